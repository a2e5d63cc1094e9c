// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The shape of cross-sections and centerlines, and zero-dimensional models made of them, against closed forms.

#include <CGAL/Tubular_meshing/Centerlines/build_centerline_graph.h>
#include <CGAL/Tubular_meshing/Centerlines/cross_sections.h>
#include <CGAL/Tubular_meshing/Centerlines/zero_d_model.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/IO/write_sections.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace TM = CGAL::Tubular_meshing;
typedef nlohmann::json Json;

const double pi = std::acos(-1.);

TM::Tubular_model model_of(const TM::Tubular_skeleton& skeleton, double points = 32) {
  TM::Surface surface;
  TM::generate_tubular_surface(skeleton, surface, TM::parameters::points_per_circumference(points));
  return TM::make_tubular_model(surface);
}

/* A tube along z from a curve and a radius, both of a parameter from 0 to 1. */
template <class Curve, class Radius> TM::Tubular_skeleton skeleton_of(const Curve& curve, const Radius& radius) {
  TM::Tubular_skeleton skeleton;
  skeleton.nodes = {curve(0.), curve(1.)};
  skeleton.add_branch(0, 1, curve, radius);
  return skeleton;
}

/* Of radius a, rising by 2 π c a turn. */
struct Helix {
  double a, c, turns;
  bool is_left = false;

  TM::Point_3 operator()(double t) const {
    const double u = 2 * pi * turns * t;
    return TM::Point_3(a * std::cos(u), (is_left ? -1 : 1) * a * std::sin(u), c * u);
  }
  double curvature() const { return a / (a * a + c * c); }
  double torsion() const { return (is_left ? -1 : 1) * c / (a * a + c * c); }
};

// A graph of one branch along a curve.
template <class Curve> TM::Centerline_graph line_of(const Curve& curve, double radius, int points) {
  std::vector<TM::Point_3> line;
  std::vector<std::size_t> indices;
  for (int i = 0; i < points; ++i) {
    line.push_back(curve(double(i) / (points - 1)));
    indices.push_back(std::size_t(i));
  }
  return TM::Centerline_graph(line, std::vector<double>(line.size(), radius), {indices});
}

// Sections of nothing but lengths, where a known radius is wanted.
template <class Radius>
std::vector<TM::Cross_section> sections_of(const TM::Centerline_graph& graph, std::size_t branch, int number,
                                           const Radius& radius) {
  std::vector<TM::Cross_section> sections;
  const double length = graph.branches()[branch].length;
  for (int i = 0; i < number; ++i) {
    TM::Cross_section s;
    s.branch = branch;
    s.abscissa = length * (i + 0.5) / number;
    s.inscribed_radius = radius(s.abscissa / length);
    s.area = pi * s.inscribed_radius * s.inscribed_radius;
    sections.push_back(s);
  }
  return sections;
}

const TM::Zero_d_boundary_condition& condition_named(const TM::Zero_d_model& model, const std::string& name) {
  for (const auto& c : model.boundary_conditions)
    if (c.name == name)
      return c;
  throw std::runtime_error("there is no condition " + name);
}

Json json_of(const TM::Zero_d_model& model) {
  const std::string file = (std::filesystem::path(TUBULAR_MESHING_SCRATCH) / "zero_d_model_test.json").string();
  TM::IO::write_zero_d_model(file, model);
  std::ifstream in(file);
  Json json = Json::parse(in);
  in.close();
  std::filesystem::remove(file);
  return json;
}

} // namespace

TEST(Section_shape, Of_a_line_along_a_helix) {
  TM::Surface surface;
  TM::generate_tubular_surface(TM::straight_tube(4, 1), surface, TM::parameters::points_per_circumference(12));
  for (const Helix& helix : {Helix{3, 1, 2}, Helix{3, 1, 2, true}, Helix{2, 0.3, 2}, Helix{10, 8, 1}}) {
    const double radius = 0.5;
    const auto graph = line_of(helix, radius, 400);
    for (const auto& s : TM::cross_sections(surface, graph)) {
      const double length = graph.branches()[0].length;
      const bool is_inside = s.abscissa > 2 * radius && s.abscissa < length - 2 * radius;
      EXPECT_NEAR(s.curvature, helix.curvature(), (is_inside ? 0.01 : 0.03) * helix.curvature()) << s.abscissa;
      EXPECT_NEAR(s.torsion, helix.torsion(), (is_inside ? 0.02 : 0.1) * std::abs(helix.torsion())) << s.abscissa;
    }
  }
}

TEST(Section_shape, Is_inverse_to_the_unit) {
  TM::Surface surface;
  TM::generate_tubular_surface(TM::straight_tube(4, 1), surface, TM::parameters::points_per_circumference(12));
  const Helix small{3, 1, 2};
  const auto large = [&](double t) {
    const TM::Point_3 p = small(t);
    return TM::Point_3(1000 * p.x(), 1000 * p.y(), 1000 * p.z());
  };
  const auto a = TM::cross_sections(surface, line_of(small, 0.5, 200)),
             b = TM::cross_sections(surface, line_of(large, 500, 200));
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(a[i].curvature, 1000 * b[i].curvature, 1e-9);
    EXPECT_NEAR(a[i].torsion, 1000 * b[i].torsion, 1e-9);
  }
}

TEST(Section_shape, Of_a_straight_line_there_is_no_curvature_and_no_torsion) {
  const TM::Tubular_model model = model_of(TM::straight_tube(20, 2));
  for (const auto& s : TM::cross_sections(model.surface, model.centerlines)) {
    EXPECT_LT(s.curvature * 2, 0.02) << s.abscissa;
    EXPECT_EQ(s.torsion, 0) << s.abscissa;
    EXPECT_LT(s.eccentricity, 0.2) << s.abscissa;
    EXPECT_NEAR(s.hydraulic_diameter(), 4, 0.06) << s.abscissa;
  }
}

// Of lines that are computed from a surface, and are noisy.
TEST(Section_shape, Of_computed_centerlines) {
  const TM::Tubular_model bend = model_of(TM::curved_tube(5, pi, 1));
  std::size_t near = 0, all = 0;
  for (const auto& s : TM::cross_sections(bend.surface, bend.centerlines)) {
    if (s.abscissa < 1.5 || s.abscissa > bend.centerlines.branches()[0].length - 1.5)
      continue;
    ++all;
    near += std::abs(s.curvature - 0.2) < 0.02;
    EXPECT_NEAR(s.curvature, 0.2, 0.05) << s.abscissa;
  }
  EXPECT_GT(double(near), 0.8 * double(all));

  const Helix helix{4, 1.5, 1.5};
  const TM::Tubular_model coil = model_of(skeleton_of(helix, [](double) { return 1.; }));
  std::vector<double> curvature, torsion;
  for (const auto& s : TM::cross_sections(coil.surface, coil.centerlines))
    if (s.abscissa > 2 && s.abscissa < coil.centerlines.branches()[0].length - 2) {
      curvature.push_back(s.curvature);
      torsion.push_back(s.torsion);
    }
  std::sort(curvature.begin(), curvature.end());
  std::sort(torsion.begin(), torsion.end());
  EXPECT_NEAR(curvature[curvature.size() / 2], helix.curvature(), 0.05 * helix.curvature());
  EXPECT_NEAR(torsion[torsion.size() / 2], helix.torsion(), 0.15 * helix.torsion());
}

TEST(Section_shape, Of_an_elliptic_tube) {
  TM::Tubular_model model = model_of(TM::straight_tube(20, 1), 48);
  const double a = 1.5, b = 0.75;
  for (auto v : model.surface.vertices()) {
    const TM::Point_3 p = model.surface.point(v);
    model.surface.point(v) = TM::Point_3(a * p.x(), b * p.y(), p.z());
  }
  const auto line = [](double t) { return TM::Point_3(0, 0, 20 * t); };
  // Ramanujan's second formula
  const double h = (a - b) * (a - b) / ((a + b) * (a + b));
  const double perimeter = pi * (a + b) * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h)));
  for (const auto& s : TM::cross_sections(model.surface, line_of(line, b, 50))) {
    if (s.abscissa < 0.2 || s.abscissa > 19.8)
      continue;
    EXPECT_NEAR(s.area, pi * a * b, 0.03 * pi * a * b);
    EXPECT_NEAR(s.perimeter, perimeter, 0.02 * perimeter);
    EXPECT_NEAR(s.eccentricity, std::sqrt(1 - b * b / (a * a)), 0.01);
    EXPECT_NEAR(s.hydraulic_diameter(), 4 * pi * a * b / perimeter, 0.03 * 4 * pi * a * b / perimeter);
  }
}

TEST(Zero_d_model, Of_a_straight_tube_is_that_of_Poiseuille) {
  const auto line = [](double t) { return TM::Point_3(0, 0, 30 * t); };
  const auto graph = line_of(line, 2, 10);
  TM::Zero_d_options options;
  options.length_unit = 0.1; // millimetres
  const double r = 0.2, l = 3, h = 0.2 * r;
  for (int number : {0, 1, 2, 17}) {
    const auto model =
        TM::make_zero_d_model(graph, {}, sections_of(graph, 0, number, [](double) { return 2.; }), options, {});
    ASSERT_EQ(model.vessels.size(), 1u);
    const TM::Zero_d_vessel& v = model.vessels[0];
    EXPECT_NEAR(v.length, l, 1e-12);
    EXPECT_NEAR(v.resistance, 8 * 0.04 * l / (pi * std::pow(r, 4)), 1e-9 * v.resistance);
    EXPECT_NEAR(v.inductance, 1.06 * l / (pi * r * r), 1e-9 * v.inductance);
    EXPECT_NEAR(v.capacitance, 3 * l * pi * r * r * r / (2 * 4e6 * h), 1e-9 * v.capacitance);
  }
  options.wall_thickness = [](const TM::Cross_section&) { return 0.5; }; // millimetres
  options.youngs_modulus = 1e6;
  options.viscosity = 0.035;
  options.density = 1.05;
  const auto model = TM::make_zero_d_model(graph, {}, sections_of(graph, 0, 5, [](double) { return 2.; }), options, {});
  EXPECT_NEAR(model.vessels[0].resistance, 8 * 0.035 * l / (pi * std::pow(r, 4)), 1e-6);
  EXPECT_NEAR(model.vessels[0].inductance, 1.05 * l / (pi * r * r), 1e-9);
  EXPECT_NEAR(model.vessels[0].capacitance, 3 * l * pi * r * r * r / (2 * 1e6 * 0.05), 1e-15);
}

TEST(Zero_d_model, Of_a_taper_is_exact) {
  const double r0 = 0.3, r1 = 0.15, l = 5;
  const auto graph = line_of([&](double t) { return TM::Point_3(l * t, 0, 0); }, 0.2, 10);
  const auto radius = [&](double t) { return r0 + t * (r1 - r0); };
  const double fourth = l / (3 * (r0 - r1)) * (1 / std::pow(r1, 3) - 1 / std::pow(r0, 3)); // ∫ ds / r⁴
  for (int number : {8, 50}) {
    const auto model = TM::make_zero_d_model(graph, {}, sections_of(graph, 0, number, radius), {}, {});
    const TM::Zero_d_vessel& v = model.vessels[0];
    EXPECT_NEAR(v.resistance, 8 * 0.04 / pi * fourth, 1e-9 * v.resistance);
    EXPECT_NEAR(v.inductance, 1.06 * l / (pi * r0 * r1), 1e-9 * v.inductance);
    EXPECT_NEAR(v.capacitance, 3 * pi / (2 * 4e6 * 0.2) * l * (r0 * r0 + r0 * r1 + r1 * r1) / 3, 1e-9 * v.capacitance);
  }
}

// Through the whole way: the surface, its centerlines, its sections.
TEST(Zero_d_model, Of_generated_tubes_and_tapers_is_near_to_the_closed_form) {
  const auto axis = [](double t) { return TM::Point_3(0, 0, 20 * t); };
  for (double end : {1., 0.6}) {
    const auto radius = [&](double t) { return 1 + t * (end - 1); };
    const TM::Tubular_model model = model_of(skeleton_of(axis, radius), 40);
    const auto sections = TM::cross_sections(model.surface, model.centerlines);
    const auto zero_d = TM::make_zero_d_model(model.centerlines, model.openings, sections);
    const double fourth = end == 1 ? 20 : 20 / (3 * (1 - end)) * (1 / std::pow(end, 3) - 1);
    EXPECT_NEAR(zero_d.vessels[0].resistance, 8 * 0.04 / pi * fourth, 0.03 * 8 * 0.04 / pi * fourth);
    EXPECT_NEAR(zero_d.vessels[0].inductance, 1.06 * 20 / (pi * end), 0.02 * 1.06 * 20 / (pi * end));
    ASSERT_EQ(zero_d.boundary_conditions.size(), 2u);
    EXPECT_EQ(zero_d.vessels[0].inlet, "inlet");
    EXPECT_EQ(zero_d.vessels[0].outlet, "outlet_1");
    // of a wall shear stress of 15 dyn/cm²
    const double r = model.openings[0].radius;
    EXPECT_NEAR(condition_named(zero_d, "inlet").value, pi * r * r * r * 15 / (4 * 0.04), 1e-9);
    EXPECT_EQ(condition_named(zero_d, "outlet_1").type, TM::Zero_d_boundary_condition::pressure);
  }
}

TEST(Zero_d_model, Outlets_share_the_flow_by_the_cube_of_the_radius) {
  const TM::Tubular_model model = model_of(TM::y_bifurcation());
  const auto sections = TM::cross_sections(model.surface, model.centerlines);
  for (double exponent : {2., 2.7, 3.}) {
    TM::Zero_d_options options;
    options.murray = true;
    options.murray_exponent = exponent;
    options.flow_rate = 5;
    options.mean_pressure = 1e5;
    const auto zero_d = TM::make_zero_d_model(model.centerlines, model.openings, sections, options);
    ASSERT_EQ(zero_d.vessels.size(), 3u);
    ASSERT_EQ(zero_d.junctions.size(), 1u);
    EXPECT_EQ(zero_d.junctions[0].inlets.size(), 1u);
    EXPECT_EQ(zero_d.junctions[0].outlets.size(), 2u);
    const auto &a = condition_named(zero_d, "outlet_1"), &b = condition_named(zero_d, "outlet_2");
    EXPECT_EQ(a.type, TM::Zero_d_boundary_condition::resistance);
    // both at the mean pressure, the flows are as the powers of the radii, and add up
    const double flow_a = 1e5 / a.value, flow_b = 1e5 / b.value;
    EXPECT_NEAR(flow_a + flow_b, 5, 1e-9);
    EXPECT_NEAR(flow_a / flow_b, std::pow(model.openings[1].radius / model.openings[2].radius, exponent), 1e-9);
    EXPECT_NEAR(flow_a / flow_b, std::pow(0.8 / 0.7, exponent), 0.06); // as it was generated
    EXPECT_EQ(condition_named(zero_d, "inlet").value, 5);
  }
}

// Next to the bifurcation, planes cut several vessels at once, which would have hardly any resistance there.
TEST(Zero_d_model, Sections_of_several_vessels_do_not_count) {
  const TM::Tubular_model model = model_of(TM::y_bifurcation());
  const auto& graph = model.centerlines;
  const auto zero_d =
      TM::make_zero_d_model(graph, model.openings, TM::cross_sections(model.surface, model.centerlines));
  for (std::size_t b = 1; b < 3; ++b) {
    const double r = model.openings[b].radius;
    const std::size_t branch = model.openings[b].branch;
    const double tube = 8 * 0.04 * graph.branches()[branch].length / (pi * std::pow(r, 4));
    EXPECT_NEAR(zero_d.vessels[branch].resistance, tube, 0.25 * tube);
  }
}

TEST(Zero_d_model, Loops_and_blind_ends_have_junctions_and_conditions) {
  // a ring between two lines, and a blind branch
  const std::vector<TM::Point_3> points = {TM::Point_3(0, 0, 0),  TM::Point_3(4, 0, 0), TM::Point_3(6, 2, 0),
                                           TM::Point_3(6, -2, 0), TM::Point_3(8, 0, 0), TM::Point_3(12, 0, 0),
                                           TM::Point_3(6, 5, 0)};
  const TM::Centerline_graph graph(points, std::vector<double>(points.size(), 0.5),
                                   {{0, 1}, {1, 2}, {1, 3, 4}, {2, 4}, {4, 5}, {2, 6}});
  std::vector<TM::Cross_section> sections;
  for (std::size_t b = 0; b < graph.branches().size(); ++b)
    for (const auto& s : sections_of(graph, b, 4, [](double) { return 0.5; }))
      sections.push_back(s);
  std::vector<TM::Opening> openings(3);
  for (std::size_t n = 0; n < graph.nodes().size(); ++n)
    for (std::size_t i = 0; i < 2; ++i)
      if (graph.nodes()[n].point == (i == 0 ? 0u : 5u))
        openings[i].node = n;
  openings.push_back(openings[1]); // where another one is
  openings.push_back(openings[1]); // and one where vessels meet
  openings.back().node =
      std::size_t(std::find_if(graph.nodes().begin(), graph.nodes().end(), [](const auto& n) { return !n.is_end(); }) -
                  graph.nodes().begin());
  for (TM::Opening& o : openings)
    o.radius = 0.5;
  openings[1].name = "aorta \"a\\b\"";
  const auto model = TM::make_zero_d_model(graph, openings, sections);
  EXPECT_EQ(model.vessels.size(), 6u);
  EXPECT_EQ(model.junctions.size(), 3u);
  EXPECT_EQ(model.boundary_conditions.size(), 3u);
  EXPECT_EQ(condition_named(model, "blind_1").value, 0);
  EXPECT_EQ(condition_named(model, "blind_1").type, TM::Zero_d_boundary_condition::flow);
  EXPECT_EQ(model.openings_left_out, (std::vector<std::string>{"outlet_2", "outlet_3", "outlet_4"}));

  const Json json = json_of(model);
  std::set<std::string> names;
  for (const auto& c : json["boundary_conditions"])
    names.insert(c["bc_name"]);
  EXPECT_EQ(names, (std::set<std::string>{"inlet", "aorta \"a\\b\"", "blind_1"}));
  std::multiset<int> in_junctions, at_ends;
  for (const auto& j : json["junctions"])
    for (const char* side : {"inlet_vessels", "outlet_vessels"})
      for (int v : j[side])
        in_junctions.insert(v);
  for (const auto& v : json["vessels"]) {
    EXPECT_GT(v["zero_d_element_values"]["R_poiseuille"], 0);
    EXPECT_GT(v["zero_d_element_values"]["C"], 0);
    EXPECT_GT(v["zero_d_element_values"]["L"], 0);
    const std::size_t ends = v.contains("boundary_conditions") ? v["boundary_conditions"].size() : 0;
    EXPECT_EQ(in_junctions.count(v["vessel_id"]) + ends, 2u) << v; // each end of a vessel is somewhere
  }
  for (const char* parameter : {"number_of_cardiac_cycles", "number_of_time_pts_per_cardiac_cycle"})
    EXPECT_TRUE(json["simulation_parameters"].contains(parameter)) << parameter;

  openings[0].node = TM::Opening::no_branch;
  EXPECT_THROW(TM::make_zero_d_model(graph, openings, sections), TM::Input_error);
}

TEST(Zero_d_model, Values_that_cannot_be_are_refused) {
  const auto graph = line_of([](double t) { return TM::Point_3(t, 0, 0); }, 0.2, 4);
  const auto sections = sections_of(graph, 0, 3, [](double) { return 0.2; });
  for (double bad : {0., -1., std::nan("")})
    for (double TM::Zero_d_options::*value :
         {&TM::Zero_d_options::length_unit, &TM::Zero_d_options::density, &TM::Zero_d_options::viscosity,
          &TM::Zero_d_options::youngs_modulus, &TM::Zero_d_options::mean_pressure}) {
      TM::Zero_d_options options;
      options.*value = bad;
      EXPECT_THROW(TM::make_zero_d_model(graph, {}, sections, options, {}), TM::Parameter_error);
    }
  TM::Zero_d_options options;
  options.wall_thickness = [](const TM::Cross_section&) { return -1.; };
  EXPECT_THROW(TM::make_zero_d_model(graph, {}, sections, options, {}), TM::Input_error);
}

TEST(Sections_written, As_csv_hold_all_numbers) {
  const TM::Tubular_model model = model_of(TM::y_bifurcation(), 16);
  const auto sections = TM::cross_sections(model.surface, model.centerlines);
  const std::string file = (std::filesystem::path(TUBULAR_MESHING_SCRATCH) / "sections_test.csv").string();
  TM::IO::write_sections(file, sections);
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "branch,abscissa,x,y,z,normal_x,normal_y,normal_z,center_x,center_y,center_z,area,perimeter,"
                  "hydraulic_diameter,inscribed_radius,eccentricity,curvature,torsion");
  for (const auto& s : sections) {
    ASSERT_TRUE(std::getline(in, line));
    std::vector<double> numbers;
    std::istringstream words(line);
    for (std::string word; std::getline(words, word, ',');)
      numbers.push_back(std::stod(word));
    ASSERT_EQ(numbers.size(), 18u);
    EXPECT_EQ(numbers[0], double(s.branch));
    EXPECT_EQ(numbers[1], s.abscissa);
    EXPECT_EQ(numbers[4], s.point.z());
    EXPECT_EQ(numbers[11], s.area);
    EXPECT_EQ(numbers[13], s.hydraulic_diameter());
    EXPECT_EQ(numbers[17], s.torsion);
  }
  EXPECT_FALSE(std::getline(in, line));
  in.close();
  std::filesystem::remove(file);
  EXPECT_THROW(TM::IO::write_sections("sections.txt", sections), TM::Output_error);
  EXPECT_FALSE(TM::IO::is_supported_sections_format("sections.txt"));
  EXPECT_TRUE(TM::IO::is_supported_sections_format("a/b.vtp"));
}
