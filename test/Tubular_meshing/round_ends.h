// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESHING_TEST_ROUND_ENDS_H
#define TUBULAR_MESHING_TEST_ROUND_ENDS_H

// Closed vessels with sacs, bumps and stubs, and domes on the openings of any surface; the truth is known.

#include "vessel_ends.h"

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace round_ends {

using namespace vessel_ends;

inline Vector normalized(const Vector& v) {
  return v / std::sqrt(v.squared_length());
}

/* A line from a node to a new one, of a radius that may change; returns the new node. */
inline std::size_t add_tube(Skeleton& s, std::size_t from, const Point& to, double radius, double radius_at_end) {
  const Point p = s.nodes[from];
  s.nodes.push_back(to);
  s.add_branch(
      from, s.nodes.size() - 1, [=](double t) { return p + t * (to - p); },
      [=](double t) { return radius + t * (radius_at_end - radius); });
  return s.nodes.size() - 1;
}

/* Very nearly a ball around a node. */
inline void add_ball(Skeleton& s, std::size_t at, double radius, const Vector& along) {
  add_tube(s, at, s.nodes[at] + 0.02 * radius * normalized(along), radius, radius);
}

/* A ball on a neck that leaves a node, its center at a distance; and lobes, of a share of its radius, that stick out of
 * its far side. */
inline void add_sac(Skeleton& s, std::size_t node, const Vector& direction, double distance, double radius, double neck,
                    int lobes = 0, double lobe_share = 0.5) {
  const Vector out = normalized(direction);
  const std::size_t center = add_tube(s, node, s.nodes[node] + distance * out, neck, neck);
  add_ball(s, center, radius, out);
  const Vector any = std::abs(out.x()) < 0.7 ? Vector(1, 0, 0) : Vector(0, 1, 0);
  const Vector u = normalized(CGAL::cross_product(out, any)), v = CGAL::cross_product(out, u);
  for (int k = 0; k < lobes; ++k) {
    const double a = 2 * CGAL_PI * k / lobes + 0.4;
    const Vector way = normalized(0.6 * out + std::cos(a) * u + std::sin(a) * v);
    const double r = lobe_share * radius;
    const std::size_t lobe = add_tube(s, center, s.nodes[center] + 0.95 * radius * way, r, r);
    add_ball(s, lobe, r, way);
  }
}

/* A tube along z of radius 1, with a node in its middle, which is node 1. */
inline Skeleton tube_with_node(double length = 14) {
  Skeleton s;
  s.nodes = {Point(0, 0, 0)};
  const std::size_t middle = add_tube(s, 0, Point(0, 0, length / 2), 1, 1);
  add_tube(s, middle, Point(0, 0, length), 1, 1);
  return s;
}

/* A tube along z of radius 1 that swells to a radius in its middle. */
inline Skeleton spindle(double widest, double length = 20) {
  Skeleton s;
  s.nodes = {Point(0, 0, 0), Point(0, 0, length)};
  s.add_branch(
      0, 1, [=](double t) { return Point(0, 0, t * length); },
      [=](double t) {
        const double z = (t - 0.5) * length / widest;
        return 1 + (widest - 1) * std::exp(-z * z);
      });
  return s;
}

/* Closes each loop of the border by a dome: copies of the loop that shrink to its center as an ellipse does, of a height
 * given in radii. Few rings do, as triangles are to be about as large as at the rim. Returns the faces of each dome. */
inline std::vector<std::vector<Mesh::Face_index>> dome_openings(Mesh& mesh, double height) {
  std::vector<std::vector<Mesh::Face_index>> domes;
  const bool inside_out = tubular::internal::is_inside_out(mesh, tubular::internal::border_loops(mesh));
  for (const auto& loop : tubular::internal::border_loops(mesh)) {
    const Point c = loop.shape.center;
    const Vector n = (inside_out ? -1. : 1.) * loop.shape.plane.normal();
    const double edge = loop.shape.perimeter / double(loop.rim.size());
    const int rings = std::max(3, int(std::lround(0.5 * CGAL_PI * loop.shape.radius / edge)));
    std::vector<Mesh::Vertex_index> below, ring;
    std::vector<Vector> from_center;
    for (auto h : loop.rim) {
      below.push_back(mesh.target(h));
      from_center.push_back(mesh.point(mesh.target(h)) - c);
    }
    const std::size_t m = below.size();
    domes.emplace_back();
    for (int k = 1; k < rings; ++k) {
      const double a = 0.5 * CGAL_PI * k / rings;
      ring.clear();
      for (const Vector& d : from_center)
        ring.push_back(mesh.add_vertex(c + std::cos(a) * d + std::sin(a) * height * loop.shape.radius * n));
      for (std::size_t i = 0; i < m; ++i) {
        const std::size_t j = (i + 1) % m;
        domes.back().push_back(mesh.add_face(below[i], below[j], ring[j]));
        domes.back().push_back(mesh.add_face(below[i], ring[j], ring[i]));
      }
      below = ring;
    }
    const auto top = mesh.add_vertex(c + height * loop.shape.radius * n);
    for (std::size_t i = 0; i < m; ++i)
      domes.back().push_back(mesh.add_face(below[i], below[(i + 1) % m], top));
  }
  return domes;
}

/* The same surface with its vertices and faces in another order. */
inline Mesh in_other_order(const Mesh& mesh, unsigned number) {
  std::mt19937 random(number);
  const auto shuffle = [&](auto& items) {
    for (std::size_t i = items.size(); i > 1; --i)
      std::swap(items[i - 1], items[random() % i]);
  };
  std::vector<Mesh::Vertex_index> vertices(mesh.vertices().begin(), mesh.vertices().end());
  std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
  shuffle(vertices);
  shuffle(faces);
  Mesh result;
  std::map<Mesh::Vertex_index, Mesh::Vertex_index> copy;
  for (auto v : vertices)
    copy[v] = result.add_vertex(mesh.point(v));
  for (auto f : faces) {
    const auto h = mesh.halfedge(f);
    result.add_face(copy[mesh.source(h)], copy[mesh.target(h)], copy[mesh.target(mesh.next(h))]);
  }
  return result;
}

/* Turned about two axes, scaled and moved. */
inline void move(Mesh& mesh, double scale, double angle = 0.7) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (auto v : mesh.vertices()) {
    const Point p = mesh.point(v);
    const Point q(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z());
    mesh.point(v) = Point(scale * (q.x() + 3), scale * (c * q.y() - s * q.z()), scale * (s * q.y() + c * q.z()));
  }
}

} // namespace round_ends

#endif // TUBULAR_MESHING_TEST_ROUND_ENDS_H
