// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_TETGEN_H
#define CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_TETGEN_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/fill_keeping_boundary.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#ifdef CGAL_TUBULAR_MESHING_WITH_TETGEN
#include <CGAL/Tubular_meshing/Volume/internal/tetgen/run_tetgen.h>
#endif

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 *
 * Whether this program is linked with TetGen. CMake sees to that where it finds it; otherwise define
 * `CGAL_TUBULAR_MESHING_WITH_TETGEN` and link `-ltet`. TetGen is free software under the AGPL, version 3 or later.
 */
constexpr bool has_tetgen() {
#ifdef CGAL_TUBULAR_MESHING_WITH_TETGEN
  return true;
#else
  return false;
#endif
}

/*! \ingroup PkgTubularMeshingRef
 *
 * fills a closed labelled surface with tetrahedra and keeps it as it is, facet for facet. TetGen (\cgalCite{si2015})
 * connects the points of the surface; Delaunay refinement adds points inside, as many as the field asks for. What makes
 * the mesh good is optimize_tetrahedra() with `keep_boundary(true)`.
 *
 * TetGen runs in a child process: whatever happens there, a crash included, this program goes on, with an exception.
 * Nothing is printed. The surface is handed over in a frame of unit extent: units and distance from the origin make no
 * difference. One thread; the result is reproducible. About linear in the number of tetrahedra.
 *
 * \param surface a closed triangle mesh without self-intersections, its faces turned outward
 * \param patch a readable property map from its faces to `int`
 * \param size a model of `MeshDomainField_3`: the wanted length of edges. Inside, edges are 1.05 times as long on
 *   average. Must outlive the call only.
 * \param mesh is replaced: tetrahedra of region labels::lumen, and the surface's triangles. Its first points are the
 *   surface's, its triangles the surface's faces, both in their order and bit for bit.
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{time_limit} \cgalParamDescription{seconds of processor time after which TetGen is stopped}
 *     \cgalParamDefault{ten minutes, and a hundredth of a second for each triangle: a hundred times what it should
 * take} \cgalParamNEnd \cgalNamedParamsEnd
 *
 * \throws Meshing_error if the surface is not closed, if TetGen fails or cannot keep the surface, or if this program is
 *   not linked with it (see has_tetgen()). fill_with_mesh_3() is the way out.
 */
template <class SizingField, class NamedParameters = CGAL::parameters::Default_named_parameters>
void fill_with_tetgen(const Surface& surface, Face_patch_map patch, const SizingField& size, Mixed_mesh& mesh,
                      const NamedParameters& np = CGAL::parameters::default_values()) {
#ifdef CGAL_TUBULAR_MESHING_WITH_TETGEN
  const double seconds = internal::choose(np, internal_np::time_limit, 600 + 0.01 * double(num_faces(surface)));
  internal::fill_keeping_boundary(surface, patch, size, internal::run_tetgen, "TetGen", {seconds}, mesh);
#else
  (void)surface, (void)patch, (void)size, (void)mesh, (void)np;
  throw Meshing_error(
      "This program was built without TetGen: build it where CMake finds TetGen (libtet1.5-dev), or use "
      "fill_with_mesh_3().");
#endif
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_TETGEN_H
