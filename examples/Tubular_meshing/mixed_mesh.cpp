// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// From a surface to a mesh of mixed cells: hexahedra in the vessel's wall, and on the same quads pyramids in the lumen,
// with tetrahedra between them.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Pipelines/make_mesh.h>

#include <cstdlib>
#include <iostream>

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

    const TM::Mixed_mesh mesh =
        TM::make_mixed_mesh(surface, TM::parameters::points_per_circumference(20).wall_thickness(0.2).wall_layers(4));

    const TM::Quality_report quality = TM::quality_report(mesh);
    const auto print = [](std::size_t n, const char* cells, const TM::Measure_statistics& s) {
      std::cout << n << " " << cells << " of quality " << s.min() << " at least, " << s.mean() << " on average\n";
    };
    print(mesh.hexahedra.size(), "hexahedra", quality.zeta_H);
    print(mesh.pyramids.size(), "pyramids", quality.pyramid_jacobian);
    print(mesh.tetrahedra.size(), "tetrahedra", quality.gamma_tau);
    TM::IO::write_mesh(argv[2], mesh);
  } catch (const TM::Error& e) {
    std::cerr << e.what() << "\n";
    return EXIT_FAILURE;
  }
}
