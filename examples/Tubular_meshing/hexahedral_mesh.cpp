// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// From a surface to a mesh of hexahedra alone: of the lumen, with layers along its wall, and of the wall around it.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/Pipelines/make_mesh.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>

#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
namespace TM = CGAL::Tubular_meshing;

int main(int argc, char* argv[]) {
  if (argc != 3) {
    std::cerr << "usage: " << argv[0] << " SURFACE OUTPUT.vtu|.msh|.mesh|.inp\n";
    return EXIT_FAILURE;
  }
  try {
    CGAL::Surface_mesh<Point_3> surface;
    TM::IO::read_surface(argv[1], surface);
    std::cout << TM::repair_surface(surface).text();

    TM::Mesher mesher(surface, TM::parameters::points_per_circumference(20)
                                   .boundary_layer_prisms(4)
                                   .boundary_layer_thickness(0.3)
                                   .first_height(0.05)
                                   .wall_thickness(0.2)
                                   .wall_layers(2));
    const TM::Mixed_mesh mesh = mesher.hexahedral();

    for (const std::string& sentence : mesher.report().fallbacks)
      std::cout << sentence << "\n";
    const TM::Quality_report quality = TM::quality_report(mesh);
    std::cout << mesh.hexahedra.size() << " hexahedra, made by " << TM::name_of(mesher.report().hexahedral.method)
              << ", of quality " << quality.zeta_H.min() << " at least, " << quality.zeta_H.mean() << " on average\n";
    TM::IO::write_mesh(argv[2], mesh);
  } catch (const TM::Error& e) {
    std::cerr << e.what() << "\n";
    return EXIT_FAILURE;
  }
}
