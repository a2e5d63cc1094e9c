// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_WALL_DISTANCE_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_WALL_DISTANCE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 *
 * The distance to the wall of a tubular surface, as a function object: at a point of the centerlines it is the local
 * radius r(x_c) of section 2.2. Caps must be left out, or a centerline would seem to narrow towards its ends.
 *
 * Built once in O(n log n) in the faces; a query is O(log n), allocates nothing, and is safe from several threads.
 * Copies share the tree. The mesh need not outlive the object.
 *
 * \tparam Point_3 a model of `Point_3`
 */
class Wall_distance {
public:
  typedef Tubular_meshing::Point_3 Point_3;

  /*! The distance to all faces of a triangle mesh.
   * \param mesh a triangle mesh
   * \param np CGAL's `vertex_point_map`
   * \throws Input_error if there are no faces */
  template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Wall_distance(const TriangleMesh& mesh, const NamedParameters& np = CGAL::parameters::default_values()) {
    build(
        mesh, [](const auto&) { return true; }, np);
  }

  /*! The distance to the faces whose value in `patches` is `patch` (`labels::wall`, as a rule).
   * \param mesh a triangle mesh
   * \param patches a readable property map from face descriptor to integer
   * \param patch the label of the faces that count
   * \param np CGAL's `vertex_point_map`
   * \throws Input_error if there is no such face */
  template <class TriangleMesh, class PatchMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
  Wall_distance(const TriangleMesh& mesh, const PatchMap& patches, int patch,
                const NamedParameters& np = CGAL::parameters::default_values()) {
    build(
        mesh, [&](const auto& face) { return int(get(patches, face)) == patch; }, np);
  }

  /// The distance from `x` to the wall.
  double operator()(const Point_3& x) const {
    return std::sqrt(tree_.nearest(internal::to_double_point(x)).squared_distance);
  }

  /// The point of the wall that is nearest to `x`.
  Point_3 closest_point(const Point_3& x) const {
    const internal::Double_kernel::Point_3 p = tree_.nearest(internal::to_double_point(x)).point;
    return Point_3(p.x(), p.y(), p.z());
  }

  /// The box of the wall.
  CGAL::Bbox_3 bbox() const { return tree_.bbox(); }

private:
  typedef internal::Double_kernel::Triangle_3 Triangle;

  template <class TriangleMesh, class IsWall, class NamedParameters>
  void build(const TriangleMesh& mesh, const IsWall& is_wall, const NamedParameters& np) {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    auto vpm = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                get_const_property_map(CGAL::vertex_point, mesh));
    std::vector<Triangle> triangles;
    triangles.reserve(num_faces(mesh));
    for (auto f : faces(mesh)) {
      if (!is_wall(f))
        continue;
      const auto h = halfedge(f, mesh);
      const Triangle t(internal::to_double_point(get(vpm, source(h, mesh))),
                       internal::to_double_point(get(vpm, target(h, mesh))),
                       internal::to_double_point(get(vpm, target(next(h, mesh), mesh))));
      if (CGAL::cross_product(t[1] - t[0], t[2] - t[0]).squared_length() > 0) // its neighbours cover a flat one
        triangles.push_back(t);
    }
    if (triangles.empty())
      throw Input_error("The surface has no wall: none of its faces can be used to measure the radius of the vessel.");
    tree_ = internal::Nearest_tree<Triangle>(std::move(triangles));
  }

  internal::Nearest_tree<Triangle> tree_;
};

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_WALL_DISTANCE_H
