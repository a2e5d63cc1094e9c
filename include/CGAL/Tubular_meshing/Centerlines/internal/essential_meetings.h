// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_ESSENTIAL_MEETINGS_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_ESSENTIAL_MEETINGS_H

#include <CGAL/Tubular_meshing/Centerlines/internal/Interior_voronoi_diagram.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Voronoi_front.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Where a front meets itself after it has gone round something: the edges of the Voronoi diagram that close a cycle
 * which no faces fill.
 *
 * The diagram is built up in the order in which the front reaches it. An edge then joins two components or closes a
 * cycle, and a face fills the youngest cycle of its outline that is not filled yet: persistent homology in dimension
 * one, by the reduction of the boundary matrix (H. Edelsbrunner, D. Letscher and A. Zomorodian, Topological persistence
 * and simplification, 2002). Near linear in practice. */
class Front_homology {
public:
  typedef Interior_voronoi_diagram Diagram;
  typedef Diagram::Index Index;
  typedef std::array<Index, 2> Edge; // by rank: the later vertex first

  Front_homology(const Diagram& diagram, const Voronoi_front& front)
      : diagram_(diagram)
      , front_(front) {
    collect_faces();
    collect_edges();
    find_cycles();
    fill_cycles();
  }

  // Those that close a cycle for good, as pairs of vertices.
  std::vector<Edge> essential_edges() const {
    std::vector<Edge> result;
    for (std::size_t e = 0; e < edges_.size(); ++e)
      if (closes_cycle_[e] && column_of_[e].empty())
        result.push_back(Edge{{vertex_of_rank_[edges_[e][0]], vertex_of_rank_[edges_[e][1]]}});
    return result;
  }

private:
  typedef std::vector<Index> Column; // numbers of edges, increasing

  void collect_faces() {
    vertex_of_rank_.resize(diagram_.points.size());
    for (std::size_t v = 0; v < diagram_.points.size(); ++v)
      if (front_.has_reached(Index(v)))
        vertex_of_rank_[front_.rank(Index(v))] = Index(v);
    for (Index f = 0; f < diagram_.number_of_faces(); ++f) {
      Index last = 0;
      for (Index i = diagram_.face_begin[f]; i < diagram_.face_begin[f + 1]; ++i)
        last = (std::max)(last, front_.rank(diagram_.face_vertices[i])); // `none`, the greatest, if not reached
      if (last != Diagram::none)
        faces_.emplace_back(last, f);
    }
    std::sort(faces_.begin(), faces_.end());
  }

  template <class Visitor> void for_each_edge(Index f, const Visitor& visit) const {
    const Index begin = diagram_.face_begin[f], end = diagram_.face_begin[f + 1];
    for (Index i = begin; i < end; ++i) {
      const Index a = front_.rank(diagram_.face_vertices[i]);
      const Index b = front_.rank(diagram_.face_vertices[i + 1 < end ? i + 1 : begin]);
      visit(Edge{{(std::max)(a, b), (std::min)(a, b)}});
    }
  }

  void collect_edges() {
    for (const auto& f : faces_)
      for_each_edge(f.second, [&](const Edge& e) { edges_.push_back(e); });
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  }

  void find_cycles() {
    std::vector<Index> parent(vertex_of_rank_.size());
    std::iota(parent.begin(), parent.end(), Index(0));
    const auto root = [&](Index v) {
      while (parent[v] != v)
        v = parent[v] = parent[parent[v]];
      return v;
    };
    for (const Edge& e : edges_) {
      const Index a = root(e[0]), b = root(e[1]);
      closes_cycle_.push_back(a == b);
      parent[a] = b;
    }
  }

  void fill_cycles() {
    column_of_.resize(edges_.size());
    Column column, sum;
    for (const auto& f : faces_) {
      column.clear();
      for_each_edge(f.second, [&](const Edge& e) {
        const Index i = Index(std::lower_bound(edges_.begin(), edges_.end(), e) - edges_.begin());
        if (closes_cycle_[i])
          column.push_back(i);
      });
      std::sort(column.begin(), column.end());
      while (!column.empty() && !column_of_[column.back()].empty()) {
        const Column& other = column_of_[column.back()];
        sum.clear();
        std::set_symmetric_difference(column.begin(), column.end(), other.begin(), other.end(),
                                      std::back_inserter(sum));
        column.swap(sum);
      }
      if (!column.empty())
        column_of_[column.back()] = column;
    }
  }

  const Diagram& diagram_;
  const Voronoi_front& front_;
  std::vector<Index> vertex_of_rank_;
  std::vector<std::pair<Index, Index>> faces_; // rank of the last vertex, face
  std::vector<Edge> edges_;                    // in the order of the front
  std::vector<bool> closes_cycle_;
  std::vector<Column> column_of_; // by the edge whose cycle it fills
};

/* How far two paths get away from each other, in local radii of the first. O(n log n) in their points. */
inline double separation(const Sampled_line& a, const Sampled_line& b) {
  std::vector<Double_kernel::Segment_3> segments;
  for (std::size_t i = 1; i < b.size(); ++i)
    segments.emplace_back(b[i - 1].point, b[i].point);
  if (segments.empty())
    return 0;
  const Nearest_tree<Double_kernel::Segment_3> tree(std::move(segments));
  double result = 0;
  for (const Line_point& p : a)
    result = (std::max)(result, std::sqrt(tree.nearest(p.point).squared_distance) / p.radius);
  return result;
}

/* An upper bound of it, by walking both at once: two ways through the same vessel stay beside each other, which costs
 * no search to see. O(n). */
inline double separation_bound(const Sampled_line& a, const Sampled_line& b) {
  const std::size_t look_ahead = 8;
  double result = 0;
  std::size_t j = 0;
  for (const Line_point& p : a) {
    double nearest = CGAL::squared_distance(p.point, b[j].point);
    for (std::size_t k = j + 1; k < b.size() && k <= j + look_ahead; ++k) {
      const double d = CGAL::squared_distance(p.point, b[k].point);
      if (d < nearest) {
        nearest = d;
        j = k;
      }
    }
    result = (std::max)(result, std::sqrt(nearest) / p.radius);
  }
  return result;
}

struct Meeting {
  double separation;
  Interior_voronoi_diagram::Index other_side;
};

/* Where a front closes a cycle with its arrival at a vertex, the vertex was reached from one side, and one of its
 * neighbours from the other: the one whose way parts furthest from the vertex's own, if by more than `least`. */
inline Meeting widest_meeting(const Interior_voronoi_diagram& diagram, const Voronoi_front& front,
                              Interior_voronoi_diagram::Index vertex, double least) {
  typedef Interior_voronoi_diagram::Index Index;
  const Sampled_line way = front.path_from(vertex);
  Meeting widest = {least, vertex};
  for (Index f : diagram.faces_of[vertex])
    for (Index i = f == diagram.none ? 0 : diagram.face_begin[f]; f != diagram.none && i < diagram.face_begin[f + 1];
         ++i) {
      const Index other = diagram.face_vertices[i];
      if (other == vertex || !front.has_reached(other))
        continue;
      const Sampled_line other_way = front.path_from(other);
      if ((std::max)(separation_bound(other_way, way), separation_bound(way, other_way)) <= widest.separation)
        continue;
      const double s = (std::max)(separation(other_way, way), separation(way, other_way));
      if (s > widest.separation)
        widest = Meeting{s, other};
    }
  return widest;
}

/* The meetings at which the two sides have come by different vessels, the widest loops first, `most` of them at most;
 * others go round a hole in the diagram, which the samples' irregularities tear. */
inline std::vector<std::array<Interior_voronoi_diagram::Index, 2>>
essential_meetings(const Interior_voronoi_diagram& diagram, const Voronoi_front& front, std::size_t most) {
  typedef std::array<Interior_voronoi_diagram::Index, 2> Edge;
  const double least = 1.25; // radii: two vessels' axes are two radii apart, or their walls would touch
  std::vector<std::pair<double, Edge>> found;
  for (const Edge& e : Front_homology(diagram, front).essential_edges()) {
    const Meeting m = widest_meeting(diagram, front, e[0], least);
    if (m.separation > least)
      found.emplace_back(-m.separation, Edge{{e[0], m.other_side}});
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  if (found.size() > most)
    found.resize(most);
  std::vector<Edge> result;
  for (const auto& f : found)
    result.push_back(f.second);
  return result;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_ESSENTIAL_MEETINGS_H
