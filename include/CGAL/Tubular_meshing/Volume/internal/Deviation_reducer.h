// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_DEVIATION_REDUCER_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_DEVIATION_REDUCER_H

#include <CGAL/Tubular_meshing/Volume/internal/Patch_projection.h>
#include <CGAL/Tubular_meshing/Volume/internal/Vertex_optimizer.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Brings the mesh to the vertices of the surface that it has cut off: where one is further from the mesh than a part of
 * the facet there, the nearest vertex of that facet with the same patches is moved onto it, if the elements around
 * allow. A coarse input has few vertices, and each of them is a corner. O(n log n). */
class Deviation_reducer {
public:
  typedef Tetrahedron_store::Index Index;

  Deviation_reducer(const Surface& surface, Face_patch_map patch, Tetrahedron_store& store,
                    Vertex_optimizer<Patch_projection>& vertices, int threads)
      : surface_(surface)
      , patch_(patch)
      , store_(store)
      , vertices_(vertices)
      , threads_(threads) {
    std::vector<Triangle> triangles;
    for (Index t = 0; t < store.number_of_slots(); ++t)
      for (int i = 0; i < 4; ++i)
        if (store.is_alive(t) && store[t].label[i] != 0) {
          facets_.push_back(Tetrahedron_store::facet(t, i));
          const auto v = store.vertices(facets_.back());
          triangles.emplace_back(to_point(v[0]), to_point(v[1]), to_point(v[2]));
        }
    tree_ = Nearest_tree<Triangle>(std::move(triangles));
  }

  void run() {
    const auto all = surface_.vertices();
    const std::vector<Vertex> corners(all.begin(), all.end());
    std::vector<Index> facet(corners.size(), Tetrahedron_store::none);
    for_each_range(corners.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) {
        const auto found = tree_.nearest(point(corners[k]));
        if (found.squared_distance > tolerance * tolerance * squared_size(facets_[found.index]))
          facet[k] = facets_[found.index];
      }
    });
    for (std::size_t k = 0; k < corners.size(); ++k)
      if (facet[k] != Tetrahedron_store::none)
        snap(corners[k], facet[k]);
  }

private:
  typedef Surface::Vertex_index Vertex;
  typedef Double_kernel::Triangle_3 Triangle;
  typedef Tetrahedron_store::Facet_vertices Facet_vertices;

  static constexpr double tolerance = 0.1;     // of the facet's longest edge, twice what roundness alone makes of it
  static constexpr double least_quality = 0.3; // that is given for it

  void snap(Vertex u, Index facet) {
    const Vector_3d p(point(u));
    const std::vector<std::int32_t> patches = patches_at(u);
    Facet_vertices v = store_.vertices(facet);
    std::sort(v.begin(), v.end(),
              [&](Index a, Index b) { return squared_norm(store_.point(a) - p) < squared_norm(store_.point(b) - p); });
    for (Index w : v)
      if (vertices_.is_on(w, patches) && vertices_.move_to(w, p, least_quality))
        return;
  }

  std::vector<std::int32_t> patches_at(Vertex u) const {
    std::vector<std::int32_t> patches;
    for (auto f : faces_around_target(halfedge(u, surface_), surface_))
      patches.push_back(get(patch_, f));
    std::sort(patches.begin(), patches.end());
    patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
    return patches;
  }

  double squared_size(Index facet) const {
    const auto v = store_.vertices(facet);
    return (std::max)({squared_norm(store_.point(v[0]) - store_.point(v[1])),
                       squared_norm(store_.point(v[1]) - store_.point(v[2])),
                       squared_norm(store_.point(v[2]) - store_.point(v[0]))});
  }
  Double_kernel::Point_3 point(Vertex u) const { return to_double_point(get(CGAL::vertex_point, surface_, u)); }
  Double_kernel::Point_3 to_point(Index v) const { return to_double_point(store_.point(v)); }

  const Surface& surface_;
  Face_patch_map patch_;
  Tetrahedron_store& store_;
  Vertex_optimizer<Patch_projection>& vertices_;
  int threads_;
  std::vector<Index> facets_;
  Nearest_tree<Triangle> tree_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_DEVIATION_REDUCER_H
