// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_EXTRUDE_WALL_H
#define CGAL_TUBULAR_MESHING_LAYERS_EXTRUDE_WALL_H

#include <CGAL/Tubular_meshing/Layers/Layer_report.h>
#include <CGAL/Tubular_meshing/Layers/Wall_materials.h>
#include <CGAL/Tubular_meshing/Layers/Wall_thickness.h>
#include <CGAL/Tubular_meshing/Layers/local_radius.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingLayers
 *
 * The options of extrude_wall(): its named parameters. */
struct Extrude_wall_options {
  Wall_thickness wall_thickness = 0.2;
  int wall_layers = 4;
  double wall_growth = 1;
  bool tetrahedral_wall = false;
  Wall_thickness second_wall_thickness;
  int second_wall_layers = 4;
  double second_wall_growth = 1;
  Wall_materials materials; ///< `wall_materials`
  int number_of_threads = 0;

  Extrude_wall_options() = default;
  template <class NamedParameters> explicit Extrude_wall_options(const NamedParameters& np) {
    using internal::choose;
    wall_thickness = choose(np, internal_np::wall_thickness, wall_thickness);
    wall_layers = choose(np, internal_np::wall_layers, wall_layers);
    wall_growth = choose(np, internal_np::wall_growth, wall_growth);
    materials = choose(np, internal_np::wall_materials, materials);
    tetrahedral_wall = choose(np, internal_np::tetrahedral_wall, tetrahedral_wall);
    second_wall_thickness = choose(np, internal_np::second_wall_thickness, second_wall_thickness);
    second_wall_layers = choose(np, internal_np::second_wall_layers, wall_layers);
    second_wall_growth = choose(np, internal_np::second_wall_growth, wall_growth);
    number_of_threads = choose(np, internal_np::number_of_threads, number_of_threads);
  }
};

/*! \ingroup PkgTubularMeshingLayers
 *
 * A vessel's wall without the lumen. */
struct Extruded_wall {
  Mixed_mesh mesh;
  Layer_report report;
};

namespace internal {

Layer_report extrude_wall(Mixed_mesh& mesh, Length_function radius, const Extrude_wall_options& options);
Extruded_wall extrude_wall(const Surface& surface, Face_patch_map patch, Length_function radius,
                           const Extrude_wall_options& options);

} // namespace internal

/*! \ingroup PkgTubularMeshingLayers
 *
 * grows the vessels' wall outward from the lumen's surface (section 2.3 of the paper): layers of cells of a total
 * thickness \f$ \delta = \alpha \, r(\mathbf{x}_c(\mathbf{x})) \f$ (2), in proportion to the local radius. Triangles
 * give prisms, quads hexahedra; or all are cut into tetrahedra.
 *
 * Each vertex of the wall gets a column of points on a straight line: along the Gouraud normal, turned where a face
 * around would not see it, and then to and fro until the angles of the cells are as close to right angles as they get.
 * At rims it runs in the plane of the rim, so that a vessel's end stays flat.
 *
 * The wall is as thick as wanted where there is room. Two vessels, or the two sides of a crotch, share the gap between
 * them, and keep a quarter of it free; from there on the thickness grows by at most 0.4 of the distance, which bounds
 * jumps of the radius, and of thicknesses that are given, too. What comes out is checked: no corner of a cell is
 * inverted, and the outer surface, with its rings and the openings, does not cross itself, so that no cell overlaps
 * another. Where one or the other happens the wall is made thinner around, until all is well. What it came to is
 * reported.
 *
 * New points come after the mesh's own, layer after layer; cells and facets of the mesh stay, but for facets of the
 * wall that lie in the plane of an opening, which become the opening's. Point arrays continue with the values of the
 * lumen's points below.
 *
 * | labels | |
 * |---|---|
 * | region 2 `wall`, region 3 `second_wall` | the cells |
 * | region 4, 5, … | the cells of the wall over areas of other materials, see Wall_materials |
 * | patch 1 `wall` | the facets that the wall grew on: now the interface |
 * | patch 100 `outer_wall` | |
 * | patch 101 `middle_wall` | the interface between the wall and the second one |
 * | patch 102 `inlet_ring`, 103, … `outlet_ring_1`, … | the ends of one or both walls: 100 + that of the opening |
 * | patch 200 `material_interface` | the facets between the wall and its materials |
 *
 * Where the mesh has more than 98 openings, 100 is 1000 in all of that, and 200 is 2000: see
 * labels::outer_wall_for().
 *
 * O(n log n) in the number of facets; the result does not depend on the number of threads.
 *
 * \param mesh cells of any kind with their labelled boundary; or, without cells, the facets of a closed surface, or of
 *   one that is open at its openings. Facets of patch labels::wall turn counterclockwise seen from outside, all others
 *   are openings, about flat. It must not cross itself
 * \param radius the local radius: a function object that is called with a `Point_3`, from one thread, or a
 *   Centerline_field
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{wall_thickness}
 *     \cgalParamDescription{α, relative to the local radius; above 0, at most 10. Or lengths, in the unit of the mesh}
 *     \cgalParamType{`double`, or Wall_thickness}
 *     \cgalParamDefault{0.2}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{wall_layers}
 *     \cgalParamDescription{number of layers}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{4}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{wall_growth}
 *     \cgalParamDescription{ratio of the thicknesses of a layer and of the one inside of it; from 0.1 to 10}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{1}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{tetrahedral_wall}
 *     \cgalParamDescription{whether the wall is made of tetrahedra; quads that it grows on are then split, which cells
 *       beneath must not have}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{wall_materials}
 *     \cgalParamDescription{areas of the lumen's surface over which the wall is a region of its own: the cells over a
 *       facet belong to that of the facet's middle. The second wall has none}
 *     \cgalParamType{Wall_materials}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{second_wall_thickness}
 *     \cgalParamDescription{the same for a second wall around the first, say the adventitia; 0: there is none}
 *     \cgalParamType{`double`, or Wall_thickness}
 *     \cgalParamDefault{0}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{second_wall_layers}
 *     \cgalParamDescription{number of layers of the second wall}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{`wall_layers`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{second_wall_growth}
 *     \cgalParamDescription{ratio of successive thicknesses in the second wall}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`wall_growth`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads}
 *     \cgalParamDescription{0 takes all cores}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{0}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \returns how thick the wall is
 *
 * \throws Parameter_error if a parameter is out of its range, or the wall cannot be of tetrahedra
 * \throws Input_error if the mesh has a wall already, or no facets to grow one on; if those are not a manifold surface,
 *   cross themselves, or have angles of 0 or 180 degrees; if a radius is not above 0; or if a thickness is not above 0,
 *   or more than ten local radii
 * \throws Meshing_error if the surface is folded so that no valid cell has room on it. The mesh is as it was, after any
 *   exception
 */
template <class LocalRadius, class NamedParameters = CGAL::parameters::Default_named_parameters>
Layer_report extrude_wall(Mixed_mesh& mesh, const LocalRadius& radius,
                          const NamedParameters& np = CGAL::parameters::default_values()) {
  return internal::extrude_wall(mesh, internal::radius_function(radius), Extrude_wall_options(np));
}

/*! \ingroup PkgTubularMeshingLayers
 *
 * makes a mesh of the wall alone, without the lumen, for computations of the wall's mechanics.
 *
 * The mesh's first points are the vertices of the surface's wall, in the order of the surface. Patch labels::wall is
 * the inside of the wall; as everywhere, its facets turn counterclockwise seen from outside the vessel.
 *
 * \param surface a model of `FaceListGraph` of triangles and quads, turned outward; closed, or open at its openings
 * \param patch a readable property map from its faces to `int`: labels::wall, or the label of an opening. Openings
 *   without faces are numbered on
 * \param radius as above
 * \param np those above, and `vertex_point_map`
 *
 * \throws Input_error, Meshing_error, Parameter_error as above, and if a face has more than four edges
 */
template <class FaceGraph, class FacePatchMap, class LocalRadius,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Extruded_wall extrude_wall(const FaceGraph& surface, FacePatchMap patch, const LocalRadius& radius,
                           const NamedParameters& np = CGAL::parameters::default_values()) {
  const internal::Core_labelled_surface<FaceGraph, FacePatchMap, NamedParameters> core(surface, patch, np);
  return internal::extrude_wall(core.surface(), core.patch(), internal::radius_function(radius),
                                Extrude_wall_options(np));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Layers/extrude_wall_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_LAYERS_EXTRUDE_WALL_H
