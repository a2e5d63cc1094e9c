// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef LOOPED_SURFACES_H
#define LOOPED_SURFACES_H

#include "test_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>
#include <vector>

/* Lumens with loops, by implicit functions that are negative inside. They are open at the least and the greatest z,
 * where they end in planes. */
namespace looped_surfaces {

using test_surfaces::Mesh;
using test_surfaces::Point;

typedef std::function<double(double, double, double)> Function;

struct Grid {
  std::array<double, 3> low, high; // the surface does not reach the sides, but goes through top and bottom
  double edge;
};

/* The zero surface on a grid of cubes, each cut into the six tetrahedra round its diagonal. */
class Marcher {
public:
  Marcher(const Function& function, const Grid& grid)
      : grid_(grid) {
    for (std::size_t k = 0; k < 3; ++k)
      n_[k] = std::size_t(std::lround((grid.high[k] - grid.low[k]) / grid.edge));
    for (std::size_t i = 0; i <= n_[0]; ++i)
      for (std::size_t j = 0; j <= n_[1]; ++j)
        for (std::size_t k = 0; k <= n_[2]; ++k) {
          const Point p = point({{i, j, k}});
          values_.push_back(function(p.x(), p.y(), p.z()));
        }
    for (std::size_t i = 0; i < n_[0]; ++i)
      for (std::size_t j = 0; j < n_[1]; ++j)
        for (std::size_t k = 0; k < n_[2]; ++k)
          march_cube({{i, j, k}});
  }

  Mesh mesh;

private:
  typedef std::array<std::size_t, 3> Node;

  std::size_t number(const Node& a) const { return (a[0] * (n_[1] + 1) + a[1]) * (n_[2] + 1) + a[2]; }
  Point point(const Node& a) const {
    double x[3];
    for (std::size_t k = 0; k < 3; ++k)
      x[k] = a[k] == n_[k] ? grid_.high[k] : grid_.low[k] + grid_.edge * double(a[k]);
    return Point(x[0], x[1], x[2]);
  }

  void march_cube(const Node& low) {
    std::array<std::size_t, 3> axes = {{0, 1, 2}};
    do {
      std::array<Node, 4> t = {{low, low, low, low}};
      for (std::size_t k = 1; k < 4; ++k) {
        t[k] = t[k - 1];
        ++t[k][axes[k - 1]];
      }
      march(t);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }

  void march(const std::array<Node, 4>& t) {
    std::vector<std::size_t> inside, outside;
    for (std::size_t i = 0; i < 4; ++i)
      (values_[number(t[i])] < 0 ? inside : outside).push_back(i);
    const auto at = [&](std::size_t i, std::size_t j) { return crossing(t[i], t[j]); };
    if (inside.size() == 1 || outside.size() == 1) {
      const std::size_t one = inside.size() == 1 ? inside[0] : outside[0];
      std::vector<std::size_t> other;
      for (std::size_t i = 0; i < 4; ++i)
        if (i != one)
          other.push_back(i);
      add(t, {{at(one, other[0]), at(one, other[1]), at(one, other[2])}});
    } else if (inside.size() == 2) {
      const auto a = at(inside[0], outside[0]), b = at(inside[0], outside[1]);
      const auto c = at(inside[1], outside[1]), d = at(inside[1], outside[0]);
      add(t, {{a, b, c}});
      add(t, {{a, c, d}});
    }
  }

  // Turned towards the outside of its tetrahedron.
  void add(const std::array<Node, 4>& t, std::array<Mesh::Vertex_index, 3> f) {
    const Point& p = mesh.point(f[0]);
    const auto normal = CGAL::cross_product(mesh.point(f[1]) - p, mesh.point(f[2]) - p);
    double outward = 0;
    for (const Node& a : t)
      outward += (values_[number(a)] < 0 ? -1 : 1) * ((point(a) - p) * normal);
    if (outward < 0)
      std::swap(f[1], f[2]);
    mesh.add_face(f[0], f[1], f[2]);
  }

  // Off the ends of the edge, so that all triangles have an area.
  Mesh::Vertex_index crossing(const Node& a, const Node& b) {
    const std::size_t i = number(a), j = number(b);
    if (i > j)
      return crossing(b, a);
    const auto inserted = crossings_.emplace(std::make_pair(i, j), Mesh::Vertex_index());
    if (inserted.second) {
      const double t = std::min(std::max(values_[i] / (values_[i] - values_[j]), 0.15), 0.85);
      const Point p = point(a), q = point(b);
      inserted.first->second = mesh.add_vertex(p + t * (q - p));
    }
    return inserted.first->second;
  }

  const Grid grid_;
  std::array<std::size_t, 3> n_;
  std::vector<double> values_;
  std::map<std::pair<std::size_t, std::size_t>, Mesh::Vertex_index> crossings_;
};

/* A tube of radius 1 along z, split by a flap, which has holes: the lumen has one more loop than these. */
struct Septum {
  int holes = 2;
  double length = 8, flap = 5, thickness = 0.2, hole = 0.4;
  double off_center = 0; // of the flap: lumens of two widths
};

inline Mesh septum(const Septum& s, double edge = 0.1) {
  const auto inside = [s](double x, double y, double z) {
    double flap = std::max(std::abs(x - s.off_center) - s.thickness / 2, std::abs(z) - s.flap / 2);
    for (int i = 0; i < s.holes; ++i) {
      const double center = s.flap * ((i + 1.) / (s.holes + 1.) - 0.5);
      flap = std::max(flap, s.hole - std::hypot(y, z - center));
    }
    return std::max(std::hypot(x, y) - 1, -flap);
  };
  const double side = 1.2;
  return Marcher(inside, {{{-side, -side, -s.length / 2}}, {{side, side, s.length / 2}}, edge}).mesh;
}

/* A tube of radius 1 along z, with arches on its wall: thin tubes that leave it and come back. */
inline Mesh tube_with_arches(int arches, double length, double thickness, double edge = 0.1) {
  const auto inside = [=](double x, double y, double z) {
    double d = std::hypot(x, y) - 1;
    for (int i = 0; i < arches; ++i) {
      const double center = length * ((i + 0.5) / arches - 0.5), ring = std::hypot(x - 0.9, z - center) - 0.8;
      d = std::min(d, std::hypot(ring, y) - thickness);
    }
    return d;
  };
  return Marcher(inside, {{{-1.2, -1.2, -length / 2}}, {{2.2, 1.2, length / 2}}, edge}).mesh;
}

/* A tube along z that parts into two round a hole in its wall, again and again. */
inline Mesh chain_of_rings(int rings, double edge = 0.1) {
  const double pitch = 4;
  const auto inside = [=](double x, double y, double z) {
    double d = std::hypot(x, y) - 0.5;
    for (int i = 0; i < rings; ++i) {
      const double center = pitch * (i + 0.5 - rings / 2.), rho = std::hypot(x, z - center);
      d = rho < 1.3 ? std::hypot(rho - 1.3, y) - 0.4 : std::min(d, std::hypot(rho - 1.3, y) - 0.4);
    }
    return d;
  };
  return Marcher(inside, {{{-2, -1, -pitch * rings / 2}}, {{2, 1, pitch * rings / 2}}, edge}).mesh;
}

} // namespace looped_surfaces

#endif // LOOPED_SURFACES_H
