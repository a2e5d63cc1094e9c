// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes the centerlines of a tubular surface. See --help.

#include <CGAL/Tubular_meshing/Centerlines/branched_centerlines.h>
#include <CGAL/Tubular_meshing/Centerlines/compute_centerlines.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/IO/write_centerlines.h>
#include <CGAL/Tubular_meshing/Operators/close_openings.h>
#include <CGAL/Tubular_meshing/Operators/openings.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <new>
#include <sstream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Surface;
typedef CGAL::Tubular_meshing::Centerline_graph<Point_3> Graph;
namespace tubular = CGAL::Tubular_meshing;

namespace {

enum Exit_status { done = 0, wrong_usage = 2, unusable_input = 3, failed = 4 };

struct Options {
  std::string surface, output, seeds;
  std::vector<std::string> inlet, outlets;
  bool loops = false, whole = false;
};

// Three numbers, apart by commas or blanks.
Point_3 point_of(std::string text, const std::string& where) {
  for (char& c : text)
    c = c == ',' ? ' ' : c;
  std::istringstream in(text);
  double x, y, z;
  std::string rest;
  if (!(in >> x >> y >> z) || in >> rest || !std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
    throw tubular::Input_error(where + " is \"" + text + "\"; a point is three numbers, X,Y,Z.");
  return Point_3(x, y, z);
}

// A point a line, the source first; lines that are empty or begin with # do not count.
std::vector<Point_3> read_seeds(const std::string& file) {
  std::ifstream in(file);
  if (!in)
    throw tubular::Input_error("The file \"" + file + "\" cannot be read.");
  std::vector<Point_3> seeds;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number)
    if (line.find_first_not_of(" \t\r") != std::string::npos && line[0] != '#')
      seeds.push_back(point_of(line, "Line " + std::to_string(number) + " of \"" + file + "\""));
  return seeds;
}

std::vector<Point_3> seeds_of(const Options& o) {
  std::vector<Point_3> seeds;
  if (!o.seeds.empty())
    seeds = read_seeds(o.seeds);
  else if (!o.outlets.empty()) {
    if (o.inlet.empty())
      throw tubular::Parameter_error("--outlet needs --inlet, where the centerlines begin.");
    seeds.push_back(point_of(o.inlet[0], "--inlet"));
    for (const std::string& p : o.outlets)
      seeds.push_back(point_of(p, "--outlet"));
  }
  return seeds;
}

// Seeds tell where lines begin and end, also on a surface that has openings: these are closed first, if it is open.
Graph centerlines_between_seeds(const Options& o, Surface& surface, const std::vector<Point_3>& seeds) {
  if (seeds.size() < 2)
    throw tubular::Input_error("\"" + o.seeds + "\" holds " + std::to_string(seeds.size()) +
                               " points; give the source, and one or more targets.");
  if (!CGAL::is_closed(surface)) {
    std::vector<tubular::Opening<Point_3>> openings = tubular::find_openings(surface);
    const auto patch = surface.add_property_map<Surface::Face_index, int>("f:patch", 0).first;
    tubular::close_openings(surface, openings, patch);
  }
  Graph graph;
  tubular::compute_centerlines(surface, seeds, graph, tubular::parameters::loops(o.loops));
  return graph;
}

Graph centerlines_between_openings(const Options& o, Surface& surface) {
  std::vector<tubular::Opening<Point_3>> openings =
      o.inlet.empty() ? tubular::find_openings(surface)
                      : tubular::find_openings(surface, tubular::parameters::inlet(point_of(o.inlet[0], "--inlet")));
  const auto patch = surface.add_property_map<Surface::Face_index, int>("f:patch", 0).first;
  tubular::close_openings(surface, openings, patch);
  Graph graph;
  tubular::compute_centerlines(surface, patch, openings, graph, tubular::parameters::loops(o.loops));
  return graph;
}

void run(const Options& o) {
  if (!tubular::IO::is_supported_centerlines_format(o.output))
    throw tubular::Parameter_error("Centerlines cannot be written to \"" + o.output + "\": give a .vtp or .vtk file.");
  const std::vector<Point_3> seeds = seeds_of(o);
  Surface surface;
  tubular::IO::read_surface(o.surface, surface);
  const bool between_openings = o.seeds.empty() && o.outlets.empty();
  const Graph graph =
      between_openings ? centerlines_between_openings(o, surface) : centerlines_between_seeds(o, surface, seeds);
  if (o.whole)
    tubular::IO::write_centerlines(o.output, tubular::centerlines_from_root(graph));
  else
    tubular::IO::write_centerlines(o.output, tubular::branched_centerlines(graph));
  std::printf("%zu branches, %zu ends, %zu points\n", graph.branches().size(), graph.number_of_ends(),
              graph.points().size());
}

int fail(const std::string& sentence, Exit_status status) {
  std::fprintf(stderr, "compute_centerlines: %s\n", sentence.c_str());
  return status;
}

} // namespace

int main(int argc, char* argv[]) {
  Options o;
  CLI::App app("Computes the centerlines of a vessel or airway tree, with the radii of the inscribed spheres, from its "
               "triangulated surface.\nWritten as VMTK's branch extractor does: lines from the inlet to each outlet, "
               "cut into tracts, with CenterlineIds, TractIds, GroupIds and Blanking.");
  app.footer("Exit status: 0 done, 2 wrong usage, 3 input that cannot be read or used, 4 failed.");
  app.add_option("surface", o.surface, "surface, open at its ends or capped flat: .stl .off .obj .ply .vtp")
      ->required();
  app.add_option("-o,--output", o.output, "centerlines to write: .vtp .vtk")->required();
  auto* inlet =
      app.add_option("--inlet", o.inlet, "X,Y,Z: the opening nearest to this point is the inlet (default: the largest)")
          ->expected(1);
  auto* outlets =
      app.add_option("--outlet", o.outlets,
                     "X,Y,Z (repeatable): lines end here instead of at the openings; with --inlet, where they begin")
          ->expected(1)
          ->take_all();
  app.add_option("--seeds", o.seeds, "file with a point a line, the source first, instead of --inlet and --outlet")
      ->excludes(outlets)
      ->excludes(inlet);
  app.add_flag("--loops", o.loops, "keep every branch where vessels split and rejoin");
  app.add_flag("--whole", o.whole, "write each line in one piece, without the cell arrays");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? done : wrong_usage;
  }
  try {
    run(o);
    return done;
  } catch (const tubular::Parameter_error& e) {
    return fail(e.what(), wrong_usage);
  } catch (const tubular::Input_error& e) {
    return fail(e.what(), unusable_input);
  } catch (const tubular::Error& e) {
    return fail(e.what(), failed);
  } catch (const std::bad_alloc&) {
    return fail("There is not enough memory.", failed);
  } catch (const std::exception& e) {
    return fail(e.what(), failed);
  }
}
