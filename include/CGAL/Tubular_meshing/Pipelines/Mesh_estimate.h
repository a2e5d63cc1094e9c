// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_MESH_ESTIMATE_H
#define CGAL_TUBULAR_MESHING_PIPELINES_MESH_ESTIMATE_H

#include <CGAL/Tubular_meshing/Pipelines/Hexahedral_report.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPipelines
 * What a Mesher makes. */
enum class Mesh_type {
  isotropic,   ///< Mesher::isotropic()
  anisotropic, ///< Mesher::anisotropic()
  mixed,       ///< Mesher::mixed()
  hexahedral,  ///< Mesher::hexahedral()
  surface      ///< Mesher::surface()
};

/*! \ingroup PkgTubularMeshingPipelines
 * How large a lumen is in units of its mesh size h, or of its metric M: what the number of cells goes with. */
struct Lumen_integrals {
  double cubes = 0;        ///< \f$ \int dV / h^3 \f$ over the lumen
  double inner_cubes = 0;  ///< the same without what layers along the wall take up
  double wall_squares = 0; ///< \f$ \int dA / h^2 \f$ over the wall
  double cap_squares = 0;  ///< over the openings
  double rims = 0;         ///< \f$ \int ds / h \f$ along the openings' rims
  double metric_cubes = 0; ///< \f$ \int \sqrt{\det M} dV \f$, of an anisotropic mesh
  double metric_wall =
      0; ///< \f$ \int \sqrt{\det M_t} dA \f$ over the wall, of the metric in its tangent plane, less where facets are long and narrow
  double metric_caps = 0;     ///< the same over the openings
  double rows_of_blocks = 0;  ///< rows of hexahedra along all vessels, of a mesh in blocks
  double domes_of_blocks = 0; ///< blind ends in a mesh in blocks
  double layer_thickness = 0; ///< of the layers along the wall, in local radii
};

/*! \ingroup PkgTubularMeshingPipelines
 *
 * About how many cells a mesh will have, and what it will take to make it.
 *
 * Numbers of cells are linear in the lumen's integrals; the coefficients, one set for each type of mesh, were found by
 * least squares on generated tubes, bends, bifurcations, arches, loops and trees of 10 to 20 points round a vessel
 * (benchmark/Tubular_meshing/calibrate_estimate.py). Times are those of one machine, on both of its two cores: others
 * differ by a factor of two or so.
 */
struct Mesh_estimate {
  double tetrahedra = 0, pyramids = 0, prisms = 0, hexahedra = 0;
  double wall_triangles = 0, wall_quads = 0;                        ///< facets on the lumen's wall
  double cap_triangles = 0, cap_quads = 0;                          ///< and on the openings
  double smallest_size = (std::numeric_limits<double>::infinity)(); ///< of h on the wall, a length
  double largest_size = 0;
  double vessel_length = 0;                                                               ///< of all branches
  double smallest_radius = (std::numeric_limits<double>::infinity)(), largest_radius = 0; ///< of the vessels
  double seconds = 0;                                   ///< from the mesh size on, which is there already
  double bytes = 0;                                     ///< of memory at the most
  Hexahedral_method method = Hexahedral_method::blocks; ///< of a hexahedral mesh
  static constexpr double bytes_of_program = 30e6;      ///< without any mesh, part of `bytes`
  std::vector<std::string> fallbacks;                   ///< a sentence each, where another way will be taken
  Lumen_integrals integrals;

  double cells() const { return tetrahedra + pyramids + prisms + hexahedra; }
  double facets() const { return wall_triangles + wall_quads + cap_triangles + cap_quads; }

  /*! Adds layers of cells on the outside of the lumen's wall, as extrude_wall() makes them. */
  void add_wall(int layers, bool of_tetrahedra);

  /*! Adds that of another vessel, meshed after this one. */
  void add(const Mesh_estimate& other);
};

inline void Mesh_estimate::add_wall(int layers, bool of_tetrahedra) {
  (of_tetrahedra ? tetrahedra : prisms) += (of_tetrahedra ? 3 : 1) * layers * wall_triangles;
  hexahedra += layers * wall_quads;
  const double microseconds = 14, bytes_of_cell = 180; // as for layers inside
  seconds += 1e-6 * microseconds * layers * (wall_triangles + wall_quads);
  bytes += bytes_of_cell * layers * (wall_triangles + wall_quads);
}

inline void Mesh_estimate::add(const Mesh_estimate& other) {
  if (bytes > 0 && other.bytes > 0) // the program itself is there once
    bytes -= bytes_of_program;
  for (double Mesh_estimate::*number :
       {&Mesh_estimate::tetrahedra, &Mesh_estimate::pyramids, &Mesh_estimate::prisms, &Mesh_estimate::hexahedra,
        &Mesh_estimate::wall_triangles, &Mesh_estimate::wall_quads, &Mesh_estimate::cap_triangles,
        &Mesh_estimate::cap_quads, &Mesh_estimate::vessel_length, &Mesh_estimate::seconds, &Mesh_estimate::bytes})
    this->*number += other.*number;
  smallest_size = (std::min)(smallest_size, other.smallest_size);
  largest_size = (std::max)(largest_size, other.largest_size);
  smallest_radius = (std::min)(smallest_radius, other.smallest_radius);
  largest_radius = (std::max)(largest_radius, other.largest_radius);
  if (other.method == Hexahedral_method::subdivision)
    method = other.method;
  fallbacks.insert(fallbacks.end(), other.fallbacks.begin(), other.fallbacks.end());
  for (double Lumen_integrals::*number :
       {&Lumen_integrals::cubes, &Lumen_integrals::inner_cubes, &Lumen_integrals::wall_squares,
        &Lumen_integrals::cap_squares, &Lumen_integrals::rims, &Lumen_integrals::metric_cubes,
        &Lumen_integrals::metric_wall, &Lumen_integrals::metric_caps, &Lumen_integrals::rows_of_blocks,
        &Lumen_integrals::domes_of_blocks})
    integrals.*number += other.integrals.*number;
  integrals.layer_thickness = (std::max)(integrals.layer_thickness, other.integrals.layer_thickness);
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PIPELINES_MESH_ESTIMATE_H
