// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces of lumens that are given by a function, as segmentations give them: triangles of all shapes.

#ifndef CGAL_TUBULAR_MESHING_TEST_IMPLICIT_SURFACE_H
#define CGAL_TUBULAR_MESHING_TEST_IMPLICIT_SURFACE_H

#include "test_surfaces.h"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace test_surfaces {

typedef std::function<double(const Point&)> Implicit; // negative inside

inline Implicit ball(const Point& center, double radius) {
  return [=](const Point& p) { return std::sqrt(CGAL::squared_distance(p, center)) - radius; };
}

/* A vessel along a segment, of a radius that depends on how far along it a point is, from 0 to 1. */
inline Implicit vessel(const Point& a, const Point& b, const std::function<double(double)>& radius) {
  return [=](const Point& p) {
    const double t = std::min(1., std::max(0., (p - a) * (b - a) / (b - a).squared_length()));
    return std::sqrt(CGAL::squared_distance(p, a + t * (b - a))) - radius(t);
  };
}
inline Implicit vessel(const Point& a, const Point& b, double radius) {
  return vessel(a, b, [radius](double) { return radius; });
}

inline Implicit united(const Implicit& f, const Implicit& g) {
  return [=](const Point& p) { return std::min(f(p), g(p)); };
}

/* The part of the surface f = 0 in a box, by marching tetrahedra in cubes of the given width: turned outward, open
 * where the box cuts it off. */
inline Mesh implicit_surface(const Implicit& f, const Point& low, const Point& high, double width) {
  std::array<int, 3> n;
  for (int k = 0; k < 3; ++k)
    n[k] = int(std::lround((high[k] - low[k]) / width));
  const auto number = [&](int i, int j, int k) { return (std::size_t(i) * (n[1] + 1) + j) * (n[2] + 1) + k; };
  std::vector<double> value(std::size_t(n[0] + 1) * (n[1] + 1) * (n[2] + 1));
  std::vector<Point> place(value.size());
  for (int i = 0; i <= n[0]; ++i)
    for (int j = 0; j <= n[1]; ++j)
      for (int k = 0; k <= n[2]; ++k) {
        const std::size_t v = number(i, j, k);
        place[v] = low + width * Vector(i, j, k);
        value[v] = f(place[v]);
        if (std::abs(value[v]) < 1e-3 * width) // no triangle without an area
          value[v] = 1e-3 * width;
      }
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> on_edge;
  const auto cut = [&](std::size_t a, std::size_t b) { // between a, inside, and b, outside
    const auto found = on_edge.emplace(std::minmax(a, b), points.size());
    if (found.second)
      points.push_back(place[a] + value[a] / (value[a] - value[b]) * (place[b] - place[a]));
    return found.first->second;
  };
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t inside) {
    const Vector normal = CGAL::cross_product(points[b] - points[a], points[c] - points[a]);
    if (normal * (place[inside] - points[a]) > 0)
      std::swap(b, c);
    triangles.push_back({{a, b, c}});
  };
  const auto march = [&](const std::array<std::size_t, 4>& t) {
    std::vector<std::size_t> in, out;
    for (std::size_t v : t)
      (value[v] < 0 ? in : out).push_back(v);
    if (in.size() == 1)
      add(cut(in[0], out[0]), cut(in[0], out[1]), cut(in[0], out[2]), in[0]);
    else if (in.size() == 3)
      add(cut(in[0], out[0]), cut(in[1], out[0]), cut(in[2], out[0]), in[0]);
    else if (in.size() == 2) {
      const std::size_t a = cut(in[0], out[0]), b = cut(in[0], out[1]), c = cut(in[1], out[1]), d = cut(in[1], out[0]);
      add(a, b, c, in[0]);
      add(a, c, d, in[0]);
    }
  };
  static const int paths[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  for (int i = 0; i < n[0]; ++i)
    for (int j = 0; j < n[1]; ++j)
      for (int k = 0; k < n[2]; ++k)
        for (const auto& path : paths) { // from one corner of the cube to the opposite one, axis by axis
          std::array<int, 3> at = {{i, j, k}};
          std::array<std::size_t, 4> t = {{number(i, j, k), 0, 0, 0}};
          for (int s = 0; s < 3; ++s) {
            ++at[path[s]];
            t[s + 1] = number(at[0], at[1], at[2]);
          }
          march(t);
        }
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  return mesh;
}

} // namespace test_surfaces

#endif // CGAL_TUBULAR_MESHING_TEST_IMPLICIT_SURFACE_H
