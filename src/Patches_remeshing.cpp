// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/Patches/metric_surface_report_impl.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Piece_mesher_impl.h>
#include <CGAL/Tubular_meshing/Patches/remesh_patches_impl.h>
#include <CGAL/Tubular_meshing/Patches/surface_to_mixed_mesh_impl.h>
