// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_SMOOTH_WALL_H
#define CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_SMOOTH_WALL_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The smooth surface behind a surface of triangles.
 *
 * Over each triangle of the wall there is a cubic patch of Bezier, as PN triangles are (Vlachos, Peters, Boyd, Mitchell
 * 2001): its sides depend on the ends of the edge and the normals there alone, so that patches meet. Unlike those of PN
 * triangles, sides are as long as they have to be for an arc of a circle to come out as one, but for the sixth power of
 * its angle. Normals are those of the wall alone, not of the caps beyond a rim. A rim has a curve of its own, in the
 * plane of its opening, and the patches next to it end there.
 *
 * At a crease, and at the tip of a vessel that ends in a point, the normal of a vertex is the mean of normals that have
 * nothing in common. Sides that it does not fit would leave their edge there at a large angle, or at a much larger one
 * than at the other end, as no arc does. They are arcs by the normal at the other end, and straight where that does not
 * fit either, or where one end is such a tip: there the surface is that of the triangles. */
class Smooth_wall {
public:
  Smooth_wall(const Surface& surface, Face_patch_map patch, int threads) {
    add_vertices(surface, patch, threads);
    find_tips(surface, patch);
    add_rims(surface, patch);
    add_triangles(surface, patch);
  }

  struct Place {
    Vector_3d point, normal; // outward, of unit length
  };

  /* The point of the smooth wall that lies straight above or below x, no further than a bound, and where the wall faces
   * the same way as n; none where what is nearest is another part of the wall. */
  std::optional<Place> nearest(const Vector_3d& x, const Vector_3d& n, double bound) const {
    auto found = tree_.nearest(to_double_point(x), bound * bound);
    if (found.index >= tree_.size() || !(dot(patches_[found.index].flat_normal, n) > 0))
      return std::nullopt;
    Place place = at(found.index, Vector_3d(found.point));
    // the foot of the perpendicular: the footprint moves by what is left along the surface
    for (int round = 0; round < most_rounds; ++round) {
      const Vector_3d rest = x - place.point;
      const Vector_3d along = rest - dot(rest, place.normal) * place.normal;
      if (squared_norm(along) <= squared_tolerance * bound * bound)
        break;
      const Vector_3d footprint = Vector_3d(found.point) + along;
      const auto next = tree_.nearest_from(found.index, to_double_point(footprint), bound * bound);
      if (next.index >= tree_.size())
        break;
      const Place moved = at(next.index, Vector_3d(next.point));
      if (squared_norm(x - moved.point) > squared_norm(rest) * (1 + 1e-9))
        break;
      found = next;
      place = moved;
    }
    return place;
  }

  // The points that the wall comes to, each with its normal.
  const std::vector<Place>& tips() const { return tips_; }

  bool has_rim(int opening) const { return rims_.count(opening) != 0; }

  /* The point of the rim of an opening next to x, no further than a bound. */
  std::optional<Vector_3d> nearest_on_rim(int opening, const Vector_3d& x, double bound) const {
    const auto rim = rims_.find(opening);
    if (rim == rims_.end())
      return std::nullopt;
    auto found = rim->second.tree.nearest(to_double_point(x), bound * bound);
    if (found.index >= rim->second.tree.size())
      return std::nullopt;
    Vector_3d tangent, point = on_rim(rim->second, found, tangent);
    for (int round = 0; round < most_rounds; ++round) {
      const Vector_3d along = dot(x - point, tangent) * tangent;
      if (squared_norm(along) <= squared_tolerance * bound * bound)
        break;
      const auto next =
          rim->second.tree.nearest_from(found.index, to_double_point(Vector_3d(found.point) + along), bound * bound);
      if (next.index >= rim->second.tree.size())
        break;
      Vector_3d moved_tangent;
      const Vector_3d moved = on_rim(rim->second, next, moved_tangent);
      if (squared_norm(x - moved) > squared_norm(x - point) * (1 + 1e-9))
        break;
      found = next;
      point = moved;
      tangent = moved_tangent;
    }
    return point;
  }

private:
  static constexpr int most_rounds = 6;
  static constexpr double squared_tolerance = 1e-20;
  // Of the angle between an edge and the surface at its end: at most 40 degrees; and 15 where the other end has none,
  // which puts a side off its edge by a twenty-fifth of its length.
  static constexpr double least_cosine = 0.766, largest_sine = 0.643, sine_alone = 0.259;
  typedef std::uint32_t Index;

  struct Patch {
    std::array<Index, 3> corner;
    std::array<Vector_3d, 6> side; // of the edges 01, 12, 20, the control point next to each end
    Vector_3d flat_normal;
  };
  struct Curve {
    std::array<Vector_3d, 4> control;
  };
  struct Rim {
    Nearest_tree<Double_kernel::Segment_3> tree;
    std::vector<Curve> curves;
  };
  struct Rim_edge {
    Index from, to;
  };

  // --- normals ---

  void add_vertices(const Surface& surface, Face_patch_map patch, int threads) {
    points_.reserve(surface.number_of_vertices());
    std::vector<Surface::Vertex_index> vertices;
    number_.assign(surface.num_vertices(), 0);
    for (auto v : surface.vertices()) {
      number_[std::size_t(v)] = Index(points_.size());
      points_.emplace_back(surface.point(v));
      vertices.push_back(v);
    }
    normals_.resize(points_.size());
    for_each_range(points_.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        normals_[i] = wall_normal(surface, patch, vertices[i]);
    });
  }

  /* By the weights of Max (1999), which make it exact where a vertex and its neighbors lie on a sphere, whatever the
   * triangles are like. */
  static Vector_3d wall_normal(const Surface& surface, Face_patch_map patch, Surface::Vertex_index v) {
    Vector_3d sum;
    const Vector_3d p(surface.point(v));
    for (auto h : surface.halfedges_around_target(surface.halfedge(v))) {
      const auto f = surface.face(h);
      if (f == Surface::null_face() || patch[f] != labels::wall)
        continue;
      const Vector_3d before = Vector_3d(surface.point(surface.source(h))) - p;
      const Vector_3d after = Vector_3d(surface.point(surface.target(surface.next(h)))) - p;
      const double lengths = squared_norm(before) * squared_norm(after);
      if (lengths > 0)
        sum += (1 / lengths) * cross(after, before);
    }
    return normalized(sum);
  }

  // --- sides of patches ---

  /* The control point next to p of the side from p to q, which leaves p along the tangent. */
  static Vector_3d control(const Vector_3d& p, const Vector_3d& q, const Vector_3d& tangent) {
    const Vector_3d chord = q - p;
    const double length = norm(chord), cosine = length > 0 ? dot(tangent, chord) / length : 0;
    if (!(cosine >= least_cosine))
      return p + (1. / 3) * chord;
    return p + (2 * length / (3 * (1 + cosine))) * tangent;
  }

  // The sine of the angle between the surface at p and the edge to q, positive where the surface is convex.
  double fall(Index p, Index q) const {
    const Vector_3d chord = points_[q] - points_[p];
    const double length = norm(chord);
    return length > 0 ? -dot(chord, normals_[p]) / length : 0;
  }

  // Whether an edge that leaves the surface so at one end may leave it so at the other; on an arc it does alike.
  static bool fits(double sine, double other) {
    const double alike = (std::max)(0., sine > 0 ? other : -other);
    return std::abs(sine) <= (std::min)(largest_sine, sine_alone + 2 * alike);
  }

  Vector_3d control_by_normal(Index p, Index q) const {
    const double here = fall(p, q), there = fall(q, p);
    if (is_tip_[p] || is_tip_[q])
      return points_[p] + (1. / 3) * (points_[q] - points_[p]);
    if (fits(here, there))
      return control(points_[p], points_[q], tangent(p, q));
    const Vector_3d chord = points_[q] - points_[p], other = tangent(q, p);
    if (!fits(there, here) || !(squared_norm(chord) > 0))
      return points_[p] + (1. / 3) * chord;
    const Vector_3d mirrored = other - (2 * dot(other, chord) / squared_norm(chord)) * chord;
    return control(points_[p], points_[q], mirrored);
  }

  // Of the surface at p, towards q.
  Vector_3d tangent(Index p, Index q) const {
    const Vector_3d chord = points_[q] - points_[p];
    return normalized(chord - dot(chord, normals_[p]) * normals_[p]);
  }

  // Vertices whose normal fits hardly any of their edges: one along a crease fits its two sides of the crease.
  void find_tips(const Surface& surface, Face_patch_map patch) {
    const double most = 0.25;
    is_tip_.assign(points_.size(), 0);
    for (auto v : surface.vertices()) {
      const Index p = number_[std::size_t(v)];
      std::size_t edges = 0, fitting = 0;
      bool is_of_wall = true;
      for (auto h : surface.halfedges_around_target(surface.halfedge(v))) {
        const auto f = surface.face(h);
        is_of_wall = is_of_wall && f != Surface::null_face() && patch[f] == labels::wall;
        const Index q = number_[std::size_t(surface.source(h))];
        ++edges;
        fitting += fits(fall(p, q), fall(q, p)) ? 1 : 0;
      }
      if (!is_of_wall || double(fitting) > most * double(edges))
        continue;
      is_tip_[p] = 1;
      tips_.push_back({points_[p], normals_[p]});
    }
  }

  static std::pair<Index, Index> key(Index a, Index b) { return {(std::min)(a, b), (std::max)(a, b)}; }

  Vector_3d side_control(Index p, Index q) const {
    const auto rim = rim_curve_.find(key(p, q));
    if (rim == rim_curve_.end())
      return control_by_normal(p, q);
    return p < q ? rim->second.control[1] : rim->second.control[2];
  }

  // --- rims ---

  void add_rims(const Surface& surface, Face_patch_map patch) {
    std::map<int, std::vector<Rim_edge>> edges;
    for (auto h : surface.halfedges()) {
      const auto f = surface.face(h), g = surface.face(surface.opposite(h));
      if (f == Surface::null_face() || g == Surface::null_face() || patch[f] == labels::wall ||
          patch[g] != labels::wall)
        continue;
      edges[patch[f]].push_back({number_[std::size_t(surface.source(h))], number_[std::size_t(surface.target(h))]});
    }
    for (const auto& rim : edges)
      add_rim(rim.first, rim.second);
  }

  void add_rim(int opening, const std::vector<Rim_edge>& edges) {
    constexpr Index none = Index(-1);
    std::map<Index, std::array<Index, 2>> neighbors; // the one before and the one behind
    for (const Rim_edge& e : edges) {
      neighbors.emplace(e.from, std::array<Index, 2>{none, none});
      neighbors.emplace(e.to, std::array<Index, 2>{none, none});
    }
    for (const Rim_edge& e : edges) {
      neighbors[e.from][1] = e.to;
      neighbors[e.to][0] = e.from;
    }
    std::map<Index, Vector_3d> tangents;
    for (const auto& n : neighbors) {
      if (n.second[0] == none || n.second[1] == none)
        continue;
      // of the circle through the three
      const Vector_3d before = points_[n.first] - points_[n.second[0]], after = points_[n.second[1]] - points_[n.first];
      const double a = norm(before), b = norm(after);
      if (a > 0 && b > 0)
        tangents[n.first] = normalized((b / a) * before + (a / b) * after);
    }
    const auto tangent = [&](Index v) {
      const auto found = tangents.find(v);
      return found == tangents.end() ? Vector_3d() : found->second;
    };
    std::vector<Double_kernel::Segment_3> segments;
    Rim rim;
    for (const Rim_edge& e : edges) {
      const Vector_3d &p = points_[e.from], &q = points_[e.to];
      const Curve curve = {{p, control(p, q, tangent(e.from)), control(q, p, -1. * tangent(e.to)), q}};
      segments.emplace_back(to_double_point(p), to_double_point(q));
      rim.curves.push_back(curve);
      Curve ascending = curve;
      if (e.from > e.to)
        std::reverse(ascending.control.begin(), ascending.control.end());
      rim_curve_[key(e.from, e.to)] = ascending;
    }
    rim.tree = Nearest_tree<Double_kernel::Segment_3>(std::move(segments));
    rims_[opening] = std::move(rim);
  }

  template <class Found> static Vector_3d on_rim(const Rim& rim, const Found& found, Vector_3d& tangent) {
    const auto& c = rim.curves[found.index].control;
    const Vector_3d chord = c[3] - c[0];
    const double length2 = squared_norm(chord), along = dot(Vector_3d(found.point) - c[0], chord);
    const double t = length2 > 0 ? (std::min)((std::max)(along / length2, 0.), 1.) : 0;
    const double s = 1 - t;
    tangent = normalized(s * s * (c[1] - c[0]) + 2 * s * t * (c[2] - c[1]) + t * t * (c[3] - c[2]));
    return s * s * s * c[0] + 3 * s * s * t * c[1] + 3 * s * t * t * c[2] + t * t * t * c[3];
  }

  // --- patches ---

  void add_triangles(const Surface& surface, Face_patch_map patch) {
    std::vector<Double_kernel::Triangle_3> triangles;
    for (auto f : surface.faces()) {
      if (patch[f] != labels::wall)
        continue;
      const auto h = surface.halfedge(f);
      Patch p;
      p.corner = {number_[std::size_t(surface.target(h))], number_[std::size_t(surface.target(surface.next(h)))],
                  number_[std::size_t(surface.source(h))]};
      const Vector_3d &a = points_[p.corner[0]], &b = points_[p.corner[1]], &c = points_[p.corner[2]];
      p.flat_normal = normalized(cross(b - a, c - a));
      if (!(squared_norm(p.flat_normal) > 0))
        continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const Index from = p.corner[k], to = p.corner[(k + 1) % 3];
        p.side[2 * k] = side_control(from, to);
        p.side[2 * k + 1] = side_control(to, from);
      }
      patches_.push_back(p);
      triangles.emplace_back(to_double_point(a), to_double_point(b), to_double_point(c));
    }
    tree_ = Nearest_tree<Double_kernel::Triangle_3>(std::move(triangles));
  }

  // The patch over a point of its triangle.
  Place at(std::size_t index, const Vector_3d& point) const {
    const Patch& t = patches_[index];
    const Vector_3d &a = points_[t.corner[0]], &b = points_[t.corner[1]], &c = points_[t.corner[2]];
    const Vector_3d n = cross(b - a, c - a);
    const double area = squared_norm(n);
    const double u = dot(cross(c - b, point - b), n) / area, v = dot(cross(a - c, point - c), n) / area, w = 1 - u - v;
    Vector_3d sides;
    for (const Vector_3d& s : t.side)
      sides += s;
    const Vector_3d middle = 0.25 * sides + (-1. / 6) * (a + b + c);
    const auto& s = t.side;
    Place result;
    result.point = u * u * u * a + v * v * v * b + w * w * w * c + 3 * u * u * v * s[0] + 3 * u * v * v * s[1] +
                   3 * v * v * w * s[2] + 3 * v * w * w * s[3] + 3 * w * w * u * s[4] + 3 * w * u * u * s[5] +
                   6 * u * v * w * middle;
    // the control points' differences along the edges 01 and 02
    const Vector_3d along_1 = u * u * (s[0] - a) + v * v * (b - s[1]) + w * w * (s[3] - s[4]) +
                              2 * u * v * (s[1] - s[0]) + 2 * v * w * (s[2] - middle) + 2 * w * u * (middle - s[5]);
    const Vector_3d along_2 = u * u * (s[5] - a) + v * v * (s[2] - s[1]) + w * w * (c - s[4]) +
                              2 * u * v * (middle - s[0]) + 2 * v * w * (s[3] - middle) + 2 * w * u * (s[4] - s[5]);
    const Vector_3d normal = normalized(cross(along_1, along_2));
    result.normal = dot(normal, t.flat_normal) > 0 ? normal : t.flat_normal;
    return result;
  }

  std::vector<Vector_3d> points_, normals_;
  std::vector<char> is_tip_;
  std::vector<Place> tips_;
  std::vector<Index> number_;
  std::map<std::pair<Index, Index>, Curve> rim_curve_; // by the edge, from its lower vertex
  std::map<int, Rim> rims_;
  std::vector<Patch> patches_;
  Nearest_tree<Double_kernel::Triangle_3> tree_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_SMOOTH_WALL_H
