// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/IO/write_openfoam_impl.h>
#include <CGAL/Tubular_meshing/IO/write_febio_impl.h>
#include <CGAL/Tubular_meshing/IO/write_fluent_impl.h>
#include <CGAL/Tubular_meshing/IO/write_su2_impl.h>
#include <CGAL/Tubular_meshing/IO/write_svmultiphysics_impl.h>
#include <CGAL/Tubular_meshing/IO/write_partitioned_mesh_impl.h>
