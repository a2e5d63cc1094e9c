// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Compiled with the header of METIS, where it was found, which no other file needs.

#include <CGAL/Tubular_meshing/Partition/partition_cells_impl.h>
#include <CGAL/Tubular_meshing/Partition/partition_report_impl.h>
