// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_JUNCTION_PARTITION_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_JUNCTION_PARTITION_H

#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The sphere of directions round a junction, divided into one four-sided region a branch. Corners are directions; a side
 * leads from one to another between two branches, over its middle. */
struct Junction_partition {
  struct Side {
    std::size_t from, to;               // corners
    std::array<std::size_t, 2> regions; // the one on its left seen from outside, and the one on its right
    Vector_3d middle;
  };
  struct Region {
    std::array<std::size_t, 4> corners; // counterclockwise seen from outside
    std::array<std::size_t, 4> sides;   // side i from corner i to the next
    std::array<bool, 4> forward;        // whether the side is on the region's boundary as it is, not reversed
  };

  std::vector<Vector_3d> corners; // k + 2
  std::vector<Side> sides;        // 2 k
  std::vector<Region> regions;    // k

  // The number of regions that meet at a corner.
  std::size_t degree(std::size_t corner) const {
    return std::size_t(
        std::count_if(sides.begin(), sides.end(), [&](const Side& s) { return s.from == corner || s.to == corner; }));
  }
};

/* Divides the sphere so that each of k >= 2 directions has a region round it.
 *
 * The Voronoi regions of the directions are the normal cones of their convex hull. A region has as many sides as its
 * direction has edges on the hull; four are wanted. So each edge gets a multiplicity, with sum 4 at each direction: where
 * it is 0, the two faces beside it become one corner; where it is m, m - 1 corners are added on the side that they
 * share. For three directions, all edges count twice: the orange of two poles and three crotches. Of all the
 * multiplicities the ones are taken that give the regions most even angles.
 *
 * See P. Viville, P. Kraemer, D. Bechmann, Hexahedral mesh generation for tubular shapes using skeletons and connection
 * surfaces, 2021, who flip and merge edges for the same end. Exponential in
 * the number of edges: for up to eight directions or so. */
class Junction_partitioner {
public:
  explicit Junction_partitioner(const std::vector<Vector_3d>& directions)
      : directions_(directions) {
    if (directions.size() == 2)
      make_digon();
    else
      make_hull();
  }

  // None if no multiplicities will do.
  std::optional<Junction_partition> partition() {
    multiplicity_.assign(edges_.size(), 0);
    missing_.assign(directions_.size(), 4);
    last_edge_.assign(directions_.size(), 0);
    for (std::size_t e = 0; e < edges_.size(); ++e)
      for (std::size_t v : edges_[e].vertices)
        last_edge_[v] = e;
    best_cost_ = (std::numeric_limits<double>::infinity)();
    choose(0);
    return best_;
  }

private:
  // An edge of the hull, with the face on its left and the one on its right, seen from outside.
  struct Hull_edge {
    std::array<std::size_t, 2> vertices, faces;
  };
  typedef std::array<std::size_t, 3> Triangle;

  // Two directions: "faces" on both sides of the one edge are the same.
  void make_digon() {
    const Vector_3d axis = normalized(directions_[1] - directions_[0]);
    face_normals_ = {normalized(cross(axis, std::abs(axis.x) < 0.6 ? Vector_3d(1, 0, 0) : Vector_3d(0, 1, 0)))};
    edges_ = {{{{0, 1}}, {{0, 0}}}};
  }

  void make_hull() {
    const std::size_t k = directions_.size();
    std::vector<Triangle> triangles;
    if (k == 3)
      triangles = {{{0, 1, 2}}, {{0, 2, 1}}};
    else
      for (std::size_t a = 0; a < k; ++a)
        for (std::size_t b = a + 1; b < k; ++b)
          for (std::size_t c = b + 1; c < k; ++c)
            for (const Triangle& t : {Triangle{{a, b, c}}, Triangle{{a, c, b}}})
              if (is_outside(t))
                triangles.push_back(t);
    for (const Triangle& t : triangles)
      face_normals_.push_back(normal_of(t));
    for (std::size_t f = 0; f < triangles.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t a = triangles[f][i], b = triangles[f][(i + 1) % 3];
        if (a > b)
          continue;
        for (std::size_t g = 0; g < triangles.size(); ++g)
          for (std::size_t j = 0; j < 3; ++j)
            if (triangles[g][j] == b && triangles[g][(j + 1) % 3] == a)
              edges_.push_back({{{a, b}}, {{f, g}}});
      }
  }

  // Directions in one plane or on one circle would leave the hull undecided: each is moved by a little of its own.
  Vector_3d distinct(std::size_t i) const {
    const double t = double(i + 1);
    return directions_[i] + 1e-5 * Vector_3d(std::sin(1.3 * t), std::sin(2.9 * t + 1), std::sin(4.7 * t + 2));
  }
  bool is_outside(const Triangle& t) const {
    const Vector_3d o = distinct(t[0]), n = cross(distinct(t[1]) - o, distinct(t[2]) - o);
    for (std::size_t i = 0; i < directions_.size(); ++i)
      if (i != t[0] && i != t[1] && i != t[2] && dot(distinct(i) - o, n) >= 0)
        return false;
    return true;
  }
  Vector_3d normal_of(const Triangle& t) const {
    const Vector_3d o = distinct(t[0]);
    return normalized(cross(distinct(t[1]) - o, distinct(t[2]) - o));
  }

  void choose(std::size_t e) {
    if (e == edges_.size()) {
      evaluate();
      return;
    }
    const auto [a, b] = edges_[e].vertices;
    for (int m = 0; m <= 4; ++m) {
      if (m > missing_[a] || m > missing_[b])
        break;
      if ((last_edge_[a] == e && missing_[a] != m) || (last_edge_[b] == e && missing_[b] != m))
        continue;
      multiplicity_[e] = m;
      missing_[a] -= m;
      missing_[b] -= m;
      choose(e + 1);
      missing_[a] += m;
      missing_[b] += m;
    }
    multiplicity_[e] = 0;
  }

  void evaluate() {
    for (int m : missing_)
      if (m != 0)
        return;
    const std::optional<Junction_partition> p = made();
    if (!p)
      return;
    const double c = cost(*p);
    if (c < best_cost_) {
      best_cost_ = c;
      best_ = p;
    }
  }

  std::optional<Junction_partition> made() const {
    Junction_partition p;
    // faces with an edge of multiplicity 0 between them are one corner
    std::vector<std::size_t> group(face_normals_.size());
    std::iota(group.begin(), group.end(), std::size_t(0));
    const auto root = [&](std::size_t f) {
      while (group[f] != f)
        f = group[f];
      return f;
    };
    for (std::size_t e = 0; e < edges_.size(); ++e)
      if (multiplicity_[e] == 0) {
        const std::size_t f = root(edges_[e].faces[0]), g = root(edges_[e].faces[1]);
        if (f == g) // a ring of faces would be one corner
          return std::nullopt;
        group[(std::max)(f, g)] = (std::min)(f, g);
      }
    std::vector<std::size_t> corner_of(face_normals_.size());
    for (std::size_t f = 0; f < face_normals_.size(); ++f)
      if (root(f) == f) {
        Vector_3d sum;
        for (std::size_t g = 0; g < face_normals_.size(); ++g)
          if (root(g) == f) {
            sum += face_normals_[g];
            corner_of[g] = p.corners.size();
          }
        p.corners.push_back(normalized(sum));
      }
    for (std::size_t e = 0; e < edges_.size(); ++e)
      add_sides(e, corner_of, p);
    return add_regions(p) ? std::make_optional(p) : std::nullopt;
  }

  // The sides that an edge of the hull stands for, one after the other from its left face to its right one.
  void add_sides(std::size_t e, const std::vector<std::size_t>& corner_of, Junction_partition& p) const {
    const int m = multiplicity_[e];
    const auto [a, b] = edges_[e].vertices;
    const std::size_t first = corner_of[edges_[e].faces[0]], last = corner_of[edges_[e].faces[1]];
    const Vector_3d along = directions_[b] - directions_[a];
    const Vector_3d n = face_normals_[edges_[e].faces[0]], g = face_normals_[edges_[e].faces[1]];
    const Vector_3d out = normalized(cross(along, n));
    double angle = std::atan2(dot(g, out), dot(g, n));
    if (angle <= 0) // of two directions: all the way round
      angle += 2 * pi;
    const auto at = [&](double t) { return std::cos(t * angle) * n + std::sin(t * angle) * out; };
    std::size_t from = first;
    for (int i = 0; i < m; ++i) {
      std::size_t to = last;
      if (i + 1 < m) {
        to = p.corners.size();
        p.corners.push_back(at(double(i + 1) / m));
      }
      p.sides.push_back({from, to, {{b, a}}, at((i + 0.5) / m)});
      from = to;
    }
  }

  /* Links the sides of each region to a ring of four, counterclockwise. */
  bool add_regions(Junction_partition& p) const {
    for (std::size_t v = 0; v < directions_.size(); ++v) {
      std::vector<std::array<std::size_t, 3>> around; // from, to, side
      for (std::size_t s = 0; s < p.sides.size(); ++s) {
        if (p.sides[s].regions[0] == v)
          around.push_back({p.sides[s].from, p.sides[s].to, s});
        else if (p.sides[s].regions[1] == v)
          around.push_back({p.sides[s].to, p.sides[s].from, s});
      }
      if (around.size() != 4)
        return false;
      Junction_partition::Region r;
      std::size_t corner = around[0][0];
      for (std::size_t i = 0; i < 4; ++i) {
        std::size_t next = 4;
        for (std::size_t j = 0; j < 4; ++j)
          if (around[j][0] == corner)
            next = next == 4 ? j : 5;
        if (next > 3)
          return false;
        r.corners[i] = corner;
        r.sides[i] = around[next][2];
        r.forward[i] = p.sides[r.sides[i]].regions[0] == v;
        corner = around[next][1];
      }
      if (corner != r.corners[0])
        return false;
      p.regions.push_back(r);
    }
    return true;
  }

  /* How uneven the angles are at which a region's corners and middles lie round its direction. */
  double cost(const Junction_partition& p) const {
    double sum = 0;
    for (std::size_t v = 0; v < directions_.size(); ++v) {
      const Junction_partition::Region& r = p.regions[v];
      std::array<Vector_3d, 8> around;
      for (std::size_t i = 0; i < 4; ++i) {
        around[2 * i] = p.corners[r.corners[i]];
        around[2 * i + 1] = p.sides[r.sides[i]].middle;
      }
      const Vector_3d& d = directions_[v];
      for (std::size_t i = 0; i < 8; ++i) {
        const Vector_3d a = around[i], b = around[(i + 1) % 8];
        const double angle = std::atan2(dot(d, cross(a, b)), dot(a, b) - dot(a, d) * dot(b, d));
        const double gap = angle / (pi / 4);
        sum += gap > 0 ? (gap - 1) * (gap - 1) + 0.05 / (gap + 0.02) : 10 + gap * gap;
      }
    }
    return sum;
  }

  const std::vector<Vector_3d>& directions_;
  std::vector<Vector_3d> face_normals_;
  std::vector<Hull_edge> edges_;
  std::vector<int> multiplicity_, missing_;
  std::vector<std::size_t> last_edge_;
  std::optional<Junction_partition> best_;
  double best_cost_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_JUNCTION_PARTITION_H
