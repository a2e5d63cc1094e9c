// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_LABEL_FRAGMENTS_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_LABEL_FRAGMENTS_H

#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* New faces that have their labels from the nearest of the old triangles: where the rim of a cap was replaced, these
 * labels are ragged. Connected faces of one label are a fragment if all of them are new, and they are less than a fifth
 * of the region that their label comes from: what would be a hole in a cap, or another cap beside it. A fragment takes
 * the label that is longest around it; the smallest ones first. A cap of which all faces are new has its area, and is
 * none. O(n log n) for n new faces. */
class Label_fragments {
  typedef Surface::Face_index Face;

public:
  /* `region_area`: by face, the area of the region that its label comes from; 0 for a face that is not new. */
  Label_fragments(const Surface& surface, Face_patch_map label, const std::vector<double>& region_area)
      : surface_(surface)
      , label_(label)
      , region_area_(region_area) {}

  void relabel() {
    std::vector<std::pair<double, Face>> fragments; // areas, and one face each
    std::vector<bool> visited(surface_.num_faces(), false);
    for (Face f : surface_.faces())
      if (is_new(f) && !visited[std::size_t(f)]) {
        const Region region = grow(f, visited, true);
        if (is_fragment(region))
          fragments.emplace_back(region.area, f);
      }
    std::sort(fragments.begin(), fragments.end());
    visited.assign(surface_.num_faces(), false);
    for (const auto& fragment : fragments) {
      const Region region = grow(fragment.second, visited, false); // another one may have joined it
      for (Face f : region.faces)
        visited[std::size_t(f)] = false;
      if (is_fragment(region))
        take_label_around(region);
    }
  }

private:
  static constexpr double least_share = 0.2;

  struct Region {
    std::vector<Face> faces;
    double area = 0;
    bool has_old_faces = false; // of its label beside it
  };

  bool is_new(Face f) const { return region_area_[std::size_t(f)] > 0; }

  bool is_fragment(const Region& region) const {
    return !region.has_old_faces && region.area < least_area(region.faces.front());
  }

  double least_area(Face first) const { return least_share * region_area_[std::size_t(first)]; }

  // The new faces of one label that are connected with the first: all, or until they are no fragment.
  Region grow(Face first, std::vector<bool>& visited, bool all) const {
    Region region;
    region.faces = {first};
    visited[std::size_t(first)] = true;
    for (std::size_t i = 0; i < region.faces.size() && (all || region.area < least_area(first)); ++i) {
      const auto side = surface_.halfedge(region.faces[i]);
      region.area += std::sqrt(area_vector(side, surface_).squared_length());
      for (auto h : CGAL::halfedges_around_face(side, surface_)) {
        const Face g = surface_.face(surface_.opposite(h));
        if (g == Surface::null_face() || label_[g] != label_[first] || visited[std::size_t(g)])
          continue;
        if (!is_new(g)) {
          region.has_old_faces = true;
          continue;
        }
        visited[std::size_t(g)] = true;
        region.faces.push_back(g);
      }
    }
    return region;
  }

  void take_label_around(const Region& region) {
    std::map<int, double> length;
    const int own = label_[region.faces.front()];
    for (Face f : region.faces)
      for (auto h : CGAL::halfedges_around_face(surface_.halfedge(f), surface_)) {
        const Face g = surface_.face(surface_.opposite(h));
        if (g != Surface::null_face() && label_[g] != own)
          length[label_[g]] += point_distance(surface_.point(surface_.source(h)), surface_.point(surface_.target(h)));
      }
    if (length.empty())
      return;
    const int label = std::max_element(length.begin(), length.end(), [](const auto& a, const auto& b) {
                        return a.second < b.second;
                      })->first;
    for (Face f : region.faces)
      label_[f] = label;
  }

  const Surface& surface_;
  Face_patch_map label_;
  const std::vector<double>& region_area_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_LABEL_FRAGMENTS_H
