// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_EXTRUDE_BOUNDARY_LAYER_H
#define CGAL_TUBULAR_MESHING_LAYERS_EXTRUDE_BOUNDARY_LAYER_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Layers/Layer_report.h>
#include <CGAL/Tubular_meshing/Layers/append_mesh.h>
#include <CGAL/Tubular_meshing/Layers/internal/boundary_layer/Boundary_layer_maker.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/Surface_mesh.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 *
 * Layers of cells along the wall, inside the lumen, and the surface of what they leave of it.
 */
struct Boundary_layer {
  typedef Tubular_meshing::Point_3 Point_3;
  typedef CGAL::Surface_mesh<Point_3> Surface;
  typedef typename Surface::template Property_map<typename Surface::Face_index, int> Face_map;

  /// Prisms and hexahedra of region labels::lumen, with the wall's facets, and a ring of quads along each opening that
  /// has the opening's label. Its first points are the surface's on the wall, in their order.
  Mixed_mesh layers;
  Surface inner;  ///< of what is left: closed, turned outward
  Face_map patch; ///< labels::wall on the layers' far side, else the label of an opening: property map `f:patch`
  std::vector<std::uint32_t> mesh_points; ///< the point of `layers` that each vertex of `inner` is, or `no_point`
  Layer_report report;

  Boundary_layer() { patch = inner.add_property_map<typename Surface::Face_index, int>("f:patch", 0).first; }
  Boundary_layer(const Boundary_layer&) = delete; // the map refers to the surface's own properties
  Boundary_layer& operator=(const Boundary_layer&) = delete;
  Boundary_layer(Boundary_layer&&) = default;
  Boundary_layer& operator=(Boundary_layer&&) = default;
};

namespace internal {

template <class LocalRadius> auto radius_function(const LocalRadius& radius) {
  return [&radius](const Point_3& p) { return radius(p); };
}
inline auto radius_function(const Centerline_field& centerlines) {
  return [&centerlines](const Point_3& p) { return centerlines.radius(p); };
}

} // namespace internal

/*! \ingroup PkgTubularMeshingRef
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
 * its cap is meshed anew inside of them, by triangles of the mean edge of the rim.
 *
 * O(n log n) in the number of facets; the result does not depend on the number of threads.
 *
 * \param surface closed, turned outward, of triangles and quads, free of self-intersections
 * \param patch a readable property map from its faces to `int`: labels::wall, or the label of an opening, which is
 * about flat \param radius the local radius, a function object that is called with a `Point`, from one thread; or a
 *   Centerline_field
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{boundary_layer_thickness} \cgalParamDescription{δ, relative to the local radius; above 0, below 1.
 *     It gives the defaults of the two that follow} \cgalParamDefault{0.3} \cgalParamNEnd
 *   \cgalParamNBegin{first_height} \cgalParamDescription{\f$ h_n^0 \f$, relative to the local radius; above 0, below 1}
 *     \cgalParamDefault{a twentieth of `boundary_layer_thickness`} \cgalParamNEnd
 *   \cgalParamNBegin{boundary_layer_prisms} \cgalParamDescription{number of layers; they must not come to more than the
 *     local radius together} \cgalParamDefault{as many as come closest to `boundary_layer_thickness`} \cgalParamNEnd
 *   \cgalParamNBegin{growth} \cgalParamDescription{r, the ratio of successive heights; at least 1}
 *     \cgalParamDefault{1.3} \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads} \cgalParamDescription{0 takes all cores} \cgalParamDefault{0} \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Parameter_error if a parameter is out of its range
 * \throws Input_error if the surface is not closed or not manifold, crosses itself, or has angles of 0 or 180 degrees,
 *   or if a radius is not above 0
 * \throws Meshing_error if the surface is folded so that no valid cell has room on it
 */
template <class LocalRadius, class NamedParameters = CGAL::parameters::Default_named_parameters>
Boundary_layer extrude_boundary_layer(const CGAL::Surface_mesh<Point_3>& surface, Face_patch_map patch,
                                      const LocalRadius& radius,
                                      const NamedParameters& np = CGAL::parameters::default_values()) {
  const internal::Boundary_layer_heights heights(np);
  Boundary_layer result;
  internal::Boundary_layer_maker<Boundary_layer>(internal::labelled_facets(surface, patch), heights, result)
      .run(internal::radius_function(radius));
  return result;
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_LAYERS_EXTRUDE_BOUNDARY_LAYER_H
