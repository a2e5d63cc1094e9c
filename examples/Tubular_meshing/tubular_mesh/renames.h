// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_RENAMES_H
#define TUBULAR_MESH_RENAMES_H

#include "Run.h"
#include "parts.h"

#include <vector>

/* Gives the patches of the vessels the names that are asked for, before the work of meshing. Throws a Parameter_error
 * if a name that is to be changed is not there, or if two patches would have one name. */
void rename_patches(const Run& run, std::vector<Part>& parts);

/* The same for patches that came with walls. */
void rename_wall_patches(Run& run);

#endif // TUBULAR_MESH_RENAMES_H
