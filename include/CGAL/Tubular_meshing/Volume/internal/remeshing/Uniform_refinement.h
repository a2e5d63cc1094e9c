// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_UNIFORM_REFINEMENT_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_UNIFORM_REFINEMENT_H

#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Metric_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Splits all edges of a mesh at once: each tetrahedron becomes eight, four at its corners, and four of the octahedron
 * between them, around the diagonal that gives the best of the worst shapes. A mesh that fits the metric at twice the
 * unit length becomes one that nearly fits it, for a hundredth of what single splits take.
 *
 * New vertices go to the middle of their edge in the metric, those on the surface to the nearest point there; those
 * inside follow where the surface is near, so that layers along a curved one keep their heights. Where that would
 * spoil a tetrahedron, its new vertices stay nearer to the middles of the straight edges, where nothing can be inverted.
 * O(n log n) in the number of tetrahedra, on all threads; the result does not depend on their number. */
class Uniform_refinement {
public:
  typedef Tetrahedron_store Store;
  typedef Store::Index Index;

  // The mesh has to be renumbered: all tetrahedra are alive.
  explicit Uniform_refinement(Metric_mesh& mesh)
      : mesh_(mesh)
      , store_(mesh.store)
      , old_vertices_(store_.number_of_vertices()) {}

  void run() {
    number_edges();
    locate_edges();
    place_vertices();
    keep_shapes();
    for (const New_vertex& v : new_)
      mesh_.add_vertex(v.at, v.location, v.location.dimension < 3 && v.part == 1);
    store_.assign(children());
  }

private:
  static constexpr double fair = 0.2, kept = 0.7;

  struct New_vertex {
    Index a, b; // the ends of its edge, a < b
    Surface_location location;
    Vector_3d straight, shift;
    double part;
    Metric_point at;
  };
  typedef std::array<Index, 6> Middles; // 01 02 03 12 13 23

  static int edge(int i, int j) {
    static const int number[4][4] = {{-1, 0, 1, 2}, {0, -1, 3, 4}, {1, 3, -1, 5}, {2, 4, 5, -1}};
    return number[i][j];
  }

  void number_edges() {
    struct End {
      Index b, place;
    };
    const Index n = store_.number_of_slots();
    std::vector<std::size_t> begin(old_vertices_ + 1, 0);
    const auto for_each_edge = [&](const auto& visit) {
      for (Index t = 0; t < n; ++t)
        for (int i = 0; i < 4; ++i)
          for (int j = i + 1; j < 4; ++j) {
            const auto ends = std::minmax(store_[t].v[i], store_[t].v[j]);
            visit(ends.first, ends.second, 6 * t + Index(edge(i, j)));
          }
    };
    for_each_edge([&](Index a, Index, Index) { ++begin[a + 1]; });
    for (Index v = 0; v < old_vertices_; ++v)
      begin[v + 1] += begin[v];
    std::vector<End> ends(begin.back());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for_each_edge([&](Index a, Index b, Index place) { ends[next[a]++] = {b, place}; });
    for_each_range(old_vertices_, mesh_.threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v)
        std::sort(ends.begin() + std::ptrdiff_t(begin[v]), ends.begin() + std::ptrdiff_t(begin[v + 1]),
                  [](const End& x, const End& y) { return x.b < y.b || (x.b == y.b && x.place < y.place); });
    });
    middles_.resize(n);
    first_edge_.assign(old_vertices_ + 1, 0);
    for (Index a = 0; a < old_vertices_; ++a) {
      for (std::size_t k = begin[a]; k < begin[a + 1]; ++k) {
        if (k == begin[a] || ends[k].b != ends[k - 1].b)
          new_.push_back({a, ends[k].b, {}, {}, {}, 1, {}});
        middles_[ends[k].place / 6][ends[k].place % 6] = Index(new_.size() - 1);
      }
      first_edge_[a + 1] = new_.size();
    }
  }

  void locate_edges() {
    store_.for_each_labelled_edge([&](const auto& ends, const std::vector<std::int32_t>& patches) {
      const auto at = std::lower_bound(new_.begin() + std::ptrdiff_t(first_edge_[ends.first]),
                                       new_.begin() + std::ptrdiff_t(first_edge_[ends.first + 1]), ends.second,
                                       [](const New_vertex& v, Index b) { return v.b < b; });
      at->location = mesh_.locations.of_patches(patches);
    });
  }

  void place_vertices() {
    std::vector<double> distance(old_vertices_, 0.);
    for_each_range(old_vertices_, mesh_.threads, [&](std::size_t first, std::size_t last) {
      Vector_3d nearest;
      for (std::size_t v = first; v < last; ++v)
        distance[v] = mesh_.projection.distance(store_.point(Index(v)), 1e300, nearest);
    });
    for_each_range(new_.size(), mesh_.threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) {
        New_vertex& v = new_[k];
        const Metric_point a = mesh_.at(v.a), b = mesh_.at(v.b);
        const Vector_3d e = b.position - a.position;
        v.straight = a.position + 0.5 * e;
        const double s = metric_middle(a, b);
        const Vector_3d middle = a.position + s * e;
        const double wanted = (1 - s) * distance[v.a] + s * distance[v.b];
        const Vector_3d to = mesh_.project(follow(middle, norm(e), wanted), v.location);
        v.shift = to - v.straight;
        v.at = mesh_.at(to);
      }
    });
  }

  // Where a point inside, in the middle of an edge of this length, has that distance from the surface.
  Vector_3d follow(const Vector_3d& p, double length, double wanted) const {
    Vector_3d q;
    const double d = mesh_.projection.distance(p, length, q);
    if (!(d < length) || d <= 1e-6 * length)
      return p;
    const double x = d / length, share = (1 - x) * (1 - x) * (1 + 2 * x);
    return p + share * (wanted / d - 1) * (p - q);
  }

  const Metric_point& at(Index middle) const { return new_[middle].at; }

  typedef std::array<Metric_point, 10> Points; // corners, middles
  Points points(Index t) const {
    Points p;
    for (std::size_t i = 0; i < 4; ++i)
      p[i] = mesh_.at(store_[t].v[i]);
    for (std::size_t e = 0; e < 6; ++e)
      p[4 + e] = at(middles_[t][e]);
    return p;
  }
  static double quality(const Metric_point& a, const Metric_point& b, const Metric_point& c, const Metric_point& d) {
    return is_positive(a.position, b.position, c.position, d.position) ? metric_quality(a, b, c, d) : 0;
  }
  // i, j, k, l of the diagonal from the middle of ij to that of kl, even.
  static const std::array<int, 4>& diagonal(int d) {
    static const std::array<std::array<int, 4>, 3> corners = {{{{0, 1, 2, 3}}, {{0, 2, 3, 1}}, {{0, 3, 1, 2}}}};
    return corners[std::size_t(d)];
  }
  // The middles around a diagonal.
  static std::array<int, 4> around(const std::array<int, 4>& c) {
    return {edge(c[0], c[2]), edge(c[0], c[3]), edge(c[1], c[3]), edge(c[1], c[2])};
  }

  double worst_at_corners(const Points& p) const {
    double worst = 1;
    for (int i = 0; i < 4; ++i) {
      std::array<std::size_t, 4> c;
      for (int j = 0; j < 4; ++j)
        c[std::size_t(j)] = std::size_t(j == i ? i : 4 + edge(i, j));
      worst = (std::min)(worst, quality(p[c[0]], p[c[1]], p[c[2]], p[c[3]]));
    }
    return worst;
  }
  double worst_around(const Points& p, int d) const {
    const auto& c = diagonal(d);
    const auto ring = around(c);
    double worst = 1;
    for (std::size_t q = 0; q < 4; ++q)
      worst = (std::min)(worst, quality(p[std::size_t(4 + edge(c[0], c[1]))], p[std::size_t(4 + edge(c[2], c[3]))],
                                        p[std::size_t(4 + ring[q])], p[std::size_t(4 + ring[(q + 1) % 4])]));
    return worst;
  }

  double best_diagonal(Index t, int& best) const {
    const Points p = points(t);
    double worst = -1;
    for (int d = 0; d < 3; ++d) {
      const double q = worst_around(p, d);
      if (q > worst) {
        worst = q;
        best = d;
      }
    }
    return (std::min)(worst, worst_at_corners(p));
  }

  void keep_shapes() {
    const Index n = store_.number_of_slots();
    diagonal_.assign(n, 0);
    std::vector<char> at_fault(n, 1), moved(new_.size(), 1);
    for (bool any = true; any;) {
      for_each_range(n, mesh_.threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t t = first; t < last; ++t) {
          const auto& m = middles_[t];
          if (std::none_of(m.begin(), m.end(), [&](Index k) { return moved[k] != 0; })) {
            at_fault[t] = 0;
            continue;
          }
          int d = 0;
          const double q = best_diagonal(Index(t), d);
          diagonal_[t] = std::uint8_t(d);
          at_fault[t] = q < fair && q < kept * mesh_.shape(store_[Index(t)].v).quality();
        }
      });
      std::fill(moved.begin(), moved.end(), char(0));
      any = false;
      for (Index t = 0; t < n; ++t)
        if (at_fault[t])
          for (Index k : middles_[t])
            moved[k] = new_[k].part > 0;
      for_each_range(new_.size(), mesh_.threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k)
          if (moved[k]) {
            New_vertex& v = new_[k];
            v.part = v.part > 0.2 ? v.part / 2 : 0;
            v.at = mesh_.at(v.straight + v.part * v.shift);
          }
      });
      any = std::find(moved.begin(), moved.end(), 1) != moved.end();
    }
  }

  std::vector<Store::Tetrahedron> children() const {
    const Index n = store_.number_of_slots();
    std::vector<Store::Tetrahedron> result(8 * std::size_t(n));
    for_each_range(n, mesh_.threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t)
        put_children(Index(t), result.data());
    });
    return result;
  }

  // The child in the middle of facet i of t, and which of its facets lies there.
  Index middle_facet(Index t, int i) const {
    static const int child[4] = {2, 0, 1, 3}, corner[4] = {0, 0, 1, 1}; // of facets i, j, k, l, see put_children()
    const auto& c = diagonal(diagonal_[t]);
    const std::size_t k = std::size_t(std::find(c.begin(), c.end(), i) - c.begin());
    return Store::facet(8 * t + 4 + Index(child[k]), corner[k]);
  }

  void put_children(Index t, Store::Tetrahedron* all) const {
    const Store::Tetrahedron& parent = store_[t];
    const auto middle = [&](int i, int j) { return old_vertices_ + middles_[t][std::size_t(edge(i, j))]; };
    const auto link = [&](Index f, Index g) {
      all[Store::tetrahedron_of(f)].neighbor[std::size_t(Store::opposite_of(f))] = g;
      all[Store::tetrahedron_of(g)].neighbor[std::size_t(Store::opposite_of(g))] = f;
    };
    for (Index k = 8 * t; k < 8 * t + 8; ++k)
      all[k] = {{}, {Store::none, Store::none, Store::none, Store::none}, {0, 0, 0, 0}, parent.region};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        all[8 * t + Index(i)].v[std::size_t(j)] = j == i ? parent.v[std::size_t(i)] : middle(i, j);
    const auto& c = diagonal(diagonal_[t]);
    const std::array<Index, 4> ring = {middle(c[0], c[2]), middle(c[0], c[3]), middle(c[1], c[3]), middle(c[1], c[2])};
    const Index inner = 8 * t + 4;
    for (Index q = 0; q < 4; ++q) {
      all[inner + q].v = {middle(c[0], c[1]), middle(c[2], c[3]), ring[q], ring[(q + 1) % 4]};
      // the corner that the two middles of the ring share, and where the facet towards it is
      static const int corner[4] = {0, 3, 1, 2}, facet[4] = {1, 0, 1, 0};
      link(Store::facet(inner + q, 2), Store::facet(inner + (q + 1) % 4, 3));
      link(Store::facet(inner + q, facet[q]),
           Store::facet(8 * t + Index(c[std::size_t(corner[q])]), c[std::size_t(corner[q])]));
    }
    for (int i = 0; i < 4; ++i) {
      const Index other = parent.neighbor[std::size_t(i)];
      const std::int32_t label = parent.label[std::size_t(i)];
      const auto put = [&](Index f, Index g) {
        all[Store::tetrahedron_of(f)].neighbor[std::size_t(Store::opposite_of(f))] = g;
        all[Store::tetrahedron_of(f)].label[std::size_t(Store::opposite_of(f))] = label;
      };
      const Index behind = other == Store::none ? Store::none : Store::tetrahedron_of(other);
      const int opposite = other == Store::none ? 0 : Store::opposite_of(other);
      put(middle_facet(t, i), behind == Store::none ? Store::none : middle_facet(behind, opposite));
      for (int j = 0; j < 4; ++j)
        if (j != i)
          put(Store::facet(8 * t + Index(j), i),
              behind == Store::none
                  ? Store::none
                  : Store::facet(8 * behind + Index(store_.corner(behind, parent.v[std::size_t(j)])), opposite));
    }
  }

  Metric_mesh& mesh_;
  Store& store_;
  const Index old_vertices_;
  std::vector<New_vertex> new_; // by their edges
  std::vector<std::size_t> first_edge_;
  std::vector<Middles> middles_;
  std::vector<std::uint8_t> diagonal_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_UNIFORM_REFINEMENT_H
