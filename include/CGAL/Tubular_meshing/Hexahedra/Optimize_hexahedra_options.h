// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_OPTIMIZE_HEXAHEDRA_OPTIONS_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_OPTIMIZE_HEXAHEDRA_OPTIONS_H

#include <CGAL/Tubular_meshing/base/parameters.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingHexahedra
 * The edge lengths that a hexahedron should have, in the directions of its edges 01, 03 and 04. Their ratios count, not
 * their size. */
typedef std::array<double, 3> Hexahedron_edge_lengths;

/*! \ingroup PkgTubularMeshingHexahedra
 * The named parameters of optimize_hexahedra(), as a struct. */
struct Optimize_hexahedra_options {
  double quality_wanted = 0.5;
  int number_of_rings = 2;
  int number_of_sweeps = 8;
  int untangling_sweeps = 200;
  double tempering = 0.35;
  const std::vector<bool>* fixed_vertices = nullptr;
  const std::vector<Hexahedron_edge_lengths>* target_lengths = nullptr;
  int number_of_threads = 0;

  Optimize_hexahedra_options() = default;
  template <class NamedParameters> explicit Optimize_hexahedra_options(const NamedParameters& np) {
    quality_wanted = internal::choose(np, internal_np::quality_wanted, quality_wanted);
    number_of_rings = internal::choose(np, internal_np::number_of_rings, number_of_rings);
    number_of_sweeps = internal::choose(np, internal_np::number_of_sweeps, number_of_sweeps);
    untangling_sweeps = internal::choose(np, internal_np::untangling_sweeps, untangling_sweeps);
    tempering = internal::choose(np, internal_np::tempering, tempering);
    fixed_vertices = internal::choose(np, internal_np::fixed_vertices, fixed_vertices);
    target_lengths = internal::choose(np, internal_np::target_lengths, target_lengths);
    number_of_threads = internal::choose(np, internal_np::number_of_threads, number_of_threads);
  }
};

/*! \ingroup PkgTubularMeshingHexahedra
 * What optimize_hexahedra() has done. A hexahedron counts with the least scaled Jacobian of its eight corners, and is
 * inverted where that is not positive. */
struct Optimize_hexahedra_report {
  double min_scaled_jacobian_before = 0;
  double min_scaled_jacobian = 0;
  double mean_scaled_jacobian_before = 0;
  double mean_scaled_jacobian = 0;
  std::size_t inverted_before = 0;
  std::size_t inverted = 0;
  std::size_t below_wanted_before = 0; ///< hexahedra worse than `quality_wanted`
  std::size_t below_wanted = 0;
  std::size_t movable_vertices = 0; ///< the most that have taken part at a time
  std::size_t sweeps = 0;           ///< over these
  std::size_t held_vertices = 0;    ///< of the boundary, left off the surface: on it, hexahedra would be inverted
};

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_OPTIMIZE_HEXAHEDRA_OPTIONS_H
