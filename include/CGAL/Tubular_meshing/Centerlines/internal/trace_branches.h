// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_TRACE_BRANCHES_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_TRACE_BRANCHES_H

#include <CGAL/Tubular_meshing/Centerlines/internal/Sampled_line.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

typedef std::vector<std::size_t> Vertex_path;

/* The maximal paths of a graph of edges: from node to node, where a node is a vertex of degree other than two. A closed
 * curve without nodes is one path that begins and ends at its lowest vertex. O(n). */
class Branch_tracer {
public:
  typedef std::array<std::size_t, 2> Edge;

  Branch_tracer(std::size_t number_of_vertices, std::vector<Edge> edges)
      : edges_(std::move(edges))
      , incident_(number_of_vertices)
      , used_(edges_.size(), false) {
    for (std::size_t e = 0; e < edges_.size(); ++e)
      for (std::size_t v : edges_[e])
        incident_[v].push_back(e);
  }

  std::vector<Vertex_path> branches() {
    std::vector<Vertex_path> result;
    for (std::size_t v = 0; v < incident_.size(); ++v)
      if (incident_[v].size() != 2)
        for (std::size_t e : incident_[v])
          if (!used_[e])
            result.push_back(trace(v, e));
    for (std::size_t e = 0; e < edges_.size(); ++e)
      if (!used_[e])
        result.push_back(trace(edges_[e][0], e));
    return result;
  }

private:
  Vertex_path trace(std::size_t v, std::size_t e) {
    Vertex_path path(1, v);
    const std::size_t start = v;
    do {
      used_[e] = true;
      v = edges_[e][0] == v ? edges_[e][1] : edges_[e][0];
      path.push_back(v);
      if (incident_[v].size() == 2)
        e = incident_[v][0] == e ? incident_[v][1] : incident_[v][0];
    } while (incident_[v].size() == 2 && v != start);
    return path;
  }

  std::vector<Edge> edges_;
  std::vector<std::vector<std::size_t>> incident_;
  std::vector<bool> used_;
};

inline double length(const Vertex_path& path, const std::vector<Line_point>& vertices) {
  double sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    sum += distance(vertices[path[i - 1]].point, vertices[path[i]].point);
  return sum;
}

/* The edges without spurs: branches from a bifurcation to a free end that are shorter than `shortest` radii, where a
 * line ends beside another. A bifurcation keeps its two longest branches at least. O(n log n). */
inline std::vector<Branch_tracer::Edge> without_spurs(std::vector<Branch_tracer::Edge> edges,
                                                      const std::vector<Line_point>& vertices, double shortest) {
  std::vector<std::size_t> degree(vertices.size(), 0);
  for (const Branch_tracer::Edge& e : edges)
    for (std::size_t v : e)
      ++degree[v];

  std::vector<std::pair<double, Vertex_path>> spurs;
  for (Vertex_path& b : Branch_tracer(vertices.size(), edges).branches()) {
    if (degree[b.front()] == 1)
      std::reverse(b.begin(), b.end());
    const double l = length(b, vertices);
    if (degree[b.front()] > 2 && degree[b.back()] == 1 && l < shortest * vertices[b.front()].radius)
      spurs.emplace_back(l, std::move(b));
  }
  std::stable_sort(spurs.begin(), spurs.end(), [](const auto& a, const auto& b) { return a.first < b.first; });

  std::vector<bool> removed(vertices.size(), false);
  for (const auto& spur : spurs)
    if (degree[spur.second.front()] > 2) {
      --degree[spur.second.front()];
      for (std::size_t i = 1; i < spur.second.size(); ++i)
        removed[spur.second[i]] = true;
    }
  edges.erase(std::remove_if(edges.begin(), edges.end(),
                             [&](const Branch_tracer::Edge& e) { return removed[e[0]] || removed[e[1]]; }),
              edges.end());
  return edges;
}

/* Contracts branches between two bifurcations that are shorter than `tolerance` radii: lines that part at nearly the
 * same place part at the same place. Branches that become shorter than the step (closed on one node) go too. O(n). */
inline std::vector<Vertex_path> without_short_inner_branches(std::vector<Vertex_path> branches,
                                                             const std::vector<Line_point>& vertices,
                                                             double tolerance) {
  std::vector<std::size_t> degree(vertices.size(), 0), merged_into(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v)
    merged_into[v] = v;
  for (const Vertex_path& b : branches) {
    ++degree[b.front()];
    ++degree[b.back()];
  }
  const auto representative = [&](std::size_t v) {
    while (merged_into[v] != v)
      v = merged_into[v] = merged_into[merged_into[v]];
    return v;
  };
  std::vector<Vertex_path> result;
  for (Vertex_path& b : branches) {
    const bool inner = degree[b.front()] > 1 && degree[b.back()] > 1;
    if (inner && length(b, vertices) <= tolerance * vertices[b.front()].radius)
      merged_into[representative(b.back())] = representative(b.front());
    else
      result.push_back(std::move(b));
  }
  for (Vertex_path& b : result) {
    b.front() = representative(b.front());
    b.back() = representative(b.back());
  }
  return result;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_TRACE_BRANCHES_H
