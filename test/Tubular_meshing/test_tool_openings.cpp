// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line tool and the ends of vessels: openings, inlets, seeds, extensions; centerlines, given or computed.

#include "test_surfaces.h"
#include "test_tool_bad_files.h"
#include "test_tool_helpers.h"
#include "test_tool_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#ifdef TUBULAR_MESH_TOOL

namespace {

using namespace tool_test;

TEST_F(Tool, Takes_the_opening_at_the_point_for_the_inlet) {
  const Sample s = bifurcation();
  const Arguments arguments = {make("y.off", s.surface),
                               "-c",
                               make("lines.vtk", s.lines),
                               "-n",
                               "10",
                               "-o",
                               out("mesh.vtu"),
                               "--report",
                               out("r.json")};
  const auto inlet_z = [&](const Arguments& inlet) {
    succeed(arguments + inlet);
    const Json report = json_in(out("r.json"));
    expect_report_of(report, mesh_in(out("mesh.vtu")));
    expect_by_patches(report);
    EXPECT_EQ(report["openings"][0]["patch"], 2);
    EXPECT_TRUE(report["branches"][report["openings"][0]["branch"].get<std::size_t>()]["parents"].empty());
    return report["openings"][0]["center"][2].get<double>();
  };
  EXPECT_NEAR(inlet_z({}), 0, 0.01); // where the lines begin
  EXPECT_NEAR(inlet_z({"--inlet", "3.2,0,12"}), 12, 0.2);
  EXPECT_NEAR(inlet_z({"--inlet", "-30,0,110"}), 11, 0.2);
  EXPECT_NEAR(inlet_z({"--inlet=-1,-1,-1"}), 0, 0.01);
}

// --- without centerlines ---

// The largest difference between branches' lengths, in the order of their lengths, of the longest.
double difference_of_lengths(const Json& a, const Json& b) {
  std::vector<double> lengths[2];
  for (const Json& branch : a["branches"])
    lengths[0].push_back(branch["length"]);
  for (const Json& branch : b["branches"])
    lengths[1].push_back(branch["length"]);
  if (lengths[0].size() != lengths[1].size())
    return 1;
  double difference = 0;
  for (auto& l : lengths)
    std::sort(l.begin(), l.end());
  for (std::size_t i = 0; i < lengths[0].size(); ++i)
    difference = (std::max)(difference, std::abs(lengths[0][i] - lengths[1][i]));
  return difference / lengths[0].back();
}

TEST_F(Tool, Needs_no_centerlines) {
  const Sample s = bifurcation();
  const Arguments common =
      Arguments{make("y.off", s.surface), "-n", "12", "-o", out("mesh.vtu"), "--report", out("r.json")};
  succeed(common + Arguments{"-c", make("lines.vtk", s.lines)});
  const Json given = json_in(out("r.json"));
  succeed(common);
  const Json computed = json_in(out("r.json"));
  expect_report_of(computed, mesh_in(out("mesh.vtu")));
  expect_by_patches(computed);
  EXPECT_TRUE(computed["centerlines"].is_null());
  EXPECT_LT(difference_of_lengths(computed, given), 0.05); // where lines part is a matter of definition
  EXPECT_NEAR(computed["points"].get<double>(), given["points"].get<double>(), 0.05 * given["points"].get<double>());
  for (const Json& opening : computed["openings"])
    EXPECT_FALSE(opening["branch"].is_null());
  EXPECT_TRUE(computed["branches"][computed["openings"][0]["branch"].get<std::size_t>()]["parents"].empty());

  const Json first_outlet = computed["openings"][1];
  std::ostringstream point;
  point << first_outlet["center"][0] << "," << first_outlet["center"][1] << "," << first_outlet["center"][2];
  succeed(common + Arguments{"--inlet", point.str()});
  const Json turned = json_in(out("r.json"));
  EXPECT_EQ(turned["openings"][0]["center"], first_outlet["center"]);
  EXPECT_TRUE(turned["branches"][turned["openings"][0]["branch"].get<std::size_t>()]["parents"].empty());
}

std::string cigar() { // closed, and round at its ends
  Surface surface;
  std::istringstream in(sphere_off());
  CGAL::IO::read_OFF(in, surface);
  for (auto v : surface.vertices())
    surface.point(v) = Point(surface.point(v).x(), surface.point(v).y(), 4 * surface.point(v).z());
  std::ostringstream out;
  CGAL::IO::write_OFF(out, surface);
  return out.str();
}

TEST_F(Tool, Takes_points_for_the_ends_of_a_surface_without_any) {
  const Arguments common =
      Arguments{make("cigar.off", cigar()), "-o", out("mesh.vtu"), "--report", out("r.json")} + reproducibly;
  std::string meshes[2];
  int i = 0;
  for (const Arguments& ends : {Arguments{"--inlet", "0,0,-4", "--outlet", "0,0,4"},
                                Arguments{"--seeds", make("seeds.txt", "# from, to\n0,0,-4\n\n 0 0 4\n")}}) {
    succeed(common + ends);
    const Json report = json_in(out("r.json"));
    ASSERT_EQ(report["openings"].size(), 2u); // cut open there
    EXPECT_LT(report["openings"][0]["center"][2].get<double>(), 0);
    EXPECT_EQ(report["branches"].size(), 1u);
    EXPECT_EQ(report["boundary_euler"], 2);
    expect_by_patches(report);
    EXPECT_NEAR(report["branches"][0]["max_radius"].get<double>(), 1, 0.02);
    meshes[i++] = bytes_of(out("mesh.vtu"));
  }
  EXPECT_TRUE(meshes[0] == meshes[1]);
}

// --- ends, and what may be one ---

TEST_F(Tool, Cuts_round_ends_of_a_closed_surface) {
  const Arguments common = {make("cigar.off", cigar()), "-o", out("mesh.vtu"), "--report", out("r.json"), "-n", "10"};
  const Outcome outcome = succeed(common);
  const Json report = json_in(out("r.json"));
  EXPECT_EQ(report["openings"].size(), 2u);
  ASSERT_EQ(report["round_ends"].size(), 2u);
  EXPECT_TRUE(report["round_ends"][0]["cut"]);
  EXPECT_NE(outcome.out.find("2 round ends were cut open"), std::string::npos) << outcome.out;
  const Arguments kept = common + Arguments{"--keep-end", "0,0,4"};
  EXPECT_EQ(run(kept).status, input);
  succeed(kept + Arguments{"--allow-single-opening"});
  EXPECT_EQ(json_in(out("r.json"))["openings"].size(), 1u);
}

TEST_F(Tool, Keeps_a_dome_behind_a_crease_closed_where_a_point_says_so) {
  test_surfaces::Tube tube;
  tube.length = 8;
  tube.sides = 24;
  tube.rings = 30;
  tube.top = test_surfaces::End::fine;
  tube.dish = -1;
  const Arguments common = {
      make("domed.off", test_surfaces::make_tube(tube)), "-o", out("mesh.vtu"), "--report", out("r.json"), "-n", "10"};
  succeed(common);
  EXPECT_EQ(json_in(out("r.json"))["openings"].size(), 2u);
  for (const char* more : {"", "--cut-ends"}) {
    Arguments kept = common + Arguments{"--keep-end", "0,0,8.9"};
    if (*more != 0)
      kept = kept + Arguments{more};
    EXPECT_EQ(run(kept).status, input);
    succeed(kept + Arguments{"--allow-single-opening"});
    const Json report = json_in(out("r.json"));
    EXPECT_EQ(report["openings"].size(), 1u);
    ASSERT_EQ(report["round_ends"].size(), 1u);
    EXPECT_EQ(report["round_ends"][0]["reason"], "kept");
  }
}

TEST_F(Tool, Meshes_a_vessel_with_one_opening_where_allowed) {
  const Arguments common = {
      make("bag.off", half_of(sphere_off(), 4)), "-o", out("mesh.vtu"), "--report", out("r.json"), "-n", "10"};
  EXPECT_EQ(run(common).status, input);
  succeed(common + Arguments{"--allow-single-opening"});
  EXPECT_EQ(json_in(out("r.json"))["openings"].size(), 1u);
  succeed(common + Arguments{"--cut-ends"});
  EXPECT_EQ(json_in(out("r.json"))["openings"].size(), 2u);
}

TEST_F(Tool, Takes_a_hole_as_large_as_the_vessel_for_an_opening_unless_it_is_to_be_filled) {
  const Arguments common = {
      make("window.off", tube_with_a_window()), "-o", out("mesh.vtu"), "--report", out("r.json"), "-n", "10"};
  const Outcome outcome = succeed(common);
  EXPECT_NE(outcome.out.find("--fill"), std::string::npos) << outcome.out;
  EXPECT_EQ(json_in(out("r.json"))["openings"].size(), 3u);
  succeed(common + Arguments{"--fill", "1,0,3"});
  EXPECT_EQ(json_in(out("r.json"))["openings"].size(), 2u);
  const Outcome refused = run(common + Arguments{"--openings", "2"});
  EXPECT_EQ(refused.status, input);
  EXPECT_NE(refused.err.find("3 openings, not 2"), std::string::npos) << refused.err;
  succeed(common + Arguments{"--openings", "3"});
}

TEST_F(Tool, Meshes_all_vessels_of_a_file) {
  const Sample two = two_tubes(4);
  const Arguments common = {make("two.off", two.surface), "-o", out("mesh.vtu"), "--report", out("r.json"), "-n", "10"};
  for (const Arguments& lines : {Arguments{}, Arguments{"-c", make("two.vtk", two.lines)}}) {
    succeed(common + lines);
    const Json report = json_in(out("r.json"));
    ASSERT_EQ(report["openings"].size(), 4u);
    EXPECT_EQ(report["openings"][2]["name"], "inlet_2");
    EXPECT_EQ(report["openings"][3]["name"], "outlet_2");
    EXPECT_EQ(report["openings_of_parts"], Json({2, 2}));
    EXPECT_EQ(report["boundary_euler"], 4);
  }
  succeed(common + Arguments{"--parts", "largest"});
  EXPECT_EQ(json_in(out("r.json"))["openings"].size(), 2u);
  EXPECT_EQ(run(common + Arguments{"--parts", "0"}).status, usage);
  succeed(common + Arguments{"-t", "mixed", "--wall", "0.2"});
  EXPECT_EQ(json_in(out("r.json"))["openings"].size(), 4u);
}

TEST_F(Tool, Keeps_all_branches_of_a_loop_unless_asked_not_to) {
  const Sample s = sample_of(tubular::willis_loop());
  const Arguments common = {make("loop.off", s.surface), "-n", "10", "-o", out("mesh.vtu"), "--report", out("r.json")};
  succeed(common + Arguments{"-c", make("lines.vtk", s.lines)});
  const Json given = json_in(out("r.json"));
  succeed(common + Arguments{"--loops"});
  const std::string mesh = bytes_of(out("mesh.vtu"));
  succeed(common);
  const Json computed = json_in(out("r.json"));
  EXPECT_EQ(computed["loops"], true);
  EXPECT_TRUE(bytes_of(out("mesh.vtu")) == mesh);
  EXPECT_EQ(computed["branches"].size(), given["branches"].size());
  EXPECT_EQ(computed["boundary_euler"], given["boundary_euler"]);
  EXPECT_LT(computed["boundary_euler"], 2);
  succeed(common + Arguments{"--no-loops"});
  EXPECT_LT(json_in(out("r.json"))["branches"].size(), given["branches"].size());
  EXPECT_EQ(json_in(out("r.json"))["loops"], false);
}

TEST_F(Tool, Extends_the_openings) {
  const Sample s = bifurcation();
  const Arguments common = {make("y.off", s.surface),
                            "-n",
                            "10",
                            "-o",
                            out("mesh.vtu"),
                            "--report",
                            out("r.json"),
                            "--inlet",
                            "3.2,0,12"}; // a twig's end
  succeed(common);
  const Json plain = json_in(out("r.json"));
  EXPECT_TRUE(plain["flow_extensions"].empty());
  succeed(common + Arguments{"--flow-extensions", "4"});
  const Json extended = json_in(out("r.json"));
  expect_report_of(extended, mesh_in(out("mesh.vtu")));
  expect_by_patches(extended);
  ASSERT_EQ(extended["openings"].size(), 3u);
  ASSERT_EQ(extended["flow_extensions"].size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) { // in the same order
    const double radius = plain["openings"][i]["radius"], length = extended["flow_extensions"][i];
    EXPECT_NEAR(length, 4 * radius, 0.05 * radius);
    double along = 0;
    for (int k = 0; k < 3; ++k)
      along += (extended["openings"][i]["center"][k].get<double>() - plain["openings"][i]["center"][k].get<double>()) *
               plain["openings"][i]["normal"][k].get<double>();
    EXPECT_NEAR(along, length, 0.1 * length);
    EXPECT_NEAR(extended["openings"][i]["radius"].get<double>(), radius, 0.05 * radius);
  }
}

} // namespace

#endif // TUBULAR_MESH_TOOL
