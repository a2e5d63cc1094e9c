// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the command-line tool makes of surfaces: clean ones, torn ones, its own.

#include "test_tool_helpers.h"
#include "test_tool_report.h"

#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#ifdef TUBULAR_MESH_TOOL

namespace {

using namespace tool_test;

TEST_F(Tool, Leaves_a_clean_surface_alone) {
  const Arguments arguments = tube_run(*this) + Arguments{"--report", out("r.json")} + reproducibly;
  const Outcome outcome = succeed(arguments);
  EXPECT_TRUE(json_in(out("r.json"))["repairs"].empty());
  EXPECT_EQ(outcome.out.find("repair:"), std::string::npos);
  const std::string mesh = bytes_of(out("mesh.vtu"));
  succeed(arguments + Arguments{"--repair", "off"});
  EXPECT_TRUE(bytes_of(out("mesh.vtu")) == mesh);
}

TEST_F(Tool, Repairs_a_surface_and_says_so) {
  Surface surface = tube().surface;
  std::size_t removed = 0;
  for (auto f : surface.faces()) // a pinhole
    if (removed < 1 && std::abs(surface.point(surface.target(surface.halfedge(f))).z() - 3) < 0.3) {
      CGAL::Euler::remove_face(surface.halfedge(f), surface);
      ++removed;
    }
  surface.collect_garbage();
  std::string soup =
      "OFF\n" + std::to_string(surface.number_of_vertices()) + " " + std::to_string(surface.number_of_faces()) + " 0\n";
  for (auto v : surface.vertices()) {
    std::ostringstream line;
    line.precision(17);
    line << surface.point(v) << "\n";
    soup += line.str();
  }
  for (auto f : surface.faces()) { // every fifth triangle is turned
    std::vector<std::string> corners;
    for (auto v : CGAL::vertices_around_face(surface.halfedge(f), surface))
      corners.push_back(std::to_string(v.idx()));
    if (f.idx() % 5 == 1)
      std::swap(corners[0], corners[1]);
    soup += "3 " + corners[0] + " " + corners[1] + " " + corners[2] + "\n";
  }
  const Outcome outcome = succeed({make("torn.off", soup), "-o", out("mesh.vtu"), "--report", out("r.json")});
  const Json report = json_in(out("r.json"));
  expect_report_of(report, mesh_in(out("mesh.vtu")));
  expect_by_patches(report);
  EXPECT_EQ(report["openings"].size(), 2u);
  std::set<std::string> defects;
  for (const Json& repair : report["repairs"]) {
    defects.insert(repair["defect"].get<std::string>());
    EXPECT_GT(repair["count"].get<int>(), 0);
    EXPECT_NE(outcome.out.find(repair["sentence"].get<std::string>()), std::string::npos);
  }
  EXPECT_EQ(defects, (std::set<std::string>{"turned_triangles", "pinholes"}));
}

TEST_F(Tool, Wraps_and_smooths_when_told_to) {
  const Sample s = bifurcation();
  const Arguments common = {make("y.off", s.surface), "-n", "10", "-o", out("mesh.vtu"), "--report", out("r.json")};
  for (const Arguments& options : {Arguments{"--repair", "wrap"}, Arguments{"--smooth"}}) {
    succeed(common + options);
    const Json report = json_in(out("r.json"));
    expect_report_of(report, mesh_in(out("mesh.vtu")));
    EXPECT_EQ(report["repairs"].size(), 1u);
    EXPECT_EQ(report["openings"].size(), 3u);
    EXPECT_EQ(report["branches"].size(), 3u);
  }
}

class Reads : public Tool {
protected:
  /* Meshes a surface, then the same surface along the centerlines that were written, then the surface that was written
   * along these: in it, an opening has that share of its area at least. */
  void expect_to_read_what_it_has_written(const Arguments& mesher, double share_of_area) {
    const Sample s = bifurcation();
    Json reports[3];
    const Arguments common = Arguments{"--report", out("r.json")} + mesher + reproducibly;
    succeed(common + Arguments{make("y.off", s.surface), "-c", make("lines.vtk", s.lines), "-o", out("a.vtu"),
                               "--write-surface", out("a.vtp"), "--write-centerlines", out("c.vtp")});
    reports[0] = json_in(out("r.json"));
    Surface closed;
    tubular::IO::read_surface(out("a.vtp"), closed);
    EXPECT_TRUE(CGAL::is_closed(closed));
    Centerlines branches;
    tubular::IO::read_centerlines(out("c.vtp"), branches);
    EXPECT_EQ(branches.lines.size(), 3u);
    EXPECT_EQ(branches.radius.size(), branches.points.size());

    succeed(common + Arguments{in("y.off"), "-c", out("c.vtp"), "-o", out("b.vtu")});
    reports[1] = json_in(out("r.json"));
    succeed(common + Arguments{out("a.vtp"), "-c", out("c.vtp"), "-o", out("b.vtu")});
    reports[2] = json_in(out("r.json"));
    expect_report_of(reports[2], mesh_in(out("b.vtu")));
    for (const Json& r : reports) {
      EXPECT_EQ(r["openings"].size(), 3u);
      EXPECT_EQ(r["branches"].size(), 3u);
      EXPECT_NEAR(r["points"].get<double>(), reports[0]["points"].get<double>(), 0.02 * r["points"].get<double>());
      for (int i = 0; i < 3; ++i) {
        const double area = r["openings"][i]["area"], first = reports[0]["openings"][i]["area"];
        EXPECT_LE(area, first + 0.02);
        EXPECT_GE(area, &r == &reports[2] ? share_of_area * first - 0.02 : first - 0.02);
      }
    }
  }
};

TEST_F(Reads, What_it_has_written) {
  expect_to_read_what_it_has_written({}, 0.98); // as it was meshed: rims are polygons of twenty sides
}

TEST_F(Reads, What_it_has_written_for_Mesh_3) {
  expect_to_read_what_it_has_written(by_mesh_3, 1); // as it came
}

// --- places are the surface's ---

// The first three numbers in parentheses.
bool find_place(const std::string& text, Point& place) {
  static const std::string number = "([-+0-9.e]+)";
  static const std::regex triple("\\(" + number + ", " + number + ", " + number + "\\)");
  std::smatch match;
  if (!std::regex_search(text, match, triple))
    return false;
  place = Point(std::stod(match[1]), std::stod(match[2]), std::stod(match[3]));
  return true;
}

// Meshes are made in a frame of the model's own: what fails there is said of the surface that was given.
TEST_F(Tool, Names_places_of_the_surface_that_it_was_given) {
  NEEDS_FILLING();
  Surface surface;
  tubular::IO::read_surface(arch(), surface);
  CGAL::Bbox_3 box;
  for (auto v : surface.vertices())
    box += surface.point(v).bbox();
  const double diagonal = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());

  const Outcome outcome = run({arch(), "-c", arch_centerlines(), "--boundary-layer-prisms", "3", "--first-height",
                               "1e-17", "-o", out("mesh.vtu")});
  EXPECT_EQ(outcome.status, meshing) << outcome.killed_by << outcome.err;
  expect_one_sentence(outcome, {"layers"});
  Point place;
  ASSERT_TRUE(find_place(outcome.err, place)) << outcome.err;
  for (int i = 0; i < 3; ++i) {
    EXPECT_GE(place[i], box.min_coord(i) - 1e-6 * diagonal) << outcome.err;
    EXPECT_LE(place[i], box.max_coord(i) + 1e-6 * diagonal) << outcome.err;
  }
  EXPECT_LE(tubular::Wall_distance(surface)(place), 0.01 * diagonal) << "layers grow from the wall";
}

} // namespace

#endif // TUBULAR_MESH_TOOL
