// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_EXTENSION_EXTENSION_BUILDER_H
#define CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_EXTENSION_EXTENSION_BUILDER_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/Openings/internal/extension/Extension_band.h>
#include <CGAL/Tubular_meshing/Openings/internal/extension/Extension_profile.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Adds the triangles of one extension to a mesh: the band at the rim, and regular rings from there to the end. */
class Extension_builder {
  typedef Surface::Vertex_index Vertex;
  typedef Surface::Halfedge_index Halfedge;
  typedef Surface::Face_index Face;

public:
  std::vector<Face> faces;
  std::vector<Halfedge> rim; ///< of the far end, in order

  explicit Extension_builder(Surface& mesh)
      : mesh_(mesh) {}

  /* The rim's halfedges are border halfedges, in order. False if a triangle does not fit the mesh. */
  bool build(const Extension_profile& profile, const std::vector<Halfedge>& from) {
    const Extension_band band(profile);
    std::vector<Vertex> vertices;
    for (Halfedge h : from)
      vertices.push_back(mesh_.target(h));
    for (std::size_t i = vertices.size(); i < band.points.size(); ++i)
      vertices.push_back(mesh_.add_vertex(profile.point(band.points[i])));
    for (const Index_triangle& t : band.triangles)
      if (!add(vertices[t[0]], vertices[t[1]], vertices[t[2]]))
        return false;
    const std::size_t corners = std::size_t(profile.corners());
    std::vector<Vertex> ring(vertices.begin() + std::ptrdiff_t(from.size()),
                             vertices.begin() + std::ptrdiff_t(from.size() + corners));
    if (!add_rings(profile, band, ring))
      return false;
    find_rim(ring);
    return rim.size() == corners;
  }

private:
  bool add(Vertex a, Vertex b, Vertex c) {
    const Face f = mesh_.add_face(a, b, c);
    faces.push_back(f);
    return f != Surface::null_face();
  }

  // Each ring stands half a step turned on the one before. `ring` is the first, and then the last.
  bool add_rings(const Extension_profile& profile, const Extension_band& band, std::vector<Vertex>& ring) {
    const std::size_t corners = ring.size();
    const double left = profile.end() - band.ring_height(), row = 0.866 * profile.edge_length();
    const int rows = left > 0 ? (std::max)(1, int(std::lround(left / row))) : 0;
    for (int j = 1; j <= rows; ++j) {
      const bool odd = j % 2 == 1;
      std::vector<Vertex> next;
      for (std::size_t i = 0; i < corners; ++i)
        next.push_back(
            mesh_.add_vertex(profile.point({band.ring_phase() + (double(i) + (odd ? 0.5 : 0)) * profile.edge_length(),
                                            band.ring_height() + left * j / rows})));
      for (std::size_t i = 0; i < corners; ++i) {
        const std::size_t k = (i + 1) % corners;
        if (odd ? !add(ring[i], ring[k], next[i]) || !add(ring[k], next[k], next[i])
                : !add(ring[i], next[k], next[i]) || !add(ring[i], ring[k], next[k]))
          return false;
      }
      ring.swap(next);
    }
    return true;
  }

  void find_rim(const std::vector<Vertex>& ring) {
    rim.clear();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Halfedge h = mesh_.halfedge(ring[i], ring[(i + 1) % ring.size()]);
      if (h != Surface::null_halfedge() && mesh_.is_border(h))
        rim.push_back(h);
    }
  }

  Surface& mesh_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_EXTENSION_EXTENSION_BUILDER_H
