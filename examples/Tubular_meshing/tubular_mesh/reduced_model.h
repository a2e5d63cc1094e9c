// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_REDUCED_MODEL_H
#define TUBULAR_MESH_REDUCED_MODEL_H

#include "Run.h"
#include "Stage_clock.h"

// Cross-sections of all branches, and the zero-dimensional model made from them, if they are wanted.
void make_reduced_model(Run& run, Stage_clock& clock);

#endif // TUBULAR_MESH_REDUCED_MODEL_H
