// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_BATCH_JOB_OPTIONS_H
#define TUBULAR_MESH_BATCH_JOB_OPTIONS_H

#include "../Options.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

/* The options of the program, for what reads them from tables. */
class Known_options {
public:
  Known_options();
  Known_options(const Known_options&) = delete;
  ~Known_options();

  // The long name, without dashes, of an option as a table calls it: with or without dashes, with _ for -, or its letter;
  // empty if there is none, or it is the batch's own.
  std::string name_of(const std::string& column) const;
  bool is_flag(const std::string& name) const;
  bool is_repeatable(const std::string& name) const;

private:
  struct Declared;
  Declared* declared_;
};

/* What one surface of a batch is meshed with. */
struct Job_options {
  Options options;
  std::vector<std::string> words; // the same as words, whose order is that of --help
  std::vector<std::string> files; // that they have the program read
};

/* Those of the batch as words, of what its command line has been parsed into; files that they read are absolute. */
std::vector<std::string> common_words(const CLI::App& app);

/* The own options of a surface replace those of the batch that have the same name. Files that they read are relative to
 * the folder. Throws a Parameter_error for what is wrong with them. */
Job_options job_options(const std::vector<std::string>& common, const std::vector<std::string>& own,
                        const std::string& folder);

#endif // TUBULAR_MESH_BATCH_JOB_OPTIONS_H
