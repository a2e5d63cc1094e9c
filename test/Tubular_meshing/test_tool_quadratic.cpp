// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// tubular_mesh --order 2: what it makes, and what it reports.

#include "test_tool_helpers.h"

#include <CGAL/Tubular_meshing/Volume/Volume_mesher.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#ifdef TUBULAR_MESH_TOOL

namespace {

using namespace tool_test;

TEST_F(Tool, Makes_quadratic_elements_that_are_as_round_as_the_vessel) {
  tubular::Surface surface;
  tubular::generate_tubular_surface(tubular::straight_tube(6, 1), surface,
                                    tubular::parameters::points_per_circumference(24));
  const std::string input = make("tube.off", surface);
  const double exact = 6 * CGAL_PI;
  for (const std::string type : {"isotropic", "hexahedral"}) {
    if (type == "isotropic" && tubular::default_volume_mesher() == tubular::Volume_mesher::mesh_3)
      continue;
    const Outcome outcome =
        succeed({input, "-t", type, "-n", "12", "--order", "2", "-o", out("mesh.vtu"), "--report", out("r.json")});
    const Json r = json_in(out("r.json"));
    EXPECT_EQ(r["order"], 2);
    EXPECT_EQ(r["valid"], true);
    EXPECT_NEAR(r["volume"]["mesh"].get<double>() / exact, 1, 5e-4);
    EXPECT_EQ(r["volume"]["preserved"], false);
    for (const Json& o : r["openings"])
      EXPECT_NEAR(o["mesh_area"].get<double>() / CGAL_PI, 1, 5e-4);
    const Json& q = r["quadratic"];
    EXPECT_EQ(q["complete"], false);
    EXPECT_GT(r["points"].get<long>(), 3 * q["corners"].get<long>()); // about as many edges as that
    EXPECT_EQ(q["invalid"], 0);
    EXPECT_EQ(q["unproved"], 0);
    EXPECT_GT(q["scaled_jacobian"]["cells"]["min"].get<double>(), 0.05);
    EXPECT_EQ(q["scaled_jacobian"]["cells"]["count"].get<long>(),
              r["cells"]["tetrahedra"].get<long>() + r["cells"]["hexahedra"].get<long>());
    EXPECT_NE(outcome.out.find("order 2: Every cell is valid"), std::string::npos) << outcome.out;
    EXPECT_NE(bytes_of(out("mesh.vtu")).find("NumberOfPoints=\"" + std::to_string(r["points"].get<long>())),
              std::string::npos);
  }
}

TEST_F(Tool, Makes_complete_elements_with_walls_and_layers) {
  const Arguments options = {"-n", "8",          "--order",    "2",   "--order-2-complete",
                             "-t", "hexahedral", "--wall",     "0.2", "--boundary-layer-prisms",
                             "3",  "--report",   out("r.json")};
  succeed(run_to(*this, out("mesh.msh")) + options);
  const Json r = json_in(out("r.json"));
  EXPECT_EQ(r["valid"], true);
  EXPECT_EQ(r["quadratic"]["complete"], true);
  EXPECT_EQ(r["quadratic"]["straightened"], 0);
}

TEST_F(Tool, Elements_of_first_order_are_what_they_were) {
  const Arguments options = {"-n", "8", "--report", out("r.json")};
  succeed(run_to(*this, out("a.vtu")) + options);
  EXPECT_FALSE(json_in(out("r.json")).contains("quadratic"));
  succeed(run_to(*this, out("b.vtu")) + options + Arguments{"--order", "1"});
  EXPECT_EQ(bytes_of(out("a.vtu")), bytes_of(out("b.vtu")));
}

} // namespace

#endif // TUBULAR_MESH_TOOL
