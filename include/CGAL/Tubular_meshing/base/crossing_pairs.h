// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_CROSSING_PAIRS_H
#define CGAL_TUBULAR_MESHING_BASE_CROSSING_PAIRS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

typedef std::vector<std::pair<Surface::Face_index, Surface::Face_index>> Face_pairs;

/* The pairs of triangles, of all or of those given, that meet elsewhere than at a common edge or vertex: the smaller
 * index first, in order. O(n log n) with CGAL's exact test, which is compiled once, here. On one thread: CGAL's
 * parallel version took twice the time on two cores. */
Face_pairs crossing_pairs(const Surface& surface);
Face_pairs crossing_pairs(const std::vector<Surface::Face_index>& faces, const Surface& surface);

} // namespace CGAL::Tubular_meshing::internal

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/base/crossing_pairs_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_BASE_CROSSING_PAIRS_H
