// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_EXECUTE_H
#define TUBULAR_MESH_EXECUTE_H

#include "Options.h"

#include <string>

// Reads, meshes, writes and prints what the options ask for; throws an Error where that cannot be done.
void execute(const Options& options, const std::string& version);

#endif // TUBULAR_MESH_EXECUTE_H
