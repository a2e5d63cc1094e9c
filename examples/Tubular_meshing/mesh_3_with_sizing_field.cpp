// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The centerline sizing field with a plain Mesh_3 domain: Mesh_3's users keep their own pipeline, and only take the
// size.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/make_mesh_3.h>

#include <fstream>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Surface;
typedef CGAL::Polyhedral_mesh_domain_3<Surface, Kernel> Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type Triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation> C3t3;
namespace TM = CGAL::Tubular_meshing;

int main(int argc, char* argv[]) {
  if (argc != 4) {
    std::cerr << "usage: " << argv[0] << " SURFACE CENTERLINES OUTPUT.mesh\n";
    return 1;
  }
  Surface surface;
  TM::Centerline_polylines lines;
  TM::IO::read_surface(argv[1], surface);
  TM::IO::read_centerlines(argv[2], lines);
  const TM::Tubular_model model = TM::make_tubular_model(surface, lines);

  const TM::Centerline_sizing_field size(TM::Centerline_field(model.centerlines),
                                         TM::Wall_distance(model.surface, model.patch, TM::labels::wall),
                                         TM::parameters::points_per_circumference(20));
  const Domain domain(model.surface);
  const CGAL::Mesh_criteria_3<Triangulation> criteria(
      CGAL::parameters::facet_angle = 25, CGAL::parameters::facet_size = size, CGAL::parameters::cell_size = size);
  const C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria);

  std::cout << c3t3.number_of_cells_in_complex() << " tetrahedra\n";
  std::ofstream out(argv[3]);
  c3t3.output_to_medit(out);
}
