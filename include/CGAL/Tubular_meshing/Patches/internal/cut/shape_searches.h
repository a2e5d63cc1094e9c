// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_SHAPE_SEARCHES_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_SHAPE_SEARCHES_H

#include <CGAL/Tubular_meshing/base/Nearest_tree.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The segments whose boxes meet a box, in no particular order. O(log n + found). */
class Segments_in_box {
public:
  typedef Double_kernel::Segment_3 Segment;

  explicit Segments_in_box(std::vector<Segment> segments)
      : tree_(std::move(segments)) {}

  template <class Report> void for_each(const CGAL::Bbox_3& box, const Report& report) const {
    Visitor<Report> visitor{report};
    tree_.visit(box, visitor);
  }

private:
  typedef Shape_tree<Segment> Tree;

  template <class Report> struct Visitor {
    const Report& report;
    bool go_further() const { return true; }
    template <class Node> bool do_intersect(const CGAL::Bbox_3& box, const Node& node) const {
      return CGAL::do_overlap(box, node.bbox());
    }
    void intersection(const CGAL::Bbox_3& box, const typename Tree::Primitive& p) const {
      if (CGAL::do_overlap(box, p.datum().bbox()))
        report(p.datum());
    }
  };

  Tree tree_;
};

/* The first triangle that a ray meets. O(log n) for surfaces of evenly sized triangles. */
class First_hit {
public:
  typedef Double_kernel::Triangle_3 Triangle;

  struct Ray {
    Vector_3d origin, direction;
  };
  struct Hit {
    std::size_t triangle;
    double distance; // in lengths of the direction
  };
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  explicit First_hit(std::vector<Triangle> triangles)
      : tree_(std::move(triangles)) {}

  // `triangle` is none if nothing is hit.
  Hit operator()(const Ray& ray) const {
    Visitor visitor{tree_, Hit{none, (std::numeric_limits<double>::infinity)()}};
    tree_.visit_best_first(ray, visitor);
    return visitor.hit;
  }

private:
  typedef Shape_tree<Triangle> Tree;

  struct Visitor {
    typedef double Priority;

    const Tree& tree;
    Hit hit;

    bool go_further() const { return true; }
    template <class Node> bool do_intersect(const Ray& ray, const Node& node) const {
      return entry(ray, node.bbox()) < hit.distance;
    }
    template <class Node> std::pair<bool, Priority> do_intersect_with_priority(const Ray& ray, const Node& node) const {
      const double t = entry(ray, node.bbox());
      return std::make_pair(t < hit.distance, -t);
    }
    void intersection(const Ray& ray, const typename Tree::Primitive& p) {
      const double t = meeting(ray, p.datum());
      if (t < hit.distance)
        hit = Hit{tree.index(p), t};
    }
  };

  static constexpr double nowhere = (std::numeric_limits<double>::infinity)();

  // Where the ray enters the box.
  static double entry(const Ray& ray, const CGAL::Bbox_3& box) {
    double first = 0, last = nowhere;
    for (int k = 0; k < 3; ++k) {
      const double o = ray.origin[k], d = ray.direction[k];
      if (d == 0) {
        if (o < box.min_coord(k) || o > box.max_coord(k))
          return nowhere;
        continue;
      }
      const double a = (box.min_coord(k) - o) / d, b = (box.max_coord(k) - o) / d;
      first = (std::max)(first, (std::min)(a, b));
      last = (std::min)(last, (std::max)(a, b));
    }
    const double rounding = 1e-12; // a flat box must not be missed
    return first <= last * (1 + rounding) ? first : nowhere;
  }

  // T. Möller and B. Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, 1997. Edges belong to both triangles.
  static double meeting(const Ray& ray, const Triangle& t) {
    const Vector_3d a(t[0]), u = Vector_3d(t[1]) - a, v = Vector_3d(t[2]) - a, p = cross(ray.direction, v);
    const double det = dot(u, p), tolerance = 1e-9;
    if (det == 0)
      return nowhere;
    const Vector_3d w = ray.origin - a, q = cross(w, u);
    const double x = dot(w, p) / det, y = dot(ray.direction, q) / det, z = dot(v, q) / det;
    return x >= -tolerance && y >= -tolerance && x + y <= 1 + tolerance && z >= 0 ? z : nowhere;
  }

  Tree tree_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_SHAPE_SEARCHES_H
