// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes the wall of a tubular surface with quads alone: structured grids on the vessels, unstructured quads where they
// meet. The openings are closed with triangles.

#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/IO/write_surface.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Pipelines/make_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <exception>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Surface;
namespace tubular = CGAL::Tubular_meshing;

int main(int argc, char* argv[]) {
  if (argc != 3 && argc != 4) {
    std::cerr << "usage: quad_surface SURFACE OUTPUT.vtp [POINTS_PER_CIRCUMFERENCE]\n";
    return 2;
  }
  try {
    Surface surface;
    tubular::IO::read_surface(argv[1], surface);
    tubular::repair_surface(surface);
    const auto model = tubular::make_tubular_model(surface);
    const double points = argc == 4 ? std::atof(argv[3]) : 20;
    const auto mesh =
        tubular::make_quad_surface_mesh(model, tubular::parameters::points_per_circumference(points).quad_caps(false));

    const tubular::Quad_report& quads = mesh.quads;
    std::cout << quads.wall_quads() << " quads, of them " << quads.structured_quads << " in grids; "
              << quads.irregular_vertices << " irregular vertices; eta_q at least " << quads.least_eta << ", "
              << quads.mean_eta << " on the mean\n";
    tubular::IO::write_surface(argv[2], mesh.surface,
                               tubular::parameters::face_patch_map(mesh.patch).surface_patch_map(mesh.patch_of_face));
  } catch (const std::exception& e) {
    std::cerr << "quad_surface: " << e.what() << "\n";
    return 1;
  }
}
