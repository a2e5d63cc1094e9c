// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Run_report.h"

#include "Stage_clock.h"

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Partition/partition_report.h>
#include <CGAL/Tubular_meshing/Patches/metric_surface_report.h>
#include <CGAL/Tubular_meshing/Quality/boundary_layer_report.h>
#include <CGAL/Tubular_meshing/Quality/branch_resolution.h>
#include <CGAL/Tubular_meshing/Quality/lumen_measures.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/Quadratic/quadratic_quality.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <string>
#include <vector>

namespace tubular = CGAL::Tubular_meshing;
typedef nlohmann::ordered_json Json;

namespace {

Json statistics(const tubular::Measure_statistics& s) {
  return {{"count", s.count()},    {"min", s.min()},        {"mean", s.mean()},        {"max", s.max()},
          {"p1", s.percentile(1)}, {"p5", s.percentile(5)}, {"p50", s.percentile(50)}, {"histogram", s.histogram()}};
}

// Of a measure that is large where it is bad, and has no bound; a cell that is flat has none at all.
Json statistics_of_excess(const tubular::Measure_statistics& s) {
  const auto number = [](double x) { return std::isfinite(x) ? Json(x) : Json(); };
  return {{"count", s.count()},
          {"min", number(s.min())},
          {"mean", number(s.mean())},
          {"max", number(s.max())},
          {"p50", number(s.percentile(50))},
          {"p95", number(s.percentile(95))},
          {"p99", number(s.percentile(99))}};
}

template <class Point> Json vector_of(const Point& p) {
  return {p.x(), p.y(), p.z()};
}

Json repairs(const tubular::Repair_report& report) {
  Json list = Json::array();
  for (const auto& r : report.repairs) {
    Json entry = {{"defect", tubular::name_of(r.defect)}, {"count", r.count}, {"size", r.size}};
    entry["place"] = r.has_place ? vector_of(r.place) : Json();
    entry["sentence"] = r.sentence;
    list.push_back(entry);
  }
  return list;
}

// What became of the labels of the input.
Json labels(const tubular::Labelled_ends& ends) {
  Json list = Json::array();
  for (const auto& l : ends.labels)
    list.push_back({{"label", l.label},
                    {"name", l.name.empty() ? Json() : Json(l.name)},
                    {"meaning", l.count > 0 ? "opening" : "wall"},
                    {"openings", l.count},
                    {"understood", l.is_understood()},
                    {"reason", l.is_understood() ? Json() : Json(l.reason)}});
  return {{"source", ends.source}, {"labels", list}};
}

double area_of(const tubular::Lumen_measures& measures, int patch) {
  const auto found = measures.opening_area.find(patch);
  return found == measures.opening_area.end() ? 0 : found->second;
}

Json openings(const tubular::Tubular_model& model, const tubular::Mixed_mesh& mesh,
              const tubular::Lumen_measures& measures) {
  std::map<int, std::size_t> triangles, quads;
  for (int label : mesh.triangles.label)
    ++triangles[label];
  for (int label : mesh.quads.label)
    ++quads[label];
  Json list = Json::array();
  for (const auto& o : model.openings) {
    Json entry = {{"name", mesh.patch_names.at(o.patch)},
                  {"patch", o.patch},
                  {"center", vector_of(o.center)},
                  {"normal", vector_of(o.normal)},
                  {"area", o.area},
                  {"mesh_area", area_of(measures, o.patch)},
                  {"perimeter", o.perimeter},
                  {"radius", o.radius},
                  {"triangles", triangles[o.patch]},
                  {"quads", quads[o.patch]}};
    entry["branch"] = o.branch == tubular::Opening::no_branch ? Json() : Json(o.branch);
    const auto id = model.patch_ids.id.find(o.patch);
    if (!model.patch_ids.empty() && id != model.patch_ids.id.end())
      entry["label"] = id->second;
    list.push_back(entry);
  }
  return list;
}

Json branches(const tubular::Tubular_model& model, const tubular::Mixed_mesh& mesh) {
  const auto& graph = model.centerlines;
  const std::vector<double> points =
      tubular::points_per_circumference(mesh, tubular::Centerline_field(graph), graph.branches().size());
  Json list = Json::array();
  for (std::size_t b = 0; b < graph.branches().size(); ++b) {
    const auto& branch = graph.branches()[b];
    list.push_back({{"length", branch.length},
                    {"min_radius", branch.min_radius},
                    {"max_radius", branch.max_radius},
                    {"points_per_circumference", points[b]},
                    {"parents", branch.parents},
                    {"children", branch.children}});
  }
  return list;
}

// Of the measures of elements that are not always there, those of elements that are.
Json qualities(const tubular::Quality_report& quality) {
  Json q = {{"gamma_tau", statistics(quality.gamma_tau)}, {"gamma_T", statistics(quality.gamma_T)}};
  const auto add = [&](const char* name, const tubular::Measure_statistics& s) {
    if (s.count() > 0)
      q[name] = statistics(s);
  };
  add("eta_q", quality.eta_q);
  add("zeta_H", quality.zeta_H);
  add("scaled_jacobian", quality.scaled_jacobian);
  if (quality.aspect.count() > 0) {
    q["aspect"] = statistics_of_excess(quality.aspect);
    q["non_orthogonality"] = statistics_of_excess(quality.non_orthogonality);
    q["skewness"] = statistics_of_excess(quality.skewness);
  }
  return q;
}

// Whether the centerlines were to keep all branches where vessels rejoin, or have them.
bool keeps_loops(const Run& run) {
  const tubular::Centerline_graph& graph = run.model.centerlines;
  return run.options.loops ||
         (run.options.centerlines.empty() && !run.options.no_loops && graph.branches().size() >= graph.nodes().size());
}

// That of the surface that was meshed, and of the mesh's lumen; how the latter came to it.
Json volumes(const Run& run, const tubular::Lumen_measures& measures) {
  const double input = CGAL::to_double(CGAL::Polygon_mesh_processing::volume(run.model.surface));
  return {{"input", input},
          {"mesh", measures.volume},
          {"relative_difference", input > 0 ? measures.volume / input - 1 : 0},
          {"preserved", run.options.preserve_volume && !run.options.is_quadratic()},
          {"before", run.meshing.volume.volume_before > 0 ? Json(run.meshing.volume.volume_before) : Json()},
          {"largest_shift", run.meshing.volume.largest_shift},
          {"vertices_held_back", run.meshing.volume.held_back}};
}

Json description_of(const Run& run) {
  const tubular::Mixed_mesh& mesh = run.cells();
  tubular::Validity_report validity = tubular::validity_report(mesh);
  if (run.options.is_quadratic()) // whose cells are judged as they are curved
    validity.inverted_cells = 0;
  if (!run.options.material_array.empty()) // which may be in several places, and part the wall
    validity.region_components.erase(validity.region_components.lower_bound(tubular::labels::wall_region),
                                     validity.region_components.end());
  const tubular::Quality_report quality = tubular::quality_report(mesh);
  const std::size_t openings_of_all = run.model.openings.size();
  const tubular::Lumen_measures measures = run.options.is_quadratic()
                                               ? tubular::lumen_measures(run.quadratic, openings_of_all)
                                               : tubular::lumen_measures(mesh, openings_of_all);
  return {{"program", std::string("tubular_mesh ") + run.version},
          {"input", run.options.surface},
          {"centerlines", run.options.centerlines.empty() ? Json() : Json(run.options.centerlines)},
          {"loops", keeps_loops(run)},
          {"repairs", repairs(run.repairs)},
          {"flow_extensions", run.extensions.lengths},
          {"output", run.options.output},
          {"type", run.options.type},
          {"points_per_circumference", run.options.points_per_circumference},
          {"fallbacks", run.meshing.fallbacks},
          {"order", run.options.order},
          {"points", run.options.is_quadratic() ? run.quadratic.number_of_nodes() : mesh.points.size()},
          {"cells",
           {{"tetrahedra", mesh.tetrahedra.size()},
            {"pyramids", mesh.pyramids.size()},
            {"prisms", mesh.prisms.size()},
            {"hexahedra", mesh.hexahedra.size()}}},
          {"facets", {{"triangles", mesh.triangles.size()}, {"quads", mesh.quads.size()}}},
          {"valid", validity.is_valid_in((std::max)(run.openings_of_parts.size(), std::size_t(1)))},
          {"boundary_euler", validity.boundary_euler},
          {"quality", qualities(quality)},
          {"volume", volumes(run, measures)},
          {"openings", openings(run.model, mesh, measures)},
          {"branches", branches(run.model, mesh)}};
}

// Of elements of the second order.
void add_quadratic(Json& report, const Run& run) {
  const tubular::Quadratic_quality_report quality = tubular::quality_report(run.quadratic, run.options.threads);
  const tubular::Quadratic_report& r = run.curving;
  Json q = {{"complete", run.options.complete_elements},
            {"corners", run.quadratic.linear.points.size()},
            {"curved_edges", r.curved_edges},
            {"largest_bend", r.largest_bend},
            {"largest_shift", r.largest_shift},
            {"relaxed", r.relaxed},
            {"straightened", r.straightened},
            {"corners_held_back", r.corners_held_back},
            {"nodes_not_found", r.not_found},
            {"invalid", quality.invalid},
            {"unproved", quality.unproved},
            {"sentence", r.text()}};
  const auto add = [&](const char* name, const tubular::Measure_statistics& s) {
    if (s.count() > 0)
      q["scaled_jacobian"][name] = statistics(s);
  };
  add("cells", quality.scaled_jacobian);
  add("tetrahedra", quality.tetrahedra);
  add("pyramids", quality.pyramids);
  add("prisms", quality.prisms);
  add("hexahedra", quality.hexahedra);
  report["quadratic"] = q;
  report["valid"] = report["valid"].get<bool>() && quality.is_valid();
}

void print_quadratic(const Json& q) {
  std::printf("\n%-22s %8s %8s %8s\n", "whole cells, Jacobian", "min", "1 %", "mean");
  for (const auto& kind : q["scaled_jacobian"].items())
    if (kind.key() != "cells")
      std::printf("%-22s %8.3g %8.3f %8.3f\n", kind.key().c_str(), kind.value()["min"].get<double>(),
                  kind.value()["p1"].get<double>(), kind.value()["mean"].get<double>());
  std::printf("order 2: %s\n", q["sentence"].get<std::string>().c_str());
}

// The round ends of vessels, cut open or not.
void add_round_ends(Json& report, const std::vector<tubular::Round_end_report>& ends) {
  Json list = Json::array();
  for (const auto& end : ends)
    list.push_back({{"cut", end.is_cut},
                    {"center", vector_of(end.center)},
                    {"radius", end.radius},
                    {"reason", end.is_cut ? Json() : Json(end.reason)}});
  report["round_ends"] = list;
}

void print_round_ends(const Json& ends) {
  long cut = 0;
  for (const auto& end : ends)
    cut += end["cut"].get<bool>();
  if (cut > 0)
    std::printf("ends: %ld round %s cut open, by planes across the vessels\n", cut, cut == 1 ? "end was" : "ends were");
  for (const auto& end : ends)
    if (!end["cut"].get<bool>())
      std::printf("note: the round end at (%g, %g, %g), of radius %g, stays closed (%s); --outlet opens it\n",
                  end["center"][0].get<double>(), end["center"][1].get<double>(), end["center"][2].get<double>(),
                  end["radius"].get<double>(), end["reason"].get<std::string>().c_str());
  std::printf("\n");
}

// How the surface was cut, and its patches were mapped.
void add_patches(Json& report, const tubular::Remeshed_surface& surface) {
  const tubular::Patch_report& r = surface.report;
  const auto number = [&](tubular::Patch_kind kind) {
    const auto found = r.kinds.find(kind);
    return found == r.kinds.end() ? std::size_t(0) : found->second;
  };
  Json methods = Json::object();
  for (const auto& m : r.methods)
    methods[tubular::name_of(m.first)] = m.second;
  report["patches"] = {{"count", r.number_of_patches()},
                       {"annular", number(tubular::Patch_kind::annular)},
                       {"junctions", number(tubular::Patch_kind::junction)},
                       {"disks", number(tubular::Patch_kind::disk)},
                       {"largest_aspect_ratio", r.largest_aspect_ratio},
                       {"moved_cuts", r.moved_cuts},
                       {"methods", methods},
                       {"fallbacks", r.number_of_fallbacks()},
                       {"refined", r.refined_patches},
                       {"problems", r.problems}};
  if (r.handle_cuts > 0)
    report["patches"]["handle_cuts"] = r.handle_cuts;
  if (r.smoothed_places > 0)
    report["patches"]["smoothed_places"] = r.smoothed_places;
}

// How hexahedra were made, and where not in blocks.
void add_hexahedral(Json& report, const tubular::Hexahedral_report& h) {
  Json places = Json::array();
  for (const auto& p : h.places_without_blocks)
    places.push_back(
        {{"place", vector_of(p.place)}, {"reason", p.reason}, {"pyramids", p.pyramids}, {"tetrahedra", p.tetrahedra}});
  report["hexahedral"] = {{"method", tubular::name_of(h.method)},
                          {"junctions", h.number_of_junctions},
                          {"places_without_blocks", places},
                          {"blocks", h.number_of_blocks},
                          {"points_per_circumference", h.points_per_circumference},
                          {"irregular_edges", h.irregular_edges},
                          {"twist", h.twist},
                          {"boundary",
                           {{"largest_shift", h.boundary.largest_shift},
                            {"vertices_not_found", h.boundary.not_found},
                            {"vertices_held_back", h.boundary.held_back}}},
                          {"optimization",
                           {{"min_scaled_jacobian_before", h.optimization.min_scaled_jacobian_before},
                            {"min_scaled_jacobian", h.optimization.min_scaled_jacobian},
                            {"mean_scaled_jacobian_before", h.optimization.mean_scaled_jacobian_before},
                            {"mean_scaled_jacobian", h.optimization.mean_scaled_jacobian},
                            {"inverted_before", h.optimization.inverted_before},
                            {"inverted", h.optimization.inverted},
                            {"vertices_left_off_surface", h.optimization.held_vertices}}}};
}

void print_hexahedral(const Json& h) {
  const bool has_blocks = h["method"] == "blocks";
  if (has_blocks)
    std::printf("%ld blocks of hexahedra, %ld points round each vessel, %ld junctions; %ld irregular edges inside\n",
                h["blocks"].get<long>(), h["points_per_circumference"].get<long>(), h["junctions"].get<long>(),
                h["irregular_edges"].get<long>());
  else
    std::printf("hexahedra by subdivision of tetrahedra and prisms\n");
  const Json& o = h["optimization"];
  std::printf("optimized, scaled Jacobian: %.3f at least, %.3f on average; before, %.3f and %.3f\n",
              o["min_scaled_jacobian"].get<double>(), o["mean_scaled_jacobian"].get<double>(),
              o["min_scaled_jacobian_before"].get<double>(), o["mean_scaled_jacobian_before"].get<double>());
  if (const long held = o["vertices_left_off_surface"].get<long>())
    std::printf(
        "note: %ld vertices of the boundary stay a little off the surface: on it, hexahedra would be inverted\n", held);
  for (const auto& p : h["places_without_blocks"]) {
    std::printf("note: no blocks near (%g, %g, %g): %s", p["place"][0].get<double>(), p["place"][1].get<double>(),
                p["place"][2].get<double>(), p["reason"].get<std::string>().c_str());
    const long pyramids = p["pyramids"].get<long>(), tetrahedra = p["tetrahedra"].get<long>();
    if (has_blocks && pyramids + tetrahedra > 0)
      std::printf("; %ld pyramids and %ld tetrahedra there", pyramids, tetrahedra);
    else if (has_blocks)
      std::printf("; filled together with the place before");
    std::printf("\n");
  }
  const long off = h["boundary"]["vertices_not_found"].get<long>() + h["boundary"]["vertices_held_back"].get<long>();
  if (off > 0)
    std::printf("note: %ld vertices could not go all of the way to the surface; cells would have turned over, or the "
                "wall met itself\n",
                off);
}

// Of a mesh that is written in parts.
void add_partitions(Json& report, const tubular::Partition_report& p) {
  report["partitions"] = {{"count", p.number_of_parts()}, {"cells", p.cells},   {"imbalance", p.imbalance},
                          {"cut_faces", p.cut_faces},     {"pieces", p.pieces}, {"ghost_cells", p.ghost_cells}};
}

void print_partitions(const Json& p) {
  const auto cells = p["cells"].get<std::vector<long>>(), ghosts = p["ghost_cells"].get<std::vector<long>>();
  const auto pieces = p["pieces"].get<std::vector<long>>();
  const auto range = std::minmax_element(cells.begin(), cells.end());
  if (cells.size() == 1) {
    std::printf("\nwritten in 1 part, of %ld cells\n", cells[0]);
    return;
  }
  std::printf("\nwritten in %zu parts of %ld to %ld cells, the largest %.2f %% over its share; %ld faces between "
              "parts, %ld ghost "
              "cells\n",
              cells.size(), *range.first, *range.second, 100 * p["imbalance"].get<double>(), p["cut_faces"].get<long>(),
              std::accumulate(ghosts.begin(), ghosts.end(), 0l));
  const auto split = std::count_if(pieces.begin(), pieces.end(), [](long n) { return n > 1; });
  if (split > 0)
    std::printf("note: %ld of the parts %s not connected through faces\n", long(split), split > 1 ? "are" : "is");
}

// Of a surface of quads.
void add_quads(Json& report, const tubular::Quad_report& quads) {
  report["quads"] = {{"structured", quads.structured_quads},
                     {"unstructured", quads.unstructured_quads},
                     {"irregular_vertices", quads.irregular_vertices},
                     {"annular_patches_without_grid", quads.annular_patches_without_grid},
                     {"folded", quads.folded_quads}};
}

// Of a surface alone, the validity is its own.
void describe_surface(Json& report, const tubular::Remeshed_surface& surface) {
  const auto& mesh = surface.surface;
  report["valid"] = CGAL::is_closed(mesh) && mesh.is_valid();
  report["boundary_euler"] =
      long(mesh.number_of_vertices()) - long(mesh.number_of_edges()) + long(mesh.number_of_faces());
}

void print_quads(const Json& q) {
  std::printf("%ld quads in grids, %ld unstructured; %ld irregular vertices\n", q["structured"].get<long>(),
              q["unstructured"].get<long>(), q["irregular_vertices"].get<long>());
}

void print_patches(const Json& p) {
  std::printf("\n%ld patches: %ld annular, %ld junctions, %ld disks; aspect ratio at most %.2f\n",
              p["count"].get<long>(), p["annular"].get<long>(), p["junctions"].get<long>(), p["disks"].get<long>(),
              p["largest_aspect_ratio"].get<double>());
  std::printf("%ld not mapped conformally, %ld meshed finer than asked for\n", p["fallbacks"].get<long>(),
              p["refined"].get<long>());
  if (p.contains("smoothed_places"))
    std::printf("%ld places where triangles met each other at any size, and were smoothed\n",
                p["smoothed_places"].get<long>());
  if (p.contains("handle_cuts"))
    std::printf("%ld cuts round handles of the wall\n", p["handle_cuts"].get<long>());
  for (const auto& problem : p["problems"])
    std::printf("note: %s\n", problem.get<std::string>().c_str());
}

// Where layers had to give way.
void add_layers(Json& report, const char* name, const tubular::Layer_report& layers) {
  report[name] = {{"vertices", layers.vertices},
                  {"reduced_vertices", layers.reduced_vertices},
                  {"min_ratio", layers.min_ratio},
                  {"mean_ratio", layers.mean_ratio},
                  {"steep_vertices", layers.steep_vertices},
                  {"worst_place", vector_of(layers.worst_place)},
                  {"sentence", layers.text()}};
}

// Of the wall's materials.
void add_materials(Json& report, const tubular::Mixed_mesh& mesh) {
  std::map<int, std::size_t> cells;
  for (const auto* labels : {&mesh.tetrahedra.label, &mesh.pyramids.label, &mesh.prisms.label, &mesh.hexahedra.label})
    for (int region : *labels)
      ++cells[region];
  Json list = Json::array();
  for (const auto& name : mesh.region_names)
    if (name.first == tubular::labels::wall_region || name.first >= tubular::labels::first_material)
      list.push_back({{"region", name.first}, {"name", name.second}, {"cells", cells[name.first]}});
  report["materials"] = list;
}

void print_materials(const Json& materials) {
  std::string text;
  for (const auto& m : materials)
    text += (text.empty() ? "" : ", ") + m["name"].get<std::string>() + " " + std::to_string(m["cells"].get<long>()) +
            " cells";
  std::printf("materials of the wall: %s\n", text.c_str());
}

void add_zero_d_model(Json& report, const tubular::Zero_d_model& model) {
  double resistance = 0;
  for (const auto& v : model.vessels)
    resistance = (std::max)(resistance, v.resistance);
  report["zero_d_model"] = {{"vessels", model.vessels.size()},
                            {"junctions", model.junctions.size()},
                            {"boundary_conditions", model.boundary_conditions.size()},
                            {"flow_rate", model.flow_rate},
                            {"largest_resistance", resistance},
                            {"openings_left_out", model.openings_left_out}};
}

void print_zero_d_model(const Json& m) {
  std::printf("0D model: %ld vessels, %ld junctions, %ld ends; flow at the inlet %g ml/s\n", m["vessels"].get<long>(),
              m["junctions"].get<long>(), m["boundary_conditions"].get<long>(), m["flow_rate"].get<double>());
}

// Of a mesh in a metric, with layers at the wall.
void add_metric_quality(Json& report, const tubular::Tubular_model& model, const tubular::Mixed_mesh& mesh) {
  const tubular::Quality_report quality = tubular::quality_report(mesh, tubular::labels::lumen);
  report["quality"]["Q_tau"] = statistics(quality.Q_tau);
  report["quality"]["Q_tau"]["share_below_3"] = quality.Q_tau.share_below(3);
  report["quality"]["efficiency"] = quality.efficiency;
  const tubular::Boundary_layer_report layer = tubular::boundary_layer_report(mesh, model.centerlines);
  report["quality"]["first_height"] = statistics(layer.first_height);
  report["quality"]["first_height"]["share_within_30_percent"] = layer.share_of_first_heights(0.3);
  report["quality"]["alignment"] = statistics(layer.alignment);
  report["quality"]["alignment"]["share_below_15_degrees"] = layer.alignment.share_below(15);
}

// Of the triangles of a surface in a metric.
void add_metric_quality(Json& report, const tubular::Remeshed_surface& surface) {
  const tubular::Metric_surface_report fit = tubular::metric_surface_report(surface);
  const auto json = [](const tubular::Metric_fit& f) {
    return Json({{"shape", statistics(f.shape)},
                 {"edge_length", statistics(f.edge_length)},
                 {"share_of_unit_edges", f.share_of_unit_edges()},
                 {"wanted_triangles", f.wanted_triangles}});
  };
  report["quality"]["in_the_metric"] = {{"wall", json(fit.wall)}, {"caps", json(fit.caps)}};
}

void print_histogram(const Json& measure, const char* name) {
  const auto& bins = measure["histogram"];
  const double most = *std::max_element(bins.begin(), bins.end());
  std::printf("\n%s\n", name);
  for (std::size_t i = 0; i < bins.size(); ++i)
    std::printf("  %4.2f %9ld %s\n", double(i) / double(bins.size()), bins[i].get<long>(),
                std::string(std::size_t(50 * bins[i].get<double>() / (std::max)(most, 1.)), '#').c_str());
}

void print_branches(const Json& branches) {
  std::printf("\n%-8s %12s %12s %12s %10s\n", "branch", "length", "min radius", "max radius", "points");
  for (std::size_t i = 0; i < branches.size(); ++i)
    std::printf("%-8zu %12.5g %12.5g %12.5g %10.1f\n", i, branches[i]["length"].get<double>(),
                branches[i]["min_radius"].get<double>(), branches[i]["max_radius"].get<double>(),
                branches[i]["points_per_circumference"].get<double>());
}

// The measures of quality in the order of the table, with what they are called there.
const std::vector<std::pair<const char*, const char*>>& measures() {
  static const std::vector<std::pair<const char*, const char*>> list = {{"gamma_tau", "tetrahedra, gamma_tau"},
                                                                        {"scaled_jacobian", "hexahedra, Jacobian"},
                                                                        {"zeta_H", "hexahedra, zeta_H"},
                                                                        {"gamma_T", "triangles, gamma_T"},
                                                                        {"eta_q", "quads, eta_q"}};
  return list;
}

// Those of finite volumes.
void print_excesses(const Json& q) {
  const std::pair<const char*, const char*> list[] = {
      {"aspect", "cells, aspect"}, {"non_orthogonality", "faces, non-orthogonal"}, {"skewness", "faces, skewness"}};
  if (!q.contains("aspect"))
    return;
  const auto text = [](const Json& x) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%8.3f", x.is_null() ? HUGE_VAL : x.get<double>());
    return std::string(buffer);
  };
  std::printf("\n%-22s %8s %8s %8s\n", "finite volumes", "max", "99 %", "mean");
  for (const auto& m : list)
    std::printf("%-22s %s %s %s\n", m.second, text(q[m.first]["max"]).c_str(), text(q[m.first]["p99"]).c_str(),
                text(q[m.first]["mean"]).c_str());
}

void print_counts(const Json& r) {
  std::printf("%s: %ld points", r["output"].get<std::string>().c_str(), r["points"].get<long>());
  for (const char* kinds : {"cells", "facets"})
    for (const auto& kind : r[kinds].items())
      if (kind.value() > 0)
        std::printf(", %ld %s", kind.value().get<long>(), kind.key().c_str());
  std::printf("\n\n");
}

void print_metric_quality(const Json& q) {
  std::printf("in the metric: Q %.2f on average, at most %.2f; efficiency %.3f\n", q["Q_tau"]["mean"].get<double>(),
              q["Q_tau"]["max"].get<double>(), q["efficiency"].get<double>());
  std::printf("first layer: %.2f of the height asked for on average, within 30 %% of it at %.1f %% of the wall\n",
              q["first_height"]["mean"].get<double>(),
              100 * q["first_height"]["share_within_30_percent"].get<double>());
  if (q["alignment"]["count"] > 0)
    std::printf("long edges: %.1f %% within 15 degrees of the centerline's direction\n",
                100 * q["alignment"]["share_below_15_degrees"].get<double>());
}

void print_surface_in_its_metric(const Json& q) {
  for (const char* part : {"wall", "caps"})
    if (q[part]["shape"]["count"] > 0)
      std::printf("in the metric, %s: shape %.3f at least, %.3f on average; %.1f %% of the edges of unit length\n",
                  part, q[part]["shape"]["min"].get<double>(), q[part]["shape"]["mean"].get<double>(),
                  100 * q[part]["share_of_unit_edges"].get<double>());
}

std::string text_of(const Json& label) {
  return label["name"].is_null() ? std::to_string(label["label"].get<int>()) : label["name"].get<std::string>();
}

// The first of those that are wanted.
template <class Wanted> std::string list_of_labels(const Json& labels, const Wanted& is_wanted) {
  std::string list;
  std::size_t number = 0;
  const std::size_t most = 12;
  for (const auto& l : labels)
    if (is_wanted(l) && ++number <= most)
      list += (list.empty() ? "" : ", ") + text_of(l);
  return (list.empty() ? "none" : list) + (number > most ? ", …" : "");
}

// One line for all labels that are not understood for the same reason.
void print_labels(const Json& l) {
  const auto meaning = [&](const char* wanted) {
    return list_of_labels(l["labels"], [&](const Json& label) { return label["meaning"] == wanted; });
  };
  std::printf("labels: %s; wall: %s; ends: %s\n", l["source"].get<std::string>().c_str(), meaning("wall").c_str(),
              meaning("opening").c_str());
  std::map<std::string, std::size_t> reasons;
  for (const auto& label : l["labels"])
    if (!label["understood"])
      ++reasons[label["reason"].get<std::string>()];
  for (const auto& reason : reasons)
    std::printf("note: label%s %s%s %s, and is taken for wall there\n", reason.second > 1 ? "s" : "",
                list_of_labels(l["labels"], [&](const Json& label) { return label["reason"] == reason.first; }).c_str(),
                reason.second > 1 ? ": each" : "", reason.first.c_str());
  std::printf("\n");
}

void print_volume(const Json& v) {
  std::printf("\nvolume: %.6g, that of the surface: %.6g (%+.2f %%)\n", v["mesh"].get<double>(),
              v["input"].get<double>(), 100 * v["relative_difference"].get<double>());
  if (v["vertices_held_back"] > 0)
    std::printf("note: to keep the volume %ld vertices should have moved further; cells would have turned over, or the "
                "wall met itself\n",
                v["vertices_held_back"].get<long>());
}

void print_summary(const Json& r, bool verbose) {
  print_counts(r);
  if (r.contains("labels"))
    print_labels(r["labels"]);
  if (r.contains("notes")) {
    for (const auto& note : r["notes"])
      std::printf("note: %s\n", note.get<std::string>().c_str());
    std::printf("\n");
  }
  for (const auto& repair : r["repairs"])
    std::printf("repair: %s%s\n", repair["sentence"].get<std::string>().c_str(),
                repair["defect"] == "possible_openings" ? " (--fill X,Y,Z)" : "");
  if (!r["repairs"].empty())
    std::printf("\n");
  if (r.contains("round_ends"))
    print_round_ends(r["round_ends"]);
  if (r.contains("openings_of_parts"))
    std::printf("%ld vessels, meshed each by itself\n\n", long(r["openings_of_parts"].size()));
  for (const auto& fallback : r["fallbacks"])
    std::printf("note: %s\n\n", fallback.get<std::string>().c_str());
  std::printf("%-22s %8s %8s %8s\n", "quality", "min", "1 %", "mean");
  for (const auto& m : measures()) {
    if (!r["quality"].contains(m.first) || r["quality"][m.first]["count"] == 0)
      continue;
    const auto& s = r["quality"][m.first];
    std::printf("%-22s %8.3f %8.3f %8.3f\n", m.second, s["min"].get<double>(), s["p1"].get<double>(),
                s["mean"].get<double>());
  }
  if (r.contains("quadratic"))
    print_quadratic(r["quadratic"]);
  print_excesses(r["quality"]);
  if (r["quality"].contains("Q_tau"))
    print_metric_quality(r["quality"]);
  if (r["quality"].contains("in_the_metric"))
    print_surface_in_its_metric(r["quality"]["in_the_metric"]);
  double fewest = 0, most = 0;
  for (const auto& b : r["branches"]) {
    const double p = b["points_per_circumference"];
    if (p > 0) {
      fewest = fewest > 0 ? (std::min)(fewest, p) : p;
      most = (std::max)(most, p);
    }
  }
  std::printf("\n%ld branches", long(r["branches"].size()));
  if (most > 0) // else their wall has no triangles
    std::printf(", %.1f to %.1f points round their circumference", fewest, most);
  std::printf("\n");
  for (const auto& layers : {std::make_pair("wall", "wall"), std::make_pair("boundary_layer", "boundary layer")})
    if (r.contains(layers.first))
      std::printf("%s: %s\n", layers.second, r[layers.first]["sentence"].get<std::string>().c_str());
  if (r.contains("materials"))
    print_materials(r["materials"]);
  if (r.contains("zero_d_model"))
    print_zero_d_model(r["zero_d_model"]);
  if (r.contains("patches"))
    print_patches(r["patches"]);
  if (r.contains("quads"))
    print_quads(r["quads"]);
  if (r.contains("hexahedral"))
    print_hexahedral(r["hexahedral"]);
  if (r.contains("partitions"))
    print_partitions(r["partitions"]);
  print_volume(r["volume"]);
  std::printf("\n%-12s %6s %10s %12s %12s %12s\n", "opening", "patch", "facets", "radius", "area", "in the mesh");
  for (const auto& o : r["openings"])
    std::printf("%-12s %6d %10ld %12.5g %12.5g %12.5g\n", o["name"].get<std::string>().c_str(), o["patch"].get<int>(),
                o["triangles"].get<long>() + o["quads"].get<long>(), o["radius"].get<double>(), o["area"].get<double>(),
                o["mesh_area"].get<double>());
  for (const auto& o : r["openings"])
    if (o["branch"].is_null())
      std::printf("note: no centerline leads to %s; the mesh size there is that of the lumen's shape\n",
                  o["name"].get<std::string>().c_str());
  const long pieces = r.contains("openings_of_parts") ? long(r["openings_of_parts"].size()) : 1;
  if (r["centerlines"].is_null() && !r["loops"] && r["boundary_euler"] < 2 * pieces)
    std::printf(
        "note: vessels split and rejoin; one that no centerline follows is no branch of its own: all of them are kept "
        "without --no-loops\n");
  if (verbose) {
    print_branches(r["branches"]);
    for (const auto& m : measures())
      if (r["quality"].contains(m.first))
        print_histogram(r["quality"][m.first], m.second);
  }
  std::printf("\n%-22s %8s\n", "stage", "seconds");
  for (const auto& t : r["times"].items())
    std::printf("%-22s %8.2f\n", t.key().c_str(), t.value().get<double>());
  std::printf("%-22s %8.2f   peak memory %.0f MB\n", "total", r["total_time"].get<double>(),
              r["peak_memory_bytes"].get<double>() / 1e6);
}

} // namespace

struct Run_report::Content {
  Json json;
};

Run_report::Run_report(const Run& run)
    : content_(new Content{description_of(run)}) {
  Json& report = content_->json;
  if (!run.labels.empty())
    report["labels"] = labels(run.labels);
  if (!run.round_ends.empty())
    add_round_ends(report, run.round_ends);
  if (run.openings_of_parts.size() > 1)
    report["openings_of_parts"] = run.openings_of_parts;
  if (!run.notes.empty())
    report["notes"] = run.notes;
  if (run.surface.surface.number_of_faces() > 0)
    add_patches(report, run.surface);
  if (run.surface.quads.wall_quads() > 0)
    add_quads(report, run.surface.quads);
  if (run.options.is_hexahedral())
    add_hexahedral(report, run.meshing.hexahedral);
  if (run.options.makes_surface_only())
    describe_surface(report, run.surface);
  if (run.options.is_anisotropic_surface())
    add_metric_quality(report, run.surface);
  if (run.options.has_wall())
    add_layers(report, "wall", run.wall);
  if (!run.options.material_array.empty())
    add_materials(report, run.cells());
  if (run.options.fibres)
    report["fibres"] = {{"cells", run.fibres.cells}, {"undirected", run.fibres.undirected}};
  if (!run.sections.empty())
    report["sections"] = {{"count", run.sections.size()}};
  if (!run.options.zero_d_output.empty())
    add_zero_d_model(report, run.zero_d);
  if (run.options.boundary_layer_prisms > 0)
    add_layers(report, "boundary_layer", run.meshing.boundary_layer);
  if (run.options.is_anisotropic())
    add_metric_quality(report, run.model, run.cells());
  if (run.options.is_quadratic())
    add_quadratic(report, run);
  if (run.options.partitions > 0)
    add_partitions(report, tubular::partition_report(run.mesh, run.partition));
}

Run_report::~Run_report() = default;

void Run_report::add_times(const Stage_clock& clock) {
  Json& report = content_->json;
  for (const auto& stage : clock.stages())
    report["times"][stage.first] = stage.second;
  report["total_time"] = clock.total();
  report["peak_memory_bytes"] = Stage_clock::peak_memory();
}

std::string Run_report::json() const {
  return content_->json.dump(2) + "\n";
}

void Run_report::print(bool verbose) const {
  print_summary(content_->json, verbose);
}
