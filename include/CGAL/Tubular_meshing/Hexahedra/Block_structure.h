// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_BLOCK_STRUCTURE_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_BLOCK_STRUCTURE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingHexahedra
 *
 * The blocks that hexahedra along vessels are in, for methods that take curved blocks, such as spectral elements and
 * isogeometric analysis: one hexahedron a block, between vertices of the hexahedra. A vessel has twelve blocks, four of
 * its core and eight of the ring; a blind end has four more, on its dome.
 */
struct Block_structure {
  Element_block<8> hexahedra; ///< the label is the number of the branch of the centerlines, from 0
  Element_block<4> quads;     ///< of the boundary; the label is that of its patch
};

/*! \ingroup PkgTubularMeshingHexahedra
 *
 * makes the mesh of a block structure: its region `branch_K`, labeled K + 1, is what lies along branch K.
 *
 * Linear in the points.
 *
 * \param blocks vertices are numbers of points
 * \param points of the mesh that the blocks are of; layers that were put in do not matter, as they add points at the end
 * \param first_branch what is added to the numbers of branches, where other vessels come before
 */
inline Mixed_mesh make_block_mesh(const Block_structure& blocks, const std::vector<Point_3>& points,
                                  std::size_t first_branch = 0) {
  constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();
  Mixed_mesh mesh;
  std::vector<std::uint32_t> number(points.size(), none);
  const auto renumbered = [&](auto element) {
    for (std::uint32_t& v : element) {
      if (number[v] == none) {
        number[v] = std::uint32_t(mesh.points.size());
        mesh.points.push_back(points[v]);
      }
      v = number[v];
    }
    return element;
  };
  for (std::size_t i = 0; i < blocks.hexahedra.size(); ++i) {
    const int branch = int(first_branch) + blocks.hexahedra.label[i];
    mesh.hexahedra.push_back(renumbered(blocks.hexahedra.vertices[i]), branch + 1);
    mesh.region_names.emplace(branch + 1, "branch_" + std::to_string(branch));
  }
  for (std::size_t i = 0; i < blocks.quads.size(); ++i)
    mesh.quads.push_back(renumbered(blocks.quads.vertices[i]), blocks.quads.label[i]);
  return mesh;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_BLOCK_STRUCTURE_H
