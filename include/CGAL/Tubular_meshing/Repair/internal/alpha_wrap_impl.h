// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_ALPHA_WRAP_IMPL_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_ALPHA_WRAP_IMPL_H

#include <CGAL/Tubular_meshing/Repair/internal/alpha_wrap.h>

#include <CGAL/alpha_wrap_3.h>

#include <vector>

namespace CGAL::Tubular_meshing::internal {

CGAL_TUBULAR_MESHING_INLINE void alpha_wrap(const std::vector<Point_3>& points,
                                            const std::vector<Index_triangle>& triangles, double alpha, double offset,
                                            Surface& wrap) {
  CGAL::alpha_wrap_3(points, triangles, alpha, offset, wrap);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_ALPHA_WRAP_IMPL_H
