// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Which ends of closed surfaces are vessels, and are cut open, and which are sacs or bumps.

#include "round_ends.h"

#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Openings/cut_round_ends.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace round_ends;
namespace np = tubular::parameters;
typedef std::vector<tubular::Round_end_report> Reports;

std::set<double> rounded_radii(const std::vector<tubular::Opening>& openings) {
  std::set<double> radii;
  for (const auto& o : openings)
    radii.insert(std::round(10 * o.radius) / 10);
  return radii;
}

std::size_t number_with(const Reports& reports, const std::string& reason) {
  return std::size_t(std::count_if(reports.begin(), reports.end(), [&](const auto& r) { return r.reason == reason; }));
}

// Cuts the ends of a closed vessel, turned, in a unit of its own.
Reports expect_openings(const Skeleton& skeleton, std::size_t number, double n, double scale, double angle) {
  Mesh mesh = round_tree(skeleton, n);
  move(mesh, scale, angle);
  const Reports reports = tubular::cut_round_ends(mesh);
  EXPECT_EQ(number_with(reports, ""), number);
  EXPECT_EQ(number_with(reports, "cannot be cut"), 0u);
  EXPECT_EQ(tubular::find_openings(mesh).size(), number);
  return reports;
}

// A trunk and two branches that part widely, so that there is room for a sac between them; the fork is node 1.
Skeleton wide_fork() {
  Skeleton s;
  s.nodes = {Point(0, 0, 0)};
  const std::size_t fork = add_tube(s, 0, Point(0, 0, 8), 1, 1);
  add_tube(s, fork, Point(10, 0, 11), 0.8, 0.8);
  add_tube(s, fork, Point(-10, 0, 10), 0.7, 0.7);
  return s;
}

struct Sac {
  double ratio; ///< of its radius to the vessel's
  int lobes;
  double neck;
};

// Of all sizes, some with lobes; those with lobes are much wider than the vessel.
std::vector<Sac> sacs() {
  std::vector<Sac> result;
  for (double ratio : {1.2, 1.6, 2.4, 4.})
    for (int lobes : {0, 1, 2, 3, 4})
      for (double neck : {0.5, 0.8})
        if (lobes == 0 || ratio > 1.5)
          result.push_back({ratio, lobes, neck});
  return result;
}

// Different ones in different directions, units and resolutions.
template <class Add_sac> void check_sacs(const Skeleton& vessel, std::size_t openings, const Add_sac& add) {
  int number = 0;
  for (const Sac& sac : sacs()) {
    SCOPED_TRACE("ratio " + std::to_string(sac.ratio) + ", lobes " + std::to_string(sac.lobes) + ", neck " +
                 std::to_string(sac.neck));
    Skeleton s = vessel;
    add(s, sac);
    const double scale = std::array<double, 3>{{1, 1e-3, 1e3}}[std::size_t(number % 3)];
    expect_openings(s, openings, number % 2 == 0 ? 14 : 24, scale, 0.4 * number);
    ++number;
  }
}

#ifdef TUBULAR_MESHING_SHARED_DATA
// The ends of a surface of real vessels that have been closed by domes of a height, in radii, and cut open again.
void check_domed(const std::string& file, double height, std::size_t least, std::size_t most) {
  const std::string path = std::string(TUBULAR_MESHING_SHARED_DATA) + "/" + file;
  if (!std::filesystem::exists(path))
    GTEST_SKIP() << file << " is not there";
  Mesh mesh;
  tubular::IO::read_surface(path, mesh);
  const auto truth = tubular::find_openings(mesh);
  dome_openings(mesh, height);
  tubular::cut_round_ends(mesh);
  const auto openings = tubular::find_openings(mesh);
  std::size_t found = 0;
  for (const auto& o : truth)
    found += std::any_of(openings.begin(), openings.end(),
                         [&](const auto& p) {
                           return tubular::internal::point_distance(o.center, p.center) < 2 * o.radius &&
                                  std::abs(p.radius - o.radius) < 0.25 * o.radius;
                         })
                 ? 1
                 : 0;
  EXPECT_GE(found, least) << "height " << height;
  EXPECT_LE(openings.size(), most) << "height " << height;
}
#endif

} // namespace

// --- ends of vessels ---

TEST(Round_ends, Each_is_cut_across_its_vessel) {
  const Skeleton s = tubular::y_bifurcation();
  for (double scale : {1., 1e-3, 1e3})
    for (double n : {14., 24.}) {
      Mesh mesh = round_tree(s, n);
      move(mesh, scale);
      const auto report = tubular::cut_round_ends(mesh);
      EXPECT_EQ(std::count_if(report.begin(), report.end(), [](const auto& r) { return r.is_cut; }), 3);
      auto openings = tubular::find_openings(mesh);
      ASSERT_EQ(openings.size(), 3u);
      for (auto& o : openings)
        o.radius /= scale;
      EXPECT_EQ(rounded_radii(openings), (std::set<double>{0.7, 0.8, 1}));
    }
}

TEST(Round_ends, A_closed_surface_becomes_a_model_with_all_openings) {
  const auto model = tubular::make_tubular_model(round_tree(tubular::aortic_arch(), 16));
  EXPECT_EQ(model.openings.size(), 5u);
  EXPECT_EQ(model.round_ends.size(), 5u);
}

TEST(Round_ends, Those_at_points_are_cut_and_others_stay) {
  const Skeleton s = tubular::y_bifurcation();
  const auto ends = s.ends();
  const std::vector<Point> two = {ends[0].center, ends[1].center};
  EXPECT_EQ(tubular::make_tubular_model(round_tree(s, 16), np::seeds(two)).openings.size(), 2u);
  Mesh mesh = round_tree(s, 16);
  const auto report = tubular::cut_round_ends(mesh, np::blind_ends(std::vector<Point>{ends[2].center}));
  EXPECT_EQ(tubular::find_openings(mesh).size(), 2u);
  EXPECT_EQ(std::count_if(report.begin(), report.end(), [](const auto& r) { return r.reason == "kept"; }), 1);
}

TEST(Round_ends, Domes_of_any_height_close_vessels_whether_creases_bound_them_or_not) {
  for (double n : {12., 24.})
    for (double height : {0.3, 0.45, 0.6, 0.8, 1.2, 1.6}) {
      SCOPED_TRACE("height " + std::to_string(height) + ", n " + std::to_string(n));
      Mesh mesh;
      tubular::generate_tubular_surface(tubular::y_bifurcation(), mesh, np::points_per_circumference(n));
      dome_openings(mesh, height);
      EXPECT_EQ(tubular::make_tubular_model(mesh).openings.size(), 3u);
    }
}

TEST(Round_ends, A_needle_in_a_dome_or_in_a_sac_does_not_matter) {
  const Skeleton y = tubular::y_bifurcation();
  for (double out : {-0.8, 0.8, 1.6}) {
    Mesh mesh = round_tree(y, 20);
    for (const End& end : y.ends()) {
      auto& p = mesh.point(outermost(mesh, end.center, end.normal, 1.5 * end.radius));
      p = p + out * end.radius * end.normal;
    }
    const Reports reports = tubular::cut_round_ends(mesh);
    EXPECT_EQ(number_with(reports, ""), 3u) << out;
    EXPECT_EQ(reports.size(), 3u) << out;
  }
  Skeleton s = tube_with_node();
  add_sac(s, 1, Vector(1, 0, 0), 3.8, 2.4, 0.6, 3);
  for (double angle : {0., 0.8, 1.6, 2.4}) {
    Mesh mesh = round_tree(s, 20);
    const Point center(3.8, 0, 7);
    const Vector way(std::cos(angle) * std::cos(angle), std::sin(angle), std::cos(angle) * std::sin(angle));
    auto& p = mesh.point(outermost(mesh, center, normalized(way), 4));
    p = p - 1.2 * normalized(way);
    const Reports reports = tubular::cut_round_ends(mesh);
    EXPECT_EQ(number_with(reports, ""), 2u) << angle;
    EXPECT_EQ(number_with(reports, "sac"), 1u) << angle;
  }
}

// --- sacs ---

TEST(Round_ends, A_sac_is_none_unless_a_point_names_it) {
  Skeleton s = tube_with_node();
  add_sac(s, 1, Vector(1, 0, 0), 2.9, 1.5, 0.5);
  const Reports reports = expect_openings(s, 2, 20, 1, 0);
  EXPECT_EQ(number_with(reports, "sac"), 1u);
  Mesh mesh = round_tree(s, 20);
  const std::vector<Point> tip = {Point(4.4, 0, 7)};
  tubular::cut_round_ends(mesh, np::ends_to_cut(tip));
  EXPECT_EQ(tubular::find_openings(mesh).size(), 3u);
}

TEST(Round_ends, A_sac_at_the_side_is_none_however_many_lobes_it_has) {
  check_sacs(tube_with_node(), 2, [](Skeleton& s, const Sac& sac) {
    add_sac(s, 1, Vector(1, 0, 0.2), 1.4 + sac.ratio, sac.ratio, sac.neck, sac.lobes);
  });
}

TEST(Round_ends, A_sac_that_sits_on_its_vessel_broadly_is_none) {
  check_sacs(tube_with_node(), 2, [](Skeleton& s, const Sac& sac) {
    add_sac(s, 1, Vector(1, 0, 0), 0.7 + 0.8 * sac.ratio, sac.ratio, sac.neck, sac.lobes);
  });
}

TEST(Round_ends, A_sac_in_a_fork_is_none) {
  check_sacs(wide_fork(), 3, [](Skeleton& s, const Sac& sac) {
    add_sac(s, 1, Vector(0, 0.2, 1), 1.6 + sac.ratio, sac.ratio, sac.neck, sac.lobes);
  });
}

// The longest ways along the wall lead to the sac, and from there to the ends on both sides of it.
TEST(Round_ends, A_short_vessel_along_a_broad_sac_has_its_ends) {
  int number = 0;
  for (double ratio : {1.9, 2.4, 3.})
    for (double gap : {0.75, 1.2})
      for (double neck : {0.5, 0.8})
        for (bool has_fork : {false, true}) {
          SCOPED_TRACE("ratio " + std::to_string(ratio) + ", gap " + std::to_string(gap) + ", neck " +
                       std::to_string(neck) + (has_fork ? ", with a fork" : ""));
          Skeleton s = tube_with_node(7);
          if (has_fork) {
            add_tube(s, 2, s.nodes[2] + Vector(0, 4, 4), 0.75, 0.75);
            add_tube(s, 2, s.nodes[2] + Vector(0, -4, 4), 0.7, 0.7);
          }
          add_sac(s, 1, Vector(1, 0, 0.3), ratio + gap, ratio, neck, ratio > 2 ? number % 3 : 0);
          const double scale = std::array<double, 3>{{1, 1e-3, 1e3}}[std::size_t(number % 3)];
          expect_openings(s, has_fork ? 3 : 2, number % 2 == 0 ? 14 : 22, scale, 0.4 * number);
          ++number;
        }
}

TEST(Round_ends, A_vessel_that_widens_in_its_middle_has_its_two_ends) {
  for (double ratio : {1.2, 1.6, 2.4, 4.})
    for (double n : {14., 24.}) {
      SCOPED_TRACE("ratio " + std::to_string(ratio));
      const Reports reports = expect_openings(spindle(ratio), 2, n, 1, ratio);
      EXPECT_EQ(reports.size(), 2u);
    }
}

TEST(Round_ends, A_vessel_that_leaves_a_sac_is_one) {
  Skeleton s = tube_with_node();
  add_sac(s, 1, Vector(1, 0, 0), 3.8, 2.4, 0.6);
  add_tube(s, 4, s.nodes[4] + Vector(6, 0, 3), 0.7, 0.7);
  expect_openings(s, 3, 18, 1, 0.3);
}

// --- stubs and bumps ---

TEST(Round_ends, A_thin_stub_opposite_to_a_wide_sac_is_a_vessel_in_any_order_of_the_vertices) {
  unsigned number = 0;
  for (double sac : {1.6, 2.4, 3.2})
    for (double r : {0.25, 0.32, 0.45})
      for (double angle : {90., 65.})
        for (double stub : {1., 1.6}) {
          SCOPED_TRACE("sac " + std::to_string(sac) + ", radius " + std::to_string(r) + ", angle " +
                       std::to_string(angle) + ", stub " + std::to_string(stub));
          const double a = angle * CGAL_PI / 180;
          Skeleton s = tube_with_node();
          add_sac(s, 1, Vector(-1, 0, 0.1), sac + (number % 2 == 0 ? 0.7 : 1.4), sac, 0.6, int(number % 4));
          add_tube(s, 1, s.nodes[1] + (1 / std::sin(a) + stub * r) * Vector(std::sin(a), 0, std::cos(a)), r, r);
          const Mesh vessel = round_tree(s, 18);
          for (unsigned order = 0; order < 2; ++order) {
            Mesh mesh = in_other_order(vessel, 2 * number + order);
            move(mesh, 1, 0.3 * number);
            const Reports reports = tubular::cut_round_ends(mesh);
            EXPECT_EQ(number_with(reports, ""), 3u);
            EXPECT_EQ(tubular::find_openings(mesh).size(), 3u);
          }
          ++number;
        }
}

TEST(Round_ends, A_stub_shorter_than_its_width_is_a_vessel_and_a_half_ball_is_none) {
  for (double n : {14., 24.})
    for (double r : {0.3, 0.5, 0.7})
      for (double angle : {90., 60.})
        for (double stub : {0., 0.7, 1., 1.5, 2.}) {
          if (stub == 0.7 && n < 20)
            continue; // a handful of triangles
          SCOPED_TRACE("radius " + std::to_string(r) + ", stub " + std::to_string(stub) + ", angle " +
                       std::to_string(angle) + ", n " + std::to_string(n));
          const double a = angle * CGAL_PI / 180;
          Skeleton s = tube_with_node();
          add_tube(s, 1, s.nodes[1] + (1 / std::sin(a) + stub * r) * Vector(std::sin(a), 0, std::cos(a)), r, r);
          expect_openings(s, stub > 0 ? 3 : 2, n, r, n * r);
        }
}

#ifdef TUBULAR_MESHING_SHARED_DATA
TEST(Round_ends, Domed_vessels_of_the_paper_have_their_ends) {
  for (double height : {0.5, 1., 1.5}) {
    check_domed("paper/aorta.stl", height, 5, 5);
    check_domed("paper/carotid.stl", height, 3, 3);
    check_domed("paper/cerebral.stl", height, 9, 9);
    check_domed("paper/bypass.stl", height, 2, 2);
    check_domed("paper/cylemi.stl", height, 2, 2);
  }
}

// It has vessels without an opening besides, which are ends as well.
TEST(Round_ends, Domed_airways_have_their_ends) {
  check_domed("trees/airway_lf_open.vtp", 1, 110, 160);
}
#endif
