// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Job.h"

#include "../../command_line/words.h"
#include "Digest.h"
#include "Job_options.h"

#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace tubular = CGAL::Tubular_meshing;
namespace fs = std::filesystem;

namespace {

// What tells a changed file from the one that there was; null of one that is not there.
Json stamp(const std::string& file) {
  struct stat s = {};
  if (::stat(file.c_str(), &s) != 0)
    return Json();
  return {static_cast<long long>(s.st_mtim.tv_sec), s.st_mtim.tv_nsec, static_cast<long long>(s.st_size)};
}

bool is_surface_format(const std::string& format) {
  return format == "stl" || format == "vtp" || format == "ply" || format == "off" || format == "obj" || format == "vtk";
}

// Of a format: the ending, or the whole name of a folder.
std::string output_of(const std::string& id, const Options& o, std::string format) {
  static const std::map<std::string, std::string> endings = {{"gmsh", ".msh"},  {"medit", ".mesh"}, {"abaqus", ".inp"},
                                                             {"febio", ".feb"}, {"fluent", ".cas"}, {"exodus", ".exo"}};
  if (o.solver_case.is_wanted() || format.compare(0, 8, "openfoam") == 0)
    return "case";
  if (format == "svmultiphysics")
    return "mesh-complete";
  const auto ending = endings.find(format);
  return id + (ending == endings.end() ? "." + format : ending->second);
}

// Whether the program knows it without being told.
bool is_in_name(const std::string& output, const std::string& format) {
  namespace IO = tubular::IO;
  return format.empty() || is_surface_format(format) || IO::mesh_format_of(output) == IO::mesh_format_named(format);
}

std::string default_format(const Options& o) {
  return o.makes_surface_only() ? "vtp" : o.partitions > 0 ? "pvtu" : "vtu";
}

// A status file's name is KEY-ATTEMPT.json.
bool parse_name(const std::string& name, Job_result& result) {
  const std::size_t dash = name.find('-'), end = name.size() > 5 ? name.size() - 5 : 0;
  if (dash != 16 || name.substr(end) != ".json" || dash + 1 >= end ||
      name.find_first_not_of("0123456789", dash + 1) != end)
    return false;
  result.key = name.substr(0, dash);
  result.attempt = std::strtol(name.c_str() + dash + 1, nullptr, 10);
  return true;
}

bool is_status(const Json& json) {
  const auto has = [&](const char* key, bool (Json::*is_type)() const) {
    return json.contains(key) && (json[key].*is_type)();
  };
  bool is_one = json.is_object() && has("status", &Json::is_number_integer) && has("files", &Json::is_array);
  for (const char* text : {"sentence", "output", "program"})
    is_one = is_one && has(text, &Json::is_string);
  for (const char* number : {"seconds", "peak_memory_mb"})
    is_one = is_one && has(number, &Json::is_number);
  return is_one && std::all_of(json["files"].begin(), json["files"].end(), [](const Json& f) { return f.is_string(); });
}

} // namespace

std::optional<Job_result> read_result(const std::string& results, const std::string& id) {
  std::optional<Job_result> latest;
  fs::file_time_type latest_time{};
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(fs::path(results) / batch_paths::statuses(id), error)) {
    Job_result result;
    std::error_code ignored;
    const auto time = entry.last_write_time(ignored);
    if (ignored || !parse_name(entry.path().filename().string(), result) || (latest && time <= latest_time))
      continue;
    std::ifstream file(entry.path());
    result.json = Json::parse(file, nullptr, false);
    if (!is_status(result.json))
      continue; // as if it had not been made
    latest = std::move(result);
    latest_time = time;
  }
  return latest;
}

Job::Job(const Batch_row& row, const Options& batch, const std::string& program)
    : row_(row)
    , program_(program)
    , problem_(row.problem)
    , has_page_(batch.batch.has_pages) {
  Json files = Json::array();
  try {
    const Job_options job = job_options(batch.batch.options, row.options, row.folder);
    std::string format = job.options.format;
    if (job.options.makes_surface_only() ? !format.empty() && !is_surface_format(format) : is_surface_format(format))
      throw tubular::Parameter_error("--format " + format + " is not for a mesh of type " + job.options.type + ".");
    output_ = output_of(row.id, job.options, format.empty() ? default_format(job.options) : format);
    format_ = is_in_name(output_, format) ? "" : format;
    for (const std::string& word : job.words)
      if (word.compare(0, 9, "--format=") != 0)
        words_.push_back(word);
    for (const std::string& file : job.files)
      files.push_back({file, stamp(file)});
  } catch (const tubular::Error& e) {
    if (problem_.empty())
      problem_ = e.what();
  }
  const Json made_of = {{"id", row.id},      {"given", row.given},  {"stamp", stamp(row.surface)}, {"options", words_},
                        {"files", files},    {"problem", problem_}, {"output", output_},           {"format", format_},
                        {"page", has_page_}, {"program", program_}};
  key_ = digest(made_of.dump(-1, ' ', false, Json::error_handler_t::replace));
  look_up(batch);
}

// A mesh that is not there any more is made again, and one that has failed where that is wanted.
void Job::look_up(const Options& batch) {
  known_ = read_result(batch.output, row_.id);
  if (!known_ || known_->key != key_)
    return;
  bool is_wanted = known_->status() != 0 && batch.batch.retries;
  if (known_->status() == 0)
    for (const Json& file : known_->json.value("files", Json::array())) {
      std::error_code ignored;
      is_wanted |= !fs::exists(fs::path(batch.output) / batch_paths::home(row_.id) / file.get<std::string>(), ignored);
    }
  attempt_ = known_->attempt + is_wanted;
  is_done_ = !is_wanted;
}

std::string Job::status_file() const {
  return batch_paths::statuses(row_.id) + "/" + key_ + "-" + std::to_string(attempt_) + ".json";
}

std::vector<std::string> Job::command(const std::string& program, int threads) const {
  std::vector<std::string> words = {program, row_.surface};
  words.insert(words.end(), words_.begin(), words_.end());
  const auto is_given = [&](const std::string& option) {
    return std::any_of(words_.begin(), words_.end(),
                       [&](const std::string& word) { return word.compare(0, option.size() + 1, option + "=") == 0; });
  };
  const std::string& id = row_.id;
  words.insert(words.end(), {"--threads=" + std::to_string(threads), "--report=" + id + ".json"});
  if (has_page_) {
    words.push_back("--report=" + id + ".html");
    if (!is_given("--report-budget"))
      words.push_back("--report-budget=5");
  }
  words.push_back("--picture=" + id + ".png");
  if (!is_given("--picture-size"))
    words.push_back("--picture-size=320x240");
  if (!format_.empty())
    words.push_back("--format=" + format_);
  words.push_back("--output=" + output_);
  return words;
}

Json Job::description() const {
  return {{"id", row_.id},       {"name", row_.name},
          {"given", row_.given}, {"options", command_line::text_of(row_.options)},
          {"output", output_},   {"program", program_}};
}
