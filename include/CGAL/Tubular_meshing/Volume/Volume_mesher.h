// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_VOLUME_MESHER_H
#define CGAL_TUBULAR_MESHING_VOLUME_VOLUME_MESHER_H

#include <CGAL/Tubular_meshing/Volume/fill_with_ccdt.h>
#include <CGAL/Tubular_meshing/Volume/fill_with_tetgen.h>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 * What fills a surface mesh with tetrahedra. */
enum class Volume_mesher {
  mesh_3, ///< CGAL's Mesh_3, which meshes the surface anew
  tetgen, ///< TetGen, which keeps it: see has_tetgen()
  ccdt    ///< CGAL's constrained triangulations in space, which keep it: see has_ccdt()
};

/*! \ingroup PkgTubularMeshingRef
 * One that keeps the surface mesh, if this program has it. */
constexpr Volume_mesher default_volume_mesher() {
  return has_tetgen() ? Volume_mesher::tetgen : has_ccdt() ? Volume_mesher::ccdt : Volume_mesher::mesh_3;
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_VOLUME_MESHER_H
