// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_MAKE_MIXED_MESH_H
#define CGAL_TUBULAR_MESHING_PIPELINES_MAKE_MIXED_MESH_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Layers/extrude_wall.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Volume/fill_with_pyramids_and_tetrahedra.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Model_in_its_frame.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/fill_within_layers.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/check_mesh_of_model.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/Stage_observer.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/Pipelines/make_quad_surface_mesh.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 *
 * makes a mesh of mixed cells (sections 2.5 and 3.2 of the paper): the wall's surface is meshed by quads, on which
 * pyramids stand on the inside, tetrahedra fill the lumen between them, and hexahedra the vessel's wall, if one is
 * wanted. Further hexahedra may lie in layers inside, along the wall; the pyramids stand on these then.
 *
 * Regions are labels::lumen and, with a wall, labels::wall_region. The patches are those of make_isotropic_mesh(), and
 * of extrude_wall(); patch labels::wall is then the interface between lumen and wall. The mesh is checked: cells match
 * face to face, none is inverted, and there are facets on every opening.
 *
 * In the few places where no pyramid fits on a quad it is split, see fill_with_pyramids_and_tetrahedra(): the patch
 * labels::wall has triangles there, and the wall prisms. With layers inside that cannot be done.
 *
 * \param model see make_tubular_model()
 * \param surface gets the surface of quads, see make_quad_surface_mesh()
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{points_per_circumference, min_size, max_size, gradation}
 *     \cgalParamDescription{see Centerline_sizing_field} \cgalParamNEnd
 *   \cgalParamNBegin{aspect_ratio, quad_caps} \cgalParamDescription{see make_quad_surface_mesh()} \cgalParamNEnd
 *   \cgalParamNBegin{wall_thickness} \cgalParamDescription{of the wall, in local radii; 0: there is none}
 *     \cgalParamDefault{0} \cgalParamNEnd
 *   \cgalParamNBegin{wall_layers, wall_growth, second_wall_thickness, second_wall_layers, second_wall_growth}
 *     \cgalParamDescription{see extrude_wall()} \cgalParamNEnd
 *   \cgalParamNBegin{boundary_layer_prisms, first_height, growth, boundary_layer_thickness, boundary_layer_report}
 *     \cgalParamDescription{layers of hexahedra inside the lumen, between its wall and the pyramids, as for
 *     make_isotropic_mesh()} \cgalParamDefault{none} \cgalParamNEnd
 *   \cgalParamNBegin{volume_mesher, optimization_passes} \cgalParamDescription{see fill_with_pyramids_and_tetrahedra()}
 *     \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads, observer} \cgalParamDescription{as for make_isotropic_mesh()} \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * O(n log n) in the size of the result, but for the parameterization, see make_quad_surface_mesh().
 *
 * \throws Parameter_error if a parameter is out of its range
 * \throws Meshing_error if no valid mesh comes out, or this program was built without LEMON, or with neither TetGen nor
 *   CGAL 6.1, see has_lemon(), has_tetgen() and has_ccdt()
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
Mixed_mesh make_mixed_mesh(const Tubular_model& model, Remeshed_surface& surface,
                           const NamedParameters& np = CGAL::parameters::default_values()) {
  typedef Named_parameters<bool, internal_np::split_quads_t, NamedParameters> With_splits;
  const auto observer = internal::stage_observer(np);
  const double wall_thickness = internal::choose(np, internal_np::wall_thickness, 0.);
  internal::check_keeps_boundary(internal::choose(np, internal_np::volume_mesher, default_volume_mesher()));
  observer("size field");
  internal::Model_in_its_frame framed(model);
  const Centerline_sizing_field size = framed.sizing_field(np);
  internal::check_memory(size.estimated_number_of_tetrahedra());
  surface = internal::quadrangulate_in_frame(framed, size, np);
  const bool may_split = !internal::wants_boundary_layer(np); // not the far sides of hexahedra
  const auto fill = [&](const auto& closed, const auto& patch, Mixed_mesh& filling) {
    observer("pyramids and tetrahedra");
    fill_with_pyramids_and_tetrahedra(closed, patch, size, filling, With_splits(may_split, np));
  };
  Mixed_mesh mesh;
  internal::fill_within_layers(surface, framed, fill, mesh, np);
  if (wall_thickness != 0) {
    observer("wall");
    extrude_wall(mesh, Centerline_field(framed.centerlines()), np);
  }
  observer("check");
  internal::check_differences(mesh, model);
  framed.bring_back(mesh);
  framed.bring_back(surface.surface);
  const Label_names names = lumen_patch_names(int(model.openings.size()));
  mesh.patch_names.insert(names.begin(), names.end());
  return mesh;
}

/*! \ingroup PkgTubularMeshingRef
 *
 * the same, for those who have no use for the surface.
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
Mixed_mesh make_mixed_mesh(const Tubular_model& model, const NamedParameters& np = CGAL::parameters::default_values()) {
  Remeshed_surface surface;
  return make_mixed_mesh(model, surface, np);
}

/*! \ingroup PkgTubularMeshingRef
 *
 * the same, from a surface and its centerlines; takes the named parameters of make_tubular_model() as well.
 */
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Mixed_mesh make_mixed_mesh(const TriangleMesh& surface, const Centerline_polylines& lines,
                           const NamedParameters& np = CGAL::parameters::default_values()) {
  return make_mixed_mesh(make_tubular_model(surface, lines, np), np);
}

/*! \ingroup PkgTubularMeshingRef
 *
 * the same, from a surface alone, whose centerlines are computed.
 */
template <class T, class Tag, class Base>
Mixed_mesh make_mixed_mesh(const CGAL::Surface_mesh<Point_3>& surface,
                           const CGAL::Named_function_parameters<T, Tag, Base>& np) {
  return make_mixed_mesh(make_tubular_model(surface, np), np);
}

inline Mixed_mesh make_mixed_mesh(const CGAL::Surface_mesh<Point_3>& surface) {
  return make_mixed_mesh(surface, CGAL::parameters::default_values());
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_PIPELINES_MAKE_MIXED_MESH_H
