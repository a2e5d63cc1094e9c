// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_MESH_COMPLEX_TO_MIXED_MESH_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_MESH_COMPLEX_TO_MIXED_MESH_H

#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>

#include <CGAL/Unique_hash_map.h>

#include <cstdint>
#include <utility>

namespace CGAL::Tubular_meshing::internal {

/* The cells and labelled facets of a Mesh_3 complex as a Mixed_mesh; its vertices are those that a cell of the complex
 * uses. Linear in the size of the triangulation. */
template <class C3t3> void mesh_complex_to_mixed_mesh(const C3t3& c3t3, Mixed_mesh& mesh) {
  typedef typename C3t3::Triangulation Triangulation;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  const Triangulation& tr = c3t3.triangulation();
  constexpr std::uint32_t none = std::uint32_t(-1);

  Unique_hash_map<Vertex_handle, std::uint32_t> number(none, tr.number_of_vertices());
  mesh.points.reserve(tr.number_of_vertices());
  mesh.tetrahedra.reserve(c3t3.number_of_cells_in_complex());
  mesh.triangles.reserve(c3t3.number_of_facets_in_complex());

  const auto number_of = [&](Vertex_handle v) {
    std::uint32_t& n = number[v];
    if (n == none) {
      n = std::uint32_t(mesh.points.size());
      const auto& p = tr.point(v);
      mesh.points.emplace_back(p.x(), p.y(), p.z());
    }
    return n;
  };
  for (auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    mesh.tetrahedra.push_back(
        {number_of(c->vertex(0)), number_of(c->vertex(1)), number_of(c->vertex(2)), number_of(c->vertex(3))},
        c3t3.subdomain_index(c));
  for (auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f) {
    auto facet = *f;
    if (!c3t3.is_in_complex(facet.first)) // seen from its cell of the complex
      facet = tr.mirror_facet(facet);
    const int i = facet.second;
    const auto vertex = [&](int k) { return number_of(facet.first->vertex(Triangulation::vertex_triple_index(i, k))); };
    mesh.triangles.push_back({vertex(0), vertex(2), vertex(1)}, c3t3.surface_patch_index(*f)); // triples turn inward
  }
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_MESH_COMPLEX_TO_MIXED_MESH_H
