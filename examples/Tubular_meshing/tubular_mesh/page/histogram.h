// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_PAGE_HISTOGRAM_H
#define TUBULAR_MESH_PAGE_HISTOGRAM_H

#include <string>
#include <vector>

// A picture, as SVG, of how many elements are in each part of [0, 1].
std::string histogram(const std::vector<double>& counts, const std::string& title);

#endif // TUBULAR_MESH_PAGE_HISTOGRAM_H
