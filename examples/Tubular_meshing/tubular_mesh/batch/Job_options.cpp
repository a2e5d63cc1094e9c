// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Job_options.h"

#include "../declare_options.h"

#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace tubular = CGAL::Tubular_meshing;

namespace {

const std::set<std::string> files_read = {"centerlines", "seeds", "wall-thickness-table"};
const std::set<std::string> files_written = {"write-surface", "write-centerlines", "write-blocks", "write-sections",
                                             "write-0d"};
const std::set<std::string> set_by_batch = {"output",  "report", "picture", "dry-run", "log-json",
                                            "threads", "quiet",  "help",    "version"};

// An option with its values, each of which is a word of the command line.
struct Word_group {
  std::string name;
  std::vector<std::string> values;
};

void declare(CLI::App& app, Options& options) {
  declare_options(app, options, "");
  allow_in_batch(app);
}

const CLI::Option* find(const CLI::App& app, const std::string& name) {
  return app.get_option_no_throw((name.size() == 1 ? "-" : "--") + name);
}

bool is_flag(const CLI::Option& option) {
  return option.get_items_expected_max() == 0;
}

// A word that begins with a letter after one or two dashes is an option: others are values, negative numbers too.
std::string name_in(const std::string& word) {
  const auto is_letter = [&](std::size_t i) {
    return i < word.size() && std::isalpha(static_cast<unsigned char>(word[i]));
  };
  if (word.size() > 2 && word[0] == '-' && word[1] == '-' && is_letter(2))
    return word.substr(2, word.find('=') - 2);
  return word.size() > 1 && word[0] == '-' && is_letter(1) ? word.substr(1, 1) : "";
}

// Of a flag that has two names, as --preserve-volume and --no-preserve-volume.
bool is_negated(const std::string& name, const Word_group& group) {
  return name == "no-" + group.name;
}

std::vector<Word_group> groups_of(const std::vector<std::string>& words, const CLI::App& app) {
  std::vector<Word_group> groups;
  for (const std::string& word : words) {
    const std::string name = name_in(word);
    if (name.empty() && groups.empty())
      throw tubular::Parameter_error("An option is wanted where there is \"" + word + "\"; see --help.");
    if (name.empty()) {
      groups.back().values.push_back(word);
      continue;
    }
    const CLI::Option* option = find(app, name);
    if (!option)
      throw tubular::Parameter_error("There is no option " + word + "; see --help.");
    groups.push_back({option->get_lnames().front(), {}});
    if (name.size() == 1 && word.size() > 2)
      groups.back().values.push_back(word.substr(word[2] == '=' ? 3 : 2));
    else if (name.size() > 1 && word.find('=') != word.npos)
      groups.back().values.push_back(word.substr(word.find('=') + 1));
    if (is_negated(name, groups.back()))
      groups.back().values = {groups.back().values == std::vector<std::string>{"false"} ? "true" : "false"};
  }
  return groups;
}

// A flag that is not set is as good as none, and excludes no other.
void leave_out_unset_flags(std::vector<Word_group>& groups, const CLI::App& app) {
  const auto is_unset = [&](const Word_group& g) {
    return is_flag(*find(app, g.name)) && g.name != "preserve-volume" && g.values == std::vector<std::string>{"false"};
  };
  groups.erase(std::remove_if(groups.begin(), groups.end(), is_unset), groups.end());
}

std::vector<std::string> words_of(const std::vector<Word_group>& groups) {
  std::vector<std::string> words;
  for (const Word_group& group : groups) {
    if (group.values.empty())
      words.push_back("--" + group.name);
    for (const std::string& value : group.values)
      words.push_back("--" + group.name + "=" + value);
  }
  return words;
}

// What has been parsed, in the order in which options are declared.
std::vector<Word_group> parsed_groups(const CLI::App& app) {
  std::vector<Word_group> groups;
  for (const CLI::Option* option : app.get_options()) {
    if (option->count() == 0 || option->get_positional() || option->get_group() == batch_group)
      continue;
    Word_group group{option->get_lnames().front(), option->results()};
    if (is_flag(*option) && group.values == std::vector<std::string>{"true"})
      group.values.clear();
    groups.push_back(std::move(group));
  }
  return groups;
}

void make_absolute(std::vector<Word_group>& groups, const std::string& folder) {
  for (Word_group& group : groups)
    if (files_read.count(group.name) > 0)
      for (std::string& file : group.values)
        file = (std::filesystem::current_path() / folder / file).lexically_normal().string();
}

void check_groups(const std::vector<Word_group>& groups, const CLI::App& app) {
  for (const Word_group& group : groups) {
    if (set_by_batch.count(group.name) > 0 || find(app, group.name)->get_group() == batch_group)
      throw tubular::Parameter_error("--" + group.name + " is set by --batch: no surface has one of its own.");
    for (const std::string& file : group.values)
      if (files_written.count(group.name) > 0 && std::filesystem::path(file).has_parent_path())
        throw tubular::Parameter_error("With --batch each surface has a file --" + group.name +
                                       " in the folder of its mesh: give a name without a folder, not \"" + file +
                                       "\".");
  }
}

void parse(CLI::App& app, std::vector<std::string> words) {
  std::reverse(words.begin(), words.end()); // the order in which CLI11 takes them
  try {
    app.parse(std::move(words));
  } catch (const CLI::ParseError& e) {
    throw tubular::Parameter_error(command_line::sentence_of(e));
  }
}

} // namespace

struct Known_options::Declared {
  CLI::App app;
  Options options;
};

Known_options::Known_options()
    : declared_(new Declared) {
  declare(declared_->app, declared_->options);
}
Known_options::~Known_options() {
  delete declared_;
}

std::string Known_options::name_of(const std::string& column) const {
  std::string name = column.substr((std::min)(column.find_first_not_of('-'), column.size()));
  std::replace(name.begin(), name.end(), '_', '-');
  const CLI::Option* option = name.empty() ? nullptr : find(declared_->app, name);
  const bool is_free = option && !option->get_positional() && option->get_group() != batch_group &&
                       set_by_batch.count(option->get_lnames().front()) == 0;
  return !is_free ? "" : name.size() == 1 ? option->get_lnames().front() : name;
}
bool Known_options::is_flag(const std::string& name) const {
  return ::is_flag(*find(declared_->app, name));
}
bool Known_options::is_repeatable(const std::string& name) const {
  return find(declared_->app, name)->get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
}

std::vector<std::string> common_words(const CLI::App& app) {
  std::vector<Word_group> groups = parsed_groups(app);
  const std::set<std::string> of_batch = {"output", "log-json", "quiet", "threads", "dry-run"};
  groups.erase(
      std::remove_if(groups.begin(), groups.end(), [&](const Word_group& g) { return of_batch.count(g.name) > 0; }),
      groups.end());
  check_groups(groups, app);
  make_absolute(groups, "");
  return words_of(groups);
}

Job_options job_options(const std::vector<std::string>& common, const std::vector<std::string>& own,
                        const std::string& folder) {
  Job_options job;
  CLI::App app;
  declare(app, job.options);
  std::vector<Word_group> groups = groups_of(own, app);
  check_groups(groups, app);
  make_absolute(groups, folder);
  std::set<std::string> names;
  for (const Word_group& group : groups)
    names.insert(group.name);
  for (Word_group& group : groups_of(common, app))
    if (names.count(group.name) == 0)
      groups.push_back(std::move(group));
  leave_out_unset_flags(groups, app);
  parse(app, words_of(groups));
  for (const Word_group& group : parsed_groups(app)) {
    const std::vector<std::string> words = words_of({group});
    job.words.insert(job.words.end(), words.begin(), words.end());
    if (files_read.count(group.name) > 0)
      job.files.insert(job.files.end(), group.values.begin(), group.values.end());
  }
  return job;
}
