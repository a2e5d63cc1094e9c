// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SAMPLE_THINNER_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SAMPLE_THINNER_H

#include <CGAL/Tubular_meshing/Centerlines/internal/Wall_stars.h>
#include <CGAL/Tubular_meshing/base/Point_boxes.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/opposite_ball.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Chooses among the vertices of a wall, where they are dense against the lumen, so many that each other one is within a
 * quarter of the local radius of one of these: what is found between samples twice as dense is the same centerline.
 *
 * The radius is that of the largest ball that touches the wall, against every third vertex or so, which is found for these
 * vertices, and no more exactly than it matters; of what is measured round a vertex, the smallest counts. What is narrow
 * against its triangles, creases, and vertices with long edges, stay as they are. O(n log n). */
class Sample_thinner {
public:
  typedef std::uint32_t Index;
  static constexpr double spacing = 0.25; // of the local radius

  /* `normals` are outward; vertices that are `needed` stay. */
  template <class Point, class Vector>
  Sample_thinner(const std::vector<Point>& points, const std::vector<Vector>& normals, const Wall_stars& stars,
                 const std::vector<char>& needed, int threads)
      : stars_(stars)
      , threads_(threads)
      , points_(points.begin(), points.end())
      , normals_(normals.begin(), normals.end())
      , longest_edge_(points.size(), 0)
      , reach_(points.size(), 0)
      , instead_(points.size(), none) {
    measure_edges();
    choose_some();
    measure_balls();
    spread_reach();
    thin(needed);
  }

  /* Of each vertex: the one that stands for it, itself if it stays. */
  const std::vector<Index>& instead() const { return instead_; }

private:
  static constexpr Index none = Index(-1);
  static constexpr double farthest = 4; // edges, to where a vertex stands for others
  static constexpr double crease = 0.5; // the cosine of the angle between normals

  std::size_t size() const { return points_.size(); }
  template <class Body> void for_each_vertex(const Body& body) const {
    for_each_range(size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v)
        body(v);
    });
  }

  void measure_edges() {
    for_each_vertex([&](std::size_t v) {
      double longest = 0;
      stars_.for_each_neighbor(
          v, [&](std::size_t w) { longest = (std::max)(longest, squared_norm(points_[w] - points_[v])); });
      longest_edge_[v] = std::sqrt(longest);
    });
  }

  // So that each other vertex is beside one of them.
  void choose_some() {
    std::vector<char> covered(size(), 0);
    for (std::size_t v = 0; v < size(); ++v)
      if (!covered[v]) {
        some_.push_back(Index(v));
        stars_.for_each_neighbor(v, [&](std::size_t w) { covered[w] = 1; });
      }
  }

  // Their reach; 0 if no vertex beside them can be spared.
  void measure_balls() {
    std::vector<Vector_3d> obstacles;
    for (Index v : some_)
      obstacles.push_back(points_[v]);
    const Point_boxes boxes(obstacles, std::vector<double>(obstacles.size(), 0.));
    for_each_range(some_.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const Index v = some_[i];
        const Vector_3d inward = -1. * normals_[v];
        const double edge = longest_edge_[v], least = edge / spacing;
        if (!(edge > 0) || ball_within(boxes, points_[v], inward, least) > 0)
          continue;
        const double radius = ball_within(boxes, points_[v], inward, farthest * least);
        reach_[v] = radius > 0 ? spacing * radius : farthest * edge;
      }
    });
  }

  // To the vertices beside them, and of these the least, as one ball may have missed what is opposite.
  void spread_reach() {
    const double infinity = (std::numeric_limits<double>::infinity)();
    std::vector<double> beside(size(), infinity), least(size());
    for (Index v : some_)
      beside[v] = reach_[v];
    for (int round = 0; round < 2; ++round) {
      for_each_vertex([&](std::size_t v) {
        double result = beside[v];
        stars_.for_each_neighbor(v, [&](std::size_t w) { result = (std::min)(result, beside[w]); });
        least[v] = result;
      });
      beside.swap(least);
    }
    reach_.swap(beside);
  }

  void thin(const std::vector<char>& needed) {
    std::vector<Index> reached;
    std::vector<Index> seen_from(size(), none);
    for (std::size_t v = 0; v < size(); ++v) {
      if (instead_[v] != none)
        continue;
      instead_[v] = Index(v);
      if (!(reach_[v] > 0))
        continue;
      reached.assign(1, Index(v));
      seen_from[v] = Index(v);
      for (std::size_t i = 0; i < reached.size(); ++i)
        stars_.for_each_neighbor(reached[i], [&](std::size_t w) {
          const double distance2 = squared_norm(points_[w] - points_[v]);
          if (seen_from[w] == v || distance2 > reach_[v] * reach_[v])
            return;
          seen_from[w] = Index(v);
          reached.push_back(Index(w));
          if (instead_[w] == none && !needed[w] && distance2 <= reach_[w] * reach_[w] &&
              2 * spacing * longest_edge_[w] <= reach_[w] && dot(normals_[v], normals_[w]) > crease)
            instead_[w] = Index(v);
        });
    }
  }

  const Wall_stars& stars_;
  const int threads_;
  std::vector<Vector_3d> points_, normals_;
  std::vector<double> longest_edge_; // at each vertex
  std::vector<Index> some_;
  std::vector<double> reach_; // how far each vertex can stand for others
  std::vector<Index> instead_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SAMPLE_THINNER_H
