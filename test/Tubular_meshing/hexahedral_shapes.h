// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes of hexahedra, and the surfaces that they lie on.

#ifndef CGAL_TUBULAR_MESHING_TEST_HEXAHEDRAL_SHAPES_H
#define CGAL_TUBULAR_MESHING_TEST_HEXAHEDRAL_SHAPES_H

#include <CGAL/Tubular_meshing/base/Labelled_surface.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/cell_topology.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace hexahedral_shapes {

namespace tubular = CGAL::Tubular_meshing;
typedef tubular::Point_3 Point;
typedef tubular::Mixed_mesh Mesh;
typedef std::array<std::uint32_t, 4> Quad;

/* Adds the faces that one hexahedron has alone, with the label that they are given by their corners. */
inline void add_boundary(Mesh& mesh, const std::function<int(const std::array<Point, 4>&)>& label) {
  std::map<Quad, std::pair<Quad, int>> faces; // by sorted corners: the face, and how often it is there
  for (const auto& h : mesh.hexahedra.vertices)
    for (const auto& f : tubular::internal::Cell_topology<8>::quads()) {
      const Quad face = {h[std::size_t(f[0])], h[std::size_t(f[1])], h[std::size_t(f[2])], h[std::size_t(f[3])]};
      Quad key = face;
      std::sort(key.begin(), key.end());
      ++faces.emplace(key, std::make_pair(face, 0)).first->second.second;
    }
  for (const auto& f : faces)
    if (f.second.second == 1) {
      const Quad& q = f.second.first;
      mesh.quads.push_back(q, label({mesh.points[q[0]], mesh.points[q[1]], mesh.points[q[2]], mesh.points[q[3]]}));
    }
}

// --- a box ---

/* The box of these lengths, its sides labelled 1 to 6: axis by axis, the lower first. */
inline tubular::Labelled_surface box_surface(const std::array<double, 3>& lengths) {
  tubular::Labelled_surface result;
  auto& surface = result.surface;
  std::vector<tubular::Surface::Vertex_index> v;
  for (int i = 0; i < 8; ++i)
    v.push_back(surface.add_vertex(Point((i & 1) * lengths[0], ((i >> 1) & 1) * lengths[1], (i >> 2) * lengths[2])));
  const int sides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (int s = 0; s < 6; ++s)
    for (int half = 0; half < 2; ++half)
      result.patch[surface.add_face(v[std::size_t(sides[s][0])], v[std::size_t(sides[s][1 + half])],
                                    v[std::size_t(sides[s][2 + half])])] = s + 1;
  return result;
}

/* Its grid of n[0] x n[1] x n[2] hexahedra. */
inline Mesh box_grid(const std::array<int, 3>& n, const std::array<double, 3>& lengths) {
  Mesh mesh;
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i)
        mesh.points.emplace_back(lengths[0] * i / n[0], lengths[1] * j / n[1], lengths[2] * k / n[2]);
  const auto at = [&](int i, int j, int k) { return std::uint32_t((k * (n[1] + 1) + j) * (n[0] + 1) + i); };
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i)
        mesh.hexahedra.push_back({at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k), at(i, j, k + 1),
                                  at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1)},
                                 1);
  add_boundary(mesh, [&](const std::array<Point, 4>& p) {
    for (int axis = 0; axis < 3; ++axis)
      for (int end = 0; end < 2; ++end)
        if (std::all_of(p.begin(), p.end(),
                        [&](const Point& q) { return q[axis] == end * lengths[std::size_t(axis)]; }))
          return 1 + 2 * axis + end;
    return 0;
  });
  return mesh;
}

/* Moves each vertex by up to `amount` in each coordinate; `within(v, p)` says where it ends up. */
inline void shake(Mesh& mesh, double amount, const std::function<Point(std::size_t, const Point&)>& within) {
  std::mt19937 random(11);
  const auto uniform = [&] { return amount * (2 * (random() / 4294967296.) - 1); };
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const double x = uniform(), y = uniform(), z = uniform();
    const Point& p = mesh.points[v];
    mesh.points[v] = within(v, Point(p.x() + x, p.y() + y, p.z() + z));
  }
}

/* The same, vertices of a box staying in its sides. */
inline void shake_box(Mesh& mesh, double amount, const std::array<double, 3>& lengths) {
  const std::vector<Point> before = mesh.points;
  shake(mesh, amount, [&](std::size_t v, const Point& p) {
    std::array<double, 3> x = {p.x(), p.y(), p.z()};
    for (int i = 0; i < 3; ++i) {
      const double at = before[v][i], length = lengths[std::size_t(i)];
      x[std::size_t(i)] = at == 0 || at == length ? at : std::min(std::max(x[std::size_t(i)], 0.), length);
    }
    return Point(x[0], x[1], x[2]);
  });
}

// --- a cylinder ---

/* A prism of that many sides around the z-axis, of radius 1: its wall labelled 1, its ends 2 and 3. */
inline tubular::Labelled_surface cylinder_surface(int sides, int rings, double length) {
  tubular::Labelled_surface result;
  auto& surface = result.surface;
  const auto add = [&](tubular::Surface::Vertex_index a, tubular::Surface::Vertex_index b,
                       tubular::Surface::Vertex_index c,
                       int label) { result.patch[surface.add_face(a, b, c)] = label; };
  std::vector<tubular::Surface::Vertex_index> v;
  for (int k = 0; k <= rings; ++k)
    for (int i = 0; i < sides; ++i) {
      const double a = 2 * CGAL_PI * i / sides;
      v.push_back(surface.add_vertex(Point(std::cos(a), std::sin(a), length * k / rings)));
    }
  const auto at = [&](int i, int k) { return v[std::size_t(k * sides + i % sides)]; };
  for (int k = 0; k < rings; ++k)
    for (int i = 0; i < sides; ++i) {
      add(at(i, k), at(i + 1, k), at(i + 1, k + 1), 1);
      add(at(i, k), at(i + 1, k + 1), at(i, k + 1), 1);
    }
  const auto bottom = surface.add_vertex(Point(0, 0, 0)), top = surface.add_vertex(Point(0, 0, length));
  for (int i = 0; i < sides; ++i) {
    add(at(i + 1, 0), at(i, 0), bottom, 2);
    add(at(i, rings), at(i + 1, rings), top, 3);
  }
  return result;
}

/* An O-grid in it: a square of 2s x 2s, `layers` around it, and `length_cells` along the axis. */
inline Mesh o_grid(int s, int layers, int length_cells, double length) {
  Mesh mesh;
  std::map<std::array<int, 4>, std::uint32_t> index;
  const auto vertex = [&](int u, int w, int l, int t) {
    const auto found = index.emplace(std::array<int, 4>{u, w, l, t}, std::uint32_t(mesh.points.size()));
    if (found.second) {
      const double m = std::max(std::abs(u), std::abs(w)), inner = 0.5;
      // the square bulges half of the way to a circle
      const double norm = std::hypot(u, w), x = norm > 0 ? u / norm : 0, y = norm > 0 ? w / norm : 0;
      const double square = norm / s, circle = m / s;
      const double r = l == 0 ? inner * (square + circle) / 2
                              : (inner * (norm / m + 1) / 2) * (1 - double(l) / layers) + double(l) / layers;
      mesh.points.emplace_back(r * x, r * y, length * t / length_cells);
    }
    return found.first->second;
  };
  std::vector<std::array<int, 2>> ring; // around the square, counterclockwise
  for (int i = -s; i < s; ++i)
    ring.push_back({i, -s});
  for (int i = -s; i < s; ++i)
    ring.push_back({s, i});
  for (int i = s; i > -s; --i)
    ring.push_back({i, s});
  for (int i = s; i > -s; --i)
    ring.push_back({-s, i});
  const auto add = [&](const std::array<std::array<int, 3>, 4>& base, int t) {
    std::array<std::uint32_t, 8> h;
    for (std::size_t c = 0; c < 4; ++c) {
      h[c] = vertex(base[c][0], base[c][1], base[c][2], t);
      h[c + 4] = vertex(base[c][0], base[c][1], base[c][2], t + 1);
    }
    mesh.hexahedra.push_back(h, 1);
  };
  for (int t = 0; t < length_cells; ++t) {
    for (int u = -s; u < s; ++u)
      for (int w = -s; w < s; ++w)
        add({{{u, w, 0}, {u + 1, w, 0}, {u + 1, w + 1, 0}, {u, w + 1, 0}}}, t);
    for (std::size_t b = 0; b < ring.size(); ++b) {
      const auto p = ring[b], q = ring[(b + 1) % ring.size()];
      for (int l = 0; l < layers; ++l)
        add({{{p[0], p[1], l}, {p[0], p[1], l + 1}, {q[0], q[1], l + 1}, {q[0], q[1], l}}}, t);
    }
  }
  add_boundary(mesh, [&](const std::array<Point, 4>& p) {
    const auto all_at = [&](double z) {
      return std::all_of(p.begin(), p.end(), [&](const Point& q) { return q.z() == z; });
    };
    return all_at(0) ? 2 : all_at(length) ? 3 : 1;
  });
  return mesh;
}

// --- from tetrahedra ---

/* Each tetrahedron in four: a hexahedron at each of its vertices, with the middles of edges, facets and the
 * tetrahedron. */
inline Mesh split_tetrahedra(const Mesh& from) {
  Mesh mesh;
  mesh.points = from.points;
  std::map<std::vector<std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::vector<std::uint32_t> of) {
    std::sort(of.begin(), of.end());
    const auto found = middles.emplace(of, std::uint32_t(mesh.points.size()));
    if (found.second) {
      double x = 0, y = 0, z = 0;
      for (std::uint32_t v : of) {
        x += from.points[v].x() / double(of.size());
        y += from.points[v].y() / double(of.size());
        z += from.points[v].z() / double(of.size());
      }
      mesh.points.emplace_back(x, y, z);
    }
    return found.first->second;
  };
  for (std::size_t i = 0; i < from.tetrahedra.size(); ++i) {
    const auto& t = from.tetrahedra.vertices[i];
    // each corner with the others, right handed
    const int corners[4][4] = {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};
    for (const auto& k : corners) {
      const std::uint32_t o = t[std::size_t(k[0])], a = t[std::size_t(k[1])], b = t[std::size_t(k[2])],
                          c = t[std::size_t(k[3])];
      mesh.hexahedra.push_back({o, middle({o, a}), middle({o, a, b}), middle({o, b}), middle({o, c}), middle({o, a, c}),
                                middle({o, a, b, c}), middle({o, b, c})},
                               from.tetrahedra.label[i]);
    }
  }
  for (std::size_t i = 0; i < from.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& t = from.triangles.vertices[i];
      const std::uint32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
      mesh.quads.push_back({a, middle({a, b}), middle({a, b, c}), middle({a, c})}, from.triangles.label[i]);
    }
  mesh.region_names = from.region_names;
  mesh.patch_names = from.patch_names;
  return mesh;
}

} // namespace hexahedral_shapes

#endif // CGAL_TUBULAR_MESHING_TEST_HEXAHEDRAL_SHAPES_H
