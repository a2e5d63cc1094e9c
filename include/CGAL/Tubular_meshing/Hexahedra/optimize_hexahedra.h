// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_OPTIMIZE_HEXAHEDRA_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_OPTIMIZE_HEXAHEDRA_H

#include <CGAL/Tubular_meshing/Hexahedra/Optimize_hexahedra_options.h>
#include <CGAL/Tubular_meshing/base/Labelled_surface.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>

namespace CGAL::Tubular_meshing {

namespace internal {

Optimize_hexahedra_report optimize_hexahedra(Mixed_mesh& mesh, const Surface& surface, Face_patch_map patch,
                                             const Optimize_hexahedra_options& options);

} // namespace internal

/*! \ingroup PkgTubularMeshingHexahedra
 *
 * untangles the hexahedra of a mesh and improves their worst scaled Jacobians, by moving vertices. Elements, their order
 * and their labels stay.
 *
 * With J the edges at one of the eight corners of a hexahedron and W its target edge lengths, on the diagonal, what is
 * brought down is the sum over the corners of
 * \f[ \Bigl( \frac{(|J W^{-1}|^2/3)^{3/2}}{\chi_\varepsilon(\det J W^{-1})} \Bigr)^p, \qquad
 *     \chi_\varepsilon(D) = \frac{D + \sqrt{\varepsilon^2 + D^2}}{2}, \f]
 * which is 1 at a corner with right angles and edges in the proportions of their targets, and has no bound as the corner
 * becomes flat. \f$ \varepsilon \f$ is positive as long as there are inverted corners, and is lowered with the worst of
 * them, \cgalCite{garanzha2021}. After that it is 0, and nothing is inverted any more, and p goes from 1 to 2, 4
 * and 8, so that the worst corners count more and more. The sum is a convex function of the position of each single vertex:
 * vertices take turns in Newton steps.
 *
 * Vertices of facets slide on `surface`: those of one patch's facets on the patch, those between two patches on the rim
 * between these, a planar patch being its plane. Vertices where three patches meet, at corners of rims, of facets of
 * patches that the surface does not have, and of cells of other kinds stay.
 *
 * Where vertices come off the surface, they go there first. If that turns hexahedra over, and these do not recover, all is
 * done once more with such vertices where they came from: the report counts them.
 *
 * Only hexahedra worse than `quality_wanted` and some rings around them are worked on; all other vertices stay bit for
 * bit where they are. If all is well already, that is all. A mesh that does not get better stays as it is.
 *
 * Linear in the hexahedra for each sweep, of those that are worked on; about 120 bytes a hexahedron. Sweeps run in
 * parallel; the result does not depend on the number of threads.
 *
 * \tparam FaceGraph a model of `FaceListGraph`
 * \tparam FacePatchMap a readable property map from its faces to `int`
 *
 * \param mesh its hexahedra, and the facets of its boundary and interfaces, labelled
 * \param surface the triangulated surface that the mesh lies on
 * \param patch the labels of its faces: those of the mesh's facets
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{quality_wanted}
 *     \cgalParamDescription{the scaled Jacobian from which on a hexahedron is good enough}
 *     \cgalParamType{`double`, 1 for all that can be had}
 *     \cgalParamDefault{0.5}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_rings}
 *     \cgalParamDescription{the rings of hexahedra around those that are not good enough, whose vertices move too}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{2}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_sweeps}
 *     \cgalParamDescription{the most sweeps for each p; there are fewer where vertices come to rest}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{8}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{untangling_sweeps}
 *     \cgalParamDescription{the most sweeps while there are inverted hexahedra}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{200}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{tempering}
 *     \cgalParamDescription{target lengths are \f$ g^t l^{1-t} \f$ with t the tempering, l the mean length of a
 *       hexahedron's parallel edges when the function is called, and g the geometric mean of its three l. With 0,
 *       proportions such as those of boundary layers are kept as they are}
 *     \cgalParamType{`double` in [0, 1]}
 *     \cgalParamDefault{0.35}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{target_lengths}
 *     \cgalParamDescription{target lengths of each hexahedron, in place of these}
 *     \cgalParamType{`const std::vector<Hexahedron_edge_lengths>*`}
 *     \cgalParamDefault{null}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{fixed_vertices}
 *     \cgalParamDescription{for each vertex, whether it stays in any case}
 *     \cgalParamType{`const std::vector<bool>*`}
 *     \cgalParamDefault{null: none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads}
 *     \cgalParamDescription{0 takes all cores}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{0}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the surface's vertices}
 *     \cgalParamType{a model of `ReadablePropertyMap`}
 *     \cgalParamDefault{`get(CGAL::vertex_point, surface)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \exception Parameter_error if an option is out of its range, or if `fixed_vertices` or `target_lengths` have not one
 * value for each vertex, or hexahedron
 */
#ifdef DOXYGEN_RUNNING
template <class FaceGraph, class FacePatchMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
#else
template <class FaceGraph, class FacePatchMap, class NamedParameters = CGAL::parameters::Default_named_parameters,
          std::enable_if_t<!std::is_base_of<Labelled_surface, FaceGraph>::value, int> = 0>
#endif
Optimize_hexahedra_report optimize_hexahedra(Mixed_mesh& mesh, const FaceGraph& surface, FacePatchMap patch,
                                             const NamedParameters& np = CGAL::parameters::default_values()) {
  const internal::Core_labelled_surface<FaceGraph, FacePatchMap, NamedParameters> core(surface, patch, np);
  return internal::optimize_hexahedra(mesh, core.surface(), core.patch(), Optimize_hexahedra_options(np));
}

/*! \ingroup PkgTubularMeshingHexahedra
 *
 * the same with a surface and its labels in one.
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
Optimize_hexahedra_report optimize_hexahedra(Mixed_mesh& mesh, const Labelled_surface& surface,
                                             const NamedParameters& np = CGAL::parameters::default_values()) {
  return internal::optimize_hexahedra(mesh, surface.surface, surface.patch, Optimize_hexahedra_options(np));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Hexahedra/optimize_hexahedra_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_OPTIMIZE_HEXAHEDRA_H
