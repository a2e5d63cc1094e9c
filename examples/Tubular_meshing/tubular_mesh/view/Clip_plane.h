// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_VIEW_CLIP_PLANE_H
#define TUBULAR_MESH_VIEW_CLIP_PLANE_H

#include "Shown_mesh.h"

#include <cstddef>
#include <vector>

/* A plane whose normal points to where cells are taken away. */
struct Clip_plane {
  Shown_mesh::Vector point, normal;

  bool keeps(const Shown_mesh::Vector& center) const {
    return CGAL::Tubular_meshing::internal::dot(center - point, normal) <= 0;
  }
};

/* What is seen of a mesh from outside, whole or cut by whole cells: those stay whose centre the plane keeps. */
struct Seen_faces {
  struct Cut_face {
    std::size_t cell;
    Shown_mesh::Face face;
  };
  std::vector<std::size_t> facets;
  std::vector<Cut_face> cut; ///< and a few behind them; where a facet is there too, it lies on it
};

Seen_faces seen_faces(const Shown_mesh& mesh);
Seen_faces seen_faces(const Shown_mesh& mesh, const Clip_plane& plane);

#endif // TUBULAR_MESH_VIEW_CLIP_PLANE_H
