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
 * spheres would bulge out between the vertices. */
class Sample_refiner {
public:
  typedef Sampled_surface::Point Point;
  typedef Sampled_surface::Vector Vector;

  explicit Sample_refiner(Sampled_surface& surface)
      : surface_(surface)
      , triangle_parts_(surface.wall.size(), 1) {}

  /* Linear in the surface and the samples added. Returns whether there was anything to add; if so, call it again with
   * the diagram of all samples. */
  bool refine(const Interior_voronoi_diagram& diagram) {
    const std::size_t before = surface_.points.size();
    std::map<Edge, std::pair<int, Vector>> long_edges;
    for (std::size_t i = 0; i < surface_.wall.size(); ++i) {
      const Sampled_surface::Triangle& t = surface_.wall[i];
      const Point p = surface_.points[t[0]], q = surface_.points[t[1]], r = surface_.points[t[2]];
      const Vector normal = Sampled_surface::unit(CGAL::cross_product(q - p, r - p));
      int most = 1, least = most_parts;
      for (int k = 0; k < 3; ++k) {
        const Edge edge((std::min)(t[k], t[(k + 1) % 3]), (std::max)(t[k], t[(k + 1) % 3]));
        const int parts = parts_of(edge, diagram);
        most = (std::max)(most, parts);
        least = (std::min)(least, parts);
        if (parts > 1) {
          auto& entry = long_edges.emplace(edge, std::make_pair(parts, Vector(0, 0, 0))).first->second;
          entry.second = entry.second + normal;
        }
      }
      if (least > 1) // else it is narrow, and the samples on its edges will do
        fill(p, q, r, normal, triangle_parts_[i], most);
    }
    for (const auto& e : long_edges)
      fill(e.first, Sampled_surface::unit(e.second.second), e.second.first);
    return surface_.points.size() > before;
  }

private:
  typedef std::pair<std::size_t, std::size_t> Edge; // lower sample first
  static constexpr int most_parts = 64;

  // Into how many parts an edge is to be cut, a power of two, so that each is at most half the radius; edges up to the
  // radius are left alone.
  int parts_of(const Edge& e, const Interior_voronoi_diagram& diagram) const {
    double radius = 0;
    for (std::size_t v : {e.first, e.second})
      if (diagram.poles[v] != Interior_voronoi_diagram::none)
        radius = (std::max)(radius, diagram.radii[diagram.poles[v]]);
    const double length = std::sqrt(CGAL::squared_distance(surface_.points[e.first], surface_.points[e.second]));
    if (!(radius > 0) || length <= radius)
      return 1;
    int parts = 2;
    while (parts < most_parts && parts * radius < 2 * length)
      parts *= 2;
    return parts;
  }

  // Only what is not there from earlier rounds, of fewer parts.
  void fill(const Point& p, const Point& q, const Point& r, const Vector& normal, int& done, int parts) {
    for (int i = 1; i < parts; ++i)
      for (int j = 1; i + j < parts; ++j)
        if ((i * done) % parts != 0 || (j * done) % parts != 0)
          surface_.add(p + double(i) / parts * (q - p) + double(j) / parts * (r - p), normal);
    done = (std::max)(done, parts);
  }

  void fill(const Edge& e, const Vector& normal, int parts) {
    int& done = edge_parts_.emplace(e, 1).first->second;
    const Point p = surface_.points[e.first], q = surface_.points[e.second];
    for (int i = 1; i < parts; ++i)
      if ((i * done) % parts != 0)
        surface_.add(p + double(i) / parts * (q - p), normal);
    done = (std::max)(done, parts);
  }

  Sampled_surface& surface_;
  std::vector<int> triangle_parts_; // so far
  std::map<Edge, int> edge_parts_;
};

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SAMPLE_REFINER_H
