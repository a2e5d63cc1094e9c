// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_INTERNAL_NEAREST_TREE_H
#define CGAL_TUBULAR_MESHING_INTERNAL_NEAREST_TREE_H

#include <CGAL/Tubular_meshing/internal/cgal_compatibility.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

// Distances need no exact predicates, and filtered ones cost several times more: all of this is in plain doubles.
typedef CGAL::Simple_cartesian<double> Double_kernel;

template <class Point_3> Double_kernel::Point_3 to_double_point(const Point_3& p) {
  return Double_kernel::Point_3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
}

inline Double_kernel::Point_3 projection(const Double_kernel::Segment_3& s, const Double_kernel::Point_3& q) {
  const Double_kernel::Vector_3 d = s.target() - s.source();
  const double length2 = d.squared_length();
  const double t = length2 > 0 ? ((q - s.source()) * d) / length2 : 0;
  return t <= 0 ? s.source() : t >= 1 ? s.target() : s.source() + t * d;
}

inline Double_kernel::Point_3 projection(const Double_kernel::Triangle_3& t, const Double_kernel::Point_3& q) {
  return Double_kernel().construct_projected_point_3_object()(t, q);
}

inline double squared_distance_to_box(const CGAL::Bbox_3& b, const Double_kernel::Point_3& q) {
  const double dx = (std::max)((std::max)(b.xmin() - q.x(), q.x() - b.xmax()), 0.);
  const double dy = (std::max)((std::max)(b.ymin() - q.y(), q.y() - b.ymax()), 0.);
  const double dz = (std::max)((std::max)(b.zmin() - q.z(), q.z() - b.zmax()), 0.);
  return dx * dx + dy * dy + dz * dz;
}

/* The nearest of many segments or triangles (`Shape`, of Double_kernel).
 *
 * CGAL's AABB tree, walked nearer child first: unlike AABB_tree::closest_point(), a query needs no starting hint (whose
 * kd-tree search allocates), takes no lock and allocates nothing. Built once in O(n log n); a query is O(log n) for
 * shapes such as surfaces and centerlines. Safe to query from several threads.
 */
template <class Shape> class Nearest_tree {
public:
  typedef Double_kernel::Point_3 Point;

  struct Result {
    std::size_t index;
    Point point;
    double squared_distance;
  };

  Nearest_tree() {}
  explicit Nearest_tree(std::vector<Shape> shapes)
      : shapes_(new std::vector<Shape>(std::move(shapes)))
      , tree_(new Tree(shapes_->data(), shapes_->data() + shapes_->size())) {
    tree_->do_not_accelerate_distance_queries();
    tree_->build();
  }

  bool empty() const { return !shapes_ || shapes_->empty(); }
  std::size_t size() const { return shapes_ ? shapes_->size() : 0; }
  const Shape& shape(std::size_t i) const { return (*shapes_)[i]; }
  CGAL::Bbox_3 bbox() const { return empty() ? CGAL::Bbox_3() : CGAL::Bbox_3(tree_->bbox()); }

  /* The nearest shape closer than the given bound; `index` is size() if there is none. */
  Result nearest(const Point& q, double squared_bound = (std::numeric_limits<double>::infinity)()) const {
    Descent descent{q, nullptr, squared_bound};
    if (!empty())
      tree_->traversal_with_priority(q, descent);
    const std::size_t index = descent.shape == nullptr ? size() : std::size_t(descent.shape - shapes_->data());
    return Result{index, descent.point, descent.squared_distance};
  }

private:
  struct Primitive {
    typedef const Shape* Id;
    typedef Shape Datum;
    typedef const Shape& Datum_reference;
    typedef Double_kernel::Point_3 Point;
    typedef Point Point_reference;

    const Shape* shape;

    explicit Primitive(const Shape* s)
        : shape(s) {}
    Id id() const { return shape; }
    Datum_reference datum() const { return *shape; }
    Point_reference reference_point() const { return shape->vertex(0); }
  };

  typedef Aabb_traits<Double_kernel, Primitive> Traits;
  typedef CGAL::AABB_tree<Traits> Tree;

  // The traversal traits: a node is entered if it may hold something nearer than the best so far.
  struct Descent {
    typedef double Priority;

    Point point;
    const Shape* shape;
    double squared_distance;

    bool go_further() const { return true; }
    template <class Node> bool do_intersect(const Point& q, const Node& node) const {
      return squared_distance_to_box(node.bbox(), q) < squared_distance;
    }
    template <class Node> std::pair<bool, Priority> do_intersect_with_priority(const Point& q, const Node& node) const {
      const double d = squared_distance_to_box(node.bbox(), q);
      return std::make_pair(d < squared_distance, -d);
    }
    void intersection(const Point& q, const Primitive& primitive) {
      const Point p = projection(primitive.datum(), q);
      const double d = CGAL::squared_distance(p, q);
      if (d < squared_distance)
        *this = Descent{p, primitive.shape, d};
    }
  };

  // behind pointers, so that the tree's primitives stay valid when this object moves
  std::shared_ptr<std::vector<Shape>> shapes_;
  std::shared_ptr<Tree> tree_;
};

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_INTERNAL_NEAREST_TREE_H
