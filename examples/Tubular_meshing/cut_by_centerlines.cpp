// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Cuts a tubular surface into patches of moderate aspect ratio, by disks across its branches. See --help.
// The file written holds, for each face, the number of its patch along the centerlines; caps have -1.

#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/IO/write_surface.h>
#include <CGAL/Tubular_meshing/Patches/cut_by_centerlines.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <CLI/CLI.hpp>

#include <cstddef>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Surface;
namespace tubular = CGAL::Tubular_meshing;

namespace {

struct Options {
  std::string surface, output;
  double aspect_ratio = 4;
  bool no_loops = false;
};

const char* name_of(tubular::Patch_kind kind) {
  switch (kind) {
  case tubular::Patch_kind::closed:
    return "closed";
  case tubular::Patch_kind::disk:
    return "disk";
  case tubular::Patch_kind::annular:
    return "annular";
  default:
    return "junction";
  }
}

void print(const tubular::Surface_cut& cut) {
  std::printf("patch  kind      triangles  aspect ratio  neighbours\n");
  for (std::size_t i = 0; i < cut.patches.size(); ++i) {
    const auto& patch = cut.patches[i];
    std::printf("%5zu  %-8s %10zu %13.2f ", i, name_of(patch.kind), patch.faces.size(), patch.aspect_ratio());
    for (const tubular::Patch_loop& loop : patch.loops) {
      const auto& curve = cut.curves[loop.curve];
      curve.is_rim() ? std::printf(" cap %d", curve.opening) : std::printf(" %zu", loop.neighbour);
    }
    std::printf("\n");
  }
  for (const auto& problem : cut.problems)
    std::printf("%s\n", problem.message().c_str());
}

typedef tubular::Tubular_model Model;
typedef tubular::Surface_cut Cut;

Cut cut_model(const Options& o, Model& model) {
  return tubular::cut_by_centerlines(model.surface, model.centerlines, model.patch,
                                     tubular::parameters::aspect_ratio(o.aspect_ratio));
}

// Adds where vessels end blind, as the cut has found them: centerlines need to be told. Whether there are any.
bool add_seeds(const Cut& cut, std::vector<Point_3>& seeds) {
  const std::size_t before = seeds.size();
  for (const auto& problem : cut.problems)
    if (problem.kind == tubular::Cut_problem::no_centerline)
      seeds.push_back(problem.point);
  return seeds.size() > before;
}

void run(const Options& o) {
  Surface surface;
  tubular::IO::read_surface(o.surface, surface);
  tubular::repair_surface(surface);
  Model model = tubular::make_tubular_model(surface, tubular::parameters::loops(!o.no_loops));
  Cut cut = cut_model(o, model);
  std::vector<Point_3> seeds(1, model.openings.front().center); // the inlet comes first
  const int rounds = 4;                                         // blind vessels may branch off blind vessels
  for (int i = 0; i < rounds && add_seeds(cut, seeds); ++i) {
    std::printf("%zu vessels end blind; computing the centerlines anew, with seeds there\n", seeds.size() - 1);
    model = tubular::make_tubular_model(surface, tubular::parameters::loops(!o.no_loops).seeds(seeds));
    cut = cut_model(o, model);
  }
  print(cut);
  tubular::IO::write_surface(o.output, model.surface, tubular::parameters::face_patch_map(cut.patch_of_face));
}

} // namespace

int main(int argc, char* argv[]) {
  Options o;
  CLI::App app("Cuts a tubular surface into patches of moderate aspect ratio, by disks across its branches.");
  app.add_option("surface", o.surface, "surface, open at its ends or capped flat: .stl .off .obj .ply .vtp")
      ->required();
  app.add_option("-o,--output", o.output, "surface with the numbers of the patches: .vtp .vtk .ply .msh")->required();
  app.add_option("--aspect-ratio", o.aspect_ratio, "largest length over mean diameter of a patch")
      ->capture_default_str();
  app.add_flag("--no-loops", o.no_loops, "follow shortest paths alone where vessels split and rejoin");
  CLI11_PARSE(app, argc, argv);
  try {
    run(o);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "cut_by_centerlines: %s\n", e.what());
    return 3;
  }
}
