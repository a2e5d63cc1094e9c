// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_TUBULAR_MODEL_H
#define CGAL_TUBULAR_MESHING_TUBULAR_MODEL_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Centerlines/build_centerline_graph.h>
#include <CGAL/Tubular_meshing/Centerlines/check_centerlines.h>
#include <CGAL/Tubular_meshing/Centerlines/clip_to_openings.h>
#include <CGAL/Tubular_meshing/Operators/Opening.h>
#include <CGAL/Tubular_meshing/Operators/close_openings.h>
#include <CGAL/Tubular_meshing/Operators/openings.h>
#include <CGAL/Tubular_meshing/labels.h>
#include <CGAL/Tubular_meshing/parameters.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 *
 * A vessel or airway tree, ready to be meshed: its surface closed and labelled, its branches with their radii, its
 * openings. Every kind of mesh starts from one; make_tubular_model() prepares it.
 */
template <class Point_3_> struct Tubular_model {
  typedef Point_3_ Point_3;
  typedef CGAL::Surface_mesh<Point_3> Surface;
  typedef typename Surface::template Property_map<typename Surface::Face_index, int> Face_patch_map;

  Surface surface; ///< closed, turned outward; the label of a face is in its property map `f:patch`
  Face_patch_map patch;
  Centerline_graph<Point_3> centerlines;  ///< directed away from the inlet
  std::vector<Opening<Point_3>> openings; ///< the inlet first

  Tubular_model() { patch = surface.template add_property_map<typename Surface::Face_index, int>("f:patch", 0).first; }
  Tubular_model(const Tubular_model&) = delete; // the map refers to the surface's own properties
  Tubular_model& operator=(const Tubular_model&) = delete;
  Tubular_model(Tubular_model&&) = default;
  Tubular_model& operator=(Tubular_model&&) = default;
};

namespace internal {

/* What no mesher can do with: a surface in pieces, or one that intersects itself. Named here, with its place, rather
 * than by a mesher that fails or never ends. */
template <class Point_3> void check_volume_boundary(const CGAL::Surface_mesh<Point_3>& surface) {
  namespace PMP = CGAL::Polygon_mesh_processing;
  typedef typename CGAL::Surface_mesh<Point_3>::Face_index Face;
  std::vector<std::pair<Face, Face>> crossings;
  PMP::self_intersections<CGAL::Parallel_if_available_tag>(surface, std::back_inserter(crossings));
  if (!crossings.empty()) {
    const auto first = *std::min_element(crossings.begin(), crossings.end());
    throw Input_error("The surface intersects itself: " + std::to_string(crossings.size()) +
                      " pairs of its triangles cross, one of them at " +
                      coordinates(surface.point(surface.target(surface.halfedge(first.first)))) +
                      "; repair the surface there.");
  }
}

template <class Point_3> void check_one_piece(CGAL::Surface_mesh<Point_3>& surface) {
  typedef typename CGAL::Surface_mesh<Point_3>::Face_index Face;
  auto piece = surface.template add_property_map<Face, std::size_t>("f:tubular_meshing_piece").first;
  const std::size_t pieces = CGAL::Polygon_mesh_processing::connected_components(surface, piece);
  std::vector<std::size_t> size(pieces, 0);
  Face stray;
  for (Face f : surface.faces())
    ++size[piece[f]];
  const auto largest = std::size_t(std::max_element(size.begin(), size.end()) - size.begin());
  for (Face f : surface.faces())
    if (piece[f] != largest) {
      stray = f;
      break;
    }
  surface.remove_property_map(piece);
  if (pieces > 1)
    throw Input_error("The surface is in " + std::to_string(pieces) + " pieces, one of them at " +
                      coordinates(surface.point(surface.target(surface.halfedge(stray)))) +
                      ": keep one connected wall.");
}

} // namespace internal

/*! \ingroup PkgTubularMeshingRef
 *
 * prepares a surface and its centerlines for meshing: merges the lines into branches, finds the openings, closes them,
 * measures the local radii, and brings the branches' ends to the caps' centres.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph` with points of type `Point_3`
 *
 * \param surface the tree's surface, open at its ends or closed by flat caps
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
template <class Point_3, class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Tubular_model<Point_3> make_tubular_model(const TriangleMesh& surface, const Centerline_polylines<Point_3>& lines,
                                          const NamedParameters& np = CGAL::parameters::default_values()) {
  typedef Centerline_graph<Point_3> Graph;
  typedef Named_parameters<std::reference_wrapper<const Graph>, internal_np::centerline_graph_t, NamedParameters>
      With_graph;
  Tubular_model<Point_3> model;
  copy_face_graph(surface, model.surface);
  internal::check_tubular_surface(model.surface);
  internal::check_one_piece(model.surface);
  build_centerline_graph(lines, Wall_distance<Point_3>(model.surface), model.centerlines, np);

  model.openings = find_openings(model.surface, With_graph(std::cref(model.centerlines), np));
  close_openings(model.surface, model.openings, model.patch);
  internal::check_volume_boundary(model.surface);
  const std::vector<std::size_t> nodes = clip_to_openings(model.centerlines, model.openings);
  check_centerlines_inside(model.centerlines, model.surface);

  const Wall_distance<Point_3> wall(model.surface, model.patch, labels::wall);
  std::vector<double> radii;
  for (const Point_3& p : model.centerlines.points())
    radii.push_back(wall(p));
  model.centerlines.set_radii(std::move(radii));
  if (nodes.front() != Opening<Point_3>::no_branch)
    model.centerlines.direct_from(nodes.front());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    model.openings[i].node = nodes[i];
    model.openings[i].branch =
        nodes[i] == Opening<Point_3>::no_branch ? nodes[i] : model.centerlines.nodes()[nodes[i]].branches.front();
  }
  return model;
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_TUBULAR_MODEL_H
