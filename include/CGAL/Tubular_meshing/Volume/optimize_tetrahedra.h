// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_OPTIMIZE_TETRAHEDRA_H
#define CGAL_TUBULAR_MESHING_VOLUME_OPTIMIZE_TETRAHEDRA_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Kept_boundary.h>
#include <CGAL/Tubular_meshing/Volume/internal/Patch_projection.h>
#include <CGAL/Tubular_meshing/Volume/internal/Surface_flip_guard.h>
#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>
#include <CGAL/Tubular_meshing/Volume/internal/Topology_optimizer.h>
#include <CGAL/Tubular_meshing/Volume/internal/Vertex_optimizer.h>
#include <CGAL/Tubular_meshing/Volume/internal/reduce_deviation.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/remesh_worst.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/write_inside.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

// Where flips start from: slivers first, then whatever is clearly below the mean that comes out.
constexpr double first_flips_below = 0.5;
constexpr double later_flips_below = 0.6;

inline void optimize_with_surface(Mixed_mesh& mesh, const Surface& surface, Face_patch_map patch, int passes,
                                  int threads) {
  typedef Surface_flip_guard<Patch_projection> Guard;
  const Patch_projection projection(surface, patch);
  Tetrahedron_store store(mesh);
  const Guard guard(store, projection);
  Topology_optimizer<Guard>(store, guard).improve_below(first_flips_below);
  for (int pass = 0; pass < passes; ++pass) {
    Vertex_optimizer<Patch_projection> vertices(store, projection, threads);
    vertices.sweep();
    vertices.sweep();
    if (pass + 1 == passes)
      reduce_deviation(surface, patch, store, vertices, threads);
    Topology_optimizer<Guard>(store, guard).improve_below(later_flips_below);
  }
  store.write_to(mesh);
}

// Flips and sweeps alone leave a few tetrahedra of boundary vertices at 0.15 to 0.25: those are remeshed.
constexpr double remeshed_below = 0.4;

inline void optimize_inside(Mixed_mesh& mesh, int passes, int threads) {
  const Kept_boundary boundary;
  Tetrahedron_store store(mesh);
  Topology_optimizer<Kept_boundary>(store, boundary).improve_below(first_flips_below);
  for (int pass = 0; pass < passes; ++pass) {
    Vertex_optimizer<Kept_boundary> vertices(store, boundary, threads);
    vertices.sweep();
    vertices.sweep();
    Topology_optimizer<Kept_boundary>(store, boundary).improve_below(later_flips_below);
    remesh_worst(store, remeshed_below);
  }
  write_inside(store, mesh);
}

} // namespace internal

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
 * With `keep_boundary(true)` only the inside changes: all labelled triangles, interfaces between regions included, and
 * their vertices stay bit for bit, in their order. Where tetrahedra of vertices that may not move stay bad, vertices
 * are added or taken away around them.
 *
 * Linear in the size of the mesh for each round. Sweeps run in parallel; the result does not depend on the number of
 * threads.
 *
 * \tparam Surface a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam Face_patch_map a readable property map from its faces to `int`
 *
 * \param mesh tetrahedra, positively oriented, and all their boundary triangles, labelled
 * \param surface the closed triangulated surface that the mesh approximates
 * \param patch the labels of its faces: those of the mesh's triangles
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{optimization_passes} \cgalParamDescription{number of rounds} \cgalParamDefault{2} \cgalParamNEnd
 *   \cgalParamNBegin{keep_boundary} \cgalParamDescription{only the inside is improved; `surface` and `patch` make no
 *     difference then} \cgalParamDefault{false} \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads} \cgalParamDescription{0 takes all cores} \cgalParamDefault{0} \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * References: edge removal by dynamic programming, \cgalCite{klincsek1980}; swapping and smoothing in turn,
 * \cgalCite{freitag1997}; new vertices in cavities that grow, \cgalCite{klingner2007}.
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
void optimize_tetrahedra(Mixed_mesh& mesh, const Surface& surface, Face_patch_map patch,
                         const NamedParameters& np = CGAL::parameters::default_values()) {
  const int passes = internal::choose(np, internal_np::optimization_passes, 2);
  const int threads = internal::choose(np, internal_np::number_of_threads, 0);
  if (internal::choose(np, internal_np::keep_boundary, false))
    internal::optimize_inside(mesh, passes, threads);
  else
    internal::optimize_with_surface(mesh, surface, patch, passes, threads);
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_OPTIMIZE_TETRAHEDRA_H
