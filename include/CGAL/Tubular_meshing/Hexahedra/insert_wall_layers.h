// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_INSERT_WALL_LAYERS_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_INSERT_WALL_LAYERS_H

#include <CGAL/Tubular_meshing/Layers/Layer_report.h>
#include <CGAL/Tubular_meshing/Layers/extrude_boundary_layer.h>
#include <CGAL/Tubular_meshing/Layers/local_radius.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

namespace CGAL::Tubular_meshing {

namespace internal {

Layer_report insert_wall_layers(Mixed_mesh& mesh, Length_function radius,
                                const Extrude_boundary_layer_options& options);

} // namespace internal

/*! \ingroup PkgTubularMeshingHexahedra
 *
 * cuts the hexahedra on the wall into layers, thin at the wall, each higher than the one before by a constant ratio; what
 * is left of them is one hexahedron more. The edges that lead inward from the wall become curves that start along the
 * wall's normal. Where there is too little room, layers are thinner, and the report says so; where a hexahedron would be
 * bad, which was not before it was cut, the curves get straighter, too.
 *
 * \param mesh hexahedra whose facets of patch labels::wall are quads; each hexahedron has one of them at most, and each
 *   vertex on them one edge inward, as in make_hexahedral_blocks()
 * \param radius the local radius: a Centerline_field, or a function object of a `Point_3`
 * \param np the named parameters `boundary_layer_prisms`, the number of layers, `first_height`, `growth`,
 *   `boundary_layer_thickness` and `number_of_threads` of extrude_boundary_layer()
 *
 * Linear.
 *
 * \throws Parameter_error if a parameter is out of its range, see extrude_boundary_layer()
 * \throws Input_error if the hexahedra on the wall are not as they should be; the mesh is as it was then
 */
template <class LocalRadius, class NamedParameters = CGAL::parameters::Default_named_parameters>
Layer_report insert_wall_layers(Mixed_mesh& mesh, const LocalRadius& radius,
                                const NamedParameters& np = CGAL::parameters::default_values()) {
  const auto function = internal::radius_function(radius);
  return internal::insert_wall_layers(mesh, function, Extrude_boundary_layer_options(np));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Hexahedra/insert_wall_layers_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_INSERT_WALL_LAYERS_H
