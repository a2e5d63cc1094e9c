// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_TUBULAR_MODEL_H
#define CGAL_TUBULAR_MESHING_PIPELINES_TUBULAR_MODEL_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Openings/Round_end_report.h>
#include <CGAL/Tubular_meshing/Openings/labelled_ends.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Labelled_surface.h>
#include <CGAL/Tubular_meshing/base/Opening.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPipelines
 *
 * A vessel or airway tree, ready to be meshed: its surface closed and labelled, its branches with their radii, its
 * openings. Every kind of mesh starts from one; make_tubular_model() prepares it.
 */
struct Tubular_model : Labelled_surface {   ///< the surface is closed and turned outward
  Centerline_graph centerlines;             ///< directed away from the inlet
  std::vector<Opening> openings;            ///< the inlet first
  std::vector<Round_end_report> round_ends; ///< that were cut open, see cut_round_ends(), or not
  Label_names patch_names; ///< of wall and openings, as meshes get them; empty: wall, inlet, outlet_1, …
  Patch_ids patch_ids;     ///< where the input has numbers for them
  Labelled_ends labels;    ///< what was made of the input's labels; empty: it had none
};

/*! \ingroup PkgTubularMeshingPipelines
 * The names of a model's patches, also of one that has no names of its own. */
inline Label_names patch_names(const Tubular_model& model) {
  return model.patch_names.empty() ? lumen_patch_names(int(model.openings.size())) : model.patch_names;
}

/*! \ingroup PkgTubularMeshingPipelines
 * What make_tubular_model() can be told; each member is the named parameter of that name. */
struct Tubular_model_options {
  std::optional<Point_3> inlet; ///< the nearest opening is the inlet
  std::vector<Point_3> seeds;   ///< ends of vessels; one that is closed and round is cut open. The first is the inlet
  std::vector<Point_3> blind_ends; ///< round or capped ends that stay closed, see cut_round_ends(), find_openings()
  bool single_opening = false;     ///< whether a surface with one opening will do
  bool blind_vessels = true;       ///< whether lines lead into vessels that end blind
  bool loops = true;               ///< whether vessels that split and rejoin keep all their branches
  double merge_tolerance = 0.1;    ///< see build_centerline_graph()
  int number_of_threads = 0;       ///< for centerlines that are computed, see compute_centerlines()
  Labelled_ends labelled_ends;     ///< of a surface that open_labelled_ends() has opened

  Tubular_model_options() = default;
  template <class NamedParameters> explicit Tubular_model_options(const NamedParameters& np) {
    using internal::choose;
    inlet = internal::optional_point(np, internal_np::inlet);
    seeds = choose(np, internal_np::seeds, seeds);
    blind_ends = choose(np, internal_np::blind_ends, blind_ends);
    single_opening = choose(np, internal_np::single_opening, single_opening);
    blind_vessels = choose(np, internal_np::blind_vessels, blind_vessels);
    loops = choose(np, internal_np::loops, loops);
    merge_tolerance = choose(np, internal_np::merge_tolerance, merge_tolerance);
    number_of_threads = choose(np, internal_np::number_of_threads, number_of_threads);
    labelled_ends = choose(np, internal_np::labelled_ends, labelled_ends);
  }
};

namespace internal {

/* Of a model that has its surface, and nothing else yet. */
void prepare(Tubular_model& model, const Centerline_polylines& lines, const Tubular_model_options& options);
void prepare(Tubular_model& model, const Tubular_model_options& options);
/* Without centerlines, for a Sampled_estimator; that the surface crosses itself is not looked for. */
void prepare_without_centerlines(Tubular_model& model, const Tubular_model_options& options);

/* Opens a copy of a caller's surface at the ends that the caller's labels mark, if there are labels. */
template <class FaceGraph, class NamedParameters>
void open_labelled_ends(const FaceGraph& surface, Tubular_model& model, Tubular_model_options& options,
                        const NamedParameters& np) {
  typedef std::decay_t<decltype(CGAL::parameters::get_parameter(np, internal_np::face_label_map))> Label_map;
  if constexpr (!std::is_same<Label_map, CGAL::internal_np::Param_not_found>::value) {
    const Label_map label_map = CGAL::parameters::get_parameter(np, internal_np::face_label_map);
    Face_patch_map label = model.surface.template add_property_map<Surface::Face_index, int>("f:input_label", 0).first;
    auto f = model.surface.faces().begin();
    for (auto caller : faces(surface))
      label[*f++] = int(get(label_map, caller));
    options.labelled_ends = open_labelled_ends(model.surface, label, Labelled_ends_options(np));
    model.surface.remove_property_map(label);
  }
}

/* A model of a copy of a caller's surface, by prepare(model, options). */
template <class FaceGraph, class NamedParameters, class Prepare>
Tubular_model prepared_model(const FaceGraph& surface, const NamedParameters& np, const Prepare& prepare) {
  Tubular_model model;
  Tubular_model_options options(np);
  copy_face_graph(*Core_surface<FaceGraph, NamedParameters>(surface, np), model.surface);
  open_labelled_ends(surface, model, options, np);
  prepare(model, options);
  return model;
}

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
 *     \cgalParamDefault{the end that a label calls so, else the opening at the lines' common start, else the largest}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{merge_tolerance}
 *     \cgalParamDescription{see build_centerline_graph()}
 *     \cgalParamType{double}
 *     \cgalParamDefault{0.1}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_label_map}
 *     \cgalParamDescription{labels of the surface's faces, which mark and name its ends: see open_labelled_ends(), whose
 *       parameters `label_names`, `wall_label`, `inlet_name` and `label_source` count with it}
 *     \cgalParamType{a model of `ReadablePropertyMap` from faces to `int`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{labelled_ends}
 *     \cgalParamDescription{the ends that have names, of a surface that open_labelled_ends() has opened already}
 *     \cgalParamType{Labelled_ends}
 *     \cgalParamDefault{none}
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
  return internal::prepared_model(surface, np,
                                  [&](auto& model, const auto& options) { internal::prepare(model, lines, options); });
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
 *     \cgalParamDefault{the first seed's, else the end that a label calls so, else the largest}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{seeds}
 *     \cgalParamDescription{where vessels end: the first is at the inlet. A round end there is cut open, see
 *       cut_round_ends()}
 *     \cgalParamType{`std::vector<Point_3>`}
 *     \cgalParamDefault{none; where the surface is closed and has no flat caps, all round ends are cut open}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{blind_ends}
 *     \cgalParamDescription{points: round or capped ends that stay closed, see cut_round_ends() and find_openings()}
 *     \cgalParamType{`std::vector<Point_3>`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{single_opening}
 *     \cgalParamDescription{whether a surface with one opening will do: its lines lead from there to the tips of vessels}
 *     \cgalParamType{bool}
 *     \cgalParamDefault{`false`}
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
 *   \cgalParamNBegin{number_of_threads}
 *     \cgalParamDescription{see compute_centerlines()}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{0}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_label_map}
 *     \cgalParamDescription{labels of the surface's faces, which mark and name its ends: see open_labelled_ends(), whose
 *       parameters `label_names`, `wall_label`, `inlet_name` and `label_source` count with it}
 *     \cgalParamType{a model of `ReadablePropertyMap` from faces to `int`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{labelled_ends}
 *     \cgalParamDescription{the ends that have names, of a surface that open_labelled_ends() has opened already}
 *     \cgalParamType{Labelled_ends}
 *     \cgalParamDefault{none}
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
  return internal::prepared_model(surface, np,
                                  [](auto& model, const auto& options) { internal::prepare(model, options); });
}

/*! \ingroup PkgTubularMeshingPipelines
 *
 * the same without centerlines, with which it can be meshed no more: for a Sampled_estimator. It takes a tenth of the
 * time. That the surface crosses itself is not looked for.
 *
 * \throws Input_error if the surface is in pieces, or has fewer than two ends
 */
template <class FaceGraph, class NamedParameters = CGAL::parameters::Default_named_parameters>
Tubular_model make_model_without_centerlines(const FaceGraph& surface,
                                             const NamedParameters& np = CGAL::parameters::default_values()) {
  return internal::prepared_model(
      surface, np, [](auto& model, const auto& options) { internal::prepare_without_centerlines(model, options); });
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_PIPELINES_TUBULAR_MODEL_H
