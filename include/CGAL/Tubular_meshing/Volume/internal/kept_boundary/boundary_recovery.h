// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_BOUNDARY_RECOVERY_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_BOUNDARY_RECOVERY_H

#include <CGAL/Tubular_meshing/Volume/Volume_mesher.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Recovered_boundary.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/version.h>

#include <functional>
#include <string>

#ifdef CGAL_TUBULAR_MESHING_WITH_TETGEN
#include <CGAL/Tubular_meshing/Volume/internal/tetgen/run_tetgen.h>
#endif
#if CGAL_VERSION_NR >= 1060100000
#define CGAL_TUBULAR_MESHING_WITH_CCDT
#include <CGAL/Tubular_meshing/Volume/internal/ccdt/run_ccdt.h>
#endif

namespace CGAL::Tubular_meshing::internal {

/* What connects the points of a boundary. `run` returns 0 or one of TetGen's numbers for what went wrong; `name` is
 * what it is called in a sentence; `keeps_inner_facets`: triangles may lie inside the boundary of what is filled. */
struct Boundary_recovery {
  std::function<int(const Boundary_arrays&, Recovered_boundary&)> run;
  std::string name;
  bool keeps_inner_facets = false;

  bool is_there() const { return bool(run); }
};

inline Boundary_recovery tetgen_recovery() {
#ifdef CGAL_TUBULAR_MESHING_WITH_TETGEN
  return {run_tetgen, "TetGen", true};
#else
  return {};
#endif
}

inline Boundary_recovery ccdt_recovery() {
#ifdef CGAL_TUBULAR_MESHING_WITH_CCDT
  return {run_ccdt, "CGAL", false};
#else
  return {};
#endif
}

inline Boundary_recovery recovery_by(Volume_mesher mesher) {
  const Boundary_recovery recovery = mesher == Volume_mesher::tetgen ? tetgen_recovery()
                                     : mesher == Volume_mesher::ccdt ? ccdt_recovery()
                                                                     : Boundary_recovery();
  if (recovery.is_there())
    return recovery;
  if (mesher == Volume_mesher::tetgen)
    throw Meshing_error("This program was built without TetGen: build it where CMake finds TetGen (libtet1.5-dev), or "
                        "use fill_with_mesh_3().");
  if (mesher == Volume_mesher::ccdt)
    throw Meshing_error("This program was built with a version of CGAL before 6.1, which has no constrained "
                        "triangulations in space: use TetGen or fill_with_mesh_3().");
  throw Meshing_error("Mesh_3 does not keep the surface: build this program where CMake finds TetGen (libtet1.5-dev), "
                      "or CGAL 6.1 or later, and choose one of these, or use fill_with_mesh_3().");
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_BOUNDARY_RECOVERY_H
