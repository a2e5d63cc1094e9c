// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PARAMETERIZATION_METHOD_H
#define CGAL_TUBULAR_MESHING_PATCHES_PARAMETERIZATION_METHOD_H

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPatches
 *
 * How a patch was mapped onto the plane: each of these is tried when the one before gave no bijection.
 */
enum class Parameterization_method {
  conformal,          ///< keeps angles
  conformal_repaired, ///< conformal, but near triangles that were flipped: there mean value coordinates
  harmonic,           ///< by cotangents, bounded from below, with the outer loop on a circle: mostly near conformal
  mean_value,         ///< Floater's mean value coordinates, with the outer loop on a circle by its lengths
  uniform,            ///< Tutte's map: each vertex in the middle of its neighbours
  shortened           ///< for long blind branches: as if the surface were less deep, as seen from its outer loop
};

/*! \ingroup PkgTubularMeshingPatches
 * Its name, as reports print it. */
inline const char* name_of(Parameterization_method method) {
  switch (method) {
  case Parameterization_method::conformal:
    return "conformal";
  case Parameterization_method::conformal_repaired:
    return "conformal_repaired";
  case Parameterization_method::harmonic:
    return "harmonic";
  case Parameterization_method::mean_value:
    return "mean_value";
  case Parameterization_method::uniform:
    return "uniform";
  default:
    return "shortened";
  }
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PATCHES_PARAMETERIZATION_METHOD_H
