// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// TetGen on a cube and on tubes, whose volume and labels are known; and what happens when it fails.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/Volume/fill_keeping_boundary.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Filled_surface.h>
#include <CGAL/Tubular_meshing/Volume/optimize_tetrahedra.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include "schoenhardt.h"
#include "test_surfaces.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
using test_surfaces::Point;
using tubular::internal::Child_ending;
using tubular::internal::Vector_3d;
typedef CGAL::Surface_mesh<Point> Surface;
typedef Surface::Property_map<Surface::Face_index, int> Patch_map;
typedef tubular::Mixed_mesh Mesh;

#ifdef REAL
#error "TetGen's macros must not leak"
#endif

class Fill_with_tetgen : public ::testing::Test {
protected:
  void SetUp() override {
    if (!tubular::has_tetgen())
      GTEST_SKIP() << "built without TetGen";
  }
};

template <class Function> struct Size {
  Function function;
  typedef double FT;
  template <class P, class Index> double operator()(const P& p, int, const Index&) const { return function(p); }
};
template <class Function> Size<Function> size_field(const Function& f) {
  return {f};
}
auto constant_size(double h) {
  return size_field([h](const Point&) { return h; });
}

template <class SizingField>
void fill_with_tetgen(const Surface& surface, const Patch_map& patch, const SizingField& size, Mesh& mesh,
                      bool in_child_process = true) {
  tubular::fill_keeping_boundary(
      surface, patch, size, mesh,
      tubular::parameters::volume_mesher(tubular::Volume_mesher::tetgen).in_child_process(in_child_process));
}

Patch_map no_patch(Surface& surface) {
  return surface.add_property_map<Surface::Face_index, int>("f:patch", tubular::labels::wall).first;
}

/* A tube of radius 1 along z, bent and not quite round, for a symmetric one has points on a common sphere everywhere,
 * where rounding decides how they are connected; with triangles that are nearly equilateral: rows of an even number of
 * sides, each turned by half a side, and flat caps of concentric circles. Patches 1 (wall), 2 (z = 0) and 3 (top). */
struct Labelled_tube {
  Surface surface;
  Patch_map patch;

  explicit Labelled_tube(int sides = 24, double length = 4, double scale = 1, const Point& origin = Point(0, 0, 0)) {
    const double side = 2 * CGAL_PI / sides;
    const int rows = int(std::lround(length / (side * std::sqrt(0.75))));
    std::vector<std::vector<Surface::Vertex_index>> ring(rows + 1);
    const auto add = [&](double x, double y, double z) {
      const double bent_x = 1.07 * x + 0.06 * y + 0.03 * z * z, bent_y = y + 0.1 * std::sin(z + x);
      return surface.add_vertex(
          Point(origin.x() + scale * bent_x, origin.y() + scale * bent_y, origin.z() + scale * z));
    };
    for (int k = 0; k <= rows; ++k)
      for (int i = 0; i < sides; ++i) {
        const double angle = side * (i + 0.5 * (k % 2));
        ring[k].push_back(add(std::cos(angle), std::sin(angle), length * k / rows));
      }
    patch = surface.add_property_map<Surface::Face_index, int>("f:patch", 0).first;
    for (int k = 0; k < rows; ++k)
      for (int i = 0; i < sides; ++i) {
        const int j = (i + 1) % sides;
        const auto &low = ring[k], &high = ring[k + 1];
        if (k % 2 == 0) {
          label(surface.add_face(low[i], low[j], high[i]), 1);
          label(surface.add_face(low[j], high[j], high[i]), 1);
        } else {
          label(surface.add_face(low[i], high[j], high[i]), 1);
          label(surface.add_face(low[i], low[j], high[j]), 1);
        }
      }
    cap(ring.front(), side, 0, true, 2, add);
    cap(ring.back(), side, length, false, 3, add);
  }

private:
  void label(Surface::Face_index f, int l) {
    ASSERT_NE(f, Surface::null_face());
    patch[f] = l;
  }

  // Circles of fewer and fewer vertices, sewn two by two.
  template <class Add>
  void cap(std::vector<Surface::Vertex_index> outer, double side, double z, bool bottom, int l, const Add& add) {
    const int circles = int(std::lround(1 / side));
    const auto face = [&](Surface::Vertex_index a, Surface::Vertex_index b, Surface::Vertex_index c) {
      label(bottom ? surface.add_face(a, c, b) : surface.add_face(a, b, c), l);
    };
    double outer_turn = 0.5 * side * ((bottom ? 0 : 1) * (std::lround(z / (side * std::sqrt(0.75))) % 2));
    for (int c = circles - 1; c >= 1; --c) {
      const double radius = double(c) / circles;
      const int n = std::max(5, int(std::lround(2 * CGAL_PI * radius / side)));
      std::vector<Surface::Vertex_index> inner;
      for (int i = 0; i < n; ++i)
        inner.push_back(add(radius * std::cos(outer_turn + 2 * CGAL_PI * i / n),
                            radius * std::sin(outer_turn + 2 * CGAL_PI * i / n), z));
      const int m = int(outer.size());
      for (int i = 0, j = 0; i < m || j < n;)
        if (j == n || (i < m && double(i + 0.5) / m <= double(j + 0.5) / n)) {
          face(outer[i % m], outer[(i + 1) % m], inner[j % n]);
          ++i;
        } else {
          face(outer[i % m], inner[(j + 1) % n], inner[j % n]);
          ++j;
        }
      outer = inner;
    }
    const auto center = add(0, 0, z);
    for (std::size_t i = 0; i < outer.size(); ++i)
      face(outer[i], outer[(i + 1) % outer.size()], center);
  }
};

double volume(const Mesh& m) {
  double v = 0;
  for (const auto& t : m.tetrahedra.vertices)
    v += tubular::internal::signed_volume(Vector_3d(m.points[t[0]]), Vector_3d(m.points[t[1]]),
                                          Vector_3d(m.points[t[2]]), Vector_3d(m.points[t[3]]));
  return v;
}

double enclosed_volume(const Surface& s) {
  const Vector_3d origin(s.point(*s.vertices().begin()));
  double v = 0;
  for (auto f : s.faces()) {
    std::vector<Vector_3d> p;
    for (auto u : vertices_around_face(s.halfedge(f), s))
      p.push_back(Vector_3d(s.point(u)));
    v += tubular::internal::signed_volume(p[2], p[1], p[0], origin);
  }
  return v;
}

// Point for point, triangle for triangle, label for label, bit for bit.
void expect_kept(const Surface& surface, const Patch_map& patch, const Mesh& mesh) {
  ASSERT_GE(mesh.points.size(), surface.number_of_vertices());
  for (auto v : surface.vertices())
    for (int k = 0; k < 3; ++k)
      ASSERT_EQ(mesh.points[v.idx()][k], surface.point(v)[k]);
  ASSERT_EQ(mesh.triangles.size(), surface.number_of_faces());
  for (auto f : surface.faces()) {
    int k = 0;
    for (auto v : vertices_around_face(surface.halfedge(f), surface))
      ASSERT_EQ(mesh.triangles.vertices[f.idx()][k++], v.idx());
    ASSERT_EQ(mesh.triangles.label[f.idx()], patch[f]);
  }
  const auto report = tubular::validity_report(mesh);
  EXPECT_TRUE(report.is_valid()) << report.defects();
}

TEST_F(Fill_with_tetgen, Keeps_the_surface_bit_for_bit) {
  const Labelled_tube tube(24, 4, 1, Point(0.1, -7.7, 1000.3));
  Mesh mesh;
  fill_with_tetgen(tube.surface, tube.patch, constant_size(2 * CGAL_PI / 24), mesh);
  expect_kept(tube.surface, tube.patch, mesh);
  EXPECT_GT(mesh.points.size(), tube.surface.number_of_vertices() + 100);
  EXPECT_NEAR(volume(mesh), enclosed_volume(tube.surface), 1e-9);
  EXPECT_EQ(std::set<int>(mesh.tetrahedra.label.begin(), mesh.tetrahedra.label.end()),
            std::set<int>{tubular::labels::lumen});
  EXPECT_EQ(mesh.region_names.at(tubular::labels::lumen), "lumen");
}

// A cap's coplanar triangles could be taken for one polygon, and be triangulated otherwise.
TEST_F(Fill_with_tetgen, Keeps_planar_patches_triangle_by_triangle) {
  Surface cube = test_surfaces::make_square_duct();
  const Patch_map patch = no_patch(cube);
  Mesh mesh;
  fill_with_tetgen(cube, patch, constant_size(0.5), mesh);
  expect_kept(cube, patch, mesh);
  EXPECT_NEAR(volume(mesh), enclosed_volume(cube), 1e-9);
}

TEST_F(Fill_with_tetgen, Sizes_follow_a_graded_field) {
  // coarse at one end, fine at the other, inside a surface that is fine everywhere
  const Labelled_tube tube(40, 4);
  const double side = 2 * CGAL_PI / 40;
  const auto h = [side](const Point& p) { return side * (1 + 0.5 * std::min(1., std::max(0., p.z() - 1) / 2)); };
  Mesh mesh;
  fill_with_tetgen(tube.surface, tube.patch, size_field(h), mesh);
  const std::uint32_t boundary = std::uint32_t(tube.surface.number_of_vertices());
  double sum[2] = {0, 0};
  std::size_t count[2] = {0, 0};
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
  for (const auto& t : mesh.tetrahedra.vertices)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j) {
        const auto edge = std::minmax(t[i], t[j]);
        if (edge.first < boundary || !seen.insert(edge).second)
          continue;
        const Point &p = mesh.points[t[i]], &q = mesh.points[t[j]], middle = CGAL::midpoint(p, q);
        const int zone = middle.z() < 1 ? 0 : middle.z() > 3 ? 1 : -1;
        if (zone < 0)
          continue;
        sum[zone] += std::sqrt(CGAL::squared_distance(p, q)) / h(middle);
        ++count[zone];
      }
  for (int zone = 0; zone < 2; ++zone) {
    EXPECT_GT(count[zone], 300u);
    EXPECT_NEAR(sum[zone] / double(count[zone]), 1.05, 0.12) << "zone " << zone;
  }
}

TEST_F(Fill_with_tetgen, Is_good_after_optimization) {
  const Labelled_tube tube(24, 6);
  Mesh mesh;
  fill_with_tetgen(tube.surface, tube.patch, constant_size(2 * CGAL_PI / 24), mesh);
  const auto before = tubular::quality_report(mesh).gamma_tau;
  tubular::optimize_tetrahedra(mesh, tube.surface, tube.patch, tubular::parameters::keep_boundary(true));
  expect_kept(tube.surface, tube.patch, mesh);
  EXPECT_NEAR(volume(mesh), enclosed_volume(tube.surface), 1e-9);
  const auto after = tubular::quality_report(mesh).gamma_tau;
  EXPECT_GT(after.min(), 0.3);
  EXPECT_GT(after.mean(), 0.73);
  EXPECT_GT(after.mean(), before.mean());
}

TEST_F(Fill_with_tetgen, Is_the_same_in_any_unit_and_far_from_the_origin) {
  Mesh unit;
  const double side = 2 * CGAL_PI / 16;
  {
    const Labelled_tube tube(16, 3);
    fill_with_tetgen(tube.surface, tube.patch, constant_size(side), unit);
  }
  for (double scale : {1e-3, 1e6, 1e-9})
    for (double away : {0., 1e4}) {
      const Labelled_tube tube(16, 3, scale, Point(away * scale, -2 * away * scale, 3 * away * scale));
      Mesh mesh;
      fill_with_tetgen(tube.surface, tube.patch, constant_size(side * scale), mesh);
      expect_kept(tube.surface, tube.patch, mesh);
      EXPECT_NEAR(volume(mesh) / enclosed_volume(tube.surface), 1, 1e-6);
      EXPECT_NEAR(double(mesh.tetrahedra.size()) / double(unit.tetrahedra.size()), 1, 0.05);
    }
}

TEST_F(Fill_with_tetgen, Is_the_same_each_time) {
  const Labelled_tube tube;
  Mesh a, b;
  fill_with_tetgen(tube.surface, tube.patch, constant_size(0.3), a);
  fill_with_tetgen(tube.surface, tube.patch, constant_size(0.3), b);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.tetrahedra.vertices, b.tetrahedra.vertices);
}

TEST_F(Fill_with_tetgen, Is_the_same_in_this_process_and_in_one_of_its_own) {
  const Labelled_tube tube;
  Mesh inside, outside;
  fill_with_tetgen(tube.surface, tube.patch, constant_size(0.3), inside, false);
  fill_with_tetgen(tube.surface, tube.patch, constant_size(0.3), outside, true);
  EXPECT_EQ(inside.points, outside.points);
  EXPECT_EQ(inside.tetrahedra.vertices, outside.tetrahedra.vertices);
}

// TetGen's predicates have global constants that depend on the model.
TEST_F(Fill_with_tetgen, Is_the_same_in_several_threads_of_this_process) {
  const Labelled_tube large, small(16, 3);
  std::vector<Mesh> meshes(6);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < meshes.size(); ++i)
    threads.emplace_back([&, i] {
      const Labelled_tube& tube = i % 2 == 0 ? large : small;
      fill_with_tetgen(tube.surface, tube.patch, constant_size(0.4), meshes[i], false);
    });
  for (std::thread& t : threads)
    t.join();
  for (std::size_t i = 2; i < meshes.size(); ++i)
    EXPECT_EQ(meshes[i].tetrahedra.vertices, meshes[i - 2].tetrahedra.vertices);
}

TEST_F(Fill_with_tetgen, Works_beside_threads_that_allocate) {
  const Labelled_tube tube(16, 3);
  tubular::internal::for_each_range(10000, 0, [](std::size_t, std::size_t) {}); // the workers of oneTBB are there now
  std::atomic<bool> stop(false);
  std::vector<std::thread> threads;
  for (int i = 0; i < 3; ++i)
    threads.emplace_back([&] {
      while (!stop)
        std::vector<std::unique_ptr<int>>(1000).resize(2000);
    });
  for (int run = 0; run < 20; ++run) {
    Mesh mesh;
    fill_with_tetgen(tube.surface, tube.patch, constant_size(0.5), mesh);
    EXPECT_FALSE(mesh.tetrahedra.empty());
  }
  stop = true;
  for (std::thread& t : threads)
    t.join();
}

std::string error_of(const Surface& surface, const Patch_map& patch) {
  Mesh mesh;
  mesh.points.push_back(Point(1, 2, 3));
  try {
    fill_with_tetgen(surface, patch, constant_size(0.3), mesh);
  } catch (const tubular::Meshing_error& e) {
    EXPECT_EQ(mesh.points.size(), 1u) << "a mesh stays as it was where there is no other";
    return e.what();
  }
  return "";
}

TEST_F(Fill_with_tetgen, Says_where_a_surface_crosses_itself) {
  Labelled_tube tube;
  for (auto v : tube.surface.vertices()) { // the bottom's middle comes out through the wall
    const Point& p = tube.surface.point(v);
    if (p.z() == 0 && CGAL::square(p.x()) + CGAL::square(p.y()) < 0.01)
      tube.surface.point(v) = Point(2, 0, 2);
  }
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const std::string sentence = error_of(tube.surface, tube.patch);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_NE(sentence.find("crosses itself at "), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("the first at ("), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("fill_with_mesh_3()"), std::string::npos) << sentence;
}

TEST_F(Fill_with_tetgen, Refuses_an_open_surface) {
  Labelled_tube tube;
  CGAL::Euler::remove_face(tube.surface.halfedge(*tube.surface.faces().begin()), tube.surface);
  EXPECT_NE(error_of(tube.surface, tube.patch).find("closed"), std::string::npos);
  Surface none;
  const Patch_map patch = no_patch(none);
  EXPECT_NE(error_of(none, patch).find("closed"), std::string::npos);
}

TEST_F(Fill_with_tetgen, Says_in_this_process_as_well_where_a_surface_crosses_itself) {
  Labelled_tube tube;
  for (auto v : tube.surface.vertices())
    if (tube.surface.point(v).z() == 0 && std::hypot(tube.surface.point(v).x(), tube.surface.point(v).y()) < 0.1)
      tube.surface.point(v) = Point(2, 0, 2);
  Mesh mesh;
  try {
    fill_with_tetgen(tube.surface, tube.patch, constant_size(0.3), mesh, false);
    FAIL() << "it crosses itself";
  } catch (const tubular::Meshing_error& e) {
    EXPECT_NE(std::string(e.what()).find("crosses itself at "), std::string::npos) << e.what();
  }
}

TEST(Fill_keeping_boundary, Refuses_quads) {
  if (!tubular::has_tetgen() && !tubular::has_ccdt())
    GTEST_SKIP() << "built without TetGen, and with a CGAL before 6.1";
  Surface cube = test_surfaces::make_square_duct();
  CGAL::Euler::join_face(*cube.halfedges().begin(), cube);
  const Patch_map patch = no_patch(cube);
  Mesh mesh;
  EXPECT_THROW(tubular::fill_keeping_boundary(cube, patch, constant_size(0.5), mesh), tubular::Input_error);
}

TEST(Fill_keeping_boundary, Needs_a_mesher_that_keeps_it) {
  Surface cube = test_surfaces::make_square_duct();
  const Patch_map patch = no_patch(cube);
  Mesh mesh;
  EXPECT_THROW(tubular::fill_keeping_boundary(cube, patch, constant_size(0.5), mesh,
                                              tubular::parameters::volume_mesher(tubular::Volume_mesher::mesh_3)),
               tubular::Meshing_error);
}

TEST(Fill_without_tetgen, Says_so) {
  if (tubular::has_tetgen())
    GTEST_SKIP() << "built with TetGen";
  const Labelled_tube tube;
  EXPECT_NE(error_of(tube.surface, tube.patch).find("without TetGen"), std::string::npos);
}

// --- what may happen in the child process, with other work than TetGen's ---

template <class Work> Child_ending ending_of(const Work& work, double seconds = 60) {
  std::vector<int> values;
  return tubular::internal::run_in_child_process(
      work, [&](const tubular::internal::Pipe_reader& pipe) { return pipe.read(values); }, seconds);
}
typedef const tubular::internal::Pipe_writer& Pipe;

TEST(Child_process, Sends_its_result_how_large_it_may_be) {
  std::vector<int> sent(3000000), got;
  for (std::size_t i = 0; i < sent.size(); ++i)
    sent[i] = int(7 * i);
  const Child_ending ending = tubular::internal::run_in_child_process(
      [&](Pipe pipe) { return pipe.write(sent) ? 0 : 1; },
      [&](const tubular::internal::Pipe_reader& pipe) { return pipe.read(got); }, 60);
  EXPECT_EQ(ending.kind, Child_ending::done);
  EXPECT_EQ(got, sent);
}

TEST(Child_process, Tells_how_it_ended) {
  for (int signal : {SIGSEGV, SIGABRT, SIGKILL}) {
    const Child_ending e = ending_of([signal](Pipe) { return std::raise(signal); });
    EXPECT_EQ(e.kind, Child_ending::killed);
    EXPECT_EQ(e.code, signal);
  }
  const Child_ending gave_up = ending_of([](Pipe) { return 3; });
  EXPECT_EQ(gave_up.kind, Child_ending::gave_up);
  EXPECT_EQ(gave_up.code, 3);
  const Child_ending left = ending_of([](Pipe) -> int { _exit(5); });
  EXPECT_EQ(left.kind, Child_ending::gave_up);
  EXPECT_EQ(left.code, 5);
  const Child_ending memory = ending_of([](Pipe) -> int { throw std::bad_alloc(); });
  EXPECT_EQ(memory.code, tubular::internal::out_of_memory_code);
  const Child_ending thrown = ending_of([](Pipe) -> int { throw 1.5; });
  EXPECT_EQ(thrown.kind, Child_ending::gave_up);
  const Child_ending quiet = ending_of([](Pipe) { return 0; }); // but nothing was sent
  EXPECT_EQ(quiet.kind, Child_ending::gave_up);
}

TEST(Child_process, Is_stopped_when_its_time_is_up) {
  const Child_ending e = ending_of(
      [](Pipe) {
        for (volatile unsigned i = 0;;)
          i = i + 1;
        return 0;
      },
      0.1);
  EXPECT_EQ(e.kind, Child_ending::killed);
  EXPECT_EQ(e.code, SIGXCPU);
}

TEST(Child_process, Prints_nothing) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  std::printf("before ");
  ending_of([](Pipe) {
    std::printf("child\n");
    std::fprintf(stderr, "child\n");
    std::fflush(nullptr);
    return 0;
  });
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "before ");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

using tubular::internal::Boundary_arrays;
using tubular::internal::Recovered_boundary;

template <class Recovery> std::string sentence_of(const Recovery& recover, bool in_child_process = true) {
  Surface surface; // one whose triangles are not facets of the Delaunay triangulation of its points
  const Boundary_arrays boundary = test_surfaces::schoenhardt();
  for (const Vector_3d& p : boundary.points)
    surface.add_vertex(Point(p.x, p.y, p.z));
  for (const auto& t : boundary.triangles)
    surface.add_face(Surface::Vertex_index(t[0]), Surface::Vertex_index(t[1]), Surface::Vertex_index(t[2]));
  const Patch_map patch = surface.add_property_map<Surface::Face_index, int>("f:patch", 1).first;
  tubular::Fill_keeping_boundary_options options;
  options.in_child_process = in_child_process;
  options.time_limit = 60;
  const tubular::internal::Filling_limits limits(options, surface, "use fill_with_mesh_3()");
  tubular::internal::Filled_surface filling;
  const auto failure = filling.fill(
      surface, patch, [](const Point&) { return 0.5; }, {recover, "Some mesher"}, limits);
  return failure ? failure->str() : std::string();
}

TEST(Fill_keeping_boundary, Explains_whatever_happens) {
  const auto ends_by = [](int code, int signal) {
    return sentence_of([=](const Boundary_arrays&, Recovered_boundary&) {
      if (signal != 0)
        std::raise(signal);
      return code;
    });
  };
  const std::vector<std::pair<std::string, std::string>> expected = {{ends_by(0, SIGSEGV), "crashed (signal 11)"},
                                                                     {ends_by(0, SIGKILL), "not enough memory"},
                                                                     {ends_by(1, 0), "not enough memory"},
                                                                     {ends_by(2, 0), "an error of its own"},
                                                                     {ends_by(3, 0), "cross or overlap"},
                                                                     {ends_by(4, 0), "too small"},
                                                                     {ends_by(5, 0), "too close"},
                                                                     {ends_by(10, 0), "input"},
                                                                     {ends_by(77, 0), "code 77"}};
  for (const auto& e : expected) {
    EXPECT_EQ(e.first.find("Some mesher could not"), 0u) << e.first;
    EXPECT_NE(e.first.find(e.second), std::string::npos) << e.first;
    EXPECT_NE(e.first.find("fill_with_mesh_3()"), std::string::npos) << e.first;
  }
}

TEST(Fill_keeping_boundary, Explains_in_this_process_what_can_be_explained) {
  const auto gives_up = [](const Boundary_arrays&, Recovered_boundary&) { return 5; };
  const auto runs_out_of_memory = [](const Boundary_arrays&, Recovered_boundary&) -> int { throw std::bad_alloc(); };
  EXPECT_NE(sentence_of(gives_up, false).find("too close"), std::string::npos);
  EXPECT_NE(sentence_of(runs_out_of_memory, false).find("not enough memory"), std::string::npos);
}

TEST_F(Fill_with_tetgen, Refuses_more_points_than_memory_holds) {
  const Labelled_tube tube(12, 2);
  tubular::internal::Filling_limits limits({}, tube.surface, "");
  limits.most_points = 5;
  tubular::internal::Filled_surface filling;
  const auto failure = filling.fill(
      tube.surface, tube.patch, [](const Point&) { return 0.2; }, tubular::internal::tetgen_recovery(), limits);
  ASSERT_TRUE(failure);
  EXPECT_NE(failure->str().find("more than 5 points"), std::string::npos) << failure->str();
}

TEST(Fill_keeping_boundary, Refuses_a_filling_that_does_not_keep_the_surface) {
  const std::string sentence = sentence_of([](const Boundary_arrays&, Recovered_boundary& recovered) {
    recovered.tetrahedra.push_back({0, 1, 2, 3});
    return 0;
  });
  EXPECT_NE(sentence.find("Some mesher could not keep this surface"), std::string::npos) << sentence;
}

// A cube as a fan of tetrahedra around its middle.
Mesh fan_in_a_cube(double side) {
  Mesh m;
  for (int i = 0; i < 8; ++i)
    m.points.push_back(Point(side * (i & 1), side * ((i >> 1) & 1), side * (i >> 2)));
  m.points.push_back(Point(side / 2, side / 2, side / 2));
  for (auto q :
       {std::array<std::uint32_t, 4>{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
    for (int k : {1, 2}) {
      m.triangles.push_back({q[0], q[k], q[k + 1]}, 1);
      m.tetrahedra.push_back({8, q[0], q[k], q[k + 1]}, 1);
    }
  return m;
}

// Whether there was room for all.
template <class Size> bool add_points_inside(const Size& size, std::size_t most, int threads, Mesh& mesh) {
  tubular::internal::Tetrahedron_store store(mesh, threads);
  tubular::internal::Delaunay_refinement refine(store, size, tubular::internal::Filled_surface::radius_bound, threads);
  const bool is_done = refine(most) < most;
  store.write_inside_to(mesh);
  return is_done;
}

TEST(Delaunay_refinement, Fills_a_cube_and_keeps_its_boundary) {
  for (double side : {1., 1e-7}) {
    Mesh mesh = fan_in_a_cube(side);
    const Mesh before = mesh;
    // not below the size of the boundary's triangles by much: points too near to those are not added
    ASSERT_TRUE(add_points_inside([side](const Point&) { return 0.25 * side; }, 100000, 1, mesh));
    const auto report = tubular::validity_report(mesh);
    EXPECT_TRUE(report.is_valid()) << report.defects();
    EXPECT_NEAR(volume(mesh) / (side * side * side), 1, 1e-12);
    EXPECT_EQ(mesh.triangles.vertices, before.triangles.vertices);
    EXPECT_GT(mesh.points.size(), 15u);
    for (int i = 0; i < 8; ++i)
      EXPECT_EQ(mesh.points[i], before.points[i]);
  }
}

TEST(Delaunay_refinement, Gives_the_same_mesh_on_any_number_of_threads) {
  // small near one corner, so that batches get in their own way there
  const auto size = [](const Point& p) { return 0.03 + 0.1 * (p.x() + p.y() + p.z()); };
  Mesh one = fan_in_a_cube(1);
  ASSERT_TRUE(add_points_inside(size, 1000000, 1, one));
  EXPECT_GT(one.points.size(), 300u);
  EXPECT_TRUE(tubular::validity_report(one).is_valid());
  for (int threads : {2, 3}) {
    Mesh several = fan_in_a_cube(1);
    ASSERT_TRUE(add_points_inside(size, 1000000, threads, several));
    EXPECT_EQ(several.points, one.points);
    EXPECT_EQ(several.tetrahedra.vertices, one.tetrahedra.vertices);
  }
}

// Sizes are known at vertices, and none of those of the wall is near the ball in which they are small.
TEST_F(Fill_with_tetgen, Finds_small_sizes_far_from_the_wall) {
  const double sides = 24, coarse = 2 * CGAL_PI / sides;
  const Labelled_tube tube(int(sides), 2);
  const Point center(0.02, 0.01, 1);
  const auto away = [&](const Point& p) { return std::sqrt(CGAL::squared_distance(p, center)); };
  const auto size = [&](const Point& p) { return (std::min)(coarse, 0.03 + 0.3 * (std::max)(0., away(p) - 0.05)); };
  Mesh mesh;
  const tubular::internal::Filling_limits limits({}, tube.surface, "");
  tubular::internal::Filled_surface filling;
  ASSERT_FALSE(filling.fill(tube.surface, tube.patch, size, tubular::internal::tetgen_recovery(), limits));
  filling.write_to(mesh);
  std::size_t checked = 0;
  for (const auto& t : mesh.tetrahedra.vertices) {
    const Point &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]], &d = mesh.points[t[3]];
    const Point middle = CGAL::centroid(a, b, c, d);
    if (away(middle) > 0.6) // where the wall may be in the way
      continue;
    ++checked;
    EXPECT_LE(std::sqrt(CGAL::squared_radius(a, b, c, d)),
              1.1 * tubular::internal::Filled_surface::radius_bound * size(middle));
  }
  EXPECT_GT(checked, 1000u);
}

TEST(Delaunay_refinement, Refuses_more_points_than_memory_holds) {
  Mesh mesh = fan_in_a_cube(1);
  EXPECT_FALSE(add_points_inside([](const Point&) { return 0.2; }, 5, 1, mesh));
}

TEST(Unit_frame, Brings_points_to_unit_extent_and_back) {
  const std::vector<Point> points = {Point(1e6, 2e6, -5), Point(1e6 + 3e-3, 2e6, -5), Point(1e6, 2e6 + 1e-3, -5)};
  const tubular::internal::Unit_frame frame(points);
  for (const Point& p : points) {
    const auto x = frame.to_frame(p);
    for (int k = 0; k < 3; ++k)
      EXPECT_LE(std::abs(x[k]), 0.5);
    const Point back = frame.from_frame(x);
    EXPECT_NEAR(back.x(), p.x(), 1e-9);
    EXPECT_NEAR(back.y(), p.y(), 1e-9);
  }
  EXPECT_EQ(frame.scale(), 0.00390625); // the power of two above
}

} // namespace
