// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_OPENING_H
#define CGAL_TUBULAR_MESHING_BASE_OPENING_H

#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <CGAL/Kernel_traits.h>

#include <cstddef>
#include <limits>
#include <string>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingBase
 *
 * An end of the tubular surface through which fluid enters or leaves: an open boundary loop, or the flat cap that
 * closes it. Openings are numbered in the order in which they are listed: 0 is the inlet, i > 0 is outlet i.
 */
struct Opening {
  typedef typename Kernel_traits<Point_3>::Kernel::Vector_3 Vector_3;

  static constexpr std::size_t no_branch = (std::numeric_limits<std::size_t>::max)();

  Point_3 center;  ///< centroid of the cap's area
  Vector_3 normal; ///< unit, out of the lumen
  double area = 0; ///< of the cap
  double perimeter = 0;
  double radius = 0;              ///< of the disk of the same area
  std::size_t branch = no_branch; ///< the branch of the centerline graph that ends here
  std::size_t node = no_branch;   ///< the end node of the centerline graph that lies here
  int patch = 0;                  ///< the label of the cap's facets
  std::string name;               ///< that of the patch in the output; empty: inlet, outlet_1, …
};

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_BASE_OPENING_H
