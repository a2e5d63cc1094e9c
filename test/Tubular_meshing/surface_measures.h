// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What tests ask of a surface as a whole.

#ifndef CGAL_TUBULAR_MESHING_TEST_SURFACE_MEASURES_H
#define CGAL_TUBULAR_MESHING_TEST_SURFACE_MEASURES_H

#include <CGAL/Tubular_meshing/base/Nearest_tree.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

typedef CGAL::Tubular_meshing::internal::Nearest_tree<CGAL::Tubular_meshing::internal::Double_kernel::Triangle_3>
    Triangle_tree;

template <class Point> Triangle_tree tree_of(const CGAL::Surface_mesh<Point>& mesh) {
  std::vector<CGAL::Tubular_meshing::internal::Double_kernel::Triangle_3> triangles;
  for (auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    const auto at = [&](auto v) { return CGAL::Tubular_meshing::internal::to_double_point(mesh.point(v)); };
    triangles.emplace_back(at(mesh.source(h)), at(mesh.target(h)), at(mesh.target(mesh.next(h))));
  }
  return Triangle_tree(std::move(triangles));
}

// The largest distance from a vertex of one surface to another surface, which is of triangles.
template <class Point> double distance(const CGAL::Surface_mesh<Point>& from, const CGAL::Surface_mesh<Point>& to) {
  const Triangle_tree tree = tree_of(to);
  double largest = 0;
  for (auto v : from.vertices())
    largest = (std::max)(
        largest, tree.nearest(CGAL::Tubular_meshing::internal::to_double_point(from.point(v))).squared_distance);
  return std::sqrt(largest);
}

// The diagonal of the bounding box.
template <class Point> double extent(const CGAL::Surface_mesh<Point>& mesh) {
  const CGAL::Bbox_3 b = CGAL::Polygon_mesh_processing::bbox(mesh);
  return std::sqrt(CGAL::square(b.x_span()) + CGAL::square(b.y_span()) + CGAL::square(b.z_span()));
}

// Euler's characteristic.
template <class Point> long euler(const CGAL::Surface_mesh<Point>& mesh) {
  return long(mesh.number_of_vertices()) - long(mesh.number_of_edges()) + long(mesh.number_of_faces());
}

#endif // CGAL_TUBULAR_MESHING_TEST_SURFACE_MEASURES_H
