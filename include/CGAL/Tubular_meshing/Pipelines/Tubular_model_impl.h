// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_TUBULAR_MODEL_IMPL_H
#define CGAL_TUBULAR_MESHING_PIPELINES_TUBULAR_MODEL_IMPL_H

#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Centerlines/build_centerline_graph.h>
#include <CGAL/Tubular_meshing/Centerlines/check_centerlines.h>
#include <CGAL/Tubular_meshing/Centerlines/clip_to_openings.h>
#include <CGAL/Tubular_meshing/Centerlines/compute_centerlines.h>
#include <CGAL/Tubular_meshing/Openings/close_openings.h>
#include <CGAL/Tubular_meshing/Openings/cut_round_ends.h>
#include <CGAL/Tubular_meshing/Openings/labelled_ends.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/Openings/seeds.h>
#include <CGAL/Tubular_meshing/Patches/follow_blind_vessels.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/check_meshable.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

// Gives the openings their branches.
inline void connect(Tubular_model& model, const std::vector<std::size_t>& node_of_opening) {
  for (std::size_t i = 0; i < node_of_opening.size(); ++i) {
    const std::size_t node = node_of_opening[i];
    model.openings[i].node = node;
    model.openings[i].branch = node == Opening::no_branch ? node : model.centerlines.nodes()[node].branches.front();
  }
}

inline Find_openings_options opening_options(const Tubular_model_options& options, const Centerline_graph* graph) {
  Find_openings_options result;
  result.inlet = options.inlet;
  if (!result.inlet && options.labelled_ends.inlet != Labelled_ends::none)
    result.inlet = options.labelled_ends.ends[options.labelled_ends.inlet].center;
  result.blind_ends = options.blind_ends;
  result.centerline_graph = graph;
  return result;
}

// The names of the patches, and the numbers that they had.
inline void name_patches(Tubular_model& model, const Labelled_ends& ends) {
  if (ends.empty())
    return;
  model.labels = ends;
  name_openings(model.openings, ends);
  model.patch_names = lumen_patch_names(int(model.openings.size()));
  std::set<std::string> used;
  for (const Opening& o : model.openings)
    if (!o.name.empty())
      used.insert(model.patch_names[o.patch] = o.name);
  for (const Opening& o : model.openings)
    if (o.name.empty())
      used.insert(model.patch_names[o.patch] = unused_name(model.patch_names[o.patch], used));
  std::string& wall = model.patch_names[labels::wall];
  wall = unused_name(ends.wall_name.empty() ? wall : ends.wall_name, used);
  model.patch_ids.array = ends.array;
  if (ends.wall)
    model.patch_ids.id[labels::wall] = *ends.wall;
  const std::vector<std::size_t> end_of = ends.match(model.openings);
  for (std::size_t i = 0; i < end_of.size(); ++i)
    if (end_of[i] != Labelled_ends::none)
      model.patch_ids.id[model.openings[i].patch] = ends.ends[end_of[i]].label;
}

inline Build_centerline_graph_options graph_options(const Tubular_model_options& options) {
  Build_centerline_graph_options result;
  result.merge_tolerance = options.merge_tolerance;
  return result;
}

// What the rest of the package relies on: one piece of triangles.
inline void check_surface(Tubular_model& model) {
  check_tubular_surface(model.surface);
  check_one_piece(model.surface);
}

CGAL_TUBULAR_MESHING_INLINE void prepare(Tubular_model& model, const Centerline_polylines& lines,
                                         const Tubular_model_options& options) {
  check_surface(model);
  build_centerline_graph(lines, Wall_distance(model.surface), model.centerlines, graph_options(options));

  model.openings = find_openings(model.surface, opening_options(options, &model.centerlines));
  name_patches(model, options.labelled_ends);
  close_openings(model.surface, model.openings, model.patch);
  check_no_crossings(model.surface);
  const std::vector<std::size_t> nodes = clip_to_openings(model.centerlines, model.openings);
  check_centerlines_inside(model.centerlines, model.surface);

  const Wall_distance wall(model.surface, model.patch, labels::wall);
  std::vector<double> radii;
  for (const Point_3& p : model.centerlines.points())
    radii.push_back(wall(p));
  model.centerlines.set_radii(std::move(radii));
  if (nodes.front() != Opening::no_branch)
    model.centerlines.direct_from(nodes.front());
  connect(model, nodes);
}

// A surface that is closed, with its openings, and where lines are to lead to.
inline std::vector<std::pair<Point_3, int>> close(Tubular_model& model, const Tubular_model_options& options) {
  check_surface(model);
  std::optional<std::vector<Opening>> known;
  model.round_ends = open_round_ends(model.surface, options.seeds, options.blind_ends, known);
  const Find_openings_options finding = opening_options(options, nullptr);
  model.openings = known ? std::move(*known) : find_unordered_openings(model.surface, finding);
  order_openings_or_seeds(model.openings, options.seeds, finding);
  name_patches(model, options.labelled_ends);
  close_openings(model.surface, model.openings, model.patch);
  return ends_of_lines(model.openings, {}, options.single_opening);
}

CGAL_TUBULAR_MESHING_INLINE void prepare_without_centerlines(Tubular_model& model,
                                                             const Tubular_model_options& options) {
  close(model, options);
}

CGAL_TUBULAR_MESHING_INLINE void prepare(Tubular_model& model, const Tubular_model_options& options) {
  std::vector<std::pair<Point_3, int>> ends = close(model, options);
  const Build_centerline_graph_options merging = graph_options(options);
  if (ends.size() == 1)
    ends.emplace_back(farthest_point(model.surface, model.patch, ends.front().second), int(labels::wall));
  bool is_checked = false;
  const auto check = [&] {
    check_no_crossings(model.surface);
    is_checked = true;
  };
  std::unique_ptr<Centerline_computation> lines;
  try {
    lines = std::make_unique<Centerline_computation>(model.surface, model.patch, ends, options.loops,
                                                     options.blind_vessels, options.number_of_threads, check);
  } catch (const Input_error&) {
    if (!is_checked)
      check(); // that the surface crosses itself explains what else is wrong
    throw;
  }
  Centerline_computation& computation = *lines;
  computation.make_graph(model.centerlines, merging);
  if (options.blind_vessels)
    follow_blind_vessels(model.surface, model.patch, computation, model.centerlines, merging);
  connect(model, nodes_at(model.centerlines, model.openings));
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PIPELINES_TUBULAR_MODEL_IMPL_H
