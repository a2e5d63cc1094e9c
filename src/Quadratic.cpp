// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/Quadratic/Quadratic_mesh_impl.h>
#include <CGAL/Tubular_meshing/Quadratic/make_quadratic_mesh_impl.h>
#include <CGAL/Tubular_meshing/Quadratic/quadratic_quality_impl.h>
