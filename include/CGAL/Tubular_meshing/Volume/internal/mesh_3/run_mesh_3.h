// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_RUN_MESH_3_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_RUN_MESH_3_H

#include <CGAL/Tubular_meshing/Rims/rim_corners.h>
#include <CGAL/Tubular_meshing/Volume/internal/mesh_3/Watched_size.h>
#include <CGAL/Tubular_meshing/Volume/internal/mesh_3/make_complex.h>
#include <CGAL/Tubular_meshing/Volume/internal/mesh_3/mesh_complex_to_mixed_mesh.h>
#include <CGAL/Tubular_meshing/Volume/internal/mesh_3/rim_polylines.h>

#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

// The size times a constant, light enough for Mesh_3's habit of copying fields by value.
struct Scaled_size {
  typedef double FT;
  const Watched_size* size;
  FT factor;

  template <class Index> FT operator()(const Point_3& p, int, const Index&) const { return factor * (*size)(p); }
};

// Mesh_3 bounds the radii of Delaunay balls, not edges: these ratios make the mean edge, on the surface and inside,
// about h (0.95 h and 1.06 h after optimization, on the vessels that were measured).
constexpr double facet_ball_radius = 0.9;
constexpr double cell_ball_radius = 0.81;
constexpr double facet_angle_bound = 25; // degrees; Mesh_3 is proved to end up to 30
constexpr double radius_edge_ratio_bound = 2;

// `labelled_surface` has its labels in CGAL's own property map of patches. What the size throws comes through.
inline void run_mesh_3(Surface& labelled_surface, const Watched_size& size, double facet_distance, Mixed_mesh& mesh) {
  Lumen_domain domain(labelled_surface, size);
  std::vector<Rim_polyline> rims;
  for (const Rim_polyline& rim : rim_polylines(labelled_surface, get(face_patch_id_t<int>(), labelled_surface)))
    for (auto& piece : split_at_corners(rim.points, [&](const Point_3& p) { return 0.5 * size(p); }))
      rims.push_back({std::move(piece), rim.patches});
  domain.add_features_and_incidences(rims.begin(), rims.end(), Rim_points_map(), Rim_patches_map());

  const Lumen_criteria criteria = {
      Lumen_criteria::Edge_criteria(Scaled_size{&size, 1.}),
      Lumen_criteria::Facet_criteria(facet_angle_bound, Scaled_size{&size, facet_ball_radius},
                                     Scaled_size{&size, facet_distance}),
      Lumen_criteria::Cell_criteria(radius_edge_ratio_bound, Scaled_size{&size, cell_ball_radius})};
  Lumen_complex complex;
  make_complex(domain, criteria, complex);
  mesh_complex_to_mixed_mesh(complex, mesh);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_RUN_MESH_3_H
