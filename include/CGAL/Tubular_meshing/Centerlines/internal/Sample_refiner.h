// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SAMPLE_REFINER_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SAMPLE_REFINER_H

#include <CGAL/Tubular_meshing/Centerlines/internal/Interior_voronoi_diagram.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Sampled_surface.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Adds samples on the edges and in the triangles of the wall that are large against the spheres that touch them: the
 * spheres would bulge out between the vertices. */
class Sample_refiner {
public:
  typedef Sampled_surface::Point Point;
  typedef Sampled_surface::Vector Vector;

  explicit Sample_refiner(Sampled_surface& surface, int threads = 0)
      : surface_(surface)
      , threads_(threads)
      , shortest_edge_(surface.points.size(), (std::numeric_limits<double>::infinity)()) {
    for (const Sampled_surface::Triangle& t : surface_.wall)
      for (int k = 0; k < 3; ++k) {
        const Edge edge(t[k], t[(k + 1) % 3]);
        for (std::size_t v : {edge.first, edge.second})
          shortest_edge_[v] = (std::min)(shortest_edge_[v], length(edge));
      }
  }

  /* O(n log n) in the surface and the samples added. Returns whether there was anything to add; if so, call it again
   * with the diagram of all samples. */
  bool refine(const Interior_voronoi_diagram& diagram) {
    const std::size_t before = surface_.points.size();
    std::map<Edge, Vector> long_edges; // and their normals
    const std::vector<char> is_large = large_triangles(diagram);
    for (std::size_t i = 0; i < is_large.size(); ++i) {
      if (!is_large[i])
        continue;
      const Sampled_surface::Triangle& t = surface_.wall[i];
      const Point p = surface_.points[t[0]], q = surface_.points[t[1]], r = surface_.points[t[2]];
      const Vector normal = Sampled_surface::unit(CGAL::cross_product(q - p, r - p));
      for (int k = 0; k < 3; ++k)
        if (const Edge edge = edge_of(t, k); is_long(edge, diagram)) {
          Vector& sum = long_edges.emplace(edge, Vector(0, 0, 0)).first->second;
          sum = sum + normal;
        }
      fill(t, normal, diagram);
    }
    for (const auto& e : long_edges)
      fill(surface_.points[e.first.first], surface_.points[e.first.second],
           parts(length(e.first), radius(e.first, diagram)), Sampled_surface::unit(e.second));
    return surface_.points.size() > before;
  }

private:
  typedef std::pair<std::size_t, std::size_t> Edge; // lower sample first

  static Edge edge_of(const Sampled_surface::Triangle& t, int k) {
    return Edge((std::min)(t[k], t[(k + 1) % 3]), (std::max)(t[k], t[(k + 1) % 3]));
  }

  bool is_long(const Edge& e, const Interior_voronoi_diagram& diagram) const {
    return parts(length(e), radius(e, diagram)) > 1;
  }

  // Those with a long edge.
  std::vector<char> large_triangles(const Interior_voronoi_diagram& diagram) const {
    std::vector<char> result(surface_.wall.size(), 0);
    for_each_range(result.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        for (int k = 0; k < 3; ++k)
          result[i] |= is_long(edge_of(surface_.wall[i], k), diagram);
    });
    return result;
  }

  double length(const Edge& e) const {
    return std::sqrt(CGAL::squared_distance(surface_.points[e.first], surface_.points[e.second]));
  }

  /* Of the larger of the two spheres that touch at the ends of an edge; 0 if there are none. A vessel is not much
   * narrower than the edges round it are short: smaller spheres, as there are where vessels nearly touch, do not count,
   * or there would be no end of samples. */
  double radius(const Edge& e, const Interior_voronoi_diagram& diagram) const {
    const double narrowest = 0.5; // of the edges
    double result = 0;
    for (std::size_t v : {e.first, e.second})
      if (const double r = diagram.pole_radius(v); r > 0)
        result = (std::max)({result, r, narrowest * shortest_edge_[v]});
    return result;
  }

  // Into how many parts a length is to be cut, so that each is at most half the radius; lengths up to the radius are
  // left alone. A power of two, so that one round's samples are among the next one's.
  static int parts(double length, double radius) {
    const int most = 64;
    if (!(radius > 0) || length <= radius)
      return 1;
    int result = 2;
    while (result < most && result * radius < 2 * length)
      result *= 2;
    return result;
  }

  // In rows parallel to the shortest side, so that long thin triangles do not get more than they need.
  void fill(const Sampled_surface::Triangle& t, const Vector& normal, const Interior_voronoi_diagram& diagram) {
    int apex = 0;
    for (int k = 1; k < 3; ++k)
      if (opposite_length(t, k) < opposite_length(t, apex))
        apex = k;
    const std::size_t a = t[apex], b = t[(apex + 1) % 3], c = t[(apex + 2) % 3];
    const Point p = surface_.points[a], q = surface_.points[b], r = surface_.points[c];
    const double largest = (std::max)(radius(Edge(a, b), diagram), radius(Edge(a, c), diagram));
    const int rows = (std::max)(parts(length(Edge(a, b)), largest), parts(length(Edge(a, c)), largest));
    for (int k = 1; k < rows; ++k) {
      const double s = double(k) / rows;
      fill(p + s * (q - p), p + s * (r - p), parts(s * length(Edge(b, c)), largest), normal);
    }
  }

  double opposite_length(const Sampled_surface::Triangle& t, int k) const {
    return length(Edge(t[(k + 1) % 3], t[(k + 2) % 3]));
  }

  void fill(Point p, Point q, int parts, const Vector& normal) { // copies: adding samples moves them
    for (int i = 1; i < parts; ++i) {
      const Point x = p + double(i) / parts * (q - p);
      if (added_.insert(x).second)
        surface_.add(x, normal);
    }
  }

  Sampled_surface& surface_;
  const int threads_;
  std::vector<double> shortest_edge_; // at each sample that is a vertex of the wall
  std::set<Point> added_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SAMPLE_REFINER_H
