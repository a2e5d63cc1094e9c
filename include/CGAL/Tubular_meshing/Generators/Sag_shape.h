// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_GENERATORS_SAG_SHAPE_H
#define CGAL_TUBULAR_MESHING_GENERATORS_SAG_SHAPE_H

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 * How the rim of a generated opening leaves its plane. */
enum class Sag_shape {
  saddle, ///< twice up and twice down around the rim, by cos(2a)
  tilt    ///< an oblique ellipse, by cos(a)
};

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_GENERATORS_SAG_SHAPE_H
