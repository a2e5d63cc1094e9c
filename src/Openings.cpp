// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/Openings/close_openings_impl.h>
#include <CGAL/Tubular_meshing/Openings/cut_round_ends_impl.h>
#include <CGAL/Tubular_meshing/Openings/flow_extensions_impl.h>
#include <CGAL/Tubular_meshing/Openings/labelled_ends_impl.h>
#include <CGAL/Tubular_meshing/Openings/openings_impl.h>
#include <CGAL/Tubular_meshing/Openings/seeds_impl.h>
