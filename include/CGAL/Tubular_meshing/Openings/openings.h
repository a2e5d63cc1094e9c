// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_OPENINGS_H
#define CGAL_TUBULAR_MESHING_OPENINGS_OPENINGS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Opening.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/Rims/flat_ends.h>
#include <CGAL/Tubular_meshing/Openings/internal/match_centerlines.h>
#include <CGAL/Tubular_meshing/Openings/order_openings.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parameters.h>


#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

template <class Graph> const Graph& as_graph(const std::reference_wrapper<Graph>& graph) {
  return graph.get();
}
template <class Graph> const Graph& as_graph(const Graph* graph) {
  return *graph;
}
inline const Centerline_graph& as_graph(const Centerline_graph& graph) {
  return graph;
}

inline void set_shape(Opening& opening, const Rim_shape& shape, bool inside_out) {
  opening.center = shape.center;
  opening.normal = inside_out ? -shape.plane.normal() : shape.plane.normal();
  opening.area = shape.area;
  opening.perimeter = shape.perimeter;
  opening.radius = shape.radius;
}

inline double median_radius(const std::vector<Opening_site>& sites) {
  std::vector<double> radii;
  for (const auto& site : sites)
    radii.push_back(site.shape.radius);
  if (radii.empty())
    return 0;
  std::nth_element(radii.begin(), radii.begin() + radii.size() / 2, radii.end());
  return radii[radii.size() / 2];
}

// Matches the loops to ends of the graph, and adds the flat ends that ends without a loop lead to.
inline std::vector<Centerline_ends::End> match_to_graph(const Surface& surface,
                                                          const Centerline_graph& graph, bool inside_out,
                                                          std::vector<Opening_site>& sites) {
  Flat_end_finder finder(surface, inside_out);
  const double radius = sites.empty() ? median_radius(finder.find(possible_flat_ends()[0])) : median_radius(sites);
  Centerline_ends ends(graph, radius);
  if (ends.ends().empty())
    return ends.ends();
  ends.match(sites, 0, inside_out);
  for (const Flat_end_criteria& criteria : possible_flat_ends()) {
    if (ends.all_matched())
      break;
    std::vector<Opening_site> extended = sites;
    for (auto& flat_end : finder.find(criteria))
      extended.push_back(std::move(flat_end));
    ends.match(extended, sites.size(), inside_out);
    ends.keep_matched(extended, sites.size());
    sites.swap(extended);
  }
  const std::string number = std::to_string(ends.ends().size());
  if (sites.empty())
    throw Input_error("The surface is closed, and none of the " + number +
                      " ends of the centerlines lies at a flat end of it: open the surface at its ends or cap them "
                      "flat, and check that these are its centerlines, in the same unit.");
  if (ends.none_matched())
    throw Input_error("None of the " + number + " ends of the centerlines lies near one of the " +
                      std::to_string(sites.size()) +
                      " openings of the surface: check that these are the centerlines of this surface, in the same "
                      "unit.");
  return ends.ends();
}

template <class NamedParameters>
std::size_t choose_inlet(const std::vector<Opening>& openings, std::size_t root, const NamedParameters& np) {
  const auto inlet = CGAL::parameters::get_parameter(np, internal_np::inlet);
  if constexpr (!std::is_same<decltype(inlet), const CGAL::internal_np::Param_not_found>::value) {
    if (!std::isfinite(inlet.x()) || !std::isfinite(inlet.y()) || !std::isfinite(inlet.z()))
      throw Parameter_error("The point of the inlet, " + coordinates(inlet) + ", has to have finite coordinates.");
    return nearest_opening(openings, Point_3(inlet.x(), inlet.y(), inlet.z()));
  } else {
    for (std::size_t i = 0; i < openings.size(); ++i)
      if (root != Opening::no_branch && openings[i].node == root)
        return i;
    return largest_opening(openings);
  }
}

// None, where the surface is closed and has no flat ends.
template <class NamedParameters>
std::vector<Opening> find_any_openings(const Surface& surface, const NamedParameters& np) {
  check_tubular_surface(surface);
  std::vector<Opening_site> sites = border_loops(surface);
  const bool inside_out = is_inside_out(surface, sites);
  sites.erase(std::remove_if(sites.begin(), sites.end(), [&](const auto& site) { return is_pinhole(site, surface); }),
              sites.end());

  std::vector<Centerline_ends::End> ends;
  std::size_t root = Opening::no_branch;
  const auto parameter = CGAL::parameters::get_parameter(np, internal_np::centerline_graph);
  if constexpr (!std::is_same<decltype(parameter), const CGAL::internal_np::Param_not_found>::value) {
    const auto& graph = as_graph(parameter);
    ends = match_to_graph(surface, graph, inside_out, sites);
    root = graph.root();
  }
  if (ends.empty())
    for (auto& flat_end : Flat_end_finder(surface, inside_out).find(certain_flat_end()))
      sites.push_back(std::move(flat_end));
  if (sites.empty())
    return {};

  std::vector<Opening> openings(sites.size());
  for (std::size_t i = 0; i < sites.size(); ++i)
    set_shape(openings[i], sites[i].shape, inside_out);
  for (const auto& end : ends)
    if (end.site != Centerline_ends::none) {
      openings[end.site].branch = end.branch;
      openings[end.site].node = end.node;
    }
  order_openings(openings, choose_inlet(openings, root, np));
  return openings;
}

} // namespace internal

/*!
 * \ingroup PkgTubularMeshingRef
 *
 * Finds the openings of a tubular surface: where fluid enters and leaves.
 *
 * - Each border loop of an open surface is an opening. Only a triangle or two missing in the middle of a smooth wall
 *   (a loop of three or four edges, in the plane of the faces around it) is none; close_openings() fills it as wall.
 * - An end that is closed already is recognised by its flat cap, by geometry alone: a disk-like set of facets within 5
 * % of its radius of their mean plane, bounded by one closed loop of edges at which the surface turns by more than 25
 *   degrees, convex and upright on average (60 degrees or more), round (4 pi area / perimeter² of at least 0.55, an
 *   ellipse of 3:1), and with at least five corners, so that the sides of coarse prism-like tubes and boxes are none.
 *   Each cap may be a fan, finely meshed, slightly dished or noisy. A surface may have open and closed ends.
 *
 * Where a graph of centerlines is given, each of its free ends is matched to the opening that its branch, prolonged
 * along its tangent by two radii, passes through; then `Opening::branch` and `Opening::node` are set. Flat caps then
 * count only, but also where their rim is blunt or they have fewer corners (a square duct), where a centerline ends.
 *
 * The inlet comes first. The outlets follow in the order of their nodes in the graph; those without a node, by
 * decreasing area (equal ones by increasing distance from the inlet). Apart from models with symmetries, this order
 * does not change when the surface is moved, turned, scaled or its vertices are renumbered. Opening `i` is labelled
 * `labels::of_opening(i)`.
 *
 * \param surface a triangle mesh, manifold, with consistently oriented faces. The normals of openings point out of the
 *   lumen even if those of the faces point into it.
 * \param np named parameters:
 *   - `centerline_graph`: the Centerline_graph, in `std::cref()` if it is not to be copied. Default: none.
 *   - `inlet`: a point; the opening whose centre is nearest to it is the inlet. Default: the opening at the root of the
 *     graph, if any, else the largest one (of several, the farthest from the mean of all).
 * \return the openings, with all lengths in the unit of the surface. Each opening is described by the mean plane of the
 *   vertices of its rim (length-weighted principal components), and by the area that the rim bounds in that plane.
 *
 * \throws Input_error if the surface is empty, has coordinates that are not finite or faces that are not triangles; if
 *   its border touches itself at a vertex; if it is closed and has no flat ends; if none of the graph's ends is near an
 *   opening.
 * \throws Parameter_error if the point of the inlet is not finite.
 *
 * Complexity: O(n) in the number of faces (expected), plus O(m log m) in openings and points of the graph.
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Opening> find_openings(const Surface& surface,
                                   const NamedParameters& np = CGAL::parameters::default_values()) {
  std::vector<Opening> openings = internal::find_any_openings(surface, np);
  if (openings.empty())
    throw Input_error("The surface is closed and has no flat ends, so that nothing can flow through it: open it where "
                      "vessels begin and end, cap these ends flat, or give the points (seeds) at which they are.");
  return openings;
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_OPENINGS_OPENINGS_H
