// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_VOLUME_MESHER_H
#define CGAL_TUBULAR_MESHING_VOLUME_VOLUME_MESHER_H

#include <CGAL/Tubular_meshing/base/config.h>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingVolume
 * What fills a surface mesh with tetrahedra. */
enum class Volume_mesher {
  mesh_3, ///< CGAL's Mesh_3, which meshes the surface again: see fill_with_mesh_3()
  tetgen, ///< TetGen, which keeps it: see fill_keeping_boundary() and has_tetgen()
  ccdt    ///< CGAL's constrained triangulations in space, which keep it: see fill_keeping_boundary() and has_ccdt()
};

/*! \ingroup PkgTubularMeshingVolume
 *
 * Whether this library is linked with TetGen. CMake sees to that where it finds it; otherwise define
 * `CGAL_TUBULAR_MESHING_WITH_TETGEN` and link `-ltet`. TetGen is free software under the AGPL, version 3 or later.
 */
bool has_tetgen();

/*! \ingroup PkgTubularMeshingVolume
 *
 * Whether the version of \cgal that this library was built with has constrained Delaunay triangulations in space: 6.1
 * and later.
 */
bool has_ccdt();

/*! \ingroup PkgTubularMeshingVolume
 * One that keeps the surface mesh, if this library has it. */
inline Volume_mesher default_volume_mesher() {
  return has_tetgen() ? Volume_mesher::tetgen : has_ccdt() ? Volume_mesher::ccdt : Volume_mesher::mesh_3;
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Volume/Volume_mesher_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_VOLUME_VOLUME_MESHER_H
