// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// For tests of walls.

#ifndef TUBULAR_MESHING_TEST_WALL_VERTICES_H
#define TUBULAR_MESHING_TEST_WALL_VERTICES_H

#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <cstddef>
#include <cstdint>
#include <set>

// Those of the facets between lumen and wall.
inline std::set<std::uint32_t> wall_vertices(const CGAL::Tubular_meshing::Mixed_mesh& mesh) {
  std::set<std::uint32_t> vertices;
  const auto collect = [&](const auto& facets) {
    for (std::size_t i = 0; i < facets.size(); ++i)
      if (facets.label[i] == CGAL::Tubular_meshing::labels::wall)
        vertices.insert(facets.vertices[i].begin(), facets.vertices[i].end());
  };
  collect(mesh.triangles);
  collect(mesh.quads);
  return vertices;
}

#endif // TUBULAR_MESHING_TEST_WALL_VERTICES_H
