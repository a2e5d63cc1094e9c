// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Run_report.h"

#include "report/counts.h"
#include "report/hexahedra.h"
#include "report/json.h"
#include "report/layers.h"
#include "report/partitions.h"
#include "report/quality.h"
#include "report/surface_mesh.h"
#include "report/times.h"
#include "report/vessels.h"
#include "report/zero_d_model.h"

#include <CGAL/Tubular_meshing/Partition/partition_report.h>
#include <CGAL/Tubular_meshing/Quadratic/quadratic_quality.h>
#include <CGAL/Tubular_meshing/Quality/lumen_measures.h>
#include <CGAL/Tubular_meshing/Quality/mesh_report.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>

namespace tubular = CGAL::Tubular_meshing;

namespace {

Json description_of(const Run& run) {
  const tubular::Mixed_mesh& mesh = run.cells();
  const auto threads = tubular::parameters::number_of_threads(run.options.threads);
  const tubular::Mesh_report report = tubular::mesh_report(mesh, threads.mesh_check(run.meshing.check));
  tubular::Validity_report validity = report.validity;
  if (run.options.is_quadratic()) // whose cells are judged as they are curved
    validity.inverted_cells = 0;
  if (!run.options.material_array.empty()) // which may be in several places, and part the wall
    validity.region_components.erase(validity.region_components.lower_bound(tubular::labels::wall_region),
                                     validity.region_components.end());
  const std::size_t openings_of_all = run.model.openings.size();
  const tubular::Lumen_measures measures = run.options.is_quadratic()
                                               ? tubular::lumen_measures(run.quadratic, openings_of_all)
                                               : tubular::lumen_measures(mesh, openings_of_all);
  Json json = {
      {"program", std::string("tubular_mesh ") + run.version},
      {"input", run.options.surface},
      {"centerlines", run.options.centerlines.empty() ? Json() : Json(run.options.centerlines)},
      {"loops", keeps_loops(run)},
      {"repairs", repairs_of(run.repairs)},
      {"flow_extensions", run.extensions.lengths},
      {"output", run.options.output},
      {"type", run.options.type},
      {"points_per_circumference", run.options.points_per_circumference},
      {"fallbacks", run.meshing.fallbacks},
      {"order", run.options.order},
      {"points", run.options.is_quadratic() ? run.quadratic.number_of_nodes() : mesh.points.size()},
      {"cells", cells_by_kind(mesh.tetrahedra.size(), mesh.pyramids.size(), mesh.prisms.size(), mesh.hexahedra.size())},
      {"facets", facets_by_kind(mesh.triangles.size(), mesh.quads.size())},
      {"valid", validity.is_valid_in((std::max)(run.openings_of_parts.size(), std::size_t(1)))},
      {"boundary_euler", validity.boundary_euler},
      {"quality", qualities_of(report.quality)},
      {"volume", volumes_of(run, measures)},
      {"openings", openings_of(run, measures)},
      {"branches", branches_of(run)}};
  if (run.options.is_anisotropic())
    add_metric_quality(json, run.model, mesh, report.quality, run.options.threads);
  return json;
}

void print_counts(const Json& r) {
  std::printf("%s: %ld points", r["output"].get<std::string>().c_str(), r["points"].get<long>());
  for_each_count(r, [](const Json& number, const std::string& kind) {
    std::printf(", %ld %s", number.get<long>(), kind.c_str());
  });
  std::printf("\n\n");
}

void print_notes(const Json& r) {
  if (!r.contains("notes"))
    return;
  for (const auto& note : r["notes"])
    std::printf("note: %s\n", note.get<std::string>().c_str());
  std::printf("\n");
}

// A part of the report by its own function, if it is there.
void print_if_there(const Json& r, const char* part, void (*print)(const Json&)) {
  if (r.contains(part))
    print(r[part]);
}

void print_summary(const Json& r, bool verbose) {
  print_counts(r);
  print_if_there(r, "labels", print_labels);
  print_notes(r);
  print_repairs(r["repairs"]);
  print_if_there(r, "round_ends", print_round_ends);
  if (r.contains("openings_of_parts"))
    std::printf("%ld vessels, meshed each by itself\n\n", long(r["openings_of_parts"].size()));
  for (const auto& fallback : r["fallbacks"])
    std::printf("note: %s\n\n", fallback.get<std::string>().c_str());
  print_qualities(r);
  print_range_of_points(r["branches"]);
  print_layers(r);
  print_if_there(r, "materials", print_materials);
  print_if_there(r, "zero_d_model", print_zero_d_model);
  print_if_there(r, "patches", print_patches);
  print_if_there(r, "quads", print_quads);
  print_if_there(r, "hexahedral", print_hexahedral);
  print_if_there(r, "partitions", print_partitions);
  print_volume(r["volume"]);
  print_openings(r["openings"]);
  print_lost_branches(r);
  if (verbose) {
    print_branches(r["branches"]);
    print_histograms(r["quality"]);
  }
  print_times(r);
}

} // namespace

struct Run_report::Content {
  Json json;
};

Run_report::Run_report(const Run& run)
    : content_(new Content{description_of(run)}) {
  Json& report = content_->json;
  if (!run.labels.empty())
    report["labels"] = labels_of(run.labels);
  if (!run.round_ends.empty())
    report["round_ends"] = round_ends_of(run.round_ends);
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
  if (run.options.is_quadratic())
    add_quadratic(report, run);
  if (run.options.partitions > 0)
    add_partitions(report, tubular::partition_report(run.mesh, run.partition));
}

Run_report::~Run_report() = default;

void Run_report::add_times(const Stage_clock& clock) {
  ::add_times(content_->json, clock);
}

std::string Run_report::json() const {
  return text_of(content_->json);
}

void Run_report::print(bool verbose) const {
  print_summary(content_->json, verbose);
}
