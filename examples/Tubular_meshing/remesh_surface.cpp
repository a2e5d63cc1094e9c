// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes a tubular surface anew, patch by patch in the parametric plane, with triangles of a size of one's own choice:
// here, a number of points round each vessel, and twice as many at the inlet.

#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/IO/write_surface.h>
#include <CGAL/Tubular_meshing/Patches/cut_by_centerlines.h>
#include <CGAL/Tubular_meshing/Patches/parameterize_patch.h>
#include <CGAL/Tubular_meshing/Patches/remesh_patches.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Surface;
namespace tubular = CGAL::Tubular_meshing;

int main(int argc, char* argv[]) {
  if (argc != 3) {
    std::cerr << "usage: remesh_surface SURFACE OUTPUT.vtp\n";
    return 2;
  }
  try {
    Surface surface;
    tubular::IO::read_surface(argv[1], surface);
    auto model = tubular::make_tubular_model(surface);
    const auto cut = tubular::cut_by_centerlines(model.surface, model.centerlines, model.patch);
    const auto maps = tubular::parameterize_patches(model.surface, cut);

    const tubular::Centerline_sizing_field by_radius(
        tubular::Centerline_field(model.centerlines),
        tubular::Wall_distance(model.surface, model.patch, tubular::labels::wall),
        tubular::parameters::points_per_circumference(20));
    const auto& inlet = model.openings.front();
    const auto size = [&](const Point_3& p) {
      const double away = std::sqrt(CGAL::squared_distance(p, inlet.center)) / inlet.radius;
      return by_radius(p) * std::min(1., 0.5 + 0.1 * away);
    };
    const auto remeshed = tubular::remesh_patches(model.surface, cut, maps, size);

    std::cout << remeshed.surface.number_of_faces() << " triangles on " << cut.patches.size() << " patches, "
              << remeshed.report.number_of_fallbacks() << " of them not mapped conformally\n";
    tubular::IO::write_surface(
        argv[2], remeshed.surface,
        tubular::parameters::face_patch_map(remeshed.patch).surface_patch_map(remeshed.patch_of_face));
  } catch (const std::exception& e) {
    std::cerr << "remesh_surface: " << e.what() << "\n";
    return 1;
  }
}
