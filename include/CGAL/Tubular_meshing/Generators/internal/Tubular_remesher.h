// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_GENERATORS_INTERNAL_TUBULAR_REMESHER_H
#define CGAL_TUBULAR_MESHING_GENERATORS_INTERNAL_TUBULAR_REMESHER_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Generators/Tubular_distance_function.h>
#include <CGAL/Tubular_meshing/Generators/Tubular_skeleton.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <CGAL/number_type_config.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Isotropic remeshing of the zero surface of a Tubular_distance_function, to edges of 2 pi r / n: collapses, splits,
 * Delaunay flips, and tangential relaxation, each vertex being projected back onto the surface (compare M. Botsch, L.
 * Kobbelt, A remeshing approach to multiresolution modeling, 2004). Border loops lie on the circles of the skeleton's
 * ends and stay there. A pass is linear in the number of triangles, and costs about three evaluations a vertex. */
class Tubular_remesher {
public:
  typedef Tubular_skeleton::End End;

  Tubular_remesher(const Tubular_distance_function& function, const std::vector<End>& ends,
                   double points_per_circumference, Surface& mesh)
      : function_(function)
      , ends_(ends)
      , edge_over_radius_(2 * CGAL_PI / points_per_circumference)
      , mesh_(mesh) {
    normal_ = mesh.add_property_map<Vertex, Vector_3d>("v:tubular_normal").first;
    size_ = mesh.add_property_map<Vertex, double>("v:tubular_size", 0).first;
    end_ = mesh.add_property_map<Vertex, int>("v:tubular_end", -1).first;
    for (Vertex v : mesh.vertices())
      put(v, place_at(at(v), function_.evaluate(at(v))));
  }

  ~Tubular_remesher() {
    mesh_.remove_property_map(normal_);
    mesh_.remove_property_map(size_);
    mesh_.remove_property_map(end_);
  }

  Tubular_remesher(const Tubular_remesher&) = delete;
  Tubular_remesher& operator=(const Tubular_remesher&) = delete;

  /// Says that a border loop is the rim of an end, and moves its vertices onto that circle.
  void attach_border(Halfedge border, std::size_t end) {
    for (Halfedge h : CGAL::halfedges_around_face(border, mesh_)) {
      end_[mesh_.target(h)] = int(end);
      project(mesh_.target(h));
    }
  }

  void pass() {
    limit_growth_of_sizes();
    collapse_short_edges();
    split_long_edges();
    flip_edges();
    relax();
  }

  void clean_up_slivers() {
    limit_growth_of_sizes();
    collapse_short_edges();
    flip_edges();
  }

private:
  // --- the surface ---

  Vector_3d at(Vertex v) const { return Vector_3d(mesh_.point(v)); }

  // A point with what the function says there.
  struct Place {
    Vector_3d point, normal;
    double radius;
  };

  Place place_at(const Vector_3d& p, const Tubular_distance_function::Value& value) const {
    return {p, normalized(Vector_3d(value.gradient[0], value.gradient[1], value.gradient[2])), value.radius};
  }

  void put(Vertex v, const Place& place) {
    mesh_.point(v) = as<Point_3>(place.point);
    normal_[v] = place.normal;
    size_[v] = edge_over_radius_ * place.radius;
  }

  void project(Vertex v) { put(v, projection(at(v), end_[v])); }

  Place projection(const Vector_3d& p, int end) const { return end >= 0 ? onto_rim(p, end) : onto_surface(p); }

  // Newton's method; steps are limited, as what is far from the surface shall not leave the tube.
  Place onto_surface(Vector_3d p) const {
    for (int i = 0;; ++i) {
      const auto value = function_.evaluate(p);
      const Vector_3d g(value.gradient[0], value.gradient[1], value.gradient[2]);
      const double g2 = squared_norm(g);
      if (i == 8 || std::abs(value.value) < 1e-9 * value.radius || !(g2 > 1e-6))
        return place_at(p, value);
      const double step = (std::min)((std::max)(value.value / g2, -0.3 * value.radius), 0.3 * value.radius);
      p = p - step * g;
    }
  }

  Place onto_rim(const Vector_3d& p, int end) const {
    const End& e = ends_[std::size_t(end)];
    const Vector_3d center(e.center), n(e.normal);
    Vector_3d d = p - center;
    d = d - dot(d, n) * n;
    const Vector_3d on_rim = center + e.radius * normalized(d);
    return place_at(on_rim, function_.evaluate(on_rim));
  }

  double length(Edge e) const { return norm(at(mesh_.vertex(e, 0)) - at(mesh_.vertex(e, 1))); }
  double wanted_length(Edge e) const { return (std::min)(size_[mesh_.vertex(e, 0)], size_[mesh_.vertex(e, 1)]); }

  // So that a thin branch does not begin at a wide one within a single triangle.
  void limit_growth_of_sizes() {
    const double growth = 0.35; // a unit length
    for (int sweep = 0; sweep < 3; ++sweep)
      for (Edge e : mesh_.edges()) {
        double& a = size_[mesh_.vertex(e, 0)];
        double& b = size_[mesh_.vertex(e, 1)];
        const double most = growth * length(e);
        a = (std::min)(a, b + most);
        b = (std::min)(b, a + most);
      }
  }

  // --- collapses ---

  void collapse_short_edges() {
    const std::vector<Edge> edges(mesh_.edges().begin(), mesh_.edges().end());
    for (Edge e : edges)
      if (!mesh_.is_removed(e) && length(e) < 0.75 * wanted_length(e))
        collapse(e);
  }

  void collapse(Edge e) {
    Vertex a = mesh_.vertex(e, 0), b = mesh_.vertex(e, 1);
    const bool a_fixed = end_[a] >= 0, b_fixed = end_[b] >= 0;
    if ((a_fixed && b_fixed && !mesh_.is_border(e)) || !CGAL::Euler::does_satisfy_link_condition(e, mesh_))
      return;
    const int end = (std::max)(end_[a], end_[b]);
    if (mesh_.is_border(e) && loop_is_small(mesh_.halfedge(e)))
      return;
    const Vector_3d p = a_fixed == b_fixed ? 0.5 * (at(a) + at(b)) : a_fixed ? at(a) : at(b);
    const Place place = projection(p, end);
    if (!may_move_to(a, b, place.point) || !may_move_to(b, a, place.point) || makes_long_edges(a, place.point) ||
        makes_long_edges(b, place.point))
      return;
    const Vertex kept = CGAL::Euler::collapse_edge(e, mesh_);
    end_[kept] = end;
    put(kept, place);
  }

  bool loop_is_small(Halfedge h) const {
    const Halfedge border = mesh_.is_border(h) ? h : mesh_.opposite(h);
    return mesh_.next(mesh_.next(mesh_.next(mesh_.next(mesh_.next(mesh_.next(border)))))) == border;
  }

  bool makes_long_edges(Vertex v, const Vector_3d& p) const {
    for (Vertex a : CGAL::vertices_around_target(v, mesh_))
      if (norm(at(a) - p) > 1.35 * (std::max)(size_[a], size_[v]))
        return true;
    return false;
  }

  // Whether, with v at p, the triangles of v that do not have w face along the surface's normal and have some area, or
  // are better than before in this respect.
  bool may_move_to(Vertex v, Vertex w, const Vector_3d& p) const {
    double before = 1, after = 1;
    for (Halfedge h : CGAL::halfedges_around_target(mesh_.halfedge(v), mesh_)) {
      const Vertex a = mesh_.source(h), b = mesh_.target(mesh_.next(h));
      if (mesh_.is_border(h) || a == w || b == w)
        continue;
      const Vector_3d n = normalized(normal_[a] + normal_[b] + normal_[v]);
      before = (std::min)(before, shape_on_surface(at(v), at(b), at(a), n));
      after = (std::min)(after, shape_on_surface(p, at(b), at(a), n));
    }
    return after > 0.05 || after > before;
  }

  // Twice the area, seen along the normal, over the longest edge's square: 0.87 for an equilateral triangle.
  static double shape_on_surface(const Vector_3d& a, const Vector_3d& b, const Vector_3d& c, const Vector_3d& normal) {
    const double longest = (std::max)({squared_norm(b - a), squared_norm(c - b), squared_norm(a - c)});
    const Vector_3d area = cross(b - a, c - a);
    const double size = norm(area), cosine = size > 0 ? dot(area, normal) / size : 0;
    if (cosine < 0.3) // folded: the more so the worse, whatever the shape
      return cosine - 1;
    return size / longest;
  }

  // --- splits ---

  void split_long_edges() {
    const std::vector<Edge> edges(mesh_.edges().begin(), mesh_.edges().end());
    for (Edge e : edges)
      if (length(e) > 1.35 * wanted_length(e))
        split(e);
  }

  void split(Edge e) {
    const bool border = mesh_.is_border(e);
    const Vertex a = mesh_.vertex(e, 0), b = mesh_.vertex(e, 1);
    const Vector_3d middle = 0.5 * (at(a) + at(b));
    const Halfedge h = CGAL::Euler::split_edge(mesh_.halfedge(e), mesh_);
    const Vertex v = mesh_.target(h);
    end_[v] = border ? end_[a] : -1;
    for (Halfedge g : {h, mesh_.prev(mesh_.opposite(h))})
      if (!mesh_.is_border(g))
        CGAL::Euler::split_face(g, mesh_.next(mesh_.next(g)), mesh_);
    put(v, projection(middle, end_[v]));
  }

  // --- flips ---

  void flip_edges() {
    for (int sweep = 0; sweep < 2; ++sweep)
      for (Edge e : mesh_.edges())
        if (!mesh_.is_border(e) && is_flip_good(mesh_.halfedge(e)))
          CGAL::Euler::flip_edge(mesh_.halfedge(e), mesh_);
  }

  bool is_flip_good(Halfedge h) const {
    const Halfedge o = mesh_.opposite(h);
    const Vertex a = mesh_.source(h), b = mesh_.target(h), c = mesh_.target(mesh_.next(h)),
                 d = mesh_.target(mesh_.next(o));
    const Vector_3d pa = at(a), pb = at(b), pc = at(c), pd = at(d);
    if (cotangent(pc, pa, pb) + cotangent(pd, pa, pb) > -1e-6 || mesh_.halfedge(c, d) != Surface::null_halfedge() ||
        (end_[c] >= 0 && end_[d] >= 0))
      return false;
    const Vector_3d n = normal_[a] + normal_[b] + normal_[c] + normal_[d];
    const Vector_3d left = cross(pd - pa, pc - pa), right = cross(pc - pb, pd - pb);
    return dot(n, left) > 0.3 * norm(n) * norm(left) && dot(n, right) > 0.3 * norm(n) * norm(right);
  }

  // Of the angle at p between a and b.
  static double cotangent(const Vector_3d& p, const Vector_3d& a, const Vector_3d& b) {
    const double sine = norm(cross(a - p, b - p));
    return sine > 0 ? dot(a - p, b - p) / sine : 0;
  }

  // --- relaxation ---

  void relax() {
    for (Vertex v : mesh_.vertices()) {
      const Place place = end_[v] >= 0 ? relaxed_on_rim(v) : relaxed_inside(v);
      if (may_move_to(v, v, place.point))
        put(v, place);
      else
        project(v);
    }
  }

  Place relaxed_on_rim(Vertex v) const {
    Vector_3d sum;
    for (Halfedge h : CGAL::halfedges_around_target(mesh_.halfedge(v), mesh_))
      if (mesh_.is_border(mesh_.edge(h)))
        sum += at(mesh_.source(h));
    return onto_rim(0.5 * sum, end_[v]);
  }

  // Towards the centroid of the neighbouring triangles, large ones counting more, in the tangent plane.
  Place relaxed_inside(Vertex v) const {
    const Vector_3d p = at(v);
    Vector_3d sum;
    double weights = 0;
    for (Halfedge h : CGAL::halfedges_around_target(mesh_.halfedge(v), mesh_)) {
      const Vertex a = mesh_.source(h), b = mesh_.target(mesh_.next(h));
      const double s = (size_[a] + size_[b] + size_[v]);
      const double weight = norm(cross(at(a) - p, at(b) - p)) / (s * s * s);
      sum += (weight / 3) * (at(a) + at(b) + p);
      weights += weight;
    }
    Vector_3d step = (1 / weights) * sum - p;
    step = step - dot(step, normal_[v]) * normal_[v];
    return onto_surface(p + step);
  }

  const Tubular_distance_function& function_;
  const std::vector<End>& ends_;
  double edge_over_radius_;
  Surface& mesh_;
  Surface::Property_map<Vertex, Vector_3d> normal_;
  Surface::Property_map<Vertex, double> size_;
  Surface::Property_map<Vertex, int> end_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_GENERATORS_INTERNAL_TUBULAR_REMESHER_H
