// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The wall of a vessel alone, in layers of hexahedra, as an input deck for CalculiX or Abaqus:
// solvers/calculix_wall.py computes what the pressure of the blood does to it.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/Layers/extrude_wall.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Pipelines/make_mesh.h>

#include <cstdlib>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
namespace TM = CGAL::Tubular_meshing;

int main(int argc, char* argv[]) {
  if (argc < 3 || argc > 4) {
    std::cerr << "usage: " << argv[0] << " SURFACE OUTPUT.inp [POINTS_PER_CIRCUMFERENCE]\n";
    return EXIT_FAILURE;
  }
  try {
    CGAL::Surface_mesh<Point_3> surface;
    TM::IO::read_surface(argv[1], surface);
    TM::repair_surface(surface);
    const auto model = TM::make_tubular_model(surface);
    const double points = argc > 3 ? std::atof(argv[3]) : 20;
    const auto quads = TM::make_quad_surface_mesh(model, TM::parameters::points_per_circumference(points));

    const TM::Centerline_field centerlines(model.centerlines);
    const TM::Extruded_wall wall =
        TM::extrude_wall(quads.surface, quads.patch, centerlines, TM::parameters::wall_thickness(0.2).wall_layers(4));
    std::cout << wall.mesh.hexahedra.size() << " hexahedra. " << wall.report.text() << "\n";
    TM::IO::write_mesh(argv[2], wall.mesh);
  } catch (const TM::Error& e) {
    std::cerr << e.what() << "\n";
    return EXIT_FAILURE;
  }
}
