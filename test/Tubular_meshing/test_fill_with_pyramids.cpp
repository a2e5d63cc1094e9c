// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Pyramids and tetrahedra in boxes and tubes of quads, whose volume is known; quads that are warped, bent, or near to
// others; and surfaces that cannot be filled.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/Quality/shape_measures.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/base/cell_topology.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/Volume/fill_with_pyramids_and_tetrahedra.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
using tubular::internal::Vector_3d;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Surface;
typedef Surface::Vertex_index Vertex;
typedef tubular::Mixed_mesh Mesh;

class Fill_with_pyramids : public ::testing::Test {
protected:
  void SetUp() override {
    if (!tubular::has_tetgen() && !tubular::has_ccdt())
      GTEST_SKIP() << "built without TetGen, and with a CGAL before 6.1";
  }
};

struct Constant_size {
  double h;
  typedef double FT;
  template <class P, class Index> double operator()(const P&, int, const Index&) const { return h; }
};

struct Labelled_surface {
  Surface surface;
  Surface::Property_map<Surface::Face_index, int> patch;

  Labelled_surface() { patch = surface.add_property_map<Surface::Face_index, int>("f:patch", 0).first; }
  Labelled_surface(const Labelled_surface&) = delete;

  template <class... Vertices> void add(int label, Vertices... v) { patch[surface.add_face(v...)] = label; }
  void move(const std::function<Point(const Point&)>& f) {
    for (Vertex v : surface.vertices())
      surface.point(v) = f(surface.point(v));
  }
};

/* The box of (0,0,0) and (a,b,c), of quads of about side 1 / n: patch 1, but for z = 0, which is 2, and z = c, 3; these
 * are of triangles if `triangles_on_caps`. */
void make_box(Labelled_surface& s, double a, double b, double c, int n, bool triangles_on_caps = false) {
  const std::array<double, 3> size = {a, b, c};
  std::array<int, 3> m;
  for (int k = 0; k < 3; ++k)
    m[k] = std::max(1, int(std::lround(size[k] * n)));
  std::map<std::array<int, 3>, Vertex> at;
  const auto vertex = [&](const std::array<int, 3>& i) {
    auto found = at.find(i);
    if (found == at.end())
      found = at.emplace(i, s.surface.add_vertex(Point(a * i[0] / m[0], b * i[1] / m[1], c * i[2] / m[2]))).first;
    return found->second;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int end : {0, m[axis]}) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (int i = 0; i < m[u]; ++i)
        for (int j = 0; j < m[v]; ++j) {
          std::array<Vertex, 4> q;
          const int corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
          for (int k = 0; k < 4; ++k) {
            std::array<int, 3> p;
            p[axis] = end;
            p[u] = i + corners[end == 0 ? 3 - k : k][0];
            p[v] = j + corners[end == 0 ? 3 - k : k][1];
            q[k] = vertex(p);
          }
          const int label = axis < 2 ? 1 : end == 0 ? 2 : 3;
          if (label == 1 || !triangles_on_caps) {
            s.add(label, q[0], q[1], q[2], q[3]);
          } else {
            s.add(label, q[0], q[1], q[2]);
            s.add(label, q[0], q[2], q[3]);
          }
        }
    }
}

/* A tube of radius 1 along z with a wall of quads, `sides` of them round it, and caps of triangles. */
void make_tube(Labelled_surface& s, int sides, double length, double scale = 1, const Point& o = Point(0, 0, 0)) {
  const double side = 2 * std::sin(CGAL_PI / sides);
  const int rows = int(std::lround(length / side)), circles = std::max(1, int(std::lround(1 / side)));
  const auto ring = [&](double r, double z) {
    std::vector<Vertex> v;
    for (int i = 0; i < sides; ++i) {
      const double t = 2 * CGAL_PI * i / sides;
      v.push_back(s.surface.add_vertex(
          Point(o.x() + scale * r * std::cos(t), o.y() + scale * r * std::sin(t), o.z() + scale * z)));
    }
    return v;
  };
  std::vector<std::vector<Vertex>> rings;
  for (int k = 0; k <= rows; ++k)
    rings.push_back(ring(1, length * k / rows));
  for (int k = 0; k < rows; ++k)
    for (int i = 0; i < sides; ++i) {
      const int j = (i + 1) % sides;
      s.add(1, rings[k][i], rings[k][j], rings[k + 1][j], rings[k + 1][i]);
    }
  for (bool top : {false, true}) {
    const double z = top ? length : 0;
    const int label = top ? 3 : 2;
    const auto add = [&](Vertex a, Vertex b, Vertex c) { top ? s.add(label, a, b, c) : s.add(label, a, c, b); };
    std::vector<Vertex> outer = top ? rings.back() : rings.front();
    for (int c = circles - 1; c >= 1; --c) {
      const std::vector<Vertex> inner = ring(double(c) / circles, z);
      for (int i = 0; i < sides; ++i) {
        const int j = (i + 1) % sides;
        add(outer[i], outer[j], inner[j]);
        add(outer[i], inner[j], inner[i]);
      }
      outer = inner;
    }
    const Vertex center = s.surface.add_vertex(Point(o.x(), o.y(), o.z() + scale * z));
    for (int i = 0; i < sides; ++i)
      add(outer[i], outer[(i + 1) % sides], center);
  }
}

template <std::size_t N> double volume(const Mesh& m, const std::array<std::uint32_t, N>& c) {
  Vector_3d middle;
  for (std::uint32_t v : c)
    middle += (1. / N) * Vector_3d(m.points[v]);
  double sum = 0;
  const auto add = [&](const auto& face) {
    Vector_3d center;
    for (int k : face)
      center += (1. / double(face.size())) * Vector_3d(m.points[c[k]]);
    for (std::size_t k = 0; k < face.size(); ++k)
      sum += tubular::internal::signed_volume(Vector_3d(m.points[c[face[(k + 1) % face.size()]]]),
                                              Vector_3d(m.points[c[face[k]]]), center, middle);
  };
  for (const auto& f : tubular::internal::Cell_topology<N>::triangles())
    add(f);
  for (const auto& f : tubular::internal::Cell_topology<N>::quads())
    add(f);
  return sum;
}
double volume(const Mesh& m) {
  double sum = 0;
  for (const auto& c : m.tetrahedra.vertices)
    sum += volume(m, c);
  for (const auto& c : m.pyramids.vertices)
    sum += volume(m, c);
  return sum;
}

// Point for point and face for face; a pyramid on each quad; valid.
void expect_kept(const Labelled_surface& s, const Mesh& mesh) {
  ASSERT_GE(mesh.points.size(), s.surface.number_of_vertices());
  for (Vertex v : s.surface.vertices())
    for (int k = 0; k < 3; ++k)
      ASSERT_EQ(mesh.points[v.idx()][k], s.surface.point(v)[k]);
  std::size_t t = 0, q = 0;
  for (auto f : s.surface.faces()) {
    std::vector<std::uint32_t> face;
    for (Vertex v : vertices_around_face(s.surface.halfedge(f), s.surface))
      face.push_back(v.idx());
    if (face.size() == 3) {
      ASSERT_LT(t, mesh.triangles.size());
      ASSERT_TRUE(std::equal(face.begin(), face.end(), mesh.triangles.vertices[t].begin()));
      ASSERT_EQ(mesh.triangles.label[t++], s.patch[f]);
    } else {
      ASSERT_LT(q, mesh.quads.size());
      ASSERT_TRUE(std::equal(face.begin(), face.end(), mesh.quads.vertices[q].begin()));
      ASSERT_EQ(mesh.quads.label[q++], s.patch[f]);
    }
  }
  EXPECT_EQ(mesh.triangles.size(), t);
  EXPECT_EQ(mesh.quads.size(), q);
  ASSERT_EQ(mesh.pyramids.size(), q);
  for (std::size_t k = 0; k < q; ++k) {
    const auto& c = mesh.pyramids.vertices[k];
    EXPECT_EQ((std::set<std::uint32_t>(c.begin(), c.begin() + 4)),
              (std::set<std::uint32_t>(mesh.quads.vertices[k].begin(), mesh.quads.vertices[k].end())));
    EXPECT_EQ(c[4], s.surface.number_of_vertices() + k);
    EXPECT_EQ(mesh.pyramids.label[k], tubular::labels::lumen);
  }
  const auto report = tubular::validity_report(mesh);
  EXPECT_TRUE(report.is_valid()) << report.defects();
  EXPECT_EQ(report.boundary_euler, 2);
  EXPECT_EQ(mesh.region_names.at(tubular::labels::lumen), "lumen");
}

TEST_F(Fill_with_pyramids, Fills_a_box_of_quads) {
  Labelled_surface box;
  make_box(box, 1, 1, 1.5, 6);
  Mesh mesh;
  tubular::fill_with_pyramids_and_tetrahedra(box.surface, box.patch, Constant_size{1. / 6}, mesh);
  expect_kept(box, mesh);
  EXPECT_TRUE(mesh.triangles.empty());
  EXPECT_NEAR(volume(mesh), 1.5, 1e-12);
  const auto quality = tubular::quality_report(mesh);
  EXPECT_GT(quality.gamma_tau.min(), 0.2);
  EXPECT_GT(quality.gamma_tau.mean(), 0.7);
  EXPECT_GT(quality.pyramid_jacobian.min(), 0.3);
  EXPECT_LE(quality.pyramid_jacobian.max(), 1);
}

TEST_F(Fill_with_pyramids, Fills_a_single_cube) {
  Labelled_surface cube;
  make_box(cube, 1, 1, 1, 1);
  ASSERT_EQ(cube.surface.number_of_faces(), 6u);
  Mesh mesh;
  tubular::fill_with_pyramids_and_tetrahedra(cube.surface, cube.patch, Constant_size{1}, mesh);
  expect_kept(cube, mesh);
  EXPECT_NEAR(volume(mesh), 1, 1e-12);
}

// A prism of N sides: its volume is that of the polygon times its length.
TEST_F(Fill_with_pyramids, Fills_a_tube_with_caps_of_triangles_in_any_unit_and_place) {
  const int sides = 16;
  const double exact = 0.5 * sides * std::sin(2 * CGAL_PI / sides) * 5;
  std::size_t tetrahedra = 0;
  for (double scale : {1., 1e-6, 1e3})
    for (double away : {0., 1e4}) {
      Labelled_surface tube;
      make_tube(tube, sides, 5, scale, Point(away * scale, -away * scale, 2 * away * scale));
      Mesh mesh;
      tubular::fill_with_pyramids_and_tetrahedra(tube.surface, tube.patch, Constant_size{0.39 * scale}, mesh);
      expect_kept(tube, mesh);
      EXPECT_EQ(std::set<int>(mesh.triangles.label.begin(), mesh.triangles.label.end()), (std::set<int>{2, 3}));
      EXPECT_NEAR(volume(mesh) / (exact * scale * scale * scale), 1, away == 0 ? 1e-12 : 1e-7);
      const auto quality = tubular::quality_report(mesh);
      EXPECT_GT(quality.gamma_tau.min(), 0.2);
      EXPECT_GT(quality.gamma_tau.mean(), 0.68);
      EXPECT_GT(quality.pyramid_jacobian.min(), 0.3);
      if (tetrahedra == 0)
        tetrahedra = mesh.tetrahedra.size();
      EXPECT_NEAR(double(mesh.tetrahedra.size()) / double(tetrahedra), 1, 0.05);
    }
}

TEST_F(Fill_with_pyramids, Is_the_same_for_any_number_of_threads) {
  Labelled_surface tube;
  make_tube(tube, 16, 5);
  Mesh a, b;
  tubular::fill_with_pyramids_and_tetrahedra(tube.surface, tube.patch, Constant_size{0.4}, a,
                                             tubular::parameters::number_of_threads(1));
  tubular::fill_with_pyramids_and_tetrahedra(tube.surface, tube.patch, Constant_size{0.4}, b,
                                             tubular::parameters::number_of_threads(3));
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.tetrahedra.vertices, b.tetrahedra.vertices);
}

// The optimization moves apexes: it must not make the worst worse, and make the mean better.
TEST_F(Fill_with_pyramids, Optimization_makes_it_better) {
  Labelled_surface tube;
  make_tube(tube, 12, 6);
  Mesh before, after;
  tubular::fill_with_pyramids_and_tetrahedra(tube.surface, tube.patch, Constant_size{0.5}, before,
                                             tubular::parameters::optimization_passes(0));
  tubular::fill_with_pyramids_and_tetrahedra(tube.surface, tube.patch, Constant_size{0.5}, after);
  expect_kept(tube, before);
  const auto b = tubular::quality_report(before), a = tubular::quality_report(after);
  EXPECT_GT(a.gamma_tau.min(), b.gamma_tau.min());
  EXPECT_GT(a.gamma_tau.mean(), b.gamma_tau.mean());
}

// Corners of each quad leave its plane by a quarter of its side, to either side.
TEST_F(Fill_with_pyramids, Stands_on_warped_quads) {
  Labelled_surface box;
  make_box(box, 2, 2, 1, 4);
  box.move([](const Point& p) {
    const int i = int(std::lround(4 * p.x())), j = int(std::lround(4 * p.y()));
    return Point(p.x(), p.y(), p.z() + ((i + j) % 2 == 0 ? 1 : -1) * 0.0625);
  });
  Mesh mesh;
  tubular::fill_with_pyramids_and_tetrahedra(box.surface, box.patch, Constant_size{0.25}, mesh);
  expect_kept(box, mesh);
  EXPECT_NEAR(volume(mesh), 4, 1e-12); // top and bottom are warped alike
  EXPECT_GT(tubular::quality_report(mesh).gamma_tau.min(), 0.1);
}

// Walls nearer than a pyramid would be high: those opposite share the gap.
TEST_F(Fill_with_pyramids, Shares_narrow_gaps) {
  for (double gap : {0.5, 0.2, 0.05}) { // of the side of a quad
    Labelled_surface slab;
    make_box(slab, 2, 2, 0.25, 4);
    slab.move([gap](const Point& p) { return Point(p.x(), p.y(), p.z() * gap); });
    Mesh mesh;
    tubular::fill_with_pyramids_and_tetrahedra(slab.surface, slab.patch, Constant_size{0.25}, mesh);
    expect_kept(slab, mesh);
    EXPECT_NEAR(volume(mesh) / gap, 1, 1e-12);
    EXPECT_GT(tubular::quality_report(mesh).gamma_tau.min(), 0.1 * gap);
  }
}

// A wedge of 10 degrees: the pyramids on both of its sides meet at its edge.
TEST_F(Fill_with_pyramids, Lowers_the_pyramids_in_a_sharp_fold) {
  Labelled_surface wedge;
  make_box(wedge, 2, 1, 1, 4);
  wedge.move([](const Point& p) { return Point(p.x(), p.y(), (p.z() - 0.5) * (0.02 + 0.17 * p.x())); });
  Mesh mesh;
  tubular::fill_with_pyramids_and_tetrahedra(wedge.surface, wedge.patch, Constant_size{0.25}, mesh);
  expect_kept(wedge, mesh);
}

template <class Surface_> std::string error_of(const Surface_& s, bool split = false) {
  Mesh mesh;
  mesh.points.push_back(Point(1, 2, 3));
  try {
    tubular::fill_with_pyramids_and_tetrahedra(s.surface, s.patch, Constant_size{0.25}, mesh,
                                               tubular::parameters::split_quads(split));
  } catch (const tubular::Meshing_error& e) {
    EXPECT_EQ(mesh.points.size(), 1u) << "a mesh stays as it was where there is no other";
    return e.what();
  }
  return "";
}

TEST_F(Fill_with_pyramids, Names_a_quad_that_no_pyramid_fits_on_or_splits_it) {
  Labelled_surface box;
  make_box(box, 1, 1, 1, 4);
  box.move([](const Point& p) { // a corner inside the top comes to lie beyond the diagonal of one of its quads
    return p == Point(0.5, 0.5, 1) ? Point(0.64, 0.64, 1) : p;
  });
  const std::string sentence = error_of(box);
  EXPECT_NE(sentence.find("No pyramid fits on the quad at (0.66"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("180 degrees"), std::string::npos) << sentence;
  Mesh mesh;
  tubular::fill_with_pyramids_and_tetrahedra(box.surface, box.patch, Constant_size{0.25}, mesh,
                                             tubular::parameters::split_quads(true));
  const auto report = tubular::validity_report(mesh);
  EXPECT_TRUE(report.is_valid()) << report.defects();
  EXPECT_EQ(mesh.quads.size(), 95u);
  EXPECT_EQ(mesh.pyramids.size(), 95u);
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.triangles.label, (std::vector<int>{3, 3}));
  EXPECT_NEAR(volume(mesh), 1, 1e-12);
}

/* With two edges on the rim of a flat cap, the corner of a quad between them lies in the cap's plane, turned outward:
 * no pyramid is positive there. A drum of an octagon below, a square on top, and such quads and triangles between. */
TEST_F(Fill_with_pyramids, Splits_quads_bent_round_a_rim) {
  Labelled_surface drum;
  std::vector<Vertex> low, high;
  for (int i = 0; i < 8; ++i) {
    const double t = 2 * CGAL_PI * i / 8;
    low.push_back(drum.surface.add_vertex(Point(std::cos(t), std::sin(t), 0)));
    if (i % 2 == 1)
      high.push_back(drum.surface.add_vertex(Point(std::cos(t), std::sin(t), 0.8)));
  }
  const Vertex bottom = drum.surface.add_vertex(Point(0, 0, 0)), top = drum.surface.add_vertex(Point(0, 0, 0.8));
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    drum.add(1, low[2 * i], low[2 * i + 1], low[2 * j], high[i]);
    drum.add(1, low[2 * j], high[j], high[i]);
    drum.add(3, high[i], high[j], top);
    drum.add(2, low[2 * i + 1], low[2 * i], bottom);
    drum.add(2, low[2 * j], low[2 * i + 1], bottom);
  }
  const std::string sentence = error_of(drum);
  EXPECT_NE(sentence.find("and on 3 others"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("rim of an opening"), std::string::npos) << sentence;
  Mesh mesh;
  tubular::fill_with_pyramids_and_tetrahedra(drum.surface, drum.patch, Constant_size{0.7}, mesh,
                                             tubular::parameters::split_quads(true));
  const auto report = tubular::validity_report(mesh);
  EXPECT_TRUE(report.is_valid()) << report.defects();
  EXPECT_TRUE(mesh.quads.empty());
  EXPECT_EQ(mesh.triangles.size(), 24u);
}

TEST_F(Fill_with_pyramids, Says_where_a_surface_meets_itself) {
  Labelled_surface box;
  make_box(box, 1, 1, 1, 4);
  box.move([](const Point& p) { return p == Point(0.5, 0.5, 1) ? Point(0.5, 0.5, -0.5) : p; });
  const std::string sentence = error_of(box);
  EXPECT_NE(sentence.find("at ("), std::string::npos) << sentence;
  EXPECT_FALSE(error_of(box, true).empty());
}

TEST_F(Fill_with_pyramids, Refuses_what_is_no_closed_surface_of_triangles_and_quads) {
  Labelled_surface box;
  make_box(box, 1, 1, 1, 2);
  CGAL::Euler::remove_face(box.surface.halfedge(*box.surface.faces().begin()), box.surface);
  EXPECT_NE(error_of(box).find("closed"), std::string::npos);
  Labelled_surface none;
  EXPECT_NE(error_of(none).find("closed"), std::string::npos);
  Labelled_surface pentagons;
  make_box(pentagons, 1, 1, 1, 1);
  CGAL::Euler::split_edge(*pentagons.surface.halfedges().begin(), pentagons.surface);
  EXPECT_NE(error_of(pentagons).find("more than four edges"), std::string::npos);
}

TEST_F(Fill_with_pyramids, Fills_triangles_alone_as_well) {
  Labelled_surface tube;
  make_tube(tube, 12, 3);
  std::vector<Surface::Halfedge_index> quads;
  for (auto f : tube.surface.faces())
    if (tube.patch[f] == 1)
      quads.push_back(tube.surface.halfedge(f));
  for (auto h : quads)
    CGAL::Euler::split_face(h, tube.surface.next(tube.surface.next(h)), tube.surface);
  Mesh mesh;
  tubular::fill_with_pyramids_and_tetrahedra(tube.surface, tube.patch, Constant_size{0.5}, mesh);
  expect_kept(tube, mesh);
  EXPECT_TRUE(mesh.pyramids.empty());
}

TEST(Fill_without_mesher, Says_what_is_needed) {
  Labelled_surface box;
  make_box(box, 1, 1, 1, 2);
  Mesh mesh;
  try {
    tubular::fill_with_pyramids_and_tetrahedra(box.surface, box.patch, Constant_size{0.5}, mesh,
                                               tubular::parameters::volume_mesher(tubular::Volume_mesher::mesh_3));
    FAIL() << "Mesh_3 cannot keep the pyramids' sides";
  } catch (const tubular::Meshing_error& e) {
    EXPECT_NE(std::string(e.what()).find("libtet1.5-dev"), std::string::npos) << e.what();
  }
  for (auto mesher : {tubular::Volume_mesher::tetgen, tubular::Volume_mesher::ccdt}) {
    if (mesher == tubular::Volume_mesher::tetgen ? tubular::has_tetgen() : tubular::has_ccdt())
      continue;
    EXPECT_THROW(tubular::fill_with_pyramids_and_tetrahedra(box.surface, box.patch, Constant_size{0.5}, mesh,
                                                            tubular::parameters::volume_mesher(mesher)),
                 tubular::Meshing_error);
  }
}

TEST(Pyramid_jacobian, Is_that_of_known_pyramids) {
  const double h = std::sqrt(0.5);
  const auto jacobian = [](const Point& apex) {
    return tubular::pyramid_jacobian(
        std::array<Point, 5>{Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), apex});
  };
  EXPECT_NEAR(jacobian(Point(0.5, 0.5, h)), h, 1e-12);
  EXPECT_NEAR(jacobian(Point(0, 0, 1)), std::sqrt(1. / 3), 1e-12); // at the corner opposite
  EXPECT_EQ(jacobian(Point(0.5, 0.5, 0)), 0);
  EXPECT_LT(jacobian(Point(0.5, 0.5, -1)), 0);
}

} // namespace
