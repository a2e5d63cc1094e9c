// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_REPORT_LAYERS_H
#define TUBULAR_MESH_REPORT_LAYERS_H

#include "json.h"

#include <CGAL/Tubular_meshing/Layers/Layer_report.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>

/* Layers of the vessel's wall or along it, where they had to give way, and what the wall is made of. */
void add_layers(Json& report, const char* name, const CGAL::Tubular_meshing::Layer_report& layers);
void add_materials(Json& report, const CGAL::Tubular_meshing::Mixed_mesh& mesh);

void print_layers(const Json& report);
void print_materials(const Json& materials);

#endif // TUBULAR_MESH_REPORT_LAYERS_H
