// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Attaches straight tubes to the openings of a vessel:  flow_extensions SURFACE OUT [LENGTH [OPENING...]]
// LENGTH is in radii of each opening (5 by default); OPENING are the numbers of the openings to extend (all by default,
// 0 is the inlet). The extension of OUT names its format: .stl, .off, .obj, .ply, .vtp, .vtk or .msh.

#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/IO/write_surface.h>
#include <CGAL/Tubular_meshing/Openings/flow_extensions.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <numeric>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Surface;

namespace Tubular = CGAL::Tubular_meshing;

// Numbers given on the command line, or else all openings.
std::vector<std::size_t> chosen(char** begin, char** end, std::size_t number_of_openings) {
  std::vector<std::size_t> indices;
  for (char** word = begin; word < end; ++word)
    indices.push_back(std::strtoul(*word, nullptr, 10));
  if (indices.empty()) {
    indices.resize(number_of_openings);
    std::iota(indices.begin(), indices.end(), std::size_t(0));
  }
  return indices;
}

int main(int argc, char* argv[]) {
  if (argc < 3) {
    std::cerr << "usage: flow_extensions SURFACE OUT [LENGTH [OPENING...]]\n";
    return 2;
  }
  const double length = argc > 3 ? std::atof(argv[3]) : 5;
  try {
    Surface surface;
    Tubular::IO::read_surface(argv[1], surface);
    std::vector<Tubular::Opening> openings = Tubular::find_openings(surface);
    const std::vector<double> lengths =
        Tubular::add_flow_extensions(surface, openings,
                                     Tubular::parameters::extension_length(length).extended_openings(
                                         chosen(argv + 4, argv + argc, openings.size())));
    Tubular::IO::write_surface(argv[2], surface);

    const Tubular::Label_names names = Tubular::lumen_patch_names(int(openings.size()));
    std::cout << std::left << std::setw(12) << "opening" << std::setw(14) << "radius" << std::setw(14) << "extended by"
              << "center\n";
    for (std::size_t i = 0; i < openings.size(); ++i)
      std::cout << std::setw(12) << names.at(openings[i].patch) << std::setw(14) << openings[i].radius << std::setw(14)
                << lengths[i] << openings[i].center << "\n";
  } catch (const Tubular::Output_error& error) {
    std::cerr << error.what() << "\n";
    return 4;
  } catch (const Tubular::Error& error) {
    std::cerr << error.what() << "\n";
    return 3;
  }
  return 0;
}
