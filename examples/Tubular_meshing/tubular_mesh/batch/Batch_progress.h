// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_BATCH_BATCH_PROGRESS_H
#define TUBULAR_MESH_BATCH_BATCH_PROGRESS_H

#include "../Options.h"
#include "write_index.h"

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

/* Tells how a batch goes on: a line a surface on standard error, and on a terminal one more that changes; for programs,
 * with --log-json, in lines of JSON. */
class Batch_progress {
public:
  /* Throws a Parameter_error if the file for programs cannot be written. */
  Batch_progress(const Options& options, const std::string& version, std::size_t rows, std::size_t kept);
  ~Batch_progress() { clear(); }

  void begin(const Batch_row& row);
  void end(const Indexed_row& row);
  /* Of the surfaces at work; to be called every now and then. */
  void show(const std::vector<std::string>& names);
  void finish(int status, const std::string& sentence);

private:
  struct Close {
    void operator()(std::FILE* f) const {
      if (f != stderr)
        std::fclose(f);
    }
  };
  typedef std::chrono::steady_clock Clock;

  void log(Json event);
  void clear();
  double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  std::unique_ptr<std::FILE, Close> log_;
  bool is_quiet_, shows_line_, is_line_shown_ = false;
  std::size_t rows_, kept_, done_ = 0, failed_ = 0;
  Clock::time_point start_ = Clock::now(), shown_ = start_;
};

#endif // TUBULAR_MESH_BATCH_BATCH_PROGRESS_H
