// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/Repair/carry_labels_impl.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface_impl.h>
#include <CGAL/Tubular_meshing/Repair/split_into_parts_impl.h>
