// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_CENTERLINE_SIZING_FIELD_H
#define CGAL_TUBULAR_MESHING_FIELDS_CENTERLINE_SIZING_FIELD_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Fields/Local_radius.h>
#include <CGAL/Tubular_meshing/Fields/Size_requests.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

#include <limits>
#include <memory>

namespace CGAL::Tubular_meshing {

namespace internal {

class Size_octree;

} // namespace internal

/*! \ingroup PkgTubularMeshingFields
 *
 * The options of Centerline_sizing_field: its named parameters.
 */
struct Centerline_sizing_field_options {
  double points_per_circumference = 20;
  double min_size = 0;
  double max_size = (std::numeric_limits<double>::infinity)();
  double gradation = 1.3;
  Size_requests size_requests;
  int number_of_threads = 0;

  Centerline_sizing_field_options() = default;
  template <class NamedParameters> explicit Centerline_sizing_field_options(const NamedParameters& np) {
    points_per_circumference = internal::choose(np, internal_np::points_per_circumference, points_per_circumference);
    min_size = internal::choose(np, internal_np::min_size, min_size);
    max_size = internal::choose(np, internal_np::max_size, max_size);
    gradation = internal::choose(np, internal_np::gradation, gradation);
    size_requests = internal::choose(np, internal_np::size_requests, size_requests);
    number_of_threads = internal::choose(np, internal_np::number_of_threads, number_of_threads);
  }
};

/*! \ingroup PkgTubularMeshingFields
 *
 * The mesh size that gives every vessel the same number of points round its circumference: h = 2 π r / N, r the local
 * radius, growing no faster from one element to the next than the gradation allows.
 *
 * The radius is the Local_radius at the nearest wall point. On a plain branch this is the radius of the centerline, or
 * that wall point's own distance to the centerline where this is larger. Elsewhere it is that of the largest ball in
 * the lumen that touches the wall there: the sac of an aneurysm, its neck, and a communicating vessel that no
 * centerline follows have N points round themselves, not round the vessel that the nearest centerline is in.
 *
 * The field is sampled once, on an octree whose leaves are as large as the local radius allows; afterwards it depends
 * on nothing that it was built from, and copies share it. Building takes O(n log n) in the number n of leaves, which is
 * proportional to the length of the tree over its radius, and in that of the wall's triangles; a query takes about 0.1 µs, allocates nothing, and is safe
 * from several threads.
 *
 * \cgalModels `MeshDomainField_3`, so it can be given to `Mesh_criteria_3` as it is.
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
   *   \cgalParamNBegin{points_per_circumference}
   *     \cgalParamDescription{N; at least 3}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{20}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{min_size}
   *     \cgalParamDescription{lower limit of h, a length}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{0}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{max_size}
   *     \cgalParamDescription{upper limit of h, a length}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{infinity}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{gradation}
   *     \cgalParamDescription{largest ratio of the sizes of neighboring elements, at least 1}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{1.3}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{size_requests}
   *     \cgalParamDescription{where the mesh is to be finer or coarser, and sizes given on the surface}
   *     \cgalParamType{Size_requests}
   *     \cgalParamDefault{none}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{number_of_threads}
   *     \cgalParamDescription{0 takes all cores}
   *     \cgalParamType{`int`}
   *     \cgalParamDefault{0}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws Parameter_error if one of these is out of its range
   */
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  Centerline_sizing_field(const Centerline_field& centerlines, const Wall_distance& wall,
                          const NamedParameters& np = CGAL::parameters::default_values())
      : Centerline_sizing_field(centerlines, wall, Centerline_sizing_field_options(np)) {}

  /*! The same, with options in a struct. */
  Centerline_sizing_field(const Centerline_field& centerlines, const Wall_distance& wall,
                          const Centerline_sizing_field_options& options);

  /*! By a local radius that is there already, as other fields or layers share it.
   * \throws Parameter_error as above */
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Centerline_sizing_field(const Local_radius& radius,
                                   const NamedParameters& np = CGAL::parameters::default_values())
      : Centerline_sizing_field(radius, Centerline_sizing_field_options(np)) {}

  /*! The same, with options in a struct. */
  Centerline_sizing_field(const Local_radius& radius, const Centerline_sizing_field_options& options);

  /// The mesh size at a point, a length in the unit of the surface.
  FT operator()(const Point_3& p) const { return size(p.x(), p.y(), p.z()); }

  /// The same for Mesh_3, for which the dimension and index of the point make no difference here.
  template <class Any_point, class Index> FT operator()(const Any_point& p, const int, const Index&) const {
    return size(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }

  /// About how many tetrahedra of this size fill the lumen: to know it before waiting for them. Within a third.
  double estimated_number_of_tetrahedra() const;

private:
  double size(double x, double y, double z) const;

  std::shared_ptr<const internal::Size_octree> octree_;
};

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_FIELDS_CENTERLINE_SIZING_FIELD_H
