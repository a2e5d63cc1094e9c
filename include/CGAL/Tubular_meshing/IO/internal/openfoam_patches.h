// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_OPENFOAM_PATCHES_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_OPENFOAM_PATCHES_H

#include <CGAL/Tubular_meshing/IO/internal/Face_mesh.h>
#include <CGAL/Tubular_meshing/IO/internal/Openfoam_files.h>
#include <CGAL/Tubular_meshing/IO/internal/Wall_patches.h>
#include <CGAL/Tubular_meshing/IO/internal/names_in_files.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

// The patches of a mesh, in the order of its faces; last, if there are any, the faces that have none.
inline std::vector<Openfoam_patch> openfoam_patches(const Face_mesh& faces) {
  const Label_names names = patch_names_in_file(faces.cells().mesh(), Mesh_format::openfoam);
  const Wall_patches walls(faces.cells(), faces.facets());
  std::vector<Openfoam_patch> patches;
  for (const auto& p : faces.patches()) {
    const bool is_wall = walls.contain(p.first);
    patches.push_back({names.at(p.first),
                       openfoam_entry("type", is_wall ? "wall" : "patch") +
                           (is_wall ? openfoam_entry("inGroups", "1(wall)") : std::string()),
                       p.second.size()});
  }
  if (!faces.faces_without_patch().empty())
    patches.push_back({"defaultFaces", openfoam_entry("type", "patch"), faces.faces_without_patch().size()});
  return patches;
}

// One region that is the lumen needs no name.
inline bool has_openfoam_cell_zones(const Mixed_mesh& mesh) {
  return labels_of(mesh, 3) != std::set<int>{labels::lumen};
}

// Calls f(number, label, flipped) for the faces between cells that a facet lies on: a face is flipped where its owner
// lies on the other side than the lower region.
template <class F> void for_each_face_in_zone(const Face_mesh& faces, F f) {
  std::size_t number = 0;
  faces.for_each_inner_face_and_facet([&](const Face_mesh::Inner_face& face, std::uint32_t facet) {
    if (facet != no_cell)
      f(number, faces.facets().label(facet), face.owner.cell != faces.facets().sides(facet)[0].cell);
    ++number;
  });
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_OPENFOAM_PATCHES_H
