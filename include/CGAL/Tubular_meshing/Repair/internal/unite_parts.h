// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_UNITE_PARTS_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_UNITE_PARTS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* What became of the parts of a surface that touch others. */
struct United_parts {
  std::size_t united = 0; ///< that crossed another one, and are one with it now
  std::size_t inside = 0; ///< that lay inside of another one, and are gone
  double share = 0;       ///< of the area, of those inside
  Point_3 crossing;       ///< the first place of two that crossed
  Point_3 place_inside;   ///< on the first one inside
};

/* Unites the parts of a surface that cross each other: the boundary of the union of their lumens, by corefinement, of
 * which what closed the parts' border loops is taken away again. A part that lies inside of another one is dropped.
 * Each part has to be turned outward and free of crossings. Throws Input_error where two parts cannot be united. */
United_parts unite_parts(Surface& mesh);

} // namespace CGAL::Tubular_meshing::internal

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Repair/internal/unite_parts_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_UNITE_PARTS_H
