// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_COMPUTE_CENTERLINES_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_COMPUTE_CENTERLINES_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Centerlines/build_centerline_graph.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Opening.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingCenterlines
 *
 * The options of compute_centerlines(): its named parameters.
 */
struct Compute_centerlines_options {
  bool loops = true;            ///< whether vessels that split and rejoin keep all their branches
  double merge_tolerance = 0.1; ///< see build_centerline_graph()
  int number_of_threads = 0;    ///< 0: all there are; the result does not depend on it

  Compute_centerlines_options() = default;
  template <class NamedParameters>
  explicit Compute_centerlines_options(const NamedParameters& np)
      : loops(internal::choose(np, internal_np::loops, true))
      , merge_tolerance(internal::choose(np, internal_np::merge_tolerance, 0.1))
      , number_of_threads(internal::choose(np, internal_np::number_of_threads, 0)) {}
};

namespace internal {

/* The computation of compute_centerlines(), to which further ends can be added at little cost. */
class Centerline_computation {
public:
  /* `ends` are points, each with the label of the faces around it, two at least. Further ends can be added if
   * `everywhere`; then one will do. `threads`: 0 for all. `beside` is done when there is work for one thread only, so
   * that it may take no time; what it throws is thrown. */
  Centerline_computation(
      const Surface& surface, const Face_patch_map& patch, const std::vector<std::pair<Point_3, int>>& ends, bool loops,
      bool everywhere, int threads = 0, Function_view<void()> beside = [] {});
  ~Centerline_computation();

  /* Adds a line to each of these vertices of the wall to which one leads; false if there are none. */
  bool add_ends(const std::vector<Surface::Vertex_index>& vertices);

  /* Lets the lines lead from that of their ends that is nearest to a point to all others. Only where all ends are places
   * of the wall, and none is an opening, and with `everywhere`. */
  void start_from(const Point_3& end);

  /* Of all lines, the length of that which is longest against the largest ball along it, in radii of that. */
  double longest_line() const;

  /* Merges the lines, of which there has to be one, into branches. */
  void make_graph(Centerline_graph& graph, const Build_centerline_graph_options& options) const;
  template <class NamedParameters> void make_graph(Centerline_graph& graph, const NamedParameters& np) const {
    make_graph(graph, Build_centerline_graph_options(np));
  }

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

void compute_centerlines(const Surface& surface, const Face_patch_map& patch, const std::vector<Opening>& openings,
                         Centerline_graph& graph, const Compute_centerlines_options& options);
void compute_centerlines(const Surface& surface, const std::vector<Point_3>& ends, Centerline_graph& graph,
                         const Compute_centerlines_options& options);

} // namespace internal

/*! \ingroup PkgTubularMeshingCenterlines
 *
 * Computes the centerlines of a tubular surface, from its inlet to each outlet: the paths on the Voronoi diagram that
 * minimize the integral of 1/R, R being the radius of the maximal inscribed sphere (section 2.1; L. Antiga,
 * B. Ene-Iordache and A. Remuzzi, 2003).
 *
 * The surface's vertices are samples of a Delaunay triangulation: with further points where triangles are large against
 * the vessel, and, where they are small against it, only so many that all are within a quarter of the local radius of
 * one. The circumcentres of its inner tetrahedra make an approximate medial axis, over whose faces one front
 * runs from the inlet to all outlets. Paths are traced back by steepest descent, smoothed by local fits over one
 * radius, which keeps them in the middle, and merged into branches with build_centerline_graph(). They end at the caps'
 * centres; the radii are distances to the wall, caps left out.
 *
 * The result does not depend on the unit, the position or the direction of the surface, nor on the order of its
 * vertices and triangles, apart from surfaces with symmetries.
 *
 * O(n log n) in the surface's size, plus the length of the lines, for surfaces sampled as evenly as segmented ones.
 *
 * \tparam TriangleMesh a model of `FaceListGraph`, of any kernel
 * \param surface a closed triangle mesh, turned outwards: what close_openings() leaves
 * \param patch a readable property map from face to int: `labels::wall`, or the label of the face's opening
 * \param openings two or more; the first is the inlet
 * \param graph is replaced; its root is at the inlet
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{loops}
 *     \cgalParamDescription{whether vessels that split and rejoin keep all their branches, not only those on a shortest
 *       path. On a surface of genus 0, whose lumen has no loops, it makes no difference}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`true`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{merge_tolerance}
 *     \cgalParamDescription{see build_centerline_graph()}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{0.1}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads}
 *     \cgalParamDescription{of the work that can be shared out; 0: all there are. The result does not depend on it}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{0}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the surface's vertices}
 *     \cgalParamType{a readable property map from its vertices to points}
 *     \cgalParamDefault{`get(CGAL::vertex_point, surface)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Input_error if the surface is not closed, has fewer than two openings, or its inside does not connect them
 */
template <class TriangleMesh, class FacePatchMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
void compute_centerlines(const TriangleMesh& surface, FacePatchMap patch, const std::vector<Opening>& openings,
                         Centerline_graph& graph, const NamedParameters& np = CGAL::parameters::default_values()) {
  const internal::Core_labelled_surface<TriangleMesh, FacePatchMap, NamedParameters> core(surface, patch, np);
  internal::compute_centerlines(core.surface(), core.patch(), openings, graph, Compute_centerlines_options(np));
}

/*! \ingroup PkgTubularMeshingCenterlines
 *
 * The same for surfaces without flat ends: from the first of the given points to each of the others. A point stands for
 * the largest inscribed sphere that touches the surface where it is nearest to the point; the lines end at the centres
 * of these spheres.
 *
 * \param surface a closed triangle mesh, turned outwards; all of it is wall
 * \param ends two points or more, the source first
 * \param graph is replaced; its root is at the source
 * \param np the named parameters, as above
 */
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
void compute_centerlines(const TriangleMesh& surface, const std::vector<Point_3>& ends, Centerline_graph& graph,
                         const NamedParameters& np = CGAL::parameters::default_values()) {
  const internal::Core_surface<TriangleMesh, NamedParameters> core(surface, np);
  internal::compute_centerlines(*core, ends, graph, Compute_centerlines_options(np));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Centerlines/compute_centerlines_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_COMPUTE_CENTERLINES_H
