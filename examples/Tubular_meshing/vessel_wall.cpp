// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The meshes of fluid-structure interaction: tetrahedra in the lumen, prisms in a wall of two parts around it (a fifth
// of the local radius, in four layers, and half as much in two), and on the inside of the wall boundary layers for the
// flow. Interfaces, openings and the wall's ends are labelled. A second file has the wall alone.

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/Layers/extrude_wall.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Layers/extrude_boundary_layer.h>
#include <CGAL/Tubular_meshing/Volume/fill_keeping_boundary.h>
#include <CGAL/Tubular_meshing/Volume/optimize_tetrahedra.h>
#include <CGAL/Tubular_meshing/Pipelines/make_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <exception>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
namespace tubular = CGAL::Tubular_meshing;

int main(int argc, char* argv[]) {
  if (argc != 4) {
    std::cerr << "usage: vessel_wall SURFACE OUTPUT.vtu WALL_ALONE.vtu\n";
    return 2;
  }
  try {
    CGAL::Surface_mesh<Point_3> input;
    tubular::IO::read_surface(argv[1], input);
    const auto model = tubular::make_tubular_model(input);
    const auto surface = tubular::make_isotropic_surface_mesh(model);
    const tubular::Centerline_field centerlines(model.centerlines);

    // the lumen: seven layers of prisms along the wall, tetrahedra inside of them
    auto lumen = tubular::extrude_boundary_layer(surface.surface, surface.patch, centerlines);
    const tubular::Centerline_sizing_field size(
        centerlines, tubular::Wall_distance(model.surface, model.patch, tubular::labels::wall));
    tubular::Mixed_mesh inside;
    tubular::fill_keeping_boundary(lumen.inner, lumen.patch, size, inside);
    tubular::optimize_tetrahedra(inside, lumen.inner, lumen.patch, tubular::parameters::keep_boundary(true));
    tubular::Mixed_mesh& mesh = lumen.layers;
    tubular::append_mesh(mesh, inside, lumen.mesh_points);

    // the wall: media and adventitia
    const auto two_walls =
        tubular::parameters::wall_thickness(0.2).wall_layers(4).second_wall_thickness(0.1).second_wall_layers(2);
    const auto report = tubular::extrude_wall(mesh, centerlines, two_walls);
    std::cout << report.text() << "\n";

    const tubular::Validity_report validity = tubular::validity_report(mesh);
    std::cout << validity.cells << " cells in " << validity.region_components.size() << " regions, "
              << (validity.is_valid() ? "valid" : validity.defects()) << "\n";
    tubular::IO::write_mesh(argv[2], mesh);

    tubular::IO::write_mesh(argv[3],
                            tubular::extrude_wall(surface.surface, surface.patch, centerlines, two_walls).mesh);
  } catch (const std::exception& e) {
    std::cerr << "vessel_wall: " << e.what() << "\n";
    return 1;
  }
}
