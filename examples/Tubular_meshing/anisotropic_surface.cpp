// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes a tubular surface anew with triangles that are long along the vessels, first by the metric of a boundary
// layer, then by one of one's own: a fixed number of points round each vessel, and edges along it that are thrice as
// long.

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/Patches/metric_surface_report.h>
#include <CGAL/Tubular_meshing/Patches/surface_to_mixed_mesh.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Pipelines/make_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_utils.h>

#include <array>
#include <exception>
#include <iostream>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
typedef CGAL::Surface_mesh<Point_3> Surface;
namespace tubular = CGAL::Tubular_meshing;

void write(const std::string& file, const tubular::Remeshed_surface& remeshed) {
  const tubular::Metric_fit fit = tubular::metric_surface_report(remeshed).wall;
  std::cout << file << ": " << remeshed.surface.number_of_faces()
            << " triangles; on the wall their shape in the metric "
            << "is " << fit.shape.mean() << " on average, and " << 100 * fit.share_of_unit_edges()
            << " % of the edges have unit length\n";
  tubular::Mixed_mesh mesh;
  tubular::surface_to_mixed_mesh(remeshed, mesh);
  tubular::IO::write_mesh(file, mesh);
}

int main(int argc, char* argv[]) {
  if (argc != 4) {
    std::cerr << "usage: anisotropic_surface SURFACE BY_LAYER.vtu BY_RADIUS.vtu\n";
    return 2;
  }
  try {
    Surface surface;
    tubular::IO::read_surface(argv[1], surface);
    auto model = tubular::make_tubular_model(surface);
    write(argv[2], tubular::make_anisotropic_surface_mesh(model, tubular::parameters::first_height(0.02)));

    const tubular::Centerline_field lines(model.centerlines);
    const auto metric = [&](const Point_3& p) {
      const auto frame = lines.frame(p);
      const double around = 2 * CGAL_PI * lines.radius(p) / 20;
      return tubular::Metric_tensor_3::from_sizes({around, around, 3 * around},
                                                  std::array<Vector_3, 3>{frame.e_n, frame.e_bn, frame.e_t});
    };
    const auto cut = tubular::cut_by_centerlines(model.surface, model.centerlines, model.patch);
    const auto maps = tubular::parameterize_patches(model.surface, cut);
    write(argv[3], tubular::remesh_patches(model.surface, cut, maps, metric));
  } catch (const std::exception& e) {
    std::cerr << "anisotropic_surface: " << e.what() << "\n";
    return 1;
  }
}
