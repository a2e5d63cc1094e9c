// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_GENERATORS_INTERNAL_MARCH_TETRAHEDRA_H
#define CGAL_TUBULAR_MESHING_GENERATORS_INTERNAL_MARCH_TETRAHEDRA_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Generators/Tubular_distance_function.h>
#include <CGAL/Tubular_meshing/Generators/internal/Tubular_octree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The zero surface of a function on the conforming tetrahedra of a balanced octree, as a closed manifold triangle mesh
 * that is oriented towards positive values.
 *
 * A cell is cut into the tetrahedra between its centre, the centre of a face and a piece of that face's edges; a face
 * next to smaller cells is taken as their four faces, and an edge that a smaller cell has divided as two pieces. Both
 * sides of a face thus see the same triangles, so that the result is watertight by construction, and manifold as each
 * tetrahedron is crossed by one or two triangles at most. */
class Tetrahedra_marcher {
public:
  Tetrahedra_marcher(const Tubular_distance_function& function, const Tubular_octree& octree, Surface& mesh)
      : function_(function)
      , octree_(octree)
      , mesh_(mesh) {
    for (const Cell& c : octree.leaves())
      march(c);
  }

private:
  typedef Tubular_octree::Cell Cell;
  typedef Tubular_octree::Lattice_point Lattice_point;
  typedef std::array<std::size_t, 4> Tetrahedron; // of lattice points

  void march(const Cell& c) {
    // The function grows by hardly more than the distance.
    const Vector_3d center = octree_.center(c);
    if (std::abs(function_.evaluate(center).value) > 1.2 * 0.8661 * octree_.size(c))
      return;
    const std::int64_t h = octree_.half_edge(c);
    Lattice_point corner = octree_.corner(c);
    const std::size_t apex = lattice_index({{corner[0] + h, corner[1] + h, corner[2] + h}});
    for (int axis = 0; axis < 3; ++axis)
      for (int side : {0, 1}) {
        std::array<int, 3> step = {{0, 0, 0}};
        step[std::size_t(axis)] = 2 * side - 1;
        Lattice_point lower = corner;
        lower[std::size_t(axis)] += side * 2 * h;
        if (!octree_.is_divided(Tubular_octree::neighbor(c, step[0], step[1], step[2]))) {
          march_face(c, apex, axis, side, lower);
          continue;
        }
        for (int i : {0, 1})
          for (int j : {0, 1}) {
            Lattice_point quarter = lower;
            quarter[std::size_t((axis + 1) % 3)] += i * h;
            quarter[std::size_t((axis + 2) % 3)] += j * h;
            march_quarter(apex, axis, side, quarter, h);
          }
      }
  }

  // A face of a cell that no smaller cell touches: its edges may be divided still.
  void march_face(const Cell& c, std::size_t apex, int axis, int side, const Lattice_point& lower) {
    const std::int64_t h = octree_.half_edge(c);
    const std::size_t u = std::size_t((axis + 1) % 3), v = std::size_t((axis + 2) % 3);
    Lattice_point middle = lower;
    middle[u] += h;
    middle[v] += h;
    const std::size_t face_center = lattice_index(middle);
    static constexpr int turn[4][2] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    for (std::size_t i = 0; i < 4; ++i) {
      const int* from = turn[i];
      const int* to = turn[(i + 1) % 4];
      Lattice_point a = lower, b = lower, m = lower;
      a[u] += from[0] * h, a[v] += from[1] * h;
      b[u] += to[0] * h, b[v] += to[1] * h;
      m[u] += (from[0] + to[0]) / 2 * h, m[v] += (from[1] + to[1]) / 2 * h;
      // Across the edge, in the plane of the face: below u, v for edges 0 and 3, above for 1 and 2.
      const std::size_t across = i % 2 == 0 ? v : u;
      const int direction = i == 0 || i == 3 ? -1 : 1;
      const std::size_t ia = lattice_index(a), ib = lattice_index(b);
      if (is_edge_divided(c, axis, side, across, direction)) {
        const std::size_t im = lattice_index(m);
        march_oriented(side, apex, face_center, ia, im);
        march_oriented(side, apex, face_center, im, ib);
      } else
        march_oriented(side, apex, face_center, ia, ib);
    }
  }

  // A face of a smaller neighbour: balance leaves its edges whole.
  void march_quarter(std::size_t apex, int axis, int side, const Lattice_point& lower, std::int64_t edge) {
    const std::size_t u = std::size_t((axis + 1) % 3), v = std::size_t((axis + 2) % 3);
    std::array<Lattice_point, 4> corners = {{lower, lower, lower, lower}};
    corners[1][u] += edge;
    corners[2][u] += edge, corners[2][v] += edge;
    corners[3][v] += edge;
    Lattice_point middle = lower;
    middle[u] += edge / 2, middle[v] += edge / 2;
    const std::size_t face_center = lattice_index(middle);
    for (std::size_t i = 0; i < 4; ++i) {
      // One after the other: points are numbered as they are met, whatever the compiler.
      const std::size_t ib = lattice_index(corners[(i + 1) % 4]);
      const std::size_t ia = lattice_index(corners[i]);
      march_oriented(side, apex, face_center, ia, ib);
    }
  }

  // Any of the three other cells around an edge may have divided it.
  bool is_edge_divided(const Cell& c, int axis, int side, std::size_t across, int direction) const {
    std::array<int, 3> face_step = {{0, 0, 0}}, side_step = {{0, 0, 0}};
    face_step[std::size_t(axis)] = 2 * side - 1;
    side_step[across] = direction;
    auto divided = [&](const std::array<int, 3>& s) {
      return octree_.is_divided(Tubular_octree::neighbor(c, s[0], s[1], s[2]));
    };
    return divided(face_step) || divided(side_step) ||
           divided({{face_step[0] + side_step[0], face_step[1] + side_step[1], face_step[2] + side_step[2]}});
  }

  // Makes (b, c, d) turn clockwise seen from a.
  void march_oriented(int side, std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    if (side == 1)
      march_tetrahedron({{a, b, c, d}});
    else
      march_tetrahedron({{a, b, d, c}});
  }

  void march_tetrahedron(const Tetrahedron& t) {
    std::array<std::size_t, 4> inside, outside;
    std::size_t n = 0, m = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if (values_[t[i]] < 0)
        inside[n++] = i;
      else
        outside[m++] = i;
    if (n == 1) {
      const std::size_t i = inside[0];
      add_triangle(t, i, (i + 1) % 4, i, (i + 2) % 4, i, (i + 3) % 4, i % 2 == 0);
    } else if (n == 3) {
      const std::size_t o = outside[0];
      add_triangle(t, o, (o + 1) % 4, o, (o + 2) % 4, o, (o + 3) % 4, o % 2 == 1);
    } else if (n == 2) {
      const std::size_t i = inside[0], j = inside[1], k = outside[0], l = outside[1];
      const bool even = !((i == 0 && j == 2) || (i == 1 && j == 3)); // parity of (i, j, k, l)
      add_triangle(t, i, k, i, l, j, l, even);
      add_triangle(t, i, k, j, l, j, k, even);
    }
  }

  void add_triangle(const Tetrahedron& t, std::size_t a0, std::size_t a1, std::size_t b0, std::size_t b1,
                    std::size_t c0, std::size_t c1, bool as_is) {
    const Vertex a = crossing(t[a0], t[a1]), b = crossing(t[b0], t[b1]), c = crossing(t[c0], t[c1]);
    if (as_is)
      mesh_.add_face(a, b, c);
    else
      mesh_.add_face(a, c, b);
  }

  // Kept off the ends of the edge, so that all triangles have an area.
  Vertex crossing(std::size_t i, std::size_t j) {
    if (i > j)
      std::swap(i, j);
    const auto inserted = crossings_.emplace((std::uint64_t(i) << 32) | std::uint64_t(j), Vertex());
    if (inserted.second) {
      const double t = (std::min)((std::max)(values_[i] / (values_[i] - values_[j]), 0.1), 0.9);
      inserted.first->second = mesh_.add_vertex(as<Point_3>(positions_[i] + t * (positions_[j] - positions_[i])));
    }
    return inserted.first->second;
  }

  std::size_t lattice_index(const Lattice_point& p) {
    const std::uint64_t key = (std::uint64_t(p[0]) << 42) | (std::uint64_t(p[1]) << 21) | std::uint64_t(p[2]);
    const auto inserted = lattice_.emplace(key, std::uint32_t(values_.size()));
    if (inserted.second) {
      positions_.push_back(octree_.position(p));
      values_.push_back(function_.evaluate(positions_.back()).value);
    }
    return inserted.first->second;
  }

  const Tubular_distance_function& function_;
  const Tubular_octree& octree_;
  Surface& mesh_;
  std::unordered_map<std::uint64_t, std::uint32_t> lattice_;
  std::vector<Vector_3d> positions_;
  std::vector<double> values_;
  std::unordered_map<std::uint64_t, Vertex> crossings_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_GENERATORS_INTERNAL_MARCH_TETRAHEDRA_H
