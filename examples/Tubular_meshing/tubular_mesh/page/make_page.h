// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_PAGE_MAKE_PAGE_H
#define TUBULAR_MESH_PAGE_MAKE_PAGE_H

#include "../view/Shown_mesh.h"

#include <cstddef>
#include <string>

/* A report as one page of HTML that needs nothing else: the mesh in 3D, where the program has the viewer; still
 * pictures; and all figures as tables.
 *
 * \param report that of Run_report, as JSON
 * \param command that made it; empty: not known
 * \param most_bytes of the page; what is always there, the facets and the tables, may take more */
std::string make_page(const std::string& report, const Shown_mesh& mesh, const std::string& command,
                      std::size_t most_bytes);

// Whether the program shows meshes in 3D.
bool has_viewer();

#endif // TUBULAR_MESH_PAGE_MAKE_PAGE_H
