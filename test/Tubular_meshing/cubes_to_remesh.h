// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_TEST_CUBES_TO_REMESH_H
#define CGAL_TUBULAR_MESHING_TEST_CUBES_TO_REMESH_H

// What tests of the remesher share: meshes of a cube, metrics, and what is asked of a mesh.

#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>

#include "grid_of_tetrahedra.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace cubes_to_remesh {

namespace tubular = CGAL::Tubular_meshing;
typedef tubular::Point_3 Point;
typedef tubular::Mixed_mesh Mesh;
typedef tubular::Metric_tensor_3 Metric;
using tubular::internal::Vector_3d;

// A grid mapped from the unit cube.
template <class Map, class Label> Mesh make_grid(int nx, int ny, int nz, const Map& map, const Label& label) {
  return grid_of_tetrahedra(
      {nx, ny, nz}, [&](int i, int j, int k) { return map(double(i) / nx, double(j) / ny, double(k) / nz); }, label);
}

// The unit cube, its sides labelled 1 to 6.
inline Mesh make_cube(int n) {
  return make_grid(
      n, n, n, [](double x, double y, double z) { return Point(x, y, z); },
      [](int axis, int end) { return 1 + 2 * axis + end; });
}

inline Metric sizes(double a, double b, double c, const Vector_3d& u = {1, 0, 0}, const Vector_3d& v = {0, 1, 0},
                    const Vector_3d& w = {0, 0, 1}) {
  return Metric::from_sizes(std::array<double, 3>{a, b, c}, std::array<Vector_3d, 3>{u, v, w});
}

inline double volume_of(const Mesh& m, const std::array<std::uint32_t, 4>& t) {
  return tubular::internal::signed_volume(Vector_3d(m.points[t[0]]), Vector_3d(m.points[t[1]]),
                                          Vector_3d(m.points[t[2]]), Vector_3d(m.points[t[3]]));
}
inline double volume(const Mesh& m, int region = 0) {
  double v = 0;
  for (std::size_t i = 0; i < m.tetrahedra.size(); ++i)
    if (region == 0 || m.tetrahedra.label[i] == region)
      v += volume_of(m, m.tetrahedra.vertices[i]);
  return v;
}
inline void expect_valid(const Mesh& m, double expected_volume, double tolerance = 1e-9) {
  const auto r = tubular::validity_report(m);
  EXPECT_TRUE(r.is_valid()) << r.defects();
  EXPECT_NEAR(volume(m), expected_volume, tolerance * expected_volume);
}

} // namespace cubes_to_remesh

#endif // CGAL_TUBULAR_MESHING_TEST_CUBES_TO_REMESH_H
