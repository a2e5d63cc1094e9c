// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_REPORT_SURFACE_MESH_H
#define TUBULAR_MESH_REPORT_SURFACE_MESH_H

#include "json.h"

#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>

/* How a surface was cut, mapped and meshed, patch by patch. */
void add_patches(Json& report, const CGAL::Tubular_meshing::Remeshed_surface& surface);
void add_quads(Json& report, const CGAL::Tubular_meshing::Quad_report& quads);

/* Of a surface alone, whose validity is its own. */
void describe_surface(Json& report, const CGAL::Tubular_meshing::Remeshed_surface& surface);

void print_patches(const Json& patches);
void print_quads(const Json& quads);

#endif // TUBULAR_MESH_REPORT_SURFACE_MESH_H
