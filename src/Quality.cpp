// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/Quality/Mesh_check_impl.h>
#include <CGAL/Tubular_meshing/Quality/boundary_layer_report_impl.h>
#include <CGAL/Tubular_meshing/Quality/branch_resolution_impl.h>
#include <CGAL/Tubular_meshing/Quality/element_quality_impl.h>
#include <CGAL/Tubular_meshing/Quality/mesh_report_impl.h>
#include <CGAL/Tubular_meshing/Quality/quality_report_impl.h>
#include <CGAL/Tubular_meshing/Quality/validity_report_impl.h>
