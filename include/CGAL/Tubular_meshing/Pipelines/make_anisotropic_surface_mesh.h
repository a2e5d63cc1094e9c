// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_MAKE_ANISOTROPIC_SURFACE_MESH_H
#define CGAL_TUBULAR_MESHING_PIPELINES_MAKE_ANISOTROPIC_SURFACE_MESH_H

#include <CGAL/Tubular_meshing/Fields/Centerline_metric_field.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Model_in_its_frame.h>
#include <CGAL/Tubular_meshing/base/Stage_observer.h>
#include <CGAL/Tubular_meshing/Pipelines/make_isotropic_surface_mesh.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 *
 * makes a surface mesh of anisotropic triangles in the parametric plane (sections 2.4 and 3.3 of the paper): cuts the
 * model by its centerlines, maps the patches onto the plane, and meshes them there, and the caps, in the metric (11)
 * that Centerline_metric_field induces.
 *
 * On the wall, triangles are as long along the vessel and around it as its curvatures allow; on the caps, the thin
 * layers along the wall show. The result is closed and conforming, does not intersect itself, has its vertices on the
 * model's surface, and the metric at them.
 *
 * \param model see make_tubular_model()
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{boundary_layer_thickness, first_height, growth, smoothing_ratio, curvature_points,
 *     points_per_circumference, max_anisotropy, min_size, max_size, gradation} \cgalParamDescription{see
 *     Centerline_metric_field} \cgalParamNEnd
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
Remeshed_surface make_anisotropic_surface_mesh(const Tubular_model& model,
                                               const NamedParameters& np = CGAL::parameters::default_values()) {
  internal::stage_observer(np)("metric field");
  internal::Model_in_its_frame framed(model);
  Remeshed_surface result = internal::remesh_in_frame(framed, framed.metric_field(np), np);
  framed.bring_back(result);
  return result;
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_PIPELINES_MAKE_ANISOTROPIC_SURFACE_MESH_H
