// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes the centerlines of a tubular surface, which is repaired first. See --help.

#include "command_line/Points.h"
#include "command_line/run_tool.h"
#include "command_line/validators.h"

#include <CGAL/Tubular_meshing/Centerlines/branched_centerlines.h>
#include <CGAL/Tubular_meshing/Centerlines/compute_centerlines.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/IO/write_centerlines.h>
#include <CGAL/Tubular_meshing/Openings/close_openings.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <CLI/CLI.hpp>

#include <array>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Surface;
typedef CGAL::Tubular_meshing::Centerline_graph Graph;
namespace tubular = CGAL::Tubular_meshing;

namespace {

struct Options {
  std::string surface, output, seeds, inlet;
  std::vector<std::string> outlets;
  bool no_loops = false, whole = false;
};

std::vector<Point_3> seeds_of(const Options& o) {
  if (!o.seeds.empty())
    return command_line::read_points(o.seeds);
  std::vector<Point_3> seeds;
  if (o.outlets.empty())
    return seeds;
  if (o.inlet.empty())
    throw tubular::Parameter_error("--outlet needs --inlet, where the centerlines begin.");
  seeds.push_back(command_line::point_of(o.inlet));
  for (const std::string& p : o.outlets)
    seeds.push_back(command_line::point_of(p));
  return seeds;
}

Surface repaired_surface(const Options& o) {
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  tubular::IO::read_triangle_soup(o.surface, points, triangles);
  Surface surface;
  std::fputs(tubular::repair_surface(points, triangles, surface).text().c_str(), stdout);
  return surface;
}

// Seeds tell where lines begin and end, also on a surface that has openings: these are closed first, if it is open.
Graph centerlines_between_seeds(const Options& o, Surface& surface, const std::vector<Point_3>& seeds) {
  if (!CGAL::is_closed(surface)) {
    std::vector<tubular::Opening> openings = tubular::find_openings(surface);
    const auto patch = surface.add_property_map<Surface::Face_index, int>("f:patch", 0).first;
    tubular::close_openings(surface, openings, patch);
  }
  Graph graph;
  tubular::compute_centerlines(surface, seeds, graph, tubular::parameters::loops(!o.no_loops));
  return graph;
}

Graph centerlines_between_openings(const Options& o, Surface& surface) {
  std::vector<tubular::Opening> openings =
      o.inlet.empty() ? tubular::find_openings(surface)
                      : tubular::find_openings(surface, tubular::parameters::inlet(command_line::point_of(o.inlet)));
  const auto patch = surface.add_property_map<Surface::Face_index, int>("f:patch", 0).first;
  tubular::close_openings(surface, openings, patch);
  Graph graph;
  tubular::compute_centerlines(surface, patch, openings, graph, tubular::parameters::loops(!o.no_loops));
  return graph;
}

void run(const Options& o) {
  if (!tubular::IO::is_supported_centerlines_format(o.output))
    throw tubular::Parameter_error("Centerlines cannot be written to \"" + o.output + "\": give a .vtp or .vtk file.");
  const std::vector<Point_3> seeds = seeds_of(o);
  Surface surface = repaired_surface(o);
  const Graph graph =
      seeds.empty() ? centerlines_between_openings(o, surface) : centerlines_between_seeds(o, surface, seeds);
  if (o.whole)
    tubular::IO::write_centerlines(o.output, tubular::centerlines_from_root(graph));
  else
    tubular::IO::write_centerlines(o.output, tubular::branched_centerlines(graph));
  std::printf("%zu branches, %zu ends, %zu points\n", graph.branches().size(), graph.number_of_ends(),
              graph.points().size());
}

} // namespace

int main(int argc, char* argv[]) {
  Options o;
  CLI::App app("Computes the centerlines of a vessel or airway tree, with the radii of the inscribed spheres, from its "
               "triangulated surface.\nWritten as VMTK's branch extractor does: lines from the inlet to each outlet, "
               "cut into tracts, with CenterlineIds, TractIds, GroupIds and Blanking.",
               "compute_centerlines");
  app.footer(command_line::exit_statuses());
  app.add_option("surface", o.surface, "surface, open at its ends or capped flat: .stl .off .obj .ply .vtp .vtk .msh")
      ->required();
  app.add_option("-o,--output", o.output, "centerlines to write: .vtp .vtk")->required();
  auto* inlet =
      app.add_option("--inlet", o.inlet, "X,Y,Z: the opening nearest to this point is the inlet (default: the largest)")
          ->check(command_line::is_point());
  auto* outlets =
      app.add_option("--outlet", o.outlets,
                     "X,Y,Z (repeatable): lines end here instead of at the openings; with --inlet, where they begin")
          ->expected(1)
          ->take_all()
          ->check(command_line::is_point());
  app.add_option("--seeds", o.seeds, "file with a point a line, the source first, instead of --inlet and --outlet")
      ->excludes(outlets)
      ->excludes(inlet);
  app.add_flag("--no-loops", o.no_loops, "follow shortest paths alone where vessels split and rejoin");
  app.add_flag("--whole", o.whole, "write each line in one piece, without the cell arrays");
  return command_line::run_tool(app, argc, argv, [&] { run(o); });
}
