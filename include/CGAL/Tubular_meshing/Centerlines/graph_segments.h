// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_GRAPH_SEGMENTS_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_GRAPH_SEGMENTS_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The segments of a graph in the order of its branches, and where each is. */
struct Graph_segments {
  struct Place {
    std::size_t branch, segment;
  };

  std::vector<Double_kernel::Segment_3> segments;
  std::vector<Place> places;

  explicit Graph_segments(const Centerline_graph& graph) {
    for (std::size_t b = 0; b < graph.branches().size(); ++b) {
      const std::vector<std::size_t>& points = graph.branches()[b].points;
      for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        segments.emplace_back(to_double_point(graph.points()[points[i]]),
                              to_double_point(graph.points()[points[i + 1]]));
        places.push_back(Place{b, i});
      }
    }
  }
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_GRAPH_SEGMENTS_H
