// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_COMPUTE_CENTERLINES_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_COMPUTE_CENTERLINES_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Centerlines/build_centerline_graph.h>
#include <CGAL/Tubular_meshing/base/Canonical_frame.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Centerline_tracer.h>
#include <CGAL/Tubular_meshing/base/Opening.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

inline void check_closed_surface(const CGAL::Surface_mesh<Point_3>& surface) {
  if (surface.is_empty())
    throw Input_error("The surface is empty; it has no centerlines.");
  if (!CGAL::is_triangle_mesh(surface) || !CGAL::is_closed(surface))
    throw Input_error("Centerlines are computed inside closed surfaces of triangles; close the openings of this one "
                      "first (close_openings()), and triangulate its faces.");
  for (auto v : surface.vertices())
    for (int k = 0; k < 3; ++k)
      if (!std::isfinite(CGAL::to_double(surface.point(v)[k])))
        throw Input_error("Vertex " + std::to_string(std::size_t(v)) +
                          " of the surface has a coordinate that is not a number; repair the file.");
}

// Of a closed surface: the number of independent cycles inside it, half of those on it.
inline int genus(const CGAL::Surface_mesh<Point_3>& surface) {
  const long characteristic =
      long(surface.number_of_vertices()) - long(surface.number_of_edges()) + long(surface.number_of_faces());
  return int((2 - characteristic) / 2);
}

// The graph in the canonical frame, as a graph of the caller's points.
inline Centerline_graph from_canonical(const Centerline_graph& graph, const Canonical_frame& frame,
                                       const Point_3& root) {
  std::vector<Point_3> points;
  std::vector<double> radii;
  std::vector<std::vector<std::size_t>> branches;
  for (const Point_3& p : graph.points()) {
    const Double_kernel::Point_3 q = frame.from_canonical(to_double_point(p));
    points.emplace_back(q.x(), q.y(), q.z());
  }
  for (double r : graph.radii())
    radii.push_back(frame.scale() * r);
  for (const auto& b : graph.branches())
    branches.push_back(b.points);
  Centerline_graph result(std::move(points), std::move(radii), std::move(branches));
  const auto away = [&](std::size_t n) {
    return CGAL::to_double(CGAL::squared_distance(result.points()[result.nodes()[n].point], root));
  };
  std::size_t nearest = 0;
  for (std::size_t n = 1; n < result.nodes().size(); ++n)
    if (away(n) < away(nearest))
      nearest = n;
  result.direct_from(nearest);
  return result;
}

/* The computation of compute_centerlines(), to which further ends can be added at little cost. */
class Centerline_computation {
public:
  /* `ends` are points, each with the label of the faces around it. Further ends can be added if `everywhere`. */
  Centerline_computation(const CGAL::Surface_mesh<Point_3>& surface, const Face_patch_map& patch,
                         const std::vector<std::pair<Point_3, int>>& ends, bool loops, bool everywhere)
      : frame_(points_of(surface, ends.size()))
      , root_(ends.front().first)
      , tracer_(Sampled_surface(surface, patch, frame_), canonical(ends))
      , wall_(tracer_.wall_triangles()) {
    tracer_.trace(loops ? genus(surface) : 0, everywhere);
  }

  // Adds a line to a vertex of the wall; false if none leads there.
  bool add_end(Surface::Vertex_index v) { return tracer_.add_end(std::size_t(v)); }

  // Merges the lines into branches.
  template <class NamedParameters> void make_graph(Centerline_graph& graph, const NamedParameters& np) const {
    Centerline_polylines polylines;
    for (const Sampled_line& line : tracer_.lines()) {
      polylines.lines.emplace_back();
      for (const Line_point& p : line) {
        polylines.lines.back().push_back(polylines.points.size());
        polylines.points.emplace_back(p.point.x(), p.point.y(), p.point.z());
      }
    }
    const auto radius = [&](const Point_3& p) { return std::sqrt(wall_.nearest(to_double_point(p)).squared_distance); };
    Centerline_graph merged;
    build_centerline_graph(polylines, radius, merged, np);
    graph = from_canonical(merged, frame_, root_);
  }

private:
  static std::vector<Double_kernel::Point_3> points_of(const CGAL::Surface_mesh<Point_3>& surface,
                                                       std::size_t number_of_ends) {
    check_closed_surface(surface);
    if (number_of_ends < 2)
      throw Input_error("Centerlines lead from an inlet to outlets, but the surface has only " +
                        std::to_string(number_of_ends) + " opening; name further ends, by points.");
    std::vector<Double_kernel::Point_3> points;
    for (auto v : surface.vertices())
      points.push_back(to_double_point(surface.point(v)));
    return points;
  }

  std::vector<Centerline_end> canonical(const std::vector<std::pair<Point_3, int>>& ends) const {
    std::vector<Centerline_end> result;
    for (const auto& e : ends)
      result.push_back(Centerline_end{frame_.to_canonical(to_double_point(e.first)), e.second});
    return result;
  }

  const Canonical_frame frame_;
  const Point_3 root_;
  Centerline_tracer tracer_;
  const Nearest_tree<Double_kernel::Triangle_3> wall_;
};

template <class NamedParameters>
void compute_centerlines(const CGAL::Surface_mesh<Point_3>& surface, const Face_patch_map& patch,
                         const std::vector<std::pair<Point_3, int>>& ends, Centerline_graph& graph,
                         const NamedParameters& np) {
  if (ends.empty()) // before one is taken for the root
    throw Input_error("Centerlines lead from an inlet to outlets, but the surface has no opening; name its ends, by "
                      "points.");
  Centerline_computation(surface, patch, ends, choose(np, internal_np::loops, false), false).make_graph(graph, np);
}

} // namespace internal

/*! \ingroup PkgTubularMeshingRef
 *
 * Computes the centerlines of a tubular surface, from its inlet to each outlet: the paths on the Voronoi diagram that
 * minimize the integral of 1/R, R being the radius of the maximal inscribed sphere (section 2.1; L. Antiga,
 * B. Ene-Iordache and A. Remuzzi, 2003).
 *
 * The surface's vertices, with further points where triangles are large against the vessel, are samples of a Delaunay
 * triangulation. The circumcentres of its inner tetrahedra make an approximate medial axis, over whose faces one front
 * runs from the inlet to all outlets. Paths are traced back by steepest descent, smoothed by local fits over one
 * radius, which keeps them in the middle, and merged into branches with build_centerline_graph(). They end at the caps'
 * centres; the radii are distances to the wall, caps left out.
 *
 * The result does not depend on the unit, the position or the direction of the surface, nor on the order of its
 * vertices and triangles, apart from surfaces with symmetries.
 *
 * O(n log n) in the surface's size, plus the length of the lines, for surfaces sampled as evenly as segmented ones.
 *
 * \param surface a closed triangle mesh, turned outwards: what close_openings() leaves
 * \param patch a readable property map from face to int: `labels::wall`, or the label of the face's opening
 * \param openings two or more; the first is the inlet
 * \param graph is replaced; its root is at the inlet
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{loops} \cgalParamDescription{whether vessels that split and rejoin keep all their branches, not
 * only those on a shortest path} \cgalParamDefault{`false`} \cgalParamNEnd \cgalParamNBegin{merge_tolerance}
 * \cgalParamDescription{see build_centerline_graph()} \cgalParamNEnd \cgalNamedParamsEnd
 *
 * \throws Input_error if the surface is not closed, has fewer than two openings, or its inside does not connect them
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
void compute_centerlines(const CGAL::Surface_mesh<Point_3>& surface, Face_patch_map patch,
                         const std::vector<Opening>& openings, Centerline_graph& graph,
                         const NamedParameters& np = CGAL::parameters::default_values()) {
  std::vector<std::pair<Point_3, int>> ends;
  for (const Opening& o : openings)
    ends.emplace_back(o.center, o.patch);
  internal::compute_centerlines(surface, patch, ends, graph, np);
}

/*! \ingroup PkgTubularMeshingRef
 *
 * The same for surfaces without flat ends: from the first of the given points to each of the others. A point stands for
 * the largest inscribed sphere that touches the surface where it is nearest to the point; the lines end at the centres
 * of these spheres.
 *
 * \param surface a closed triangle mesh, turned outwards; all of it is wall
 * \param ends two points or more, the source first
 * \param graph is replaced; its root is at the source
 * \param np the named parameters `loops` and `merge_tolerance`, as above
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
void compute_centerlines(const CGAL::Surface_mesh<Point_3>& surface, const std::vector<Point_3>& ends,
                         Centerline_graph& graph, const NamedParameters& np = CGAL::parameters::default_values()) {
  Surface labelled = surface;
  const Face_patch_map patch = labelled.add_property_map<Surface::Face_index, int>("f:patch").first;
  for (Surface::Face_index f : labelled.faces())
    patch[f] = labels::wall;
  std::vector<std::pair<Point_3, int>> all;
  for (const Point_3& p : ends)
    all.emplace_back(p, int(labels::wall));
  internal::compute_centerlines(labelled, patch, all, graph, np);
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_COMPUTE_CENTERLINES_H
