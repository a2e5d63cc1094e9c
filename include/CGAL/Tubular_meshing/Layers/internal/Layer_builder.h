// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LAYER_BUILDER_H
#define CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LAYER_BUILDER_H

#include <CGAL/Tubular_meshing/Layers/internal/Layer_levels.h>
#include <CGAL/Tubular_meshing/Layers/internal/Layer_surface.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Adds layers of cells on a surface to a mesh that has its vertices: those of a layer after those of the layer before,
 * in the order of the surface's. */
class Layer_builder {
public:
  typedef std::uint32_t Index;
  typedef Layer_surface::Face Face;

  /* \param base the mesh's point of each vertex of the surface
   * \param levels as in Layer_options
   * \param inward whether the cells are on the other side of the surface than those of a wall */
  Layer_builder(const Layer_surface& surface, std::vector<Index> base, std::size_t layers, bool inward,
                Mixed_mesh& mesh)
      : surface_(surface)
      , base_(std::move(base))
      , first_(Index(mesh.points.size()))
      , layers_(layers)
      , inward_(inward)
      , mesh_(mesh) {}

  // \param vectors to the far side
  void add_points(const Layer_levels& levels, Function_view<Vector_3d(Index)> vector) {
    mesh_.points.reserve(mesh_.points.size() + layers_ * base_.size());
    for (std::size_t k = 1; k < levels.size(); ++k)
      for (Index v = 0; v < base_.size(); ++v) {
        const Vector_3d p = surface_.points[v] + levels(v, k) * vector(v);
        mesh_.points.emplace_back(p.x, p.y, p.z);
      }
  }

  // Level 0 is the surface.
  Index point(Index v, std::size_t level) const {
    return level == 0 ? base_[v] : first_ + Index((level - 1) * base_.size()) + v;
  }

  void add_cells(std::size_t first_layer, std::size_t last_layer, int region, bool tetrahedral) {
    add_cells(first_layer, last_layer, std::vector<int>(surface_.faces.size(), region), tetrahedral);
  }

  // \param regions one a face
  void add_cells(std::size_t first_layer, std::size_t last_layer, const std::vector<int>& regions, bool tetrahedral) {
    for (std::size_t k = first_layer; k < last_layer; ++k)
      for (std::size_t i = 0; i < surface_.faces.size(); ++i) {
        const Face& f = surface_.faces[i];
        const int region = regions[i];
        if (Layer_surface::degree(f) == 4)
          mesh_.hexahedra.push_back({point(f[0], k), point(f[1], k), point(f[2], k), point(f[3], k), point(f[0], k + 1),
                                     point(f[1], k + 1), point(f[2], k + 1), point(f[3], k + 1)},
                                    region);
        else if (tetrahedral)
          add_tetrahedra(f, k, region);
        else
          mesh_.prisms.push_back({point(f[0], k), point(f[1], k), point(f[2], k), point(f[0], k + 1),
                                  point(f[1], k + 1), point(f[2], k + 1)},
                                 region);
      }
  }

  /* The facets between columns of different regions, as the face of the higher one turns: seen from the lower one.
   * O(n log n). */
  void add_interfaces(std::size_t first_layer, std::size_t last_layer, const std::vector<int>& regions, int label,
                      bool tetrahedral) {
    struct Side {
      std::array<Index, 2> edge; // lower vertex first
      std::size_t face;
      bool is_turned;
      bool operator<(const Side& s) const { return edge != s.edge ? edge < s.edge : face < s.face; }
    };
    std::vector<Side> sides;
    for (std::size_t i = 0; i < surface_.faces.size(); ++i) {
      const Face& f = surface_.faces[i];
      const std::size_t n = std::size_t(Layer_surface::degree(f));
      for (std::size_t j = 0; j < n; ++j) {
        const Index v = f[j], w = f[(j + 1) % n];
        sides.push_back({{(std::min)(v, w), (std::max)(v, w)}, i, w < v});
      }
    }
    std::sort(sides.begin(), sides.end());
    for (std::size_t k = first_layer; k < last_layer; ++k)
      for (std::size_t s = 1; s < sides.size(); ++s) {
        if (sides[s].edge != sides[s - 1].edge || regions[sides[s].face] == regions[sides[s - 1].face])
          continue;
        const Side& higher = regions[sides[s].face] > regions[sides[s - 1].face] ? sides[s] : sides[s - 1];
        add_ring_facet(higher.edge[higher.is_turned ? 1 : 0], higher.edge[higher.is_turned ? 0 : 1], k, label,
                       tetrahedral);
      }
  }

  // The faces of the surface at a level, turned as it is, or the other way where layers grow inward.
  void add_facets(std::size_t level, int label) {
    for (const Face& f : surface_.faces)
      if (Layer_surface::degree(f) == 4)
        mesh_.quads.push_back(
            inward_
                ? std::array<Index, 4>{point(f[3], level), point(f[2], level), point(f[1], level), point(f[0], level)}
                : std::array<Index, 4>{point(f[0], level), point(f[1], level), point(f[2], level), point(f[3], level)},
            label);
      else
        mesh_.triangles.push_back(
            inward_ ? std::array<Index, 3>{point(f[2], level), point(f[1], level), point(f[0], level)}
                    : std::array<Index, 3>{point(f[0], level), point(f[1], level), point(f[2], level)},
            label);
  }

  /* \param label called with the label of an opening */
  void add_rings(Function_view<int(int)> label, bool tetrahedral) {
    for (std::size_t k = 0; k < layers_; ++k)
      for (const Layer_surface::Rim_edge& e : surface_.rim_edges)
        add_ring_facet(e.source, e.target, k, label(e.label), tetrahedral);
  }

private:
  /* Each side of a prism is cut from below at its smaller vertex to above at its larger one: neighbours agree, and no
   * prism is cut so that no tetrahedra fit. */
  void add_tetrahedra(const Face& f, std::size_t k, int region) {
    std::array<Index, 3> t = {f[0], f[1], f[2]};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    const Index a = t[0], b = (std::min)(t[1], t[2]), c = (std::max)(t[1], t[2]);
    const auto add = [&](Index p, Index q, Index r, Index s) {
      if (t[1] < t[2])
        mesh_.tetrahedra.push_back({p, q, r, s}, region);
      else
        mesh_.tetrahedra.push_back({p, r, q, s}, region);
    };
    const Index A = point(a, k + 1), B = point(b, k + 1), C = point(c, k + 1);
    const Index la = point(a, k), lb = point(b, k), lc = point(c, k);
    add(la, lb, lc, C);
    add(la, lb, C, B);
    add(la, B, C, A);
  }

  void add_ring_facet(Index v, Index w, std::size_t k, int label, bool tetrahedral) {
    const Index a = point(v, k), b = point(w, k), c = point(w, k + 1), d = point(v, k + 1);
    if (!tetrahedral)
      mesh_.quads.push_back({a, b, c, d}, label);
    else if (v < w) {
      mesh_.triangles.push_back({a, b, c}, label);
      mesh_.triangles.push_back({a, c, d}, label);
    } else {
      mesh_.triangles.push_back({a, b, d}, label);
      mesh_.triangles.push_back({b, c, d}, label);
    }
  }

  const Layer_surface& surface_;
  const std::vector<Index> base_;
  const Index first_;
  const std::size_t layers_;
  const bool inward_;
  Mixed_mesh& mesh_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LAYER_BUILDER_H
