// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SAMPLED_SURFACE_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SAMPLED_SURFACE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Canonical_frame.h>
#include <CGAL/Tubular_meshing/base/place_on_curve.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Sample_thinner.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Wall_stars.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/parallel_sort.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Points on a closed surface with their outward normals, in canonical coordinates and canonical order: all that the
 * Voronoi diagram is made from. Built in O(n log n).
 *
 * The vertices of the wall come first, along a curve that fills space; where they are denser than is of use, others stand
 * for them, see Sample_thinner. A cap is sampled again, whatever its triangles are: by its centre, and by copies of its
 * rim shrunk towards it. */
class Sampled_surface {
public:
  typedef Double_kernel::Point_3 Point;
  typedef Double_kernel::Vector_3 Vector;
  typedef Wall_stars::Triangle Triangle;

  std::vector<Point> points;
  std::vector<Vector> normals;
  std::vector<Triangle> wall; // by samples
  std::vector<Double_kernel::Triangle_3> wall_triangles;

  /* `patch` tells the label of a face; those that are not labels::wall are caps. */
  Sampled_surface(const Surface& mesh, const Face_patch_map& patch, const Canonical_frame& frame, int threads = 0) {
    add_vertices(mesh, patch, frame, threads);
    for (auto f : mesh.faces())
      if (get(patch, f) == labels::wall)
        wall.push_back(corners(mesh, f));
      else
        caps_.emplace_back(corners(mesh, f), get(patch, f));
    parallel_sort(wall.begin(), wall.end(), std::less<Triangle>(), threads);
    wall_triangles.reserve(wall.size());
    for (const Triangle& t : wall)
      wall_triangles.emplace_back(points[t[0]], points[t[1]], points[t[2]]);
    const Wall_stars stars(points.size(), wall);
    for_each_range(points.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v)
        normals[v] = normal_at(v, stars);
    });
    instead_ = Sample_thinner(points, normals, stars, on_caps(), threads).instead();
  }

  std::size_t number_in_use() const {
    std::size_t result = points.size();
    for (std::size_t i = 0; i < instead_.size(); ++i)
      result -= is_left_out(i);
    return result;
  }

  /* Whether a sample is one of those that others stand for. */
  bool is_left_out(std::size_t sample) const { return sample < instead_.size() && instead_[sample] != sample; }

  /* Samples a cap: returns the sample at its centre. The rim runs counterclockwise, seen from outside. */
  std::size_t add_cap(const std::vector<std::size_t>& rim, const Point& center) {
    double perimeter = 0, radius = 0;
    Vector area(0, 0, 0);
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const Point &p = points[rim[i]], &q = points[rim[(i + 1) % rim.size()]];
      perimeter += std::sqrt(CGAL::squared_distance(p, q));
      radius += std::sqrt(CGAL::squared_distance(p, center)) / double(rim.size());
      area = area + CGAL::cross_product(p - center, q - center);
    }
    // as fine as the rim, within reason: at least 3 circles, at most 12
    const double step = (std::min)((std::max)(perimeter / double(rim.size()), radius / 12), radius / 3);
    const int circles = (std::max)(3, int(std::lround(radius / step)));
    const Vector normal = unit(area);
    for (std::size_t v : rim)
      normals[v] = unit(normals[v] + normal);
    for (int k = 1; k < circles; ++k) {
      const double t = double(k) / circles;
      double walked = 0, next = 0;
      for (std::size_t i = 0; i < rim.size(); ++i) {
        const Point p = center + t * (points[rim[i]] - center);
        if (walked >= next) {
          add(p, normal);
          next += step;
        }
        walked += t * std::sqrt(CGAL::squared_distance(points[rim[i]], points[rim[(i + 1) % rim.size()]]));
      }
    }
    add(center, normal);
    return points.size() - 1;
  }

  void add(const Point& p, const Vector& normal) {
    points.push_back(p);
    normals.push_back(normal);
  }

  struct Rim {
    int patch;
    std::vector<std::size_t> samples; // counterclockwise, seen from outside, from the lowest on
  };

  /* The loops in which the wall meets caps. */
  std::vector<Rim> rims() const {
    std::map<std::pair<std::size_t, std::size_t>, int> edges;
    for (const auto& c : caps_)
      for (int k = 0; k < 3; ++k)
        edges[{c.first[k], c.first[(k + 1) % 3]}] = c.second;
    std::map<std::size_t, std::pair<std::size_t, int>> next;
    for (const auto& e : edges)
      if (edges.find({e.first.second, e.first.first}) == edges.end())
        next[e.first.first] = {e.first.second, e.second};
    std::vector<Rim> result;
    while (!next.empty()) {
      Rim rim = {next.begin()->second.second, {}};
      for (auto i = next.begin(); i != next.end();) {
        rim.samples.push_back(i->first);
        const std::size_t following = i->second.first;
        next.erase(i);
        i = next.find(following);
      }
      if (rim.samples.size() > 2)
        result.push_back(std::move(rim));
    }
    return result;
  }

  /* The sample that stands for a vertex of the mesh, by number, that is on the wall. */
  std::size_t sample_of(std::size_t vertex) const {
    const std::size_t sample = sample_of_[vertex];
    return sample < instead_.size() ? instead_[sample] : sample;
  }

  static Vector unit(const Vector& v) {
    const double l = std::sqrt(v.squared_length());
    return l > 0 ? v / l : Vector(0, 0, 0);
  }

private:
  static constexpr std::size_t none = std::size_t(-1);

  struct Vertex_in_space {
    std::uint64_t along; // see place_on_curve()
    Point point;
    std::size_t number;

    bool operator<(const Vertex_in_space& other) const {
      if (along != other.along)
        return along < other.along;
      return point != other.point ? point < other.point : number < other.number;
    }
  };

  void add_vertices(const Surface& mesh, const Face_patch_map& patch, const Canonical_frame& frame, int threads) {
    sample_of_.assign(mesh.num_vertices(), none);
    for (auto f : mesh.faces())
      if (get(patch, f) == labels::wall)
        for (auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
          sample_of_[v] = 0;
    std::vector<Vertex_in_space> order;
    order.reserve(mesh.number_of_vertices());
    for (auto v : mesh.vertices())
      order.push_back({0, Point(), std::size_t(v)});
    for_each_range(order.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        order[i].point = frame.to_canonical(to_double_point(mesh.point(Surface::Vertex_index(order[i].number))));
        order[i].along = place_on_curve(order[i].point);
      }
    });
    parallel_sort(order.begin(), order.end(), std::less<Vertex_in_space>(), threads);
    points.reserve(order.size());
    for (const Vertex_in_space& v : order)
      if (sample_of_[v.number] != none) {
        sample_of_[v.number] = points.size();
        points.push_back(v.point);
      }
    std::size_t name = points.size(); // of a vertex inside a cap, which is no sample
    for (const Vertex_in_space& v : order)
      if (sample_of_[v.number] == none)
        sample_of_[v.number] = name++;
    normals.assign(points.size(), Vector(0, 0, 0));
  }

  Triangle corners(const Surface& mesh, Surface::Face_index f) const {
    const auto h = mesh.halfedge(f);
    Triangle t = {{sample_of_[mesh.source(h)], sample_of_[mesh.target(h)], sample_of_[mesh.target(mesh.next(h))]}};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
  }

  // Weighted by the angle, so that it does not depend on how the surface is triangulated.
  Vector normal_at(std::size_t v, const Wall_stars& stars) const {
    Vector sum(0, 0, 0);
    stars.for_each_triangle(v, [&](const Triangle& t, std::size_t k) {
      const Vector n = unit(CGAL::cross_product(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]));
      const Vector u = points[t[(k + 1) % 3]] - points[t[k]], w = points[t[(k + 2) % 3]] - points[t[k]];
      sum = sum + std::atan2(std::sqrt(CGAL::cross_product(u, w).squared_length()), u * w) * n;
    });
    return unit(sum);
  }

  std::vector<char> on_caps() const {
    std::vector<char> result(points.size(), 0);
    for (const auto& c : caps_)
      for (std::size_t v : c.first)
        if (v < result.size())
          result[v] = 1;
    return result;
  }

  std::vector<std::size_t> sample_of_;         // by vertex of the mesh
  std::vector<Sample_thinner::Index> instead_; // of each vertex of the wall, by sample: the one that stands for it
  std::vector<std::pair<Triangle, int>> caps_; // faces and their labels
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_SAMPLED_SURFACE_H
