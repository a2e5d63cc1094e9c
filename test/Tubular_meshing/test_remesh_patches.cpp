// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces meshed anew patch by patch: their shape, their sizes, their patches, and that they are surfaces at all.

#include "surface_measures.h"
#include "test_surfaces.h"

#include <CGAL/Tubular_meshing/Generators/bronchial_tree.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Patches/internal/remeshing/Surface_sizes.h>
#include <CGAL/Tubular_meshing/Patches/internal/remeshing/Triangle_piece_mesher.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Curve_divider.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Peak_finder.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/Pipelines/make_mesh.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace test_surfaces;
namespace tubular = CGAL::Tubular_meshing;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef tubular::Tubular_model Model;
typedef tubular::Remeshed_surface Remeshed;

const double pi = 3.14159265358979323846;

// --- models ---

Model model_of(const tubular::Tubular_skeleton& skeleton, double points = 24, double noise = 0) {
  Mesh mesh;
  tubular::generate_tubular_surface(skeleton, mesh, tubular::parameters::points_per_circumference(points).noise(noise));
  return tubular::make_tubular_model(mesh, tubular::centerlines_of(skeleton));
}

Remeshed remesh(const Model& model, double points) {
  return tubular::make_isotropic_surface_mesh(
      model, tubular::parameters::points_per_circumference(points).preserve_volume(false));
}

// --- an independent look at a surface ---

std::array<Point, 3> corners(const Mesh& mesh, Mesh::Face_index f) {
  const auto h = mesh.halfedge(f);
  return {{mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h)))}};
}

struct Quality {
  double worst = 1, mean = 0;
};
Quality quality_of(const Mesh& mesh) {
  Quality q;
  for (auto f : mesh.faces()) {
    const auto c = corners(mesh, f);
    const double gamma = tubular::internal::triangle_gamma(
        tubular::internal::Vector_3d(c[0]), tubular::internal::Vector_3d(c[1]), tubular::internal::Vector_3d(c[2]));
    q.worst = std::min(q.worst, gamma);
    q.mean += gamma / double(mesh.number_of_faces());
  }
  return q;
}

// What every surface mesh must be, whatever it is of.
void expect_good(const Model& model, const Remeshed& r, double worst_gamma = 0.5, double mean_gamma = 0.95) {
  EXPECT_TRUE(r.surface.is_valid());
  EXPECT_TRUE(CGAL::is_closed(r.surface));
  EXPECT_TRUE(CGAL::is_triangle_mesh(r.surface));
  EXPECT_FALSE(PMP::does_self_intersect(r.surface));
  EXPECT_EQ(euler(r.surface), euler(model.surface));
  EXPECT_GT(PMP::volume(r.surface), 0);
  const Quality q = quality_of(r.surface);
  EXPECT_GE(q.worst, worst_gamma);
  EXPECT_GE(q.mean, mean_gamma);
  EXPECT_LE(distance(r.surface, model.surface), 1e-9 * extent(model.surface)) << "all vertices are on the old surface";
  EXPECT_TRUE(r.report.problems.empty()) << r.report.problems.front();
  EXPECT_LE(r.report.largest_aspect_ratio, 4 * (1 + 1e-9));
}

// The Euler characteristic of the faces with a number, and the number of their border edges.
std::map<int, std::array<long, 2>> topology_of_patches(const Remeshed& r) {
  std::map<int, std::set<Mesh::Vertex_index>> vertices;
  std::map<int, std::set<Mesh::Edge_index>> edges;
  std::map<int, std::array<long, 2>> result;
  for (auto f : r.surface.faces()) {
    const int k = r.patch_of_face[f];
    ++result[k][0];
    for (auto h : r.surface.halfedges_around_face(r.surface.halfedge(f))) {
      vertices[k].insert(r.surface.target(h));
      edges[k].insert(r.surface.edge(h));
      if (r.patch_of_face[r.surface.face(r.surface.opposite(h))] != k)
        ++result[k][1];
    }
  }
  for (auto& k : result)
    k.second[0] += long(vertices[k.first].size()) - long(edges[k.first].size());
  return result;
}

// --- curves ---

typedef tubular::internal::Curve_divider Divider;
typedef tubular::internal::Curve_position Position;

std::vector<Point> circle(int n, double radius) {
  std::vector<Point> points;
  for (int i = 0; i < n; ++i)
    points.push_back(Point(radius * std::cos(2 * pi * i / n), radius * std::sin(2 * pi * i / n), 0));
  return points;
}

double gap(const Divider::Points& points, std::size_t i) {
  return std::sqrt(CGAL::squared_distance(points[i].point, points[(i + 1) % points.size()].point));
}

TEST(Curve, Is_divided_into_edges_of_the_size) {
  const std::vector<Point> c = circle(1000, 1);
  for (double h : {0.05, 0.1, 0.3}) {
    const auto points = Divider(
                            c, [&](const Position&) { return h; }, false)
                            .divide(c, 3, false);
    EXPECT_EQ(points.size(), std::size_t(std::lround(2 * pi / h)));
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_NEAR(gap(points, i), 2 * std::sin(pi / double(points.size())), 1e-3 * h);
  }
}

TEST(Curve, May_be_coarser_than_its_mesh) {
  const std::vector<Point> c = circle(6, 1);
  const auto points = Divider(
                          c, [](const Position&) { return 0.1; }, false)
                          .divide(c, 3, false);
  EXPECT_EQ(points.size(), 60u);
  for (const auto& p : points) {
    const auto &a = c[p.edge], &b = c[(p.edge + 1) % 6];
    EXPECT_LT(CGAL::squared_distance(p.point, a + p.t * (b - a)), 1e-24);
  }
}

TEST(Curve, Has_an_even_number_of_edges_if_wanted_and_never_too_few) {
  const std::vector<Point> c = circle(100, 1);
  for (double h : {0.1, 0.21, 0.33, 0.5}) {
    const std::size_t n = Divider(
                              c, [&](const Position&) { return h; }, false)
                              .divide(c, 3, true)
                              .size();
    EXPECT_EQ(n % 2, 0u);
    EXPECT_NEAR(double(n), 2 * pi / h, 1.5);
  }
  EXPECT_EQ(Divider(
                c, [](const Position&) { return 10.; }, false)
                .divide(c, 6, false)
                .size(),
            6u);
}

TEST(Curve, Keeps_its_corners_where_told_to) {
  std::vector<Point> square;
  for (const auto& p : {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)})
    square.push_back(p);
  const auto points = Divider(
                          square, [](const Position&) { return 0.3; }, true)
                          .divide(square, 3, false);
  EXPECT_EQ(points.size(), 12u); // three on each side
  for (const Point& corner : square)
    EXPECT_TRUE(std::any_of(points.begin(), points.end(), [&](const auto& p) { return p.point == corner; }));
}

TEST(Curve, Follows_a_size_that_varies) {
  const std::vector<Point> c = circle(2000, 1);
  const auto size = [](const Point& p) { return 0.03 * (1 + 0.5 * p.x()); };
  const auto points = Divider(
                          c, [&](const Position& at) { return size(at.point); }, false)
                          .divide(c, 3, false);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_NEAR(gap(points, i) / size(CGAL::midpoint(points[i].point, points[(i + 1) % points.size()].point)), 1, 0.03);
}

TEST(Curve, Follows_a_size_of_its_edges) { // as one is that depends on their directions
  std::vector<Point> square;
  for (const auto& p : {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)})
    square.push_back(p);
  const auto size = [](const Position& at) { return at.edge % 2 == 0 ? 0.2 : 0.1; };
  const auto points = Divider(square, size, true).divide(square, 3, false);
  std::size_t along_x = 0;
  for (const auto& p : points)
    along_x += p.edge % 2 == 0;
  EXPECT_NEAR(double(along_x), 10 + 2, 2) << "a smaller size grows gradually";
  EXPECT_NEAR(double(points.size() - along_x), 20, 2);
}

TEST(Curve, Lets_a_small_size_grow_gradually) {
  const std::vector<Point> c = circle(2000, 1);
  const auto size = [](const Position& at) { return at.point.x() > 0.99 ? 0.01 : 0.2; };
  const auto points = Divider(c, size, false).divide(c, 3, false);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double ratio = gap(points, i) / gap(points, (i + 1) % points.size());
    EXPECT_LT(std::max(ratio, 1 / ratio), 1.8);
  }
}

// --- peaks ---

// A flat grid with a height for each of its vertices.
std::vector<int> peaks(int n, const std::vector<double>& height, double prominence) {
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> border;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int a = i * n + j;
      if (i + 1 < n && j + 1 < n) {
        triangles.push_back({{a, a + 1, a + n + 1}});
        triangles.push_back({{a, a + n + 1, a + n}});
      }
      if (i == 0 || j == 0 || i + 1 == n || j + 1 == n)
        border.push_back(a);
    }
  std::vector<int> found = tubular::internal::Peak_finder(height, triangles, {border}).find(prominence);
  std::sort(found.begin(), found.end());
  return found;
}

TEST(Peaks, Are_found_by_their_prominence) {
  const int n = 30;
  std::vector<double> height(n * n, 1);
  const auto add = [&](int i, int j, double top) {
    for (int k = 0; k < n * n; ++k)
      height[std::size_t(k)] += top * std::exp(-0.5 * (std::pow(k / n - i, 2) + std::pow(k % n - j, 2)));
  };
  add(8, 8, 100);
  add(8, 22, 10); // too low
  add(20, 15, 1000);
  EXPECT_EQ(peaks(n, height, 16), (std::vector<int>{8 * n + 8, 20 * n + 15}));
  EXPECT_EQ(peaks(n, height, 5).size(), 3u);
  EXPECT_TRUE(peaks(n, height, 1e4).empty());
  add(0, 3, 1e6); // one on the border is known
  EXPECT_EQ(peaks(n, height, 16).size(), 2u);
}

TEST(Peaks, Beside_a_higher_one_count_from_the_pass) {
  const int n = 25;
  std::vector<double> height(n * n, 1);
  for (int j = 4; j < 21; ++j) // a ridge
    height[std::size_t(12 * n + j)] = j < 12 ? 100 : 1000;
  height[std::size_t(12 * n + 11)] = 50;
  EXPECT_EQ(peaks(n, height, 16).size(), 1u) << "100 over a pass of 50 is no peak";
  height[std::size_t(12 * n + 11)] = height[std::size_t(12 * n + 10)] = 2;
  EXPECT_EQ(peaks(n, height, 16).size(), 2u);
}

// --- surfaces ---

TEST(Remeshed_surface, Of_a_tube_has_the_size_wanted) {
  const Model model = model_of(tubular::straight_tube(10, 1), 60);
  for (double n : {12., 20., 32.}) {
    const Remeshed r = remesh(model, n);
    expect_good(model, r, 0.6, 0.97);
    double sum = 0;
    std::size_t edges = 0;
    for (auto e : r.surface.edges()) {
      sum += std::sqrt(
          CGAL::squared_distance(r.surface.point(r.surface.vertex(e, 0)), r.surface.point(r.surface.vertex(e, 1))));
      ++edges;
    }
    const double h = 2 * pi / n;
    EXPECT_NEAR(sum / double(edges) / h, 1, 0.06);
    for (const auto& curve : r.curves)
      EXPECT_NEAR(double(curve.size()), n, 1);
  }
}

TEST(Remeshed_surface, Keeps_volume_and_caps) {
  const Model model = model_of(tubular::curved_tube(), 60);
  const Remeshed r = remesh(model, 40);
  expect_good(model, r, 0.6, 0.97);
  EXPECT_NEAR(PMP::volume(r.surface) / PMP::volume(model.surface), 1, 0.01);
  for (const auto& opening : model.openings) {
    double area = 0;
    for (auto f : r.surface.faces())
      if (r.patch[f] == opening.patch)
        area += PMP::face_area(f, r.surface);
    EXPECT_NEAR(area / opening.area, 1, 0.01);
  }
}

TEST(Remeshed_surface, Of_a_bifurcation_has_its_patches) {
  const Model model = model_of(tubular::y_bifurcation());
  const Remeshed r = remesh(model, 20);
  expect_good(model, r);
  const auto patches = topology_of_patches(r);
  EXPECT_EQ(patches.size(), r.report.number_of_patches() + 1); // and caps, as −1
  std::size_t annuli = 0, junctions = 0;
  for (const auto& p : patches) {
    annuli += p.first >= 0 && p.second[0] == 0;
    junctions += p.first >= 0 && p.second[0] == -1;
  }
  EXPECT_EQ(annuli, r.report.kinds.at(tubular::Patch_kind::annular));
  EXPECT_EQ(junctions, 1u);
}

TEST(Remeshed_surface, Has_edges_along_all_curves) {
  const Model model = model_of(tubular::aortic_arch());
  const Remeshed r = remesh(model, 16);
  expect_good(model, r);
  std::size_t edges_between_patches = 0, edges_on_curves = 0;
  for (auto e : r.surface.edges())
    edges_between_patches += r.patch_of_face[r.surface.face(r.surface.halfedge(e, 0))] !=
                             r.patch_of_face[r.surface.face(r.surface.halfedge(e, 1))];
  for (const auto& curve : r.curves)
    for (std::size_t i = 0; i < curve.size(); ++i) {
      EXPECT_NE(r.surface.halfedge(curve[i], curve[(i + 1) % curve.size()]), Mesh::null_halfedge());
      ++edges_on_curves;
    }
  EXPECT_EQ(edges_between_patches, edges_on_curves);
}

TEST(Remeshed_surface, Has_even_curves_if_wanted) {
  const Model model = model_of(tubular::aortic_arch());
  const Remeshed r = tubular::make_isotropic_surface_mesh(
      model, tubular::parameters::points_per_circumference(15).even_curves(true).preserve_volume(false));
  expect_good(model, r);
  for (const auto& curve : r.curves)
    EXPECT_EQ(curve.size() % 2, 0u);
}

TEST(Remeshed_surface, Of_vessels_that_split_and_rejoin) {
  const Model model = model_of(tubular::willis_loop());
  expect_good(model, remesh(model, 16));
}

TEST(Remeshed_surface, Of_a_noisy_tree) {
  const Model model = model_of(tubular::bronchial_tree(31), 14, 0.02);
  expect_good(model, remesh(model, 14));
}

TEST(Remeshed_surface, Is_finer_or_coarser_than_the_old_one) {
  const Model model = model_of(tubular::y_bifurcation(), 24);
  const std::size_t coarse = remesh(model, 8).surface.number_of_faces();
  const Remeshed fine = remesh(model, 60);
  expect_good(model, fine, 0.5, 0.97);
  EXPECT_GT(fine.surface.number_of_faces(), 40 * coarse);
}

TEST(Remeshed_surface, Does_not_depend_on_the_number_of_threads) {
  const Model model = model_of(tubular::aortic_arch());
  const auto run = [&](int threads) {
    return tubular::make_isotropic_surface_mesh(model, tubular::parameters::number_of_threads(threads));
  };
  const Remeshed one = run(1), two = run(2);
  ASSERT_EQ(one.surface.number_of_vertices(), two.surface.number_of_vertices());
  for (auto v : one.surface.vertices())
    ASSERT_EQ(one.surface.point(v), two.surface.point(v));
}

TEST(Remeshed_surface, Does_not_depend_on_unit_position_and_direction) {
  Mesh mesh;
  tubular::generate_tubular_surface(tubular::aortic_arch(), mesh);
  const Remeshed r = remesh(tubular::make_tubular_model(mesh), 14);
  const double c = std::cos(1.), s = std::sin(1.), k = 1e-3;
  const Transformation t(k * c, -k * s, 0, 50 * k, k * s, k * c, 0, -20 * k, 0, 0, k, 70 * k);
  const Remeshed moved = remesh(tubular::make_tubular_model(test_surfaces::transformed(mesh, t)), 14);
  ASSERT_EQ(r.surface.number_of_faces(), moved.surface.number_of_faces());
  const double close = 1e-6 * k * extent(mesh);
  for (auto v : r.surface.vertices())
    ASSERT_LT(CGAL::squared_distance(t(r.surface.point(v)), moved.surface.point(v)), close * close);
}

// A tube 6 long and 2 wide, of whose side a finger is drawn out that ends blind: a cone 4 long.
Mesh tube_with_finger() {
  Tube tube;
  tube.length = 6;
  tube.rings = 40;
  tube.sides = 40;
  Mesh mesh = make_tube(tube);
  for (auto v : mesh.vertices()) {
    const Point p = mesh.point(v);
    const double d2 = p.y() * p.y() + (p.z() - 3) * (p.z() - 3);
    if (p.x() > 0 && d2 < 0.25)
      mesh.point(v) = Point(p.x() + 4 * std::min(1., 4 * (0.25 - d2)), p.y() * 0.9, p.z());
  }
  return mesh;
}

TEST(Tubular_model, Has_centerlines_in_blind_vessels) {
  const Mesh mesh = tube_with_finger();
  const Model with = tubular::make_tubular_model(mesh);
  EXPECT_EQ(with.centerlines.branches().size(), 3u);
  double furthest = 0;
  for (const Point& p : with.centerlines.points())
    furthest = std::max(furthest, p.x());
  EXPECT_GT(furthest, 3) << "the tip is at 5";
  const Model without = tubular::make_tubular_model(mesh, tubular::parameters::blind_vessels(false));
  EXPECT_EQ(without.centerlines.branches().size(), 1u);
}

// A blind vessel that the centerlines leave out shrinks to a spot in the plane, but must not be lost.
TEST(Remeshed_surface, Has_blind_vessels_without_centerline_too) {
  const Mesh mesh = tube_with_finger();
  tubular::Centerline_polylines line;
  line.lines.emplace_back();
  for (int i = 0; i <= 40; ++i) {
    line.lines[0].push_back(line.points.size());
    line.points.push_back(Point(0, 0, 6. * i / 40));
  }
  const Model model = tubular::make_tubular_model(mesh, line);
  const Remeshed r = tubular::make_isotropic_surface_mesh(
      model, tubular::parameters::points_per_circumference(24).max_size(0.15).preserve_volume(false));
  EXPECT_FALSE(PMP::does_self_intersect(r.surface));
  // The finger is a cone 4 long and 1 wide at its foot: what triangles of 0.15 may cut off is where it is narrower.
  EXPECT_LT(distance(model.surface, r.surface), 0.15 * 4);
  EXPECT_FALSE(r.report.problems.empty());
}

// Five sixths of a ring whose hole is narrower than the triangles: chords of its inner side would cross it.
TEST(Remeshed_surface, Does_not_close_gaps_narrower_than_its_triangles) {
  const int sides = 48, rings = 200;
  Mesh mesh;
  std::vector<std::vector<Mesh::Vertex_index>> ring(rings + 1);
  for (int k = 0; k <= rings; ++k) {
    const double turn = 5. / 3 * pi * k / rings;
    for (int i = 0; i < sides; ++i) {
      const double a = 2 * pi * i / sides, radius = 1.04 + std::cos(a);
      ring[std::size_t(k)].push_back(
          mesh.add_vertex(Point(radius * std::cos(turn), radius * std::sin(turn), std::sin(a))));
    }
  }
  for (std::size_t k = 0; k < std::size_t(rings); ++k)
    for (std::size_t i = 0; i < std::size_t(sides); ++i) {
      const std::size_t j = (i + 1) % std::size_t(sides);
      mesh.add_face(ring[k][i], ring[k + 1][j], ring[k][j]);
      mesh.add_face(ring[k][i], ring[k + 1][i], ring[k + 1][j]);
    }
  const Model model = tubular::make_tubular_model(mesh);
  const Remeshed r = remesh(model, 8);
  expect_good(model, r, 0.3, 0.9);
}

// What is done where triangles do cross: the piece, its curves and its neighbours are meshed again.
TEST(Remeshed_surface, Is_refined_piece_by_piece) {
  Model model = model_of(tubular::straight_tube(20, 1));
  const auto cut = tubular::cut_by_centerlines(model.surface, model.centerlines, model.patch);
  const auto maps = tubular::parameterize_patches(model.surface, cut);
  ASSERT_GE(maps.size(), 3u);
  const auto size = [](const Point&) { return 0.4; };
  const tubular::internal::Isotropic_sizes sizes(maps, size);
  tubular::internal::Triangle_piece_mesher mesher(model.surface, cut, maps, sizes, false, 1);
  mesher.mesh_all();
  const auto before = mesher.pieces();
  const auto curves_before = mesher.curve_points();
  mesher.mesh_finer({0});
  EXPECT_EQ(mesher.report().refined_patches, 1u);
  EXPECT_GT(mesher.pieces()[0].triangles.size(), 1.7 * double(before[0].triangles.size()));
  EXPECT_EQ(mesher.pieces()[2].triangles, before[2].triangles) << "not a neighbour";
  for (std::size_t c = 0; c < curves_before.size(); ++c) {
    const bool concerned = cut.curves[c].left_patch == 0 || cut.curves[c].right_patch == 0;
    EXPECT_EQ(mesher.curve_points()[c].size() > curves_before[c].size(), concerned);
  }
  for (const auto& piece : mesher.pieces()) { // as many corners as points on its curves and inside
    std::size_t points = piece.inner_points.size(), largest = 0;
    for (const auto& side : piece.sides)
      points += mesher.curve_points()[side.curve].size();
    for (const auto& t : piece.triangles)
      largest = std::max({largest, t[0], t[1], t[2]});
    EXPECT_EQ(largest + 1, points);
  }
}

TEST(Remeshed_surface, Needs_a_map_of_each_patch) {
  Model model = model_of(tubular::straight_tube(10, 1));
  const auto cut = tubular::cut_by_centerlines(model.surface, model.centerlines, model.patch);
  auto maps = tubular::parameterize_patches(model.surface, cut);
  maps.pop_back();
  EXPECT_THROW(tubular::remesh_patches(model.surface, cut, maps, [](const Point&) { return 0.3; }),
               tubular::Input_error);
}

// --- real vessels ---

#ifdef TUBULAR_MESHING_SHARED_DATA
void remesh_real(const std::string& name, bool loops, double points, double deviation) {
  const std::string file = std::string(TUBULAR_MESHING_SHARED_DATA) + "/" + name;
  if (!std::ifstream(file))
    GTEST_SKIP() << file << " is not there";
  Mesh mesh;
  tubular::IO::read_surface(file, mesh);
  tubular::repair_surface(mesh);
  const Model model = tubular::make_tubular_model(mesh, tubular::parameters::loops(loops));
  const Remeshed r = remesh(model, points);
  expect_good(model, r, 0.5, 0.95);
  EXPECT_LE(distance(model.surface, r.surface), deviation * extent(model.surface));
}

TEST(Remeshed_real, Aorta) { // 12,000 triangles, and the deviation that is wanted of it
  remesh_real("paper/aorta.stl", false, 34, 0.004);
}
TEST(Remeshed_real, Cylinder) {
  remesh_real("paper/cylemi.stl", false, 20, 0.01);
}
TEST(Remeshed_real, Bypass) {
  remesh_real("paper/bypass.stl", true, 16, 0.01);
}
TEST(Remeshed_real, Carotid) {
  remesh_real("paper/carotid.stl", false, 12, 0.01);
}
TEST(Remeshed_real, Cerebral) {
  remesh_real("paper/cerebral.stl", false, 12, 0.01);
}
TEST(Remeshed_real, Coarse_coronary) {
  remesh_real("trees/sofa_LCA.stl", false, 12, 0.01);
}
TEST(Remeshed_real, Noisy_carotids) {
  remesh_real("trees/sofa_carotids.stl", false, 12, 0.01);
}
TEST(Remeshed_real, Vessels_that_split_and_rejoin) {
  remesh_real("trees/sofa_phantom_network.obj", true, 12, 0.01);
}
#endif

} // namespace
