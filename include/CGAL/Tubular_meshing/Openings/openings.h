// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_OPENINGS_H
#define CGAL_TUBULAR_MESHING_OPENINGS_OPENINGS_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Opening.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingOpenings
 *
 * The options of find_openings(): its named parameters of the same names. */
struct Find_openings_options {
  const Centerline_graph* centerline_graph = nullptr; ///< null: there is none
  std::optional<Point_3> inlet;                       ///< the nearest opening is the inlet
  std::vector<Point_3> blind_ends;                    ///< points: the capped end nearest to each is no opening

  Find_openings_options() = default;
  template <class NamedParameters> explicit Find_openings_options(const NamedParameters& np) {
    using CGAL::parameters::get_parameter;
    set_graph(get_parameter(np, internal_np::centerline_graph));
    inlet = internal::optional_point(np, internal_np::inlet);
    blind_ends = internal::choose(np, internal_np::blind_ends, blind_ends);
  }

private:
  void set_graph(const Centerline_graph* graph) { centerline_graph = graph; }
  template <class Graph> void set_graph(const std::reference_wrapper<Graph>& graph) { centerline_graph = &graph.get(); }
  void set_graph(const Centerline_graph& graph) {
    copy_ = std::make_shared<const Centerline_graph>(graph);
    centerline_graph = copy_.get();
  }
  void set_graph(const CGAL::internal_np::Param_not_found&) {}

  std::shared_ptr<const Centerline_graph> copy_; // where a graph itself is the parameter
};

namespace internal {

std::vector<Opening> find_openings(const Surface& surface, const Find_openings_options& options);

/* None, where the surface is closed and has no flat ends, nor any that a crease bounds. */
std::vector<Opening> find_any_openings(const Surface& surface, const Find_openings_options& options);

/* Its two steps: finds them, and chooses the inlet, by which they are ordered and labelled. */
std::vector<Opening> find_unordered_openings(const Surface& surface, const Find_openings_options& options);
void order_from_inlet(std::vector<Opening>& openings, const Find_openings_options& options);

void check_not_closed(const std::vector<Opening>& openings);

} // namespace internal

/*!
 * \ingroup PkgTubularMeshingOpenings
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
 * \tparam TriangleMesh a model of `FaceListGraph`
 *
 * \param surface a triangle mesh, manifold, with consistently oriented faces. The normals of openings point out of the
 *   lumen even if those of the faces point into it.
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{centerline_graph}
 *     \cgalParamDescription{the graph of the surface's centerlines, or a pointer to it}
 *     \cgalParamType{Centerline_graph, in `std::cref()` if it is not to be copied}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{inlet}
 *     \cgalParamDescription{a point: the opening whose centre is nearest to it is the inlet}
 *     \cgalParamType{a model of `Kernel::Point_3`}
 *     \cgalParamDefault{the opening at the root of the graph, if any, else the largest one (of several, the farthest
 *       from the mean of all)}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{blind_ends}
 *     \cgalParamDescription{points: the capped end nearest to each, if the point is within a radius of its cap, is no
 *       opening but the blind end of a vessel. Counts where there is no graph}
 *     \cgalParamType{`std::vector<Point_3>`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the vertices of `surface`}
 *     \cgalParamType{a model of `ReadablePropertyMap`}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, surface)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the openings, with all lengths in the unit of the surface. Each opening is described by the mean plane of the
 *   vertices of its rim (length-weighted principal components), and by the area that the rim bounds in that plane.
 *
 * \throws Input_error if the surface is empty, has coordinates that are not finite or faces that are not triangles; if
 *   its border touches itself at a vertex; if it is closed and has no flat ends; if none of the graph's ends is near an
 *   opening; if a point of `blind_ends` lies in a border loop, which is open.
 * \throws Parameter_error if the point of the inlet is not finite.
 *
 * Complexity: O(n) in the number of faces (expected), plus O(m log m) in openings and points of the graph.
 */
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Opening> find_openings(const TriangleMesh& surface,
                                   const NamedParameters& np = CGAL::parameters::default_values()) {
  const internal::Core_surface<TriangleMesh, NamedParameters> core(surface, np);
  return internal::find_openings(*core, Find_openings_options(np));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Openings/openings_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_OPENINGS_OPENINGS_H
