// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SAMPLE_REFINER_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SAMPLE_REFINER_H

#include <CGAL/Tubular_meshing/Centerlines/internal/Interior_voronoi_diagram.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Sampled_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* Adds samples on the edges and in the triangles of the wall that are large against the spheres that touch them: the
 * spheres would bulge out between the vertices. Linear in the surface and the samples added. Returns whether there was
 * anything to add. */
class Sample_refiner {
public:
  typedef Sampled_surface::Point Point;
  typedef Sampled_surface::Vector Vector;

  Sample_refiner(Sampled_surface& surface, const Interior_voronoi_diagram& diagram)
      : surface_(surface)
      , diagram_(diagram) {}

  /* `number_of_own_samples` is how many the surface had before the first round: the others are made anew. */
  bool refine(std::size_t number_of_own_samples) {
    const std::size_t before = surface_.points.size();
    surface_.points.resize(number_of_own_samples);
    surface_.normals.resize(number_of_own_samples, Vector(0, 0, 0));
    std::map<std::pair<std::size_t, std::size_t>, std::pair<int, Vector>> long_edges;
    for (std::size_t i = 0; i < surface_.wall.size(); ++i) {
      const Sampled_surface::Triangle& t = surface_.wall[i];
      const Point &p = surface_.points[t[0]], &q = surface_.points[t[1]], &r = surface_.points[t[2]];
      const Vector normal = Sampled_surface::unit(CGAL::cross_product(q - p, r - p));
      int most = 1, least = 64;
      for (int k = 0; k < 3; ++k) {
        const auto edge = std::minmax(t[k], t[(k + 1) % 3]);
        const int parts = parts_of(edge.first, edge.second);
        most = (std::max)(most, parts);
        least = (std::min)(least, parts);
        if (parts > 1) {
          auto& entry = long_edges.emplace(edge, std::make_pair(parts, Vector(0, 0, 0))).first->second;
          entry.second = entry.second + normal;
        }
      }
      if (least > 1) // else it is narrow, and the samples on its edges will do
        fill(p, q, r, normal, most);
    }
    for (const auto& e : long_edges) {
      const Point &p = surface_.points[e.first.first], q = surface_.points[e.first.second];
      for (int k = 1; k < e.second.first; ++k)
        surface_.add(p + double(k) / e.second.first * (q - p), Sampled_surface::unit(e.second.second));
    }
    return surface_.points.size() > before;
  }

private:
  // Into how many parts an edge is to be cut, so that each is at most half the radius; edges up to that are left alone.
  int parts_of(std::size_t a, std::size_t b) const {
    const int most = 64;
    double radius = 0;
    for (std::size_t v : {a, b})
      if (diagram_.poles[v] != Interior_voronoi_diagram::none)
        radius = (std::max)(radius, diagram_.radii[diagram_.poles[v]]);
    const double length = std::sqrt(CGAL::squared_distance(surface_.points[a], surface_.points[b]));
    if (!(radius > 0) || length <= radius)
      return 1;
    int parts = 2; // a power of two, so that one round's samples are among the next one's
    while (parts < most && parts * radius < 2 * length)
      parts *= 2;
    return parts;
  }

  void fill(const Point& p, const Point& q, const Point& r, const Vector& normal, int parts) {
    for (int i = 1; i < parts; ++i)
      for (int j = 1; i + j < parts; ++j)
        surface_.add(p + double(i) / parts * (q - p) + double(j) / parts * (r - p), normal);
  }

  Sampled_surface& surface_;
  const Interior_voronoi_diagram& diagram_;
};

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SAMPLE_REFINER_H
