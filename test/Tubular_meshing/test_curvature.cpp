// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curvatures of surfaces that have a formula.

#include <CGAL/Tubular_meshing/Fields/curvature.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef Mesh::Vertex_index Vertex;
typedef tubular::Vertex_curvature<Vector> Curvature;

const double pi = 3.14159265358979323846;

/* A surface x(u, v) over [0, 1]², its parameters known at each vertex. */
struct Sheet {
  Mesh mesh;
  std::vector<double> u, v;

  // `close_u`, `close_v`: whether 1 is 0 again; `shift`: how far vertices move at random, in cells of the grid
  Sheet(int nu, int nv, bool close_u, bool close_v, const std::function<Point(double, double)>& x, double shift = 0) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> move(-shift, shift);
    const int mu = close_u ? nu : nu + 1, mv = close_v ? nv : nv + 1;
    for (int i = 0; i < mu; ++i)
      for (int j = 0; j < mv; ++j) {
        const bool fixed_u = !close_u && (i == 0 || i == nu), fixed_v = !close_v && (j == 0 || j == nv);
        u.push_back((i + (fixed_u ? 0 : move(random))) / nu);
        v.push_back((j + (fixed_v ? 0 : move(random))) / nv);
        mesh.add_vertex(x(u.back(), v.back()));
      }
    const auto at = [&](int i, int j) { return Vertex(unsigned((i % mu) * mv + j % mv)); };
    for (int i = 0; i < nu; ++i)
      for (int j = 0; j < nv; ++j)
        if ((i + j) % 2 == 0) {
          mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
          mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
        } else {
          mesh.add_face(at(i, j), at(i + 1, j), at(i, j + 1));
          mesh.add_face(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
        }
  }

  template <class NamedParameters> std::vector<Curvature> curvatures(const NamedParameters& np) const {
    std::vector<Curvature> result(mesh.number_of_vertices());
    tubular::compute_curvatures(mesh, CGAL::make_property_map(result), np);
    return result;
  }
  std::vector<Curvature> curvatures() const { return curvatures(CGAL::parameters::default_values()); }

  void add_noise(double amplitude) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> noise(-amplitude, amplitude);
    for (Vertex w : mesh.vertices())
      mesh.point(w) = mesh.point(w) + Vector(noise(random), noise(random), noise(random));
  }
};

struct Truth {
  double min, max;
};

/* The largest error over all vertices that count, relative to `scale`. */
double largest_error(const Sheet& s, const std::vector<Curvature>& k, const std::function<Truth(double, double)>& truth,
                     double scale, double margin = 0) {
  double error = 0;
  for (std::size_t i = 0; i < k.size(); ++i) {
    if (s.v[i] < margin || s.v[i] > 1 - margin)
      continue;
    const Truth t = truth(s.u[i], s.v[i]);
    error = (std::max)({error, std::abs(k[i].min_curvature - t.min), std::abs(k[i].max_curvature - t.max)});
  }
  return error / scale;
}

Point on_torus(double u, double v) {
  const double a = 2 * pi * u, b = 2 * pi * v, r = 3 + std::cos(b);
  return Point(r * std::cos(a), r * std::sin(a), std::sin(b));
}
Truth of_torus(double, double v) {
  const double c = std::cos(2 * pi * v);
  return {(std::min)(c / (3 + c), 1.), 1};
}
Sheet torus(int n, double shift = 0) {
  return Sheet(3 * n, n, true, true, on_torus, shift);
}
Point on_cylinder(double u, double v) {
  return Point(std::cos(2 * pi * u), std::sin(2 * pi * u), 6 * v);
}
Truth of_cylinder(double, double) {
  return {0, 1};
}
// z = (x² − y²)/2, turned upward; x and y within ±0.6
Point on_saddle(double u, double v) {
  const double x = 1.2 * u - 0.6, y = 1.2 * v - 0.6;
  return Point(x, y, (x * x - y * y) / 2);
}
Truth of_saddle(double u, double v) {
  const double x = 1.2 * u - 0.6, y = 1.2 * v - 0.6, w = 1 + x * x + y * y;
  // mean and Gaussian curvature of a graph; convex where the surface bends away from its normal
  const double mean = -((1 + y * y) - (1 + x * x)) / (2 * w * std::sqrt(w)), gauss = -1 / (w * w);
  const double d = std::sqrt(mean * mean - gauss);
  return {mean - d, mean + d};
}

TEST(Curvature, Of_a_sphere_is_one_over_the_radius) {
  for (double radius : {1e-3, 1., 1e4}) {
    const Sheet sphere(48, 48, true, false, [&](double u, double v) {
      const double a = 2 * pi * u, z = 1.6 * v - 0.8, r = std::sqrt(1 - z * z); // between two circles
      return Point(radius * r * std::cos(a), radius * r * std::sin(a), radius * z);
    });
    const auto of_sphere = [&](double, double) { return Truth{1 / radius, 1 / radius}; };
    const std::vector<Curvature> k = sphere.curvatures();
    EXPECT_LT(largest_error(sphere, k, of_sphere, 1 / radius), 0.005);
    for (std::size_t i = 0; i < k.size(); ++i)
      EXPECT_GT(k[i].normal * (sphere.mesh.point(Vertex(unsigned(i))) - CGAL::ORIGIN), 0.99 * radius);
  }
}

TEST(Curvature, Of_a_sphere_does_not_depend_on_its_mesh) {
  // Max's normals are exact on a sphere, whatever the triangles
  const Sheet sphere(
      40, 40, true, false,
      [](double u, double v) {
        const double a = 2 * pi * u, z = 1.6 * v - 0.8, r = std::sqrt(1 - z * z);
        return Point(r * std::cos(a), r * std::sin(a), z);
      },
      0.3);
  EXPECT_LT(largest_error(
                sphere, sphere.curvatures(),
                [](double, double) {
                  return Truth{1, 1};
                },
                1),
            0.02);
}

TEST(Curvature, Of_a_cylinder) {
  const Sheet cylinder(40, 40, true, false, on_cylinder);
  const std::vector<Curvature> k = cylinder.curvatures();
  EXPECT_LT(largest_error(cylinder, k, of_cylinder, 1), 0.02); // its rims included
  for (const Curvature& c : k) {
    EXPECT_NEAR(std::abs(c.min_direction.z()), 1, 1e-3);
    EXPECT_NEAR(c.max_direction * c.min_direction, 0, 1e-12);
    EXPECT_NEAR(c.max_direction * c.normal, 0, 1e-12);
    EXPECT_NEAR(c.along(Vector(0, 0, 3)), 0, 0.01);
    EXPECT_NEAR(c.along(c.max_direction + c.min_direction), 0.5, 0.01);
  }
}

TEST(Curvature, Of_a_torus_and_a_saddle) {
  const Sheet t = torus(40);
  EXPECT_LT(largest_error(t, t.curvatures(), of_torus, 1), 0.02);
  const Sheet saddle(40, 40, false, false, on_saddle);
  const std::vector<Curvature> k = saddle.curvatures();
  double error = 0;
  for (std::size_t i = 0; i < k.size(); ++i)
    if (saddle.u[i] > 0.1 && saddle.u[i] < 0.9 && saddle.v[i] > 0.1 && saddle.v[i] < 0.9) {
      const Truth s = of_saddle(saddle.u[i], saddle.v[i]);
      error = (std::max)({error, std::abs(k[i].min_curvature - s.min), std::abs(k[i].max_curvature - s.max)});
    }
  EXPECT_LT(error, 0.02);
}

TEST(Curvature, Converges_with_the_square_of_the_edges) {
  double last = 0.5;
  for (int n : {16, 32, 64}) {
    const Sheet t = torus(n);
    const double error = largest_error(t, t.curvatures(), of_torus, 1);
    EXPECT_LT(error, last / 3.4) << n; // 4 in the limit
    last = error;
    RecordProperty("error_" + std::to_string(n), std::to_string(error));
  }
  EXPECT_LT(last, 0.01);
}

TEST(Curvature, Averaging_leaves_smooth_surfaces_as_they_are) {
  const auto np =
      tubular::parameters::local_radius(std::function<double(const Point&)>([](const Point&) { return 1.; }));
  const Sheet t = torus(48), cylinder(48, 48, true, false, on_cylinder);
  EXPECT_LT(largest_error(t, t.curvatures(np), of_torus, 1), 0.02);
  EXPECT_LT(largest_error(cylinder, cylinder.curvatures(np), of_cylinder, 1), 0.02);
}

TEST(Curvature, Averaging_removes_noise) {
  const auto radius = std::function<double(const Point&)>([](const Point&) { return 1.; });
  Sheet cylinder(64, 64, true, false, on_cylinder);
  cylinder.add_noise(0.005); // five percent of an edge
  const double raw = largest_error(cylinder, cylinder.curvatures(), of_cylinder, 1, 0.1);
  const double smooth =
      largest_error(cylinder, cylinder.curvatures(tubular::parameters::local_radius(radius)), of_cylinder, 1, 0.1);
  const double smoother =
      largest_error(cylinder, cylinder.curvatures(tubular::parameters::local_radius(radius).smoothing_radius(0.8)),
                    of_cylinder, 1, 0.1);
  EXPECT_GT(raw, 0.3); // or there would be nothing to show
  EXPECT_LT(smooth, raw / 4);
  EXPECT_LT(smoother, smooth / 2);
}

TEST(Curvature, Does_not_see_caps) {
  // a cylinder with a cap, whose rim is a sharp edge
  Sheet cylinder(40, 40, true, false, on_cylinder);
  const std::vector<Curvature> open = cylinder.curvatures();
  auto patch = cylinder.mesh.add_property_map<Mesh::Face_index, int>("f:patch", tubular::labels::wall).first;
  const Vertex center = cylinder.mesh.add_vertex(Point(0, 0, 6));
  const auto at = [](int i) { return Vertex(unsigned(i % 40 * 41 + 40)); };
  for (int i = 0; i < 40; ++i)
    patch[cylinder.mesh.add_face(at(i), at(i + 1), center)] = tubular::labels::inlet;
  const std::vector<Curvature> capped = cylinder.curvatures(tubular::parameters::face_patch_map(patch));
  for (std::size_t i = 0; i < open.size(); ++i) {
    EXPECT_EQ(capped[i].max_curvature, open[i].max_curvature);
    EXPECT_EQ(capped[i].min_curvature, open[i].min_curvature);
  }
  EXPECT_EQ(capped[center].normal, Vector(0, 0, 0));
}

TEST(Curvature, Is_the_same_on_any_number_of_threads) {
  const Sheet t = torus(24, 0.2);
  const auto one = t.curvatures(tubular::parameters::number_of_threads(1));
  const auto two = t.curvatures(tubular::parameters::number_of_threads(2));
  for (std::size_t i = 0; i < one.size(); ++i)
    EXPECT_EQ(one[i].max_curvature, two[i].max_curvature);
}

TEST(Curvature, Survives_slivers_and_isolated_faces) {
  Mesh mesh;
  const Vertex a = mesh.add_vertex(Point(0, 0, 0)), b = mesh.add_vertex(Point(1, 0, 0));
  const Vertex c = mesh.add_vertex(Point(0.5, 1e-9, 0)), d = mesh.add_vertex(Point(0.5, -1, 0.3));
  mesh.add_face(a, b, c);
  mesh.add_face(b, a, d);
  std::vector<Curvature> k(4);
  tubular::compute_curvatures(mesh, CGAL::make_property_map(k));
  for (const Curvature& x : k) {
    EXPECT_TRUE(std::isfinite(x.min_curvature) && std::isfinite(x.max_curvature));
    EXPECT_NEAR(x.normal.squared_length(), 1, 1e-12);
  }
}

TEST(Curvature, Refuses_a_senseless_radius) {
  const Sheet t = torus(8);
  EXPECT_THROW(t.curvatures(tubular::parameters::smoothing_radius(-1.)), tubular::Parameter_error);
  EXPECT_THROW(t.curvatures(tubular::parameters::smoothing_radius(std::nan(""))), tubular::Parameter_error);
}

} // namespace
