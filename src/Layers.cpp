// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/Layers/Wall_array_impl.h>
#include <CGAL/Tubular_meshing/Layers/Wall_materials_impl.h>
#include <CGAL/Tubular_meshing/Layers/Wall_thickness_impl.h>
#include <CGAL/Tubular_meshing/Layers/append_mesh_impl.h>
#include <CGAL/Tubular_meshing/Layers/extrude_boundary_layer_impl.h>
#include <CGAL/Tubular_meshing/Layers/extrude_wall_impl.h>
#include <CGAL/Tubular_meshing/Layers/unfold_wall_impl.h>
#include <CGAL/Tubular_meshing/Layers/wall_fibres_impl.h>
