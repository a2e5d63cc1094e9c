// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Files that a library writes, where it was found. Compiled with its headers and macros, which no other file needs.

#include <CGAL/Tubular_meshing/IO/hdf5_at_exit_impl.h>
#include <CGAL/Tubular_meshing/IO/write_cgns_impl.h>
#include <CGAL/Tubular_meshing/IO/write_exodus_impl.h>
#include <CGAL/Tubular_meshing/IO/write_xdmf_impl.h>
