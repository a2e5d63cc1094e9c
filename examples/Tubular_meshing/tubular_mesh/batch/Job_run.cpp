// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Job_run.h"

#include "../../command_line/exit_status.h"
#include "../../command_line/words.h"

#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <signal.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

using command_line::trimmed;
namespace tubular = CGAL::Tubular_meshing;
namespace fs = std::filesystem;

namespace {

constexpr int timed_out = 124; // as of timeout(1)

// What the program says goes there, beside its files.
constexpr const char *out_file = "/.out", *error_file = "/.err";

std::string whole(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void write_whole(const std::string& name, const std::string& text) {
  tubular::IO::Output_file file(name);
  file.write(text);
  file.commit();
}

// The lines of what the program says: the sentence that ends it, the stages that it has been through, others.
struct Said {
  std::string sentence, stage, other;

  explicit Said(const std::string& errors) {
    const std::string prefix = "tubular_mesh: ";
    std::istringstream lines(errors);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t seconds = line.find(" s  ");
      if (line.compare(0, prefix.size(), prefix) == 0)
        sentence = trimmed(line.substr(prefix.size()));
      else if (seconds != line.npos && line.find_first_not_of(" .0123456789") == seconds + 1)
        stage = trimmed(line.substr(seconds + 4));
      else if (!trimmed(line).empty())
        other = trimmed(line);
    }
  }
};

// What the program says is wrong, or what is known where it could not say so.
std::string sentence_of(const Child_status& ended, const std::string& errors, double limit) {
  const Said said(errors);
  std::ostringstream text;
  const std::string where = said.stage.empty() ? "" : ", after the stage " + said.stage;
  if (ended.timed_out)
    text << "The program was ended after " << limit << " s, the limit of time" << where << ".";
  else if (!said.sentence.empty())
    text << said.sentence;
  else if (ended.status == 128 + SIGKILL)
    text << "The program was killed, as the system does where memory runs out" << where << ".";
  else if (ended.status > 128)
    text << "The program was ended by signal " << ended.status - 128 << where << ".";
  else if (ended.status == 0)
    text << "The program wrote no mesh.";
  else if (!said.other.empty())
    text << said.other;
  else
    text << "The program ended with status " << ended.status << ", and said nothing.";
  return text.str();
}

std::string now() {
  const std::time_t time = std::time(nullptr);
  std::tm local = {};
  localtime_r(&time, &local);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S", &local);
  return text;
}

// At once: under another name while its files go.
void remove_folder(const std::string& folder) {
  if (!fs::exists(fs::symlink_status(folder)))
    return;
  const std::string doomed = folder + ".removed";
  fs::remove_all(doomed);
  fs::rename(folder, doomed);
  fs::remove_all(doomed);
}

std::vector<std::string> names_in(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

} // namespace

Job_run::Job_run(const Job& job, const std::string& status_file, const std::string& program, int threads,
                 const Options& batch)
    : job_(job)
    , results_(fs::absolute(batch.output).string())
    , status_file_(results_path(status_file))
    , time_limit_(batch.batch.timeout) {
  const std::string scratch = results_path(batch_paths::scratch(job.row().id));
  try {
    if (!job.problem().empty())
      return;
    fs::remove_all(scratch);
    fs::create_directories(scratch);
    command_ = job.command(program, threads);
    child_ = std::make_unique<Child>(command_, scratch, scratch + out_file, scratch + error_file,
                                     Child::Limits{batch.batch.timeout, batch.batch.memory});
  } catch (const fs::filesystem_error& e) {
    throw tubular::Output_error("The folder \"" + scratch + "\" cannot be made: " + e.code().message() + ".");
  }
}

Job_run::~Job_run() {
  child_.reset(); // ends it
  std::error_code ignored;
  fs::remove_all(results_path(batch_paths::scratch(job_.row().id)), ignored);
}

std::optional<Job_result> Job_run::poll() {
  const std::optional<Child_status> ended =
      child_ ? child_->poll() : Child_status{command_line::wrong_usage, false, 0, 0};
  if (!ended)
    return std::nullopt;
  try {
    return finish(*ended);
  } catch (const fs::filesystem_error& e) {
    throw tubular::Output_error("The results of \"" + job_.row().name + "\" cannot be put into \"" + results_ +
                                "\": " + e.code().message() + ".");
  }
}

Job_result Job_run::finish(const Child_status& ended) {
  const std::string& id = job_.row().id;
  const std::string scratch = results_path(batch_paths::scratch(id)), home = results_path(batch_paths::home(id));
  Job_result result;
  int status = ended.timed_out ? timed_out : ended.status;
  std::string sentence = job_.problem();
  if (child_) {
    const std::string out = whole(scratch + out_file), errors = whole(scratch + error_file);
    fs::remove(scratch + out_file);
    fs::remove(scratch + error_file);
    const bool is_made = status == 0 && fs::exists(scratch + "/" + job_.output());
    sentence = is_made ? "" : sentence_of(ended, errors, time_limit_);
    status = status == 0 && !is_made ? int(command_line::failed) : status;
    std::vector<std::string> typed = command_;
    typed.front() = "tubular_mesh";
    fs::create_directories(results_path("logs"));
    write_whole(results_path(batch_paths::log(id)), command_line::text_of(typed) + "\n\n" + errors + out);
  }
  remove_folder(home);
  if (status == 0) {
    fs::create_directories(results_path("meshes"));
    fs::rename(scratch, home);
  }
  result.json = {{"status", status},
                 {"sentence", sentence},
                 {"seconds", std::round(1000 * ended.seconds) / 1000},
                 {"peak_memory_mb", std::round(10 * ended.peak_memory) / 10},
                 {"files", status == 0 ? Json(names_in(home)) : Json::array()}};
  result.json.update(job_.description());
  result.json["time"] = now();
  const fs::path folder = fs::path(status_file_).parent_path();
  fs::create_directories(folder);
  write_whole(status_file_, result.json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
  for (const std::string& name : names_in(folder.string())) // of another request, or of an attempt before
    if (name != fs::path(status_file_).filename().string())
      fs::remove(folder / name);
  return result;
}
