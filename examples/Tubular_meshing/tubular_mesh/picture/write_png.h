// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_PICTURE_WRITE_PNG_H
#define TUBULAR_MESH_PICTURE_WRITE_PNG_H

#include "Raster.h"

#include <string>

// The bytes of a PNG file.
std::string png_of(const Image& image);

#endif // TUBULAR_MESH_PICTURE_WRITE_PNG_H
