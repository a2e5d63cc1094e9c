// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_WALL_DISTANCE_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_WALL_DISTANCE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Named_function_parameters.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL::Tubular_meshing {

namespace internal {

/* The corners of those faces of a triangle mesh for which `counts` holds. */
template <class TriangleMesh, class Counts, class NamedParameters>
std::vector<std::array<Point_3, 3>> corners_of_faces(const TriangleMesh& mesh, const Counts& counts,
                                                     const NamedParameters& np) {
  const auto points = core_points(mesh, np);
  std::vector<std::array<Point_3, 3>> triangles;
  triangles.reserve(num_faces(mesh));
  for (auto f : faces(mesh))
    if (counts(f)) {
      const auto h = halfedge(f, mesh);
      triangles.push_back(
          {get(points, source(h, mesh)), get(points, target(h, mesh)), get(points, target(next(h, mesh), mesh))});
    }
  return triangles;
}

} // namespace internal

/*! \ingroup PkgTubularMeshingCenterlines
 *
 * The distance to the wall of a tubular surface, as a function object: at a point of the centerlines it is the local
 * radius r(x_c) of section 2.2. Caps must be left out, or a centerline would seem to narrow towards its ends.
 *
 * Built once in O(n log n) in the faces; a query is O(log n), allocates nothing, and is safe from several threads.
 * Copies share the tree. The mesh need not outlive the object.
 */
class Wall_distance {
public:
  typedef Tubular_meshing::Point_3 Point_3;

  /*! The distance to all faces of a triangle mesh.
   * \param mesh a triangle mesh: a model of `FaceListGraph`, of any kernel
   * \param np CGAL's `vertex_point_map`
   * \throws Input_error if there are no faces */
  template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Wall_distance(const TriangleMesh& mesh, const NamedParameters& np = CGAL::parameters::default_values())
      : Wall_distance(internal::corners_of_faces(
            mesh, [](const auto&) { return true; }, np)) {}

  /*! The distance to the faces whose value in `patches` is `patch` (`labels::wall`, as a rule).
   * \param mesh a triangle mesh
   * \param patches a readable property map from face descriptor to integer
   * \param patch the label of the faces that count
   * \param np CGAL's `vertex_point_map`
   * \throws Input_error if there is no such face */
  template <class TriangleMesh, class PatchMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
  Wall_distance(const TriangleMesh& mesh, const PatchMap& patches, int patch,
                const NamedParameters& np = CGAL::parameters::default_values())
      : Wall_distance(internal::corners_of_faces(
            mesh, [&](const auto& face) { return int(get(patches, face)) == patch; }, np)) {}

  /*! The distance to triangles, by their corners; flat ones do not count.
   * \throws Input_error if there are no others */
  explicit Wall_distance(const std::vector<std::array<Point_3, 3>>& triangles);

  /// The distance from `x` to the wall.
  double operator()(const Point_3& x) const;

  /// The point of the wall that is nearest to `x`.
  Point_3 closest_point(const Point_3& x) const;

  /// A point of the wall, and the triangle it is on.
  struct Place {
    Point_3 point;
    std::size_t triangle;
  };

  /// The point of the wall that is nearest to `x`, with its triangle.
  Place closest_place(const Point_3& x) const;

  /// The number of the wall's triangles, those without an area left out.
  std::size_t number_of_triangles() const;

  /// The corners of a triangle, in the order in which they were given.
  std::array<Point_3, 3> triangle(std::size_t i) const;

  /// The number of places where triangles have corners.
  std::size_t number_of_corners() const;

  /// The numbers of the places of a triangle's corners, in the order in which they were given, from 0 on: triangles that
  /// meet have some in common. How places are numbered is not said.
  std::array<std::uint32_t, 3> corners(std::size_t i) const;

  /// The box of the wall.
  CGAL::Bbox_3 bbox() const;

private:
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_WALL_DISTANCE_H
