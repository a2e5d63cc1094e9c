// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A Riemannian metric with a plain Mesh_3 domain: the cells are isotropic, and no longer in the metric than a unit mesh
// allows. The metric is kept mild, for an isotropic mesh has as many cells as its smallest sizes ask for.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_metric_field.h>
#include <CGAL/Tubular_meshing/Fields/Metric_criteria_3.h>
#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/make_mesh_3.h>

#include <algorithm>
#include <fstream>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Surface;
typedef CGAL::Polyhedral_mesh_domain_3<Surface, Kernel> Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type Triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation> C3t3;
namespace TM = CGAL::Tubular_meshing;
typedef TM::Centerline_metric_field Metric_field;
typedef TM::Metric_mesh_criteria_3<Triangulation, Metric_field> Criteria;

// The longest edge of the mesh in the metric.
double longest_edge(const C3t3& c3t3, const Metric_field& metric) {
  double longest = 0;
  for (auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j) {
        const Point_3 p = c->vertex(j)->point().point(), q = c->vertex(i)->point().point();
        longest = std::max(longest, TM::Metric_tensor_3::edge_length(q - p, metric(p), metric(q)));
      }
  return longest;
}

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

  const Metric_field metric(model.surface, model.patch, model.centerlines,
                            TM::parameters::first_height(0.15).max_anisotropy(3.));
  const Domain domain(model.surface);
  const Criteria criteria(Criteria::Facet_criteria(CGAL::Mesh_facet_criteria_3<Triangulation>(25, 0, 0), metric),
                          Criteria::Cell_criteria(CGAL::Mesh_cell_criteria_3<Triangulation>(2, 0), metric));
  const C3t3 c3t3 =
      CGAL::make_mesh_3<C3t3>(domain, criteria, CGAL::parameters::no_perturb(), CGAL::parameters::no_exude());

  std::cout << c3t3.number_of_cells_in_complex() << " tetrahedra, the longest edge " << longest_edge(c3t3, metric)
            << " in the metric\n";
  std::ofstream out(argv[3]);
  c3t3.output_to_medit(out);
}
