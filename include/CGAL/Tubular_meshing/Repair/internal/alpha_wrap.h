// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_ALPHA_WRAP_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_ALPHA_WRAP_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Triangle_soup.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* CGAL's alpha_wrap_3() of some triangles: alone in a file of its own, as it takes long to compile. */
void alpha_wrap(const std::vector<Point_3>& points, const std::vector<Index_triangle>& triangles, double alpha,
                double offset, Surface& wrap);

} // namespace CGAL::Tubular_meshing::internal

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Repair/internal/alpha_wrap_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_ALPHA_WRAP_H
