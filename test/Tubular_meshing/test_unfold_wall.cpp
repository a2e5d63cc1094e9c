// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Folds of a wall that leave layers no room: tubes with vertices that have been drawn across their neighbours.

#include <CGAL/Tubular_meshing/Layers/extrude_boundary_layer.h>
#include <CGAL/Tubular_meshing/Layers/unfold_wall.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/base/Labelled_surface.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
namespace labels = tubular::labels;
namespace parameters = tubular::parameters;
using tubular::internal::unfold_wall;
using tubular::internal::Unfolded_wall;
typedef tubular::Surface Surface;
typedef tubular::Point_3 Point;
typedef Surface::Vertex_index Vertex;

constexpr int sides = 24, rows = 12;

/* A tube of triangles of radius 1 along z, closed at both ends, in some unit. */
tubular::Labelled_surface tube(double unit = 1) {
  tubular::Labelled_surface result;
  for (int k = 0; k <= rows; ++k)
    for (int i = 0; i < sides; ++i) {
      const double a = 2 * CGAL_PI * i / sides;
      result.surface.add_vertex(Point(unit * std::cos(a), unit * std::sin(a), unit * 0.26 * k));
    }
  const auto vertex = [](int k, int i) { return Vertex(Surface::size_type(k * sides + i % sides)); };
  const auto add = [&](Vertex a, Vertex b, Vertex c, int label) {
    result.patch[result.surface.add_face(a, b, c)] = label;
  };
  for (int k = 0; k < rows; ++k)
    for (int i = 0; i < sides; ++i) {
      add(vertex(k, i), vertex(k, i + 1), vertex(k + 1, i + 1), labels::wall);
      add(vertex(k, i), vertex(k + 1, i + 1), vertex(k + 1, i), labels::wall);
    }
  const Vertex bottom = result.surface.add_vertex(Point(0, 0, 0)),
               top = result.surface.add_vertex(Point(0, 0, unit * 0.26 * rows));
  for (int i = 0; i < sides; ++i) {
    add(vertex(0, i + 1), vertex(0, i), bottom, 2);
    add(vertex(rows, i), vertex(rows, i + 1), top, 3);
  }
  return result;
}

Vertex on_row(int row, int i = 0) {
  return Vertex(Surface::size_type(row * sides + i));
}

tubular::Boundary_layer layers_of(const tubular::Labelled_surface& s, double unit) {
  return tubular::extrude_boundary_layer(
      s.surface, s.patch, [=](const Point&) { return unit; },
      parameters::boundary_layer_prisms(3).boundary_layer_thickness(0.2).growth(1.3));
}

std::vector<Point> points_of(const Surface& surface) {
  std::vector<Point> result;
  for (Vertex v : surface.vertices())
    result.push_back(surface.point(v));
  return result;
}

TEST(Unfold_wall, Leaves_a_wall_without_folds_alone) {
  tubular::Labelled_surface s = tube();
  const std::vector<Point> before = points_of(s.surface);
  EXPECT_EQ(unfold_wall(s.surface, s.patch).vertices, 0u);
  EXPECT_EQ(points_of(s.surface), before);
}

// A vertex drawn along the wall, or along it and outward, beyond its neighbours: some of its faces are turned over.
TEST(Unfold_wall, Makes_room_for_layers_at_a_fold) {
  struct Fold {
    double radius, angle;
  };
  for (double unit : {1e-3, 1., 1e3})
    for (int row : {1, 6}) // the first has neighbours on a rim
      for (const Fold& fold : {Fold{1, 0.4}, Fold{1.2, 0.9}}) {
        tubular::Labelled_surface s = tube(unit);
        s.surface.point(on_row(row)) = Point(unit * fold.radius * std::cos(fold.angle),
                                             unit * fold.radius * std::sin(fold.angle), unit * 0.26 * row);
        EXPECT_THROW(layers_of(s, unit), tubular::Meshing_error);
        const std::vector<Point> before = points_of(s.surface);

        const Unfolded_wall unfolded = unfold_wall(s.surface, s.patch);
        EXPECT_GE(unfolded.vertices, 1u);
        EXPECT_LE(unfolded.vertices, 19u); // two rings
        EXPECT_GT(unfolded.distance, 0.05 * unit);
        EXPECT_LT(unfolded.distance, 1.2 * unit);
        std::size_t moved = 0;
        for (Vertex v : s.surface.vertices()) {
          moved += s.surface.point(v) != before[v];
          if (std::size_t(v) < std::size_t(sides)) // on a rim
            EXPECT_EQ(s.surface.point(v), before[v]);
          if (before[v] == unfolded.place)
            EXPECT_NEAR(std::sqrt(CGAL::squared_distance(s.surface.point(v), before[v])), unfolded.distance,
                        1e-12 * unit);
        }
        EXPECT_EQ(moved, unfolded.vertices);

        const tubular::Boundary_layer layers = layers_of(s, unit);
        EXPECT_EQ(tubular::validity_report(layers.layers).inverted_cells, 0u);
        EXPECT_EQ(layers.layers.prisms.size(), std::size_t(3 * 2 * sides * rows));
      }
}

// Several vertices in one place.
TEST(Unfold_wall, Moves_neighbours_of_larger_folds) {
  tubular::Labelled_surface s = tube();
  for (int row : {5, 6, 7}) {
    const Point& p = s.surface.point(on_row(row, 4));
    for (int i : {0, 1, 2})
      s.surface.point(on_row(row, i)) = Point(p.x(), p.y() + 0.01 * i, p.z() + 0.02 * i);
  }
  EXPECT_ANY_THROW(layers_of(s, 1));
  EXPECT_GE(unfold_wall(s.surface, s.patch).vertices, 9u);
  EXPECT_EQ(tubular::validity_report(layers_of(s, 1).layers).inverted_cells, 0u);
}

} // namespace
