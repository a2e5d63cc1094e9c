// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_CENTERLINE_SIZING_FIELD_H
#define CGAL_TUBULAR_MESHING_FIELDS_CENTERLINE_SIZING_FIELD_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Fields/internal/Size_octree.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 *
 * The mesh size that gives every vessel the same number of points round its circumference: h = 2 π r / N, r the local
 * radius, growing no faster from one element to the next than the gradation allows.
 *
 * The radius is that of the centerline at the nearest wall point, or that wall point's own distance to the centerline
 * where this is larger: the sac of an aneurysm is meshed at its own size, not at that of the vessel it sits on.
 *
 * The field is sampled once, on an octree whose leaves are as large as the local radius allows; afterwards it depends
 * on nothing that it was built from. Building takes O(n log n) in the number n of leaves, which is proportional to the
 * length of the tree over its radius; a query takes about 0.1 µs, allocates nothing, and is safe from several threads.
 *
 * \cgalModels `MeshDomainField_3`, so it can be given to `Mesh_criteria_3` as it is.
 *
 * \tparam Point_3 a model of `Point_3`
 */
class Centerline_sizing_field {
public:
  typedef Tubular_meshing::Point_3 Point_3;
  typedef double FT;

  /*!
   * \param centerlines descriptors of the centerlines
   * \param wall the lumen's wall, without its caps
   * \param np an optional sequence of named parameters among the ones listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{points_per_circumference} \cgalParamDescription{N; at least 3} \cgalParamDefault{20}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{min_size} \cgalParamDescription{lower limit of h, a length} \cgalParamDefault{0} \cgalParamNEnd
   *   \cgalParamNBegin{max_size} \cgalParamDescription{upper limit of h, a length} \cgalParamDefault{infinity}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{gradation} \cgalParamDescription{largest ratio of the sizes of neighboring elements, at least 1}
   *     \cgalParamDefault{1.3} \cgalParamNEnd
   *   \cgalParamNBegin{number_of_threads} \cgalParamDescription{0 takes all cores} \cgalParamDefault{0} \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws Parameter_error if one of these is out of its range
   */
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  Centerline_sizing_field(const Centerline_field& centerlines, const Wall_distance& wall,
                          const NamedParameters& np = CGAL::parameters::default_values()) {
    const double points = internal::choose(np, internal_np::points_per_circumference, 20.);
    const double min_size = internal::choose(np, internal_np::min_size, 0.);
    const double max_size = internal::choose(np, internal_np::max_size, (std::numeric_limits<double>::infinity)());
    const double gradation = internal::choose(np, internal_np::gradation, 1.3);
    check(points, min_size, max_size, gradation);

    const auto sample = [&](const internal::Size_octree::Position& x) {
      const Point_3 p(x[0], x[1], x[2]), on_wall = wall.closest_point(p);
      const auto d = centerlines.descriptors(on_wall);
      const double radius = (std::max)(d.radius, d.distance);
      const double size = (std::min)((std::max)(2 * CGAL_PI * radius / points, min_size), max_size);
      const bool outside = squared_distance(p, d.point) > squared_distance(on_wall, d.point);
      return internal::Size_octree::Sample{size, outside ? std::sqrt(CGAL::to_double(squared_distance(p, on_wall))) : 0,
                                           leaf_per_radius * radius};
    };
    octree_ = internal::Size_octree(wall.bbox(), sample, gradation - 1,
                                    internal::choose(np, internal_np::number_of_threads, 0));
  }

  /// The mesh size at a point, a length in the unit of the surface.
  FT operator()(const Point_3& p) const {
    return octree_(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }

  /// The same for Mesh_3, for which the dimension and index of the point make no difference here.
  template <class Any_point, class Index> FT operator()(const Any_point& p, const int, const Index&) const {
    return octree_(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }

  /// About how many tetrahedra of this size fill the lumen: to know it before waiting for them. Within a third.
  double estimated_number_of_tetrahedra() const { return 7 * octree_.number_of_cubes(); }

private:
  static constexpr double leaf_per_radius = 0.8;

  static void check(double points, double min_size, double max_size, double gradation) {
    if (!(points >= 3 && points <= 1e6))
      throw Parameter_error("The number of points per circumference is " + std::to_string(points) +
                            ": give at least 3; 20 is usual.");
    if (!(min_size >= 0) || !(max_size > 0) || !(min_size <= max_size))
      throw Parameter_error("The limits of the mesh size, " + std::to_string(min_size) + " to " +
                            std::to_string(max_size) + ", are no interval of positive lengths.");
    if (!(gradation >= 1 && gradation <= 1e6))
      throw Parameter_error("The gradation is " + std::to_string(gradation) +
                            ": give the largest ratio of the sizes of neighboring elements, at least 1; 1.3 is usual.");
  }

  internal::Size_octree octree_;
};

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_FIELDS_CENTERLINE_SIZING_FIELD_H
