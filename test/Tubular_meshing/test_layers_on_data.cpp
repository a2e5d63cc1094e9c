// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Walls and boundary layers of vessels as they come: touching ones, aneurysms, crotches, loops.

#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Layers/extrude_wall.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/Patches/surface_to_mixed_mesh.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Layers/extrude_boundary_layer.h>
#include <CGAL/Tubular_meshing/Volume/fill_keeping_boundary.h>
#include <CGAL/Tubular_meshing/Volume/optimize_tetrahedra.h>
#include <CGAL/Tubular_meshing/Pipelines/make_mesh.h>

#include "test_surfaces.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <string>

namespace {

namespace tubular = CGAL::Tubular_meshing;
namespace parameters = tubular::parameters;
using test_surfaces::Point;
typedef CGAL::Surface_mesh<Point> Surface;
typedef tubular::Mixed_mesh Mesh;

struct Vessel {
  const char *name, *surface, *centerlines;
  double points; // per circumference
};

class Layers_on_data : public ::testing::TestWithParam<Vessel> {};

#ifdef TUBULAR_MESHING_SHARED_DATA
tubular::Tubular_model model_of(const Vessel& vessel) {
  const std::string folder = TUBULAR_MESHING_SHARED_DATA;
  Surface surface;
  tubular::IO::read_surface(folder + vessel.surface, surface);
  tubular::repair_surface(surface);
  if (!vessel.centerlines)
    return tubular::make_tubular_model(surface);
  tubular::Centerline_polylines lines;
  tubular::IO::read_centerlines(folder + vessel.centerlines, lines);
  return tubular::make_tubular_model(surface, lines);
}
#endif

} // namespace

TEST_P(Layers_on_data, Are_valid) {
#ifndef TUBULAR_MESHING_SHARED_DATA
  GTEST_SKIP() << GetParam().name << ": no measurement data";
#else
  const auto model = model_of(GetParam());
  const auto surface =
      tubular::make_isotropic_surface_mesh(model, parameters::points_per_circumference(GetParam().points));
  const tubular::Centerline_field centerlines(model.centerlines);

  for (double thickness : {0.2, 0.5}) { // the wall alone
    const auto wall =
        tubular::extrude_wall(surface.surface, surface.patch, centerlines, parameters::wall_thickness(thickness));
    const auto validity = tubular::validity_report(wall.mesh);
    EXPECT_TRUE(validity.is_valid()) << validity.defects();
    EXPECT_GT(wall.report.mean_ratio, 0.95);
    EXPECT_GT(wall.report.min_ratio, 0);
    EXPECT_GT(tubular::quality_report(wall.mesh).prism_jacobian.percentile(1), 0.3);
  }

  auto lumen = tubular::extrude_boundary_layer(surface.surface, surface.patch, centerlines);
  EXPECT_TRUE(CGAL::is_closed(lumen.inner));
  EXPECT_GT(lumen.report.mean_ratio, 0.95);
  Mesh& mesh = lumen.layers;
  if (!tubular::has_tetgen())
    return;
  const tubular::Centerline_sizing_field size(centerlines,
                                              tubular::Wall_distance(model.surface, model.patch, tubular::labels::wall),
                                              parameters::points_per_circumference(GetParam().points));
  Mesh inside;
  tubular::fill_keeping_boundary(lumen.inner, lumen.patch, size, inside);
  tubular::optimize_tetrahedra(inside, lumen.inner, lumen.patch, parameters::keep_boundary(true));
  tubular::append_mesh(mesh, inside, lumen.mesh_points);
  tubular::extrude_wall(mesh, centerlines, parameters::tetrahedral_wall(true));
  const auto validity = tubular::validity_report(mesh);
  EXPECT_TRUE(validity.is_valid()) << validity.defects();
  EXPECT_EQ(validity.region_components, (std::map<int, std::size_t>{{1, 1}, {2, 1}}));
#endif
}

INSTANTIATE_TEST_SUITE_P(Vessels, Layers_on_data,
                         ::testing::Values(Vessel{"aorta", "/paper/aorta.stl", "/paper/centerlinesAORTA.vtk", 16},
                                           Vessel{"carotid", "/paper/carotid.stl", "/paper/centerlinesCAROTID.vtk", 16},
                                           Vessel{"cerebral", "/paper/cerebral.stl", "/paper/centerlinesCEREBRAL.vtk",
                                                  14},
                                           Vessel{"bypass", "/paper/bypass.stl", "/paper/centerlinesBYPASS.msh", 16},
                                           Vessel{"carotids", "/trees/sofa_carotids.stl", nullptr, 16}),
                         [](const ::testing::TestParamInfo<Vessel>& info) { return std::string(info.param.name); });
