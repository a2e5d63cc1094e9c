// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/Generators/Tubular_distance_function_impl.h>
#include <CGAL/Tubular_meshing/Generators/Tubular_skeleton_impl.h>
#include <CGAL/Tubular_meshing/Generators/bronchial_tree_impl.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes_impl.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface_impl.h>
