// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADRATIC_MAKE_QUADRATIC_MESH_H
#define CGAL_TUBULAR_MESHING_QUADRATIC_MAKE_QUADRATIC_MESH_H

#include <CGAL/Tubular_meshing/Quadratic/Quadratic_mesh.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <string>
#include <utility>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingQuadratic
 * The named parameters of make_quadratic_mesh(), as a struct. */
struct Quadratic_options {
  bool complete_elements = false;
  int number_of_threads = 0; ///< 0 takes all cores

  Quadratic_options() = default;
  template <class NamedParameters>
  explicit Quadratic_options(const NamedParameters& np)
      : complete_elements(internal::choose(np, internal_np::complete_elements, false))
      , number_of_threads(internal::choose(np, internal_np::number_of_threads, 0)) {}
};

/*! \ingroup PkgTubularMeshingQuadratic
 * What make_quadratic_mesh() has done. */
struct Quadratic_report {
  double largest_shift = 0;          ///< the furthest that a corner has moved
  double largest_bend = 0;           ///< the furthest that a node is from the middle of its straight edge
  std::size_t curved_edges = 0;      ///< that are not straight
  std::size_t not_found = 0;         ///< nodes of the wall that have no part of the surface next to them
  std::size_t relaxed = 0;           ///< cells that would not have been valid, and are now with less curved edges
  std::size_t straightened = 0;      ///< of these, cells whose edges are all straight now
  std::size_t corners_held_back = 0; ///< corners that could not go all of the way to the smooth surface
  Point_3 invalid_place = Point_3(0, 0, 0); ///< one of the cells that are not valid, if there are any
  std::size_t invalid = 0;                  ///< cells that are not valid with straight edges either

  /// What gave way, as a sentence.
  std::string text() const;
};

namespace internal {

Quadratic_report make_quadratic_mesh(Mixed_mesh linear, const Surface& input, Face_patch_map input_patch,
                                     Length_function radius, Quadratic_mesh& result, const Quadratic_options& options);

} // namespace internal

/*! \ingroup PkgTubularMeshingQuadratic
 *
 * makes a mesh of quadratic elements of one of linear elements, and of the smooth surface behind the triangles that it
 * was made from.
 *
 * The smooth surface is a cubic patch over each of the input's triangles, as PN triangles are \cgalCite{vlachos2001},
 * with sides that are arcs of circles where the input's vertices are on one; normals are those of the wall alone. At
 * creases and pointed ends, where a vertex's normal does not fit its edges, sides go by the normal at the other end, or are
 * straight; the wall's corner next to a pointed end that the mesh has cut off goes to it. The rims of openings are smooth
 * curves in their planes. Corners of the mesh's wall go to this surface, and so do
 * the nodes of its edges and, in complete elements, of its quads; a displacement that gave a linear mesh the volume of
 * the surface is undone thereby, see preserve_volume(). What lies in openings stays in their planes. Nodes inside follow
 * those of the wall, so that layers along it curve with it, less and less, and not beyond half the local radius; so do
 * those of walls around the lumen, as circles around a center do.
 *
 * Each cell's Jacobian is proved to be positive by bounds \cgalCite{johnen2013}, on the whole of the cell. Nodes of a
 * cell where it is not go back, half of the way at a time, to where the edges are straight, and last its corners to where
 * they came from. Of the linear mesh's cells it takes that they are valid.
 *
 * O(n log n) for n cells and triangles; the result does not depend on the number of threads.
 *
 * \param linear cells of any kinds, and their boundary facets: patch labels::wall is the lumen's, region labels::lumen
 *   inside of it
 * \param input the closed surface that the mesh was made from, with flat caps of the same labels
 * \param input_patch a readable property map from its faces to `int`: labels::wall, or the label of an opening
 * \param radius the local radius: a function object of a `Point_3`
 * \param result the mesh
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{complete_elements}
 *     \cgalParamDescription{whether quads have a node of their own, and hexahedra one in the middle: hexahedra of 27
 *       nodes, not 20}
 *     \cgalParamType{bool}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads}
 *     \cgalParamDescription{0: all cores}
 *     \cgalParamType{int}
 *     \cgalParamDefault{0}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the input's vertices}
 *     \cgalParamType{a model of `ReadablePropertyMap`}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, input)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 */
template <class FaceGraph, class FacePatchMap, class LocalRadius,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Quadratic_report make_quadratic_mesh(Mixed_mesh linear, const FaceGraph& input, FacePatchMap input_patch,
                                     const LocalRadius& radius, Quadratic_mesh& result,
                                     const NamedParameters& np = CGAL::parameters::default_values()) {
  const internal::Core_labelled_surface<FaceGraph, FacePatchMap, NamedParameters> core(input, input_patch, np);
  return internal::make_quadratic_mesh(std::move(linear), core.surface(), core.patch(), radius, result,
                                       Quadratic_options(np));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Quadratic/make_quadratic_mesh_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_QUADRATIC_MAKE_QUADRATIC_MESH_H
