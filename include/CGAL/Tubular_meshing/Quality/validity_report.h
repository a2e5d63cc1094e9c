// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_VALIDITY_REPORT_H
#define CGAL_TUBULAR_MESHING_QUALITY_VALIDITY_REPORT_H

#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <cstddef>
#include <map>
#include <string>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingQuality
 *
 * What makes a volume mesh valid, counted.
 */
struct Validity_report {
  std::size_t cells = 0;
  std::size_t inverted_cells = 0;        ///< with a Jacobian at a corner that is not positive
  std::size_t overfull_faces = 0;        ///< shared by more than two cells, or by two on the same side
  std::size_t nonmanifold_edges = 0;     ///< of the boundary, not shared by two of its faces
  std::size_t unlabelled_faces = 0;      ///< of the boundary, that are not among the mesh's facets
  std::size_t misplaced_facets = 0;      ///< of the mesh, that are no face of a cell
  std::size_t unlabelled_interfaces = 0; ///< faces between cells of two regions, that are not among the mesh's facets
  std::size_t unused_points = 0;
  std::size_t connected_components = 0;         ///< of cells sharing faces
  std::map<int, std::size_t> region_components; ///< of cells of the same region sharing faces, for each region
  std::ptrdiff_t boundary_euler = 0;            ///< Euler's characteristic of the boundary: 2 for a ball, 0 for a ring

  /// Every cell right, every face matched, the boundary and the interfaces between regions closed and labelled, the
  /// mesh in one piece, and each of its regions.
  bool is_valid() const;
  /// The same of a mesh of several vessels, see join_parts(): in so many pieces, and each of its regions in as many.
  bool is_valid_in(std::size_t pieces) const {
    Validity_report one = *this;
    one.connected_components = connected_components == pieces ? 1 : 2;
    for (auto& r : one.region_components)
      r.second = r.second == pieces ? 1 : 2;
    return one.is_valid();
  }
  /// The number of regions that are not in one piece.
  std::size_t regions_in_pieces() const;
  /// What is wrong, as part of a sentence; empty if nothing is.
  std::string defects() const;
};

namespace internal {

Validity_report validity_report_on(int threads, const Mixed_mesh& mesh);

} // namespace internal

/*! \ingroup PkgTubularMeshingQuality
 *
 * checks a volume mesh of any kinds of cells: orientation, conformity, boundary, labels, connectedness, of the whole
 * and of each region. O(n log n).
 *
 * \param mesh the mesh
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{number_of_threads}
 *     \cgalParamDescription{0: all cores. The result does not depend on it}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{`0`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 */
template <typename CGAL_NP_TEMPLATE_PARAMETERS>
Validity_report validity_report(const Mixed_mesh& mesh, const CGAL_NP_CLASS& np = CGAL::parameters::default_values()) {
  return internal::validity_report_on(internal::choose(np, internal_np::number_of_threads, 0), mesh);
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Quality/validity_report_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_QUALITY_VALIDITY_REPORT_H
