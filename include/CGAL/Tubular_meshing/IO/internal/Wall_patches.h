// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_WALL_PATCHES_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_WALL_PATCHES_H

#include <CGAL/Tubular_meshing/IO/internal/Facet_sides.h>
#include <CGAL/Tubular_meshing/Layers/Wall_materials.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <cstddef>

namespace CGAL::Tubular_meshing::IO::internal {

/* Which patches are walls, by the labels of this package: the lumen's surface, the outer and the middle wall, and the
 * interfaces of materials; not
 * openings, nor the rings around them. */
class Wall_patches {
public:
  Wall_patches(const Numbered_cells& cells, const Facet_sides& facets) {
    int largest = labels::wall; // of the lumen's patches
    for (std::size_t f = 0; f < facets.size(); ++f)
      if (cells.region(facets.sides(f)[0].cell) <= labels::lumen)
        largest = (std::max)(largest, facets.label(f));
    outer_ = labels::outer_wall_for(largest);
  }

  bool contain(int label) const {
    return label == labels::wall || label == outer_ || label == outer_ + 1 ||
           label == labels::material_interface(outer_);
  }

private:
  int outer_;
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_WALL_PATCHES_H
