// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/base/crossing_pairs_impl.h>
#include <CGAL/Tubular_meshing/base/interruption_impl.h>
#include <CGAL/Tubular_meshing/base/parallel_impl.h>
