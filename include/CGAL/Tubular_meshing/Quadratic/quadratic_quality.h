// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADRATIC_QUADRATIC_QUALITY_H
#define CGAL_TUBULAR_MESHING_QUADRATIC_QUADRATIC_QUALITY_H

#include <CGAL/Tubular_meshing/Quadratic/Quadratic_mesh.h>
#include <CGAL/Tubular_meshing/Quality/lumen_measures.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <cstddef>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingQuadratic
 *
 * The quality of a mesh of quadratic elements. The scaled Jacobian of a cell is the least on the whole of the cell, not
 * at its corners alone: at each point the determinant of the derivatives along the cell's edges, divided by the product
 * of their lengths; on a straight cell it is what CGAL::Tubular_meshing::hexahedron_jacobian(), prism_jacobian() and
 * pyramid_jacobian() take at the corners. A tetrahedron has the least of its corners' at each point, \f$ \sqrt{1/2} \f$
 * if it is regular.
 */
struct Quadratic_quality_report {
  Measure_statistics scaled_jacobian; ///< of all cells
  Measure_statistics tetrahedra;      ///< the same of those of a kind
  Measure_statistics pyramids;
  Measure_statistics prisms;
  Measure_statistics hexahedra;
  std::size_t invalid = 0;  ///< cells whose Jacobian is not positive somewhere
  std::size_t unproved = 0; ///< cells whose Jacobian is so close to zero that its sign cannot be told

  bool is_valid() const { return invalid == 0 && unproved == 0; }
};

/*! \ingroup PkgTubularMeshingQuadratic
 * Bounds of the least scaled Jacobian of a cell, see Quadratic_quality_report. */
struct Scaled_jacobian_bounds {
  double lower; ///< it is proved to be no less; -1 where the cell is not valid
  double upper; ///< what it is at some point
};

/*! \ingroup PkgTubularMeshingQuadratic
 *
 * bounds the scaled Jacobian of a cell by the coefficients of its determinant in Bernstein's basis
 * \cgalCite{johnen2013}, on ever smaller parts of the cell, until the lower bound is no less than (1 - tolerance) times
 * the upper one, or the cell is found to be invalid.
 *
 * \param mesh the mesh
 * \param type of cells
 * \param number which it is of the cells of this type
 * \param tolerance how far the bounds may be apart, as a part of the upper one
 */
Scaled_jacobian_bounds scaled_jacobian_bounds(const Quadratic_mesh& mesh, Element_type type, std::size_t number,
                                              double tolerance = 0.01);

/*! \ingroup PkgTubularMeshingQuadratic
 *
 * measures all cells, each by a lower bound, which is less than a tenth below the value but where a cell is badly
 * distorted. An invalid cell counts with the
 * least that was found, which is not above zero. O(n) for n cells.
 *
 * \param mesh the mesh
 * \param number_of_threads 0: all cores. The result does not depend on it
 */
Quadratic_quality_report quality_report(const Quadratic_mesh& mesh, int number_of_threads = 0);

/*! \ingroup PkgTubularMeshingQuadratic
 *
 * measures the lumen by its curved facets, as lumen_measures(const Mixed_mesh&, std::size_t) does by straight ones.
 * Volume and areas of openings are integrated exactly, the area of the wall by nine points a facet. */
Lumen_measures lumen_measures(const Quadratic_mesh& mesh, std::size_t number_of_openings);

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Quadratic/quadratic_quality_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_QUADRATIC_QUADRATIC_QUALITY_H
