// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_BATCH_TABLE_H
#define TUBULAR_MESH_BATCH_TABLE_H

#include <cstddef>
#include <string>
#include <vector>

/* A table in a file: CSV, as RFC 4180 has it, its values separated by commas, semicolons or tabs, in UTF-8. */
struct Table {
  struct Row {
    std::size_t line; // of the file, at which it begins; from 1
    std::vector<std::string> values;
  };

  std::vector<std::string> columns;
  std::vector<Row> rows; // without those that are empty; each has a value for each column
};

/* The separator is the one with which there is a column of this name. Throws an Input_error where there is none, or where
 * the file is no such table. */
Table read_table(const std::string& file, const std::string& needed_column);

#endif // TUBULAR_MESH_BATCH_TABLE_H
