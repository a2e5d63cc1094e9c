// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_QUAD_CLEANER_H
#define CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_QUAD_CLEANER_H

#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Quad_exchange.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Quad_patch.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Local clean-up: what a few quads can do for the vertices around. Doublets, two quads that share two edges, become
 * one; a diamond, a quad between two vertices with too few quads, goes; edges turn within their two quads; vertices
 * with too many quads become two. All as long as vertices become more regular. */
class Quad_cleaner {
public:
  typedef Quad_patch::Quad Quad;

  Quad_cleaner(Quad_patch& mesh, const Sheet_over_plane& sheet)
      : mesh_(mesh)
      , sheet_(sheet)
      , exchange_(mesh, sheet) {}

  // Whether something was done.
  bool run() {
    const int most_rounds = 10;
    bool changed = false, changes = true;
    for (int round = 0; round < most_rounds && changes; ++round) {
      changes = false;
      for (int v = 0; v < int(mesh_.places.size()); ++v)
        if (exchange_.cost(v) > 0)
          changes = improve(v) || changes;
      changed = changed || changes;
    }
    return changed;
  }

private:
  static constexpr int sweeps = 4;

  bool improve(int v) {
    if (!mesh_.is_fixed(v) && mesh_.valence(v) == 2)
      return remove_doublet(v);
    const std::vector<int> quads = mesh_.quads_at(v); // which an exchange changes
    for (int q : quads)
      if (collapse(q, 0) || collapse(q, 1))
        return true;
    for (int q : quads)
      for (std::size_t k = 0; k < 4; ++k)
        if (turn(mesh_.quad(q)[k], mesh_.quad(q)[(k + 1) % 4], 0) ||
            turn(mesh_.quad(q)[k], mesh_.quad(q)[(k + 1) % 4], 1))
          return true;
    return !mesh_.is_fixed(v) && mesh_.valence(v) > 4 && open(v);
  }

  int change(int v, int by) const { return exchange_.cost(v, mesh_.valence(v) + by) - exchange_.cost(v); }

  bool remove_doublet(int v) {
    const int p = mesh_.quads_at(v)[0], q = mesh_.quads_at(v)[1];
    if (mesh_.after(p, v) != mesh_.before(q, v) || mesh_.after(q, v) != mesh_.before(p, v))
      return false;
    return exchange_.apply({p, q},
                           {{{mesh_.after(p, v), mesh_.opposite(p, v), mesh_.before(p, v), mesh_.opposite(q, v)}}},
                           mesh_.places.size(), sweeps);
  }

  // Merges corner k of a quad and the opposite one.
  bool collapse(int q, std::size_t k) {
    if (!mesh_.is_alive(q))
      return false;
    const Quad c = mesh_.quad(q);
    int kept = c[k], gone = c[k + 2];
    const int b = c[k + 1], d = c[(k + 3) % 4];
    if (mesh_.is_fixed(gone))
      std::swap(kept, gone);
    if (mesh_.is_fixed(gone))
      return false;
    const int merged = mesh_.valence(kept) + mesh_.valence(gone) - 2;
    if (exchange_.cost(kept, merged) - exchange_.cost(kept) - exchange_.cost(gone) + change(b, -1) + change(d, -1) >= 0)
      return false;
    std::vector<int> removed = mesh_.quads_at(gone);
    std::vector<Quad> added;
    for (int other : removed) {
      if (other == q)
        continue;
      Quad fresh = mesh_.quad(other);
      for (int& v : fresh) {
        if (v == kept)
          return false; // another quad between the two
        v = v == gone ? kept : v;
      }
      added.push_back(fresh);
    }
    return exchange_.apply(removed, added, mesh_.places.size(), sweeps);
  }

  // The edge uv becomes the next diagonal of the hexagon of its two quads, in one direction or the other.
  bool turn(int u, int v, int direction) {
    const int p = mesh_.quad_left_of(u, v), q = mesh_.quad_left_of(v, u);
    if (p < 0 || q < 0)
      return false;
    const int a = mesh_.after(p, v), b = mesh_.after(p, a), c = mesh_.after(q, u), d = mesh_.after(q, c);
    const int e = direction == 0 ? a : b, f = direction == 0 ? c : d; // the ends of the new edge
    if (change(u, -1) + change(v, -1) + change(e, 1) + change(f, 1) >= 0 || mesh_.are_neighbours(e, f) || e == f)
      return false;
    const std::vector<Quad> added = direction == 0 ? std::vector<Quad>{{{a, b, u, c}}, {{c, d, v, a}}}
                                                   : std::vector<Quad>{{{b, u, c, d}}, {{d, v, a, b}}};
    return exchange_.apply({p, q}, added, mesh_.places.size(), sweeps);
  }

  // The quads at a vertex inside, counterclockwise.
  std::vector<int> ring(int v) const {
    std::vector<int> result(1, mesh_.quads_at(v)[0]);
    while (int(result.size()) < mesh_.valence(v)) {
      const int next = mesh_.quad_left_of(v, mesh_.before(result.back(), v));
      if (next < 0)
        break;
      result.push_back(next);
    }
    return result;
  }

  /* A vertex becomes two, with a new quad between them and two of its neighbours. */
  bool open(int v) {
    const std::vector<int> around = ring(v);
    const int n = int(around.size());
    if (n != mesh_.valence(v))
      return false;
    for (int i = 0; i < n; ++i)
      for (int k = 2; k + 2 <= n; ++k) {
        const int x = mesh_.after(around[std::size_t(i)], v), y = mesh_.after(around[std::size_t((i + k) % n)], v);
        if (change(x, 1) + change(y, 1) + change(v, 1 - k) + 2 * (k - 3) * (k - 3) >= 0)
          continue;
        std::vector<int> removed;
        Eigen::Vector2d sum(0, 0);
        for (int j = i; j < i + k; ++j) {
          removed.push_back(around[std::size_t(j % n)]);
          sum += mesh_.places[std::size_t(mesh_.opposite(removed.back(), v))].uv;
        }
        const Sheet_place& at = mesh_.places[std::size_t(v)];
        Sheet_place place;
        const std::size_t first_new = mesh_.places.size();
        if (!sheet_.place(0.7 * at.uv + 0.3 / k * sum, at.triangle, place))
          continue;
        const int w = mesh_.add_vertex(place);
        std::vector<Quad> added(1, {{v, x, w, y}});
        for (int q : removed) {
          Quad fresh = mesh_.quad(q);
          std::replace(fresh.begin(), fresh.end(), v, w);
          added.push_back(fresh);
        }
        if (exchange_.apply(removed, added, first_new, sweeps))
          return true;
      }
    return false;
  }

  Quad_patch& mesh_;
  const Sheet_over_plane& sheet_;
  Quad_exchange exchange_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_QUAD_CLEANER_H
