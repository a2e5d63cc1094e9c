// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_BATCH_BATCH_ROW_H
#define TUBULAR_MESH_BATCH_BATCH_ROW_H

#include "../Options.h"

#include <string>
#include <utility>
#include <vector>

/* A surface of a batch. */
struct Batch_row {
  std::string id;                                         // a name for files
  std::string name;                                       // that no other row has
  std::string given;                                      // its file, as the table or the folder has it
  std::string surface;                                    // the same as a path from anywhere
  std::string folder;                                     // to which files of its options are relative
  std::string place;                                      // of the row, for sentences
  std::vector<std::string> options;                       // its own, as words
  std::string problem;                                    // why they cannot be used; empty if they can
  std::vector<std::pair<std::string, std::string>> shown; // what the index shows of it beside, by column
};

/* All of a folder, in the order of their names, or of a table, in its order. Throws an Input_error for what is wrong with
 * it as a whole, a Parameter_error where the results would be among the surfaces. */
std::vector<Batch_row> read_rows(const Options& options);

#endif // TUBULAR_MESH_BATCH_BATCH_ROW_H
