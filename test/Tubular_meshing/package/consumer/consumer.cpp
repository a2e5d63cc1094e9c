// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>

// A mesh of one tetrahedron and its facets, judged by what the library compiles.
int main() {
  namespace tubular = CGAL::Tubular_meshing;
  typedef tubular::Element_block<3>::Element Triangle;
  tubular::Mixed_mesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.tetrahedra.push_back({0, 1, 2, 3}, tubular::labels::lumen);
  for (const auto& facet : {Triangle{0, 2, 1}, Triangle{0, 1, 3}, Triangle{1, 2, 3}, Triangle{0, 3, 2}})
    mesh.triangles.push_back(facet, tubular::labels::wall);
  return tubular::validity_report(mesh).is_valid() ? 0 : 1;
}
