// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Cuts a tubular surface into patches and maps each onto the plane. See --help.
// The file written is a Wavefront .obj with texture coordinates: a group a patch, side by side in the plane, each in a
// unit square of its own, so that any viewer with a checkerboard shows what the maps do to angles and sizes.

#include "command_line/run_tool.h"

#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Patches/cut_by_centerlines.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>
#include <CGAL/Tubular_meshing/Patches/parameterize_patch.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Surface;
namespace tubular = CGAL::Tubular_meshing;
typedef tubular::Patch_parameterization Map;

namespace {

struct Options {
  std::string surface, output;
  double aspect_ratio = 4;
  int threads = 0;
  bool no_loops = false;
};

double median_stretch_ratio(const Map& map) {
  std::vector<double> ratio;
  for (int t = 0; t < int(map.number_of_triangles()); ++t)
    ratio.push_back(map.stretch_ratio(t));
  const auto middle = ratio.begin() + std::ptrdiff_t(ratio.size() / 2);
  std::nth_element(ratio.begin(), middle, ratio.end());
  return *middle;
}

void print(const std::vector<Map>& maps) {
  std::printf("patch  triangles  loops  method            flips  median stretch ratio\n");
  for (std::size_t i = 0; i < maps.size(); ++i)
    std::printf("%5zu %10zu %6zu  %-16s %6zu %21.2f\n", i, maps[i].number_of_triangles(), maps[i].number_of_loops(),
                tubular::name_of(maps[i].method()), maps[i].number_of_flips(), median_stretch_ratio(maps[i]));
}

void write_obj(const std::string& file, const std::vector<Map>& maps) {
  std::ofstream out(file);
  out.precision(17);
  const std::size_t columns = std::size_t(std::ceil(std::sqrt(double(maps.size()))));
  std::size_t first = 1;
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const Map& map = maps[i];
    out << "g patch_" << i << "_" << tubular::name_of(map.method()) << "\n";
    for (const Point_3& p : map.patch().points)
      out << "v " << p << "\n";
    for (int v = 0; v < int(map.number_of_vertices()); ++v)
      out << "vt " << double(i % columns) + 0.5 + 0.48 * map.uv(v).x() << " "
          << double(i / columns) + 0.5 + 0.48 * map.uv(v).y() << "\n";
    for (const auto& t : map.patch().triangles) {
      out << "f";
      for (int v : t)
        out << " " << first + std::size_t(v) << "/" << first + std::size_t(v);
      out << "\n";
    }
    first += map.number_of_vertices();
  }
  if (!out.flush())
    throw tubular::Output_error("The file \"" + file + "\" cannot be written; check its folder and the space there.");
}

void run(const Options& o) {
  Surface surface;
  tubular::IO::read_surface(o.surface, surface);
  tubular::repair_surface(surface);
  auto model = tubular::make_tubular_model(surface, tubular::parameters::loops(!o.no_loops));
  const auto cut = tubular::cut_by_centerlines(model.surface, model.centerlines, model.patch,
                                               tubular::parameters::aspect_ratio(o.aspect_ratio));
  const std::vector<Map> maps =
      tubular::parameterize_patches(model.surface, cut, tubular::parameters::number_of_threads(o.threads));
  print(maps);
  write_obj(o.output, maps);
}

} // namespace

int main(int argc, char* argv[]) {
  Options o;
  CLI::App app("Cuts a tubular surface into patches and maps each onto the plane, conformally where possible.",
               "parameterize_patches");
  app.add_option("surface", o.surface, "surface, open at its ends or capped flat: .stl .off .obj .ply .vtp")
      ->required();
  app.add_option("-o,--output", o.output, "patches with texture coordinates: .obj")->required();
  app.add_option("--aspect-ratio", o.aspect_ratio, "largest length over mean diameter of a patch")
      ->capture_default_str();
  app.add_option("--threads", o.threads, "threads that map patches; 0: all cores")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_flag("--no-loops", o.no_loops, "follow shortest paths alone where vessels split and rejoin");
  app.footer(command_line::exit_statuses());
  return command_line::run_tool(app, argc, argv, [&] { run(o); });
}
