// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_DRY_RUN_H
#define TUBULAR_MESH_DRY_RUN_H

#include "Progress.h"
#include "Stage_clock.h"
#include "execute.h"

// Says of a surface that has been prepared what there is to mesh, and estimates the mesh; writes the report alone, if one
// is wanted.
void dry_run(Prepared& prepared, Stage_clock& clock, Progress& progress);

#endif // TUBULAR_MESH_DRY_RUN_H
