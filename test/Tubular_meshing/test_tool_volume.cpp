// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// tubular_mesh keeps the volume of the surface, and reports it.

#include "test_tool_helpers.h"

#include <CGAL/Tubular_meshing/Quads/blossom_recombination.h>
#include <CGAL/Tubular_meshing/Quality/lumen_measures.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>

#include <gtest/gtest.h>

#include <string>

#ifdef TUBULAR_MESH_TOOL

namespace {

using namespace tool_test;

std::string fine_y(const Tool& t) {
  tubular::Surface surface;
  tubular::generate_tubular_surface(tubular::y_bifurcation(), surface,
                                    tubular::parameters::points_per_circumference(60));
  return t.make("y.off", surface);
}

TEST_F(Tool, Keeps_the_volume_of_the_surface) {
  const std::string input = fine_y(*this);
  for (const std::string type : {"isotropic", "anisotropic", "mixed"}) {
    if (type == "mixed" &&
        (!tubular::has_lemon() || tubular::default_volume_mesher() == tubular::Volume_mesher::mesh_3))
      continue;
    const Outcome outcome = succeed({input, "-t", type, "-n", "12", "--curvature-points", "12", "--first-height",
                                     "0.06", "--wall", "0.2", "-o", out("mesh.vtu"), "--report", out("r.json")});
    const Json r = json_in(out("r.json"));
    EXPECT_NEAR(r["volume"]["relative_difference"].get<double>(), 0, 0.002) << type;
    EXPECT_EQ(r["volume"]["preserved"], true);
    EXPECT_LT(r["volume"]["before"].get<double>(), 0.995 * r["volume"]["input"].get<double>()) << type;
    EXPECT_EQ(r["volume"]["vertices_held_back"], 0) << type;
    EXPECT_NE(outcome.out.find("volume: "), std::string::npos);
    const Mesh mesh = mesh_in(out("mesh.vtu"));
    EXPECT_EQ(tubular::validity_report(mesh).defects(), "") << type;
    const auto measures = tubular::lumen_measures(mesh, 3);
    EXPECT_NEAR(measures.volume, r["volume"]["mesh"].get<double>(), 1e-6 * measures.volume);
    for (const Json& o : r["openings"]) {
      EXPECT_NEAR(o["mesh_area"].get<double>() / o["area"].get<double>(), 1, 0.003) << type;
      EXPECT_NEAR(o["mesh_area"].get<double>(), measures.opening_area.at(o["patch"].get<int>()), 1e-6);
    }
  }
}

TEST_F(Tool, Leaves_the_wall_on_the_surface_if_that_is_wanted) {
  const std::string input = fine_y(*this);
  succeed({input, "-n", "12", "--no-preserve-volume", "-o", out("mesh.vtu"), "--report", out("r.json")});
  const Json r = json_in(out("r.json"));
  EXPECT_EQ(r["volume"]["preserved"], false);
  EXPECT_TRUE(r["volume"]["before"].is_null());
  EXPECT_LT(r["volume"]["relative_difference"].get<double>(), -0.015);
  EXPECT_FALSE(r["times"].contains("volume"));
  succeed({input, "-n", "12", "--preserve-volume", "-t", "surface", "-o", out("s.stl"), "--report", out("r.json")});
  EXPECT_NEAR(json_in(out("r.json"))["volume"]["relative_difference"].get<double>(), 0, 0.002);
}

} // namespace

#endif // TUBULAR_MESH_TOOL
