// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/Hexahedra/hexahedral_blocks_impl.h>
#include <CGAL/Tubular_meshing/Hexahedra/insert_wall_layers_impl.h>
#include <CGAL/Tubular_meshing/Hexahedra/optimize_hexahedra_impl.h>
#include <CGAL/Tubular_meshing/Hexahedra/subdivide_into_hexahedra_impl.h>
