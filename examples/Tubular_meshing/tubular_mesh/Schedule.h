// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_SCHEDULE_H
#define TUBULAR_MESH_SCHEDULE_H

#include "Options.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/* How long the stages of a run are expected to take, to tell how far it is and when it will be done. What is expected is
 * that of one machine; the stages that are done tell how fast this one is. */
class Schedule {
public:
  /* Up to the mesh size, for a surface of so many triangles. What comes after is not known yet. */
  void expect_preparation(const Options& options, double triangles);

  /* From then on, for so many isotropic tetrahedra of the mesh size. */
  void expect_meshing(const Options& options, double triangles, double tetrahedra);

  void begin(const std::string& stage);
  void end(const std::string& stage, double seconds);

  struct State {
    double fraction;  // of all that there is to do, from 0 to 1
    double remaining; // seconds
  };
  /* Nothing as long as the number of cells is not known. `seconds`: since the stage has begun. */
  std::optional<State> state(double seconds) const;

private:
  struct Entry {
    std::string stage;
    double expected;
    bool is_done = false;
  };

  void expect(const char* stage, double seconds) { entries_.push_back({stage, seconds}); }
  const Entry* current() const;

  std::vector<Entry> entries_;
  std::string stage_;
  bool is_complete_ = false;
  double expected_ = 0, taken_ = 0; // by the stages that are done
};

#endif // TUBULAR_MESH_SCHEDULE_H
