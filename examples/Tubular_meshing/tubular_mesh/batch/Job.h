// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_BATCH_JOB_H
#define TUBULAR_MESH_BATCH_JOB_H

#include "../Options.h"
#include "Batch_row.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

typedef nlohmann::ordered_json Json;

/* Where things are in the folder of the results, relative to it; for a row, by its id. */
namespace batch_paths {

constexpr const char *index_page = "index.html", *index_table = "index.csv", *all_scratch = ".work";
inline std::string home(const std::string& id) {
  return "meshes/" + id;
}
inline std::string log(const std::string& id) {
  return "logs/" + id + ".txt";
}
inline std::string scratch(const std::string& id) {
  return std::string(all_scratch) + "/" + id;
}
inline std::string statuses(const std::string& id) {
  return ".status/" + id;
}

} // namespace batch_paths

/* What has become of a row, as its status file has it. */
struct Job_result {
  Json json;
  std::string key;  // of what it was made
  long attempt = 0; // which of those with that key

  int status() const { return json.value("status", 4); }
  std::string sentence() const { return json.value("sentence", ""); }
};

/* The latest of a row; none if there is none that can be read. `results`: the folder. */
std::optional<Job_result> read_result(const std::string& results, const std::string& id);

/* What is asked for of a row: all on which its mesh depends. */
class Job {
public:
  /* Does not throw for what is wrong with the row's options: problem() has it. */
  Job(const Batch_row& row, const Options& batch, const std::string& program);

  const Batch_row& row() const { return row_; }
  const std::string& problem() const { return problem_; }
  // Where its mesh is written to, within its folder.
  const std::string& output() const { return output_; }

  /* Its status file, within the folder of the results: named by what it is made of, so that of a surface that has changed,
   * or by other options, it is another one; and by the attempt. */
  std::string status_file() const;
  // Whether that is there.
  bool is_done() const { return is_done_; }
  // What was known of it when that was looked up.
  const std::optional<Job_result>& known() const { return known_; }

  /* The program's command, to be run in a folder of its own. */
  std::vector<std::string> command(const std::string& program, int threads) const;
  /* What goes into the status beside what has become of it. */
  Json description() const;

private:
  void look_up(const Options& batch);

  Batch_row row_;
  std::string program_; // its version
  std::vector<std::string> words_;
  std::string problem_, output_, format_, key_;
  bool has_page_;
  long attempt_ = 0;
  bool is_done_ = false;
  std::optional<Job_result> known_;
};

#endif // TUBULAR_MESH_BATCH_JOB_H
