// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_PAGE_PACK_SCENE_H
#define TUBULAR_MESH_PAGE_PACK_SCENE_H

#include "../view/Shown_mesh.h"

#include <cstddef>
#include <string>
#include <vector>

/* A mesh as the page carries it: the facets whole, and cells in the order of the branches, as many as fit. */
struct Packed_scene {
  std::string header;             // JSON: how the rest is to be read
  std::vector<std::string> parts; // base64: the facets, then chunks of cells
  std::size_t cells = 0;          // that it has
  std::size_t whole_branches = 0; // of which all cells are there: those before this one
};

// In at most so many bytes, but for the facets.
Packed_scene pack_scene(const Shown_mesh& mesh, std::size_t most_bytes);

#endif // TUBULAR_MESH_PAGE_PACK_SCENE_H
