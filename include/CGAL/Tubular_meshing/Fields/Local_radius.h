// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_LOCAL_RADIUS_H
#define CGAL_TUBULAR_MESHING_FIELDS_LOCAL_RADIUS_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Fields/Shape_radius.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Named_function_parameters.h>

#include <limits>
#include <memory>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingFields
 *
 * The radius that sizes, layers and walls are relative to: on a plain branch that of the centerline, elsewhere that of
 * the lumen's shape, see Shape_radius. Where no centerline runs, or where it runs but the lumen is something else than a
 * tube around it (in the sac of an aneurysm and in its neck, in a communicating vessel, a slit, a ventricle), the
 * distance to the nearest centerline says nothing of the lumen's width; the ball that touches the wall does.
 *
 * A branch is plain at a point of the wall where the ball that touches there has its center near the centerline,
 * within 0.4 of the ball's radius, and a radius that is within 2/3 and 5/4 of the centerline's. Where the center is off
 * by 3/4, or the radius is less than half or more than 8/5 of the centerline's, the ball's radius counts alone; in
 * between the two pass over into each other. A branch is plain in any case where neither the wall nor the center is
 * outside of the centerline's tube: no further from the centerline than 1.25 and 0.85 of its radius; from 1.7 or 1.05 on
 * the ball counts as said. The centerline's radius on a plain branch is
 * kept as it is, since it is smoother than what vertices tell.
 *
 * A query is O(log n), takes about 10 µs, allocates nothing, and is safe from several threads. Copies share the data.
 */
class Local_radius {
public:
  typedef Tubular_meshing::Point_3 Point_3;

  /*!
   * \param centerlines descriptors of the centerlines
   * \param wall the lumen's wall, without its caps, all turned outward or all inward
   * \param np `number_of_threads`, as of Shape_radius
   */
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  Local_radius(const Centerline_field& centerlines, const Wall_distance& wall,
               const NamedParameters& np = CGAL::parameters::default_values())
      : Local_radius(centerlines, wall, Shape_radius_options(np)) {}

  /*! The same, with options in a struct. Which way the wall is turned is found out. */
  Local_radius(const Centerline_field& centerlines, const Wall_distance& wall, const Shape_radius_options& options);

  /// The radius at the wall point nearest to `x`; on a plain branch r(x_c), the radius of the centerline's nearest
  /// point.
  double operator()(const Point_3& x) const;

  /// What there is to know at a point, all from one search.
  struct Radii {
    Point_3 on_wall;                             ///< the point of the wall nearest to it
    Centerline_field::Descriptors of_centerline; ///< nearest to the wall point
    double distance_outside;                     ///< how far the point is from the lumen: 0 inside
    double of_ball;                              ///< Shape_radius; 0 if nothing lies opposite
    double share_of_ball; ///< by where the ball's center is: 0 on a plain branch, 1 where the ball counts alone
    double outside; ///< 0 where the wall and the ball's center are in the centerline's tube, 1 where one is outside

    /// The share of the ball's radius beside a radius of the centerline, from 0 to 1: the larger of that by the
    /// center's place and that by how much the radii differ.
    double share_against(double radius_of_centerline) const;

    /// The geometric mean of a radius of the centerline and that of the ball by these shares; where the branch is
    /// plain, the former, unchanged.
    double combined(double radius_of_centerline) const;
  };
  /*! Of a point outside, farther than `reach` from the lumen, the shares are not looked for, and are 0. */
  Radii radii(const Point_3& x, double reach = (std::numeric_limits<double>::infinity)()) const;

  /*! How wide a cube around `x` may be, up to a bound, so that it holds no point of the wall where the branch is not
   * plain and the radius is less than the width over `width_per_radius`, within a tenth: what makes an octree find
   * vessels that are much narrower than those around. */
  double largest_width(const Point_3& x, double width_per_radius, double bound) const;

  /// The box of the wall.
  CGAL::Bbox_3 bbox() const;

private:
  class Impl;
  std::shared_ptr<const Impl> impl_;
};

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Fields/Local_radius_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_FIELDS_LOCAL_RADIUS_H
