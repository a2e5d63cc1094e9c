// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_WALL_ARRAY_IMPL_H
#define CGAL_TUBULAR_MESHING_LAYERS_WALL_ARRAY_IMPL_H

#include <CGAL/Tubular_meshing/Layers/Wall_array.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

CGAL_TUBULAR_MESHING_INLINE void keep_wall(Wall_array& array, const std::vector<const Labelled_surface*>& surfaces) {
  using internal::to_double_point;
  std::vector<internal::Double_kernel::Triangle_3> faces;
  std::vector<char> is_wall;
  for (const Labelled_surface* s : surfaces)
    for (const auto f : s->surface.faces()) {
      const auto h = s->surface.halfedge(f);
      const auto corner = [&](auto k) { return to_double_point(s->surface.point(s->surface.target(k))); };
      faces.emplace_back(corner(h), corner(s->surface.next(h)), corner(s->surface.prev(h)));
      is_wall.push_back(s->patch[f] == labels::wall);
    }
  if (faces.empty())
    return;
  const internal::Nearest_tree<internal::Double_kernel::Triangle_3> tree(std::move(faces));
  std::size_t kept = 0;
  for (std::size_t i = 0; i < array.triangles.size(); ++i) {
    const auto& t = array.triangles[i];
    const Point_3 middle = CGAL::centroid(array.points[t[0]], array.points[t[1]], array.points[t[2]]);
    const std::size_t face = tree.nearest(to_double_point(middle)).index;
    if (face >= is_wall.size() || !is_wall[face])
      continue;
    array.triangles[kept] = array.triangles[i];
    if (array.of == Array_of::triangles)
      array.values[kept] = array.values[i];
    ++kept;
  }
  array.triangles.resize(kept);
  if (array.of == Array_of::triangles)
    array.values.resize(kept);
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_LAYERS_WALL_ARRAY_IMPL_H
