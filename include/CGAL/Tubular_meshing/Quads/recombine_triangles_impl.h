// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_RECOMBINE_TRIANGLES_IMPL_H
#define CGAL_TUBULAR_MESHING_QUADS_RECOMBINE_TRIANGLES_IMPL_H

#include <CGAL/Tubular_meshing/Quads/recombine_triangles.h>
#include <CGAL/Tubular_meshing/Quads/internal/recombination/Triangle_recombiner.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <cmath>
#include <limits>
#include <string>

namespace CGAL::Tubular_meshing {
namespace internal {

inline void check_triangles(const std::vector<Point_3>& points,
                            const std::vector<std::array<std::size_t, 3>>& triangles, const std::vector<int>& patches) {
  const std::size_t most = std::size_t((std::numeric_limits<int>::max)()) / 3;
  if (triangles.size() > most || points.size() > most)
    throw Input_error("A mesh of " + std::to_string(triangles.size()) + " triangles and " +
                      std::to_string(points.size()) + " points is too large; recombine it in parts.");
  if (!patches.empty() && patches.size() != triangles.size())
    throw Input_error("There are patches of " + std::to_string(patches.size()) + " triangles, but " +
                      std::to_string(triangles.size()) + " triangles; give one patch a triangle, or none at all.");
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      if (triangles[t][i] >= points.size())
        throw Input_error("Triangle " + std::to_string(t) + " refers to point " + std::to_string(triangles[t][i]) +
                          ", but there are " + std::to_string(points.size()) + " points.");
      if (triangles[t][i] == triangles[t][(i + 1) % 3])
        throw Input_error("Triangle " + std::to_string(t) + " has point " + std::to_string(triangles[t][i]) +
                          " twice; leave it out.");
      const Vector_3d p(points[triangles[t][i]]);
      if (!std::isfinite(squared_norm(p)))
        throw Input_error("Point " + std::to_string(triangles[t][i]) + " of the triangles has no finite coordinates.");
    }
}

inline std::vector<Patch_triangle> patch_triangles(const std::vector<std::array<std::size_t, 3>>& triangles) {
  std::vector<Patch_triangle> result;
  for (const auto& t : triangles)
    result.push_back({{int(t[0]), int(t[1]), int(t[2])}});
  return result;
}

// The triangles of a surface, and their halfedges by the numbers of Triangle_adjacency.h.
struct Surface_triangles {
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<Surface::Halfedge_index> halfedges;

  explicit Surface_triangles(const Surface& surface)
      : points(std::size_t(surface.number_of_vertices() + surface.number_of_removed_vertices()), Point_3(0, 0, 0)) {
    for (auto v : surface.vertices())
      points[std::size_t(v)] = surface.point(v);
    for (auto f : surface.faces()) {
      const auto h = surface.halfedge(f);
      if (surface.next(surface.next(surface.next(h))) != h)
        throw Input_error("Face " + std::to_string(std::size_t(f)) +
                          " of the surface is no triangle; triangulate the surface first.");
      triangles.emplace_back();
      std::size_t i = 0;
      for (auto around : {h, surface.next(h), surface.prev(h)}) {
        halfedges.push_back(around);
        triangles.back()[i++] = std::size_t(surface.source(around));
      }
    }
  }
};

// With the vertices of the corners, by halfedges, as they are after the splits.
inline std::vector<std::size_t> corners_after_splits(const std::vector<Patch_triangle>& triangles,
                                                     const std::vector<Border_fan>& splits, std::size_t new_vertex) {
  std::vector<std::size_t> corner(3 * triangles.size());
  for (std::size_t h = 0; h < corner.size(); ++h)
    corner[h] = std::size_t(triangles[h / 3][h % 3]);
  for (const Border_fan& fan : splits) {
    for (int h : fan.halfedges())
      corner[std::size_t(h)] = new_vertex;
    ++new_vertex;
  }
  return corner;
}

inline Recombination_report report_of(const Triangle_recombiner& recombiner) {
  return {recombiner.joined().size() + 2 * recombiner.splits().size(), recombiner.left().size(),
          recombiner.splits().size(), recombiner.number_of_invalid_quads()};
}

CGAL_TUBULAR_MESHING_INLINE Recombination_report recombine_faces(Surface& surface, const std::vector<int>& patches) {
  const Surface_triangles own(surface);
  check_triangles(own.points, own.triangles, patches);
  const std::vector<Patch_triangle> indexed = patch_triangles(own.triangles);
  const std::vector<Vector_3d> vectors(own.points.begin(), own.points.end());
  Triangle_recombiner recombiner(indexed, vectors, patches);
  recombiner.run();
  for (const Border_fan& fan : recombiner.splits()) {
    // The halfedges that come to the vertex, in the last triangle and in the first one.
    const auto in_last = own.halfedges[std::size_t(previous_halfedge(fan.halfedges().back()))];
    const auto in_first = surface.prev(own.halfedges[std::size_t(fan.halfedges().front())]);
    const auto fresh = surface.source(CGAL::Euler::split_vertex(in_last, in_first, surface));
    surface.point(fresh) = as<Point_3>(fan.new_vertex());
  }
  for (int h : recombiner.joined())
    CGAL::Euler::join_face(own.halfedges[std::size_t(h)], surface);
  return report_of(recombiner);
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Recombined_triangles
recombine_triangles(const std::vector<Point_3>& points, const std::vector<std::array<std::size_t, 3>>& triangles,
                    const std::vector<int>& patches) {
  internal::check_triangles(points, triangles, patches);
  const std::vector<internal::Patch_triangle> indexed = internal::patch_triangles(triangles);
  const std::vector<internal::Vector_3d> vectors(points.begin(), points.end());
  internal::Triangle_recombiner recombiner(indexed, vectors, patches);
  recombiner.run();

  Recombined_triangles result;
  result.points = points;
  result.report = internal::report_of(recombiner);
  const auto corner = internal::corners_after_splits(indexed, recombiner.splits(), points.size());
  const auto at = [&](int h) { return corner[std::size_t(h)]; };
  const auto patch_of = [&](int h) { return patches.empty() ? 0 : patches[std::size_t(h / 3)]; };
  const auto add_quad = [&](int h, const std::array<std::size_t, 4>& quad) {
    result.quads.push_back(quad);
    result.quad_patches.push_back(patch_of(h));
  };
  for (int h : recombiner.joined()) {
    const std::array<int, 4> c = recombiner.corners(h);
    add_quad(h, {{at(c[0]), at(c[1]), at(c[2]), at(c[3])}});
  }
  for (const internal::Border_fan& fan : recombiner.splits()) {
    const int first = fan.halfedges().front(), last = fan.halfedges().back();
    const std::size_t v = triangles[std::size_t(first / 3)][std::size_t(first % 3)];
    add_quad(first, {{v, at(internal::next_halfedge(first)), at(internal::previous_halfedge(first)), at(first)}});
    add_quad(last, {{v, at(last), at(internal::next_halfedge(last)), at(internal::previous_halfedge(last))}});
    result.points.push_back(internal::as<Point_3>(fan.new_vertex()));
  }
  for (int t : recombiner.left()) {
    result.triangles.push_back({{at(3 * t), at(3 * t + 1), at(3 * t + 2)}});
    result.triangle_patches.push_back(patch_of(3 * t));
  }
  return result;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_QUADS_RECOMBINE_TRIANGLES_IMPL_H
