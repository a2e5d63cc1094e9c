// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_REPAIR_SURFACE_OPTIONS_H
#define CGAL_TUBULAR_MESHING_REPAIR_REPAIR_SURFACE_OPTIONS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingRepair
 *
 * How far repair_surface() goes. */
enum class Repair_mode {
  off,       ///< the triangles are connected and oriented, nothing else
  automatic, ///< what is wrong is repaired where it is; where that fails, the surface is wrapped
  wrap       ///< the surface is repaired as far as possible, and then wrapped in any case
};

/*! \ingroup PkgTubularMeshingRepair
 *
 * The options of repair_surface(): its named parameters of the same names. */
struct Repair_surface_options {
  Repair_mode repair_mode = Repair_mode::automatic;
  bool smooth = false;                ///< whether staircase noise is smoothed off at last
  std::size_t number_of_parts = 1;    ///< of the vessels in the surface, so many are kept, by area; 0: all
  std::vector<Point_3> filled_holes;  ///< at each the nearest border loop is filled, however large
  std::vector<Point_3> kept_openings; ///< at each the nearest border loop is kept open, however small

  Repair_surface_options() = default;
  template <class NamedParameters>
  explicit Repair_surface_options(const NamedParameters& np)
      : repair_mode(internal::choose(np, internal_np::repair_mode, Repair_mode::automatic))
      , smooth(internal::choose(np, internal_np::smooth, false))
      , number_of_parts(internal::choose(np, internal_np::number_of_parts, std::size_t(1)))
      , filled_holes(internal::choose(np, internal_np::filled_holes, std::vector<Point_3>()))
      , kept_openings(internal::choose(np, internal_np::kept_openings, std::vector<Point_3>())) {}
};

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_REPAIR_REPAIR_SURFACE_OPTIONS_H
