// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/Generators/Tubular_distance_function.h>
#include <CGAL/Tubular_meshing/Generators/bronchial_tree.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/Rims/trim_by_plane.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
typedef CGAL::Surface_mesh<Point_3> Surface;
namespace tubular = CGAL::Tubular_meshing;
namespace pmp = CGAL::Polygon_mesh_processing;
typedef tubular::Tubular_skeleton Skeleton;
typedef tubular::Tubular_distance_function Function;
using tubular::parameters::points_per_circumference;

template <class... NamedParameters> Surface generate(const Skeleton& s, const NamedParameters&... np) {
  Surface surface;
  tubular::generate_tubular_surface(s, surface, np...);
  return surface;
}

std::vector<Surface::Halfedge_index> border_loops(const Surface& s) {
  std::vector<Surface::Halfedge_index> loops;
  pmp::extract_boundary_cycles(s, std::back_inserter(loops));
  return loops;
}

long euler_characteristic(const Surface& s) {
  return long(s.number_of_vertices()) - long(s.number_of_edges()) + long(s.number_of_faces());
}

double distance(const Point_3& a, const Point_3& b) {
  return std::sqrt(CGAL::squared_distance(a, b));
}

// 1 for an equilateral triangle, 0 for a flat one.
double worst_triangle(const Surface& s) {
  double worst = 1;
  for (auto f : s.faces()) {
    const auto h = s.halfedge(f);
    const Point_3 &a = s.point(s.source(h)), &b = s.point(s.target(h)), &c = s.point(s.target(s.next(h)));
    const double squares = CGAL::squared_distance(a, b) + CGAL::squared_distance(b, c) + CGAL::squared_distance(c, a);
    worst = std::min(worst, 4 * std::sqrt(3 * CGAL::squared_area(a, b, c)) / squares);
  }
  return worst;
}

// The end whose centre is nearest.
Skeleton::End end_at(const Skeleton& s, const Point_3& p) {
  const std::vector<Skeleton::End> ends = s.ends();
  return *std::min_element(ends.begin(), ends.end(), [&](const Skeleton::End& a, const Skeleton::End& b) {
    return CGAL::squared_distance(a.center, p) < CGAL::squared_distance(b.center, p);
  });
}

void expect_manifold_of_the_skeleton(const Surface& s, const Skeleton& skeleton, bool capped) {
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(s));
  EXPECT_TRUE(CGAL::is_triangle_mesh(s));
  EXPECT_FALSE(s.has_garbage());
  const long openings = capped ? 0 : long(skeleton.number_of_openings());
  EXPECT_EQ(border_loops(s).size(), std::size_t(openings));
  EXPECT_EQ(euler_characteristic(s), 2 - 2 * long(skeleton.number_of_loops()) - openings);
  EXPECT_FALSE(pmp::does_self_intersect(s));
  EXPECT_GT(worst_triangle(s), 0.3);
}

// Also that it is seldom on the fillet of a junction.
void expect_vertices_at_the_radius(const Surface& s, const Skeleton& skeleton) {
  const Function function(skeleton);
  std::size_t checked = 0;
  for (auto v : s.vertices()) {
    const Function::Value value = function.evaluate(s.point(v));
    if (value.blended) {
      EXPECT_NEAR(value.value, 0, 1e-6 * value.radius);
      continue;
    }
    ++checked;
    EXPECT_NEAR(value.distance, value.radius, 1e-6 * value.radius) << s.point(v);
  }
  EXPECT_GT(checked, 3 * s.number_of_vertices() / 5);
}

void expect_planar_circular_rims(const Surface& s, const Skeleton& skeleton) {
  std::vector<bool> seen(skeleton.nodes.size(), false);
  for (auto loop : border_loops(s)) {
    const Skeleton::End end = end_at(skeleton, s.point(s.target(loop)));
    EXPECT_FALSE(seen[end.node]);
    seen[end.node] = true;
    for (auto h : CGAL::halfedges_around_face(loop, s)) {
      const Vector_3 d = s.point(s.target(h)) - end.center;
      EXPECT_NEAR(d * end.normal, 0, 1e-10 * end.radius);
      EXPECT_NEAR(std::sqrt(d.squared_length()), end.radius, 1e-9 * end.radius);
    }
  }
}

Skeleton moved_and_scaled(Skeleton s, double scale, const Vector_3& move) {
  auto change = [&](Point_3& p) { p = CGAL::ORIGIN + scale * (p - CGAL::ORIGIN) + move; };
  for (Point_3& p : s.nodes)
    change(p);
  for (auto& b : s.branches) {
    for (Point_3& p : b.points)
      change(p);
    for (double& r : b.radius)
      r *= scale;
  }
  return s;
}

struct Shape {
  std::string name;
  Skeleton skeleton;
  std::size_t branches, openings, loops;
};

std::vector<Shape> shapes() {
  return {{"tube", tubular::straight_tube(), 1, 2, 0},  {"curved", tubular::curved_tube(), 1, 2, 0},
          {"y", tubular::y_bifurcation(), 3, 3, 0},     {"arch", tubular::aortic_arch(), 7, 5, 0},
          {"willis", tubular::willis_loop(), 14, 7, 1}, {"tree", tubular::bronchial_tree(15), 15, 9, 0}};
}

} // namespace

TEST(Tubular_skeleton, Shapes_have_the_documented_numbers_of_branches_openings_and_loops) {
  for (const Shape& s : shapes()) {
    SCOPED_TRACE(s.name);
    EXPECT_NO_THROW(tubular::check_skeleton(s.skeleton));
    EXPECT_EQ(s.skeleton.number_of_branches(), s.branches);
    EXPECT_EQ(s.skeleton.number_of_openings(), s.openings);
    EXPECT_EQ(s.skeleton.number_of_loops(), s.loops);
    EXPECT_EQ(s.skeleton.ends().front().node, s.skeleton.inlet);
  }
}

TEST(Tubular_skeleton, Centerlines_of_a_tree_run_from_the_inlet_to_each_outlet) {
  for (const Shape& s : shapes()) {
    SCOPED_TRACE(s.name);
    const auto lines = tubular::centerlines_of(s.skeleton);
    ASSERT_EQ(lines.points.size(), lines.radius.size());
    ASSERT_EQ(lines.lines.size(), s.loops > 0 ? s.branches : s.openings - 1);
    if (s.loops > 0)
      continue;
    std::vector<Point_3> outlets, targets;
    for (const auto& line : lines.lines) {
      EXPECT_EQ(lines.points[line.front()], s.skeleton.nodes[s.skeleton.inlet]);
      targets.push_back(lines.points[line.back()]);
      for (std::size_t i = 0; i + 1 < line.size(); ++i)
        EXPECT_LT(distance(lines.points[line[i]], lines.points[line[i + 1]]), lines.radius[line[i]]);
    }
    for (const auto& end : s.skeleton.ends())
      if (end.node != s.skeleton.inlet)
        outlets.push_back(end.center);
    std::sort(outlets.begin(), outlets.end());
    std::sort(targets.begin(), targets.end());
    EXPECT_EQ(outlets, targets);
  }
}

TEST(Tubular_skeleton, Inconsistent_ones_are_refused_by_name) {
  Skeleton s = tubular::y_bifurcation();
  s.branches[2].radius[1] = std::numeric_limits<double>::quiet_NaN();
  try {
    generate(s);
    FAIL() << "a radius that is not a number was accepted";
  } catch (const tubular::Input_error& e) {
    EXPECT_NE(std::string(e.what()).find("branch 2"), std::string::npos) << e.what();
  }
  s = tubular::y_bifurcation();
  s.inlet = 1;
  EXPECT_THROW(generate(s), tubular::Input_error);
  s = tubular::y_bifurcation();
  s.nodes[2] = Point_3(1, 1, 1);
  EXPECT_THROW(generate(s), tubular::Input_error);
  EXPECT_THROW(tubular::bronchial_tree(0), tubular::Parameter_error);
  EXPECT_THROW(tubular::bronchial_tree(304), tubular::Parameter_error);
}

TEST(Bronchial_tree, Radii_shrink_as_Weibel_says_and_branches_keep_apart) {
  const Skeleton s = tubular::bronchial_tree(305);
  ASSERT_EQ(s.branches.size(), 305u);
  EXPECT_EQ(s.number_of_openings(), 154u);
  std::vector<std::size_t> into(s.nodes.size(), 305);
  for (std::size_t i = 0; i < 305; ++i)
    into[s.branches[i].target] = i;
  for (const auto& b : s.branches) {
    if (b.source == s.inlet)
      continue;
    EXPECT_NEAR(b.radius[0] / s.branches[into[b.source]].radius[0], std::pow(0.5, 1 / 3.), 1e-12);
  }
  double least = 1e9;
  for (const auto& a : s.branches)
    for (const auto& b : s.branches) {
      if (a.source == b.source || a.source == b.target || a.target == b.source || a.target == b.target)
        continue;
      for (const Point_3& p : a.points)
        for (const Point_3& q : b.points)
          least = std::min(least, CGAL::squared_distance(p, q) / CGAL::square(a.radius[0] + b.radius[0]));
    }
  EXPECT_GT(std::sqrt(least), 1.6);
}

TEST(Generate_tubular_surface, Shapes_are_manifold_of_the_right_topology_and_at_the_radius) {
  for (const Shape& s : shapes()) {
    SCOPED_TRACE(s.name);
    const Surface surface = generate(s.skeleton, points_per_circumference(20.));
    expect_manifold_of_the_skeleton(surface, s.skeleton, false);
    expect_vertices_at_the_radius(surface, s.skeleton);
    expect_planar_circular_rims(surface, s.skeleton);
  }
}

TEST(Generate_tubular_surface, Capped_shapes_are_closed_and_oriented_outwards) {
  for (const Shape& s : shapes()) {
    SCOPED_TRACE(s.name);
    const Surface surface = generate(s.skeleton, points_per_circumference(16.).capped_ends(true));
    expect_manifold_of_the_skeleton(surface, s.skeleton, true);
    EXPECT_TRUE(CGAL::is_closed(surface));
    EXPECT_GT(pmp::volume(surface), 0);
  }
}

TEST(Generate_tubular_surface, Volumes_and_areas_approach_the_closed_forms_quadratically) {
  const double r = 1.5, length = 9, bend = 6, angle = 2;
  const Skeleton tube = tubular::straight_tube(length, r);
  const Skeleton curved = tubular::curved_tube(bend, angle, r);
  const double tube_volume = CGAL_PI * r * r * length, curved_volume = CGAL_PI * r * r * bend * angle;
  const double tube_area = 2 * CGAL_PI * r * length;
  for (double n : {16., 32., 64.}) {
    const double expected = std::pow(2 * CGAL_PI / n, 2) / 6; // what an inscribed polygon of n sides lacks
    const auto capped = points_per_circumference(n).capped_ends(true);
    const double tube_lack = 1 - pmp::volume(generate(tube, capped)) / tube_volume;
    const double curved_lack = 1 - pmp::volume(generate(curved, capped)) / curved_volume;
    const double area_lack = 1 - pmp::area(generate(tube, points_per_circumference(n))) / tube_area;
    EXPECT_GT(tube_lack, 0.5 * expected);
    EXPECT_LT(tube_lack, 2 * expected);
    EXPECT_GT(curved_lack, 0.5 * expected);
    EXPECT_LT(curved_lack, 2.5 * expected);
    EXPECT_GT(area_lack, 0);
    EXPECT_LT(area_lack, 1.5 * expected);
  }
}

TEST(Generate_tubular_surface, Edges_are_as_long_as_the_points_round_the_circumference_ask) {
  const Skeleton arch = tubular::aortic_arch();
  const Function function(arch);
  for (double n : {12., 24., 40.}) {
    const Surface surface = generate(arch, points_per_circumference(n));
    double sum = 0;
    std::size_t count = 0;
    for (auto e : surface.edges()) {
      const Point_3 &p = surface.point(surface.vertex(e, 0)), &q = surface.point(surface.vertex(e, 1));
      sum += distance(p, q) * n / (2 * CGAL_PI * function.evaluate(p).radius);
      ++count;
    }
    EXPECT_NEAR(sum / double(count), 1, 0.05);
    for (auto loop : border_loops(surface)) {
      const auto rim = CGAL::halfedges_around_face(loop, surface);
      EXPECT_NEAR(double(std::distance(rim.begin(), rim.end())), n, 0.3 * n);
    }
  }
}

TEST(Generate_tubular_surface, Size_and_place_of_the_model_do_not_matter) {
  const Skeleton y = tubular::y_bifurcation();
  const double faces = double(generate(y).number_of_faces());
  for (double scale : {1e-3, 1e6}) {
    const Skeleton other = moved_and_scaled(y, scale, scale * Vector_3(1500, -900, 700));
    const Surface surface = generate(other);
    EXPECT_NEAR(double(surface.number_of_faces()), faces, 0.02 * faces);
    expect_manifold_of_the_skeleton(surface, other, false);
  }
}

TEST(Generate_tubular_surface, The_same_options_give_the_same_surface) {
  const Skeleton y = tubular::y_bifurcation();
  const auto options = points_per_circumference(16.).noise(0.03).noise_seed(7u);
  const Surface a = generate(y, options), b = generate(y, options);
  ASSERT_EQ(a.number_of_vertices(), b.number_of_vertices());
  ASSERT_EQ(a.number_of_faces(), b.number_of_faces());
  for (auto v : a.vertices())
    ASSERT_EQ(a.point(v), b.point(v));
  for (auto h : a.halfedges())
    ASSERT_EQ(a.target(h), b.target(h));
}

TEST(Generate_tubular_surface, Noise_has_its_amplitude_and_leaves_rims_planar) {
  const Skeleton tube = tubular::straight_tube(12, 2);
  const double amplitude = 0.04;
  const Surface noisy = generate(tube, points_per_circumference(24.).noise(amplitude).noise_seed(3u));
  const Surface other = generate(tube, points_per_circumference(24.).noise(amplitude).noise_seed(4u));
  double largest = 0, sum = 0, difference = 0;
  for (auto v : noisy.vertices()) {
    const Point_3& p = noisy.point(v);
    const double offset = (std::hypot(p.x(), p.y()) - 2) / 2;
    largest = std::max(largest, std::abs(offset));
    sum += offset;
    difference = std::max(difference, distance(p, other.point(v)));
    if (noisy.is_border(v)) {
      EXPECT_NEAR(std::min(std::abs(p.z()), std::abs(p.z() - 12)), 0, 1e-12);
    }
  }
  EXPECT_LE(largest, amplitude + 1e-9);
  EXPECT_GT(largest, 0.95 * amplitude);
  EXPECT_NEAR(sum / double(noisy.number_of_vertices()), 0, 0.1 * amplitude);
  EXPECT_GT(difference, amplitude);
}

TEST(Generate_tubular_surface, Sagging_rims_leave_their_planes_and_the_wall_follows_within_two_radii) {
  const Skeleton tube = tubular::straight_tube(12, 2);
  const Surface straight = generate(tube);
  for (auto shape : {tubular::Sag_shape::saddle, tubular::Sag_shape::tilt}) {
    const Surface sagging = generate(tube, tubular::parameters::sag(0.3).sag_shape(shape));
    ASSERT_EQ(sagging.number_of_vertices(), straight.number_of_vertices());
    double highest = 0, lowest = 0;
    for (auto v : sagging.vertices()) {
      const Point_3 &p = straight.point(v), &q = sagging.point(v);
      EXPECT_NEAR(std::hypot(q.x(), q.y()), 2, 1e-8);
      if (p.z() > 4 && p.z() < 8) {
        EXPECT_LT(distance(p, q), 1e-9);
      }
      if (sagging.is_border(v) && p.z() > 6) {
        highest = std::max(highest, q.z() - 12);
        lowest = std::min(lowest, q.z() - 12);
      }
    }
    EXPECT_NEAR(highest, 0.6, 0.02);
    EXPECT_NEAR(lowest, -0.6, 0.02);
    EXPECT_FALSE(pmp::does_self_intersect(sagging));
  }
  const Surface capped = generate(tube, tubular::parameters::sag(0.3).capped_ends(true));
  EXPECT_TRUE(CGAL::is_closed(capped));
  EXPECT_FALSE(pmp::does_self_intersect(capped));
}

TEST(Generate_tubular_surface, Values_out_of_range_are_refused) {
  const Skeleton tube = tubular::straight_tube();
  EXPECT_THROW(generate(tube, points_per_circumference(2.)), tubular::Parameter_error);
  EXPECT_THROW(generate(tube, points_per_circumference(std::nan(""))), tubular::Parameter_error);
  EXPECT_THROW(generate(tube, tubular::parameters::noise(-0.1)), tubular::Parameter_error);
  EXPECT_THROW(generate(tube, tubular::parameters::sag(2.)), tubular::Parameter_error);
}

TEST(Generate_tubular_surface, A_tree_of_305_branches) {
  const Skeleton tree = tubular::bronchial_tree(305);
  const Surface surface = generate(tree, points_per_circumference(10.));
  expect_manifold_of_the_skeleton(surface, tree, false);
  expect_vertices_at_the_radius(surface, tree);
  expect_planar_circular_rims(surface, tree);
}

// --- trim_by_plane ---

namespace {

Surface::Halfedge_index upper_rim(const Surface& s) {
  const auto loops = border_loops(s);
  return *std::max_element(loops.begin(), loops.end(), [&](Surface::Halfedge_index a, Surface::Halfedge_index b) {
    return s.point(s.target(a)).z() < s.point(s.target(b)).z();
  });
}

bool is_same(const Surface& a, const Surface& b) {
  return a.number_of_faces() == b.number_of_faces() && a.number_of_vertices() == b.number_of_vertices() &&
         !a.has_garbage() && std::equal(a.points().begin(), a.points().end(), b.points().begin());
}

} // namespace

TEST(Trim_by_plane, Leaves_one_planar_rim_and_no_slivers) {
  const Surface tube = generate(tubular::straight_tube(12, 2));
  for (int i = 0; i < 60; ++i) {
    Surface s = tube;
    const Point_3 origin(0, 0, 6 + 0.05 * i);
    Vector_3 normal(0.1 * std::sin(i), 0.01 * (i % 11), 1);
    const auto rim = tubular::internal::trim_by_plane(s, origin, normal, upper_rim(s));
    ASSERT_NE(rim, Surface::null_halfedge());
    ASSERT_TRUE(s.is_border(rim));
    normal = normal / std::sqrt(normal.squared_length());
    for (auto h : CGAL::halfedges_around_face(rim, s))
      EXPECT_NEAR((s.point(s.target(h)) - origin) * normal, 0, 1e-14);
    s.collect_garbage();
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(s));
    EXPECT_TRUE(CGAL::is_triangle_mesh(s));
    EXPECT_EQ(border_loops(s).size(), 2u);
    EXPECT_EQ(euler_characteristic(s), 0);
    EXPECT_GT(worst_triangle(s), 0.1);
    for (auto v : s.vertices())
      EXPECT_LE((s.point(v) - origin) * normal, 1e-14);
    EXPECT_FALSE(pmp::does_self_intersect(s));
  }
}

TEST(Trim_by_plane, Opens_a_rough_wall_in_one_loop) {
  const Skeleton tube = tubular::straight_tube(12, 2);
  for (unsigned seed = 0; seed < 20; ++seed) {
    Surface s = generate(tube, points_per_circumference(20.).noise(0.05).noise_seed(seed).sag(0.2));
    const auto rim = tubular::internal::trim_by_plane(s, Point_3(0, 0, 11), Vector_3(0, 0.1, 2), upper_rim(s));
    ASSERT_NE(rim, Surface::null_halfedge());
    s.collect_garbage();
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(s));
    EXPECT_EQ(border_loops(s).size(), 2u);
    EXPECT_EQ(euler_characteristic(s), 0);
  }
}

TEST(Trim_by_plane, Opens_a_closed_surface_at_a_vertex) {
  Surface s = generate(tubular::straight_tube(12, 2), tubular::parameters::capped_ends(true));
  const double volume = pmp::volume(s);
  auto tip = *std::find_if(s.vertices().begin(), s.vertices().end(),
                           [&](Surface::Vertex_index v) { return s.point(v).z() > 11.9; });
  const auto rim =
      tubular::internal::trim_by_plane(s, Point_3(0, 0, 9), Vector_3(0, 0, 1), std::vector<Surface::Vertex_index>{tip});
  ASSERT_NE(rim, Surface::null_halfedge());
  s.collect_garbage();
  EXPECT_EQ(border_loops(s).size(), 1u);
  // The rim lies in z = 9 and the surface below it spans the origin's side, so its cone volume from a point of that
  // plane is the volume that is left.
  double left = 0;
  const Point_3 apex(0, 0, 9);
  for (auto f : s.faces()) {
    const auto h = s.halfedge(f);
    left += CGAL::volume(apex, s.point(s.source(h)), s.point(s.target(h)), s.point(s.target(s.next(h))));
  }
  EXPECT_NEAR(left / volume, 0.75, 0.002);
}

TEST(Trim_by_plane, Leaves_the_surface_as_it_is_when_the_cut_is_no_single_loop) {
  const Surface y = generate(tubular::y_bifurcation());
  Surface s = y;
  const auto null = Surface::null_halfedge();
  // through the rim
  const Skeleton skeleton = tubular::y_bifurcation();
  const auto end = skeleton.ends()[1];
  auto rim = upper_rim(s);
  EXPECT_EQ(
      tubular::internal::trim_by_plane(s, end_at(skeleton, s.point(s.target(rim))).center, Vector_3(1, 0, 0), rim),
      null);
  EXPECT_TRUE(is_same(s, y));
  // through both branches and over the other opening, on the parent
  EXPECT_EQ(tubular::internal::trim_by_plane(s, Point_3(0, 0, 4), Vector_3(0, 0, 1), rim), null);
  EXPECT_TRUE(is_same(s, y));
  // the rim below the plane
  EXPECT_EQ(tubular::internal::trim_by_plane(s, Point_3(0, 0, 40), Vector_3(0, 0, 1), rim), null);
  EXPECT_TRUE(is_same(s, y));
  // farther than allowed
  EXPECT_EQ(tubular::internal::trim_by_plane(s, end.center - 4 * end.normal, end.normal, rim, 2.), null);
  EXPECT_TRUE(is_same(s, y));
}

TEST(Trim_by_plane, A_rim_in_the_plane_stays) {
  const Surface tube = generate(tubular::straight_tube(12, 2));
  Surface s = tube;
  const auto rim = tubular::internal::trim_by_plane(s, Point_3(0, 0, 12), Vector_3(0, 0, 1), upper_rim(s));
  ASSERT_NE(rim, Surface::null_halfedge());
  EXPECT_EQ(s.number_of_faces(), tube.number_of_faces());
  EXPECT_FALSE(s.has_garbage());
}
