// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_ANISOTROPIC_TETRAHEDRAL_REMESHING_H
#define CGAL_TUBULAR_MESHING_VOLUME_ANISOTROPIC_TETRAHEDRAL_REMESHING_H

#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingVolume
 * The named parameters of anisotropic_tetrahedral_remeshing(), as a struct. */
struct Anisotropic_tetrahedral_remeshing_options {
  bool keep_boundary = false;
  std::vector<int> boundary_layer_patches;
  int number_of_threads = 0;

  Anisotropic_tetrahedral_remeshing_options() = default;
  template <class NamedParameters> explicit Anisotropic_tetrahedral_remeshing_options(const NamedParameters& np) {
    keep_boundary = internal::choose(np, internal_np::keep_boundary, keep_boundary);
    boundary_layer_patches = internal::choose(np, internal_np::boundary_layer_patches, boundary_layer_patches);
    number_of_threads = internal::choose(np, internal_np::number_of_threads, number_of_threads);
  }
};

namespace internal {

typedef Function_view<Metric_tensor_3(const Point_3&)> Metric_function;

void anisotropic_tetrahedral_remeshing(Mixed_mesh& mesh, Metric_function metric,
                                       const Anisotropic_tetrahedral_remeshing_options& options);
void anisotropic_tetrahedral_remeshing(Mixed_mesh& mesh, const Surface& surface, Face_patch_map patch,
                                       Metric_function metric,
                                       const Anisotropic_tetrahedral_remeshing_options& options);

} // namespace internal

/*! \ingroup PkgTubularMeshingVolume
 *
 * remeshes a tetrahedral mesh to a metric: into tetrahedra that are as nearly regular, with edges as nearly of length
 * one, as the metric allows when lengths are taken in it by (10). The metric may be anything that varies from place to
 * place, anisotropic or not: any mesh of a domain becomes a mesh of the wanted sizes and directions.
 *
 * Edges are split and collapsed, edges and facets are swapped, vertices are moved. The two operations that make and
 * remove vertices are one: a cavity, the tetrahedra to go, is filled from one vertex, after it has been enlarged to
 * where this gives the best of the worst elements in the measure \f$ Q_\tau \f$ (16). Every change keeps each
 * tetrahedron positively oriented, by a margin well above rounding, so that no element is ever inverted.
 *
 * Labels are kept: regions, patches, the rims at which patches meet, and the corners at which rims meet. Unless it
 * is kept, the boundary is remeshed together with the volume, interfaces between regions too. Its vertices lie on the
 * surface that `mesh` had in the beginning, in the overload with a surface on that surface; edges are kept closer to it
 * than a tenth of their length, where the metric's sizes leave a choice. No triangle turns by more than 37 degrees from
 * the normal that those around it have together, however thin it is, or further than it was turned. Sharp edges inside
 * one patch are no rims: give the two sides patches of their own where they matter.
 *
 * Afterwards the number of tetrahedra is near the integral of \f$ \sqrt{\det M} \f$ over the domain, divided by
 * \f$ \sqrt 2 / 12 \f$, and `mesh` has the point array `metric` (xx, xy, xz, yy, yz, zz): the field at its points.
 * Other point arrays are removed, as their points are gone. Remeshing the result once more changes little.
 *
 * What the metric should be like: sizes that change by less than, say, a factor 1.5 from one element to the next (see
 * Metric_tensor_3::limit_growth()), and on a curved boundary sizes along the surface well below its radius of
 * curvature; otherwise no mesh fits it well. Where sizes are in large ratios, these come about in steps; ratios up to
 * 1000 are tested. At sharp edges of the domain that a metric of a large ratio meets obliquely, bad elements are left,
 * which quality_report() shows. A feature of the field much smaller than the edges of the given mesh may be missed.
 *
 * O(n log n) in the number n of tetrahedra, of the input or of the result, whichever is larger. All passes run on
 * several threads, where oneTBB is there; the result does not depend on their number. About 350 bytes a tetrahedron.
 *
 * \tparam MetricField a model of `MetricField_3`: a function object that gives a Metric_tensor_3 at a `Point_3`. It is
 *   called from several threads at once, unless `number_of_threads` is 1.
 *
 * \param mesh tetrahedra of positive volume, and all facets of their boundary and between regions, each with a patch
 *   other than 0
 * \param metric the field; asked at points of the mesh and, on the boundary, of the surface
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{keep_boundary}
 *     \cgalParamDescription{whether the facets of the boundary and of interfaces stay as they are, one by one}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{boundary_layer_patches}
 *     \cgalParamDescription{the patches along which the metric describes a boundary layer. The first layer there gets
 * as high as the metric's size across it; the regular tetrahedron of unit edges is only 0.8 as high}
 *     \cgalParamType{`std::vector<int>`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads}
 *     \cgalParamDescription{0 takes all cores}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{0}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Input_error if the mesh is not valid (cells other than tetrahedra, inverted cells, boundary facets without a
 *   patch, …), or if the metric somewhere is not finite, not positive definite, has sizes beyond ten times the model's
 *   extent or in a ratio above 10⁵, or asks for more tetrahedra than can be numbered. Whatever is thrown, by the field
 *   as well, `mesh` is then as it was.
 *
 * References: the cavity operator \cgalCite{loseille2013}; edge removal by dynamic programming \cgalCite{klincsek1980}.
 */
template <class MetricField, class NamedParameters = CGAL::parameters::Default_named_parameters>
void anisotropic_tetrahedral_remeshing(Mixed_mesh& mesh, const MetricField& metric,
                                       const NamedParameters& np = CGAL::parameters::default_values()) {
  const auto field = [&metric](const Point_3& p) -> Metric_tensor_3 { return metric(p); };
  internal::anisotropic_tetrahedral_remeshing(mesh, internal::Metric_function(field),
                                              Anisotropic_tetrahedral_remeshing_options(np));
}

/*! \ingroup PkgTubularMeshingVolume
 *
 * The same for a mesh that approximates a given surface: vertices on the boundary come to lie on that surface, not on
 * the facets that the mesh has.
 *
 * \tparam FaceGraph a model of `FaceListGraph`
 * \tparam FacePatchMap a readable property map from its faces to `int`
 *
 * \param mesh as above
 * \param surface the triangulated surface; interfaces of the mesh that are not in it stay on themselves approximately
 * \param patch the labels of its faces: those of the mesh's triangles
 * \param metric as above
 * \param np as above, and
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the surface's vertices}
 *     \cgalParamType{a model of `ReadablePropertyMap`}
 *     \cgalParamDefault{`get(CGAL::vertex_point, surface)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 */
template <class FaceGraph, class FacePatchMap, class MetricField,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void anisotropic_tetrahedral_remeshing(Mixed_mesh& mesh, const FaceGraph& surface, FacePatchMap patch,
                                       const MetricField& metric,
                                       const NamedParameters& np = CGAL::parameters::default_values()) {
  const internal::Core_labelled_surface<FaceGraph, FacePatchMap, NamedParameters> core(surface, patch, np);
  const auto field = [&metric](const Point_3& p) -> Metric_tensor_3 { return metric(p); };
  internal::anisotropic_tetrahedral_remeshing(mesh, core.surface(), core.patch(), internal::Metric_function(field),
                                              Anisotropic_tetrahedral_remeshing_options(np));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Volume/anisotropic_tetrahedral_remeshing_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_VOLUME_ANISOTROPIC_TETRAHEDRAL_REMESHING_H
