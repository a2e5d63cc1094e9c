// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_MAKE_ISOTROPIC_SURFACE_MESH_H
#define CGAL_TUBULAR_MESHING_PIPELINES_MAKE_ISOTROPIC_SURFACE_MESH_H

#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/Patches/cut_by_centerlines.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/Patches/parameterize_patch.h>
#include <CGAL/Tubular_meshing/Patches/remesh_patches.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Model_in_its_frame.h>
#include <CGAL/Tubular_meshing/base/Stage_observer.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* Cuts the model, maps its patches and meshes them by a size or a metric, in the model's frame. */
template <class Size, class NamedParameters>
Remeshed_surface remesh_in_frame(Model_in_its_frame& framed, const Size& size, const NamedParameters& np) {
  const auto observer = stage_observer(np);
  observer("cut");
  const Surface_cut cut = cut_by_centerlines(framed.surface(), framed.centerlines(), framed.patch(), np);
  observer("parameterization");
  const auto maps = parameterize_patches(framed.surface(), cut, np);
  observer("surface mesh");
  return remesh_patches(framed.surface(), cut, maps, size, np);
}

} // namespace internal

/*! \ingroup PkgTubularMeshingRef
 *
 * makes a surface mesh of isotropic triangles, of mesh size h = 2 π r / N, in the parametric plane (section 3.1 of the
 * paper): cuts the model by its centerlines, maps the patches onto the plane, and meshes them there, and the caps.
 *
 * The result is closed and conforming, does not intersect itself, and has its vertices on the model's surface.
 *
 * \param model see make_tubular_model()
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{points_per_circumference, min_size, max_size, gradation}
 *     \cgalParamDescription{see Centerline_sizing_field} \cgalParamNEnd
 *   \cgalParamNBegin{aspect_ratio} \cgalParamDescription{see cut_by_centerlines()} \cgalParamNEnd
 *   \cgalParamNBegin{even_curves} \cgalParamDescription{see remesh_patches()} \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads} \cgalParamDescription{the result does not depend on it; 0: all cores}
 *     \cgalParamDefault{0} \cgalParamNEnd
 *   \cgalParamNBegin{observer} \cgalParamDescription{a function object that is called with the name of each stage, a
 *     `const char*`, as it begins} \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * About O(n log n) in the sizes of the surface and of the result, but for the linear systems of the parameterization,
 * which take O(n^1.5) in those of patches.
 *
 * \throws Parameter_error if a parameter is out of its range
 * \throws Meshing_error if a patch cannot be mapped or meshed: the surface intersects itself, or its centerlines do not
 *   fit
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
Remeshed_surface make_isotropic_surface_mesh(const Tubular_model& model,
                                             const NamedParameters& np = CGAL::parameters::default_values()) {
  internal::stage_observer(np)("size field");
  internal::Model_in_its_frame framed(model);
  Remeshed_surface result = internal::remesh_in_frame(framed, framed.sizing_field(np), np);
  framed.bring_back(result.surface);
  return result;
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_PIPELINES_MAKE_ISOTROPIC_SURFACE_MESH_H
