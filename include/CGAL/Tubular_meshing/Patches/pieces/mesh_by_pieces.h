// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PIECES_MESH_BY_PIECES_H
#define CGAL_TUBULAR_MESHING_PATCHES_PIECES_MESH_BY_PIECES_H

#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Piece_mesher.h>

#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The steps of remesh_patches(), and those of quadrangulate_patches(): meshes the pieces of a cut surface and joins
 * them. Where the outcome is no surface, as pieces touch themselves or each other in meshes that are too coarse for
 * them, the pieces concerned are meshed again, finer.
 *
 * Throws Meshing_error if they meet each other even where they are eight times finer. */
Remeshed_surface mesh_by_pieces(const Surface_cut& cut, const std::vector<Patch_parameterization>& maps,
                                Piece_mesher& mesher);

} // namespace CGAL::Tubular_meshing::internal

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Patches/pieces/mesh_by_pieces_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_PATCHES_PIECES_MESH_BY_PIECES_H
