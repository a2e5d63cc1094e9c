// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_ONE_DEFECT_REMESHER_H
#define CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_ONE_DEFECT_REMESHER_H

#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Quad_exchange.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Quad_patch.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Clean-up across many quads: regions with corners at which they have one quad, and two at all other vertices of their
 * border, are meshed again with one irregular vertex, or with none: G. Bunin, *Non-local topological clean-up*, 15th
 * International Meshing Roundtable, 2006. They grow from each irregular vertex, row by row. */
class One_defect_remesher {
public:
  typedef Quad_patch::Quad Quad;
  typedef std::vector<int> Vertices;

  One_defect_remesher(Quad_patch& mesh, const Sheet_over_plane& sheet)
      : mesh_(mesh)
      , sheet_(sheet)
      , exchange_(mesh, sheet) {}

  // Whether something was done.
  bool run() {
    bool changed = false;
    for (int v = 0; v < int(mesh_.places.size()); ++v)
      for (int k = 0; k < 3 && exchange_.cost(v) > 0 && grow_from(v); ++k)
        changed = true;
    return changed;
  }

private:
  static constexpr std::size_t most_regions = 60; // from one vertex
  static constexpr std::size_t most_quads = 300;  // of a region
  static constexpr int most_trials = 4;           // that fail, from one vertex
  static constexpr int sweeps = 12;

  struct Region {
    std::vector<int> quads;
    std::vector<Vertices> sides; // counterclockwise; each from a corner to the next one, both included
    int cost = 0;                // of the vertices inside, and of those on loops
  };

  // The region with the highest cost goes on growing.
  bool grow_from(int v) {
    std::vector<Region> regions;
    std::set<std::uint64_t> seen;
    const auto push = [&](std::vector<int> quads) {
      Region region;
      region.quads = std::move(quads);
      if (make_convex(region) && seen.size() < most_regions && seen.insert(hash(region.quads)).second)
        regions.push_back(std::move(region));
    };
    push(mesh_.quads_at(v));
    for (int trials = 0; !regions.empty() && trials < most_trials;) {
      const auto best = std::max_element(regions.begin(), regions.end(),
                                         [](const Region& a, const Region& b) { return a.cost < b.cost; });
      std::swap(*best, regions.back());
      const Region region = std::move(regions.back());
      regions.pop_back();
      if (remesh(region, trials))
        return true;
      for (const Vertices& side : region.sides)
        push(with_row_beyond(region, side));
    }
    return false;
  }

  // Of a set, whatever the order.
  static std::uint64_t hash(const std::vector<int>& quads) {
    std::uint64_t sum = 0;
    for (int q : quads) {
      std::uint64_t x = (std::uint64_t(q) + 1) * 0x9e3779b97f4a7c15u;
      x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
      x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
      sum += x ^ (x >> 31);
    }
    return sum;
  }

  std::vector<int> with_row_beyond(const Region& region, const Vertices& side) const {
    std::vector<int> quads = region.quads;
    for (std::size_t i = 0; i + 1 < side.size(); ++i) {
      const int q = mesh_.quad_left_of(side[i + 1], side[i]);
      if (q >= 0 && std::find(quads.begin() + std::ptrdiff_t(region.quads.size()), quads.end(), q) == quads.end())
        quads.push_back(q);
    }
    return quads;
  }

  // Which quads are a region's, until the next call.
  void mark(const std::vector<int>& quads) {
    ++stamp_;
    marks_.resize(mesh_.quads.size(), 0);
    vertex_marks_.resize(mesh_.places.size(), 0);
    for (int q : quads)
      marks_[std::size_t(q)] = stamp_;
  }
  bool is_marked(int q) const { return q >= 0 && marks_[std::size_t(q)] == stamp_; }

  // The number of the marked quads at v, and whether they follow one another.
  std::pair<int, bool> quads_inside(int v) const {
    int n = 0, joints = 0;
    for (int q : mesh_.quads_at(v))
      n += is_marked(q);
    if (n == 1 || n == mesh_.valence(v))
      return {n, true};
    for (int q : mesh_.quads_at(v))
      joints += is_marked(q) && is_marked(mesh_.quad_left_of(v, mesh_.before(q, v)));
    return {n, joints + 1 >= n};
  }

  // Whether a vertex on a loop has all its quads inside: then it is to have as many as it should.
  bool is_free_on_loop(int v) const { return mesh_.is_fixed(v) && quads_inside(v).first == mesh_.valence(v); }
  bool is_corner(int v) const {
    return (is_free_on_loop(v) ? mesh_.loop_valences[std::size_t(v)] : quads_inside(v).first) == 1;
  }

  /* Adds quads until the border turns nowhere outward, and describes it. False if that is impossible, or no disk. */
  bool make_convex(Region& region) {
    std::vector<int>& quads = region.quads;
    mark(quads);
    for (std::size_t i = 0; i < quads.size(); ++i) // those added come in their turn
      for (int v : mesh_.quad(quads[i])) {
        const auto inside = quads_inside(v);
        if (inside.first == mesh_.valence(v)) {
          if (mesh_.is_fixed(v) && mesh_.loop_valences[std::size_t(v)] > 2)
            return false; // a loop that turns outward
        } else if (inside.first > 2 || !inside.second) {
          for (int q : mesh_.quads_at(v))
            if (!is_marked(q)) {
              marks_[std::size_t(q)] = stamp_;
              quads.push_back(q);
            }
          if (quads.size() > most_quads)
            return false;
        }
      }
    return describe_border(region);
  }

  bool describe_border(Region& region) {
    std::vector<std::pair<int, int>> border; // edges, by their first vertices
    Vertices vertices;
    for (int q : region.quads) {
      const Quad& c = mesh_.quad(q);
      for (std::size_t k = 0; k < 4; ++k) {
        const int v = c[k], w = c[(k + 1) % 4];
        if (vertex_marks_[std::size_t(v)] != stamp_) {
          vertex_marks_[std::size_t(v)] = stamp_;
          vertices.push_back(v);
        }
        if (!is_marked(mesh_.quad_left_of(w, v)))
          border.emplace_back(v, w);
      }
    }
    const std::size_t edges = (4 * region.quads.size() + border.size()) / 2;
    if (border.empty() || vertices.size() + region.quads.size() != edges + 1)
      return false;
    Vertices cycle;
    if (!walk(border, cycle))
      return false;
    std::size_t first = 0;
    while (first < cycle.size() && !is_corner(cycle[first]))
      ++first;
    if (first == cycle.size())
      return false; // no corner
    std::rotate(cycle.begin(), cycle.begin() + std::ptrdiff_t(first), cycle.end());
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      if (is_corner(cycle[i])) {
        if (i > 0)
          region.sides.back().push_back(cycle[i]);
        region.sides.emplace_back();
      }
      region.sides.back().push_back(cycle[i]);
    }
    region.sides.back().push_back(cycle[0]);
    for (int v : vertices)
      region.cost += exchange_.cost(v);
    for (int v : cycle)
      if (!is_free_on_loop(v))
        region.cost -= exchange_.cost(v);
    return true;
  }

  // The border's vertices in order. False if they are not one cycle.
  static bool walk(std::vector<std::pair<int, int>>& border, Vertices& cycle) {
    std::sort(border.begin(), border.end());
    for (std::size_t i = 1; i < border.size(); ++i)
      if (border[i].first == border[i - 1].first)
        return false;
    int v = border[0].first;
    do {
      cycle.push_back(v);
      v = std::lower_bound(border.begin(), border.end(), std::make_pair(v, -1))->second;
    } while (v != cycle[0] && cycle.size() <= border.size());
    return cycle.size() == border.size();
  }

  bool remesh(const Region& region, int& trials) {
    const std::size_t n = region.sides.size();
    if (n < 3 || n > 5 || exchange_.cost_inside(int(n)) >= region.cost)
      return false;
    const std::size_t first_new = mesh_.places.size();
    std::vector<Quad> added;
    if ((n == 4 && fill_grid(region, added)) || (n != 4 && fill_around_middle(region, added))) {
      ++trials;
      if (exchange_.apply(region.quads, added, first_new, sweeps))
        return true;
    } else {
      mesh_.shrink(mesh_.quads.size(), first_new);
    }
    return false;
  }

  static Vertices reversed(Vertices v) {
    std::reverse(v.begin(), v.end());
    return v;
  }

  bool fill_grid(const Region& region, std::vector<Quad>& added) {
    const auto& s = region.sides;
    return s[0].size() == s[2].size() && s[1].size() == s[3].size() &&
           fill_block(s[0], s[1], reversed(s[2]), reversed(s[3]), added);
  }

  /* Spokes from a vertex in the middle to a foot on each side: side i has as many edges as spokes i − 1 and i + 1. */
  bool fill_around_middle(const Region& region, std::vector<Quad>& added) {
    const auto& s = region.sides;
    const std::size_t n = s.size();
    std::vector<int> spokes(n);
    for (std::size_t i = 0; i < n; ++i) {
      // The alternating sum of sides i + 1, i + 3, …, once round: twice spoke i.
      int sum = 0;
      for (std::size_t k = 0; k < n; ++k)
        sum += (k % 2 == 0 ? 1 : -1) * (int(s[(i + 1 + 2 * k) % n].size()) - 1);
      if (sum < 2 || sum % 2 != 0)
        return false;
      spokes[i] = sum / 2;
    }
    Eigen::Vector2d center(0, 0);
    double weight = 0;
    for (const Vertices& side : s)
      for (std::size_t k = 0; k + 1 < side.size(); ++k) {
        center += mesh_.places[std::size_t(side[k])].uv;
        weight += 1;
      }
    const int middle = add_vertex(center / weight, s[0][0]);
    if (middle < 0)
      return false;
    std::vector<Vertices> spoke(n); // from the middle to the foot
    for (std::size_t i = 0; i < n; ++i) {
      const int foot = s[i][std::size_t(spokes[(i + n - 1) % n])];
      spoke[i].push_back(middle);
      for (int k = 1; k < spokes[i]; ++k) {
        const double t = double(k) / spokes[i];
        const int v = add_vertex((1 - t) * place(middle).uv + t * place(foot).uv, foot);
        if (v < 0)
          return false;
        spoke[i].push_back(v);
      }
      spoke[i].push_back(foot);
    }
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      const std::ptrdiff_t foot_i = spokes[(i + n - 1) % n], foot_j = spokes[i];
      if (!fill_block(Vertices(s[i].begin() + foot_i, s[i].end()), Vertices(s[j].begin(), s[j].begin() + foot_j + 1),
                      spoke[j], reversed(spoke[i]), added))
        return false;
    }
    return true;
  }

  const Sheet_place& place(int v) const { return mesh_.places[std::size_t(v)]; }
  int add_vertex(const Eigen::Vector2d& uv, int near) {
    Sheet_place at;
    return sheet_.place(uv, place(near).triangle, at) ? mesh_.add_vertex(at) : -1;
  }

  /* A grid between four sides, bottom and top from left to right, right and left upwards. */
  bool fill_block(const Vertices& bottom, const Vertices& right, const Vertices& top, const Vertices& left,
                  std::vector<Quad>& added) {
    const std::size_t m = bottom.size(), n = left.size();
    if (top.size() != m || right.size() != n)
      return false;
    std::vector<int> grid(m * n);
    const auto at = [&](std::size_t i, std::size_t j) -> int& { return grid[j * m + i]; };
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < m; ++i) {
        if (j == 0 || j + 1 == n || i == 0 || i + 1 == m) {
          at(i, j) = j == 0 ? bottom[i] : j + 1 == n ? top[i] : i == 0 ? left[j] : right[j];
          continue;
        }
        const double x = double(i) / double(m - 1), y = double(j) / double(n - 1);
        const Eigen::Vector2d uv = (1 - x) * place(left[j]).uv + x * place(right[j]).uv +
                                   (1 - y) * place(bottom[i]).uv + y * place(top[i]).uv -
                                   ((1 - x) * (1 - y) * place(bottom[0]).uv + x * (1 - y) * place(bottom[m - 1]).uv +
                                    (1 - x) * y * place(top[0]).uv + x * y * place(top[m - 1]).uv);
        if ((at(i, j) = add_vertex(uv, at(i, j - 1))) < 0)
          return false;
      }
    for (std::size_t j = 0; j + 1 < n; ++j)
      for (std::size_t i = 0; i + 1 < m; ++i)
        added.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}});
    return true;
  }

  Quad_patch& mesh_;
  const Sheet_over_plane& sheet_;
  Quad_exchange exchange_;
  std::vector<int> marks_, vertex_marks_; // of quads, and of vertices
  int stamp_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_ONE_DEFECT_REMESHER_H
