// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "dry_run.h"

#include "renames.h"
#include "report/counts.h"
#include "report/json.h"
#include "report/times.h"
#include "stages.h"

#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesh_estimate.h>
#include <CGAL/Tubular_meshing/Pipelines/join_parts.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace tubular = CGAL::Tubular_meshing;

namespace {

Json openings(const tubular::Tubular_model& model) {
  const auto names = tubular::patch_names(model);
  Json list = Json::array();
  for (const tubular::Opening& o : model.openings)
    list.push_back({{"name", names.at(o.patch)},
                    {"patch", o.patch},
                    {"center", vector_of(o.center)},
                    {"normal", vector_of(o.normal)},
                    {"area", o.area},
                    {"perimeter", o.perimeter},
                    {"radius", o.radius},
                    {"branch", o.branch == tubular::Opening::no_branch ? Json() : Json(o.branch)}});
  return list;
}

Json branches(const tubular::Tubular_model& model) {
  Json list = Json::array();
  for (const auto& b : model.centerlines.branches())
    list.push_back({{"length", b.length},
                    {"min_radius", b.min_radius},
                    {"max_radius", b.max_radius},
                    {"parents", b.parents},
                    {"children", b.children}});
  return list;
}

Json integrals(const tubular::Lumen_integrals& n) {
  return {{"cubes", n.cubes},
          {"inner_cubes", n.inner_cubes},
          {"wall_squares", n.wall_squares},
          {"cap_squares", n.cap_squares},
          {"rims", n.rims},
          {"metric_cubes", n.metric_cubes},
          {"metric_wall", n.metric_wall},
          {"metric_caps", n.metric_caps},
          {"rows_of_blocks", n.rows_of_blocks},
          {"domes_of_blocks", n.domes_of_blocks},
          {"layer_thickness", n.layer_thickness}};
}

Json estimate(const tubular::Mesh_estimate& e, const Options& o) {
  Json json = {{"cells", cells_by_kind(std::round(e.tetrahedra), std::round(e.pyramids), std::round(e.prisms),
                                       std::round(e.hexahedra))},
               {"facets",
                facets_by_kind(std::round(e.wall_triangles + e.cap_triangles), std::round(e.wall_quads + e.cap_quads))},
               {"seconds", e.seconds},
               {"memory_bytes", std::round(e.bytes)},
               {"integrals", integrals(e.integrals)}};
  if (o.is_hexahedral())
    json["method"] = tubular::name_of(e.method);
  return json;
}

bool is_in_blocks(const Options& o) {
  return (o.is_hexahedral() && o.hex_method == "blocks") ||
         (o.makes_surface_only() && o.surface_elements == "structured-quads");
}

// Takes the models over.
Json report_of(Prepared& prepared, const tubular::Mesh_estimate& all) {
  const Run& run = prepared.run;
  const Options& o = run.options;
  std::vector<std::string> notes = run.notes;
  std::vector<tubular::Tubular_model> models;
  for (Part& part : prepared.parts) {
    notes.insert(notes.end(), part.run.notes.begin(), part.run.notes.end());
    models.push_back(std::move(part.run.model));
  }
  for (const auto& r : run.repairs.repairs)
    notes.push_back(r.sentence);
  const bool is_sampled = prepared.parts.front().run.is_sampled;
  if (is_sampled)
    notes.push_back("The surface is large: mesh sizes are those of balls at some places of its wall; -v follows the "
                    "centerlines, and lists the branches" +
                    std::string(is_in_blocks(o) ? ", and finds whether they can have blocks." : "."));
  const tubular::Tubular_model model = tubular::join_parts(std::move(models));
  return {{"program", "tubular_mesh " + run.version},
          {"dry_run", true},
          {"input", o.surface},
          {"type", o.type},
          {"points_per_circumference", prepared.parts.front().run.options.points_per_circumference},
          {"vessels", prepared.parts.size()},
          {"triangles", model.surface.number_of_faces()},
          {"notes", notes},
          {"fallbacks", all.fallbacks},
          {"openings", openings(model)},
          {"branches", is_sampled ? Json() : branches(model)},
          {"vessels_length", all.vessel_length},
          {"radius", {{"smallest", all.smallest_radius}, {"largest", all.largest_radius}}},
          {"mesh_size", {{"smallest", all.smallest_size}, {"largest", all.largest_size}}},
          {"estimate", estimate(all, o)}};
}

// With two digits, or three: it is no more than an estimate.
std::string about(double number) {
  if (!(number >= 1))
    return "0";
  const double unit = std::pow(10, (std::max)(std::floor(std::log10(number)) - 1, 0.));
  std::string text = std::to_string((long long)(unit * std::round(number / unit)));
  for (std::size_t i = text.size(); i > 3; i -= 3)
    text.insert(i - 3, ",");
  return text;
}

std::string about_seconds(double seconds) {
  return seconds < 1 ? "less than a second" : seconds < 120 ? about(seconds) + " s" : about(seconds / 60) + " min";
}

void print(const Json& r, bool verbose) {
  const auto number = [](const Json& j) { return j.get<double>(); };
  const bool has_branches = !r["branches"].is_null();
  std::printf("%s: %ld vessel%s, %zu openings%s\n", r["input"].get<std::string>().c_str(), r["vessels"].get<long>(),
              r["vessels"].get<long>() == 1 ? "" : "s", r["openings"].size(),
              has_branches ? (", " + std::to_string(r["branches"].size()) + " branches").c_str() : "");
  for (const char* list : {"notes", "fallbacks"})
    for (const Json& sentence : r[list])
      std::printf("note: %s\n", sentence.get<std::string>().c_str());
  std::printf("\n%-12s %6s %12s %12s %8s\n", "opening", "patch", "radius", "area", "branch");
  for (const Json& o : r["openings"])
    std::printf("%-12s %6d %12.5g %12.5g %8s\n", o["name"].get<std::string>().c_str(), o["patch"].get<int>(),
                number(o["radius"]), number(o["area"]),
                !has_branches           ? ""
                : o["branch"].is_null() ? "none"
                                        : std::to_string(o["branch"].get<long>()).c_str());
  if (verbose) {
    std::printf("\n%-8s %12s %12s %12s\n", "branch", "length", "least radius", "largest");
    long i = 0;
    for (const Json& b : r["branches"])
      std::printf("%-8ld %12.5g %12.5g %12.5g\n", i++, number(b["length"]), number(b["min_radius"]),
                  number(b["max_radius"]));
  }
  std::printf("\nbranches: %s%.*g long in all, of radius %.4g to %.4g\n", has_branches ? "" : "about ",
              has_branches ? 5 : 3, number(r["vessels_length"]), number(r["radius"]["smallest"]),
              number(r["radius"]["largest"]));
  std::printf("mesh size on the wall: %.4g to %.4g, with %.4g points per circumference\n",
              number(r["mesh_size"]["smallest"]), number(r["mesh_size"]["largest"]),
              number(r["points_per_circumference"]));
  std::printf("\na mesh of type %s would have about\n", r["type"].get<std::string>().c_str());
  const Json& e = r["estimate"];
  for_each_count(e, [&](const Json& count, const std::string& kind) {
    std::printf("%14s %s\n", about(number(count)).c_str(), kind.c_str());
  });
  std::printf("and take about %s MB of memory and %s, beside the %.1f s that this took\n",
              about(number(e["memory_bytes"]) / 1e6).c_str(), about_seconds(number(e["seconds"])).c_str(),
              number(r["total_time"]));
}

} // namespace

void dry_run(Prepared& prepared, Stage_clock& clock, Progress& progress) {
  const Options& o = prepared.run.options;
  distribute_branches(prepared.run, prepared.parts);
  rename_patches(prepared.run, prepared.parts);
  tubular::Mesh_estimate all;
  for (const tubular::Mesh_estimate& e : estimate_meshes(prepared.parts, clock))
    all.add(e);
  clock.finish();
  Json report = report_of(prepared, all);
  add_times(report, clock);
  for (const std::string& name : o.reports) {
    tubular::IO::Output_file file(name);
    file.write(text_of(report));
    file.commit();
  }
  progress.finish(prepared.run);
  if (o.quiet)
    return;
  print(report, o.verbose);
  if (std::fflush(stdout) != 0)
    throw tubular::Output_error("The estimate cannot be printed.");
}
