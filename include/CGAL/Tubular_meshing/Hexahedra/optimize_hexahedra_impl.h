// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_OPTIMIZE_HEXAHEDRA_IMPL_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_OPTIMIZE_HEXAHEDRA_IMPL_H

#include <CGAL/Tubular_meshing/Hexahedra/internal/Hexahedron_optimizer.h>
#include <CGAL/Tubular_meshing/Hexahedra/optimize_hexahedra.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <string>

namespace CGAL::Tubular_meshing::internal {

inline void check_hexahedra_options(const Mixed_mesh& mesh, const Optimize_hexahedra_options& options) {
  const auto fits = [](std::size_t size, std::size_t wanted, const std::string& what, const std::string& of) {
    if (size != wanted)
      throw Parameter_error(what + " have " + std::to_string(size) + " values; give one for each of the " +
                            std::to_string(wanted) + " " + of + ".");
  };
  if (options.fixed_vertices != nullptr)
    fits(options.fixed_vertices->size(), mesh.points.size(), "The fixed vertices", "vertices");
  if (options.target_lengths != nullptr) {
    fits(options.target_lengths->size(), mesh.hexahedra.size(), "The target lengths", "hexahedra");
    for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h)
      for (double l : (*options.target_lengths)[h])
        if (!(l > 0))
          throw Parameter_error("A target length of hexahedron " + std::to_string(h) +
                                " is not positive; give three positive lengths for each hexahedron.");
  }
  if (!(options.tempering >= 0 && options.tempering <= 1))
    throw Parameter_error("The tempering is " + std::to_string(options.tempering) + "; give a number from 0 to 1.");
}

CGAL_TUBULAR_MESHING_INLINE Optimize_hexahedra_report optimize_hexahedra(Mixed_mesh& mesh, const Surface& surface,
                                                                         Face_patch_map patch,
                                                                         const Optimize_hexahedra_options& options) {
  check_hexahedra_options(mesh, options);
  return Hexahedron_optimizer(mesh, surface, patch, options).run();
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_OPTIMIZE_HEXAHEDRA_IMPL_H
