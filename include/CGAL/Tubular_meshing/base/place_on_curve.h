// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_PLACE_ON_CURVE_H
#define CGAL_TUBULAR_MESHING_BASE_PLACE_ON_CURVE_H

#include <CGAL/Tubular_meshing/base/Nearest_tree.h>

#include <algorithm>
#include <cstdint>

namespace CGAL::Tubular_meshing::internal {

/* How far along Morton's curve, which fills space, a point in canonical coordinates is: points that are near each other
 * along it are near each other in space. In memory in this order, what is needed next is mostly at hand. The planes of
 * coordinates, where vertices of symmetric vessels are, lie in the middle of its cells: not rounding errors decide. */
inline std::uint64_t place_on_curve(const Double_kernel::Point_3& p) {
  const double steps = 1 << 21, reach = 8; // extents of the surface, few of which have points that are further out
  std::uint64_t result = 0;
  for (int k = 0; k < 3; ++k) {
    const double step = (p[k] + reach) * (steps / (2 * reach)) + 0.5;
    std::uint64_t x = std::uint64_t((std::min)((std::max)(step, 0.), steps - 1));
    x = (x | x << 32) & 0x1f00000000ffff; // two zeros after each bit
    x = (x | x << 16) & 0x1f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    x = (x | x << 2) & 0x1249249249249249;
    result |= x << k;
  }
  return result;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_PLACE_ON_CURVE_H
