// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_H
#define CGAL_TUBULAR_MESHING_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Volume/Volume_mesher.h>
#include <CGAL/Tubular_meshing/Volume/anisotropic_tetrahedral_remeshing.h>
#include <CGAL/Tubular_meshing/Volume/fill_keeping_boundary.h>
#include <CGAL/Tubular_meshing/Volume/fill_with_mesh_3.h>
#include <CGAL/Tubular_meshing/Volume/optimize_tetrahedra.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Model_in_its_frame.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/fill_within_layers.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/check_mesh_of_model.h>
#include <CGAL/Tubular_meshing/base/Stage_observer.h>
#include <CGAL/Tubular_meshing/Pipelines/make_isotropic_surface_mesh.h>
#include <CGAL/Tubular_meshing/Pipelines/make_mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {

namespace internal {

/* Meshes the surface patch by patch, and fills it; all in the model's frame. Returns the surface. */
template <class NamedParameters>
Remeshed_surface make_isotropic_mesh_in_frame(Model_in_its_frame& framed, Mixed_mesh& mesh, const NamedParameters& np) {
  typedef Named_parameters<bool, internal_np::keep_boundary_t, NamedParameters> With_boundary;
  typedef Centerline_sizing_field Sizing_field;
  const auto observer = stage_observer(np);
  const Volume_mesher mesher = choose(np, internal_np::volume_mesher, default_volume_mesher());
  const Sizing_field size = framed.sizing_field(np);
  check_memory(size.estimated_number_of_tetrahedra());
  Remeshed_surface surface = remesh_in_frame(framed, size, np);
  if (wants_boundary_layer(np) && mesher == Volume_mesher::mesh_3)
    throw Meshing_error("Layers inside the lumen need a mesher that keeps their sides: build this program where CMake "
                        "finds TetGen (libtet1.5-dev), or CGAL 6.1 or later, and choose one of these.");
  const auto fill = [&](const auto& closed, const auto& patch, Mixed_mesh& filling) {
    observer("tetrahedra");
    if (mesher == Volume_mesher::mesh_3)
      fill_with_mesh_3(closed, patch, size, filling, np);
    else
      fill_keeping_boundary(closed, patch, size, filling, np);
    observer("optimization");
    optimize_tetrahedra(filling, framed.surface(), framed.patch(), With_boundary(mesher != Volume_mesher::mesh_3, np));
  };
  fill_within_layers(surface, framed, fill, mesh, np);
  observer("check");
  return surface;
}

} // namespace internal

/*! \ingroup PkgTubularMeshingRef
 *
 * makes a mesh of isotropic tetrahedra, of mesh size h = 2 π r / N (section 3.1 of the paper): region labels::lumen,
 * and patches wall, inlet, outlet_1, ….
 *
 * Mesh_3 refines, optimize_tetrahedra() makes the mesh good, and the outcome is checked: what is returned is valid (see
 * Validity_report), has the topology of the model's surface, and facets on every opening. Where the mesh size is too
 * coarse for that it is made finer, by a factor of at most two.
 *
 * \param model see make_tubular_model()
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{points_per_circumference, min_size, max_size, gradation}
 *     \cgalParamDescription{see Centerline_sizing_field} \cgalParamNEnd
 *   \cgalParamNBegin{facet_distance} \cgalParamDescription{see fill_with_mesh_3()} \cgalParamNEnd
 *   \cgalParamNBegin{optimization_passes} \cgalParamDescription{see optimize_tetrahedra()} \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads} \cgalParamDescription{1: the result is reproducible; 0: all cores}
 *     \cgalParamDefault{0} \cgalParamNEnd
 *   \cgalParamNBegin{observer} \cgalParamDescription{a function object that is called with the name of each stage, a
 *     `const char*`, as it begins} \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * O(n log n) in the size of the result.
 *
 * \throws Parameter_error if a parameter is out of its range
 * \throws Meshing_error if no valid mesh comes out, or the mesh would not fit into memory
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
Mixed_mesh make_isotropic_mesh(const Tubular_model& model,
                               const NamedParameters& np = CGAL::parameters::default_values()) {
  typedef Centerline_sizing_field Sizing_field;
  const auto observer = internal::stage_observer(np);

  observer("size field");
  const internal::Model_in_its_frame framed(model);
  const Sizing_field size = framed.sizing_field(np);
  internal::check_memory(size.estimated_number_of_tetrahedra());
  Mixed_mesh mesh;
  std::string differences;
  for (double factor : {1., 0.7, 0.5}) {
    observer("tetrahedra");
    const auto scaled = [&](const Point_3& p) { return factor * size(p); };
    fill_with_mesh_3(framed.surface(), framed.patch(), scaled, mesh, np);
    observer("optimization");
    optimize_tetrahedra(mesh, framed.surface(), framed.patch(), np);
    observer("check");
    differences = internal::differences(mesh, model);
    if (differences.empty())
      break;
  }
  if (!differences.empty())
    throw Meshing_error("The mesh came out with " + differences +
                        ": the surface may intersect itself, or have parts much narrower than the mesh size there.");
  framed.bring_back(mesh);
  mesh.patch_names = lumen_patch_names(int(model.openings.size()));
  return mesh;
}

/*! \ingroup PkgTubularMeshingRef
 *
 * the paper's own road to a mesh of isotropic tetrahedra: the surface is meshed patch by patch in the parametric plane,
 * see make_isotropic_surface_mesh(), and filled.
 *
 * TetGen and CGAL's constrained triangulations keep the surface mesh facet for facet: the mesh's first points are its
 * vertices, its triangles its faces, in their order. Mesh_3 meshes it anew.
 *
 * \param model see make_tubular_model()
 * \param surface gets the surface mesh
 * \param np takes the named parameters of make_isotropic_surface_mesh() as well as
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{volume_mesher} \cgalParamDescription{a `Volume_mesher`}
 *     \cgalParamDefault{default_volume_mesher()} \cgalParamNEnd
 *   \cgalParamNBegin{optimization_passes} \cgalParamDescription{see optimize_tetrahedra()} \cgalParamNEnd
 *   \cgalParamNBegin{facet_distance} \cgalParamDescription{see fill_with_mesh_3()} \cgalParamNEnd
 *   \cgalParamNBegin{boundary_layer_prisms} \cgalParamDescription{number of layers of prisms along the wall, inside the
 *     lumen, see extrude_boundary_layer(); these need TetGen or CGAL 6.1. The caps are meshed anew then}
 *     \cgalParamDefault{0} \cgalParamNEnd
 *   \cgalParamNBegin{first_height, growth, boundary_layer_thickness} \cgalParamDescription{of these layers, see
 *     extrude_boundary_layer()} \cgalParamNEnd
 *   \cgalParamNBegin{boundary_layer_report} \cgalParamDescription{a `std::reference_wrapper` of a `Layer_report`: is
 * told where the layers had to be thinner} \cgalParamDefault{nobody is} \cgalParamNEnd \cgalNamedParamsEnd
 *
 * \throws Parameter_error if a parameter is out of its range
 * \throws Meshing_error if the surface cannot be meshed, or TetGen or Mesh_3 fail on it
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
Mixed_mesh make_isotropic_mesh(const Tubular_model& model, Remeshed_surface& surface,
                               const NamedParameters& np = CGAL::parameters::default_values()) {
  internal::stage_observer(np)("size field");
  internal::Model_in_its_frame framed(model);
  Mixed_mesh mesh;
  surface = internal::make_isotropic_mesh_in_frame(framed, mesh, np);
  internal::check_differences(mesh, model);
  framed.bring_back(mesh);
  framed.bring_back(surface.surface);
  mesh.patch_names = lumen_patch_names(int(model.openings.size()));
  return mesh;
}

/*! \ingroup PkgTubularMeshingRef
 *
 * the same, from a surface and its centerlines; takes the named parameters of make_tubular_model() as well.
 */
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Mixed_mesh make_isotropic_mesh(const TriangleMesh& surface, const Centerline_polylines& lines,
                               const NamedParameters& np = CGAL::parameters::default_values()) {
  return make_isotropic_mesh(make_tubular_model(surface, lines, np), np);
}

/*! \ingroup PkgTubularMeshingRef
 *
 * the same, from a surface alone, whose centerlines are computed.
 */
template <class T, class Tag, class Base>
Mixed_mesh make_isotropic_mesh(const CGAL::Surface_mesh<Point_3>& surface,
                               const CGAL::Named_function_parameters<T, Tag, Base>& np) {
  return make_isotropic_mesh(make_tubular_model(surface, np), np);
}

inline Mixed_mesh make_isotropic_mesh(const CGAL::Surface_mesh<Point_3>& surface) {
  return make_isotropic_mesh(surface, CGAL::parameters::default_values());
}

/*! \ingroup PkgTubularMeshingRef
 *
 * makes a mesh of anisotropic tetrahedra (section 3.3 of the paper): thin layers along the wall, of sizes along it that
 * follow its curvature and the centerlines, and isotropic in the core. See Centerline_metric_field for the metric that
 * the tetrahedra are of unit size in, and anisotropic_tetrahedral_remeshing() for how they come about, from an
 * isotropic mesh.
 *
 * The mesh has regions and patches as isotropic ones do, and the point array `metric`: the metric that was asked for.
 *
 * \param model see make_tubular_model()
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{boundary_layer_thickness, first_height, growth, smoothing_ratio, curvature_points,
 *     points_per_circumference, max_anisotropy, min_size, max_size, gradation} \cgalParamDescription{see
 *     Centerline_metric_field} \cgalParamNEnd
 *   \cgalParamNBegin{volume_mesher} \cgalParamDescription{what makes the isotropic mesh to begin with}
 *     \cgalParamDefault{default_volume_mesher()} \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads, observer} \cgalParamDescription{as for make_isotropic_mesh()} \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * O(n log n) in the size of the result.
 *
 * \throws Parameter_error if a parameter is out of its range
 * \throws Meshing_error if no valid mesh comes out
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
Mixed_mesh make_anisotropic_mesh(const Tubular_model& model,
                                 const NamedParameters& np = CGAL::parameters::default_values()) {
  const auto observer = internal::stage_observer(np);
  observer("size field");
  internal::Model_in_its_frame framed(model);
  Mixed_mesh mesh;
  internal::make_isotropic_mesh_in_frame(framed, mesh, np);
  observer("metric field");
  const Centerline_metric_field metric = framed.metric_field(np);
  observer("anisotropic remeshing");
  typedef Named_parameters<std::vector<int>, internal_np::boundary_layer_patches_t, NamedParameters> With_layer;
  anisotropic_tetrahedral_remeshing(mesh, framed.surface(), framed.patch(), metric,
                                    With_layer(std::vector<int>{labels::wall}, np));
  observer("check");
  internal::check_differences(mesh, model);
  framed.bring_back(mesh);
  mesh.region_names = {{labels::lumen, "lumen"}};
  mesh.patch_names = lumen_patch_names(int(model.openings.size()));
  return mesh;
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_H
