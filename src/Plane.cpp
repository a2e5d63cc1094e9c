// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/Plane/triangulate_in_metric_impl.h>
#include <CGAL/Tubular_meshing/Plane/triangulate_polygons_impl.h>
