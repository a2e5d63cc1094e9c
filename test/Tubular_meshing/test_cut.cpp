// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_surfaces.h"

#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Centerlines/compute_centerlines.h>
#include <CGAL/Tubular_meshing/Generators/bronchial_tree.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Patches/cut_by_centerlines.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <gtest/gtest.h>

#include <algorithm>
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
typedef tubular::Centerline_graph Graph;
typedef tubular::Tubular_model Model;
typedef tubular::Surface_cut Cut;
typedef tubular::Cut_curve Curve;
typedef tubular::Surface_patch Patch;
typedef tubular::Patch_kind Kind;
typedef tubular::Cut_problem Problem;

// --- models ---

Model model_of(const tubular::Tubular_skeleton& skeleton, double points = 24, double noise = 0) {
  Mesh mesh;
  tubular::generate_tubular_surface(skeleton, mesh, tubular::parameters::points_per_circumference(points).noise(noise));
  return tubular::make_tubular_model(mesh, tubular::centerlines_of(skeleton));
}

// A tube along z, closed by caps, and its centerline.
Model tube_model(const Tube& tube) {
  tubular::Centerline_polylines line;
  line.lines.emplace_back();
  for (int i = 0; i <= 40; ++i) {
    line.lines[0].push_back(line.points.size());
    line.points.push_back(Point(0, 0, tube.length * i / 40));
  }
  return tubular::make_tubular_model(make_tube(tube), line);
}

// A surface that is all wall, with a graph of one polyline.
Model wall_model(const Mesh& mesh, const std::vector<Point>& points, const std::vector<std::size_t>& line) {
  Model model;
  model.surface += mesh;
  for (auto f : model.surface.faces())
    model.patch[f] = tubular::labels::wall;
  const tubular::Wall_distance wall(model.surface);
  std::vector<double> radii;
  for (const Point& p : points)
    radii.push_back(wall(p));
  model.centerlines = Graph(points, radii, {line});
  return model;
}

Model transformed(const Model& model, const Transformation& t) {
  Model result;
  result.surface += test_surfaces::transformed(model.surface, t);
  for (auto f : model.surface.faces())
    result.patch[f] = model.patch[f];
  std::vector<Point> points;
  std::vector<Graph::Polyline> branches;
  for (const Point& p : model.centerlines.points())
    points.push_back(t(p));
  for (const auto& b : model.centerlines.branches())
    branches.push_back(b.points);
  const double scale = std::sqrt((t(Point(1, 0, 0)) - t(Point(0, 0, 0))).squared_length());
  std::vector<double> radii = model.centerlines.radii();
  for (double& r : radii)
    r *= scale;
  result.centerlines = Graph(points, radii, branches);
  result.centerlines.direct_from(model.centerlines.root());
  return result;
}

Cut cut(Model& model, double aspect_ratio = 4) {
  return tubular::cut_by_centerlines(model.surface, model.centerlines, model.patch,
                                     tubular::parameters::aspect_ratio(aspect_ratio));
}

// --- an independent look at a cut ---

// Area over the square of the longest side.
double shape(const Mesh& mesh, Mesh::Face_index f) {
  const auto h = mesh.halfedge(f);
  const Point &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)),
              &c = mesh.point(mesh.target(mesh.next(h)));
  const double longest =
      std::max({CGAL::squared_distance(a, b), CGAL::squared_distance(b, c), CGAL::squared_distance(c, a)});
  return std::sqrt(CGAL::squared_area(a, b, c)) / longest;
}

double length_of(const Mesh& mesh, const Curve& curve) {
  double sum = 0;
  for (auto h : curve.halfedges)
    sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
  return sum;
}

double area_of(const Mesh& mesh, const Patch& patch) {
  double sum = 0;
  for (auto f : patch.faces)
    sum += CGAL::Polygon_mesh_processing::face_area(f, mesh);
  return sum;
}

// Of the closed subcomplex of a patch's faces: unlike the operator, which counts without the boundary.
int euler_characteristic(const Mesh& mesh, const Patch& patch) {
  std::set<Mesh::Vertex_index> vertices;
  std::set<Mesh::Edge_index> edges;
  for (auto f : patch.faces)
    for (auto h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      vertices.insert(mesh.target(h));
      edges.insert(mesh.edge(h));
    }
  return int(vertices.size()) - int(edges.size()) + int(patch.faces.size());
}

bool is_connected(const Mesh& mesh, const Cut& cut, std::size_t patch) {
  std::set<Mesh::Face_index> seen{cut.patches[patch].faces.front()};
  std::vector<Mesh::Face_index> stack(seen.begin(), seen.end());
  while (!stack.empty()) {
    const auto f = stack.back();
    stack.pop_back();
    for (auto h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      const auto g = mesh.face(mesh.opposite(h));
      if (cut.patch_of_face[g] == int(patch) && seen.insert(g).second)
        stack.push_back(g);
    }
  }
  return seen.size() == cut.patches[patch].faces.size();
}

void expect_curves_fit(const Model& model, const Cut& cut) {
  const Mesh& mesh = model.surface;
  std::set<Mesh::Vertex_index> on_curves;
  for (std::size_t i = 0; i < cut.curves.size(); ++i) {
    const Curve& c = cut.curves[i];
    ASSERT_GE(c.halfedges.size(), 3u);
    ASSERT_EQ(c.halfedges.size(), c.vertices.size());
    for (std::size_t k = 0; k < c.halfedges.size(); ++k) {
      const auto h = c.halfedges[k];
      EXPECT_EQ(mesh.source(h), c.vertices[k]);
      EXPECT_EQ(mesh.target(h), c.vertices[(k + 1) % c.vertices.size()]);
      EXPECT_EQ(cut.patch_of_face[mesh.face(h)], int(c.left_patch));
      const auto other = mesh.face(mesh.opposite(h));
      if (c.is_rim())
        EXPECT_EQ(model.patch[other], c.opening);
      else
        EXPECT_EQ(cut.patch_of_face[other], int(c.right_patch));
      EXPECT_TRUE(on_curves.insert(c.vertices[k]).second) << "curves touch";
    }
  }
}

void expect_patches_fit(const Model& model, const Cut& cut) {
  std::size_t faces = 0;
  for (auto f : model.surface.faces()) {
    const int p = cut.patch_of_face[f];
    EXPECT_EQ(p >= 0, model.patch[f] == tubular::labels::wall);
    EXPECT_LT(p, int(cut.patches.size()));
    faces += p >= 0;
  }
  for (std::size_t i = 0; i < cut.patches.size(); ++i) {
    const Patch& p = cut.patches[i];
    faces -= p.faces.size();
    EXPECT_EQ(p.euler_characteristic, euler_characteristic(model.surface, p));
    EXPECT_EQ(p.kind, p.loops.size() >= 3 ? Kind::junction : Kind(p.loops.size()));
    EXPECT_TRUE(is_connected(model.surface, cut, i));
    EXPECT_FALSE(p.branches.empty());
    for (const tubular::Patch_loop& l : p.loops) {
      const Curve& c = cut.curves[l.curve];
      EXPECT_EQ(l.forward ? c.left_patch : c.right_patch, i);
      EXPECT_EQ(l.forward ? c.right_patch : c.left_patch, l.neighbour);
    }
  }
  EXPECT_EQ(faces, 0u);
}

// The diameter is that of the round tube with the patch's area and loops: this does not look at the centerlines.
double measured_aspect_ratio(const Model& model, const Cut& cut, const Patch& patch) {
  double perimeter = 0;
  for (const tubular::Patch_loop& l : patch.loops)
    perimeter += length_of(model.surface, cut.curves[l.curve]) / double(patch.loops.size());
  return area_of(model.surface, patch) * CGAL_PI / (perimeter * perimeter);
}

void expect_good(const Model& model, const Cut& cut, double aspect_ratio = 4) {
  ASSERT_TRUE(CGAL::is_valid_polygon_mesh(model.surface) && CGAL::is_closed(model.surface) &&
              CGAL::is_triangle_mesh(model.surface));
  expect_curves_fit(model, cut);
  expect_patches_fit(model, cut);
  for (const Problem& p : cut.problems)
    ADD_FAILURE() << p.message();
  for (const Patch& p : cut.patches) {
    EXPECT_EQ(euler_characteristic(model.surface, p), 2 - int(p.loops.size()));
    EXPECT_LE(p.aspect_ratio(), aspect_ratio * (1 + 1e-9));
    for (const tubular::Patch_loop& l : p.loops)
      EXPECT_NE(cut.curves[l.curve].left_patch, cut.curves[l.curve].right_patch);
  }
}

std::map<Kind, std::size_t> kinds(const Cut& cut) {
  std::map<Kind, std::size_t> count;
  for (const Patch& p : cut.patches)
    ++count[p.kind];
  return count;
}

Point centroid(const Mesh& mesh, const Curve& curve) {
  Vector sum(0, 0, 0);
  for (auto v : curve.vertices)
    sum = sum + (mesh.point(v) - CGAL::ORIGIN);
  return CGAL::ORIGIN + sum / double(curve.vertices.size());
}

// How far a cut leaves its mean plane, and the angle between that and the branch, in radians.
struct Flatness {
  double off_plane = 0, angle = 0;
};

Vector branch_direction(const Graph& graph, std::size_t branch, double abscissa) {
  const auto& b = graph.branches()[branch];
  std::size_t i = 1;
  while (i + 1 < b.points.size() && b.abscissa[i] < abscissa)
    ++i;
  const std::size_t first = i > 3 ? i - 3 : 0, last = std::min(i + 2, b.points.size() - 1);
  const Vector d = graph.points()[b.points[last]] - graph.points()[b.points[first]];
  return d / std::sqrt(d.squared_length());
}

Flatness flatness(const Model& model, const Curve& curve) {
  const Point center = centroid(model.surface, curve);
  Vector normal(0, 0, 0);
  for (auto h : curve.halfedges)
    normal = normal + CGAL::cross_product(model.surface.point(model.surface.source(h)) - center,
                                          model.surface.point(model.surface.target(h)) - center);
  normal = normal / std::sqrt(normal.squared_length());
  Flatness result;
  for (auto v : curve.vertices)
    result.off_plane = std::max(result.off_plane, std::abs((model.surface.point(v) - center) * normal));
  result.angle =
      std::acos(std::min(1., std::abs(normal * branch_direction(model.centerlines, curve.branch, curve.abscissa))));
  return result;
}

// --- tubes ---

TEST(Cut, Leaves_a_short_tube_whole) {
  Model model = model_of(tubular::straight_tube(7.9, 1));
  const std::size_t faces = model.surface.number_of_faces();
  const Cut c = cut(model);
  expect_good(model, c);
  ASSERT_EQ(c.patches.size(), 1u);
  EXPECT_EQ(c.patches[0].kind, Kind::annular);
  EXPECT_EQ(model.surface.number_of_faces(), faces);
  EXPECT_NEAR(c.patches[0].aspect_ratio(), 3.95, 0.1);
}

TEST(Cut, Divides_a_tube_into_equal_parts) {
  Model model = model_of(tubular::straight_tube(20, 1));
  const Cut c = cut(model);
  expect_good(model, c);
  ASSERT_EQ(c.patches.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(c.patches[i].kind, Kind::annular);
    EXPECT_NEAR(c.patches[i].aspect_ratio(), 10. / 3, 0.5);
    EXPECT_NEAR(measured_aspect_ratio(model, c, c.patches[i]), 10. / 3, 0.5);
  }
  // numbered from the inlet, with cut 0 and 1 between, then the rims
  ASSERT_EQ(c.curves.size(), 4u);
  EXPECT_EQ(c.curves[0].left_patch, 0u);
  EXPECT_EQ(c.curves[0].right_patch, 1u);
  EXPECT_EQ(c.curves[1].left_patch, 1u);
  EXPECT_EQ(c.curves[1].right_patch, 2u);
  EXPECT_EQ(c.curves[2].opening, tubular::labels::inlet);
  EXPECT_EQ(c.curves[2].left_patch, 0u);
  EXPECT_EQ(c.curves[3].opening, tubular::labels::first_outlet);
  EXPECT_EQ(c.curves[3].left_patch, 2u);
  EXPECT_EQ(c.curves[3].branch, 0u);
  EXPECT_NEAR(c.curves[3].abscissa, 20, 1e-6);
}

TEST(Cut, Takes_the_aspect_ratio_wanted) {
  for (double wanted : {1., 2., 7.}) {
    Model model = model_of(tubular::straight_tube(20, 1));
    const Cut c = cut(model, wanted);
    expect_good(model, c, wanted);
    EXPECT_GE(c.patches.size(), std::size_t(std::ceil(10 / wanted)));
    EXPECT_LE(c.patches.size(), std::size_t(std::ceil(10 / (0.75 * wanted))));
  }
}

// Triangles as long as the tube, as CAD makes them: several disks go through each.
TEST(Cut, Cuts_triangles_more_than_once) {
  Tube tube;
  tube.rings = 1;
  tube.length = 40;
  tube.bottom = tube.top = End::fan;
  Model model = tube_model(tube);
  const Cut c = cut(model);
  expect_good(model, c);
  EXPECT_GE(c.patches.size(), 5u);
  EXPECT_LE(c.patches.size(), 7u);
  for (const Curve& curve : c.curves)
    if (!curve.is_rim()) {
      EXPECT_LT(flatness(model, curve).off_plane, 0.26);
    }
}

TEST(Cut, Leaves_a_blind_end_a_disk) {
  Tube tube;
  tube.length = 12;
  tube.rings = 40;
  tube.bottom = End::fan;
  tube.top = End::fine;
  std::vector<Point> points;
  std::vector<std::size_t> line;
  for (int i = 0; i <= 22; ++i) {
    line.push_back(points.size());
    points.push_back(Point(0, 0, 0.5 + 0.5 * i));
  }
  Model model = wall_model(make_tube(tube), points, line);
  const Cut c = cut(model);
  expect_good(model, c);
  EXPECT_EQ(kinds(c)[Kind::disk], 2u);
  EXPECT_EQ(c.patches.front().kind, Kind::disk);
  EXPECT_EQ(c.patches.back().kind, Kind::disk);
}

TEST(Cut, Opens_a_closed_centerline) {
  const int n = 60;
  std::vector<Point> points;
  std::vector<std::size_t> line;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * CGAL_PI * i / n;
    line.push_back(points.size());
    points.push_back(Point(3 * std::cos(a), 3 * std::sin(a), 0));
  }
  line.push_back(0);
  Model model = wall_model(make_torus(80, 24), points, line);
  const Cut c = cut(model);
  expect_good(model, c);
  EXPECT_GE(c.patches.size(), 3u);
  EXPECT_EQ(kinds(c)[Kind::annular], c.patches.size());
}

// An aneurysm on one side of a tube: it stays with its tube, and cuts keep off it.
TEST(Cut, Keeps_a_sac_with_its_tube) {
  Tube tube;
  tube.length = 16;
  tube.rings = 96;
  tube.sides = 40;
  tube.bottom = tube.top = End::fan;
  Mesh mesh = make_tube(tube);
  for (auto v : mesh.vertices()) {
    const Point p = mesh.point(v);
    const double along = (p.z() - 8) / 2, side = std::max(0., p.x());
    const double bulge = 1 + 2 * side * side * std::exp(-along * along * along * along);
    mesh.point(v) = Point(bulge * p.x(), bulge * p.y(), p.z());
  }
  tubular::Centerline_polylines lines;
  lines.lines.emplace_back();
  for (int i = 0; i <= 64; ++i) {
    lines.lines[0].push_back(lines.points.size());
    lines.points.push_back(Point(0, 0, 0.25 * i));
  }
  Model model = tubular::make_tubular_model(mesh, lines);
  const Cut c = cut(model, 4);
  expect_good(model, c, 4);
  EXPECT_EQ(kinds(c)[Kind::annular], c.patches.size());
  for (const Curve& curve : c.curves)
    EXPECT_LT(length_of(model.surface, curve), 1.5 * 2 * CGAL_PI) << "cut through the sac";
}

// --- trees ---

TEST(Cut, Parts_a_bifurcation_from_its_branches) {
  Model model = model_of(tubular::y_bifurcation());
  const Cut c = cut(model);
  expect_good(model, c);
  EXPECT_EQ(kinds(c)[Kind::junction], 1u);
  EXPECT_EQ(kinds(c)[Kind::annular] + 1, c.patches.size());
  EXPECT_TRUE(c.merged_branches.empty());
  EXPECT_EQ(c.moved_cuts, 0u);
  for (const Patch& p : c.patches)
    if (p.kind == Kind::junction) {
      EXPECT_EQ(p.loops.size(), 3u);
      EXPECT_EQ(p.branches.size(), 3u);
      EXPECT_LT(p.aspect_ratio(), 2.5); // near the junction
    }
}

TEST(Cut, Cuts_across_the_branches) {
  for (int i = 0; i < 3; ++i) {
    Model model = model_of(i == 0   ? tubular::y_bifurcation()
                           : i == 1 ? tubular::aortic_arch()
                                    : tubular::willis_loop());
    const Cut c = cut(model);
    expect_good(model, c);
    for (const Curve& curve : c.curves) {
      if (curve.is_rim())
        continue;
      const double radius = length_of(model.surface, curve) / (2 * CGAL_PI);
      const Flatness f = flatness(model, curve);
      EXPECT_LT(f.off_plane, 0.15 * radius);
      EXPECT_LT(f.angle, 0.3);
    }
  }
}

TEST(Cut, Numbers_patches_along_the_centerlines) {
  Model model = model_of(tubular::aortic_arch());
  const Cut c = cut(model);
  expect_good(model, c);
  EXPECT_EQ(kinds(c)[Kind::junction], 3u);
  const auto inlet = std::find_if(c.curves.begin(), c.curves.end(),
                                  [](const Curve& curve) { return curve.opening == tubular::labels::inlet; });
  ASSERT_NE(inlet, c.curves.end());
  EXPECT_EQ(inlet->left_patch, 0u);
  for (const Curve& curve : c.curves)
    if (!curve.is_rim()) {
      EXPECT_LT(curve.left_patch, curve.right_patch); // of a tree, directed away from the inlet
    }
}

TEST(Cut, Cuts_loops_of_vessels) {
  Model model = model_of(tubular::willis_loop());
  const Cut c = cut(model);
  expect_good(model, c);
  EXPECT_EQ(kinds(c)[Kind::junction], 7u);
}

TEST(Cut, Cuts_a_bronchial_tree) {
  Model model = model_of(tubular::bronchial_tree(63), 16);
  const Cut c = cut(model);
  expect_good(model, c);
  EXPECT_GE(kinds(c)[Kind::junction], 25u); // of 31 bifurcations, some of which may share a patch
  EXPECT_LE(c.merged_branches.size(), 3u);
}

TEST(Cut, Cuts_a_coarse_and_noisy_tree) {
  for (double points : {8., 12.})
    for (double noise : {0., 0.1}) {
      Model model = model_of(tubular::bronchial_tree(15), points, noise);
      const Cut c = cut(model);
      expect_good(model, c);
      EXPECT_GE(c.patches.size(), 15u);
    }
}

// --- what stays as it is ---

TEST(Cut, Keeps_the_shape) {
  Model model = model_of(tubular::aortic_arch(), 20, 0.05);
  const Mesh before = model.surface;
  double worst_before = 1, worst_new = 1;
  for (auto f : before.faces())
    worst_before = std::min(worst_before, shape(before, f));
  const Cut c = cut(model);
  for (auto v : before.vertices())
    EXPECT_EQ(before.point(v), model.surface.point(v));
  namespace PMP = CGAL::Polygon_mesh_processing;
  EXPECT_NEAR(PMP::area(model.surface), PMP::area(before), 1e-9 * PMP::area(before));
  EXPECT_NEAR(PMP::volume(model.surface), PMP::volume(before), 1e-9 * PMP::volume(before));
  for (auto f : model.surface.faces()) {
    if (std::size_t(f) < before.number_of_faces() && shape(before, f) == shape(model.surface, f))
      continue;
    worst_new = std::min(worst_new, shape(model.surface, f));
  }
  EXPECT_GT(worst_new, 0.15 * worst_before);
  EXPECT_GT(model.surface.number_of_faces(), before.number_of_faces());
}

TEST(Cut, Does_not_depend_on_unit_position_and_direction) {
  Model model = model_of(tubular::aortic_arch(), 20, 0.05);
  const Transformation moves[] = {Transformation(CGAL::SCALING, 1e-3), rotation(1),
                                  Transformation(CGAL::TRANSLATION, Vector(1e4, -2e4, 3e4)),
                                  rotation(2.2) * Transformation(CGAL::SCALING, 1e3)};
  std::vector<Model> moved;
  for (const Transformation& t : moves)
    moved.push_back(transformed(model, t));
  const Cut expected = cut(model);
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const Cut c = cut(moved[i]);
    expect_good(moved[i], c);
    ASSERT_EQ(c.curves.size(), expected.curves.size());
    for (std::size_t k = 0; k < c.curves.size(); ++k) {
      EXPECT_EQ(c.curves[k].left_patch, expected.curves[k].left_patch);
      const double scale = length_of(moved[i].surface, c.curves[k]) / length_of(model.surface, expected.curves[k]);
      const Point p = moves[i](centroid(model.surface, expected.curves[k]));
      EXPECT_LT(std::sqrt(CGAL::squared_distance(centroid(moved[i].surface, c.curves[k]), p)), 0.1 * scale);
    }
  }
}

TEST(Cut, Is_the_same_each_time) {
  Model a = model_of(tubular::willis_loop()), b = model_of(tubular::willis_loop());
  const Cut x = cut(a), y = cut(b);
  ASSERT_EQ(x.curves.size(), y.curves.size());
  for (std::size_t i = 0; i < x.curves.size(); ++i)
    EXPECT_EQ(x.curves[i].vertices, y.curves[i].vertices);
}

// --- what cannot be ---

// Two centerlines side by side in one tube: whatever disk is round one of them is round both.
TEST(Cut, Reports_what_cannot_be_cut) {
  Tube tube;
  tube.length = 40;
  tube.rings = 80;
  tube.bottom = tube.top = End::fan;
  Mesh mesh = make_tube(tube);
  Model model;
  model.surface += mesh;
  for (auto f : model.surface.faces())
    model.patch[f] = tubular::labels::wall;
  std::vector<Point> points;
  std::vector<double> radii;
  std::vector<Graph::Polyline> branches(2);
  for (int b = 0; b < 2; ++b)
    for (int i = 0; i < 40; ++i) {
      branches[b].push_back(points.size());
      points.push_back(Point(b == 0 ? -0.3 : 0.3, 0, 0.5 + i));
      radii.push_back(0.7);
    }
  model.centerlines = Graph(points, radii, branches);
  const Cut c = cut(model);
  expect_curves_fit(model, c);
  ASSERT_FALSE(c.is_valid());
  EXPECT_EQ(c.problems[0].kind, Problem::too_long);
  EXPECT_NE(c.problems[0].message().find("too long"), std::string::npos);
}

TEST(Cut, Reports_a_vessel_between_branches_without_centerline) {
  Model model = model_of(tubular::willis_loop());
  // the ring without one of its arcs: a tree
  std::vector<Graph::Polyline> branches;
  bool left_out = false;
  for (const auto& b : model.centerlines.branches()) {
    const auto& nodes = model.centerlines.nodes();
    if (!left_out && !nodes[b.source].is_end() && !nodes[b.target].is_end())
      left_out = true;
    else
      branches.push_back(b.points);
  }
  ASSERT_TRUE(left_out);
  model.centerlines = Graph(model.centerlines.points(), model.centerlines.radii(), branches);
  const Cut c = cut(model);
  ASSERT_FALSE(c.is_valid());
  EXPECT_TRUE(std::any_of(c.problems.begin(), c.problems.end(),
                          [](const Problem& p) { return p.kind == Problem::no_centerline; }));
}

// The third branch of a bifurcation closed at its end, and without a centerline; a seed there sets that right.
TEST(Cut, Reports_a_blind_vessel_without_centerline) {
  Model model = model_of(tubular::y_bifurcation());
  const Point end = model.openings.back().center;
  for (auto f : model.surface.faces())
    if (model.patch[f] == model.openings.back().patch)
      model.patch[f] = tubular::labels::wall;
  model.openings.pop_back();
  tubular::compute_centerlines(model.surface, model.patch, model.openings, model.centerlines);
  const Cut c = cut(model);
  ASSERT_EQ(c.problems.size(), 1u);
  EXPECT_EQ(c.problems[0].kind, Problem::no_centerline);
  EXPECT_LT(std::sqrt(CGAL::squared_distance(c.problems[0].point, end)), 1.5);
  EXPECT_EQ(model.patch[c.patches[c.problems[0].patch].faces.front()], tubular::labels::wall);
}

TEST(Cut, Refuses_unusable_input) {
  Model model = model_of(tubular::straight_tube());
  EXPECT_THROW(cut(model, 0.5), tubular::Parameter_error);
  EXPECT_THROW(cut(model, std::nan("")), tubular::Parameter_error);
  EXPECT_THROW(tubular::cut_by_centerlines(model.surface, Graph(), model.patch), tubular::Input_error);
  Mesh open = make_tube(Tube());
  auto patch = open.add_property_map<Mesh::Face_index, int>("f:patch", tubular::labels::wall).first;
  EXPECT_THROW(tubular::cut_by_centerlines(open, model.centerlines, patch), tubular::Input_error);
  for (auto f : model.surface.faces())
    model.patch[f] = tubular::labels::inlet;
  EXPECT_THROW(cut(model), tubular::Input_error);
  model.centerlines.set_radii(std::vector<double>(model.centerlines.points().size(), 0));
  EXPECT_THROW(cut(model), tubular::Input_error);
}

// --- real vessels ---

#ifdef TUBULAR_MESHING_SHARED_DATA
struct Real {
  const char* file;
  bool loops;
  std::size_t branches_at_least, merged_at_most;
};

void cut_real(const Real& real) {
  const std::string file = std::string(TUBULAR_MESHING_SHARED_DATA) + "/" + real.file;
  if (!std::ifstream(file))
    GTEST_SKIP() << file << " is not there";
  Mesh mesh;
  tubular::IO::read_surface(file, mesh);
  tubular::repair_surface(mesh);
  Model model = tubular::make_tubular_model(mesh, tubular::parameters::loops(real.loops));
  const Cut c = cut(model);
  expect_good(model, c);
  EXPECT_GE(c.patches.size(), real.branches_at_least);
  EXPECT_LE(c.merged_branches.size(), real.merged_at_most);
}

TEST(Cut_real, Aorta) {
  cut_real({"paper/aorta.stl", false, 5, 1});
}
TEST(Cut_real, Cylinder) {
  cut_real({"paper/cylemi.stl", false, 1, 0});
}
TEST(Cut_real, Coarse_coronary) {
  cut_real({"trees/sofa_LCA.stl", false, 10, 2});
}
TEST(Cut_real, Noisy_carotids) {
  cut_real({"trees/sofa_carotids.stl", false, 4, 0});
}
TEST(Cut_real, Vessels_that_split_and_rejoin) {
  cut_real({"trees/sofa_phantom_network.obj", true, 60, 0});
}
TEST(Cut_real, Bypass) {
  cut_real({"paper/bypass.stl", true, 6, 1});
}
#endif

} // namespace
