// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_WALL_FIBRES_IMPL_H
#define CGAL_TUBULAR_MESHING_LAYERS_WALL_FIBRES_IMPL_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Layers/internal/Located_triangles.h>
#include <CGAL/Tubular_meshing/Layers/wall_fibres.h>
#include <CGAL/Tubular_meshing/base/Numbered_cells.h>
#include <CGAL/Tubular_meshing/base/Plane_frame.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing {
namespace internal {

/* The normals of the lumen's surface, outward, linear between those of its vertices. */
class Lumen_normals {
public:
  explicit Lumen_normals(const Mixed_mesh& mesh)
      : triangles_(triangles_of(mesh))
      , located_(triangles_)
      , normals_(mesh.points.size()) {
    for (const auto& t : triangles_.triangles) {
      const Vector_3d p(mesh.points[t[0]]), q(mesh.points[t[1]]), r(mesh.points[t[2]]);
      const Vector_3d area = cross(q - p, r - p);
      for (std::size_t v : t)
        normals_[v] += area;
    }
    for (Vector_3d& n : normals_)
      n = normalized(n);
  }

  Vector_3d operator()(const Point_3& p) const {
    const auto place = located_(p);
    const auto& c = located_.corners(place.triangle);
    Vector_3d n;
    for (std::size_t k = 0; k < 3; ++k)
      n += place.weights[k] * normals_[c[k]];
    return normalized(squared_norm(n) > 0 ? n : normals_[c[0]]);
  }

private:
  static Wall_array triangles_of(const Mixed_mesh& mesh) {
    Wall_array array;
    array.name = "wall";
    array.points = mesh.points;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      if (mesh.triangles.label[i] == labels::wall) {
        const auto& t = mesh.triangles.vertices[i];
        array.triangles.push_back({t[0], t[1], t[2]});
      }
    for (std::size_t i = 0; i < mesh.quads.size(); ++i)
      if (mesh.quads.label[i] == labels::wall) {
        const auto& q = mesh.quads.vertices[i];
        array.triangles.push_back({q[0], q[1], q[2]});
        array.triangles.push_back({q[0], q[2], q[3]});
      }
    if (array.triangles.empty())
      throw Input_error("The mesh has no facets of patch " + std::to_string(labels::wall) +
                        ", the inside of a wall, that its directions could be found from.");
    return array;
  }

  Wall_array triangles_;
  Located_triangles located_;
  std::vector<Vector_3d> normals_;
};

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Wall_fibres wall_fibres(const Mixed_mesh& mesh, const Centerline_graph& graph,
                                                    int number_of_threads) {
  using internal::Vector_3d;
  const internal::cells::Numbered_cells cells(mesh);
  const std::size_t n = cells.size();
  Wall_fibres fibres;
  for (std::size_t c = 0; c < n; ++c)
    fibres.cells += cells.region(c) >= labels::wall_region;
  if (fibres.cells == 0)
    throw Input_error("The mesh has no cells of a wall, region " + std::to_string(labels::wall_region) +
                      " and above, to have directions.");
  fibres.circumferential = {circumferential_array_name, 3, std::vector<double>(3 * n, 0)};
  fibres.longitudinal = {longitudinal_array_name, 3, std::vector<double>(3 * n, 0)};
  const internal::Lumen_normals normals(mesh);
  const Centerline_field field(graph);
  std::vector<char> is_undirected(n, 0);
  internal::for_each_range(n, number_of_threads, [&](std::size_t first, std::size_t last) {
    const double least = 0.2; // of the branch's direction, along the wall
    for (std::size_t c = first; c < last; ++c) {
      if (cells.region(c) < labels::wall_region)
        continue;
      const auto corners = cells.corners(c);
      Vector_3d middle;
      for (std::uint32_t v : corners)
        middle += (1. / double(corners.number)) * Vector_3d(mesh.points[v]);
      const Point_3 p = internal::as<Point_3>(middle);
      const Vector_3d radial = normals(p), along(field.frame(p).e_t);
      Vector_3d longitudinal = along - dot(along, radial) * radial;
      is_undirected[c] = !(norm(longitudinal) > least);
      longitudinal = norm(longitudinal) > 1e-6 ? normalized(longitudinal) : internal::Plane_frame(middle, radial).u;
      const Vector_3d circumferential = cross(longitudinal, radial);
      for (std::size_t k = 0; k < 3; ++k) {
        fibres.longitudinal.values[3 * c + k] = longitudinal[int(k)];
        fibres.circumferential.values[3 * c + k] = circumferential[int(k)];
      }
    }
  });
  fibres.undirected = std::size_t(std::count(is_undirected.begin(), is_undirected.end(), 1));
  return fibres;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_LAYERS_WALL_FIBRES_IMPL_H
