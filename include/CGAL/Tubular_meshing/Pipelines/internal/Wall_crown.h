// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_WALL_CROWN_H
#define CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_WALL_CROWN_H

#include <CGAL/Tubular_meshing/Patches/pieces/crossing_faces.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* One hexahedron on each of some quads of the wall, inward, for layers to be cut into, as the ring of a vessel's blocks
 * is. At the rim of these quads it continues the rings that are there; elsewhere it is as thick as these are, against
 * the mesh size, or thinner where the wall is bent. */
class Wall_crown {
public:
  typedef std::uint32_t Index;
  typedef std::array<Index, 4> Quad;

  /* `quads`: counterclockwise from outside. `inner_of_rim`: of each point of the rim, the end of its edge inward. */
  Wall_crown(Mixed_mesh& mesh, const std::vector<Quad>& quads, const std::map<Index, Index>& inner_of_rim,
             Length_function size)
      : mesh_(mesh)
      , inner_of_rim_(inner_of_rim) {
    number(quads);
    set_directions();
    set_heights(size);
  }

  /* Adds the hexahedra to the mesh; their inner quads are those that the wall's have become. `caps`: what closes these;
   * the two must not meet. */
  std::vector<Quad> add(const std::vector<Quad>& caps) {
    make_room(caps);
    std::vector<Index> inner(points_.size());
    for (std::size_t v = 0; v < points_.size(); ++v)
      if (is_rim_[v]) {
        inner[v] = inner_of_rim_.at(points_[v]);
      } else {
        inner[v] = Index(mesh_.points.size());
        mesh_.points.push_back(as<Point_3>(inner_place(v)));
      }
    std::vector<Quad> result;
    for (const Corners& q : quads_) {
      std::array<Index, 8> h;
      for (std::size_t i = 0; i < 4; ++i) {
        h[i] = inner[q[i]];
        h[i + 4] = points_[q[i]];
      }
      mesh_.hexahedra.push_back(h, labels::lumen);
      result.push_back({{h[0], h[1], h[2], h[3]}});
    }
    return result;
  }

private:
  typedef std::array<std::size_t, 4> Corners; // by own numbers

  void number(const std::vector<Quad>& quads) {
    std::unordered_map<Index, std::size_t> numbers;
    for (const Quad& q : quads) {
      Corners c;
      for (std::size_t i = 0; i < 4; ++i) {
        const auto [found, is_new] = numbers.emplace(q[i], points_.size());
        if (is_new) {
          points_.push_back(q[i]);
          is_rim_.push_back(inner_of_rim_.count(q[i]) > 0);
        }
        c[i] = found->second;
      }
      quads_.push_back(c);
    }
    corners_.resize(points_.size());
    for (std::size_t k = 0; k < quads_.size(); ++k)
      for (std::size_t i = 0; i < 4; ++i)
        corners_[quads_[k][i]].push_back({quads_[k][(i + 1) % 4], quads_[k][(i + 3) % 4]});
  }

  Vector_3d place(std::size_t v) const { return Vector_3d(mesh_.points[points_[v]]); }
  Vector_3d inner_place(std::size_t v) const {
    return is_rim_[v] ? Vector_3d(mesh_.points[inner_of_rim_.at(points_[v])]) : place(v) + height_[v] * direction_[v];
  }

  // --- directions ---

  struct Corner {
    std::size_t next, previous;
  };
  Vector_3d inward(std::size_t v, const Corner& c) const {
    return normalized(cross(place(c.previous) - place(v), place(c.next) - place(v)));
  }
  // The least cosine of a direction with the normals of the corners round a point.
  double visibility(std::size_t v, const Vector_3d& d) const {
    double least = 1;
    for (const Corner& c : corners_[v])
      least = (std::min)(least, dot(d, inward(v, c)));
    return least;
  }

  /* From all corners round a point they are seen as well as possible; then they are evened out, as far as they still
   * are. */
  void set_directions() {
    constexpr int steps = 60, sweeps = 5;
    constexpr double kept = 0.8; // of visibility
    direction_.resize(points_.size());
    std::vector<double> least(points_.size());
    for (std::size_t v = 0; v < points_.size(); ++v) {
      if (is_rim_[v]) {
        direction_[v] = normalized(inner_place(v) - place(v));
        continue;
      }
      Vector_3d d;
      for (const Corner& c : corners_[v])
        d += inward(v, c);
      d = normalized(d);
      direction_[v] = d;
      double best = visibility(v, d);
      for (int step = 1; step <= steps; ++step) {
        const Corner* worst = nullptr;
        for (const Corner& c : corners_[v])
          if (worst == nullptr || dot(d, inward(v, c)) < dot(d, inward(v, *worst)))
            worst = &c;
        d = normalized(d + (1. / (step + 1)) * (inward(v, *worst) - d));
        if (visibility(v, d) > best) {
          best = visibility(v, d);
          direction_[v] = d;
        }
      }
      least[v] = kept * best;
    }
    for (int sweep = 0; sweep < sweeps; ++sweep)
      for (std::size_t v = 0; v < points_.size(); ++v) {
        if (is_rim_[v])
          continue;
        Vector_3d mean;
        for (const Corner& c : corners_[v])
          mean += direction_[c.next] + direction_[c.previous];
        const Vector_3d d = normalized(direction_[v] + normalized(mean));
        if (visibility(v, d) > least[v])
          direction_[v] = d;
      }
  }

  // --- heights ---

  void set_heights(Length_function size) {
    height_.assign(points_.size(), 0);
    double sum = 0;
    std::size_t rim = 0;
    for (std::size_t v = 0; v < points_.size(); ++v)
      if (is_rim_[v]) {
        height_[v] = norm(inner_place(v) - place(v));
        sum += height_[v] / size(mesh_.points[points_[v]]);
        ++rim;
      }
    for (std::size_t v = 0; v < points_.size(); ++v)
      if (!is_rim_[v])
        height_[v] = sum / double(rim) * size(mesh_.points[points_[v]]);
    even_out();
  }

  // Lowers what is much higher than a neighbor.
  void even_out() {
    constexpr double steepest = 1.4;
    std::vector<std::size_t> low(points_.size());
    for (std::size_t v = 0; v < low.size(); ++v)
      low[v] = v;
    while (!low.empty()) {
      const std::size_t v = low.back();
      low.pop_back();
      for (const Corner& c : corners_[v])
        for (std::size_t w : {c.next, c.previous})
          if (!is_rim_[w] && height_[w] > 1.01 * steepest * height_[v]) {
            height_[w] = steepest * height_[v];
            low.push_back(w);
          }
    }
  }

  /* Lowers it where hexahedra are bad, and then where what is left inside meets itself. */
  void make_room(const std::vector<Quad>& caps) {
    constexpr int rounds = 40;
    constexpr double good = 0.2, fair = 0.03; // scaled Jacobians
    constexpr int rounds_for_shape = 12;
    for (int round = 0; round < rounds; ++round) {
      std::vector<std::size_t> bad = quads_worse_than(round < rounds_for_shape ? good : fair);
      if (bad.empty())
        bad = quads_that_meet(caps);
      if (bad.empty())
        return;
      constexpr double lower = 0.75;
      std::vector<char> is_lower(points_.size(), 0);
      for (std::size_t k : bad)
        for (std::size_t v : quads_[k])
          if (!is_rim_[v] && !is_lower[v]++)
            height_[v] *= lower;
      even_out();
    }
    throw Meshing_error("the wall is too sharply bent there for layers");
  }

  std::vector<std::size_t> quads_worse_than(double quality) const {
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < quads_.size(); ++k) {
      std::array<Vector_3d, 8> p;
      for (std::size_t i = 0; i < 4; ++i) {
        p[i] = inner_place(quads_[k][i]);
        p[i + 4] = place(quads_[k][i]);
      }
      if (!(scaled_jacobian<8>(p) > quality))
        result.push_back(k);
    }
    return result;
  }

  std::vector<std::size_t> quads_that_meet(const std::vector<Quad>& caps) const {
    Surface surface;
    std::unordered_map<Index, Vertex> vertex_of; // of points of the mesh
    std::vector<Vertex> inner(points_.size());
    for (std::size_t v = 0; v < points_.size(); ++v) {
      inner[v] = surface.add_vertex(as<Point_3>(inner_place(v)));
      if (is_rim_[v])
        vertex_of[inner_of_rim_.at(points_[v])] = inner[v];
    }
    for (const Corners& q : quads_)
      surface.add_face(inner[q[0]], inner[q[1]], inner[q[2]], inner[q[3]]);
    for (const Quad& q : caps) {
      std::array<Vertex, 4> c;
      for (std::size_t i = 0; i < 4; ++i) {
        const auto [found, is_new] = vertex_of.emplace(q[i], Vertex());
        if (is_new)
          found->second = surface.add_vertex(mesh_.points[q[i]]);
        c[i] = found->second;
      }
      surface.add_face(c);
    }
    std::vector<std::size_t> result;
    for (const auto& pair : crossing_faces(surface))
      for (Face f : {pair.first, pair.second})
        if (std::size_t(f) < quads_.size())
          result.push_back(std::size_t(f));
    return result;
  }

  Mixed_mesh& mesh_;
  const std::map<Index, Index>& inner_of_rim_;
  std::vector<Index> points_; // of the wall, the mesh's numbers
  std::vector<char> is_rim_;
  std::vector<Corners> quads_;
  std::vector<std::vector<Corner>> corners_;
  std::vector<Vector_3d> direction_;
  std::vector<double> height_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_WALL_CROWN_H
