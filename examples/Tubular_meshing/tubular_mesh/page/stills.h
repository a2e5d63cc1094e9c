// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_PAGE_STILLS_H
#define TUBULAR_MESH_PAGE_STILLS_H

#include "../view/Shown_mesh.h"
#include "html.h"

#include <string>

// Still pictures, as SVG: the mesh with the names of openings, and cut in the middle with its centerlines.
std::string still_of_mesh(const html::Json& report, const Shown_mesh& mesh);
std::string still_of_cut(const Shown_mesh& mesh);

#endif // TUBULAR_MESH_PAGE_STILLS_H
