// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Closes the open ends of a tubular surface by planar caps:  close_openings SURFACE [OUT.ply]
// The file written holds, for each face, the label of its patch: 1 wall, 2 inlet, 3 and on the outlets.

#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Openings/close_openings.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <fstream>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Surface;

namespace Tubular = CGAL::Tubular_meshing;

void print(const std::vector<Tubular::Opening>& openings) {
  const Tubular::Label_names names = Tubular::lumen_patch_names(static_cast<int>(openings.size()));
  std::cout << std::left << std::setw(7) << "patch" << std::setw(12) << "name" << std::setw(14) << "radius"
            << std::setw(14) << "area"
            << "center\n";
  for (const Tubular::Opening& o : openings)
    std::cout << std::setw(7) << o.patch << std::setw(12) << names.at(o.patch) << std::setw(14) << o.radius
              << std::setw(14) << o.area << o.center << "\n";
}

int main(int argc, char* argv[]) {
  if (argc < 2) {
    std::cerr << "usage: close_openings SURFACE [OUT.ply]\n";
    return 2;
  }
  Surface surface;
  try {
    Tubular::IO::read_surface(argv[1], surface);
    std::vector<Tubular::Opening> openings = Tubular::find_openings(surface);
    auto patch = surface.add_property_map<Surface::Face_index, int>("f:patch", 0).first;
    Tubular::close_openings(surface, openings, patch);
    print(openings);
  } catch (const Tubular::Error& error) {
    std::cerr << error.what() << "\n";
    return 3;
  }
  if (argc < 3)
    return 0;
  std::ofstream out(argv[2], std::ios::binary);
  out.precision(17);
  if (!CGAL::IO::write_PLY(out, surface)) {
    std::cerr << argv[2] << " cannot be written.\n";
    return 4;
  }
  return 0;
}
