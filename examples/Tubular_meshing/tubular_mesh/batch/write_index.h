// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_BATCH_WRITE_INDEX_H
#define TUBULAR_MESH_BATCH_WRITE_INDEX_H

#include "Batch_row.h"
#include "Job.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

/* A row as the index shows it. */
struct Indexed_row {
  Batch_row row;
  std::optional<Job_result> result;
  Json values;                              // numbers, by the names of their columns
  std::string notes;                        // of the mesh's report
  enum { failed, waiting, meshed } outcome; // in the order of the page

  std::string sentence() const { return outcome == meshed ? notes : result ? result->sentence() : ""; }
};

/* `results`: the folder, where the report of the mesh is. */
Indexed_row indexed_row(const std::string& results, const Batch_row& row, std::optional<Job_result> result);

/* How many have been meshed, have failed, and are not done. */
std::string summary(const std::vector<Indexed_row>& rows);

/* Writes index.html and index.csv, failures first. `source`: the folder or the table. */
void write_index(const std::string& results, const std::string& source, std::vector<Indexed_row> rows);

#endif // TUBULAR_MESH_BATCH_WRITE_INDEX_H
