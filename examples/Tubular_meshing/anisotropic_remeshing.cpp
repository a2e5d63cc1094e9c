// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Any tetrahedral mesh, remeshed to a metric that is written in a few lines: flat elements along a plane through the
// middle of the model, as a shock or a contact surface would ask for.

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Tubular_meshing/IO/read_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Volume/anisotropic_tetrahedral_remeshing.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
namespace TM = CGAL::Tubular_meshing;

// A model of MetricField_3: sizes grow with the distance from a plane, across it, and are the same along it.
struct Layer_metric {
  Point_3 origin;
  Vector_3 normal;
  double thin, wide;

  TM::Metric_tensor_3 operator()(const Point_3& p) const {
    const double distance = std::abs((p - origin) * normal);
    const double across = (std::min)(thin + 0.3 * distance, wide);
    const Vector_3 u = std::abs(normal.x()) < 0.8 ? Vector_3(1, 0, 0) : Vector_3(0, 1, 0);
    Vector_3 v = CGAL::cross_product(normal, u);
    v = v / std::sqrt(v.squared_length());
    return TM::Metric_tensor_3::from_sizes(std::array<double, 3>{across, wide, wide},
                                           std::array<Vector_3, 3>{normal, v, CGAL::cross_product(normal, v)});
  }
};

int main(int argc, char* argv[]) {
  if (argc != 3) {
    std::cerr << "usage: " << argv[0] << " MESH OUTPUT.vtu|.msh|.mesh\n";
    return EXIT_FAILURE;
  }
  try {
    TM::Mixed_mesh mesh;
    TM::IO::read_mesh(argv[1], mesh);
    CGAL::Bbox_3 box;
    for (const Point_3& p : mesh.points)
      box += p.bbox();
    const Point_3 center((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2, (box.zmin() + box.zmax()) / 2);
    const double extent = (std::max)({box.x_span(), box.y_span(), box.z_span()});
    const Layer_metric metric = {center, Vector_3(0, 0, 1), extent / 400, extent / 20};

    TM::anisotropic_tetrahedral_remeshing(mesh, metric);

    const TM::Quality_report quality = TM::quality_report(mesh);
    std::cout << mesh.tetrahedra.size() << " tetrahedra, Q " << quality.Q_tau.mean() << " on average, at most "
              << quality.Q_tau.max() << "; efficiency " << quality.efficiency << "\n";
    TM::IO::write_mesh(argv[2], mesh);
  } catch (const TM::Error& e) {
    std::cerr << e.what() << "\n";
    return EXIT_FAILURE;
  }
}
