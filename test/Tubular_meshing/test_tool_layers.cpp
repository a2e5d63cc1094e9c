// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// tubular_mesh with cells other than tetrahedra: mixed meshes, walls outside of the lumen, layers inside.

#include "hub_of_vessels.h"
#include "test_tool_helpers.h"

#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Quads/blossom_recombination.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/Volume/Volume_mesher.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>

#ifdef TUBULAR_MESH_TOOL

namespace {

using namespace tool_test;

void expect_valid(const Mesh& mesh) {
  const auto validity = tubular::validity_report(mesh);
  EXPECT_TRUE(validity.is_valid()) << validity.defects();
}

template <class Labels> std::size_t count(const Labels& labels, int label) {
  return std::size_t(std::count(labels.begin(), labels.end(), label));
}

/* A tube of six sides through four rings, with faces as long as from one ring to the next: it bends at the second ring and
 * widens, so that the scale of its map jumps there. */
std::string coarse_bend() {
  static const char* const points[] = {
      "-1.57 0 0.102",       "-1.57 -0.088 0.051",  "-1.57 -0.088 -0.051", "-1.57 0 -0.102",      "-1.57 0.088 -0.051",
      "-1.57 0.088 0.051",   "-0.001 -0.001 0.127", "0.037 -0.103 0.063",  "0.038 -0.103 -0.063", "0.001 0.001 -0.127",
      "-0.037 0.103 -0.063", "-0.038 0.103 0.063",  "1.584 1.321 0.143",   "1.663 1.283 0.095",   "1.676 1.302 -0.003",
      "1.61 1.359 -0.052",   "1.531 1.397 -0.004",  "1.518 1.378 0.093",   "1.891 2.563 0.762",   "2.015 2.556 0.71",
      "2.039 2.607 0.588",   "1.939 2.665 0.518",   "1.816 2.671 0.57",    "1.791 2.62 0.692",    "-1.57 0 0",
      "1.915 2.614 0.64",
  };
  std::string off = "OFF\n26 48 0\n";
  for (const char* point : points)
    off += std::string(point) + "\n";
  const auto face = [&](int a, int b, int c) {
    off += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  };
  for (int k = 0; k < 6; ++k) {
    const int next = (k + 1) % 6;
    for (int ring = 0; ring < 18; ring += 6) {
      face(ring + k, ring + next, ring + next + 6);
      face(ring + k, ring + next + 6, ring + k + 6);
    }
    face(24, next, k);
    face(25, 18 + k, 18 + next);
  }
  return off;
}

TEST_F(Tool, Makes_layers_where_the_map_of_a_coarse_bend_jumps) {
  NEEDS_FILLING();
  const std::string input = make("bend.off", coarse_bend());
  for (const char* points : {"9", "10", "12"}) { // long triangles turned over, and no layer had room on them
    SCOPED_TRACE(points);
    succeed({input, "-n", points, "--boundary-layer-prisms", "4", "--first-height", "0.03", "-o", out("mesh.vtu"),
             "--report", out("r.json")});
    expect_valid(mesh_in(out("mesh.vtu")));
    EXPECT_GT(json_in(out("r.json"))["boundary_layer"]["mean_ratio"].get<double>(), 0.95);
  }
}

TEST_F(Tool, Makes_a_mixed_mesh_with_a_wall) {
  NEEDS("LEMON", tubular::has_lemon());
  NEEDS_FILLING();
  const std::string input = make("y.off", bifurcation().surface);
  const Outcome outcome =
      succeed({input, "-t", "mixed", "-n", "12", "--wall", "0.2", "-o", out("mesh.vtu"), "--report", out("r.json")});
  const Mesh mesh = mesh_in(out("mesh.vtu"));
  expect_valid(mesh);
  EXPECT_GT(mesh.tetrahedra.size(), 0u);
  EXPECT_EQ(mesh.prisms.size(), 0u);
  EXPECT_EQ(count(mesh.quads.label, 1), mesh.pyramids.size()); // one on each quad of the interface
  EXPECT_EQ(mesh.hexahedra.size(), 4 * mesh.pyramids.size());
  EXPECT_EQ(count(mesh.quads.label, 100), mesh.pyramids.size());
  EXPECT_GT(count(mesh.quads.label, 102), 0u);
  EXPECT_EQ(mesh.region_names.at(2), "wall");
  EXPECT_EQ(mesh.patch_names.at(103), "outlet_ring_1");
  const Json r = json_in(out("r.json"));
  EXPECT_EQ(r["valid"], true);
  EXPECT_EQ(r["cells"]["hexahedra"], mesh.hexahedra.size());
  EXPECT_EQ(r["wall"]["vertices"].get<std::size_t>() > 0, true);
  EXPECT_GE(r["quality"]["eta_q"]["min"].get<double>(), 0.3);
  EXPECT_GE(r["quality"]["zeta_H"]["min"].get<double>(), 0.3);
  EXPECT_EQ(r["quality"]["scaled_jacobian"]["count"], mesh.hexahedra.size());
  EXPECT_GT(r["quality"]["scaled_jacobian"]["min"].get<double>(), 0);
  EXPECT_EQ(r["quality"]["aspect"]["count"], mesh.number_of_cells());
  EXPECT_NE(outcome.out.find("skewness"), std::string::npos);
  EXPECT_NE(outcome.out.find("hexahedra"), std::string::npos);
}

TEST_F(Tool, Grows_walls_of_prisms_and_of_tetrahedra) {
  const std::string input = make("tube.off", tube().surface);
  succeed({input, "-n", "10", "--wall", "0.2", "--wall-layers", "2", "--second-wall", "0.1", "--second-wall-layers",
           "1", "-o", out("prisms.vtu")});
  const Mesh prisms = mesh_in(out("prisms.vtu"));
  expect_valid(prisms);
  const std::size_t facets = count(prisms.triangles.label, 1);
  EXPECT_EQ(count(prisms.prisms.label, 2), 2 * facets);
  EXPECT_EQ(count(prisms.prisms.label, 3), facets);
  EXPECT_EQ(prisms.region_names.at(3), "second_wall");

  succeed({input, "-n", "10", "--wall", "0.2", "--wall-layers", "2", "--wall-elements", "tetrahedra", "-o",
           out("tetrahedra.vtu")});
  const Mesh tetrahedra = mesh_in(out("tetrahedra.vtu"));
  expect_valid(tetrahedra);
  EXPECT_EQ(tetrahedra.number_of_cells(), tetrahedra.tetrahedra.size());
  EXPECT_EQ(count(tetrahedra.tetrahedra.label, 2), 3 * 2 * count(tetrahedra.triangles.label, 1));
}

TEST_F(Tool, Grows_layers_inside_the_lumen) {
  NEEDS_FILLING();
  const std::string input = make("tube.off", tube().surface);
  succeed({input, "-n", "14", "--boundary-layer-prisms", "5", "--first-height", "0.02", "--growth", "1.3", "-o",
           out("mesh.vtu"), "--report", out("r.json")});
  const Mesh mesh = mesh_in(out("mesh.vtu"));
  expect_valid(mesh);
  EXPECT_EQ(mesh.prisms.size(), 5 * count(mesh.triangles.label, 1));
  EXPECT_GT(mesh.tetrahedra.size(), 0u);
  EXPECT_EQ(json_in(out("r.json"))["boundary_layer"]["min_ratio"], 1.);
}

TEST_F(Tool, Grows_a_wall_around_an_anisotropic_mesh) {
  const std::string input = make("tube.off", tube().surface);
  succeed({input, "-t", "anisotropic", "-n", "10", "--curvature-points", "10", "--first-height", "0.08", "--wall",
           "0.2", "-o", out("mesh.vtu")});
  const Mesh mesh = mesh_in(out("mesh.vtu"));
  expect_valid(mesh);
  EXPECT_GT(mesh.prisms.size(), 0u);
  ASSERT_EQ(mesh.point_arrays.size(), 1u);
  EXPECT_EQ(mesh.point_arrays[0].values.size(), 6 * mesh.points.size());
}

TEST_F(Tool, Makes_a_mesh_of_hexahedra_alone) {
  NEEDS_FILLING();
  const std::string input = make("y.off", bifurcation().surface);
  const Outcome outcome = succeed({input,
                                   "-t",
                                   "hexahedral",
                                   "-n",
                                   "14",
                                   "--hex-method",
                                   "subdivision",
                                   "--boundary-layer-prisms",
                                   "3",
                                   "--first-height",
                                   "0.05",
                                   "--wall",
                                   "0.2",
                                   "--wall-layers",
                                   "2",
                                   "--second-wall",
                                   "0.1",
                                   "-o",
                                   out("mesh.vtu"),
                                   "--report",
                                   out("r.json")});
  const Mesh mesh = mesh_in(out("mesh.vtu"));
  expect_valid(mesh);
  EXPECT_EQ(mesh.number_of_cells(), mesh.hexahedra.size());
  EXPECT_EQ(mesh.number_of_facets(), mesh.quads.size());
  EXPECT_EQ(count(mesh.hexahedra.label, 2), 2 * count(mesh.quads.label, 1));
  EXPECT_EQ(count(mesh.hexahedra.label, 3), 2 * count(mesh.quads.label, 1));
  EXPECT_EQ(mesh.region_names.at(2), "wall");
  const Json r = json_in(out("r.json"));
  EXPECT_EQ(r["valid"], true);
  EXPECT_EQ(r["type"], "hexahedral");
  EXPECT_EQ(r["cells"]["hexahedra"], mesh.hexahedra.size());
  EXPECT_EQ(r["hexahedral"]["method"], "subdivision");
  EXPECT_TRUE(r["hexahedral"]["places_without_blocks"].empty());
  EXPECT_LT(std::abs(r["volume"]["relative_difference"].get<double>()), 0.003);
  EXPECT_NE(outcome.out.find("by subdivision"), std::string::npos) << outcome.out;
}

tubular::Surface hub() {
  tubular::Surface surface;
  tubular::generate_tubular_surface(hub_of_ten_vessels(), surface, tubular::parameters::points_per_circumference(16));
  return surface;
}

TEST_F(Tool, Makes_hexahedra_in_blocks) {
  const std::string input = make("y.off", bifurcation().surface);
  const Outcome outcome = succeed({input, "-t", "hexahedral", "-n", "16", "--boundary-layer-prisms", "3",
                                   "--first-height", "0.05", "--wall", "0.2", "--wall-layers", "1", "-o",
                                   out("mesh.vtu"), "--report", out("r.json"), "--write-blocks", out("blocks.vtu")});
  const Json r = json_in(out("r.json")), h = r["hexahedral"];
  EXPECT_EQ(h["method"], "blocks");
  EXPECT_EQ(h["blocks"], 36);
  EXPECT_EQ(h["junctions"], 1);
  EXPECT_EQ(h["points_per_circumference"], 16);
  EXPECT_EQ(h["twist"].size(), 3u);
  EXPECT_TRUE(h["places_without_blocks"].empty());
  EXPECT_LT(std::abs(r["volume"]["relative_difference"].get<double>()), 0.003);
  EXPECT_NE(outcome.out.find("36 blocks of hexahedra"), std::string::npos) << outcome.out;
  const Mesh mesh = mesh_in(out("mesh.vtu"));
  expect_valid(mesh);
  EXPECT_EQ(mesh.number_of_cells(), mesh.hexahedra.size());
  EXPECT_EQ(count(mesh.hexahedra.label, 2), count(mesh.quads.label, 1));
  const Mesh blocks = mesh_in(out("blocks.vtu"));
  EXPECT_EQ(blocks.hexahedra.size(), 36u);
  for (int branch = 0; branch < 3; ++branch) {
    EXPECT_EQ(count(blocks.hexahedra.label, branch + 1), 12u);
    EXPECT_EQ(blocks.region_names.at(branch + 1), "branch_" + std::to_string(branch));
  }
  EXPECT_EQ(blocks.patch_names.at(2), "inlet");
}

TEST_F(Tool, Makes_structured_quads) {
  const std::string input = make("y.off", bifurcation().surface);
  succeed({input, "-t", "surface", "--surface-elements", "structured-quads", "-n", "16", "-o", out("quads.msh")});
  const Mesh mesh = mesh_in(out("quads.msh"));
  EXPECT_EQ(mesh.triangles.size(), 0u);
  for (int patch = 2; patch < 5; ++patch)
    EXPECT_EQ(count(mesh.quads.label, patch), 2u * 2 * 4 + 16); // squares of the core, and the ring
}

// Branches and openings are counted through.
TEST_F(Tool, Writes_the_blocks_of_two_vessels) {
  tubular::Surface both = bifurcation().surface, other = both;
  for (auto v : other.vertices())
    other.point(v) = other.point(v) + CGAL::Vector_3<tubular::Kernel>(0, 0, 40);
  CGAL::copy_face_graph(other, both);
  succeed({make("two.off", both), "-t", "hexahedral", "-n", "8", "-o", out("mesh.vtu"), "--write-blocks",
           out("blocks.vtu")});
  const Mesh blocks = mesh_in(out("blocks.vtu"));
  EXPECT_EQ(blocks.hexahedra.size(), 72u);
  for (int branch = 0; branch < 6; ++branch)
    EXPECT_EQ(count(blocks.hexahedra.label, branch + 1), 12u);
  for (int patch = 2; patch < 8; ++patch)
    EXPECT_EQ(count(blocks.quads.label, patch), 12u);
}

// Blocks that are asked for and cannot be had are no mesh by subdivision.
TEST_F(Tool, Writes_nothing_where_there_are_no_blocks_to_write) {
  const Outcome outcome = run({make("hub.off", hub()), "-t", "hexahedral", "-n", "12", "-o", out("mesh.vtu"),
                               "--write-blocks", out("blocks.vtu")});
  EXPECT_EQ(outcome.status, 4);
  EXPECT_FALSE(fs::exists(out("mesh.vtu")));
  EXPECT_FALSE(fs::exists(out("blocks.vtu")));
}

// The default is blocks; where there are none that is said, in the summary and in the report.
TEST_F(Tool, Says_where_there_are_no_blocks) {
  NEEDS_FILLING();
  const std::string input = make("hub.off", hub());
  const Outcome outcome =
      succeed({input, "-t", "hexahedral", "-n", "12", "-o", out("mesh.vtu"), "--report", out("r.json")});
  const Json r = json_in(out("r.json")), h = r["hexahedral"];
  EXPECT_EQ(h["method"], "subdivision");
  ASSERT_FALSE(h["places_without_blocks"].empty());
  EXPECT_NE(outcome.out.find(h["places_without_blocks"][0]["reason"].get<std::string>()), std::string::npos)
      << outcome.out;
  EXPECT_EQ(r["fallbacks"].size(), 1u);
  const Mesh mesh = mesh_in(out("mesh.vtu"));
  EXPECT_EQ(mesh.number_of_cells(), mesh.hexahedra.size());
}

TEST_F(Tool, Fills_a_junction_without_blocks_and_says_so) {
  NEEDS_FILLING();
  const std::string input = make("hub.off", hub());
  const Outcome outcome = succeed({input, "-t", "hexahedral", "-n", "12", "--hex-fallback", "mixed", "-o",
                                   out("mesh.vtu"), "--report", out("r.json")});
  const Json r = json_in(out("r.json")), h = r["hexahedral"];
  EXPECT_EQ(h["method"], "blocks");
  ASSERT_EQ(h["places_without_blocks"].size(), 1u);
  const Json place = h["places_without_blocks"][0];
  const Mesh mesh = mesh_in(out("mesh.vtu"));
  expect_valid(mesh);
  EXPECT_GT(mesh.hexahedra.size(), 0u);
  EXPECT_GT(mesh.pyramids.size(), 0u);
  EXPECT_EQ(place["pyramids"].get<std::size_t>(), mesh.pyramids.size());
  EXPECT_EQ(place["tetrahedra"].get<std::size_t>(), mesh.tetrahedra.size());
  EXPECT_EQ(r["fallbacks"].size(), 1u);
  EXPECT_NE(outcome.out.find(place["reason"].get<std::string>() + "; " + std::to_string(mesh.pyramids.size()) +
                             " pyramids and " + std::to_string(mesh.tetrahedra.size()) + " tetrahedra there"),
            std::string::npos)
      << outcome.out;
}

TEST_F(Tool, Writes_nothing_where_blocks_cannot_be_had_and_nothing_else_is_wanted) {
  const std::string input = make("hub.off", hub());
  const Outcome outcome = run({input, "-t", "hexahedral", "-n", "12", "--hex-fallback", "none", "-o", out("mesh.vtu"),
                               "--report", out("r.json")});
  EXPECT_EQ(outcome.status, meshing) << outcome.err;
  EXPECT_NE(outcome.err.find("blocks"), std::string::npos) << outcome.err;
  EXPECT_TRUE(fs::is_empty(output_directory()));
}

TEST_F(Tool, Writes_hexahedra_to_every_format) {
  NEEDS_FILLING();
  const std::string input = make("tube.off", tube().surface);
  std::set<std::size_t> numbers;
  for (const char* file : {"mesh.vtu", "mesh.msh", "mesh.mesh"}) {
    succeed({input, "-t", "hexahedral", "--hex-method", "subdivision", "-n", "10", "-o", out(file)});
    const Mesh mesh = mesh_in(out(file));
    expect_valid(mesh);
    EXPECT_EQ(mesh.number_of_cells(), mesh.hexahedra.size()) << file;
    numbers.insert(mesh.hexahedra.size());
  }
  EXPECT_EQ(numbers.size(), 1u);
  succeed({input, "-t", "hexahedral", "--hex-method", "subdivision", "-n", "10", "-o", out("mesh.inp")});
  const std::string inp = bytes_of(out("mesh.inp"));
  EXPECT_NE(inp.find("C3D8"), std::string::npos);
  EXPECT_EQ(inp.find("C3D4"), std::string::npos);
}

TEST_F(Tool, Makes_a_surface_of_quads) {
  NEEDS("LEMON", tubular::has_lemon());
  const std::string input = make("y.off", bifurcation().surface);
  succeed({input, "-t", "surface", "--surface-elements", "quads", "-n", "12", "-o", out("s.vtp"), "--report",
           out("r.json")});
  const Json r = json_in(out("r.json"));
  EXPECT_EQ(r["valid"], true);
  EXPECT_GT(r["facets"]["quads"].get<std::size_t>(), 0u);
  EXPECT_GE(r["quality"]["eta_q"]["min"].get<double>(), 0.3);
}

TEST_F(Tool, Makes_an_anisotropic_surface) {
  const std::string input = make("y.off", bifurcation().surface);
  const std::vector<std::string> options = {input, "-t", "surface", "--surface-elements", "anisotropic"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), options.begin(), options.end());
    return more;
  };
  succeed(with({"-o", out("s.vtp"), "--report", out("r.json")}));
  const Json r = json_in(out("r.json"));
  EXPECT_EQ(r["valid"], true);
  const Json& wall = r["quality"]["in_the_metric"]["wall"];
  EXPECT_GE(wall["shape"]["mean"].get<double>(), 0.9);
  EXPECT_GE(wall["share_of_unit_edges"].get<double>(), 0.9);
  EXPECT_NE(bytes_of(out("s.vtp")).find("metric"), std::string::npos);

  succeed(with(
      {"--first-height", "0.05", "--curvature-points", "12", "-o", out("coarse.msh"), "--report", out("coarse.json")}));
  EXPECT_LT(json_in(out("coarse.json"))["facets"]["triangles"], r["facets"]["triangles"]);
  const Mesh mesh = mesh_in(out("coarse.msh"));
  ASSERT_EQ(mesh.point_arrays.size(), 1u);
  EXPECT_EQ(mesh.point_arrays[0].name, "metric");
  EXPECT_EQ(mesh.point_arrays[0].components, 6);
}

// A solver of structures wants hexahedra by sets: the input deck of the wall and the lumen.
TEST_F(Tool, Writes_prisms_for_structural_solvers) {
  const std::string input = make("tube.off", tube().surface);
  succeed({input, "-n", "10", "--wall", "0.2", "--wall-layers", "2", "-o", out("mesh.inp")});
  const std::string deck = bytes_of(out("mesh.inp"));
  EXPECT_NE(deck.find("C3D6"), std::string::npos);
}

} // namespace

#endif // TUBULAR_MESH_TOOL
