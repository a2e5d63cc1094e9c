// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "times.h"

#include "tubular_mesh/Stage_clock.h"

#include <cstdio>

void add_times(Json& report, const Stage_clock& clock) {
  for (const auto& stage : clock.stages())
    report["times"][stage.first] = stage.second;
  report["total_time"] = clock.total();
  report["peak_memory_bytes"] = Stage_clock::peak_memory();
}

void print_times(const Json& r) {
  std::printf("\n%-22s %8s\n", "stage", "seconds");
  for (const auto& t : r["times"].items())
    std::printf("%-22s %8.2f\n", t.key().c_str(), t.value().get<double>());
  std::printf("%-22s %8.2f   peak memory %.0f MB\n", "total", r["total_time"].get<double>(),
              r["peak_memory_bytes"].get<double>() / 1e6);
}
