// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_TUBULAR_MODEL_H
#define CGAL_TUBULAR_MESHING_PIPELINES_TUBULAR_MODEL_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Centerlines/build_centerline_graph.h>
#include <CGAL/Tubular_meshing/Centerlines/check_centerlines.h>
#include <CGAL/Tubular_meshing/Centerlines/clip_to_openings.h>
#include <CGAL/Tubular_meshing/Centerlines/compute_centerlines.h>
#include <CGAL/Tubular_meshing/base/Opening.h>
#include <CGAL/Tubular_meshing/Openings/close_openings.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/check_meshable.h>
#include <CGAL/Tubular_meshing/Patches/follow_blind_vessels.h>
#include <CGAL/Tubular_meshing/Openings/seeds.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 *
 * A vessel or airway tree, ready to be meshed: its surface closed and labelled, its branches with their radii, its
 * openings. Every kind of mesh starts from one; make_tubular_model() prepares it.
 */
struct Tubular_model {
  typedef Tubular_meshing::Point_3 Point_3;
  typedef CGAL::Surface_mesh<Point_3> Surface;
  typedef typename Surface::template Property_map<typename Surface::Face_index, int> Face_patch_map;

  Surface surface; ///< closed, turned outward; the label of a face is in its property map `f:patch`
  Face_patch_map patch;
  Centerline_graph centerlines;  ///< directed away from the inlet
  std::vector<Opening> openings; ///< the inlet first

  Tubular_model() { patch = surface.add_property_map<typename Surface::Face_index, int>("f:patch", 0).first; }
  Tubular_model(const Tubular_model&) = delete; // the map refers to the surface's own properties
  Tubular_model& operator=(const Tubular_model&) = delete;
  Tubular_model(Tubular_model&&) = default;
  Tubular_model& operator=(Tubular_model&&) = default;
};

namespace internal {

// Lets the openings know their branches.
inline void connect(Tubular_model& model, const std::vector<std::size_t>& node_of_opening) {
  for (std::size_t i = 0; i < node_of_opening.size(); ++i) {
    const std::size_t node = node_of_opening[i];
    model.openings[i].node = node;
    model.openings[i].branch = node == Opening::no_branch ? node : model.centerlines.nodes()[node].branches.front();
  }
}

// A copy of the surface of which the rest of the package may rely on being one piece of triangles.
template <class TriangleMesh> void copy_surface(const TriangleMesh& surface, Tubular_model& model) {
  copy_face_graph(surface, model.surface);
  check_tubular_surface(model.surface);
  check_one_piece(model.surface);
}

} // namespace internal

/*! \ingroup PkgTubularMeshingRef
 *
 * prepares a surface and its centerlines for meshing: merges the lines into branches, finds the openings, closes them,
 * measures the local radii, and brings the branches' ends to the caps' centres.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph` with points of type `Point_3`
 *
 * \param surface the tree's surface, open at its ends or closed by flat caps; see repair_surface() for one that is not
 *   clean
 * \param lines its centerlines, as read by IO::read_centerlines()
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{inlet} \cgalParamDescription{a `Point_3`: the nearest opening is the inlet}
 *     \cgalParamDefault{the opening at the lines' common start, else the largest} \cgalParamNEnd
 *   \cgalParamNBegin{merge_tolerance} \cgalParamDescription{see build_centerline_graph()} \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * O(n log n) in the sizes of surface and lines.
 *
 * \throws Input_error if the surface is in pieces or intersects itself, if the surface or the lines cannot be used, or
 *   if they do not belong together
 */
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Tubular_model make_tubular_model(const TriangleMesh& surface, const Centerline_polylines& lines,
                                 const NamedParameters& np = CGAL::parameters::default_values()) {
  typedef Centerline_graph Graph;
  typedef Named_parameters<std::reference_wrapper<const Graph>, internal_np::centerline_graph_t, NamedParameters>
      With_graph;
  Tubular_model model;
  internal::copy_surface(surface, model);
  build_centerline_graph(lines, Wall_distance(model.surface), model.centerlines, np);

  model.openings = find_openings(model.surface, With_graph(std::cref(model.centerlines), np));
  close_openings(model.surface, model.openings, model.patch);
  internal::check_no_crossings(model.surface);
  const std::vector<std::size_t> nodes = clip_to_openings(model.centerlines, model.openings);
  check_centerlines_inside(model.centerlines, model.surface);

  const Wall_distance wall(model.surface, model.patch, labels::wall);
  std::vector<double> radii;
  for (const Point_3& p : model.centerlines.points())
    radii.push_back(wall(p));
  model.centerlines.set_radii(std::move(radii));
  if (nodes.front() != Opening::no_branch)
    model.centerlines.direct_from(nodes.front());
  internal::connect(model, nodes);
  return model;
}

/*! \ingroup PkgTubularMeshingRef
 *
 * the same for a surface alone: its centerlines are computed, by compute_centerlines(), from the inlet to each outlet,
 * and to the tips of vessels that end blind.
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{inlet} \cgalParamDescription{a `Point_3`: the nearest opening is the inlet}
 *     \cgalParamDefault{the first seed's, else the largest} \cgalParamNEnd
 *   \cgalParamNBegin{seeds} \cgalParamDescription{a `std::vector<Point_3>`: where vessels end without an opening or a
 *     flat cap; the lines begin at the first. One that lies at an opening stands for the opening}
 *     \cgalParamDefault{none} \cgalParamNEnd
 *   \cgalParamNBegin{blind_vessels} \cgalParamDescription{whether lines lead into vessels that end without an opening,
 *     and are at least one and a half times longer than wide} \cgalParamDefault{`true`} \cgalParamNEnd
 *   \cgalParamNBegin{loops, merge_tolerance} \cgalParamDescription{see compute_centerlines()} \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Input_error if the surface is in pieces or intersects itself, or has fewer than two ends
 */
template <class T, class Tag, class Base>
Tubular_model make_tubular_model(const CGAL::Surface_mesh<Point_3>& surface,
                                 const CGAL::Named_function_parameters<T, Tag, Base>& np) {
  const auto seeds = internal::choose(np, internal_np::seeds, std::vector<Point_3>());
  Tubular_model model;
  internal::copy_surface(surface, model);
  model.openings = internal::find_openings_or_seeds(model.surface, seeds, Find_openings_options(np));
  close_openings(model.surface, model.openings, model.patch);
  internal::check_no_crossings(model.surface);
  const bool blind_vessels = internal::choose(np, internal_np::blind_vessels, true);
  internal::Centerline_computation computation(model.surface, model.patch,
                                               internal::ends_of_lines(model.openings, seeds),
                                               internal::choose(np, internal_np::loops, false), blind_vessels);
  computation.make_graph(model.centerlines, np);
  if (blind_vessels)
    internal::follow_blind_vessels(model.surface, model.patch, computation, model.centerlines, np);
  internal::connect(model, internal::nodes_at(model.centerlines, model.openings));
  return model;
}

inline Tubular_model make_tubular_model(const CGAL::Surface_mesh<Point_3>& surface) {
  return make_tubular_model(surface, CGAL::parameters::default_values());
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_PIPELINES_TUBULAR_MODEL_H
