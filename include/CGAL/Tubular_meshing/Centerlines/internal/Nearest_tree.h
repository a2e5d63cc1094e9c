// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_NEAREST_TREE_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_NEAREST_TREE_H

#include <CGAL/Tubular_meshing/internal/Nearest_tree.h>

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_NEAREST_TREE_H
