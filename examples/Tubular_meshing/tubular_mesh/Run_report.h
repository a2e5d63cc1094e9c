// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_RUN_REPORT_H
#define TUBULAR_MESH_RUN_REPORT_H

#include "Run.h"

#include <memory>
#include <string>

class Stage_clock;

/* All that a run has to tell, as JSON; the summary on the terminal is a view of it. */
class Run_report {
public:
  explicit Run_report(const Run& run);
  ~Run_report();

  void add_times(const Stage_clock& clock);
  std::string json() const;
  void print(bool verbose) const;

private:
  struct Content; // keeps the JSON library out of other units
  std::unique_ptr<Content> content_;
};

#endif // TUBULAR_MESH_RUN_REPORT_H
