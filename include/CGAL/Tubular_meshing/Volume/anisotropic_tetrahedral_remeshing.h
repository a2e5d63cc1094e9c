// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_ANISOTROPIC_TETRAHEDRAL_REMESHING_H
#define CGAL_TUBULAR_MESHING_VOLUME_ANISOTROPIC_TETRAHEDRAL_REMESHING_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Volume/internal/Patch_projection.h>
#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Metric_mesh.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Metric_remesher.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/remeshing_input.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

// A user's field, as the remesher asks it.
template <class MetricField> struct Metric_at_vector {
  const MetricField& field;
  Metric_tensor_3 operator()(const Vector_3d& p) const { return field(Point_3(p.x, p.y, p.z)); }
};

struct No_observer {
  template <class Remesher> void operator()(const Remesher&, const char*, std::size_t) const {}
};

/* All work is done on a copy: `mesh` is as it was until the end. `make_projection(store)` gives the surface on which
 * the vertices of the boundary stay. */
template <class MetricField, class MakeProjection, class NamedParameters, class Observer>
void remesh_to_metric(Mixed_mesh& mesh, const MetricField& metric, const MakeProjection& make_projection,
                      const NamedParameters& np, const Observer& observe) {
  typedef Metric_at_vector<MetricField> Field;
  const bool keep_boundary = choose(np, internal_np::keep_boundary, false);
  const int threads = choose(np, internal_np::number_of_threads, 0);
  const auto layer_patches = choose(np, internal_np::boundary_layer_patches, std::vector<int>());
  if (threads < 0)
    throw Parameter_error("number_of_threads is negative; pass the number of threads, or 0 for all cores.");
  check_mesh_to_remesh(mesh);
  std::unique_ptr<Tetrahedron_store> store(new Tetrahedron_store(mesh));
  const Patch_projection projection(make_projection(*store));
  const Field field{metric};
  Metric_mesh<Field> metric_mesh(*store, field, projection, keep_boundary, layer_patches, threads);
  Metric_remesher<Field>(metric_mesh).run(observe);
  metric_mesh.renumber();
  const std::vector<Metric_tensor_3> metrics = metric_mesh.take_metrics();

  Mixed_mesh result;
  const auto number = store->write_to(result);
  store.reset();
  Point_array array{"metric", 6, std::vector<double>(6 * result.points.size())};
  for (std::size_t v = 0; v < number.size(); ++v)
    if (number[v] != Tetrahedron_store::none) {
      const auto components = metrics[v].components();
      std::copy(components.begin(), components.end(), array.values.begin() + 6 * std::ptrdiff_t(number[v]));
    }
  mesh.points.swap(result.points);
  std::swap(mesh.tetrahedra, result.tetrahedra);
  std::swap(mesh.triangles, result.triangles);
  mesh.point_arrays.assign(1, std::move(array));
}

} // namespace internal

/*! \ingroup PkgTubularMeshingRef
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
 * Labels are kept: regions, patches, the rims at which patches meet, and the corners at which rims meet. Unless told to
 * keep it, the boundary is remeshed together with the volume, interfaces between regions too. Its vertices lie on the
 * surface that `mesh` had in the beginning, in the overload with a surface on that surface; edges are kept closer to it
 * than a tenth of their length, where the metric's sizes leave a choice. Sharp edges inside one patch are no rims: give
 * the two sides patches of their own where they matter.
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
 * \tparam Point a model of `Point_3`, constructible from three `double`
 * \tparam MetricField a model of `MetricField_3`: a function object that gives a Metric_tensor_3 at a `Point`. It is
 *   called from several threads at once, unless `number_of_threads` is 1.
 *
 * \param mesh tetrahedra of positive volume, and all facets of their boundary and between regions, each with a patch
 *   other than 0
 * \param metric the field; asked at points of the mesh and, on the boundary, of the surface
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{keep_boundary} \cgalParamDescription{whether the facets of the boundary and of interfaces stay as
 *     they are, one by one} \cgalParamDefault{`false`} \cgalParamNEnd
 *   \cgalParamNBegin{boundary_layer_patches} \cgalParamDescription{a `std::vector<int>`: the patches along which the
 *     metric describes a boundary layer. The first layer there gets as high as the metric's size across it; the regular
 *     tetrahedron of unit edges is only 0.8 as high} \cgalParamDefault{none} \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads} \cgalParamDescription{0 takes all cores} \cgalParamDefault{0} \cgalParamNEnd
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
  internal::remesh_to_metric(
      mesh, metric, [](const internal::Tetrahedron_store& store) { return internal::Patch_projection(store); }, np,
      internal::No_observer());
}

/*! \ingroup PkgTubularMeshingRef
 *
 * The same for a mesh that approximates a given surface: vertices on the boundary come to lie on that surface, not on
 * the facets that the mesh has.
 *
 * \tparam Surface a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam Face_patch_map a readable property map from its faces to `int`
 *
 * \param mesh as above
 * \param surface the triangulated surface; interfaces of the mesh that are not in it stay on themselves approximately
 * \param patch the labels of its faces: those of the mesh's triangles
 * \param metric as above
 * \param np as above
 */
template <class MetricField, class NamedParameters = CGAL::parameters::Default_named_parameters>
void anisotropic_tetrahedral_remeshing(Mixed_mesh& mesh, const Surface& surface, Face_patch_map patch,
                                       const MetricField& metric,
                                       const NamedParameters& np = CGAL::parameters::default_values()) {
  internal::remesh_to_metric(
      mesh, metric, [&](const internal::Tetrahedron_store&) { return internal::Patch_projection(surface, patch); }, np,
      internal::No_observer());
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_ANISOTROPIC_TETRAHEDRAL_REMESHING_H
