// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_EXTRUDE_BOUNDARY_LAYER_H
#define CGAL_TUBULAR_MESHING_LAYERS_EXTRUDE_BOUNDARY_LAYER_H

#include <CGAL/Tubular_meshing/Layers/Layer_report.h>
#include <CGAL/Tubular_meshing/Layers/append_mesh.h>
#include <CGAL/Tubular_meshing/Layers/local_radius.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingLayers
 *
 * The options of extrude_boundary_layer(): its named parameters. */
struct Extrude_boundary_layer_options {
  double boundary_layer_thickness = 0.3;
  std::optional<double> first_height;       ///< a twentieth of `boundary_layer_thickness` where it has no value
  std::optional<int> boundary_layer_prisms; ///< what comes closest to `boundary_layer_thickness` where it has no value
  double growth = 1.3;
  int number_of_threads = 0;

  Extrude_boundary_layer_options() = default;
  template <class NamedParameters> explicit Extrude_boundary_layer_options(const NamedParameters& np) {
    using internal::choose;
    boundary_layer_thickness = choose(np, internal_np::boundary_layer_thickness, boundary_layer_thickness);
    first_height = choose(np, internal_np::first_height, first_height);
    boundary_layer_prisms = choose(np, internal_np::boundary_layer_prisms, boundary_layer_prisms);
    growth = choose(np, internal_np::growth, growth);
    number_of_threads = choose(np, internal_np::number_of_threads, number_of_threads);
  }
};

/*! \ingroup PkgTubularMeshingLayers
 *
 * Layers of cells along the wall, inside the lumen, and the surface of what they leave of it.
 */
struct Boundary_layer {
  /// Prisms and hexahedra of region labels::lumen, with the wall's facets, and a ring of quads along each opening that
  /// has the opening's label. Its first points are the surface's on the wall, in their order.
  Mixed_mesh layers;
  Surface inner;        ///< of what is left: closed, turned outward
  Face_patch_map patch; ///< labels::wall on the layers' far side, else the label of an opening: property map `f:patch`
  std::vector<std::uint32_t> mesh_points; ///< the point of `layers` that each vertex of `inner` is, or `no_point`
  Layer_report report;

  Boundary_layer() { patch = inner.add_property_map<Surface::Face_index, int>("f:patch", 0).first; }
  Boundary_layer(const Boundary_layer&) = delete; // the map refers to the surface's own properties
  Boundary_layer& operator=(const Boundary_layer&) = delete;
  Boundary_layer(Boundary_layer&&) = default;
  Boundary_layer& operator=(Boundary_layer&&) = default;
};

namespace internal {

Boundary_layer extrude_boundary_layer(const Surface& surface, Face_patch_map patch, Length_function radius,
                                      const Extrude_boundary_layer_options& options);

} // namespace internal

/*! \ingroup PkgTubularMeshingLayers
 *
 * grows boundary layers inward from the wall of the lumen: prisms on triangles, hexahedra on quads, each layer higher
 * than the one before by a constant ratio: \f$ h_n^0, r h_n^0, r^2 h_n^0, \ldots \f$. What is left of the lumen is to
 * be filled by other means, and joined with the layers by append_mesh():
 *
 * \code{.cpp}
 * auto layer = extrude_boundary_layer(surface, patch, centerlines);
 * Mixed_mesh inside;
 * fill_keeping_boundary(layer.inner, layer.patch, size, inside);
 * optimize_tetrahedra(inside, layer.inner, layer.patch, parameters::keep_boundary(true));
 * append_mesh(layer.layers, inside, layer.mesh_points);
 * \endcode
 *
 * The layers are those of extrude_wall(), the other way round: straight columns, thinner where there is not enough
 * room, checked for inverted and overlapping cells. They take at most half of the way to the middle of the lumen. Where
 * the total is reduced, all layers of the column are, in proportion. At openings the layers end in the opening's plane;
 * its cap is meshed again inside of them, by triangles of the mean edge of the rim.
 *
 * O(n log n) in the number of facets; the result does not depend on the number of threads.
 *
 * \param surface a model of `FaceListGraph`: closed, turned outward, of triangles and quads, free of self-intersections
 * \param patch a readable property map from its faces to `int`: labels::wall, or the label of an opening, which is
 *   about flat
 * \param radius the local radius: a function object that is called with a `Point_3`, from one thread, or a
 *   Centerline_field
 * \param np an optional sequence of named parameters among the ones listed below, and `vertex_point_map`
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{boundary_layer_thickness}
 *     \cgalParamDescription{δ, relative to the local radius; above 0, below 1. It gives the defaults of the two that
 *       follow}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{0.3}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{first_height}
 *     \cgalParamDescription{\f$ h_n^0 \f$, relative to the local radius; above 0, below 1}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{a twentieth of `boundary_layer_thickness`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{boundary_layer_prisms}
 *     \cgalParamDescription{number of layers; they must not come to more than the local radius together}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{as many as come closest to `boundary_layer_thickness`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{growth}
 *     \cgalParamDescription{r, the ratio of successive heights; at least 1}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{1.3}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads}
 *     \cgalParamDescription{0 takes all cores}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{0}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Parameter_error if a parameter is out of its range
 * \throws Input_error if the surface is not closed or not manifold, crosses itself, or has angles of 0 or 180 degrees,
 *   or if a radius is not above 0
 * \throws Meshing_error if the surface is folded so that no valid cell has room on it
 */
template <class FaceGraph, class FacePatchMap, class LocalRadius,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Boundary_layer extrude_boundary_layer(const FaceGraph& surface, FacePatchMap patch, const LocalRadius& radius,
                                      const NamedParameters& np = CGAL::parameters::default_values()) {
  const internal::Core_labelled_surface<FaceGraph, FacePatchMap, NamedParameters> core(surface, patch, np);
  return internal::extrude_boundary_layer(core.surface(), core.patch(), internal::radius_function(radius),
                                          Extrude_boundary_layer_options(np));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Layers/extrude_boundary_layer_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_LAYERS_EXTRUDE_BOUNDARY_LAYER_H
