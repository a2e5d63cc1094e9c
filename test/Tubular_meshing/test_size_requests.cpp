// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Sizes that a user wants: in balls, in branches, on the surface; and the number of elements.

#include "test_surfaces.h"

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/Fields/Size_requests.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/Element_target.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesher.h>
#include <CGAL/Tubular_meshing/Quads/recombine_triangles.h>
#include <CGAL/Tubular_meshing/Volume/Volume_mesher.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
namespace parameters = tubular::parameters;
using namespace test_surfaces;
using tubular::Centerline_sizing_field;
using tubular::Mesher;
using tubular::Mixed_mesh;
using tubular::Size_requests;

tubular::Tubular_model model_of(const tubular::Tubular_skeleton& skeleton,
                                const Transformation& t = Transformation(CGAL::IDENTITY)) {
  Mesh surface;
  tubular::generate_tubular_surface(skeleton, surface, parameters::points_per_circumference(20));
  tubular::Centerline_polylines lines = tubular::centerlines_of(skeleton);
  for (Point& p : lines.points)
    p = t(p);
  lines.radius.clear();
  return tubular::make_tubular_model(transformed(surface, t), lines);
}

Centerline_sizing_field size_of(const tubular::Tubular_model& model, const Size_requests& requests,
                                double gradation = 1.3) {
  return Centerline_sizing_field(tubular::Centerline_field(model.centerlines),
                                 tubular::Wall_distance(model.surface, model.patch, tubular::labels::wall),
                                 parameters::points_per_circumference(16).size_requests(requests).gradation(gradation));
}

// --- the field ---

TEST(Size_requests, A_ball_divides_the_size_and_its_surroundings_are_graded) {
  const auto model = model_of(tubular::straight_tube(20, 1));
  const double plain = size_of(model, Size_requests())(Point(0, 0, 10));
  for (double factor : {0.5, 2., 4.})
    for (double radius : {0.1, 0.4, 2.}) { // also far smaller than the cells that the size is sampled in
      Size_requests requests;
      requests.balls.push_back({Point(0.3, 0, 10), radius, factor});
      const auto size = size_of(model, requests);
      if (factor > 1) {
        EXPECT_NEAR(size(Point(0.3, 0, 10)), plain / factor, 0.12 * plain / factor) << factor << " " << radius;
      }
      EXPECT_NEAR(size(Point(0, 0, 2)), plain, 0.02 * plain);
      EXPECT_NEAR(size(Point(0, 0, 18)), plain, 0.02 * plain);
      for (double z = 1; z < 19; z += 0.05) // by the gradation, with what interpolation adds
        EXPECT_LE(std::abs(size(Point(0, 0, z + 0.05)) - size(Point(0, 0, z))), 1.5 * 0.3 * 0.05) << z;
    }
}

TEST(Size_requests, A_large_ball_may_be_coarser) {
  const auto model = model_of(tubular::straight_tube(30, 1));
  Size_requests requests;
  requests.balls.push_back({Point(0, 0, 15), 6, 0.5});
  const double plain = size_of(model, Size_requests())(Point(0, 0, 15));
  EXPECT_NEAR(size_of(model, requests)(Point(0, 0, 15)), 2 * plain, 0.1 * plain);
}

TEST(Size_requests, A_branch_is_refined_all_along) {
  const auto model = model_of(tubular::y_bifurcation());
  ASSERT_EQ(model.centerlines.branches().size(), 3u);
  const auto plain = size_of(model, Size_requests());
  for (std::size_t b = 0; b < 3; ++b) {
    Size_requests requests;
    requests.branches.push_back({b, 2});
    const auto size = size_of(model, requests);
    for (std::size_t other = 0; other < 3; ++other) {
      const auto& branch = model.centerlines.branches()[other];
      const Point p = model.centerlines.points()[branch.points[branch.points.size() / 2]];
      EXPECT_NEAR(size(p), other == b ? plain(p) / 2 : plain(p), 0.05 * plain(p)) << b << " " << other;
    }
  }
}

TEST(Size_requests, Sizes_on_the_surface_take_the_place_of_the_radius) {
  const auto model = model_of(tubular::straight_tube(20, 1));
  const auto wanted = [](const Point& p) { return 0.1 + 0.02 * p.z(); };
  Size_requests requests;
  for (auto f : model.surface.faces()) {
    Size_requests::Sized_triangle t;
    std::size_t i = 0;
    for (auto v : model.surface.vertices_around_face(model.surface.halfedge(f))) {
      t.corners[i] = model.surface.point(v);
      t.sizes[i++] = wanted(model.surface.point(v));
    }
    requests.surface.push_back(t);
  }
  const auto size = size_of(model, requests);
  for (double z : {1., 5., 10., 19.})
    for (double x : {0., 0.5, 0.95})
      EXPECT_NEAR(size(Point(x, 0, z)), wanted(Point(x, 0, z)), 0.05 * wanted(Point(x, 0, z))) << x << " " << z;

  for (auto& t : requests.surface) // none above z = 10: there it is the radius again
    for (std::size_t i = 0; i < 3; ++i)
      if (t.corners[i].z() > 10)
        t.sizes[i] = i == 0 ? 0 : i == 1 ? -1 : std::numeric_limits<double>::quiet_NaN();
  const auto half = size_of(model, requests);
  const double plain = size_of(model, Size_requests())(Point(0, 0, 18));
  EXPECT_NEAR(half(Point(0, 0, 18)), plain, 0.03 * plain);
  EXPECT_NEAR(half(Point(0, 0, 4)), wanted(Point(0, 0, 4)), 0.01);
}

TEST(Size_requests, Bad_ones_are_refused) {
  const auto model = model_of(tubular::straight_tube(6, 1));
  const auto refused = [&](const Size_requests& requests, const char* word) {
    try {
      Mesher(model, parameters::size_requests(requests)).estimated_number_of_tetrahedra();
      ADD_FAILURE() << word;
    } catch (const tubular::Parameter_error& e) {
      EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
    }
  };
  for (double factor : {0., -1., 1e3, std::numeric_limits<double>::quiet_NaN()}) {
    Size_requests requests;
    requests.balls.push_back({Point(0, 0, 3), 1, factor});
    refused(requests, "factor");
    requests = Size_requests();
    requests.branches.push_back({0, factor});
    refused(requests, "factor");
  }
  Size_requests requests;
  requests.balls.push_back({Point(0, 0, 3), 0, 2});
  refused(requests, "radius");
  requests.balls[0] = {Point(9, 0, 3), 2, 2};
  refused(requests, "(9, 0, 3)");
  requests = Size_requests();
  requests.branches.push_back({1, 2});
  refused(requests, "branch 1");
}

// The nearest wall is at the mouth of a narrow vessel, and so nearer to that vessel's line than the ball is.
TEST(Size_requests, Of_a_ball_in_a_wide_vessel_by_a_narrow_one_are_met) {
  tubular::Tubular_skeleton skeleton;
  skeleton.nodes = {Point(0, 0, -12), Point(0, 0, 0), Point(0, 0, 12), Point(9, 0, 0)};
  const auto add = [&](std::size_t source, std::size_t target, double radius) {
    const Point p = skeleton.nodes[source], q = skeleton.nodes[target];
    skeleton.add_branch(
        source, target, [=](double t) { return p + t * (q - p); }, [=](double) { return radius; });
  };
  add(0, 1, 4);
  add(1, 2, 4);
  add(1, 3, 0.5);
  const auto model = model_of(skeleton);
  Size_requests requests;
  requests.balls.push_back({Point(0.5, 0, 0), 1, 6});
  Mesher plain(model, parameters::points_per_circumference(8));
  Mesher refined(model, parameters::points_per_circumference(8).size_requests(requests));
  const Mixed_mesh coarse = plain.isotropic(), fine = refined.isotropic();
  EXPECT_GT(fine.tetrahedra.size(), coarse.tetrahedra.size() + 2000); // a ball of such tetrahedra alone has as many
  requests.balls[0].center = Point(6, 3, 0); // beside the narrow vessel, and within the radius of the wide one
  EXPECT_THROW(Mesher(model, parameters::size_requests(requests)), tubular::Parameter_error);
}

// --- meshes ---

double mean_edge_near(const Mixed_mesh& mesh, const Point& center, double radius) {
  double sum = 0;
  std::size_t n = 0;
  for (const auto& t : mesh.triangles.vertices)
    for (int i = 0; i < 3; ++i) {
      const Point &p = mesh.points[t[i]], &q = mesh.points[t[(i + 1) % 3]];
      if (CGAL::squared_distance(CGAL::midpoint(p, q), center) < radius * radius) {
        sum += std::sqrt(CGAL::squared_distance(p, q));
        ++n;
      }
    }
  return n > 0 ? sum / double(n) : 0;
}

TEST(Size_requests, Meshes_follow_them_in_any_place_and_unit) {
  const Transformation placements[] = {Transformation(CGAL::IDENTITY),
                                       Transformation(CGAL::SCALING, 1e-3) * rotation(0.7),
                                       Transformation(CGAL::SCALING, 500) * rotation(2.1)};
  const double scales[] = {1, 1e-3, 500};
  for (int i = 0; i < 3; ++i) {
    const auto model = model_of(tubular::straight_tube(12, 1), placements[i]);
    const double s = scales[i];
    Size_requests requests;
    const Point center = placements[i](Point(1, 0, 6));
    requests.balls.push_back({center, 1.2 * s, 2.5});
    const auto np = parameters::points_per_circumference(10).volume_mesher(tubular::default_volume_mesher());
    Mesher plain(model, np), refined(model, np.size_requests(requests));
    for (bool anisotropic : {false, true}) {
      const Mixed_mesh a = anisotropic ? plain.anisotropic() : plain.isotropic(),
                       b = anisotropic ? refined.anisotropic() : refined.isotropic();
      const double ratio = mean_edge_near(a, center, s) / mean_edge_near(b, center, s);
      EXPECT_GT(ratio, 1.8) << i << " " << anisotropic;
      EXPECT_LT(ratio, 3.2) << i << " " << anisotropic;
      for (const Point& p : {Point(1, 0, 1.5), Point(-1, 0, 1.5), Point(1, 0, 10.5), Point(-1, 0, 10.5)}) {
        const Point away = placements[i](p);
        EXPECT_NEAR(mean_edge_near(b, away, s), mean_edge_near(a, away, s), 0.2 * mean_edge_near(a, away, s))
            << i << " " << anisotropic << " " << p;
      }
    }
  }
}

// --- the number of elements ---

// Makes "meshes" until there is one of the number wanted; returns how many.
template <class Count> std::size_t tries_for(double wanted, double first, const Count& count) {
  tubular::Element_target target(wanted, first, 3);
  for (std::size_t tries = 1;; ++tries) {
    const std::size_t elements = std::size_t(count(target.points()));
    if (target.add(elements)) {
      EXPECT_NEAR(double(elements), wanted, 0.1 * wanted);
      return tries;
    }
  }
}

TEST(Element_target, Finds_powers_of_any_sort) {
  for (double power : {0.5, 1., 1.5, 2., 3., 4.})
    for (double wanted : {1e3, 3e5, 2e7}) {
      const double factor = power < 1.5 ? 50 : 5;
      if (factor * std::pow(1e4, power) < wanted)
        continue; // no N has so many
      const auto count = [&](double points) { return factor * std::pow(points, power) + 100; };
      EXPECT_LE(tries_for(wanted, 20, count), 8u) << power << " " << wanted;
    }
}

TEST(Element_target, Finds_numbers_that_grow_little_at_first) {
  for (double base : {1e3, 1e4, 1e5})
    for (double factor : {1.2, 2., 5.})
      for (double first : {4., 15., 40.}) {
        const auto count = [&](double points) { return base + std::pow(points, 3); };
        EXPECT_LE(tries_for(factor * base, first, count), 7u) << base << " " << factor;
      }
}

// Steps of a tenth, and numbers that are up to 5 % off, now more, now less: they do not grow everywhere.
TEST(Element_target, Finds_numbers_that_grow_by_steps_and_are_noisy) {
  for (double power : {1., 2., 3.})
    for (double first : {5., 20., 60.}) {
      const auto steps = [&](double points) {
        return 100 * std::pow(1.1, std::floor(std::log(points) / std::log(1.1) * power));
      };
      const auto noise = [&](double points) {
        return 100 * std::pow(points, power) * (1 + 0.05 * std::sin(1e4 * points));
      };
      EXPECT_LE(tries_for(steps(17), first, steps), 9u) << power;
      EXPECT_LE(tries_for(noise(17), first, noise), 9u) << power;
    }
}

TEST(Element_target, Says_when_there_is_no_such_mesh) {
  tubular::Element_target constant(1000, 20, 3), jump(1000, 20, 3);
  EXPECT_THROW(
      {
        while (!constant.add(500))
          ;
      },
      tubular::Meshing_error);
  EXPECT_THROW(
      {
        while (!jump.add(jump.points() < 25 ? 500 : 2000))
          ;
      },
      tubular::Meshing_error);
  EXPECT_THROW(tubular::Element_target(3, 20, 3), tubular::Parameter_error);
}

TEST(Number_of_elements, Is_met_by_each_type_of_mesh) {
  const auto model = model_of(tubular::y_bifurcation());
  for (double wanted : {8000., 40000.}) {
    const auto expect_near = [&](std::size_t elements, const char* type) {
      EXPECT_NEAR(double(elements), wanted, 0.1 * wanted) << type;
    };
    Mesher mesher(model, parameters::number_of_elements(wanted));
    expect_near(mesher.isotropic().number_of_cells(), "isotropic");
    expect_near(mesher.surface().surface.number_of_faces(), "surface");
    if (tubular::default_volume_mesher() != tubular::Volume_mesher::mesh_3 && tubular::has_lemon())
      expect_near(mesher.mixed().number_of_cells(), "mixed");
  }
}

// Its layers at the wall alone have tens of thousands.
TEST(Number_of_elements, Is_met_by_anisotropic_meshes) {
  const double wanted = 80000;
  const auto model = model_of(tubular::y_bifurcation());
  Mesher mesher(model, parameters::number_of_elements(wanted));
  EXPECT_NEAR(double(mesher.anisotropic().number_of_cells()), wanted, 0.1 * wanted);
}

} // namespace
