// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PLANE_PLANE_STORE_H
#define CGAL_TUBULAR_MESHING_PLANE_PLANE_STORE_H

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The connectivity of a triangulated domain in compact arrays. Half-edge h = 3t + i runs counterclockwise along
 * triangle t and has a twin in the neighbour, or none on the boundary: hence no boundary edge can be flipped or
 * collapsed. The first vertices are those of the boundary, each on exactly one closed polygon; those inserted later are
 * inside. Geometry is not known here. */
class Plane_store {
public:
  typedef std::uint32_t Index;
  static constexpr Index none = Index(-1);

  // `twin_of_corner` follows `corners` slot by slot; the first `number_of_vertices` are on the boundary
  Plane_store(std::vector<Index> corners, std::vector<Index> twins, std::size_t number_of_vertices)
      : origin_(std::move(corners))
      , twin_(std::move(twins))
      , out_(number_of_vertices, none)
      , boundary_size_(Index(number_of_vertices)) {
    for (Index h = 0; h < origin_.size(); ++h)
      if (twin_[h] == none)
        out_[origin_[h]] = h;
  }

  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index prev(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  Index twin(Index h) const { return twin_[h]; }
  Index origin(Index h) const { return origin_[h]; }
  Index target(Index h) const { return origin_[next(h)]; }
  Index apex(Index h) const { return origin_[prev(h)]; } // the corner opposite to h

  std::size_t number_of_triangles() const { return origin_.size() / 3; } // dead ones included
  std::size_t number_of_vertices() const { return out_.size(); }
  Index boundary_size() const { return boundary_size_; }
  bool is_alive(Index t) const { return origin_[3 * t] != none; }
  bool is_vertex_alive(Index v) const { return out_[v] != none; }
  bool is_on_boundary(Index v) const { return v < boundary_size_; }

  // Calls f(h) for the half-edges that leave v, counterclockwise, from the boundary on if v is on it.
  template <class Function> void for_each_outgoing(Index v, const Function& f) const {
    const Index first = out_[v];
    Index h = first;
    do {
      const Index following = twin_[prev(h)];
      f(h);
      h = following;
    } while (h != first && h != none);
  }

  bool are_neighbors(Index v, Index w) const {
    bool found = false;
    for_each_outgoing(v, [&](Index h) { found = found || target(h) == w || apex(h) == w; });
    return found;
  }

  // a new vertex inside triangle t; the three triangles keep t's edges as their first half-edges
  Index insert_in_triangle(Index t) {
    const Index x = new_vertex(), h = 3 * t, s = new_triangle(), r = new_triangle();
    const Index a = origin_[h], b = origin_[h + 1], c = origin_[h + 2];
    const Index twin_bc = twin_[h + 1], twin_ca = twin_[h + 2];
    set_triangle(t, a, b, x);
    set_triangle(s, b, c, x);
    set_triangle(r, c, a, x);
    link(3 * s, twin_bc);
    link(3 * r, twin_ca);
    link(h + 1, 3 * s + 2);
    link(3 * s + 1, 3 * r + 2);
    link(3 * r + 1, h + 2);
    update_outgoing(h);
    update_outgoing(3 * s);
    update_outgoing(3 * r);
    out_[x] = h + 2;
    return x;
  }

  // a new vertex on the interior edge of h
  Index insert_on_edge(Index h) {
    const Index i = h % 3, s = Index(number_of_triangles());
    const Index x = insert_in_triangle(h / 3);
    flip(i == 0 ? h : 3 * (s + i - 1)); // away with the flat triangle
    return x;
  }

  // The edge of h becomes the other diagonal of its two triangles; h is then that diagonal.
  void flip(Index h) {
    const Index g = twin_[h];
    const Index h1 = next(h), h2 = prev(h), g1 = next(g), g2 = prev(g);
    const Index a = origin_[h], b = origin_[g], c = origin_[h2], d = origin_[g2];
    const Index bc = twin_[h1], ca = twin_[h2], ad = twin_[g1], db = twin_[g2];
    origin_[h] = d;
    origin_[h1] = c;
    origin_[h2] = a;
    origin_[g] = c;
    origin_[g1] = d;
    origin_[g2] = b;
    link(h1, ca);
    link(h2, ad);
    link(g1, db);
    link(g2, bc);
    for (Index k : {h1, h2, g1, g2})
      update_outgoing(k);
  }

  // May the origin of h, a vertex inside, be merged into its target without changing the topology?
  bool is_collapsible(Index h) const {
    const Index a = origin(h), b = target(h);
    if (is_on_boundary(a) || twin_[h] == none)
      return false;
    std::size_t common = 0;
    for_each_outgoing(a, [&](Index k) { common += target(k) != b && are_neighbors(b, target(k)); });
    return common == 2;
  }

  // Merges the origin of h into its target; the two triangles of the edge and the origin are dead afterwards.
  void collapse(Index h) {
    const Index g = twin_[h], a = origin(h), b = target(h);
    const Index left_outer = twin_[prev(h)], left_inner = twin_[next(h)];
    const Index right_outer = twin_[next(g)], right_inner = twin_[prev(g)];
    const Index c = apex(h), d = apex(g);
    for_each_outgoing(a, [&](Index k) { moved_.push_back(k); });
    for (Index k : moved_)
      origin_[k] = b;
    moved_.clear();
    kill(h / 3);
    kill(g / 3);
    out_[a] = none;
    link(left_outer, left_inner);
    link(right_inner, right_outer);
    for (Index v : {b, c, d})
      if (!is_on_boundary(v))
        out_[v] = none;
    for (Index k : {left_outer, left_inner, right_inner, right_outer})
      if (k != none) {
        update_outgoing(k);
        update_outgoing(next(k));
      }
  }

private:
  Index new_vertex() {
    out_.push_back(none);
    return Index(out_.size() - 1);
  }
  Index new_triangle() {
    origin_.resize(origin_.size() + 3, none);
    twin_.resize(origin_.size(), none);
    return Index(origin_.size() / 3 - 1);
  }
  void set_triangle(Index t, Index a, Index b, Index c) {
    origin_[3 * t] = a;
    origin_[3 * t + 1] = b;
    origin_[3 * t + 2] = c;
  }
  void link(Index h, Index g) {
    if (h != none)
      twin_[h] = g;
    if (g != none)
      twin_[g] = h;
  }
  // A vertex on the boundary starts with its boundary edge, so that its half-edges can be walked in one direction.
  void update_outgoing(Index h) {
    const Index v = origin_[h];
    if (!is_on_boundary(v) || twin_[h] == none)
      out_[v] = h;
  }
  void kill(Index t) {
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
      origin_[h] = twin_[h] = none;
  }

  std::vector<Index> origin_, twin_, out_;
  Index boundary_size_;
  std::vector<Index> moved_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PLANE_PLANE_STORE_H
