// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PIECES_REMESHED_PIECE_H
#define CGAL_TUBULAR_MESHING_PATCHES_PIECES_REMESHED_PIECE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Chart.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Curve_divider.h>
#include <CGAL/Tubular_meshing/Plane/triangulate_in_metric.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* A piece of the surface in its new faces. Its points are those of its curves, one curve after another, then those
 * inside. */
struct Remeshed_piece {
  struct Side {
    std::size_t curve;
    bool forward;
  };
  std::vector<Side> sides; // in the order of their points
  std::vector<Point_3> inner_points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::array<std::size_t, 4>> quads;

  bool empty() const { return triangles.empty() && quads.empty(); }
};

/* The points of a curve on a loop of a patch, in the plane, in the order of the loop. */
inline std::vector<typename Patch_parameterization::Point_2> loop_polygon(const Patch_parameterization& map,
                                                                          std::size_t l, bool forward,
                                                                          std::size_t edges,
                                                                          const std::vector<Curve_position>& points) {
  std::vector<typename Patch_parameterization::Point_2> polygon;
  for (const auto& p : points)
    polygon.push_back(
        map.uv(forward ? map.on_loop_edge(l, p.edge, p.t) : map.on_loop_edge(l, edges - 1 - p.edge, 1 - p.t)));
  if (!forward)
    std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

/* The loops of a patch in the plane, the outer one first; the piece gets its sides. */
inline std::vector<std::vector<typename Patch_parameterization::Point_2>>
patch_polygons(const Patch_parameterization& map, const Surface_cut& cut, std::size_t k,
               const std::vector<std::vector<Curve_position>>& curve_points, Remeshed_piece& piece) {
  std::vector<std::vector<typename Patch_parameterization::Point_2>> polygons;
  const auto add_loop = [&](std::size_t l) {
    const Patch_loop& loop = cut.patches[k].loops[l];
    piece.sides.push_back({loop.curve, loop.forward});
    polygons.push_back(
        loop_polygon(map, l, loop.forward, cut.curves[loop.curve].vertices.size(), curve_points[loop.curve]));
  };
  add_loop(map.outer_loop());
  for (std::size_t l = 0; l < map.number_of_loops(); ++l)
    if (l != map.outer_loop())
      add_loop(l);
  return polygons;
}

/* The surface over the plane, for triangles to be judged in space. */
template <class Chart> auto embedding_of(const Chart& chart) {
  return [&chart](const auto& uv) { return chart.point(uv); };
}

/* Fills polygons of the plane with triangles, which are judged under the embedding `image`, or in the metric if it is
 * No_embedding. A rim runs with the wall on its left: seen along its normal, as the cap's chart is, the cap is turned
 * inwards, which `turn` sets right. */
template <class Chart, class Embedding, class Point_2>
void triangulate_piece(const Chart& chart, const Embedding& image, const std::vector<std::vector<Point_2>>& polygons,
                       bool turn, Remeshed_piece& piece) {
  const auto metric = [&](const Point_2& uv) { return chart.metric(uv); };
  auto plane =
      triangulate_in_metric(polygons, metric, parameters::embedding(image).interior_points(chart.hidden_places()));
  std::size_t on_boundary = 0;
  for (const auto& polygon : polygons)
    on_boundary += polygon.size();
  for (std::size_t i = on_boundary; i < plane.points.size(); ++i)
    piece.inner_points.push_back(chart.point(plane.points[i]));
  if (turn)
    for (auto& t : plane.triangles)
      std::swap(t[1], t[2]);
  piece.triangles = std::move(plane.triangles);
}

/* The points of a rim in the plane of its cap, counterclockwise; the piece gets its side. */
template <class Chart>
auto cap_polygons(const Chart& chart, std::size_t rim, const std::vector<Curve_position>& points,
                  Remeshed_piece& piece) {
  std::vector<std::vector<decltype(chart.uv(points[0].point))>> polygons(1);
  piece.sides.push_back({rim, false});
  for (const auto& p : points)
    polygons[0].push_back(chart.uv(p.point));
  std::reverse(polygons[0].begin(), polygons[0].end());
  return polygons;
}

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_PATCHES_PIECES_REMESHED_PIECE_H
