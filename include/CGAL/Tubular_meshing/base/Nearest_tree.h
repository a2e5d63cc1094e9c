// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_NEAREST_TREE_H
#define CGAL_TUBULAR_MESHING_BASE_NEAREST_TREE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/cgal_compatibility.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

// Distances need no exact predicates, and filtered ones cost several times more: all of this is in plain doubles.
typedef CGAL::Simple_cartesian<double> Double_kernel;

template <class Point_3> Double_kernel::Point_3 to_double_point(const Point_3& p) {
  return Double_kernel::Point_3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
}

inline Double_kernel::Point_3 to_double_point(const Vector_3d& p) {
  return Double_kernel::Point_3(p.x, p.y, p.z);
}

inline Double_kernel::Point_3 projection(const Double_kernel::Segment_3& s, const Double_kernel::Point_3& q) {
  const Double_kernel::Vector_3 d = s.target() - s.source();
  const double length2 = d.squared_length();
  const double t = length2 > 0 ? ((q - s.source()) * d) / length2 : 0;
  return t <= 0 ? s.source() : t >= 1 ? s.target() : s.source() + t * d;
}

inline Double_kernel::Point_3 projection_on_edges(const Double_kernel::Triangle_3& t, const Double_kernel::Point_3& q) {
  Double_kernel::Point_3 nearest = projection(Double_kernel::Segment_3(t[0], t[1]), q);
  for (int i = 1; i < 3; ++i) {
    const Double_kernel::Point_3 p = projection(Double_kernel::Segment_3(t[i], t[(i + 1) % 3]), q);
    if (CGAL::squared_distance(p, q) < CGAL::squared_distance(nearest, q))
      nearest = p;
  }
  return nearest;
}

/* The nearest point of a triangle, by the Voronoi region of the triangle (corner, edge, inside) that q lies in: see C.
 * Ericson, Real-Time Collision Detection, 2005, section 5.1.5. Where a triangle is so thin that rounding
 * decides, its edges stand for it. */
inline Double_kernel::Point_3 projection(const Double_kernel::Triangle_3& t, const Double_kernel::Point_3& q) {
  const Double_kernel::Point_3 &a = t[0], &b = t[1], &c = t[2];
  const Double_kernel::Vector_3 ab = b - a, ac = c - a, aq = q - a;
  const double d1 = ab * aq, d2 = ac * aq;
  if (d1 <= 0 && d2 <= 0)
    return a;
  const Double_kernel::Vector_3 bq = q - b;
  const double d3 = ab * bq, d4 = ac * bq;
  if (d3 >= 0 && d4 <= d3)
    return b;
  const Double_kernel::Vector_3 cq = q - c;
  const double d5 = ab * cq, d6 = ac * cq;
  if (d6 >= 0 && d5 <= d6)
    return c;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 > 0 && d3 < 0)
    return a + (d1 / (d1 - d3)) * ab;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 > 0 && d6 < 0)
    return a + (d2 / (d2 - d6)) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 > d3 && d5 > d6)
    return b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b);
  const double area2 = va + vb + vc, edges2 = ab.squared_length() + ac.squared_length(); // area2: (ab × ac)²
  if (area2 > 1e-13 * edges2 * edges2)
    return a + (vb / area2) * ab + (vc / area2) * ac;
  return projection_on_edges(t, q);
}

inline double squared_distance_to_box(const CGAL::Bbox_3& b, const Double_kernel::Point_3& q) {
  const double dx = (std::max)((std::max)(b.xmin() - q.x(), q.x() - b.xmax()), 0.);
  const double dy = (std::max)((std::max)(b.ymin() - q.y(), q.y() - b.ymax()), 0.);
  const double dz = (std::max)((std::max)(b.zmin() - q.z(), q.z() - b.zmax()), 0.);
  return dx * dx + dy * dy + dz * dz;
}

/* CGAL's AABB tree over segments or triangles (`Shape`, of Double_kernel), for any question: a visitor says which boxes
 * to enter. Copies of the shapes are searched, so that the surface they come from may be refined. Built once in
 * O(n log n). Safe to query from several threads. */
template <class Shape> class Shape_tree {
public:
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

  Shape_tree() {}
  explicit Shape_tree(std::vector<Shape> shapes)
      : shapes_(new std::vector<Shape>(std::move(shapes)))
      , tree_(new Tree(shapes_->data(), shapes_->data() + shapes_->size())) {
    tree_->do_not_accelerate_distance_queries();
    tree_->build();
  }

  bool empty() const { return !shapes_ || shapes_->empty(); }
  std::size_t size() const { return shapes_ ? shapes_->size() : 0; }
  const Shape& shape(std::size_t i) const { return (*shapes_)[i]; }
  std::size_t index(const Primitive& p) const { return std::size_t(p.shape - shapes_->data()); }
  CGAL::Bbox_3 bbox() const { return empty() ? CGAL::Bbox_3() : CGAL::Bbox_3(tree_->bbox()); }

  // The visitor has the members of the traversal traits of CGAL's trees; the query is handed to them.
  template <class Query, class Visitor> void visit(const Query& query, Visitor& visitor) const {
    if (!empty())
      tree_->traversal(query, visitor);
  }
  template <class Query, class Visitor> void visit_best_first(const Query& query, Visitor& visitor) const {
    if (!empty())
      tree_->traversal_with_priority(query, visitor);
  }

private:
  typedef CGAL::AABB_tree<Aabb_traits<Double_kernel, Primitive>> Tree;

  // behind pointers, so that the tree's primitives stay valid when this object moves
  std::shared_ptr<std::vector<Shape>> shapes_;
  std::shared_ptr<Tree> tree_;
};

/* The nearest of many segments or triangles.
 *
 * Walked nearer child first: unlike AABB_tree::closest_point(), a query needs no starting hint (whose kd-tree search
 * allocates), takes no lock and allocates nothing. It is O(log n) for shapes such as surfaces and centerlines. */
template <class Shape> class Nearest_tree : public Shape_tree<Shape> {
public:
  typedef Double_kernel::Point_3 Point;

  struct Result {
    std::size_t index;
    Point point;
    double squared_distance;
  };

  using Shape_tree<Shape>::Shape_tree;

  /* The nearest shape closer than the given bound; `index` is size() if there is none. */
  Result nearest(const Point& q, double squared_bound = (std::numeric_limits<double>::infinity)()) const {
    Descent descent{*this, Result{this->size(), q, squared_bound}};
    this->visit_best_first(q, descent);
    return descent.best;
  }
  /* The same, faster where `hint` is a shape that is likely to be as near. */
  Result nearest_from(std::size_t hint, const Point& q, double squared_bound) const {
    Descent descent{*this, Result{this->size(), q, squared_bound}};
    if (hint < this->size()) {
      const Point p = projection(this->shape(hint), q);
      const double d = CGAL::squared_distance(p, q);
      if (d < squared_bound)
        descent.best = Result{hint, p, d};
    }
    this->visit_best_first(q, descent);
    return descent.best;
  }

private:
  // The traversal traits: a node is entered if it may hold something nearer than the best so far.
  struct Descent {
    typedef double Priority;

    const Nearest_tree& tree;
    Result best;

    bool go_further() const { return true; }
    template <class Node> bool do_intersect(const Point& q, const Node& node) const {
      return squared_distance_to_box(node.bbox(), q) < best.squared_distance;
    }
    template <class Node> std::pair<bool, Priority> do_intersect_with_priority(const Point& q, const Node& node) const {
      const double d = squared_distance_to_box(node.bbox(), q);
      return std::make_pair(d < best.squared_distance, -d);
    }
    void intersection(const Point& q, const typename Shape_tree<Shape>::Primitive& primitive) {
      const Point p = projection(primitive.datum(), q);
      const double d = CGAL::squared_distance(p, q);
      if (d < best.squared_distance)
        best = Result{tree.index(primitive), p, d};
    }
  };
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_NEAREST_TREE_H
