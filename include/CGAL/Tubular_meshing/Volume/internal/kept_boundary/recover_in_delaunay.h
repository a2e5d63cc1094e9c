// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_RECOVER_IN_DELAUNAY_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_RECOVER_IN_DELAUNAY_H

#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Boundary_in_delaunay.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Recovered_boundary.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Takes away the tetrahedra that can be reached from outside without crossing a triangle. False if a triangle is no
 * facet of a tetrahedron. */
inline bool keep_inside(const Boundary_arrays& boundary, int threads, Recovered_boundary& recovered) {
  Mixed_mesh mesh;
  mesh.points.reserve(boundary.points.size() + recovered.inner_points.size());
  const auto add = [&](const std::vector<Vector_3d>& points) {
    for (const Vector_3d& p : points)
      mesh.points.emplace_back(p.x, p.y, p.z);
  };
  add(boundary.points);
  add(recovered.inner_points);
  mesh.tetrahedra.label.assign(recovered.tetrahedra.size(), 0);
  mesh.tetrahedra.vertices = std::move(recovered.tetrahedra);
  mesh.triangles.vertices = boundary.triangles;
  for (std::size_t f = 0; f < boundary.triangles.size(); ++f)
    mesh.triangles.label.push_back(int(f) + 1); // by which those that are no facet are found
  const Tetrahedron_store store(mesh, threads);

  typedef Tetrahedron_store::Index Index;
  std::vector<char> is_facet(boundary.triangles.size() + 1, 0), is_outside(store.number_of_slots(), 0);
  std::vector<Index> reached;
  const auto reach = [&](Index t) {
    if (!is_outside[t])
      reached.push_back(t);
    is_outside[t] = 1;
  };
  for (Index t = 0; t < store.number_of_slots(); ++t)
    for (int i = 0; i < 4; ++i) {
      is_facet[std::size_t(store[t].label[i])] = 1;
      if (store[t].label[i] == 0 && store[t].neighbor[i] == Tetrahedron_store::none)
        reach(t);
    }
  for (std::size_t k = 0; k < reached.size(); ++k)
    for (int i = 0; i < 4; ++i) {
      const auto& t = store[reached[k]];
      if (t.label[i] == 0 && t.neighbor[i] != Tetrahedron_store::none)
        reach(Tetrahedron_store::tetrahedron_of(t.neighbor[i]));
    }
  recovered.tetrahedra.clear();
  for (Index t = 0; t < store.number_of_slots(); ++t)
    if (!is_outside[t])
      recovered.tetrahedra.push_back(store[t].v);
  return std::find(is_facet.begin() + 1, is_facet.end(), 0) == is_facet.end();
}

inline double volume_of(const std::vector<Vector_3d>& points,
                        const std::vector<std::array<std::uint32_t, 4>>& tetrahedra) {
  double volume = 0;
  for (const auto& t : tetrahedra)
    volume += std::abs(signed_volume(points[t[0]], points[t[1]], points[t[2]], points[t[3]]));
  return volume;
}

/* Fills the cavities around what is missing, all at once. recover(boundary, recovered): whether it could. False if they
 * did not get full. */
template <class Recover>
bool fill_cavities(const Cavities& cavities, std::size_t number_of_points, const Recover& recover,
                   Recovered_boundary& recovered) {
  Recovered_boundary filling;
  if (!recover(cavities.boundary, filling))
    return false;
  std::vector<Vector_3d> points = cavities.boundary.points;
  points.insert(points.end(), filling.inner_points.begin(), filling.inner_points.end());
  const double volume = volume_of(cavities.boundary.points, cavities.tetrahedra);
  const double rounding = 1e-9;
  if (std::abs(volume_of(points, filling.tetrahedra) - volume) > rounding * volume)
    return false; // what is between several cavities was filled, too
  for (auto& t : filling.tetrahedra) {
    for (std::uint32_t& v : t)
      v = v < cavities.vertex.size() ? cavities.vertex[v]
                                     : std::uint32_t(number_of_points + v - cavities.vertex.size());
    recovered.tetrahedra.push_back(t);
  }
  recovered.inner_points = std::move(filling.inner_points);
  return true;
}

/* Fills a closed surface with the Delaunay tetrahedra of its points. Where its triangles are small compared with the
 * vessel, few of them are not among their facets [Amenta, Choi, Dey, Leekha 2002]: the tetrahedra that these cross are a
 * cavity, which `recover(boundary, recovered)` fills. False, if so many are missing, or a cavity cannot be filled, that
 * the surface has to be recovered as a whole. */
template <class Recover>
bool recover_in_delaunay(const Boundary_arrays& boundary, int threads, const Recover& recover,
                         Recovered_boundary& recovered) {
  Boundary_in_delaunay delaunay(boundary);
  if (!delaunay.has_all_points() || !delaunay.has_most_triangles())
    return false;
  const Cavities cavities = delaunay.cavities();
  recovered.tetrahedra = delaunay.tetrahedra_outside_cavities();
  return (cavities.tetrahedra.empty() || fill_cavities(cavities, boundary.points.size(), recover, recovered)) &&
         keep_inside(boundary, threads, recovered);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_RECOVER_IN_DELAUNAY_H
