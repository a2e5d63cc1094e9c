// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/Volume/Volume_mesher_impl.h>
#include <CGAL/Tubular_meshing/Volume/anisotropic_tetrahedral_remeshing_impl.h>
#include <CGAL/Tubular_meshing/Volume/fill_keeping_boundary_impl.h>
#include <CGAL/Tubular_meshing/Volume/fill_with_pyramids_and_tetrahedra_impl.h>
#include <CGAL/Tubular_meshing/Volume/move_boundary_to_surface_impl.h>
#include <CGAL/Tubular_meshing/Volume/optimize_tetrahedra_impl.h>
#include <CGAL/Tubular_meshing/Volume/preserve_volume_impl.h>
