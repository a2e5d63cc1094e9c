// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_PLACE_OF_H
#define CGAL_TUBULAR_MESHING_BASE_PLACE_OF_H

#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <sstream>
#include <string>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

// A place as a sentence names it: "(1, 2, 3)".
inline std::string place_of(const Vector_3d& p, int digits = 9) {
  std::ostringstream s;
  s.precision(digits);
  s << "(" << p.x << ", " << p.y << ", " << p.z << ")";
  return s.str();
}

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_BASE_PLACE_OF_H
