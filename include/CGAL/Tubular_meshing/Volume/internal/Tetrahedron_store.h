// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_TETRAHEDRON_STORE_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_TETRAHEDRON_STORE_H

#include <CGAL/Tubular_meshing/base/Face_buckets.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Numbered_cells.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Tetrahedra with neighbors and labelled facets in compact arrays, for algorithms that change a mesh in place.
 *
 * Tetrahedra are positively oriented (see Mixed_mesh). A facet is a tetrahedron and the vertex opposite to it, coded as
 * 4 t + i; a facet's other side is found in constant time, `none` on the boundary of the mesh. A facet with a label
 * belongs to the boundary or to an interface, and carries the label on both sides; 0 means no label.
 *
 * All changes of topology go through replace(): a set of tetrahedra goes, another one that fills the same cavity comes.
 */
class Tetrahedron_store {
public:
  typedef std::uint32_t Index;
  typedef std::array<Index, 4> Vertices;
  typedef std::array<Index, 3> Facet_vertices;
  typedef boost::container::small_vector<Index, 32> Index_list;

  static constexpr Index none = (std::numeric_limits<Index>::max)();

  struct Tetrahedron {
    Vertices v;
    std::array<Index, 4> neighbor; // facet codes
    std::array<std::int32_t, 4> label;
    std::int32_t region;
  };
  struct Labelled_facet {
    Facet_vertices v;
    std::int32_t label;
  };

  static constexpr Index tetrahedron_of(Index facet) { return facet / 4; }
  static constexpr int opposite_of(Index facet) { return int(facet % 4); }
  static constexpr Index facet(Index t, int i) { return 4 * t + Index(i); }

  // The vertices of the facet opposite to vertex i, counterclockwise from outside.
  static const std::array<int, 3>& facet_corners(int i) {
    static const std::array<std::array<int, 3>, 4> corners = {{{{1, 2, 3}}, {{0, 3, 2}}, {{0, 1, 3}}, {{0, 2, 1}}}};
    return corners[i];
  }
  // The k, l that make (i, j, k, l) an even permutation of (0, 1, 2, 3).
  static std::pair<int, int> other_corners(int i, int j) {
    static const int k[4][4] = {{-1, 2, 3, 1}, {3, -1, 0, 2}, {1, 3, -1, 0}, {2, 0, 1, -1}};
    return {k[i][j], 6 - i - j - k[i][j]};
  }

  explicit Tetrahedron_store(const Mixed_mesh& mesh, int threads = 1) {
    points_.reserve(mesh.points.size());
    for (const Point_3& p : mesh.points)
      points_.emplace_back(p);
    tetrahedra_.reserve(mesh.tetrahedra.size());
    for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i)
      tetrahedra_.push_back(
          {mesh.tetrahedra.vertices[i], {none, none, none, none}, {0, 0, 0, 0}, mesh.tetrahedra.label[i]});
    connect(mesh, threads);
  }

  /* Back to a Mixed_mesh: points, in their order, tetrahedra and labelled triangles; the rest of `mesh` stays as it is.
   * Returns the points' numbers there, by vertex: `none` for those that no tetrahedron has any more. */
  std::vector<Index> write_to(Mixed_mesh& mesh) const {
    std::vector<Index> number = number_of_used_vertices();
    mesh.points.clear();
    for (Index v = 0; v < points_.size(); ++v)
      if (number[v] != none)
        mesh.points.emplace_back(points_[v].x, points_[v].y, points_[v].z);
    mesh.tetrahedra = Element_block<4>();
    mesh.triangles = Element_block<3>();
    for (Index t = 0; t < tetrahedra_.size(); ++t)
      if (is_alive(t)) {
        const Vertices& v = tetrahedra_[t].v;
        mesh.tetrahedra.push_back({number[v[0]], number[v[1]], number[v[2]], number[v[3]]}, region(t));
      }
    for (Index t = 0; t < tetrahedra_.size(); ++t) {
      if (!is_alive(t))
        continue;
      for (int i = 0; i < 4; ++i) {
        const Tetrahedron& tet = tetrahedra_[t];
        // an interface is written once, from its side of lower region
        if (tet.label[i] == 0 || (tet.neighbor[i] != none && region(tetrahedron_of(tet.neighbor[i])) < tet.region))
          continue;
        const auto& c = facet_corners(i);
        mesh.triangles.push_back({number[tet.v[c[0]]], number[tet.v[c[1]]], number[tet.v[c[2]]]}, tet.label[i]);
      }
    }
    return number;
  }

  /* The same where the inside alone has changed since the mesh was read: the labelled triangles stay in their order, and
   * with their vertices in theirs. */
  void write_inside_to(Mixed_mesh& mesh) const {
    Element_block<3> triangles = std::move(mesh.triangles);
    const std::vector<Index> number = write_to(mesh);
    for (Facet_vertices& t : triangles.vertices)
      t = {number[t[0]], number[t[1]], number[t[2]]};
    mesh.triangles = std::move(triangles);
  }

  // Whether the mesh that was read had a face of more than two cells, or of two on the same side.
  bool has_overlaps() const { return has_overlaps_; }

  Index number_of_vertices() const { return Index(points_.size()); }
  Index number_of_slots() const { return Index(tetrahedra_.size()); } // some may not be alive

  const Vector_3d& point(Index v) const { return points_[v]; }
  void move(Index v, const Vector_3d& p) { points_[v] = p; }

  bool is_alive(Index t) const { return tetrahedra_[t].v[0] != none; }
  const Tetrahedron& operator[](Index t) const { return tetrahedra_[t]; }
  std::int32_t region(Index t) const { return tetrahedra_[t].region; }
  std::int32_t label(Index facet) const { return tetrahedra_[tetrahedron_of(facet)].label[opposite_of(facet)]; }
  Index other_side(Index facet) const { return tetrahedra_[tetrahedron_of(facet)].neighbor[opposite_of(facet)]; }
  // The vertices of a facet, counterclockwise from outside of its tetrahedron.
  Facet_vertices vertices(Index facet) const {
    const Vertices& v = tetrahedra_[tetrahedron_of(facet)].v;
    const auto& c = facet_corners(opposite_of(facet));
    return {v[c[0]], v[c[1]], v[c[2]]};
  }
  Index tetrahedron_at(Index v) const { return at_vertex_[v]; }

  // The tetrahedra that there are, in their order: all, or those of which `is_wanted(t)` holds.
  std::vector<Index> tetrahedra() const {
    return tetrahedra([](Index) { return true; });
  }
  template <class IsWanted> std::vector<Index> tetrahedra(const IsWanted& is_wanted) const {
    std::vector<Index> result;
    for (Index t = 0; t < number_of_slots(); ++t)
      if (is_alive(t) && is_wanted(t))
        result.push_back(t);
    return result;
  }

  // The same, asked on several threads.
  template <class IsWanted> std::vector<Index> tetrahedra(const IsWanted& is_wanted, int threads) const {
    std::vector<char> wanted(number_of_slots());
    for_each_range(wanted.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t)
        wanted[t] = is_alive(Index(t)) && is_wanted(Index(t));
    });
    return tetrahedra([&](Index t) { return wanted[t] != 0; });
  }

  /* The labelled facets that a tetrahedron has at the vertex opposite to `base`, one of its facets: visit(facet, a, b),
   * where a and b are the other two vertices, in the facet's order after that one. */
  template <class Visit> void for_each_labelled_facet(Index base, const Visit& visit) const {
    const Tetrahedron& t = tetrahedra_[tetrahedron_of(base)];
    const int i = opposite_of(base);
    for (int j = 0; j < 4; ++j) {
      if (j == i || t.label[j] == 0)
        continue;
      const auto& c = facet_corners(j);
      const int k = c[0] == i ? 0 : c[1] == i ? 1 : 2;
      visit(facet(tetrahedron_of(base), j), t.v[c[(k + 1) % 3]], t.v[c[(k + 2) % 3]]);
    }
  }

  /* The edges of labelled facets, in their order: visit(ends, labels), with the labels that facets have there, sorted
   * and each once. O(n log n). */
  template <class Visit> void for_each_labelled_edge(const Visit& visit) const {
    std::vector<std::pair<std::pair<Index, Index>, std::int32_t>> edges;
    for (Index t = 0; t < number_of_slots(); ++t)
      for (int i = 0; i < 4; ++i) {
        if (!is_alive(t) || tetrahedra_[t].label[i] == 0)
          continue;
        const Facet_vertices v = vertices(facet(t, i));
        for (int k = 0; k < 3; ++k)
          edges.push_back({std::minmax(v[k], v[(k + 1) % 3]), tetrahedra_[t].label[i]});
      }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::vector<std::int32_t> labels;
    for (std::size_t k = 0; k < edges.size();) {
      const auto ends = edges[k].first;
      labels.clear();
      for (; k < edges.size() && edges[k].first == ends; ++k)
        labels.push_back(edges[k].second);
      visit(ends, labels);
    }
  }

  // Labels become label_of(label).
  template <class Label_of> void relabel(const Label_of& label_of, int threads) {
    for_each_range(tetrahedra_.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t)
        for (std::int32_t& label : tetrahedra_[t].label)
          if (label != 0)
            label = label_of(label);
    });
  }

  int corner(Index t, Index v) const {
    const Vertices& w = tetrahedra_[t].v;
    return w[0] == v ? 0 : w[1] == v ? 1 : w[2] == v ? 2 : 3;
  }

  // The tetrahedra around a vertex, by a walk from neighbor to neighbor.
  template <class List> void star(Index v, List& tetrahedra) const {
    star(v, tetrahedra, [](Index) { return true; });
  }
  // The same; false, and not all of them, where one is not accepted.
  template <class List, class Accepts> bool star(Index v, List& tetrahedra, const Accepts& accepts) const {
    Few_numbers known;
    std::unordered_set<Index> more; // where they are no longer few
    const auto is_known = [&](Index t) {
      if (more.empty() && !known.is_full())
        return !known.insert(t);
      if (more.empty())
        more.insert(tetrahedra.begin(), tetrahedra.end());
      return !more.insert(t).second;
    };
    tetrahedra.clear();
    tetrahedra.push_back(at_vertex_[v]);
    known.insert(at_vertex_[v]);
    for (std::size_t k = 0; k < tetrahedra.size(); ++k) {
      if (!accepts(tetrahedra[k]))
        return false;
      const Tetrahedron& t = tetrahedra_[tetrahedra[k]];
      for (int i = 0; i < 4; ++i)
        if (t.v[i] != v && t.neighbor[i] != none && !is_known(tetrahedron_of(t.neighbor[i])))
          tetrahedra.push_back(tetrahedron_of(t.neighbor[i]));
    }
    return true;
  }

  /* The tetrahedra around an edge, and its link: vertex i and i+1 of the link lie in tetrahedron i. Counterclockwise
   * around the edge seen from its second vertex. On the boundary the link has one vertex more than tetrahedra. */
  struct Ring {
    Index a, b;
    bool closed;
    Index_list tetrahedra;
    Index_list link;
  };
  void ring(Index t, int i, int j, Ring& ring) const {
    this->ring(t, i, j, ring, [](Index) { return true; });
  }
  // The same; false, and not all of it, where one of the tetrahedra is not accepted.
  template <class Accepts> bool ring(Index start, int i, int j, Ring& ring, const Accepts& accepts) const {
    ring.a = tetrahedra_[start].v[i];
    ring.b = tetrahedra_[start].v[j];
    ring.tetrahedra.clear();
    ring.link.clear();
    const auto first_corners = other_corners(i, j);
    int k = first_corners.first, l = first_corners.second;
    for (Index t = start;;) {
      if (!accepts(t))
        return false;
      ring.tetrahedra.push_back(t);
      ring.link.push_back(tetrahedra_[t].v[k]);
      const Index n = tetrahedra_[t].neighbor[k];
      if (n == none) {
        ring.link.push_back(tetrahedra_[t].v[l]);
        break;
      }
      turn(n, ring, t, k, l);
      ring.closed = t == start;
      if (ring.closed)
        return true;
    }
    // and backwards from where it began
    ring.closed = false;
    const auto forward = std::ptrdiff_t(ring.tetrahedra.size());
    l = first_corners.second;
    for (Index t = start, n; (n = tetrahedra_[t].neighbor[l]) != none;) {
      turn(n, ring, t, k, l);
      if (!accepts(t))
        return false;
      ring.tetrahedra.push_back(t);
      ring.link.push_back(tetrahedra_[t].v[k]);
    }
    put_last_first(ring.tetrahedra, forward);
    put_last_first(ring.link, forward + 1);
    return true;
  }

  /* Takes the tetrahedra `gone` away and puts `come` in their place, all of one region. Both must fill the same cavity,
   * but for flips on the boundary: facets that appear there and were not there before are listed in `facets`. The
   * numbers of the new tetrahedra are left in `come_numbers`. */
  template <class Tetrahedra, class New, class Facets>
  void replace(const Tetrahedra& gone, const New& come, const Facets& facets, Index_list& come_numbers) {
    const std::int32_t region = tetrahedra_[gone[0]].region;
    replace(
        gone, come, [region](std::size_t) { return region; }, facets, come_numbers);
  }

  /* The same for a cavity of several regions: `region_of(k)` is the region of `come[k]`, and `facets` lists all
   * labelled facets that were not there before, on the boundary and between the new tetrahedra. */
  template <class Tetrahedra, class New, class Region, class Facets>
  void replace(const Tetrahedra& gone, const New& come, const Region& region_of, const Facets& facets,
               Index_list& come_numbers) {
    struct Side {
      Facet_vertices key;
      Index code; // of the only side known so far: the outer one of an old facet, the inner one of a new facet
      std::int32_t label;
    };
    boost::container::small_vector<Side, 64> open;
    const auto label_of = [&facets](const Facet_vertices& k) {
      for (const Labelled_facet& f : facets)
        if (are_equal(sorted(f.v), k))
          return f.label;
      return std::int32_t(0);
    };
    ++stamp_;
    for (Index t : gone)
      visited_[t] = stamp_;
    for (Index t : gone) {
      const Tetrahedron& tet = tetrahedra_[t];
      for (int i = 0; i < 4; ++i)
        if (tet.neighbor[i] == none || visited_[tetrahedron_of(tet.neighbor[i])] != stamp_)
          open.push_back({key(tet.v, i), tet.neighbor[i], tet.label[i]});
    }
    for (Index t : gone)
      release(t);
    come_numbers.clear();
    for (std::size_t n = 0; n < come.size(); ++n) {
      const Vertices& v = come[n];
      const Index t = allocate();
      come_numbers.push_back(t);
      tetrahedra_[t] = {v, {none, none, none, none}, {0, 0, 0, 0}, region_of(n)};
      for (int i = 0; i < 4; ++i) {
        at_vertex_[v[i]] = t;
        const Facet_vertices k = key(v, i);
        const auto other = std::find_if(open.begin(), open.end(), [&](const Side& s) { return are_equal(s.key, k); });
        if (other == open.end()) {
          open.push_back({k, facet(t, i), label_of(k)});
          continue;
        }
        link(facet(t, i), other->code, other->label);
        *other = open.back();
        open.pop_back();
      }
    }
    // what is left are the facets newly on the surface: of new tetrahedra or, where nothing came, of old neighbors
    for (const Side& s : open) {
      if (s.code == none)
        continue;
      const std::int32_t label = label_of(s.key);
      if (label != 0)
        link(s.code, none, label);
      for (Index v : tetrahedra_[tetrahedron_of(s.code)].v)
        at_vertex_[v] = tetrahedron_of(s.code);
    }
  }

  /* The facets between the tetrahedra of a star, those between a new vertex and the facets around a cavity: codes of both
   * sides, where tetrahedron k, of corners (new vertex, corners of facet k), has the number k. */
  typedef boost::container::small_vector<std::pair<Index, Index>, 96> Star_links;
  template <class Base_facets> void match_star(const Base_facets& bases, Star_links& links) const {
    struct Side {
      std::uint64_t edge; // around the cavity
      Index code;
    };
    boost::container::small_vector<Side, 64> open;
    links.clear();
    Index k = 0;
    for (Index f : bases) {
      const Facet_vertices v = vertices(f);
      for (std::size_t i = 0; i < 3; ++i) {
        const auto ends = std::minmax(v[(i + 1) % 3], v[(i + 2) % 3]);
        const std::uint64_t edge = std::uint64_t(ends.first) << 32 | ends.second;
        const Index side = facet(k, int(i) + 1);
        const auto other = std::find_if(open.begin(), open.end(), [=](const Side& s) { return s.edge == edge; });
        if (other == open.end()) {
          open.push_back({edge, side});
          continue;
        }
        links.emplace_back(side, other->code);
        *other = open.back();
        open.pop_back();
      }
      ++k;
    }
  }

  /* The same as replace() with such a star, of all facets around a cavity, seen from inside; no facet has both of its
   * sides in the cavity. `links`: of match_star(), for these facets. */
  template <class Tetrahedra, class Base_facets>
  void replace_by_star(const Tetrahedra& gone, const Base_facets& bases, const Star_links& links, const Vector_3d& p,
                       Index_list& come_numbers) {
    const std::int32_t region = tetrahedra_[gone[0]].region;
    const Star_bases around = bases_of(bases);
    for (Index t : gone)
      release(t);
    come_numbers.clear();
    while (come_numbers.size() < around.size())
      come_numbers.push_back(allocate());
    put_star(around, links, add_vertex(p), region, come_numbers);
    for (Index t : come_numbers)
      for (Index w : tetrahedra_[t].v)
        at_vertex_[w] = t;
  }

  /* The two parts of that, where more tetrahedra come than go. First, room for them: their numbers, those that go before
   * others, and that of the new vertex; nothing else has changed then. */
  template <class Tetrahedra>
  Index reserve_star(const Tetrahedra& gone, std::size_t number, const Vector_3d& p, Index_list& come_numbers) {
    come_numbers.assign(gone.begin(), gone.end());
    while (come_numbers.size() < number)
      come_numbers.push_back(allocate());
    return add_vertex(p);
  }
  /* Then the star itself. Several whose cavities have no tetrahedron in common may be put there at the same time. What
   * is known of their vertices' tetrahedra is not up to date until renumber(). */
  template <class Base_facets>
  void fill_star(const Base_facets& bases, const Star_links& links, Index v, const Index_list& come_numbers) {
    const std::int32_t region = tetrahedra_[tetrahedron_of(*bases.begin())].region;
    put_star(bases_of(bases), links, v, region, come_numbers);
  }

  // Other tetrahedra, all alive, in place of those that there are.
  void assign(std::vector<Tetrahedron> tetrahedra) {
    tetrahedra_.swap(tetrahedra);
    free_.clear();
    visited_.assign(tetrahedra_.size(), 0);
    stamp_ = 0;
    collect_vertices();
  }

  // A vertex that replace() can use from now on.
  Index add_vertex(const Vector_3d& p) {
    if (free_vertices_.empty()) {
      points_.push_back(p);
      at_vertex_.push_back(none);
      return Index(points_.size() - 1);
    }
    const Index v = free_vertices_.back();
    free_vertices_.pop_back();
    points_[v] = p;
    return v;
  }
  // Of a vertex that no tetrahedron has any more.
  void remove_vertex(Index v) {
    at_vertex_[v] = none;
    free_vertices_.push_back(v);
  }
  bool is_used(Index v) const { return at_vertex_[v] != none; }

  /* Renumbers: vertex i of the new numbering is order[i] of the old one, where all used vertices are listed and no
   * others; tetrahedra follow their vertices. What is near in space comes to lie near in memory. */
  void renumber(const std::vector<Index>& order, int threads = 1) {
    std::vector<Index> number(points_.size(), none);
    for (Index i = 0; i < order.size(); ++i)
      number[order[i]] = i;
    std::vector<Index> lowest(tetrahedra_.size(), none); // the lowest vertex of each
    for_each_range(tetrahedra_.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t)
        if (is_alive(Index(t))) {
          const Vertices& v = tetrahedra_[t].v;
          lowest[t] = (std::min)({number[v[0]], number[v[1]], number[v[2]], number[v[3]]});
        }
    });
    std::vector<Index> place(order.size() + 1, 0); // of the next tetrahedron of each vertex
    for (Index v : lowest)
      if (v != none)
        ++place[v + 1];
    for (std::size_t v = 0; v < order.size(); ++v)
      place[v + 1] += place[v];
    std::vector<Index> tetrahedra(place.back());
    for (Index t = 0; t < lowest.size(); ++t)
      if (lowest[t] != none)
        tetrahedra[place[lowest[t]]++] = t;
    renumber(order, tetrahedra, threads);
  }

  // The same with an order of the tetrahedra; those that are not listed are taken away.
  void renumber(const std::vector<Index>& order, const std::vector<Index>& order_of_tetrahedra, int threads) {
    std::vector<Index> number(points_.size(), none), place(tetrahedra_.size(), none);
    std::vector<Vector_3d> points(order.size());
    for_each_range(order.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        number[order[i]] = Index(i);
        points[i] = points_[order[i]];
      }
    });
    points_.swap(points);
    for_each_range(order_of_tetrahedra.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k)
        place[order_of_tetrahedra[k]] = Index(k);
    });
    std::vector<Tetrahedron> tetrahedra;
    tetrahedra.reserve(order_of_tetrahedra.size() + order_of_tetrahedra.size() / 8);
    tetrahedra.resize(order_of_tetrahedra.size());
    for_each_range(tetrahedra.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) {
        Tetrahedron& t = tetrahedra[k] = tetrahedra_[order_of_tetrahedra[k]];
        for (Index& v : t.v)
          v = number[v];
        for (Index& n : t.neighbor)
          if (n != none)
            n = place[tetrahedron_of(n)] == none ? none : facet(place[tetrahedron_of(n)], opposite_of(n));
      }
    });
    tetrahedra_.swap(tetrahedra);
    free_.clear();
    free_vertices_.clear();
    visited_.assign(tetrahedra_.size(), 0);
    stamp_ = 0;
    collect_vertices();
  }

private:
  std::vector<Index> number_of_used_vertices() const {
    std::vector<Index> number(points_.size(), none);
    for (Index t = 0; t < tetrahedra_.size(); ++t)
      if (is_alive(t))
        for (Index v : tetrahedra_[t].v)
          number[v] = 0;
    Index used = 0;
    for (Index& n : number)
      if (n != none)
        n = used++;
    return number;
  }

  // A set of up to half of its places, which need no memory but the stack's.
  class Few_numbers {
  public:
    Few_numbers() { place_.fill(none); }
    bool is_full() const { return 2 * size_ >= place_.size(); }
    // Whether it was not there yet.
    bool insert(Index n) {
      std::size_t i = n * 0x9e3779b1u >> 24;
      while (place_[i] != none && place_[i] != n)
        i = (i + 1) % place_.size();
      if (place_[i] == n)
        return false;
      place_[i] = n;
      ++size_;
      return true;
    }

  private:
    std::array<Index, 256> place_;
    std::size_t size_ = 0;
  };

  // Not by the library's comparison, which calls one of memory.
  static bool are_equal(const Facet_vertices& f, const Facet_vertices& g) {
    return f[0] == g[0] && f[1] == g[1] && f[2] == g[2];
  }
  static Facet_vertices sorted(Facet_vertices f) {
    if (f[0] > f[1])
      std::swap(f[0], f[1]);
    if (f[1] > f[2])
      std::swap(f[1], f[2]);
    if (f[0] > f[1])
      std::swap(f[0], f[1]);
    return f;
  }
  static Facet_vertices key(const Vertices& v, int opposite) {
    const auto& c = facet_corners(opposite);
    return sorted({v[c[0]], v[c[1]], v[c[2]]});
  }

  // Steps around a ring's edge into the tetrahedron behind the facet with code n; k and l are its corners of the link.
  void turn(Index n, const Ring& ring, Index& t, int& k, int& l) const {
    t = tetrahedron_of(n);
    std::tie(k, l) = other_corners(corner(t, ring.a), corner(t, ring.b));
  }
  // What comes after the first ones, in reverse.
  static void put_last_first(Index_list& list, std::ptrdiff_t first) {
    std::reverse(list.begin() + first, list.end());
    std::rotate(list.begin(), list.begin() + first, list.end());
  }

  void link(Index f, Index g, std::int32_t label) {
    tetrahedra_[tetrahedron_of(f)].neighbor[opposite_of(f)] = g;
    tetrahedra_[tetrahedron_of(f)].label[opposite_of(f)] = label;
    if (g == none)
      return;
    tetrahedra_[tetrahedron_of(g)].neighbor[opposite_of(g)] = f;
    tetrahedra_[tetrahedron_of(g)].label[opposite_of(g)] = label;
  }

  Index allocate() {
    if (free_.empty()) {
      tetrahedra_.emplace_back();
      visited_.push_back(0);
      return Index(tetrahedra_.size() - 1);
    }
    const Index t = free_.back();
    free_.pop_back();
    return t;
  }
  void release(Index t) {
    tetrahedra_[t].v[0] = none;
    free_.push_back(t);
  }

  struct Star_base {
    Facet_vertices v;
    Index other;
    std::int32_t label;
  };
  typedef boost::container::small_vector<Star_base, 64> Star_bases;
  template <class Base_facets> Star_bases bases_of(const Base_facets& bases) const {
    Star_bases result;
    for (Index f : bases)
      result.push_back({vertices(f), other_side(f), label(f)});
    return result;
  }
  void put_star(const Star_bases& bases, const Star_links& links, Index v, std::int32_t region,
                const Index_list& numbers) {
    for (std::size_t k = 0; k < bases.size(); ++k) {
      const Star_base& b = bases[k];
      tetrahedra_[numbers[k]] = {{v, b.v[0], b.v[1], b.v[2]}, {none, none, none, none}, {0, 0, 0, 0}, region};
      link(facet(numbers[k], 0), b.other, b.label);
    }
    const auto number = [&](Index code) { return facet(numbers[tetrahedron_of(code)], opposite_of(code)); };
    for (const auto& [f, g] : links)
      link(number(f), number(g), 0);
  }

  // Neighbors and labels of all tetrahedra at once, by facets with the same vertices.
  void connect(const Mixed_mesh& mesh, int threads) {
    const cells::Numbered_cells cells(mesh);
    const cells::Face_buckets faces(cells, cells::Face_buckets::with_facets, threads);
    std::atomic<bool> has_overlaps{false};
    for_each_range(points_.size(), threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v)
        faces.for_each_group(v, [&](std::size_t first, std::size_t last) {
          connect_equal(faces, first, last, mesh.triangles.label);
          if (overlap(faces, first, last))
            has_overlaps.store(true, std::memory_order_relaxed);
        });
    });
    has_overlaps_ = has_overlaps;
    visited_.assign(tetrahedra_.size(), 0);
    collect_vertices();
  }

  // Other cells than tetrahedra, which there may be, come behind them.
  void connect_equal(const cells::Face_buckets& faces, std::size_t first, std::size_t last,
                     const std::vector<int>& labels) {
    static constexpr int opposite[4] = {3, 2, 0, 1}; // of the faces in their order among the cell's
    const auto code = [&](std::size_t k) {
      const auto& f = faces[k];
      return !f.is_facet() && f.owner() < tetrahedra_.size() ? facet(f.owner(), opposite[f.number()]) : none;
    };
    const auto& behind = faces[last - 1];
    const int label = behind.is_facet() && behind.owner() < labels.size() ? labels[behind.owner()] : 0;
    if (code(first) != none)
      link(code(first), first + 1 < last ? code(first + 1) : none, label);
  }

  // Whether a face has more than two cells, or two on the same side.
  static bool overlap(const cells::Face_buckets& faces, std::size_t first, std::size_t last) {
    std::size_t n = 0;
    while (first + n < last && !faces[first + n].is_facet())
      ++n;
    return n > 2 || (n == 2 && faces.overlap(faces[first], faces[first + 1]));
  }

  void collect_vertices() {
    at_vertex_.assign(points_.size(), none);
    for (Index t = 0; t < tetrahedra_.size(); ++t)
      for (Index v : tetrahedra_[t].v)
        at_vertex_[v] = t;
  }

  std::vector<Vector_3d> points_;
  std::vector<Tetrahedron> tetrahedra_;
  std::vector<Index> at_vertex_; // one tetrahedron a vertex
  std::vector<Index> free_, free_vertices_;
  std::vector<std::uint32_t> visited_; // per tetrahedron: the last replace() that it went by
  std::uint32_t stamp_ = 0;
  bool has_overlaps_ = false;
};

// The quality (13) of a tetrahedron of vertices of a store.
inline double gamma_of(const Tetrahedron_store& store, const Tetrahedron_store::Vertices& v) {
  return tetrahedron_gamma(store.point(v[0]), store.point(v[1]), store.point(v[2]), store.point(v[3]));
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_TETRAHEDRON_STORE_H
