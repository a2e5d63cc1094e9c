// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// From a surface to a mesh of isotropic tetrahedra: repaired in one call, meshed in another. Centerlines are computed
// where they are not given.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/tubular_meshing.h>

#include <cstdlib>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
namespace TM = CGAL::Tubular_meshing;

int main(int argc, char* argv[]) {
  if (argc < 3 || argc > 4) {
    std::cerr << "usage: " << argv[0] << " SURFACE OUTPUT.vtu|.msh|.mesh [CENTERLINES]\n";
    return EXIT_FAILURE;
  }
  try {
    CGAL::Surface_mesh<Point_3> surface;
    TM::IO::read_surface(argv[1], surface);
    std::cout << TM::repair_surface(surface).text();

    const auto np = TM::parameters::points_per_circumference(16).gradation(1.2);
    TM::Mixed_mesh mesh;
    if (argc == 3) {
      mesh = TM::make_isotropic_mesh(surface, np);
    } else {
      TM::Centerline_polylines lines;
      TM::IO::read_centerlines(argv[3], lines);
      mesh = TM::make_isotropic_mesh(surface, lines, np);
    }

    const TM::Quality_report quality = TM::quality_report(mesh);
    std::cout << mesh.tetrahedra.size() << " tetrahedra of quality " << quality.gamma_tau.min() << " to "
              << quality.gamma_tau.max() << ", on average " << quality.gamma_tau.mean() << "\n";
    TM::IO::write_mesh(argv[2], mesh);
  } catch (const TM::Error& e) {
    std::cerr << e.what() << "\n";
    return EXIT_FAILURE;
  }
}
