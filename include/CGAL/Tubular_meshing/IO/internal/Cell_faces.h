// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_CELL_FACES_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_CELL_FACES_H

#include <CGAL/Tubular_meshing/base/Cell_neighbours.h>
#include <CGAL/Tubular_meshing/base/Numbered_cells.h>

namespace CGAL::Tubular_meshing::IO::internal {

using Tubular_meshing::internal::cells::Cell_faces;
using Tubular_meshing::internal::cells::Cell_neighbours;
using Tubular_meshing::internal::cells::Face;
using Tubular_meshing::internal::cells::face_of;
using Tubular_meshing::internal::cells::faces_of;
using Tubular_meshing::internal::cells::lowest_corner;
using Tubular_meshing::internal::cells::no_cell;
using Tubular_meshing::internal::cells::no_vertex;
using Tubular_meshing::internal::cells::number_of_corners;
using Tubular_meshing::internal::cells::Numbered_cells;
using Tubular_meshing::internal::cells::sorted;

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_CELL_FACES_H
