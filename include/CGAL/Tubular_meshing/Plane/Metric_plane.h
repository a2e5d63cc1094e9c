// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PLANE_METRIC_PLANE_H
#define CGAL_TUBULAR_MESHING_PLANE_METRIC_PLANE_H

#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/Plane/Plane_store.h>
#include <CGAL/Tubular_meshing/Plane/Plane_triangulation.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

struct Plane_vector {
  double x, y;
};
inline Plane_vector operator-(const Plane_point& a, const Plane_point& b) {
  return {a.x() - b.x(), a.y() - b.y()};
}
inline double cross(const Plane_vector& a, const Plane_vector& b) {
  return a.x * b.y - a.y * b.x;
}
inline double dot(const Metric_tensor_2& m, const Plane_vector& a, const Plane_vector& b) {
  return m.dot(a.x, a.y, b.x, b.y);
}

// A point, and the field's values there, which are asked for once.
struct Plane_node {
  Plane_point point;
  Metric_tensor_2 metric;
  Metric_tensor_2 shape; // the metric scaled to determinant one: sums of shapes do not depend on sizes
  Vector_3d image;       // under the embedding, if there is one
  double scale = 1;      // the size aimed at, in the field's; `metric` is the field's over its square
};

/* A triangulation of the plane with the metric at its vertices, and the measures that the mesher decides by. Triangles
 * are judged under the embedding, or in the metric if that is null. */
class Metric_plane {
public:
  typedef Plane_store::Index Index;
  typedef Plane_node Node;

  Metric_plane(Plane_store store, const Plane_polygons& polygons, Plane_field field,
               const Plane_embedding* embedding = nullptr)
      : store(std::move(store))
      , field_(field)
      , embedding_(embedding) {
    for (const auto& polygon : polygons)
      for (const Plane_point& p : polygon)
        nodes.push_back(node_at(p));
    grade_from_boundary();
  }

  Plane_store store;
  std::vector<Node> nodes;

  bool is_embedded() const { return embedding_ != nullptr; }

  Node node_at(const Plane_point& p, double scale = 1) const {
    const Metric_tensor_2 m = metric_at(p);
    Node node;
    node.point = p;
    node.scale = scale;
    node.metric = 1 / (scale * scale) * m;
    node.shape = m.normalized();
    if (is_embedded())
      node.image = (*embedding_)(p);
    return node;
  }

  Metric_tensor_2 metric_at(const Plane_point& p) const {
    const Metric_tensor_2 m = field_(p);
    if (!m.is_positive_definite()) {
      std::ostringstream sentence;
      sentence.precision(17);
      sentence << "The metric at (" << p.x() << ", " << p.y() << ") is not symmetric positive definite: xx = " << m.xx
               << ", xy = " << m.xy << ", yy = " << m.yy << "; give positive, finite sizes everywhere in the domain.";
      throw Parameter_error(sentence.str());
    }
    return m;
  }

  const Node& origin(Index h) const { return nodes[store.origin(h)]; }
  const Node& target(Index h) const { return nodes[store.target(h)]; }
  const Node& apex(Index h) const { return nodes[store.apex(h)]; }

  // (10), sizes growing geometrically from end to end.
  static double length(const Node& p, const Node& q) {
    const Plane_vector e = q.point - p.point;
    return Metric_tensor_2::edge_length(e.x, e.y, p.metric, q.metric);
  }
  double length(Index h) const { return length(origin(h), target(h)); }

  // (10), with the metric in the middle asked for too: also sees what lies between the ends.
  double length_through(const Node& p, const Node& middle, const Node& q) const {
    return length(p, middle) + length(middle, q);
  }

  static bool is_positive(const Node& a, const Node& b, const Node& c) {
    return CGAL::orientation(a.point, b.point, c.point) == CGAL::LEFT_TURN;
  }

  // (12), of the true triangle in space if there is an embedding, else in the mean metric. Positive orientation is the
  // caller's business.
  double quality(const Node& a, const Node& b, const Node& c) const {
    if (is_embedded())
      return triangle_gamma(a.image, b.image, c.image);
    const Metric_tensor_2 m = a.shape + b.shape + c.shape;
    const Plane_vector u = b.point - a.point, v = c.point - a.point, w = c.point - b.point;
    const double lu = std::sqrt(dot(m, u, u)), lv = std::sqrt(dot(m, v, v)), lw = std::sqrt(dot(m, w, w));
    const double k = cross(u, v), product = lu * lv * lw;
    return product > 0 ? 4 * m.determinant() * k * k / (product * (lu + lv + lw)) : 0;
  }
  double quality(Index t) const { return quality(origin(3 * t), origin(3 * t + 1), origin(3 * t + 2)); }

  // The area in the metric of the corner where it is least: a bound from below in a triangle that reaches from small
  // sizes to large ones.
  double least_area(Index t) const {
    const Node &a = origin(3 * t), &b = origin(3 * t + 1), &c = origin(3 * t + 2);
    const double d = (std::min)({a.metric.determinant(), b.metric.determinant(), c.metric.determinant()});
    return cross(b.point - a.point, c.point - a.point) / 2 * std::sqrt(d);
  }

  // The circle through the corners of a triangle in metric m: from `a`, and its squared radius.
  struct Circle {
    Plane_vector to_center;
    double squared_radius;
  };
  static Circle circumcircle(const Metric_tensor_2& m, const Node& a, const Node& b, const Node& c) {
    const Plane_vector e = b.point - a.point, f = c.point - a.point;
    const double ee = dot(m, e, e), ff = dot(m, f, f), ef = dot(m, e, f), k = cross(e, f);
    const double gram = m.determinant() * k * k;
    const double s = ff * (ee - ef) / (2 * gram), t = ee * (ff - ef) / (2 * gram);
    return {{s * e.x + t * f.x, s * e.y + t * f.y}, s * s * ee + 2 * s * t * ef + t * t * ff};
  }

  double squared_circumradius(Index t) const {
    const Node &a = origin(3 * t), &b = origin(3 * t + 1), &c = origin(3 * t + 2);
    return circumcircle(1. / 3 * (a.metric + b.metric + c.metric), a, b, c).squared_radius;
  }

  // Does d lie in the circle through a, b, c, all in the mean shape of the four metrics?
  static bool is_in_circle(const Node& a, const Node& b, const Node& c, const Node& d) {
    // the angles at c and d over the edge ab: cot c + cot d < 0
    const Metric_tensor_2 m = a.shape + b.shape + c.shape + d.shape;
    const Plane_vector ca = a.point - c.point, cb = b.point - c.point, da = a.point - d.point, db = b.point - d.point;
    const double sin_c = cross(ca, cb), sin_d = cross(db, da);
    return dot(m, ca, cb) * sin_d + dot(m, da, db) * sin_c <
           -1e-12 * (std::abs(dot(m, ca, cb) * sin_d) + std::abs(dot(m, da, db) * sin_c));
  }

  // Would a new vertex x see the edge of h, on the boundary, under a good angle? A wide one makes a flat triangle that
  // no flip can repair.
  bool sees_at_good_angle(const Node& x, Index h) const {
    const Plane_vector u = origin(h).point - x.point, v = target(h).point - x.point;
    const Metric_tensor_2& m = x.metric;
    return dot(m, u, v) >= widest_angle_cosine * std::sqrt(dot(m, u, u) * dot(m, v, v));
  }

  // Where x would have to go, to first order, for |xa| and |xb| to become `side`, all lengths in the metric at both
  // their ends (one step of Newton's method). False if a, b and x are too flat for that.
  static bool step_to_apex(const Node& a, const Node& b, const Node& x, double side, Plane_vector& step) {
    const double la = length(a, x), lb = length(b, x);
    const Plane_vector u = length_gradient(a, x), v = length_gradient(b, x);
    const double d = cross(u, v);
    if (!(d * d > least_sine * least_sine * la * la * lb * lb * x.metric.determinant()))
      return false;
    const double ra = (side - la) * la, rb = (side - lb) * lb;
    step = {(ra * v.y - rb * u.y) / d, (u.x * rb - v.x * ra) / d};
    return true;
  }

  // May the edge of h be flipped: is its quadrilateral strictly convex?
  bool is_flippable(Index h) const {
    const Index g = store.twin(h);
    if (g == Plane_store::none)
      return false;
    const Node &a = origin(h), &b = target(h), &c = apex(h), &d = apex(g);
    return is_positive(a, d, c) && is_positive(d, b, c);
  }

  // Is the edge of h, which is flippable, Delaunay in the metric?
  bool is_locally_delaunay(Index h) const { return !is_in_circle(origin(h), target(h), apex(h), apex(store.twin(h))); }

  // What is alive; the points of the boundary come first, in their order.
  Plane_triangulation<Plane_point> triangulation() const {
    Plane_triangulation<Plane_point> result;
    std::vector<std::size_t> number(nodes.size());
    for (Index v = 0; v < nodes.size(); ++v)
      if (store.is_on_boundary(v) || store.is_vertex_alive(v)) {
        number[v] = result.points.size();
        result.points.push_back(nodes[v].point);
      }
    for (Index t = 0; t < store.number_of_triangles(); ++t)
      if (store.is_alive(t))
        result.triangles.push_back(
            {number[store.origin(3 * t)], number[store.origin(3 * t + 1)], number[store.origin(3 * t + 2)]});
    return result;
  }

private:
  // Where the boundary, which is kept, is finer than the metric asks for, the mesh starts at its size.
  void grade_from_boundary() {
    std::vector<double> length_sum(nodes.size(), 0);
    for (Index h = 0; h < 3 * store.number_of_triangles(); ++h)
      if (store.twin(h) == Plane_store::none) {
        const double l = length(h);
        length_sum[store.origin(h)] += l;
        length_sum[store.target(h)] += l;
      }
    for (Index v = 0; v < nodes.size(); ++v) {
      Node& node = nodes[v];
      node.scale = (std::min)(1., length_sum[v] / (2 * quasi_unit));
      node.metric = 1 / (node.scale * node.scale) * node.metric;
    }
  }

  static constexpr double quasi_unit = 0.8; // shorter boundary edges are meant to be short

  static constexpr double widest_angle_cosine = -0.22;
  static constexpr double least_sine = 0.3;

  // of half the squared length, by q
  static Plane_vector length_gradient(const Node& p, const Node& q) {
    const Metric_tensor_2 m = 0.5 * (p.metric + q.metric);
    const Plane_vector e = q.point - p.point;
    return {m.xx * e.x + m.xy * e.y, m.xy * e.x + m.yy * e.y};
  }

  const Plane_field field_;
  const Plane_embedding* const embedding_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PLANE_METRIC_PLANE_H
