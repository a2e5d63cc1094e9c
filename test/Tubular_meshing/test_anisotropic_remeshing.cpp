// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Remeshing to a metric, on cubes and tubes whose volume, sides and metric are known in closed form.

#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Volume/anisotropic_tetrahedral_remeshing.h>

#include "cubes_to_remesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace cubes_to_remesh;
using tubular::Surface;
using tubular::internal::Tetrahedron_store;
typedef std::function<Metric(const Point&)> Field;

const double pi = std::acos(-1.);

// A cylinder of radius 0.5 and length 3 along z: the wall 1, and the ends 2 and 3.
Mesh make_tube(int n) {
  return make_grid(
      n, n, 3 * n,
      [](double x, double y, double z) {
        const double u = 2 * x - 1, v = 2 * y - 1;
        return Point(u * std::sqrt(1 - v * v / 2) / 2, v * std::sqrt(1 - u * u / 2) / 2, 3 * z);
      },
      [](int axis, int end) { return axis < 2 ? 1 : 2 + end; });
}

double area(const Mesh& m, int patch) {
  double a = 0;
  for (std::size_t i = 0; i < m.triangles.size(); ++i)
    if (m.triangles.label[i] == patch) {
      const auto& t = m.triangles.vertices[i];
      a += norm(cross(Vector_3d(m.points[t[1]]) - Vector_3d(m.points[t[0]]),
                      Vector_3d(m.points[t[2]]) - Vector_3d(m.points[t[0]]))) /
           2;
    }
  return a;
}

// ∫ √det M over the mesh, by midpoints of a subdivision, over the volume of the regular tetrahedron.
double ideal_number(const Mesh& m, const Field& field) {
  double sum = 0;
  const int n = 6;
  for (const auto& t : m.tetrahedra.vertices) {
    double density = 0;
    int samples = 0;
    for (int a = 0; a < n; ++a)
      for (int b = 0; a + b < n; ++b)
        for (int c = 0; a + b + c < n; ++c, ++samples) {
          const double w[4] = {(a + 0.25) / n, (b + 0.25) / n, (c + 0.25) / n, 1 - (a + b + c + 0.75) / n};
          Vector_3d x;
          for (int i = 0; i < 4; ++i)
            x += w[i] * Vector_3d(m.points[t[i]]);
          density += field(Point(x.x, x.y, x.z)).density();
        }
    sum += volume_of(m, t) * density / samples;
  }
  return sum / (std::sqrt(2.) / 12);
}

Mesh remeshed(Mesh m, const Field& field, int threads = 1) {
  tubular::anisotropic_tetrahedral_remeshing(m, field, tubular::parameters::number_of_threads(threads));
  return m;
}

// What Table III asks for, and the number of elements.
void expect_unit_mesh(const Mesh& m, double ideal) {
  const auto q = tubular::quality_report(m);
  EXPECT_GE(q.efficiency, 0.87);
  EXPECT_LE(q.Q_tau.mean(), 1.4);
  EXPECT_LE(q.Q_tau.max(), 8);
  EXPECT_GE(q.Q_tau.share_below(3), 0.985);
  EXPECT_NEAR(double(m.tetrahedra.size()) / ideal, 1, 0.15);
}

TEST(Anisotropic_remeshing, Isotropic_cube) {
  for (double h : {0.12, 0.09}) {
    const Field field = [h](const Point&) { return Metric::isotropic(h); };
    const Mesh input = make_cube(5), m = remeshed(input, field);
    expect_valid(m, 1);
    expect_unit_mesh(m, ideal_number(input, field));
    const auto q = tubular::quality_report(m);
    EXPECT_GE(q.gamma_tau.mean(), 0.76);
    EXPECT_GE(q.gamma_tau.min(), 0.25);
    for (int side = 1; side <= 6; ++side)
      EXPECT_NEAR(area(m, side), 1, 1e-9);
  }
}

TEST(Anisotropic_remeshing, Coarsens_a_fine_cube) {
  const Field field = [](const Point&) { return Metric::isotropic(0.2); };
  const Mesh input = make_cube(14), m = remeshed(input, field);
  expect_valid(m, 1);
  EXPECT_LT(m.tetrahedra.size(), 1.3 * ideal_number(input, field));
  EXPECT_GE(tubular::quality_report(m).efficiency, 0.85);
}

TEST(Anisotropic_remeshing, Uniform_one_to_hundred) {
  const Field field = [](const Point&) { return sizes(0.007, 0.07, 0.7); };
  const Mesh input = make_cube(5), m = remeshed(input, field);
  expect_valid(m, 1);
  expect_unit_mesh(m, ideal_number(input, field));
}

TEST(Anisotropic_remeshing, Uniform_ratios_of_hundreds_and_thousands) {
  for (double ratio : {100., 1e3}) {
    const Field field = [=](const Point&) { return sizes(0.6 / ratio, 0.6, 0.6); };
    const Mesh input = make_cube(4), m = remeshed(input, field);
    expect_valid(m, 1);
    expect_unit_mesh(m, ideal_number(input, field));
  }
}

TEST(Anisotropic_remeshing, Layers_with_ratios_of_thousands) {
  const double h = 0.4, first = 4e-5, slope = 0.3;
  const Field field = [=](const Point& p) { return sizes(h, h, first + slope * p.z()); };
  const Mesh m = remeshed(make_cube(4), field);
  expect_valid(m, 1);
  expect_unit_mesh(m, std::log(1 + slope / first) / slope / (h * h) / (std::sqrt(2.) / 12));
}

// Uniform metrics that elements of a cube cannot follow, being longer than it: there is an end, and nothing is
// inverted.
TEST(Anisotropic_remeshing, Ratios_of_thousands_come_to_an_end) {
  for (double ratio : {1e3, 1e4}) {
    const double thin = std::sqrt(6e-3 / ratio);
    const Field field = [=](const Point&) { return sizes(thin, 0.6, ratio * thin); };
    const Mesh input = make_cube(3), m = remeshed(input, field);
    expect_valid(m, 1);
    EXPECT_LT(double(m.tetrahedra.size()), 4 * ideal_number(input, field));
  }
}

TEST(Anisotropic_remeshing, Boundary_layer) {
  const Field field = [](const Point& p) { return sizes(0.12, 0.12, (std::min)(0.01 + 0.26 * p.z(), 0.12)); };
  const Mesh input = make_cube(6), m = remeshed(input, field);
  expect_valid(m, 1);
  expect_unit_mesh(m, ideal_number(input, field));
}

// The tetrahedra on a side whose layer counts are as high as the size across it; regular ones are 0.8 as high.
TEST(Anisotropic_remeshing, Height_of_the_first_layer) {
  const Field field = [](const Point& p) { return sizes(0.12, 0.12, (std::min)(0.01 + 0.3 * p.z(), 0.12)); };
  Mesh m = make_cube(6);
  tubular::anisotropic_tetrahedral_remeshing(
      m, field, tubular::parameters::boundary_layer_patches(std::vector<int>{5}).number_of_threads(1));
  expect_valid(m, 1);
  std::size_t number = 0, fits = 0;
  for (const auto& t : m.tetrahedra.vertices) {
    int on_side = 0;
    double height = 0;
    for (auto v : t) {
      on_side += m.points[v].z() == 0;
      height += m.points[v].z();
    }
    if (on_side == 3) {
      ++number;
      fits += height > 0.007 && height < 0.013;
    }
  }
  EXPECT_GT(number, 100u);
  EXPECT_GE(double(fits), 0.95 * double(number));
  const auto q = tubular::quality_report(m);
  EXPECT_LE(q.Q_tau.mean(), 1.4);
  EXPECT_GE(q.efficiency, 0.86);
}

TEST(Anisotropic_remeshing, Rotating_metric) {
  const Field field = [](const Point& p) {
    const Vector_3d u = normalized(Vector_3d(p.x() + 0.3, p.y() + 0.3, 0));
    return sizes(0.024, 0.19, 0.07, u, {-u.y, u.x, 0});
  };
  const Mesh input = make_cube(6), m = remeshed(input, field);
  expect_valid(m, 1);
  expect_unit_mesh(m, ideal_number(input, field));
}

TEST(Anisotropic_remeshing, Shock) {
  const Vector_3d u = normalized(Vector_3d(1, 1, 1)), v = normalized(Vector_3d(1, -1, 0));
  const Field field = [=](const Point& p) {
    const double d = std::abs(dot(u, Vector_3d(p)) - 0.8);
    return sizes((std::min)(0.008 + 0.3 * d, 0.12), 0.12, 0.12, u, v, cross(u, v));
  };
  const Mesh input = make_cube(6), m = remeshed(input, field);
  expect_valid(m, 1);
  expect_unit_mesh(m, ideal_number(input, field));
}

// Seen by no vertex of the input: none lies within ten times the feature's thickness.
TEST(Anisotropic_remeshing, Finds_a_small_feature) {
  const Field field = [](const Point& p) {
    return sizes((std::min)(0.01 + 0.3 * std::abs(p.x() - 0.375), 0.2), 0.2, 0.2);
  };
  const Mesh input = make_cube(4), m = remeshed(input, field);
  expect_valid(m, 1);
  expect_unit_mesh(m, ideal_number(make_cube(16), field));
}

// A vessel's: thin at the wall, by (4), and bounded around it by the smoothing ratio, by (9).
Metric tube_metric(const Point& p) {
  const double r = std::hypot(p.x(), p.y()), core = 0.15, h_n = (std::min)(0.01 + 0.26 * (std::max)(0.5 - r, 0.), core);
  if (r < 1e-9)
    return sizes(h_n, h_n, 0.5);
  const double k = r * r * (1.5 * 1.5 - 1), u = (-1 + std::sqrt(1 + 4 * k / (h_n * h_n))) / (2 * k);
  const double around = (std::max)((std::min)(core, 1 / std::sqrt(u)), h_n);
  const Vector_3d out(p.x() / r, p.y() / r, 0);
  return sizes(h_n, around, 0.5, out, {-out.y, out.x, 0});
}

TEST(Anisotropic_remeshing, Tube_on_its_own_surface) {
  const Mesh input = make_tube(8), m = remeshed(input, tube_metric);
  expect_valid(m, volume(input), 0.01);
  expect_unit_mesh(m, ideal_number(input, tube_metric));
  for (int patch = 1; patch <= 3; ++patch)
    EXPECT_NEAR(area(m, patch), area(input, patch), 0.02 * area(input, patch));
  for (std::size_t i = 0; i < m.triangles.size(); ++i)
    for (std::uint32_t v : m.triangles.vertices[i])
      if (m.triangles.label[i] != 1) {
        EXPECT_NEAR(m.points[v].z(), m.triangles.label[i] == 2 ? 0 : 3, 1e-12);
      }
}

// A fine cylinder, with its ends.
struct Cylinder {
  Surface surface;
  Surface::Property_map<Surface::Face_index, int> patch;

  explicit Cylinder(unsigned sides) {
    patch = surface.add_property_map<Surface::Face_index, int>("f:patch", 1).first;
    for (double z : {0., 3.})
      for (unsigned k = 0; k < sides; ++k)
        surface.add_vertex(Point(0.5 * std::cos(2 * pi * k / sides), 0.5 * std::sin(2 * pi * k / sides), z));
    const auto low = surface.add_vertex(Point(0, 0, 0)), high = surface.add_vertex(Point(0, 0, 3));
    typedef Surface::Vertex_index V;
    for (unsigned k = 0; k < sides; ++k) {
      const V a(k), b((k + 1) % sides), c(sides + k), d(sides + (k + 1) % sides);
      surface.add_face(a, b, d);
      surface.add_face(a, d, c);
      patch[surface.add_face(b, a, low)] = 2;
      patch[surface.add_face(c, d, high)] = 3;
    }
  }
};

TEST(Anisotropic_remeshing, Tube_on_a_given_surface) {
  const Cylinder cylinder(128);
  Mesh m = make_tube(5); // a coarse polygon around
  tubular::anisotropic_tetrahedral_remeshing(m, cylinder.surface, cylinder.patch, &tube_metric);
  expect_valid(m, 0.75 * pi, 0.01);
  const double sagitta = 0.5 * (1 - std::cos(pi / 128));
  std::size_t wall = 0, far = 0;
  std::set<std::uint32_t> seen;
  for (std::size_t i = 0; i < m.triangles.size(); ++i)
    for (std::uint32_t v : m.triangles.vertices[i])
      if (m.triangles.label[i] == 1 && seen.insert(v).second) {
        ++wall;
        far += std::abs(std::hypot(m.points[v].x(), m.points[v].y()) - 0.5) > sagitta + 1e-9;
      }
  EXPECT_GT(wall, 300u);
  EXPECT_EQ(far, 0u);
}

TEST(Anisotropic_remeshing, Keeps_the_boundary) {
  const Mesh input = make_cube(5);
  const Field field = [](const Point& p) {
    const double d = (std::min)({p.x(), p.y(), p.z(), 1 - p.x(), 1 - p.y(), 1 - p.z()});
    return Metric::isotropic(0.2 - 0.2 * d);
  };
  Mesh m = input;
  tubular::anisotropic_tetrahedral_remeshing(m, field, tubular::parameters::keep_boundary(true));
  expect_valid(m, 1);
  EXPECT_NE(m.tetrahedra.size(), input.tetrahedra.size());
  typedef std::pair<std::set<Point>, int> Facet;
  const auto facets = [](const Mesh& mesh) {
    std::set<Facet> all;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto& t = mesh.triangles.vertices[i];
      all.insert({{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]}, mesh.triangles.label[i]});
    }
    return all;
  };
  EXPECT_EQ(facets(m), facets(input));
  EXPECT_EQ(m.triangles.size(), input.triangles.size());
}

TEST(Anisotropic_remeshing, Keeps_regions_and_their_interface) {
  Mesh input = make_cube(6);
  const auto middle = [&](std::uint32_t v) { return input.points[v].x() == 0.5; };
  for (std::size_t i = 0; i < input.tetrahedra.size(); ++i) {
    const auto& t = input.tetrahedra.vertices[i];
    double x = 0;
    for (std::uint32_t v : t)
      x += input.points[v].x() / 4;
    input.tetrahedra.label[i] = x < 0.5 ? 1 : 2;
    for (int f = 0; f < 4 && x < 0.5; ++f) {
      const auto& c = Tetrahedron_store::facet_corners(f);
      if (middle(t[c[0]]) && middle(t[c[1]]) && middle(t[c[2]]))
        input.triangles.push_back({t[c[0]], t[c[1]], t[c[2]]}, 9);
    }
  }
  const Field field = [](const Point& p) { return sizes(0.03 + 0.3 * std::abs(p.x() - 0.5), 0.12, 0.12); };
  const Mesh m = remeshed(input, field);
  expect_valid(m, 1);
  expect_unit_mesh(m, ideal_number(input, field));
  EXPECT_NEAR(volume(m, 1), 0.5, 1e-9);
  EXPECT_NEAR(volume(m, 2), 0.5, 1e-9);
  EXPECT_NEAR(area(m, 9), 1, 1e-9);
}

TEST(Anisotropic_remeshing, A_second_run_changes_little) {
  const Mesh once = remeshed(make_tube(6), tube_metric), twice = remeshed(once, tube_metric);
  EXPECT_NEAR(double(twice.tetrahedra.size()) / double(once.tetrahedra.size()), 1, 0.03);
  const auto a = tubular::quality_report(once), b = tubular::quality_report(twice);
  EXPECT_NEAR(a.efficiency, b.efficiency, 0.01);
  EXPECT_LE(b.Q_tau.mean(), a.Q_tau.mean() + 0.02);
}

TEST(Anisotropic_remeshing, Is_the_same_for_any_number_of_threads) {
  const Mesh a = remeshed(make_tube(6), tube_metric, 1), b = remeshed(make_tube(6), tube_metric, 2);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.tetrahedra.vertices, b.tetrahedra.vertices);
}

TEST(Anisotropic_remeshing, Scales_with_its_units) {
  const double unit = std::ldexp(1., -20); // exact, so that roundings are the same
  Mesh small = make_tube(4);
  for (Point& p : small.points)
    p = Point(unit * p.x(), unit * p.y(), unit * p.z());
  const Field field = [=](const Point& p) {
    return (1 / (unit * unit)) * tube_metric(Point(p.x() / unit, p.y() / unit, p.z() / unit));
  };
  const Mesh a = remeshed(make_tube(4), tube_metric), b = remeshed(small, field);
  EXPECT_EQ(a.tetrahedra.vertices, b.tetrahedra.vertices);
}

TEST(Anisotropic_remeshing, Gives_the_metric_at_the_points) {
  Mesh m = make_cube(4);
  m.point_arrays.push_back({"pressure", 1, std::vector<double>(m.points.size(), 1)});
  const Field field = [](const Point& p) { return sizes(0.1 + 0.1 * p.x(), 0.2, 0.2 + 0.1 * p.y()); };
  m = remeshed(m, field);
  ASSERT_EQ(m.point_arrays.size(), 1u);
  EXPECT_EQ(m.point_arrays[0].name, "metric");
  ASSERT_EQ(m.point_arrays[0].values.size(), 6 * m.points.size());
  for (std::size_t i = 0; i < m.points.size(); ++i) {
    const auto expected = field(m.points[i]).components();
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), m.point_arrays[0].values.begin() + 6 * std::ptrdiff_t(i)));
  }
}

void expect_refused(const Mesh& input, const Field& field, const std::string& words) {
  Mesh m = input;
  try {
    tubular::anisotropic_tetrahedral_remeshing(m, field);
    ADD_FAILURE() << "accepted, where it should say: " << words;
  } catch (const tubular::Input_error& e) {
    EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
  }
  EXPECT_EQ(m.points, input.points);
  EXPECT_EQ(m.tetrahedra.vertices, input.tetrahedra.vertices);
  EXPECT_EQ(m.triangles.vertices, input.triangles.vertices);
  EXPECT_TRUE(m.point_arrays.empty());
}

TEST(Anisotropic_remeshing, Refuses_metrics_that_are_none) {
  const Mesh cube = make_cube(3);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused(
      cube, [](const Point&) { return Metric(1, 0, 0, 1, 0, -1); }, "not positive definite");
  expect_refused(
      cube, [](const Point&) { return Metric(1, 2, 0, 1, 0, 1); }, "not positive definite");
  expect_refused(
      cube, [=](const Point&) { return Metric(1, 0, nan, 1, 0, 1); }, "finite");
  expect_refused(
      cube, [](const Point&) { return Metric::isotropic(0); }, "finite");
  expect_refused(
      cube, [](const Point&) { return Metric::isotropic(1e-9); }, "tetrahedra");
  expect_refused(
      cube, [](const Point&) { return Metric::isotropic(50); }, "far beyond");
  expect_refused(
      cube, [](const Point&) { return sizes(1e-6, 0.1, 1); }, "ratio");
  // only where new points come to lie
  expect_refused(
      cube,
      [=](const Point& p) { return p.x() > 0.4 && p.x() < 0.6 ? Metric(nan, 0, 0, 1, 0, 1) : Metric::isotropic(0.1); },
      "finite");
}

TEST(Anisotropic_remeshing, Refuses_meshes_that_are_not_valid) {
  const Field field = [](const Point&) { return Metric::isotropic(0.3); };
  Mesh m = make_cube(3);
  std::swap(m.tetrahedra.vertices[7][0], m.tetrahedra.vertices[7][1]);
  expect_refused(m, field, "1 inverted cells");
  m = make_cube(3);
  m.triangles = {};
  expect_refused(m, field, "unlabelled boundary faces");
  m = make_cube(3);
  m.triangles.label[5] = 0;
  expect_refused(m, field, "Triangle 5");
  m = make_cube(3);
  m.tetrahedra.vertices[2][1] = 12345;
  expect_refused(m, field, "12345");
  m = make_cube(3);
  m.tetrahedra.push_back(m.tetrahedra.vertices[0], 1);
  expect_refused(m, field, "overlapping");
  m = make_cube(3);
  m.points[0] = Point(std::numeric_limits<double>::infinity(), 0, 0);
  expect_refused(m, field, "Point 0");
  m = make_cube(3);
  m.hexahedra.push_back({0, 1, 2, 3, 4, 5, 6, 7}, 1);
  expect_refused(m, field, "other than tetrahedra");
  expect_refused(Mesh(), field, "no tetrahedra");
}

TEST(Anisotropic_remeshing, Lets_the_fields_exceptions_through) {
  Mesh m = make_cube(3);
  int calls = 0;
  const Field field = [&](const Point&) {
    if (++calls > 500)
      throw std::domain_error("enough");
    return Metric::isotropic(0.05);
  };
  EXPECT_THROW(tubular::anisotropic_tetrahedral_remeshing(m, field, tubular::parameters::number_of_threads(1)),
               std::domain_error);
  EXPECT_EQ(m.points, make_cube(3).points);
  EXPECT_THROW(tubular::anisotropic_tetrahedral_remeshing(m, field, tubular::parameters::number_of_threads(-1)),
               tubular::Parameter_error);
}

} // namespace
