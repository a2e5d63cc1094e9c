// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line tool and sizes that its user wants: places, branches, arrays, numbers of elements.

#include "test_tool_helpers.h"
#include "test_tool_report.h"

#include <CGAL/Tubular_meshing/IO/write_surface.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#ifdef TUBULAR_MESH_TOOL

namespace {

using namespace tool_test;

std::size_t cells(const Json& report) {
  std::size_t n = 0;
  for (const auto& kind : report["cells"].items())
    n += kind.value().get<std::size_t>();
  return n;
}

TEST_F(Tool, Has_the_number_of_elements_that_was_asked_for) {
  const std::string surface = make("y.off", bifurcation().surface);
  std::vector<Arguments> types = {{}, {"-t", "surface"}};
  if (tubular::default_volume_mesher() != tubular::Volume_mesher::mesh_3)
    for (const Arguments& more : std::vector<Arguments>{{"-t", "mixed", "--wall", "0.2"},
                                                        {"--boundary-layer-prisms", "3"},
                                                        {"--wall", "0.3", "--wall-elements", "tetrahedra"}})
      types.push_back(more);
  for (const Arguments& type : types) {
    const bool is_surface = type.size() == 2 && type[1] == "surface";
    succeed(Arguments{surface, "--elements", "20000", "-o", out(is_surface ? "m.vtp" : "m.vtu"), "--report",
                      out("r.json")} +
            type);
    const Json report = json_in(out("r.json"));
    const std::size_t n = is_surface ? report["facets"]["triangles"].get<std::size_t>() : cells(report);
    EXPECT_NEAR(double(n), 20000., 2000.) << (type.empty() ? "isotropic" : type[1]);
    EXPECT_NE(report["points_per_circumference"].get<double>(), 20);
  }
}

TEST_F(Tool, Refines_where_it_was_asked_to) {
  const std::string surface = make("y.off", bifurcation().surface);
  const auto report = [&](const Arguments& arguments) {
    succeed(Arguments{surface, "-n", "10", "-t", "surface", "-o", out("m.vtp"), "--report", out("r.json")} + arguments);
    return json_in(out("r.json"));
  };
  const Json plain = report({});
  const double faces = plain["facets"]["triangles"];
  EXPECT_GT(report({"--refine", "0,0,3,2,2"})["facets"]["triangles"].get<double>(), 1.3 * faces);
  EXPECT_GT(report({"--refine", "0,0,3,2,2", "--refine", "0,0,3,1,2"})["facets"]["triangles"].get<double>(),
            1.5 * faces);
  for (std::size_t b = 0; b < 3; ++b) {
    const Json refined = report({"--refine-branch", std::to_string(b) + ",2"});
    for (std::size_t other = 0; other < 3; ++other) {
      const double before = plain["branches"][other]["points_per_circumference"],
                   after = refined["branches"][other]["points_per_circumference"];
      if (other == b) {
        EXPECT_NEAR(after, 2 * before, 0.3 * before);
      } else {
        EXPECT_LT(after, 1.5 * before);
      }
    }
  }
}

std::string with_sizes(const Surface& surface, double size) {
  std::ostringstream vtk;
  vtk.precision(17);
  vtk << "# vtk DataFile Version 3.0\nsizes\nASCII\nDATASET POLYDATA\nPOINTS " << surface.number_of_vertices()
      << " double\n";
  for (auto v : surface.vertices())
    vtk << surface.point(v) << '\n';
  vtk << "POLYGONS " << surface.number_of_faces() << ' ' << 4 * surface.number_of_faces() << '\n';
  for (auto f : surface.faces()) {
    vtk << 3;
    for (auto v : surface.vertices_around_face(surface.halfedge(f)))
      vtk << ' ' << std::size_t(v);
    vtk << '\n';
  }
  vtk << "POINT_DATA " << surface.number_of_vertices() << "\nSCALARS sizes double 1\nLOOKUP_TABLE default\n";
  for (std::size_t i = 0; i < surface.number_of_vertices(); ++i)
    vtk << size << '\n';
  return vtk.str();
}

TEST_F(Tool, Sizes_may_come_with_the_surface) {
  const std::string file = make("t.vtk", with_sizes(tube().surface, 0.25));
  succeed({file, "--size-array", "sizes", "-t", "surface", "-o", out("m.vtp"), "--report", out("r.json")});
  EXPECT_NEAR(json_in(out("r.json"))["branches"][0]["points_per_circumference"].get<double>(), 2 * CGAL_PI / 0.25, 2.5);
  const Outcome none = run({file, "--size-array", "size", "-o", out("m.vtu")});
  EXPECT_EQ(none.status, input);
  expect_one_sentence(none, {"\"size\"", "sizes"});
}

TEST_F(Tool, Refuses_sizes_that_make_no_sense) {
  const std::string surface = make("t.off", tube().surface);
  const auto refused = [&](const Arguments& arguments, const Arguments& mentioned) {
    const Outcome outcome = run(Arguments{surface, "-o", out("m.vtu")} + arguments);
    EXPECT_EQ(outcome.status, usage) << arguments[1];
    expect_one_sentence(outcome, mentioned);
  };
  refused({"--refine", "0,0,3,1"}, {"X,Y,Z,RADIUS,FACTOR"});
  refused({"--refine", "0,0,3,-1,2"}, {"X,Y,Z,RADIUS,FACTOR"});
  refused({"--refine", "0,0,3,1,0"}, {"factor"});
  refused({"--refine", "50,0,3,1,2"}, {"(50, 0, 3)"});
  refused({"--refine-branch", "0.5,2"}, {"K,FACTOR"});
  refused({"--refine-branch", "7,2"}, {"branch 7"});
  refused({"--elements", "3"}, {"--elements"});
  refused({"--elements", "1000", "-n", "20"}, {"--elements"});
}

} // namespace

#endif // TUBULAR_MESH_TOOL
