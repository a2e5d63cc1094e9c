// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "partitions.h"

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <vector>

namespace tubular = CGAL::Tubular_meshing;

void add_partitions(Json& report, const tubular::Partition_report& p) {
  report["partitions"] = {{"count", p.number_of_parts()}, {"cells", p.cells},   {"imbalance", p.imbalance},
                          {"cut_faces", p.cut_faces},     {"pieces", p.pieces}, {"ghost_cells", p.ghost_cells}};
}

void print_partitions(const Json& p) {
  const auto cells = p["cells"].get<std::vector<long>>(), ghosts = p["ghost_cells"].get<std::vector<long>>();
  const auto pieces = p["pieces"].get<std::vector<long>>();
  const auto range = std::minmax_element(cells.begin(), cells.end());
  if (cells.size() == 1) {
    std::printf("\nwritten in 1 part, of %ld cells\n", cells[0]);
    return;
  }
  std::printf("\nwritten in %zu parts of %ld to %ld cells, the largest %.2f %% over its share; %ld faces between "
              "parts, %ld ghost "
              "cells\n",
              cells.size(), *range.first, *range.second, 100 * p["imbalance"].get<double>(), p["cut_faces"].get<long>(),
              std::accumulate(ghosts.begin(), ghosts.end(), 0l));
  const auto split = std::count_if(pieces.begin(), pieces.end(), [](long n) { return n > 1; });
  if (split > 0)
    std::printf("note: %ld of the parts %s not connected through faces\n", long(split), split > 1 ? "are" : "is");
}
