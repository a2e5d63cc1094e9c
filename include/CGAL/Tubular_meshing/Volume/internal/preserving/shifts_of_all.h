// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PRESERVING_SHIFTS_OF_ALL_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PRESERVING_SHIFTS_OF_ALL_H

#include <CGAL/Tubular_meshing/Volume/internal/preserving/Boundary_surface.h>
#include <CGAL/Tubular_meshing/Volume/internal/preserving/Input_surface.h>
#include <CGAL/Tubular_meshing/Volume/internal/preserving/Shift_holder.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* How the points inside of a mesh follow those of its wall. */
class Inside_follower {
public:
  Inside_follower(const Boundary_surface& boundary, const Shift_holder& of_boundary, const Input_surface& input)
      : of_boundary_(of_boundary) {
    std::vector<Double_kernel::Triangle_3> triangles;
    const auto point = [&](std::size_t v) { return to_double_point(of_boundary.from(v)); };
    for (auto f : boundary.surface.faces()) {
      std::vector<std::size_t> c;
      for (auto v : boundary.surface.vertices_around_face(boundary.surface.halfedge(f)))
        c.push_back(std::size_t(v));
      if (boundary.patch[f] == labels::wall) {
        for (std::size_t k = 2; k < c.size(); ++k) { // a quad is two triangles
          corners_.push_back({{c[0], c[k - 1], c[k]}});
          triangles.emplace_back(point(c[0]), point(c[k - 1]), point(c[k]));
        }
      } else if (const Input_surface::Opening* o = input.opening(boundary.patch[f]))
        for (std::size_t v : c)
          plane_of_[boundary.point_of[v]] = o->normal;
    }
    tree_ = Nearest_tree<Double_kernel::Triangle_3>(std::move(triangles));
  }

  /* The shift of a point that is not on the wall, in reach of it. */
  Vector_3d shift(std::uint32_t number, const Vector_3d& p, double reach) const {
    const auto found = tree_.nearest(Double_kernel::Point_3(p.x, p.y, p.z), reach * reach);
    if (found.index >= tree_.size())
      return Vector_3d();
    const double x = std::sqrt(found.squared_distance) / reach;
    Vector_3d s = (1 - x) * (1 - x) * (1 + 2 * x) * at(found.index, Vector_3d(found.point));
    const auto plane = plane_of_.find(number);
    if (plane != plane_of_.end())
      s = s - dot(s, plane->second) * plane->second;
    return s;
  }

private:
  Vector_3d at(std::size_t triangle, const Vector_3d& p) const {
    const auto& c = corners_[triangle];
    const Vector_3d &a = of_boundary_.from(c[0]), &b = of_boundary_.from(c[1]), &d = of_boundary_.from(c[2]);
    const Vector_3d n = cross(b - a, d - a);
    const double area = squared_norm(n);
    if (!(area > 0))
      return of_boundary_.shift(c[0]);
    const double u = dot(cross(d - b, p - b), n) / area, v = dot(cross(a - d, p - d), n) / area;
    return u * of_boundary_.shift(c[0]) + v * of_boundary_.shift(c[1]) + (1 - u - v) * of_boundary_.shift(c[2]);
  }

  const Shift_holder& of_boundary_;
  std::vector<std::array<std::size_t, 3>> corners_; // of the wall's triangles
  Nearest_tree<Double_kernel::Triangle_3> tree_;
  std::map<std::uint32_t, Vector_3d> plane_of_; // of points in openings
};

inline Shift_holder shifts_of_all(const Mixed_mesh& mesh, const Boundary_surface& boundary,
                                  const Shift_holder& of_boundary, const Input_surface& input, Length_function radius,
                                  int threads) {
  const Inside_follower follower(boundary, of_boundary, input);
  std::vector<Vector_3d> from, shift(mesh.points.size());
  for (const Point_3& p : mesh.points)
    from.emplace_back(p);
  std::vector<char> is_on_wall(mesh.points.size(), 0);
  for (auto f : boundary.surface.faces())
    if (boundary.patch[f] == labels::wall)
      for (auto v : boundary.surface.vertices_around_face(boundary.surface.halfedge(f)))
        is_on_wall[boundary.point_of[std::size_t(v)]] = 1;
  const double reach = 0.5; // of the local radius
  for_each_range(mesh.points.size(), threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      if (!is_on_wall[i])
        shift[i] = follower.shift(std::uint32_t(i), from[i], reach * radius(mesh.points[i]));
  });
  for (std::size_t v = 0; v < of_boundary.size(); ++v)
    if (is_on_wall[boundary.point_of[v]])
      shift[boundary.point_of[v]] = of_boundary.shift(v);
  return Shift_holder(std::move(from), std::move(shift));
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PRESERVING_SHIFTS_OF_ALL_H
