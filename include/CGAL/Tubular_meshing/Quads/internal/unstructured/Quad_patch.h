// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_QUAD_PATCH_H
#define CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_QUAD_PATCH_H

#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Sheet.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The quads of a patch while they are improved: its vertices, of which the first ones are on its loops and stay, and
 * its quads, counterclockwise; removed ones keep their number. */
class Quad_patch {
public:
  typedef std::array<int, 4> Quad;

  std::vector<Sheet_place> places;
  std::size_t on_loops = 0;
  std::vector<int> loop_valences; // how many quads there should be at each vertex on a loop
  std::vector<Quad> quads;
  std::vector<std::vector<int>> around; // the quads of each vertex, in no order

  bool is_fixed(int v) const { return std::size_t(v) < on_loops; }
  bool is_alive(int q) const { return quads[std::size_t(q)][0] >= 0; }
  const Quad& quad(int q) const { return quads[std::size_t(q)]; }
  const Vector_3d& point(int v) const { return places[std::size_t(v)].point; }
  const std::vector<int>& quads_at(int v) const { return around[std::size_t(v)]; }
  int valence(int v) const { return int(around[std::size_t(v)].size()); }

  int add_vertex(const Sheet_place& place) {
    places.push_back(place);
    around.emplace_back();
    return int(places.size()) - 1;
  }
  int add_quad(const Quad& q) {
    const int number = int(quads.size());
    quads.push_back(q);
    attach(number);
    return number;
  }
  /* A removed quad may come back in its place. */
  void remove_quad(int q) {
    for (int v : quad(q)) {
      std::vector<int>& list = around[std::size_t(v)];
      list.erase(std::find(list.begin(), list.end(), q));
    }
    quads[std::size_t(q)].fill(-1);
  }
  void restore_quad(int number, const Quad& q) {
    quads[std::size_t(number)] = q;
    attach(number);
  }
  // The last quads and vertices, which no quad uses any more, are forgotten.
  void shrink(std::size_t number_of_quads, std::size_t number_of_vertices) {
    quads.resize(number_of_quads);
    places.resize(number_of_vertices);
    around.resize(number_of_vertices);
  }

  /* Which corner of the quad a vertex is. */
  std::size_t corner(int q, int v) const {
    const Quad& c = quad(q);
    return std::size_t(std::find(c.begin(), c.end(), v) - c.begin());
  }
  int after(int q, int v) const { return quad(q)[(corner(q, v) + 1) % 4]; }
  int before(int q, int v) const { return quad(q)[(corner(q, v) + 3) % 4]; }
  int opposite(int q, int v) const { return quad(q)[(corner(q, v) + 2) % 4]; }

  /* The quad that has the edge from u to v, on its left; −1 if there is none. */
  int quad_left_of(int u, int v) const {
    for (int q : quads_at(u))
      if (after(q, u) == v)
        return q;
    return -1;
  }
  bool are_neighbours(int u, int v) const { return quad_left_of(u, v) >= 0 || quad_left_of(v, u) >= 0; }

  /* What a quad is worth: its η (14), or less if it is bent much along a diagonal, or has a side that is so short that it
   * is nearly a triangle, which angles do not show. Not positive if a corner of it turns the other way than the surface
   * does: the least sine, then, of an angle about the surface's normal. */
  double quality(int q) const {
    std::array<Vector_3d, 4> p, turns;
    double least_sine = 1, shortest = (std::numeric_limits<double>::infinity)(), longest = 0; // squared
    for (std::size_t k = 0; k < 4; ++k)
      p[k] = at(q, k).point;
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector_3d a = p[(k + 1) % 4] - p[k], b = p[(k + 3) % 4] - p[k];
      turns[k] = cross(a, b);
      const double side = squared_norm(a), lengths = std::sqrt(side * squared_norm(b));
      shortest = (std::min)(shortest, side);
      longest = (std::max)(longest, side);
      least_sine = (std::min)(least_sine, lengths > 0 ? dot(at(q, k).normal, turns[k]) / lengths : -1);
    }
    if (!(least_sine > 0))
      return least_sine;
    const double flat = (std::min)(cosine(turns[0], turns[2]), cosine(turns[1], turns[3]));
    return (std::min)({quad_eta(p), (std::max)(worth_if_bent_at_right_angle + flat, 0.01),
                       worth_of_ratio * std::sqrt(shortest / longest)});
  }

  double least_quality() const {
    double least = 1;
    for (int q = 0; q < int(quads.size()); ++q)
      if (is_alive(q))
        least = (std::min)(least, quality(q));
    return least;
  }

private:
  static constexpr double worth_if_bent_at_right_angle = 0.2, worth_of_ratio = 2; // of the shortest and longest side

  static double cosine(const Vector_3d& a, const Vector_3d& b) {
    const double lengths = std::sqrt(squared_norm(a) * squared_norm(b));
    return lengths > 0 ? dot(a, b) / lengths : -1;
  }
  const Sheet_place& at(int q, std::size_t k) const { return places[std::size_t(quad(q)[k % 4])]; }
  void attach(int number) {
    for (int v : quads[std::size_t(number)])
      around[std::size_t(v)].push_back(number);
  }
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_QUAD_PATCH_H
