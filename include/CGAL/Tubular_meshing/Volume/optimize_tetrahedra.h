// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_OPTIMIZE_TETRAHEDRA_H
#define CGAL_TUBULAR_MESHING_VOLUME_OPTIMIZE_TETRAHEDRA_H

#include <CGAL/Tubular_meshing/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Volume/internal/Patch_projection.h>
#include <CGAL/Tubular_meshing/Volume/internal/Surface_flip_guard.h>
#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>
#include <CGAL/Tubular_meshing/Volume/internal/Topology_optimizer.h>
#include <CGAL/Tubular_meshing/Volume/internal/Vertex_optimizer.h>
#include <CGAL/Tubular_meshing/Volume/internal/reduce_deviation.h>
#include <CGAL/Tubular_meshing/parameters.h>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 *
 * improves the shape of a tetrahedral mesh, its surface included, by flips and by moving vertices.
 *
 * Rounds of flips, each raising the worst quality \f$ \gamma_\tau \f$ (13) of the few tetrahedra it changes, alternate
 * with sweeps that move each vertex down the sum of \f$ Q_\tau \f$ (16) around it. Vertices on the surface stay on the
 * given surface and in their patch, vertices on rims on their rim; no element is inverted, no facet changes its label,
 * and the sizes of elements stay what they are. In the last round the mesh is brought to those vertices of the surface
 * that it cuts off by more than a small part of its edges. The improvement of the first rounds is by far the largest.
 *
 * Linear in the size of the mesh for each round. Sweeps run in parallel; the result does not depend on the number of
 * threads.
 *
 * \tparam SurfaceMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam FacePatchMap a readable property map from its faces to `int`
 *
 * \param mesh tetrahedra, positively oriented, and all their boundary triangles, labelled
 * \param surface the closed triangulated surface that the mesh approximates
 * \param patch the labels of its faces: those of the mesh's triangles
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{optimization_passes} \cgalParamDescription{number of rounds} \cgalParamDefault{2} \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads} \cgalParamDescription{0 takes all cores} \cgalParamDefault{0} \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * References: edge removal by dynamic programming, \cgalCite{klincsek1980}; swapping and smoothing in turn,
 * \cgalCite{freitag1997}.
 */
template <class Point, class SurfaceMesh, class FacePatchMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void optimize_tetrahedra(Mixed_mesh<Point>& mesh, const SurfaceMesh& surface, FacePatchMap patch,
                         const NamedParameters& np = CGAL::parameters::default_values()) {
  const int passes = internal::choose(np, internal_np::optimization_passes, 2);
  const int threads = internal::choose(np, internal_np::number_of_threads, 0);
  const internal::Patch_projection projection(surface, patch);
  internal::Tetrahedron_store store(mesh);
  typedef internal::Surface_flip_guard<internal::Patch_projection> Guard;
  typedef internal::Topology_optimizer<Guard> Topology_optimizer;

  // Where flips start from: slivers first, then whatever is clearly below the mean that comes out.
  Topology_optimizer(store, Guard(store, projection)).improve_below(0.5);
  for (int pass = 0; pass < passes; ++pass) {
    internal::Vertex_optimizer<internal::Patch_projection> vertices(store, projection, threads);
    vertices.sweep();
    vertices.sweep();
    if (pass + 1 == passes)
      internal::reduce_deviation(surface, patch, store, vertices, threads);
    Topology_optimizer(store, Guard(store, projection)).improve_below(0.6);
  }
  store.write_to(mesh);
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_OPTIMIZE_TETRAHEDRA_H
