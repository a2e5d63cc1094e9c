// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/Rims/Rim_shape_impl.h>
#include <CGAL/Tubular_meshing/Rims/planar_cap_impl.h>
#include <CGAL/Tubular_meshing/Rims/trim_by_plane_impl.h>
