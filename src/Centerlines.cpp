// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field_impl.h>
#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph_impl.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance_impl.h>
#include <CGAL/Tubular_meshing/Centerlines/branched_centerlines_impl.h>
#include <CGAL/Tubular_meshing/Centerlines/build_centerline_graph_impl.h>
#include <CGAL/Tubular_meshing/Centerlines/check_centerlines_impl.h>
#include <CGAL/Tubular_meshing/Centerlines/clip_to_openings_impl.h>
#include <CGAL/Tubular_meshing/Centerlines/compute_centerlines_impl.h>
#include <CGAL/Tubular_meshing/Centerlines/cross_sections_impl.h>
#include <CGAL/Tubular_meshing/Centerlines/zero_d_model_impl.h>
