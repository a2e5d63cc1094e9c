// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_VOLUME_MESHER_IMPL_H
#define CGAL_TUBULAR_MESHING_VOLUME_VOLUME_MESHER_IMPL_H

#include <CGAL/Tubular_meshing/Volume/Volume_mesher.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/boundary_recovery.h>

namespace CGAL::Tubular_meshing {

CGAL_TUBULAR_MESHING_INLINE bool has_tetgen() {
  return internal::tetgen_recovery().is_there();
}
CGAL_TUBULAR_MESHING_INLINE bool has_ccdt() {
  return internal::ccdt_recovery().is_there();
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_VOLUME_VOLUME_MESHER_IMPL_H
