// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_VIEW_DEFLATE_H
#define TUBULAR_MESH_VIEW_DEFLATE_H

#include <string>
#include <string_view>

// Compressed, in zlib's format, which browsers and PNG know.
std::string deflated(std::string_view bytes);

std::string base64(std::string_view bytes);

#endif // TUBULAR_MESH_VIEW_DEFLATE_H
