// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "surface_mesh.h"

#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <cstdio>
#include <string>

namespace tubular = CGAL::Tubular_meshing;

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

void add_quads(Json& report, const tubular::Quad_report& quads) {
  report["quads"] = {{"structured", quads.structured_quads},
                     {"unstructured", quads.unstructured_quads},
                     {"irregular_vertices", quads.irregular_vertices},
                     {"annular_patches_without_grid", quads.annular_patches_without_grid},
                     {"folded", quads.folded_quads}};
}

void describe_surface(Json& report, const tubular::Remeshed_surface& surface) {
  const auto& mesh = surface.surface;
  report["valid"] = CGAL::is_closed(mesh) && mesh.is_valid();
  report["boundary_euler"] =
      long(mesh.number_of_vertices()) - long(mesh.number_of_edges()) + long(mesh.number_of_faces());
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

void print_quads(const Json& q) {
  std::printf("%ld quads in grids, %ld unstructured; %ld irregular vertices\n", q["structured"].get<long>(),
              q["unstructured"].get<long>(), q["irregular_vertices"].get<long>());
}
