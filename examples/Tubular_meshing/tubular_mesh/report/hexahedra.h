// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_REPORT_HEXAHEDRA_H
#define TUBULAR_MESH_REPORT_HEXAHEDRA_H

#include "json.h"

#include <CGAL/Tubular_meshing/Pipelines/Hexahedral_report.h>

/* How hexahedra were made, and where not in blocks. */
void add_hexahedral(Json& report, const CGAL::Tubular_meshing::Hexahedral_report& hexahedral);
void print_hexahedral(const Json& hexahedral);

#endif // TUBULAR_MESH_REPORT_HEXAHEDRA_H
