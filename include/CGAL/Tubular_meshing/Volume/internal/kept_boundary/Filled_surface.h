// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_FILLED_SURFACE_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_FILLED_SURFACE_H

#include <CGAL/Tubular_meshing/Patches/surface_to_mixed_mesh.h>
#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Delaunay_refinement.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/recover_boundary.h>
#include <CGAL/Tubular_meshing/Volume/internal/order_in_space.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <optional>
#include <string>
#include <utility>

namespace CGAL::Tubular_meshing::internal {

/* A closed surface and the tetrahedra inside it, which stay in a store, where they can be changed, until they are good.
 */
class Filled_surface {
public:
  /* Where the circumscribed radius exceeds this part of h the circumcenter becomes a point: the mean edge inside is 1.05
   * h then, as it is with Mesh_3. Bounds on volume or edges that give as many tetrahedra leave up to twice as many
   * slivers. */
  static constexpr double radius_bound = 0.78;

  /* Fills a closed surface, which stays as it is. Returns what went wrong, if anything did: nothing has changed then. */
  std::optional<Sentence> fill(const Surface& surface, Face_patch_map patch, Length_function size,
                               const Boundary_recovery& recovery, const Filling_limits& limits) {
    Mixed_mesh mesh;
    surface_to_mixed_mesh(surface, patch, mesh);
    if (!mesh.quads.empty())
      throw Input_error("Only a surface of triangles can be filled with tetrahedra; this one has quads.");
    const auto surface_points = Tetrahedron_store::Index(mesh.points.size());
    std::optional<Tetrahedron_store> store;
    if (std::optional<Sentence> failure = recover_boundary(surface, recovery, limits, mesh, store))
      return failure;
    Element_block<3> triangles = std::move(mesh.triangles);
    mesh = Mixed_mesh();
    if (Delaunay_refinement(*store, size, radius_bound, limits.threads)(limits.most_points) == limits.most_points)
      return "A mesh this fine would have more than " + std::to_string(limits.most_points) +
             " points inside, more than the memory of this machine holds: make it coarser.";
    sort_in_space(*store, surface_points, limits.threads);
    triangles_ = std::move(triangles);
    store_ = std::move(store);
    return std::nullopt;
  }

  // Once it is filled.
  Tetrahedron_store& tetrahedra() { return *store_; }

  // The surface's points come first, and its triangles are its faces, in their order.
  void write_to(Mixed_mesh& mesh) {
    mesh = Mixed_mesh();
    mesh.triangles = std::move(triangles_);
    store_->write_inside_to(mesh);
    mesh.region_names = {{labels::lumen, "lumen"}};
    store_.reset();
  }

private:
  Element_block<3> triangles_;
  std::optional<Tetrahedron_store> store_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_FILLED_SURFACE_H
