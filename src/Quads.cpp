// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/Quads/blossom_recombination_impl.h>
#include <CGAL/Tubular_meshing/Quads/elliptic_grid_impl.h>
#include <CGAL/Tubular_meshing/Quads/quadrangulate_annular_patches_impl.h>
#include <CGAL/Tubular_meshing/Quads/quadrangulate_patches_impl.h>
#include <CGAL/Tubular_meshing/Quads/recombine_triangles_impl.h>
