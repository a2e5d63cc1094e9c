// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Sections of lumens across their branches.

#include <CGAL/Tubular_meshing/Centerlines/cross_sections.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace TM = CGAL::Tubular_meshing;

namespace {

const double pi = std::acos(-1.);

TM::Tubular_model model_of(const TM::Tubular_skeleton& skeleton) {
  TM::Surface surface;
  TM::generate_tubular_surface(skeleton, surface, TM::parameters::points_per_circumference(24));
  return TM::make_tubular_model(surface);
}

} // namespace

TEST(Cross_sections, Those_of_a_tube_are_disks) {
  const TM::Tubular_model model = model_of(TM::straight_tube(20, 2));
  for (double spacing : {0.1, 0.5, 3.}) {
    const auto sections = TM::cross_sections(model.surface, model.centerlines, spacing);
    EXPECT_NEAR(double(sections.size()), 20 / (2 * spacing), 1 + 0.05 * 20 / (2 * spacing)) << spacing;
    for (const auto& s : sections) {
      EXPECT_NEAR(s.area, 4 * pi, 0.04 * 4 * pi) << s.abscissa;
      EXPECT_NEAR(s.radius(), 2, 0.04) << s.abscissa;
      EXPECT_NEAR(s.perimeter, 4 * pi, 0.03 * 4 * pi) << s.abscissa;
      EXPECT_LT(std::sqrt(CGAL::squared_distance(s.center, s.point)), 0.05) << s.abscissa;
      EXPECT_NEAR(s.normal.squared_length(), 1, 1e-12);
    }
  }
}

TEST(Cross_sections, Every_branch_has_its_own_in_order) {
  const TM::Tubular_model model = model_of(TM::y_bifurcation());
  const auto sections = TM::cross_sections(model.surface, model.centerlines);
  std::set<std::size_t> branches;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    branches.insert(sections[i].branch);
    EXPECT_GT(sections[i].area, 0);
    EXPECT_GE(sections[i].radius(), 0.9 * sections[i].inscribed_radius);
    if (i > 0 && sections[i].branch == sections[i - 1].branch) {
      EXPECT_GT(sections[i].abscissa, sections[i - 1].abscissa);
    }
  }
  EXPECT_EQ(branches.size(), model.centerlines.branches().size());
}

TEST(Cross_sections, They_do_not_depend_on_threads) {
  const TM::Tubular_model model = model_of(TM::straight_tube(20, 2));
  const auto one = TM::cross_sections(model.surface, model.centerlines, 0.01, 1);
  const auto two = TM::cross_sections(model.surface, model.centerlines, 0.01, 2);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i)
    EXPECT_EQ(one[i].area, two[i].area);
}

// Where the plane runs out at a border there is no loop, and no area.
TEST(Cross_sections, An_open_surface_has_them_inside_alone) {
  TM::Surface surface;
  TM::generate_tubular_surface(TM::straight_tube(20, 2), surface, TM::parameters::points_per_circumference(24));
  const TM::Tubular_model model = TM::make_tubular_model(surface);
  const auto sections = TM::cross_sections(surface, model.centerlines, 0.5);
  for (const auto& s : sections)
    if (s.abscissa > 1 && s.abscissa < 19) {
      EXPECT_NEAR(s.area, 4 * pi, 0.04 * 4 * pi);
    }
}

TEST(Cross_sections, Spacings_that_are_none_are_refused) {
  const TM::Tubular_model model = model_of(TM::straight_tube(20, 2));
  for (double spacing : {0., -1., std::nan("")})
    EXPECT_THROW(TM::cross_sections(model.surface, model.centerlines, spacing), TM::Parameter_error);
}
