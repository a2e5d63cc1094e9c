// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_SHAPE_RADIUS_H
#define CGAL_TUBULAR_MESHING_FIELDS_SHAPE_RADIUS_H

#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <memory>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingFields
 *
 * The options of Shape_radius: its named parameters.
 */
struct Shape_radius_options {
  bool turned_inward = false; ///< whether the wall's triangles are turned towards the lumen
  int number_of_threads = 0;

  Shape_radius_options() = default;
  template <class NamedParameters>
  explicit Shape_radius_options(const NamedParameters& np)
      : number_of_threads(internal::choose(np, internal_np::number_of_threads, 0)) {}
};

/*! \ingroup PkgTubularMeshingFields
 *
 * The radius of the lumen by its shape alone: that of the largest ball inside which touches the wall near a point. It
 * is the medial axis's radius, and needs no centerlines: in a vessel it is the vessel's radius, in the sac of an
 * aneurysm that of the sac, in its neck that of the neck, in a slit half its width.
 *
 * At each vertex of the wall a ball shrinks along the inward normal until none of the wall that lies opposite is
 * inside of it \cgalCite{ma2012}. Opposite is what lies within 36 degrees of the normal: the vertex's own
 * neighborhood, where noise and the steps of a segmented image decide, does not count, nor does a corner of the cross
 * section. Normals are averaged over half the radius, or half the median of the radii around a vertex, as its own normal
 * may lie along the steps of an image. A ball counts at all vertices within half its radius that it touches, within 12 % of
 * its radius or of that of large ones beside the vertex; of those at a vertex the fourth largest remains, so that what a few
 * vertices out of place say, or those between the steps of an image, matters not. Vertices that stand out like a spike,
 * further from the plane of their neighbors than these are from their middle, do not stop a ball. Caps are not part of the
 * wall, and do not either. No ball is smaller than the shortest edge at its vertex: what edges do not resolve is no shape.
 *
 * Where triangles are long and thin, a copy of the wall is measured in which their edges are divided until none is longer
 * than .7 of the radius: what the vertices tell of the shape counts, not how triangles join them.
 *
 * Built in O(n log n) for n triangles, less than 10 µs each; a query is O(log n), allocates nothing, and is safe from
 * several threads. Copies share the balls. Shapes scaled, moved or turned give the same radii, scaled, but for rounding. The
 * order of the triangles matters little: it decides which vertices, a fifth of the radius apart, stop balls.
 */
class Shape_radius {
public:
  typedef Tubular_meshing::Point_3 Point_3;

  /// The ball that touches the wall at a point.
  struct Ball {
    Point_3 on_wall; ///< the point of the wall that is nearest to that of the query
    Point_3 center;
    double radius;  ///< 0 if nothing of the wall lies opposite
    bool is_at_rim; ///< whether the wall ends at that point
  };

  /*!
   * \param wall the lumen's wall, turned outward, without its caps
   * \param np an optional sequence of named parameters among the ones listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{number_of_threads}
   *     \cgalParamDescription{0 takes all cores; the balls are the same on any number}
   *     \cgalParamType{`int`}
   *     \cgalParamDefault{0}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   */
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Shape_radius(const Wall_distance& wall, const NamedParameters& np = CGAL::parameters::default_values())
      : Shape_radius(wall, Shape_radius_options(np)) {}

  /*! The same, with options in a struct. */
  Shape_radius(const Wall_distance& wall, const Shape_radius_options& options);

  /// The radius at the point of the wall that is nearest to `x`; 0 if nothing of the wall lies opposite.
  double operator()(const Point_3& x) const { return ball(x).radius; }

  /// The ball there; its radius and center are interpolated between those of the triangle's corners.
  Ball ball(const Point_3& x) const;

  /// The balls at all of the wall's vertices, then those where edges of long, thin triangles are divided.
  std::vector<Ball> balls() const;

private:
  class Impl;
  std::shared_ptr<const Impl> impl_;
};

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Fields/Shape_radius_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_FIELDS_SHAPE_RADIUS_H
