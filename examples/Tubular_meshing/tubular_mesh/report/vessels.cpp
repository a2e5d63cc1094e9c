// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "vessels.h"

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Quality/branch_resolution.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace tubular = CGAL::Tubular_meshing;

namespace {

double area_of(const tubular::Lumen_measures& measures, int patch) {
  const auto found = measures.opening_area.find(patch);
  return found == measures.opening_area.end() ? 0 : found->second;
}

std::string name_of_label(const Json& label) {
  return label["name"].is_null() ? std::to_string(label["label"].get<int>()) : label["name"].get<std::string>();
}

// The first of those that are wanted.
template <class Wanted> std::string list_of_labels(const Json& labels, const Wanted& is_wanted) {
  std::string list;
  std::size_t number = 0;
  const std::size_t most = 12;
  for (const auto& l : labels)
    if (is_wanted(l) && ++number <= most)
      list += (list.empty() ? "" : ", ") + name_of_label(l);
  return (list.empty() ? "none" : list) + (number > most ? ", …" : "");
}

} // namespace

Json repairs_of(const tubular::Repair_report& report) {
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
Json labels_of(const tubular::Labelled_ends& ends) {
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

Json round_ends_of(const std::vector<tubular::Round_end_report>& ends) {
  Json list = Json::array();
  for (const auto& end : ends)
    list.push_back({{"cut", end.is_cut},
                    {"center", vector_of(end.center)},
                    {"radius", end.radius},
                    {"reason", end.is_cut ? Json() : Json(end.reason)}});
  return list;
}

Json openings_of(const Run& run, const tubular::Lumen_measures& measures) {
  const tubular::Tubular_model& model = run.model;
  const tubular::Mixed_mesh& mesh = run.cells();
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

Json branches_of(const Run& run) {
  const auto& graph = run.model.centerlines;
  const std::vector<double> points = tubular::points_per_circumference(run.cells(), tubular::Centerline_field(graph),
                                                                       graph.branches().size(), run.options.threads);
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

// That of the surface that was meshed, and of the mesh's lumen; how the latter came to it.
Json volumes_of(const Run& run, const tubular::Lumen_measures& measures) {
  const double input = CGAL::to_double(CGAL::Polygon_mesh_processing::volume(run.model.surface));
  return {{"input", input},
          {"mesh", measures.volume},
          {"relative_difference", input > 0 ? measures.volume / input - 1 : 0},
          {"preserved", run.options.preserve_volume && !run.options.is_quadratic()},
          {"before", run.meshing.volume.volume_before > 0 ? Json(run.meshing.volume.volume_before) : Json()},
          {"largest_shift", run.meshing.volume.largest_shift},
          {"vertices_held_back", run.meshing.volume.held_back}};
}

bool keeps_loops(const Run& run) {
  const tubular::Centerline_graph& graph = run.model.centerlines;
  return run.options.loops ||
         (run.options.centerlines.empty() && !run.options.no_loops && graph.branches().size() >= graph.nodes().size());
}

void print_repairs(const Json& repairs) {
  for (const auto& repair : repairs)
    std::printf("repair: %s%s\n", repair["sentence"].get<std::string>().c_str(),
                repair["defect"] == "possible_openings" ? " (--fill X,Y,Z)" : "");
  if (!repairs.empty())
    std::printf("\n");
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

void print_openings(const Json& openings) {
  std::printf("\n%-12s %6s %10s %12s %12s %12s\n", "opening", "patch", "facets", "radius", "area", "in the mesh");
  for (const auto& o : openings)
    std::printf("%-12s %6d %10ld %12.5g %12.5g %12.5g\n", o["name"].get<std::string>().c_str(), o["patch"].get<int>(),
                o["triangles"].get<long>() + o["quads"].get<long>(), o["radius"].get<double>(), o["area"].get<double>(),
                o["mesh_area"].get<double>());
  for (const auto& o : openings)
    if (o["branch"].is_null())
      std::printf("note: no centerline leads to %s; the mesh size there is that of the lumen's shape\n",
                  o["name"].get<std::string>().c_str());
}

void print_branches(const Json& branches) {
  std::printf("\n%-8s %12s %12s %12s %10s\n", "branch", "length", "min radius", "max radius", "points");
  for (std::size_t i = 0; i < branches.size(); ++i)
    std::printf("%-8zu %12.5g %12.5g %12.5g %10.1f\n", i, branches[i]["length"].get<double>(),
                branches[i]["min_radius"].get<double>(), branches[i]["max_radius"].get<double>(),
                branches[i]["points_per_circumference"].get<double>());
}

// Of all branches, those whose wall has no triangles aside.
void print_range_of_points(const Json& branches) {
  double fewest = 0, most = 0;
  for (const auto& b : branches) {
    const double p = b["points_per_circumference"];
    if (p > 0) {
      fewest = fewest > 0 ? (std::min)(fewest, p) : p;
      most = (std::max)(most, p);
    }
  }
  std::printf("\n%ld branches", long(branches.size()));
  if (most > 0)
    std::printf(", %.1f to %.1f points round their circumference", fewest, most);
  std::printf("\n");
}

void print_lost_branches(const Json& r) {
  const long pieces = r.contains("openings_of_parts") ? long(r["openings_of_parts"].size()) : 1;
  if (r["centerlines"].is_null() && !r["loops"] && r["boundary_euler"] < 2 * pieces)
    std::printf(
        "note: vessels split and rejoin; one that no centerline follows is no branch of its own: all of them are kept "
        "without --no-loops\n");
}

void print_volume(const Json& v) {
  std::printf("\nvolume: %.6g, that of the surface: %.6g (%+.2f %%)\n", v["mesh"].get<double>(),
              v["input"].get<double>(), 100 * v["relative_difference"].get<double>());
  if (v["vertices_held_back"] > 0)
    std::printf("note: to keep the volume %ld vertices should have moved further; cells would have turned over, or the "
                "wall met itself\n",
                v["vertices_held_back"].get<long>());
}
