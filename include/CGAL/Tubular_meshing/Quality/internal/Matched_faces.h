// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_INTERNAL_MATCHED_FACES_H
#define CGAL_TUBULAR_MESHING_QUALITY_INTERNAL_MATCHED_FACES_H

#include <CGAL/Tubular_meshing/base/Face_buckets.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Numbered_cells.h>

namespace CGAL::Tubular_meshing::internal {

// The cells of a mesh, or of one region of it, and their faces: what costs most of a report, made once for several.
struct Matched_faces {
  cells::Numbered_cells cells;
  cells::Face_buckets faces;
  const int* region; // null: all

  Matched_faces(const Mixed_mesh& mesh, cells::Face_buckets::Facets facets, int threads, const int* region = nullptr)
      : cells(mesh)
      , faces(cells, facets, threads, region)
      , region(region) {}
  // Those of another mesh that has the same elements: O(1).
  Matched_faces(const Mixed_mesh& mesh, const Matched_faces& of_same_elements)
      : cells(mesh)
      , faces(cells, of_same_elements.faces)
      , region(of_same_elements.region) {}
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUALITY_INTERNAL_MATCHED_FACES_H
