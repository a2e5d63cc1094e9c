// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "defects.h"

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Vertices thrown out of their place: spikes into the lumen and outward, through each other and through the opposite
// wall. They go back into the wall, whatever their number; what is sharp by nature is not touched.

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
namespace tubular = CGAL::Tubular_meshing;
using defects::Clean_surface;
using defects::Mesh;
using defects::Point;
using defects::Soup;
using defects::Triangle;
using defects::Vector;
using tubular::Repair_mode;
using tubular::Surface_defect;
typedef CGAL::Aff_transformation_3<defects::Kernel> Transformation;

struct Thrown {
  Soup soup;
  std::set<std::size_t> vertices;
};

bool take(const Clean_surface& clean, std::size_t v, Thrown& thrown) {
  return !clean.near_rim[v] && thrown.vertices.insert(v).second;
}

// By 0.8 to 3 local radii, inward or outward, and by up to half an edge along the wall.
Thrown throw_across(const Clean_surface& clean, std::size_t count, unsigned seed) {
  Thrown thrown{clean.soup, {}};
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  while (thrown.vertices.size() < count) {
    const std::size_t v = random() % clean.soup.points.size();
    if (!take(clean, v, thrown))
      continue;
    const double far = (random() % 2 == 0 ? 1 : -1) * (0.8 + 2.2 * unit(random)) * clean.radius(v);
    const Vector any(unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5);
    thrown.soup.points[v] = thrown.soup.points[v] + far * clean.normal[v] + clean.edge[v] * any;
  }
  return thrown;
}

// Anywhere: by a third of the local radius in each coordinate, in the mean.
Thrown throw_anywhere(const Clean_surface& clean, std::size_t count, unsigned seed) {
  Thrown thrown{clean.soup, {}};
  std::mt19937 random(seed);
  const auto normal = [&] { // the sum of twelve, as the standard's distribution differs between libraries
    double sum = -6;
    for (int i = 0; i < 12; ++i)
      sum += double(random() % 65536) / 65536;
    return sum;
  };
  while (thrown.vertices.size() < count) {
    const std::size_t v = random() % clean.soup.points.size();
    if (!take(clean, v, thrown))
      continue;
    const double x = normal(), y = normal(), z = normal();
    thrown.soup.points[v] = thrown.soup.points[v] + clean.radius(v) / 3 * Vector(x, y, z);
  }
  return thrown;
}

typedef tubular::internal::Nearest_tree<tubular::internal::Double_kernel::Triangle_3> Wall;

Wall wall_of(const Soup& soup) {
  std::vector<tubular::internal::Double_kernel::Triangle_3> triangles;
  for (const Triangle& t : soup.triangles)
    triangles.emplace_back(tubular::internal::to_double_point(soup.points[t[0]]),
                           tubular::internal::to_double_point(soup.points[t[1]]),
                           tubular::internal::to_double_point(soup.points[t[2]]));
  return Wall(std::move(triangles));
}

// The largest distance of a vertex of the mesh from the clean wall, in local radii.
double deviation(const Mesh& mesh, const Clean_surface& clean) {
  const Wall wall = wall_of(clean.soup);
  double farthest = 0;
  for (auto v : mesh.vertices()) {
    const auto nearest = wall.nearest(tubular::internal::to_double_point(mesh.point(v)));
    farthest =
        std::max(farthest, std::sqrt(nearest.squared_distance) / clean.radius(clean.soup.triangles[nearest.index][0]));
  }
  return farthest;
}

void expect_clean(const Mesh& mesh, const Clean_surface& clean, double tolerance) {
  EXPECT_FALSE(pmp::does_self_intersect(mesh));
  EXPECT_EQ(tubular::find_openings(mesh).size(), clean.openings);
  EXPECT_LT(deviation(mesh, clean), tolerance);
}

void expect_untouched(const Soup& soup, const std::string& what) {
  SCOPED_TRACE(what);
  Mesh as_read, repaired;
  tubular::repair_surface(soup.points, soup.triangles, as_read, tubular::parameters::repair_mode(Repair_mode::off));
  const auto report = tubular::repair_surface(soup.points, soup.triangles, repaired);
  EXPECT_EQ(report.count(Surface_defect::spikes), 0u) << report.text();
  EXPECT_TRUE(
      std::equal(repaired.points().begin(), repaired.points().end(), as_read.points().begin(), as_read.points().end()));
}

// A surface of revolution about the z-axis; a radius of 0 is one point.
Soup revolved(const std::vector<std::pair<double, double>>& profile, std::size_t sides) {
  Soup soup;
  std::vector<std::vector<std::size_t>> rings;
  for (const auto& p : profile) {
    rings.emplace_back();
    for (std::size_t i = 0; i < sides; ++i) {
      if (i == 0 || p.first > 0) {
        const double a = 2 * CGAL_PI * double(i) / double(sides);
        soup.points.push_back(Point(p.first * std::cos(a), p.first * std::sin(a), p.second));
      }
      rings.back().push_back(soup.points.size() - 1);
    }
  }
  for (std::size_t k = 0; k + 1 < rings.size(); ++k)
    for (std::size_t i = 0; i < sides; ++i) {
      const std::size_t j = (i + 1) % sides;
      const std::size_t a = rings[k][i], b = rings[k][j], c = rings[k + 1][j], d = rings[k + 1][i];
      if (a != b)
        soup.triangles.push_back({a, b, c});
      if (c != d)
        soup.triangles.push_back({a, c, d});
    }
  return soup;
}

// The faces between voxels in a vessel and outside of it: a tube, along an axis or not, as segmentations have it.
Soup voxels(double radius, const Vector& axis) {
  const int size = 30;
  const Vector along = axis / std::sqrt(axis.squared_length());
  const auto is_inside = [&](const std::array<int, 3>& c) {
    if (*std::min_element(c.begin(), c.end()) < -size || *std::max_element(c.begin(), c.end()) > size)
      return false;
    const Vector p(c[0] + 0.31, c[1] + 0.17, c[2] + 0.23);
    return CGAL::cross_product(p, along).squared_length() < radius * radius && std::abs(p * along) < 20;
  };
  Soup soup;
  std::map<std::array<int, 3>, std::size_t> corners;
  const auto corner = [&](const std::array<int, 3>& c) {
    const auto found = corners.emplace(c, soup.points.size());
    if (found.second)
      soup.points.push_back(Point(c[0], c[1], c[2]));
    return found.first->second;
  };
  for (int x = -size; x <= size; ++x)
    for (int y = -size; y <= size; ++y)
      for (int z = -size; z <= size; ++z)
        for (int k = 0; k < 3; ++k)
          for (int side : {0, 1}) {
            std::array<int, 3> c = {x, y, z}, next = c, a, b, d;
            next[k] += 2 * side - 1;
            if (!is_inside(c) || is_inside(next))
              continue;
            c[k] += side;
            a = b = d = c;
            ++a[(k + 1) % 3];
            ++b[(k + 1) % 3];
            ++b[(k + 2) % 3];
            ++d[(k + 2) % 3];
            if (side == 0)
              std::swap(a, d);
            soup.triangles.push_back({corner(c), corner(a), corner(b)});
            soup.triangles.push_back({corner(c), corner(b), corner(d)});
          }
  return soup;
}

} // namespace

TEST(Spikes, Go_back_into_the_wall_whatever_their_number) {
  for (const Clean_surface& clean : defects::clean_surfaces())
    for (std::size_t count : {1, 4, 25, 100, 300}) {
      if (20 * count > 3 * clean.soup.points.size())
        continue; // more than 15 %
      for (unsigned seed = 0; seed < 4; ++seed) {
        SCOPED_TRACE(clean.name + ", " + std::to_string(count) + " vertices, seed " + std::to_string(seed));
        const Thrown thrown = throw_across(clean, count, seed);
        Mesh mesh;
        const auto report = tubular::repair_surface(thrown.soup.points, thrown.soup.triangles, mesh);
        SCOPED_TRACE(report.text());
        const std::size_t found = report.count(Surface_defect::spikes);
        EXPECT_GE(found, count - count / 20);
        EXPECT_LE(found, count + 1 + count / 10);
        EXPECT_EQ(report.count(Surface_defect::wrapped), 0u);
        expect_clean(mesh, clean, 0.2);
      }
    }
}

// Smaller ones, of less than 1.25 edges, are no spikes yet: they stay, as noise does.
TEST(Spikes, Of_any_direction_and_size_leave_no_more_than_noise) {
  const std::vector<Clean_surface> surfaces = {Clean_surface("fine y", tubular::y_bifurcation(), 33),
                                               Clean_surface("fine bend", tubular::curved_tube(), 33)};
  for (const Clean_surface& clean : surfaces)
    for (std::size_t count : {4, 25, 100, 300})
      for (unsigned seed = 0; seed < 4; ++seed) {
        SCOPED_TRACE(clean.name + ", " + std::to_string(count) + " vertices, seed " + std::to_string(seed));
        const Thrown thrown = throw_anywhere(clean, count, seed);
        Mesh mesh;
        const auto report = tubular::repair_surface(thrown.soup.points, thrown.soup.triangles, mesh);
        SCOPED_TRACE(report.text());
        EXPECT_GT(report.count(Surface_defect::spikes), 0u);
        EXPECT_EQ(report.count(Surface_defect::wrapped), 0u);
        expect_clean(mesh, clean, 1.4 * 2 * CGAL_PI / clean.points);
      }
}

TEST(Spikes, Are_the_same_in_any_unit_and_position) {
  const Clean_surface& clean = defects::clean_surfaces()[1];
  const Thrown thrown = throw_across(clean, 25, 7);
  Mesh mesh;
  const auto report = tubular::repair_surface(thrown.soup.points, thrown.soup.triangles, mesh);
  const std::size_t found = report.count(Surface_defect::spikes);
  EXPECT_NEAR(double(found), 25, 2);
  for (double unit : {1e-3, 1., 1e3})
    for (double angle : {0., 0.7, 2.1}) {
      SCOPED_TRACE("unit " + std::to_string(unit) + ", angle " + std::to_string(angle));
      const double c = std::cos(angle), s = std::sin(angle);
      const Transformation turn(c, -s, 0, 3, 0.6 * s, 0.6 * c, -0.8, -2, 0.8 * s, 0.8 * c, 0.6, 1);
      const Transformation place = Transformation(CGAL::SCALING, unit) * turn;
      Soup moved = thrown.soup;
      for (Point& p : moved.points)
        p = place(p);
      Mesh other;
      const auto same = tubular::repair_surface(moved.points, moved.triangles, other);
      EXPECT_EQ(same.count(Surface_defect::spikes), found);
      ASSERT_EQ(other.number_of_vertices(), mesh.number_of_vertices());
      for (auto v : mesh.vertices())
        ASSERT_LT(std::sqrt(CGAL::squared_distance(other.point(v), place(mesh.point(v)))), 1e-9 * unit * 10);
    }
}

TEST(Spikes, Are_found_where_nothing_crosses_and_nothing_else_moves) {
  for (const Clean_surface& clean : defects::clean_surfaces())
    for (double far : {-0.9, 0.9, 3.}) { // local radii
      SCOPED_TRACE(clean.name + " " + std::to_string(far));
      Soup soup = clean.soup;
      const std::size_t v = clean.vertex(12);
      soup.points[v] = soup.points[v] + far * clean.radius(v) * clean.normal[v];
      Mesh as_read, mesh;
      tubular::repair_surface(soup.points, soup.triangles, as_read, tubular::parameters::repair_mode(Repair_mode::off));
      ASSERT_FALSE(pmp::does_self_intersect(as_read));
      const auto report = tubular::repair_surface(soup.points, soup.triangles, mesh);
      ASSERT_EQ(report.count(Surface_defect::spikes), 1u) << report.text();
      const auto& repair = report.repairs.front();
      EXPECT_EQ(tubular::name_of(repair.defect), "spikes");
      ASSERT_TRUE(repair.has_place);
      EXPECT_EQ(repair.place, soup.points[v]);
      EXPECT_NEAR(repair.size, std::abs(far) * clean.radius(v), 0.1 * clean.radius(v));
      std::size_t moved = 0;
      for (auto w : mesh.vertices())
        moved += mesh.point(w) != as_read.point(w);
      EXPECT_EQ(moved, 1u);
      expect_clean(mesh, clean, 0.05);
    }
}

TEST(Spikes, Are_no_pointed_ends_stenoses_creases_or_coarse_walls) {
  for (const Clean_surface& clean : defects::clean_surfaces()) // carinas among them
    expect_untouched(clean.soup, clean.name);
  for (std::size_t sides : {3, 4, 6, 12, 40}) {
    const std::string with = " of " + std::to_string(sides) + " sides";
    for (double height : {0.2, 1., 2., 4., 10.})
      expect_untouched(revolved({{1, 0}, {1, 2}, {1, 4}, {0, 4 + height}}, sides),
                       "a pointed end, " + std::to_string(height) + " high," + with);
    for (double height : {2., 4.}) // a cone of many rings
      expect_untouched(revolved({{1, 0},
                                 {1, 2},
                                 {0.75, 2 + height / 4},
                                 {0.5, 2 + height / 2},
                                 {0.25, 2 + 3 * height / 4},
                                 {0, 2 + height}},
                                sides),
                       "a cone, " + std::to_string(height) + " high," + with);
    for (double neck : {0.3, 0.22, 0.1}) // of 0.22: 95 % of the area
      for (double length : {0.5, 1., 3.})
        expect_untouched(
            revolved({{1, 0}, {1, 3}, {neck, 3 + length}, {1, 3 + 2 * length}, {1, 6 + 2 * length}}, sides),
            "a stenosis, radius " + std::to_string(neck) + ", length " + std::to_string(length) + with);
    expect_untouched(revolved({{0, 0}, {1, 0}, {1, 3}, {1, 6}, {0, 6}}, sides), "flat caps" + with);
    expect_untouched(revolved({{1, 0}, {1, 3}, {1.4, 3.2}, {1, 3.4}, {1, 6}}, sides), "a creased ring" + with);
  }
}

TEST(Spikes, Are_no_corners_of_voxels) {
  for (double radius : {4.3, 6., 8.6})
    for (const Vector& axis : {Vector(0, 0, 1), Vector(0, 1, 3), Vector(2, 3, 4)}) {
      const Soup soup = voxels(radius, axis);
      Mesh mesh;
      const auto report = tubular::repair_surface(soup.points, soup.triangles, mesh);
      EXPECT_EQ(report.count(Surface_defect::spikes), 0u) << radius << " along " << axis << report.text();
    }
}
