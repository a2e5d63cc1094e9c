// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_PICTURE_DRAW_MESH_H
#define TUBULAR_MESH_PICTURE_DRAW_MESH_H

#include "../view/Camera.h"
#include "../view/Clip_plane.h"
#include "../view/Coloring.h"
#include "Raster.h"

// What is seen of a mesh, in its colours, with the edges of its elements or without.
Image draw_mesh(const Shown_mesh& mesh, const Seen_faces& seen, const Coloring& coloring, const Camera& camera,
                int width, int height, bool has_edges);

#endif // TUBULAR_MESH_PICTURE_DRAW_MESH_H
