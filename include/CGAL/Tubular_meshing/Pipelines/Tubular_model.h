// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_TUBULAR_MODEL_H
#define CGAL_TUBULAR_MESHING_PIPELINES_TUBULAR_MODEL_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Labelled_surface.h>
#include <CGAL/Tubular_meshing/base/Opening.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPipelines
 *
 * A vessel or airway tree, ready to be meshed: its surface closed and labelled, its branches with their radii, its
 * openings. Every kind of mesh starts from one; make_tubular_model() prepares it.
 */
struct Tubular_model : Labelled_surface { ///< the surface is closed and turned outward
  Centerline_graph centerlines;           ///< directed away from the inlet
  std::vector<Opening> openings;          ///< the inlet first
};

/*! \ingroup PkgTubularMeshingPipelines
 * What make_tubular_model() can be told; each member is the named parameter of that name. */
struct Tubular_model_options {
  std::optional<Point_3> inlet; ///< the nearest opening is the inlet
  std::vector<Point_3> seeds;   ///< where vessels end without an opening or a flat cap; the lines begin at the first
  bool blind_vessels = true;    ///< whether lines lead into vessels that end blind
  bool loops = true;            ///< whether vessels that split and rejoin keep all their branches
  double merge_tolerance = 0.1; ///< see build_centerline_graph()

  Tubular_model_options() = default;
  template <class NamedParameters> explicit Tubular_model_options(const NamedParameters& np) {
    using internal::choose;
    inlet = internal::optional_point(np, internal_np::inlet);
    seeds = choose(np, internal_np::seeds, seeds);
    blind_vessels = choose(np, internal_np::blind_vessels, blind_vessels);
    loops = choose(np, internal_np::loops, loops);
    merge_tolerance = choose(np, internal_np::merge_tolerance, merge_tolerance);
  }
};

namespace internal {

/* Of a model that has its surface, and nothing else yet. */
void prepare(Tubular_model& model, const Centerline_polylines& lines, const Tubular_model_options& options);
void prepare(Tubular_model& model, const Tubular_model_options& options);

} // namespace internal

/*! \ingroup PkgTubularMeshingPipelines
 *
 * prepares a surface and its centerlines for meshing: merges the lines into branches, finds the openings, closes them,
 * measures the local radii, and brings the branches' ends to the caps' centres.
 *
 * \tparam FaceGraph a model of `FaceListGraph`, over any kernel
 *
 * \param surface the tree's surface, open at its ends or closed by flat caps; see repair_surface() for one that is not
 *   clean
 * \param lines its centerlines, as read by IO::read_centerlines()
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{inlet}
 *     \cgalParamDescription{the nearest opening to this point is the inlet}
 *     \cgalParamType{`Point_3`}
 *     \cgalParamDefault{the opening at the lines' common start, else the largest}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{merge_tolerance}
 *     \cgalParamDescription{see build_centerline_graph()}
 *     \cgalParamType{double}
 *     \cgalParamDefault{0.1}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the surface's vertices}
 *     \cgalParamType{a model of `ReadablePropertyMap`}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, surface)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * O(n log n) in the sizes of surface and lines.
 *
 * \throws Input_error if the surface is in pieces or intersects itself, if the surface or the lines cannot be used, or
 *   if they do not belong together
 */
template <class FaceGraph, class NamedParameters = CGAL::parameters::Default_named_parameters>
Tubular_model make_tubular_model(const FaceGraph& surface, const Centerline_polylines& lines,
                                 const NamedParameters& np = CGAL::parameters::default_values()) {
  Tubular_model model;
  copy_face_graph(*internal::Core_surface<FaceGraph, NamedParameters>(surface, np), model.surface);
  internal::prepare(model, lines, Tubular_model_options(np));
  return model;
}

/*! \ingroup PkgTubularMeshingPipelines
 *
 * the same for a surface alone: its centerlines are computed, by compute_centerlines(), from the inlet to each outlet,
 * and to the tips of vessels that end blind.
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{inlet}
 *     \cgalParamDescription{the nearest opening to this point is the inlet}
 *     \cgalParamType{`Point_3`}
 *     \cgalParamDefault{the first seed's, else the largest}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{seeds}
 *     \cgalParamDescription{where vessels end without an opening or a flat cap; the lines begin at the first. One that
 *       lies at an opening stands for the opening}
 *     \cgalParamType{`std::vector<Point_3>`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{blind_vessels}
 *     \cgalParamDescription{whether lines lead into vessels that end without an opening, and are at least one and a
 *       half times longer than wide}
 *     \cgalParamType{bool}
 *     \cgalParamDefault{`true`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{loops}
 *     \cgalParamDescription{see compute_centerlines()}
 *     \cgalParamType{bool}
 *     \cgalParamDefault{`true`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{merge_tolerance}
 *     \cgalParamDescription{see build_centerline_graph()}
 *     \cgalParamType{double}
 *     \cgalParamDefault{0.1}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the surface's vertices}
 *     \cgalParamType{a model of `ReadablePropertyMap`}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, surface)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Input_error if the surface is in pieces or intersects itself, or has fewer than two ends
 */
template <class FaceGraph, class NamedParameters = CGAL::parameters::Default_named_parameters>
Tubular_model make_tubular_model(const FaceGraph& surface,
                                 const NamedParameters& np = CGAL::parameters::default_values()) {
  Tubular_model model;
  copy_face_graph(*internal::Core_surface<FaceGraph, NamedParameters>(surface, np), model.surface);
  internal::prepare(model, Tubular_model_options(np));
  return model;
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_PIPELINES_TUBULAR_MODEL_H
