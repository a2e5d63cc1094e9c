// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Walls whose thickness is given by lengths, arrays and branches, that are of several materials, and the directions of
// fibres in them; on tubes and bifurcations, where all of that is known.

#include "wall_vertices.h"

#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/IO/read_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/Layers/extrude_wall.h>
#include <CGAL/Tubular_meshing/Layers/wall_fibres.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Pipelines/make_mesh.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/base/Numbered_cells.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

namespace TM = CGAL::Tubular_meshing;
namespace labels = TM::labels;
using TM::internal::Vector_3d;

const double not_a_number = std::numeric_limits<double>::quiet_NaN();

/* A tube of quads of radius 1 along z, with caps of triangles; patches 1, 2 (z = 0) and 3. */
struct Tube {
  int sides = 32, rows = 40;
  double length = 8;

  TM::Mixed_mesh quads() const {
    TM::Mixed_mesh mesh;
    for (int k = 0; k <= rows; ++k)
      for (int i = 0; i < sides; ++i) {
        const double a = 2 * CGAL_PI * i / sides;
        mesh.points.emplace_back(std::cos(a), std::sin(a), length * k / rows);
      }
    const auto vertex = [&](int k, int i) { return std::uint32_t(k * sides + i % sides); };
    for (int k = 0; k < rows; ++k)
      for (int i = 0; i < sides; ++i)
        mesh.quads.push_back({vertex(k, i), vertex(k, i + 1), vertex(k + 1, i + 1), vertex(k + 1, i)}, labels::wall);
    const std::uint32_t center = std::uint32_t(mesh.points.size());
    mesh.points.emplace_back(0, 0, 0);
    mesh.points.emplace_back(0, 0, length);
    for (int i = 0; i < sides; ++i) {
      mesh.triangles.push_back({vertex(0, i + 1), vertex(0, i), center}, 2);
      mesh.triangles.push_back({vertex(rows, i), vertex(rows, i + 1), center + 1}, 3);
    }
    return mesh;
  }

  TM::Mixed_mesh triangles() const {
    TM::Mixed_mesh mesh = quads();
    for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
      const auto& q = mesh.quads.vertices[i];
      mesh.triangles.push_back({q[0], q[1], q[2]}, labels::wall);
      mesh.triangles.push_back({q[0], q[2], q[3]}, labels::wall);
    }
    mesh.quads = {};
    return mesh;
  }

  // The triangles with values at their points, or of their own.
  TM::Wall_array array(double (*value)(const TM::Point_3&), TM::Array_of of = TM::Array_of::points,
                       const char* name = "t", bool with_caps = false) const {
    TM::Wall_array result;
    const TM::Mixed_mesh mesh = triangles();
    result.name = name;
    result.of = of;
    result.points = mesh.points;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      if (mesh.triangles.label[i] != labels::wall && !with_caps)
        continue;
      const auto& t = mesh.triangles.vertices[i];
      result.triangles.push_back({t[0], t[1], t[2]});
      if (of == TM::Array_of::triangles)
        result.values.push_back(value(CGAL::centroid(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]])));
    }
    if (of == TM::Array_of::points)
      for (const TM::Point_3& p : mesh.points)
        result.values.push_back(value(p));
    return result;
  }
};

double one(const TM::Point_3&) {
  return 1;
}
double linear(const TM::Point_3& p) {
  return 0.1 + 0.03 * p.z();
}
double bumpy(const TM::Point_3& p) {
  return 0.2 + 0.1 * std::sin(p.z()) * p.x();
}
double step(const TM::Point_3& p) {
  return p.z() < 4 ? 0.15 : 0.3;
}

/* The thickness at each vertex of the lumen's surface, whose points come first, of a wall whose points come layer by
 * layer behind the others. */
struct Measured {
  std::vector<TM::Point_3> points;
  std::vector<double> thickness, first; // the latter of the first wall, where there are two
};

Measured measured(const TM::Mixed_mesh& mesh, int layers, int first_layers = 0) {
  const std::set<std::uint32_t> vertices = wall_vertices(mesh);
  const std::vector<std::uint32_t> base(vertices.begin(), vertices.end());
  const std::size_t before = mesh.points.size() - std::size_t(layers) * base.size();
  Measured result;
  const auto distance = [&](std::size_t i, int layer) {
    return std::sqrt(
        CGAL::squared_distance(mesh.points[base[i]], mesh.points[before + std::size_t(layer - 1) * base.size() + i]));
  };
  for (std::size_t i = 0; i < base.size(); ++i) {
    result.points.push_back(mesh.points[base[i]]);
    result.thickness.push_back(distance(i, layers));
    if (first_layers > 0)
      result.first.push_back(distance(i, first_layers));
  }
  return result;
}

// Of the wall alone: the caps are those of a lumen that has no cells here.
void expect_valid(TM::Mixed_mesh mesh) {
  const auto triangles = mesh.triangles;
  mesh.triangles = {};
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (triangles.label[i] != 2 && triangles.label[i] != 3)
      mesh.triangles.push_back(triangles.vertices[i], triangles.label[i]);
  TM::Validity_report report = TM::validity_report(mesh);
  EXPECT_LE(report.unused_points, 2u); // the middles of the caps
  report.unused_points = 0;
  report.region_components.erase(report.region_components.lower_bound(labels::wall_region),
                                 report.region_components.end());
  EXPECT_EQ(report.defects(), "");
}

std::string refusal(const TM::Wall_array& array) {
  try {
    TM::thickness_of_array(array);
  } catch (const TM::Input_error& e) {
    return e.what();
  }
  return "";
}

std::map<int, std::size_t> cells_by_region(const TM::Mixed_mesh& mesh) {
  std::map<int, std::size_t> number;
  for (const auto* block : {&mesh.tetrahedra.label, &mesh.prisms.label, &mesh.hexahedra.label})
    for (int region : *block)
      ++number[region];
  return number;
}

} // namespace

TEST(Varying_walls, A_length_is_the_thickness_everywhere) {
  for (double length : {0.05, 0.3, 0.8})
    for (bool tetrahedral : {false, true}) {
      TM::Mixed_mesh mesh = Tube().triangles();
      const auto np = TM::parameters::wall_thickness(TM::Wall_thickness::of_length(length)).wall_layers(3);
      const TM::Layer_report report = TM::extrude_wall(mesh, one, np.tetrahedral_wall(tetrahedral));
      EXPECT_EQ(report.reduced_vertices, 0u);
      EXPECT_EQ(report.steep_vertices, 0u);
      for (double t : measured(mesh, 3).thickness)
        EXPECT_NEAR(t, length, 1e-3 * length);
    }
}

TEST(Varying_walls, An_array_gives_the_thickness_on_another_subdivision) {
  const Tube fine{67, 91}, coarse{24, 24};
  for (double (*value)(const TM::Point_3&) : {linear, bumpy})
    for (TM::Array_of of : {TM::Array_of::points, TM::Array_of::triangles}) {
      TM::Mixed_mesh meshes[] = {coarse.triangles(), coarse.quads()};
      for (TM::Mixed_mesh& mesh : meshes) {
        const auto np = TM::parameters::wall_thickness(TM::thickness_of_array(fine.array(value, of))).wall_layers(2);
        EXPECT_EQ(TM::extrude_wall(mesh, one, np).steep_vertices, 0u);
        const Measured m = measured(mesh, 2);
        for (std::size_t i = 0; i < m.points.size(); ++i)
          EXPECT_NEAR(m.thickness[i], value(m.points[i]), 0.015) << m.points[i];
      }
    }
}

// Values of triangles that jump pass over from one to the other, and no faster than a wall can.
TEST(Varying_walls, Steps_become_slopes) {
  TM::Mixed_mesh mesh = Tube{32, 80}.triangles();
  const TM::Wall_array array = Tube{32, 80}.array(step, TM::Array_of::triangles);
  TM::extrude_wall(mesh, one, TM::parameters::wall_thickness(TM::thickness_of_array(array)).wall_layers(2));
  const Measured m = measured(mesh, 2);
  double below = 0, above = 0;
  for (std::size_t i = 0; i < m.points.size(); ++i) {
    if (m.points[i].z() < 3.8)
      below = (std::max)(below, std::abs(m.thickness[i] - 0.15));
    if (m.points[i].z() > 4.7)
      above = (std::max)(above, std::abs(m.thickness[i] - 0.3));
    for (std::size_t j = 0; j < i; ++j) {
      const double d = std::sqrt(CGAL::squared_distance(m.points[i], m.points[j]));
      if (d < 0.3) {
        EXPECT_LE(std::abs(m.thickness[i] - m.thickness[j]), 0.41 * d);
      }
    }
  }
  EXPECT_LT(below, 1e-3);
  EXPECT_LT(above, 1e-3);
}

TEST(Varying_walls, Thickness_that_is_too_steep_is_reported) {
  TM::Mixed_mesh mesh = Tube{32, 80}.triangles();
  const auto jump = [](const TM::Point_3& p) { return p.z() < 4 ? 0.1 : 0.9; };
  const TM::Layer_report report =
      TM::extrude_wall(mesh, one, TM::parameters::wall_thickness(TM::Wall_thickness(jump)).wall_layers(1));
  EXPECT_GT(report.steep_vertices, 32u);
  EXPECT_LT(report.steep_vertices, 32u * 25);
  EXPECT_NE(report.text().find("more than 0.4"), std::string::npos) << report.text();
}

TEST(Varying_walls, Values_that_are_no_thickness_are_refused) {
  for (double bad : {0., -0.1, not_a_number, std::numeric_limits<double>::infinity()})
    for (TM::Array_of of : {TM::Array_of::points, TM::Array_of::triangles}) {
      TM::Wall_array array = Tube().array(linear, of, "wall width");
      EXPECT_EQ(refusal(array), "");
      array.values[200] = array.values[201] = bad;
      const std::string sentence = refusal(array);
      EXPECT_NE(sentence.find("\"wall width\" has 2 values"), std::string::npos) << sentence;
      EXPECT_NE(sentence.find("thicker than 0"), std::string::npos) << sentence;
    }
  TM::Wall_array empty;
  empty.name = "t";
  EXPECT_NE(refusal(empty).find("no values"), std::string::npos);
}

TEST(Varying_walls, What_an_array_says_on_caps_does_not_count) {
  TM::Surface surface;
  TM::generate_tubular_surface(TM::straight_tube(8, 1), surface, TM::parameters::points_per_circumference(20));
  const TM::Tubular_model model = TM::make_tubular_model(surface);
  for (TM::Array_of of : {TM::Array_of::points, TM::Array_of::triangles}) {
    TM::Wall_array array = Tube().array(linear, of, "t", true);
    const std::size_t triangles = array.triangles.size(), caps = 2 * 32;
    for (std::size_t i = 0; i < triangles; ++i) {
      const auto& t = array.triangles[i];
      const double z = array.points[t[0]].z();
      const bool is_cap = array.points[t[1]].z() == z && array.points[t[2]].z() == z;
      if (is_cap && of == TM::Array_of::triangles)
        array.values[i] = not_a_number;
      for (std::size_t v : t)
        if (is_cap && of == TM::Array_of::points && array.points[v].x() == 0)
          array.values[v] = 0;
    }
    EXPECT_NE(refusal(array), "");
    TM::keep_wall(array, {&model});
    EXPECT_EQ(refusal(array), "");
    EXPECT_EQ(array.triangles.size(), triangles - caps);
  }
}

TEST(Varying_walls, Lengths_in_another_unit_are_refused) {
  TM::Mixed_mesh mesh = Tube().triangles();
  for (double bad : {11., 0., -1., not_a_number}) {
    const auto np = TM::parameters::wall_thickness(TM::Wall_thickness([bad](const TM::Point_3&) { return bad; }));
    EXPECT_THROW(TM::extrude_wall(mesh, one, np), TM::Input_error) << bad;
  }
  EXPECT_THROW(TM::extrude_wall(mesh, one, TM::parameters::wall_thickness(11)), TM::Parameter_error);
}

TEST(Varying_walls, Two_walls_have_their_own_thickness_each) {
  for (bool tetrahedral : {false, true}) {
    TM::Mixed_mesh mesh = Tube().triangles();
    const auto np = TM::parameters::wall_thickness(TM::Wall_thickness(linear))
                        .wall_layers(2)
                        .second_wall_thickness(0.1)
                        .second_wall_layers(3)
                        .tetrahedral_wall(tetrahedral);
    TM::extrude_wall(mesh, one, np);
    expect_valid(mesh);
    const Measured m = measured(mesh, 5, 2);
    for (std::size_t i = 0; i < m.points.size(); ++i) {
      EXPECT_NEAR(m.first[i], linear(m.points[i]), 2e-3);
      EXPECT_NEAR(m.thickness[i], linear(m.points[i]) + 0.1, 3e-3);
    }
  }
}

TEST(Varying_walls, Multiples_and_lengths_that_agree_make_the_same_wall) {
  TM::Mixed_mesh by_radius = Tube().triangles(), by_length = Tube().triangles();
  TM::extrude_wall(by_radius, one, TM::parameters::wall_thickness(0.25).second_wall_thickness(0.125));
  TM::extrude_wall(by_length, one,
                   TM::parameters::wall_thickness(TM::Wall_thickness::of_length(0.25))
                       .second_wall_thickness(TM::Wall_thickness::of_length(0.125)));
  ASSERT_EQ(by_radius.points.size(), by_length.points.size());
  for (std::size_t i = 0; i < by_radius.points.size(); ++i)
    EXPECT_LT(CGAL::squared_distance(by_radius.points[i], by_length.points[i]), 1e-24);
}

TEST(Varying_walls, Branches_have_their_thickness_and_pass_over_at_bifurcations) {
  TM::Surface surface;
  TM::generate_tubular_surface(TM::y_bifurcation(), surface, TM::parameters::points_per_circumference(24));
  const TM::Tubular_model model = TM::make_tubular_model(surface);
  const auto& graph = model.centerlines;
  ASSERT_EQ(graph.branches().size(), 3u);
  const std::map<std::size_t, double> table = {{0, 0.3}, {1, 0.1}, {2, 0.2}};
  const TM::Wall_thickness thickness = TM::thickness_of_branches(graph, table);
  for (std::size_t b = 0; b < 3; ++b) {
    const auto& branch = graph.branches()[b];
    for (std::size_t i = 0; i < branch.points.size(); ++i) {
      const double t = thickness(graph.points()[branch.points[i]], 1);
      const double to_bifurcation = b == 0 ? branch.length - branch.abscissa[i] : branch.abscissa[i];
      if (to_bifurcation > (std::min)(2.5, 0.5 * branch.length)) {
        EXPECT_NEAR(t, table.at(b), 1e-9) << b << " " << to_bifurcation;
      }
      if (to_bifurcation == 0) {
        EXPECT_NEAR(t, 0.2, 1e-9);
      }
    }
  }
  const TM::Wall_thickness others = TM::thickness_of_branches(graph, {{1, 0.1}}, 0.3);
  EXPECT_NEAR(others(graph.points()[graph.branches()[2].points.back()], 1), 0.3, 1e-9);
  EXPECT_THROW(TM::thickness_of_branches(graph, {{0, 0.3}, {1, 0.1}}), TM::Input_error);
  EXPECT_THROW(TM::thickness_of_branches(graph, {{3, 0.3}}, 0.1), TM::Input_error);
  EXPECT_THROW(TM::thickness_of_branches(graph, {{0, -0.3}}, 0.1), TM::Input_error);
  EXPECT_THROW(TM::thickness_of_branches(graph, {}, not_a_number), TM::Input_error);
}

// In the model's own frame, which is turned and scaled, functions are still asked in the unit and place of the model.
TEST(Varying_walls, Meshers_ask_for_the_thickness_in_the_frame_of_the_model) {
  TM::Surface surface;
  TM::generate_tubular_surface(TM::straight_tube(80, 10), surface, TM::parameters::points_per_circumference(20));
  for (auto v : surface.vertices()) { // along x, far from the origin
    const TM::Point_3 p = surface.point(v);
    surface.point(v) = TM::Point_3(p.z() + 500, p.x() - 300, p.y());
  }
  const auto thickness = [](const TM::Point_3& p) { return 1 + 0.03 * (p.x() - 500); };
  const auto area = [](const TM::Point_3& p) { return p.x() > 540 ? labels::first_material : labels::wall_region; };
  TM::Mesher_options options(
      TM::parameters::points_per_circumference(16).wall_thickness(TM::Wall_thickness(thickness)).wall_layers(2));
  options.wall->materials.region = area;
  options.wall->materials.names = {{labels::first_material, "graft"}};
  TM::Mesher mesher(TM::make_tubular_model(surface), options);
  const TM::Mixed_mesh mesh = mesher.hexahedral();
  expect_valid(mesh);
  EXPECT_EQ(mesh.region_names.at(labels::first_material), "graft");
  const Measured m = measured(mesh, 2);
  for (std::size_t i = 0; i < m.points.size(); ++i)
    EXPECT_NEAR(m.thickness[i], thickness(m.points[i]), 0.02 * thickness(m.points[i])) << m.points[i];
  const TM::internal::cells::Numbered_cells cells(mesh);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (cells.region(c) < labels::wall_region)
      continue;
    double x = 0;
    for (std::uint32_t v : cells.corners(c))
      x += mesh.points[v].x() / double(cells.corners(c).number);
    if (std::abs(x - 540) > 0.5) {
      EXPECT_EQ(cells.region(c) == labels::first_material, x > 540) << x;
    }
  }
}

TEST(Wall_materials, Areas_of_an_array_are_regions) {
  // 0 is the wall; a ring, and a patch on one side of it in two pieces
  const auto value = [](const TM::Point_3& p) {
    return p.z() > 3 && p.z() < 4 ? 7. : p.x() > 0.5 && (p.z() < 2 || p.z() > 6) ? -3. : 0.;
  };
  const Tube fine{64, 96}, coarse{32, 32};
  const TM::Wall_array array = fine.array(value, TM::Array_of::triangles, "tissue");
  const TM::Wall_materials materials = TM::materials_of_array(array, {{7, "stent"}});
  EXPECT_EQ(materials.names, (TM::Label_names{{4, "tissue_-3"}, {5, "stent"}}));
  for (int kind = 0; kind < 3; ++kind) {
    TM::Mixed_mesh mesh = kind == 2 ? coarse.quads() : coarse.triangles();
    const auto np = TM::parameters::wall_thickness(0.2).wall_layers(3).tetrahedral_wall(kind == 1);
    TM::extrude_wall(mesh, one, np.wall_materials(materials).second_wall_thickness(0.1).second_wall_layers(2));
    expect_valid(mesh);
    EXPECT_EQ(mesh.region_names.at(2), "wall");
    EXPECT_EQ(mesh.region_names.at(3), "second_wall");
    EXPECT_EQ(mesh.region_names.at(4), "tissue_-3");
    EXPECT_EQ(mesh.region_names.at(5), "stent");
    EXPECT_EQ(mesh.patch_names.at(200), "material_interface");
    const std::map<int, std::size_t> cells = cells_by_region(mesh);
    const double all = double(cells.at(2) + cells.at(4) + cells.at(5));
    EXPECT_NEAR(double(cells.at(5)), all / 8, 1e-9); // four rows of 32
    // a third of the circumference, of half the length
    EXPECT_NEAR(double(cells.at(4)), all / 6, all / 40);
    EXPECT_EQ(cells.at(3), std::size_t(all) * 2 / 3);
  }
}

TEST(Wall_materials, Each_column_is_of_one_material) {
  TM::Mixed_mesh mesh = Tube().triangles();
  const auto value = [](const TM::Point_3& p) { return p.x() > 0.3 * std::sin(p.z()) ? 2. : 0.; };
  const auto materials = TM::materials_of_array(Tube{50, 61}.array(value), {{2, "plaque"}, {0, "media"}});
  EXPECT_EQ(materials.names, (TM::Label_names{{4, "media"}, {5, "plaque"}})); // 0 has a name of its own
  TM::extrude_wall(mesh, one, TM::parameters::wall_materials(materials).wall_layers(4));
  expect_valid(mesh);
  EXPECT_EQ(mesh.region_names.count(labels::wall_region), 0u);
  const std::size_t n = mesh.prisms.size() / 4;
  std::size_t of_first_layer = 0;
  for (std::size_t i = 0; i < mesh.prisms.size(); ++i) {
    EXPECT_EQ(mesh.prisms.label[i], mesh.prisms.label[i % n]);
    of_first_layer += i < n && mesh.prisms.label[i] == 5;
  }
  EXPECT_NEAR(double(of_first_layer), 0.5 * double(n), 0.05 * double(n));
}

TEST(Wall_materials, Names_do_not_clash_and_the_walls_own_is_known) {
  const auto value = [](const TM::Point_3& p) { return std::floor(p.z() / 2); };
  const TM::Wall_array array = Tube().array(value, TM::Array_of::triangles);
  const auto materials = TM::materials_of_array(array, {{1, "lumen"}, {2, "wall"}, {3, "lumen"}});
  EXPECT_EQ(materials.names, (TM::Label_names{{4, "lumen_2"}, {5, "lumen_3"}}));
  EXPECT_EQ(materials.region(TM::Point_3(1, 0, 1)), labels::wall_region);
  EXPECT_EQ(materials.region(TM::Point_3(1, 0, 3)), 4);
  EXPECT_EQ(materials.region(TM::Point_3(1, 0, 5)), labels::wall_region);
  EXPECT_EQ(materials.region(TM::Point_3(1, 0, 7)), 5);
}

TEST(Wall_materials, Values_that_are_no_integers_are_refused) {
  for (double bad : {0.5, not_a_number, 1e12})
    for (TM::Array_of of : {TM::Array_of::points, TM::Array_of::triangles}) {
      TM::Wall_array array = Tube().array([](const TM::Point_3&) { return 1.; }, of);
      array.values[100] = bad;
      EXPECT_THROW(TM::materials_of_array(array), TM::Input_error) << bad;
    }
}

TEST(Wall_fibres, In_a_tube_they_run_round_and_along_it) {
  for (bool quads : {false, true}) {
    TM::Mixed_mesh mesh = quads ? Tube().quads() : Tube().triangles();
    TM::extrude_wall(mesh, one, TM::parameters::wall_thickness(0.4).wall_layers(3));
    const TM::Centerline_graph graph({TM::Point_3(0, 0, 0), TM::Point_3(0, 0, 8)}, {1, 1}, {{0, 1}});
    const TM::Wall_fibres fibres = TM::wall_fibres(mesh, graph);
    EXPECT_EQ(fibres.cells, mesh.number_of_cells());
    EXPECT_EQ(fibres.undirected, 0u);
    const TM::internal::cells::Numbered_cells cells(mesh);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      double x = 0, y = 0;
      for (std::uint32_t v : cells.corners(c)) {
        x += mesh.points[v].x();
        y += mesh.points[v].y();
      }
      const double r = std::sqrt(x * x + y * y);
      const auto* l = &fibres.longitudinal.values[3 * c];
      const auto* t = &fibres.circumferential.values[3 * c];
      EXPECT_GT(l[2], 1 - 1e-6);
      EXPECT_GT(t[0] * -y / r + t[1] * x / r, 1 - 1e-3); // radial, circumferential, longitudinal: right-handed
      EXPECT_NEAR(l[0] * t[0] + l[1] * t[1] + l[2] * t[2], 0, 1e-12);
    }
  }
}

TEST(Wall_fibres, In_a_bend_they_follow_the_centerline) {
  const TM::Tubular_skeleton bend = TM::curved_tube(5, CGAL_PI / 2, 1);
  TM::Surface surface;
  TM::generate_tubular_surface(bend, surface, TM::parameters::points_per_circumference(24));
  const TM::Tubular_model model = TM::make_tubular_model(surface);
  std::vector<std::size_t> line;
  for (std::size_t i = 0; i < bend.branches[0].points.size(); ++i)
    line.push_back(i);
  const TM::Centerline_graph graph(bend.branches[0].points, bend.branches[0].radius, {line});
  const TM::Extruded_wall wall = TM::extrude_wall(model.surface, model.patch, one, TM::parameters::wall_layers(2));
  const TM::Wall_fibres fibres = TM::wall_fibres(wall.mesh, graph);
  const TM::internal::cells::Numbered_cells cells(wall.mesh);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    Vector_3d p;
    for (std::uint32_t v : cells.corners(c))
      p += (1. / 6) * Vector_3d(wall.mesh.points[v]);
    const double r = std::sqrt(p.x * p.x + p.z * p.z); // the bend is in the plane y = 0, around the origin
    const Vector_3d along(-p.z / r, 0, p.x / r);
    const double* l = &fibres.longitudinal.values[3 * c];
    EXPECT_GT(std::abs(along.x * l[0] + along.z * l[2]), std::cos(4 * CGAL_PI / 180))
        << p.x << " " << p.y << " " << p.z;
  }
}

TEST(Wall_fibres, There_are_none_in_the_lumen_or_without_a_wall) {
  TM::Mixed_mesh mesh = Tube{16, 16}.triangles();
  const TM::Centerline_graph graph({TM::Point_3(0, 0, 0), TM::Point_3(0, 0, 8)}, {1, 1}, {{0, 1}});
  EXPECT_THROW(TM::wall_fibres(mesh, graph), TM::Input_error);
  TM::Surface surface;
  TM::generate_tubular_surface(TM::straight_tube(8, 1), surface, TM::parameters::points_per_circumference(16));
  const TM::Tubular_model model = TM::make_tubular_model(surface);
  mesh = TM::make_isotropic_mesh(model, TM::parameters::points_per_circumference(10));
  TM::extrude_wall(mesh, one);
  const TM::Wall_fibres fibres = TM::wall_fibres(mesh, model.centerlines);
  EXPECT_EQ(fibres.cells, mesh.prisms.size());
  ASSERT_EQ(fibres.longitudinal.values.size(), 3 * mesh.number_of_cells());
  for (std::size_t i = 0; i < 3 * mesh.tetrahedra.size(); ++i)
    EXPECT_EQ(fibres.longitudinal.values[i], 0);
  const auto one_thread = TM::wall_fibres(mesh, model.centerlines, 1);
  EXPECT_EQ(one_thread.circumferential.values, fibres.circumferential.values);
}

TEST(Cell_arrays, That_do_not_fit_are_refused) {
  TM::Mixed_mesh mesh = Tube{16, 16}.triangles();
  TM::extrude_wall(mesh, one);
  const std::filesystem::path folder = std::filesystem::path(TUBULAR_MESHING_SCRATCH) / "cell_arrays";
  std::filesystem::create_directories(folder);
  const std::vector<TM::Cell_array> short_ones = {{"a", 3, std::vector<double>(5)}};
  EXPECT_THROW(TM::IO::write_mesh((folder / "m.vtu").string(), mesh, short_ones), TM::Output_error);
  const std::vector<TM::Cell_array> arrays = {{"a", 1, std::vector<double>(mesh.number_of_cells(), 2.5)}};
  for (const char* name : {"m.su2", "m.cas", "m.mesh"}) {
    EXPECT_THROW(TM::IO::write_mesh((folder / name).string(), mesh, arrays), TM::Output_error) << name;
    EXPECT_NE(TM::IO::why_no_cell_arrays(TM::IO::mesh_format_of(name)), "");
  }
  EXPECT_THROW(TM::IO::write_mesh((folder / "m.inp").string(), mesh, arrays), TM::Output_error); // but for fibres
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  for (const char* name : {"m.vtu", "m.msh"}) { // labels and points come back as they would without
    TM::IO::write_mesh((folder / name).string(), mesh, arrays);
    TM::Mixed_mesh read;
    TM::IO::read_mesh((folder / name).string(), read);
    EXPECT_EQ(read.prisms.vertices, mesh.prisms.vertices) << name;
    EXPECT_EQ(read.triangles.label, mesh.triangles.label) << name;
  }
  std::filesystem::remove_all(folder);
}
