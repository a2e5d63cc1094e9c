// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_PROGRESS_H
#define TUBULAR_MESH_PROGRESS_H

#include "Options.h"
#include "Stage_clock.h"

#include <memory>
#include <string>

struct Run;

/* Shows how a run goes on: on a terminal in one line that changes, elsewhere in a line a stage; and for programs, with
 * --log-json, in lines of JSON. */
class Progress : public Stage_listener {
public:
  /* Throws a Parameter_error if the file for programs cannot be written. */
  Progress(const Options& options, const std::string& version);
  ~Progress() override;

  void begin(const std::string& stage) override;
  void end(const std::string& stage, double seconds) override;
  void expect_preparation(const Options& options, double triangles) override;
  bool wants_estimate() const override;
  void expect_meshing(const Options& options, double triangles, double tetrahedra) override;

  /* The last that is shown of a run that has ended well... */
  void finish(const Run& run);
  /* ... or has not: with the status of the program and why. */
  void fail(int status, const std::string& sentence);

private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

#endif // TUBULAR_MESH_PROGRESS_H
