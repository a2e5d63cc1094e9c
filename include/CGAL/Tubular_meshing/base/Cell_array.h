// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_CELL_ARRAY_H
#define CGAL_TUBULAR_MESHING_BASE_CELL_ARRAY_H

#include <string>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingBase
 *
 * Values of the cells of a mesh: `components` numbers a cell, cell after cell; first those of tetrahedra, then of
 * pyramids, prisms and hexahedra, each in the order of the mesh. They are made for a mesh that does not change any more,
 * and written with it: IO::write_mesh(). */
struct Cell_array {
  std::string name;
  int components = 1;
  std::vector<double> values;
};

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_BASE_CELL_ARRAY_H
