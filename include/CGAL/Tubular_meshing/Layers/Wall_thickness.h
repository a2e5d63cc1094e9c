// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_WALL_THICKNESS_H
#define CGAL_TUBULAR_MESHING_LAYERS_WALL_THICKNESS_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Layers/Wall_array.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <cstddef>
#include <functional>
#include <map>
#include <type_traits>
#include <utility>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingLayers
 *
 * How thick a wall is: a multiple of the local radius, as a number says; or lengths in the unit of the mesh, the same
 * everywhere, of_length(), or a function of the point of the lumen's surface. thickness_of_array() makes one of values
 * on the surface, thickness_of_branches() one of a value for each branch. */
class Wall_thickness {
public:
  typedef std::function<double(const Point_3&)> Function;

  /// No wall.
  Wall_thickness() = default;

  /// A multiple of the local radius; 0: no wall.
  Wall_thickness(double radii)
      : radii_(radii) {}

  /// A function object that is called with a `Point_3` of the surface, from one thread.
  template <class F,
            class = std::enable_if_t<std::is_convertible<F, Function>::value && !std::is_arithmetic<F>::value &&
                                     !std::is_same<std::decay_t<F>, Wall_thickness>::value>>
  Wall_thickness(F length)
      : length_(std::move(length)) {}

  /// The same everywhere, in the unit of the mesh.
  static Wall_thickness of_length(double length) {
    return Wall_thickness([length](const Point_3&) { return length; });
  }

  bool is_there() const { return !is_relative() || radii_ != 0; }
  bool is_relative() const { return !length_; }

  /// Of a relative one.
  double radii() const { return radii_; }

  /// Of one that is not relative.
  const Function& length() const { return length_; }

  /// At a point of the surface with this local radius.
  double operator()(const Point_3& p, double radius) const { return length_ ? length_(p) : radii_ * radius; }

private:
  double radii_ = 0;
  Function length_;
};

/*! \ingroup PkgTubularMeshingLayers
 *
 * The thickness that an array gives: linear in triangles, of values at points; values of triangles are made such first,
 * each point having the mean of the triangles around it, by area. Off the triangles it is that of the nearest point.
 *
 * \throws Input_error if there are no triangles, or a value is not above 0, or not finite
 */
Wall_thickness thickness_of_array(const Wall_array& array);

/*! \ingroup PkgTubularMeshingLayers
 *
 * The thickness of branches, in the unit of the graph. Within two radii of a bifurcation, or half a branch, it passes
 * over from the mean of the branches that meet to that of the branch.
 *
 * \param graph the branches, of which a copy is kept
 * \param thickness by their index
 * \param otherwise of branches that are not listed; 0: all have to be
 *
 * \throws Input_error if a value is not above 0, or not finite, if there is no such branch, or one is missing
 */
Wall_thickness thickness_of_branches(const Centerline_graph& graph, const std::map<std::size_t, double>& thickness,
                                     double otherwise = 0);

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Layers/Wall_thickness_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_LAYERS_WALL_THICKNESS_H
