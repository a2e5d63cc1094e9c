// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_ELEMENT_QUALITY_H
#define CGAL_TUBULAR_MESHING_QUALITY_ELEMENT_QUALITY_H

#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <string>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingQuality
 *
 * The names of the measures that element_quality() has values of for a mesh: those members of Quality_report which are
 * not empty, in their order.
 */
std::vector<std::string> element_measures(const Mixed_mesh& mesh);

/*! \ingroup PkgTubularMeshingQuality
 *
 * measures a mesh element by element: the values whose spread is the member of Quality_report of this name.
 *
 * They are in the order of the elements that are measured: triangles for `gamma_T`, tetrahedra for `gamma_tau` and
 * `Q_tau`, quads for `eta_q`, hexahedra for `zeta_H` and `scaled_jacobian`, prisms for `prism_jacobian`, pyramids for
 * `pyramid_jacobian`, and for `aspect` the tetrahedra, pyramids, prisms and hexahedra one after another.
 * `non_orthogonality` and `skewness` are of faces, in no order that is documented.
 *
 * O(n log n).
 *
 * \throws Parameter_error if no measure has this name
 */
std::vector<double> element_quality(const Mixed_mesh& mesh, const std::string& measure);

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Quality/element_quality_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_QUALITY_ELEMENT_QUALITY_H
