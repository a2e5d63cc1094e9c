// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADRATIC_QUADRATIC_MESH_IMPL_H
#define CGAL_TUBULAR_MESHING_QUADRATIC_QUADRATIC_MESH_IMPL_H

#include <CGAL/Tubular_meshing/Quadratic/Quadratic_mesh.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

CGAL_TUBULAR_MESHING_INLINE const Element_topology& topology_of(Element_type type) {
  static const std::array<Element_topology, 6> topologies = {{
      {4, 6, {{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}}, 0, {}},
      {5, 8, {{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}}}, 1, {{{0, 3, 2, 1}}}},
      {6,
       9,
       {{{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}},
       3,
       {{{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}}},
      {8,
       12,
       {{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}},
       6,
       {{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}}},
      {3, 3, {{{0, 1}, {1, 2}, {2, 0}}}, 0, {}},
      {4, 4, {{{0, 1}, {1, 2}, {2, 3}, {3, 0}}}, 1, {{{0, 1, 2, 3}}}},
  }};
  return topologies[std::size_t(type)];
}

CGAL_TUBULAR_MESHING_INLINE std::size_t Quadratic_mesh::edge(std::uint32_t a, std::uint32_t b) const {
  const std::uint32_t low = (std::min)(a, b), high = (std::max)(a, b);
  if (std::size_t(low) + 1 >= first_edge.size())
    return edge_end.size();
  const auto begin = edge_end.begin() + first_edge[low], end = edge_end.begin() + first_edge[low + 1];
  const auto found = std::lower_bound(begin, end, high);
  return found != end && *found == high ? std::size_t(found - edge_end.begin()) : edge_end.size();
}

CGAL_TUBULAR_MESHING_INLINE std::size_t Quadratic_mesh::quad(Quad corners) const {
  std::sort(corners.begin(), corners.end());
  const auto found = std::lower_bound(quads.begin(), quads.end(), corners);
  return found != quads.end() && *found == corners ? std::size_t(found - quads.begin()) : quads.size();
}

CGAL_TUBULAR_MESHING_INLINE Element_nodes Quadratic_mesh::nodes(Element_type type, const std::uint32_t* corners,
                                                                std::size_t number) const {
  const Element_topology& t = topology_of(type);
  Element_nodes result;
  for (std::size_t k = 0; k < t.corners; ++k)
    result.push_back(corners[k]);
  std::size_t first = linear.points.size();
  for (std::size_t k = 0; k < t.number_of_edges; ++k)
    result.push_back(std::uint32_t(first + edge(corners[t.edges[k][0]], corners[t.edges[k][1]])));
  if (!is_complete)
    return result;
  first += edge_points.size();
  for (std::size_t k = 0; k < t.number_of_quads; ++k) {
    const auto& q = t.quads[k];
    result.push_back(std::uint32_t(first + quad({corners[q[0]], corners[q[1]], corners[q[2]], corners[q[3]]})));
  }
  first += quad_points.size();
  if (type == Element_type::hexahedron)
    result.push_back(std::uint32_t(first + number));
  return result;
}

namespace internal {

// Calls f(low, high) for the edges of all elements, those that are shared more than once.
template <class F> void for_each_edge_of_elements(const Mixed_mesh& mesh, const F& f) {
  const auto visit = [&](Element_type type, const auto& block) {
    const Element_topology& t = topology_of(type);
    for (const auto& corners : block.vertices)
      for (std::size_t k = 0; k < t.number_of_edges; ++k) {
        const std::uint32_t a = corners[std::size_t(t.edges[k][0])], b = corners[std::size_t(t.edges[k][1])];
        f((std::min)(a, b), (std::max)(a, b));
      }
  };
  for_each_block_of_cells(mesh, visit);
  for_each_block_of_facets(mesh, visit);
}

inline void add_edges(Quadratic_mesh& mesh, int threads) {
  const std::size_t n = mesh.linear.points.size();
  std::vector<std::size_t> first(n + 1, 0);
  for_each_edge_of_elements(mesh.linear, [&](std::uint32_t low, std::uint32_t) { ++first[low + 1]; });
  for (std::size_t i = 0; i < n; ++i)
    first[i + 1] += first[i];
  std::vector<std::uint32_t> end(first[n]);
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for_each_edge_of_elements(mesh.linear, [&](std::uint32_t low, std::uint32_t high) { end[next[low]++] = high; });
  std::vector<std::uint32_t> number(n);
  for_each_range(n, threads, [&](std::size_t begin, std::size_t last) {
    for (std::size_t i = begin; i < last; ++i) {
      const auto from = end.begin() + std::ptrdiff_t(first[i]), to = end.begin() + std::ptrdiff_t(first[i + 1]);
      std::sort(from, to);
      number[i] = std::uint32_t(std::unique(from, to) - from);
    }
  });
  mesh.first_edge.assign(1, 0);
  mesh.first_edge.reserve(n + 1);
  mesh.edge_end.clear();
  for (std::size_t i = 0; i < n; ++i) {
    const auto from = end.begin() + std::ptrdiff_t(first[i]);
    mesh.edge_end.insert(mesh.edge_end.end(), from, from + number[i]);
    mesh.first_edge.push_back(std::uint32_t(mesh.edge_end.size()));
  }
}

inline void add_quads(Quadratic_mesh& mesh) {
  mesh.quads.clear();
  const auto visit = [&](Element_type type, const auto& block) {
    const Element_topology& t = topology_of(type);
    for (const auto& corners : block.vertices)
      for (std::size_t k = 0; k < t.number_of_quads; ++k) {
        Quadratic_mesh::Quad q;
        for (std::size_t i = 0; i < 4; ++i)
          q[i] = corners[std::size_t(t.quads[k][i])];
        std::sort(q.begin(), q.end());
        mesh.quads.push_back(q);
      }
  };
  for_each_block_of_cells(mesh.linear, visit);
  for_each_block_of_facets(mesh.linear, visit);
  std::sort(mesh.quads.begin(), mesh.quads.end());
  mesh.quads.erase(std::unique(mesh.quads.begin(), mesh.quads.end()), mesh.quads.end());
  mesh.quads.shrink_to_fit();
}

CGAL_TUBULAR_MESHING_INLINE void add_edges_and_quads(Quadratic_mesh& mesh, int threads) {
  add_edges(mesh, threads);
  if (mesh.is_complete)
    add_quads(mesh);
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Quadratic_mesh straight_quadratic_mesh(Mixed_mesh linear, bool complete_elements,
                                                                   int number_of_threads) {
  Quadratic_mesh mesh;
  mesh.linear = std::move(linear);
  mesh.is_complete = complete_elements;
  internal::add_edges_and_quads(mesh, number_of_threads);
  const auto mean = [&](const std::uint32_t* corners, std::size_t n) {
    internal::Vector_3d sum;
    for (std::size_t i = 0; i < n; ++i)
      sum += internal::Vector_3d(mesh.linear.points[corners[i]]);
    return internal::as<Point_3>((1. / double(n)) * sum);
  };
  for (std::uint32_t a = 0; a + 1 < mesh.first_edge.size(); ++a)
    for (std::size_t e = mesh.first_edge[a]; e < mesh.first_edge[a + 1]; ++e) {
      const std::uint32_t ends[2] = {a, mesh.edge_end[e]};
      mesh.edge_points.push_back(mean(ends, 2));
    }
  for (const Quadratic_mesh::Quad& q : mesh.quads)
    mesh.quad_points.push_back(mean(q.data(), 4));
  if (complete_elements)
    for (const auto& h : mesh.linear.hexahedra.vertices)
      mesh.inner_points.push_back(mean(h.data(), 8));
  return mesh;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_QUADRATIC_QUADRATIC_MESH_IMPL_H
