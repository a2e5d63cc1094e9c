// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_SIZE_NEAR_SURFACE_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_SIZE_NEAR_SURFACE_H

#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A size field, but no larger than the edges of a surface near it, from which sizes grow by a part of the distance.
 * Structured quads need not have the size that was asked for, and what is left by layers of cells does not know of it;
 * tetrahedra much larger than the facets that they stand on are bad ones. */
class Size_near_surface {
public:
  Size_near_surface(Length_function field, const Mixed_mesh& surface)
      : field_(field)
      , mean_edge_(surface.points.size(), 0)
      , points_(positions(surface.points))
      , tree_(points_.begin(), points_.end(), Tree::Splitter(), Search_traits()) {
    std::vector<double> edges(surface.points.size(), 0);
    const auto add = [&](const auto& block) {
      for (const auto& f : block.vertices)
        for (std::size_t i = 0; i < f.size(); ++i) {
          const std::uint32_t v = f[i], w = f[(i + 1) % f.size()];
          const double length = norm(Vector_3d(surface.points[v]) - Vector_3d(surface.points[w]));
          for (std::uint32_t u : {v, w}) {
            mean_edge_[u] += length;
            ++edges[u];
          }
        }
    };
    add(surface.triangles);
    add(surface.quads);
    for (std::size_t v = 0; v < edges.size(); ++v)
      mean_edge_[v] /= (std::max)(edges[v], 1.);
    tree_.build();
  }
  Size_near_surface(const Size_near_surface&) = delete;
  Size_near_surface& operator=(const Size_near_surface&) = delete;

  double operator()(const Point_3& p) const {
    const Search search(tree_, to_double_point(p), 1);
    const auto& nearest = *search.begin();
    return (std::min)(field_(p), mean_edge_[nearest.first.second] + growth * std::sqrt(nearest.second));
  }

private:
  static constexpr double growth = 0.15; // of 0.3, quads half as wide as long leave a mean quality below 0.7

  typedef std::pair<Double_kernel::Point_3, std::uint32_t> Entry; // a vertex's position and number
  typedef CGAL::First_of_pair_property_map<Entry> Position_map;
  typedef CGAL::Search_traits_adapter<Entry, Position_map, CGAL::Search_traits_3<Double_kernel>> Search_traits;
  typedef CGAL::Orthogonal_k_neighbor_search<Search_traits> Search;
  typedef Search::Tree Tree;

  static std::vector<Entry> positions(const std::vector<Point_3>& points) {
    std::vector<Entry> entries;
    for (const Point_3& p : points)
      entries.push_back({to_double_point(p), std::uint32_t(entries.size())});
    return entries;
  }

  Length_function field_;
  std::vector<double> mean_edge_; // at each vertex
  std::vector<Entry> points_;
  Tree tree_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_SIZE_NEAR_SURFACE_H
