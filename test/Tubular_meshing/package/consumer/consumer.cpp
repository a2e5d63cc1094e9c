// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>

int main() {
  CGAL::Tubular_meshing::Mixed_mesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.tetrahedra.push_back({0, 1, 2, 3}, CGAL::Tubular_meshing::labels::lumen);
  return mesh.number_of_cells() == 1 ? 0 : 1;
}
