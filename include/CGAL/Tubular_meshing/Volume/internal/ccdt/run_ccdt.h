// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_CCDT_RUN_CCDT_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_CCDT_RUN_CCDT_H

#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>
#include <CGAL/Tubular_meshing/Volume/internal/ccdt/Steiner_points_inside.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Recovered_boundary.h>

#include <CGAL/exceptions.h>
#include <CGAL/make_conforming_constrained_Delaunay_triangulation_3.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_set>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

// The cells that cannot be reached from outside without crossing the surface.
template <class Ccdt> auto cells_inside(const Ccdt& ccdt) {
  typedef typename Ccdt::Triangulation::Cell_handle Cell_handle;
  const auto& triangulation = ccdt.triangulation();
  std::vector<Cell_handle> outside(1, triangulation.infinite_cell());
  std::unordered_set<Cell_handle> reached(outside.begin(), outside.end());
  for (std::size_t k = 0; k < outside.size(); ++k)
    for (int i = 0; i < 4; ++i) {
      const Cell_handle c = outside[k], n = c->neighbor(i);
      if (!ccdt.is_facet_constrained(c, i) && reached.insert(n).second)
        outside.push_back(n);
    }
  std::vector<Cell_handle> inside;
  for (Cell_handle c : triangulation.finite_cell_handles())
    if (reached.count(c) == 0)
      inside.push_back(c);
  return inside;
}

template <class Ccdt> Steiner_points_inside to_arrays(const Ccdt& ccdt, const Surface& surface) {
  typedef typename Ccdt::Triangulation::Vertex_handle Vertex_handle;
  Steiner_points_inside arrays;
  std::map<Point_3, std::uint32_t> number;
  for (auto v : surface.vertices()) {
    number[surface.point(v)] = std::uint32_t(arrays.points.size());
    arrays.points.emplace_back(surface.point(v));
  }
  const auto number_of = [&](Vertex_handle v) {
    const auto inserted = number.emplace(v->point(), std::uint32_t(arrays.points.size()));
    if (inserted.second)
      arrays.points.emplace_back(v->point());
    return inserted.first->second;
  };
  for (auto c : cells_inside(ccdt)) {
    arrays.tetrahedra.push_back(
        {number_of(c->vertex(0)), number_of(c->vertex(1)), number_of(c->vertex(2)), number_of(c->vertex(3))});
    for (int i = 0; i < 4; ++i)
      if (ccdt.is_facet_constrained(c, i)) {
        const auto& k = Tetrahedron_store::facet_corners(i);
        arrays.facets.push_back({{number_of(c->vertex(k[0])), number_of(c->vertex(k[1])), number_of(c->vertex(k[2]))},
                                 std::uint32_t(ccdt.face_constraint_index(c, i))});
      }
  }
  return arrays;
}

/* Fills a closed surface with tetrahedra of its own points, and of as few others as that takes, by CGAL's constrained
 * Delaunay triangulation, whose points on the surface are brought inside. Returns 0 or, in TetGen's numbers, what went
 * wrong. */
inline int run_ccdt(const Boundary_arrays& boundary, Recovered_boundary& recovered) {
  Surface surface;
  std::vector<Surface::Vertex_index> vertex;
  for (const auto& p : boundary.points)
    vertex.push_back(surface.add_vertex(Point_3(p.x, p.y, p.z)));
  for (const auto& t : boundary.triangles)
    surface.add_face(vertex[t[0]], vertex[t[1]], vertex[t[2]]);
  Steiner_points_inside arrays;
  try {
    arrays = to_arrays(make_conforming_constrained_Delaunay_triangulation_3(surface), surface);
  } catch (const Failure_exception&) {
    return 2;
  }
  const std::size_t own = boundary.points.size();
  if (!arrays.run(std::uint32_t(own)))
    return 4;
  recovered.inner_points.assign(arrays.points.begin() + std::ptrdiff_t(own), arrays.points.end());
  recovered.tetrahedra = arrays.tetrahedra;
  return 0;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_CCDT_RUN_CCDT_H
