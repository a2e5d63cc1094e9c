// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/Fields/Centerline_metric_field_impl.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field_impl.h>
#include <CGAL/Tubular_meshing/Fields/Local_radius_impl.h>
#include <CGAL/Tubular_meshing/Fields/Sampled_metric_impl.h>
#include <CGAL/Tubular_meshing/Fields/Shape_radius_impl.h>
#include <CGAL/Tubular_meshing/Fields/Wall_samples_impl.h>
#include <CGAL/Tubular_meshing/Fields/curvature_impl.h>
