// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_RECOMBINE_TRIANGLES_H
#define CGAL_TUBULAR_MESHING_QUADS_RECOMBINE_TRIANGLES_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Quads/internal/recombination/Triangle_recombiner.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 *
 * What recombine_triangles() did. */
struct Recombination_report {
  std::size_t quads = 0;
  std::size_t triangles = 0;      ///< that are left, single
  std::size_t split_vertices = 0; ///< of the border
  std::size_t invalid_quads = 0;  ///< of \f$ \eta_q = 0 \f$, with an angle of π or more
};

/*! \ingroup PkgTubularMeshingRef
 *
 * Quads and triangles, all counterclockwise, and of which patch they are. The first points are the given ones. */
struct Recombined_triangles {
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 4>> quads;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<int> quad_patches, triangle_patches;
  Recombination_report report;
};

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

template <class Point_3> std::vector<Vector_3d> vectors_of(const std::vector<Point_3>& points) {
  std::vector<Vector_3d> result;
  for (const Point_3& p : points)
    result.emplace_back(p);
  return result;
}

// The triangles of a surface, their halfedges by the numbers of Triangle_adjacency.h, and their patches.
struct Surface_triangles {
  typedef CGAL::Surface_mesh<Point_3> Surface;
  typedef typename Surface::Halfedge_index Halfedge;

  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<Halfedge> halfedges;
  std::vector<int> patches;

  template <class Patch_map>
  Surface_triangles(const Surface& surface, const Patch_map& patch)
      : points(std::size_t(surface.number_of_vertices() + surface.number_of_removed_vertices()), Point_3(0, 0, 0)) {
    for (auto v : surface.vertices())
      points[std::size_t(v)] = surface.point(v);
    for (auto f : surface.faces()) {
      const Halfedge h = surface.halfedge(f);
      if (surface.next(surface.next(surface.next(h))) != h)
        throw Input_error("Face " + std::to_string(std::size_t(f)) +
                          " of the surface is no triangle; triangulate the surface first.");
      const std::array<Halfedge, 3> around = {{h, surface.next(h), surface.prev(h)}};
      halfedges.insert(halfedges.end(), around.begin(), around.end());
      triangles.push_back({{std::size_t(surface.source(around[0])), std::size_t(surface.source(around[1])),
                            std::size_t(surface.source(around[2]))}});
      if constexpr (!std::is_same<Patch_map, CGAL::internal_np::Param_not_found>::value)
        patches.push_back(get(patch, f));
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

} // namespace internal

/*! \ingroup PkgTubularMeshingRef
 *
 * makes quads of triangles, two of each: those pairs of neighbours for which \f$ \sum (1 - \eta_q) \f$, by (14), is
 * smallest among all ways to leave as few triangles as possible. That is a matching of minimum cost in the dual graph,
 * \cgalCite{remacle2012}.
 *
 * A connected part of a patch with an even number of triangles, which is one whose border has an even number of edges,
 * becomes quads altogether, but for rare shapes. Where neighbours cannot all be paired, as with triangles in corners,
 * vertices of the border are split, as few as possible: the border keeps its vertex, the triangles inside get a new
 * one, on them, and the edge between the two makes quads of the two triangles at the border. A quad with an angle of π
 * or more is made only where eight splits would not avoid it. Of an odd number of triangles, one is left.
 *
 * The border itself stays as it is: all its edges and vertices.
 *
 * \param points with `x()`, `y()`, `z()`
 * \param triangles counterclockwise, by the indices of their points
 * \param patches one number a triangle, or none at all: triangles of different patches are not joined
 *
 * O(n² log n) at worst; measured, n^1.5: 0.4 s for 100,000 triangles, 12 s for a million.
 *
 * \throws Input_error if triangles refer to points that are not there, or twice to the same one, if points are not
 *   finite, or if an edge has more than two triangles, or two that are turned differently
 * \throws Meshing_error if this program was built without LEMON, see has_lemon()
 */
inline Recombined_triangles recombine_triangles(const std::vector<Point_3>& points,
                                                const std::vector<std::array<std::size_t, 3>>& triangles,
                                                const std::vector<int>& patches = {}) {
  internal::check_triangles(points, triangles, patches);
  const std::vector<internal::Patch_triangle> indexed = internal::patch_triangles(triangles);
  const std::vector<internal::Vector_3d> vectors = internal::vectors_of(points);
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
    result.points.push_back(Point_3(fan.new_vertex().x, fan.new_vertex().y, fan.new_vertex().z));
  }
  for (int t : recombiner.left()) {
    result.triangles.push_back({{at(3 * t), at(3 * t + 1), at(3 * t + 2)}});
    result.triangle_patches.push_back(patch_of(3 * t));
  }
  return result;
}

/*! \ingroup PkgTubularMeshingRef
 *
 * The same for a surface mesh, in place: vertices, and faces of which a quad is made, keep their properties; of each
 * two faces, one is removed. Removed elements remain until `collect_garbage()`.
 *
 * \param surface of triangles
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{face_patch_map} \cgalParamDescription{a readable property map from faces to `int`: faces of
 *     different patches are not joined} \cgalParamDefault{one patch} \cgalParamNEnd
 * \cgalNamedParamsEnd
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
Recombination_report recombine_triangles(CGAL::Surface_mesh<Point_3>& surface,
                                         const NamedParameters& np = CGAL::parameters::default_values()) {
  const internal::Surface_triangles own(surface, CGAL::parameters::get_parameter(np, internal_np::face_patch_map));
  internal::check_triangles(own.points, own.triangles, own.patches);
  const std::vector<internal::Patch_triangle> indexed = internal::patch_triangles(own.triangles);
  const std::vector<internal::Vector_3d> vectors = internal::vectors_of(own.points);
  internal::Triangle_recombiner recombiner(indexed, vectors, own.patches);
  recombiner.run();
  for (const internal::Border_fan& fan : recombiner.splits()) {
    // The halfedges that come to the vertex, in the last triangle and in the first one.
    const auto in_last = own.halfedges[std::size_t(internal::previous_halfedge(fan.halfedges().back()))];
    const auto in_first = surface.prev(own.halfedges[std::size_t(fan.halfedges().front())]);
    const auto fresh = surface.source(CGAL::Euler::split_vertex(in_last, in_first, surface));
    surface.point(fresh) = Point_3(fan.new_vertex().x, fan.new_vertex().y, fan.new_vertex().z);
  }
  for (int h : recombiner.joined())
    CGAL::Euler::join_face(own.halfedges[std::size_t(h)], surface);
  return internal::report_of(recombiner);
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_QUADS_RECOMBINE_TRIANGLES_H
