// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/Patches/cut_by_centerlines_impl.h>
#include <CGAL/Tubular_meshing/Patches/follow_blind_vessels_impl.h>
