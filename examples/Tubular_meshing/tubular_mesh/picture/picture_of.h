// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_PICTURE_PICTURE_OF_H
#define TUBULAR_MESH_PICTURE_PICTURE_OF_H

#include "../Options.h"
#include "../view/Shown_mesh.h"

#include <string>

// What --picture and its options ask for: the bytes of a PNG file.
std::string picture_of(const Shown_mesh& mesh, const Options& options);

#endif // TUBULAR_MESH_PICTURE_PICTURE_OF_H
