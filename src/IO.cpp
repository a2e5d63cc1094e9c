// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/IO/Mesh_format_impl.h>
#include <CGAL/Tubular_meshing/IO/Output_file_impl.h>
#include <CGAL/Tubular_meshing/IO/Output_folder_impl.h>
#include <CGAL/Tubular_meshing/IO/read_centerlines_impl.h>
#include <CGAL/Tubular_meshing/IO/read_mesh_impl.h>
#include <CGAL/Tubular_meshing/IO/read_surface_impl.h>
#include <CGAL/Tubular_meshing/IO/unfinished_outputs_impl.h>
#include <CGAL/Tubular_meshing/IO/write_centerlines_impl.h>
#include <CGAL/Tubular_meshing/IO/write_mesh_impl.h>
#include <CGAL/Tubular_meshing/IO/write_surface_impl.h>
#include <CGAL/Tubular_meshing/IO/write_sections_impl.h>
