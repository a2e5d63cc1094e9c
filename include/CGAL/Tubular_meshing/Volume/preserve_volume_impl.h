// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_PRESERVE_VOLUME_IMPL_H
#define CGAL_TUBULAR_MESHING_VOLUME_PRESERVE_VOLUME_IMPL_H

#include <CGAL/Tubular_meshing/Patches/pieces/crossing_faces.h>
#include <CGAL/Tubular_meshing/Volume/internal/preserving/Input_surface.h>
#include <CGAL/Tubular_meshing/Volume/internal/preserving/Shift_holder.h>
#include <CGAL/Tubular_meshing/Volume/internal/preserving/Wall_shifter.h>
#include <CGAL/Tubular_meshing/Volume/preserve_volume.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

inline std::map<int, double> opening_areas(const Surface& surface, Face_patch_map patch) {
  std::map<int, Vector_3d> areas;
  for (auto f : surface.faces())
    if (patch[f] != labels::wall) {
      const auto h = surface.halfedge(f);
      const Vector_3d origin(surface.point(surface.target(h)));
      for (auto g : surface.halfedges_around_face(h))
        areas[patch[f]] += 0.5 * cross(Vector_3d(surface.point(surface.source(g))) - origin,
                                       Vector_3d(surface.point(surface.target(g))) - origin);
    }
  std::map<int, double> result;
  for (const auto& a : areas)
    result[a.first] = norm(a.second);
  return result;
}

inline Shift_holder wanted_shifts(const Surface& mesh, Face_patch_map patch, const Input_surface& input, int threads) {
  const std::vector<Vector_3d> to = Wall_shifter(mesh, patch, input, threads).run();
  std::vector<Vector_3d> from, shift;
  for (auto v : mesh.vertices()) {
    from.emplace_back(mesh.point(v));
    shift.push_back(to[std::size_t(v)] - from.back());
  }
  return Shift_holder(std::move(from), std::move(shift));
}

// Each of them once, however often it is named.
inline void hold_back(std::vector<std::size_t> points, Shift_holder& shifts) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  for (std::size_t i : points)
    shifts.hold_back(i);
}

/* Triangles keep a fair shape, or most of what they had of it: one that has to move far for its size, as at the foot of a
 * branch, would lose it. Ends, as what is held back goes to where it was. */
inline void keep_shapes(const Surface& mesh, Shift_holder& shifts) {
  const double fair = 0.55, kept = 0.8; // γ_T, and the part of it that a triangle keeps in any case
  std::vector<std::array<std::size_t, 3>> triangles;
  for (auto f : mesh.faces())
    if (mesh.degree(f) == 3) {
      const auto h = mesh.halfedge(f);
      triangles.push_back(
          {{std::size_t(mesh.source(h)), std::size_t(mesh.target(h)), std::size_t(mesh.target(mesh.next(h)))}});
    }
  for (;;) {
    std::vector<std::size_t> at_fault;
    for (const auto& t : triangles) {
      const double gamma = triangle_gamma(shifts[t[0]], shifts[t[1]], shifts[t[2]]);
      if (gamma < fair && gamma < kept * triangle_gamma(shifts.from(t[0]), shifts.from(t[1]), shifts.from(t[2])))
        at_fault.insert(at_fault.end(), t.begin(), t.end());
    }
    if (at_fault.empty())
      return;
    hold_back(std::move(at_fault), shifts);
  }
}

// Moves a surface; where it would meet itself, less.
inline void move_without_crossings(Surface& mesh, Shift_holder& shifts) {
  keep_shapes(mesh, shifts);
  for (int round = 0; round < 12; ++round) {
    for (auto v : mesh.vertices())
      mesh.point(v) = shifts.point(std::size_t(v));
    std::vector<std::size_t> at_fault;
    for (const auto& c : crossing_faces(mesh))
      for (auto f : {c.first, c.second})
        for (auto v : mesh.vertices_around_face(mesh.halfedge(f)))
          at_fault.push_back(std::size_t(v));
    if (at_fault.empty())
      return;
    hold_back(std::move(at_fault), shifts);
  }
  shifts.hold_all_back();
  for (auto v : mesh.vertices())
    mesh.point(v) = shifts.point(std::size_t(v));
}

inline void describe(const Surface& mesh, Face_patch_map patch, const Shift_holder& shifts,
                     Preserve_volume_report& report) {
  report.volume = enclosed_volume(mesh);
  report.area = opening_areas(mesh, patch);
  report.largest_shift = shifts.largest();
  report.held_back = shifts.number_held_back();
}

CGAL_TUBULAR_MESHING_INLINE Preserve_volume_report preserve_volume(Surface& mesh, Face_patch_map mesh_patch,
                                                                   const Surface& input, Face_patch_map input_patch,
                                                                   const Preserve_volume_options& options) {
  const Input_surface truth(input, input_patch);
  Preserve_volume_report report;
  report.input_volume = truth.volume();
  report.volume_before = enclosed_volume(mesh);
  Shift_holder shifts = wanted_shifts(mesh, mesh_patch, truth, options.number_of_threads);
  move_without_crossings(mesh, shifts);
  describe(mesh, mesh_patch, shifts, report);
  return report;
}

/* The boundary of a mesh as a surface of its own. */
struct Boundary_surface : Labelled_surface {
  std::vector<std::uint32_t> point_of; // the mesh's point of each vertex

  explicit Boundary_surface(const Mixed_mesh& mesh) {
    std::vector<Surface::Vertex_index> vertex_of(mesh.points.size(), Surface::null_vertex());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      std::array<Surface::Vertex_index, 3> t;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t p = mesh.triangles.vertices[i][k];
        if (vertex_of[p] == Surface::null_vertex()) {
          vertex_of[p] = surface.add_vertex(mesh.points[p]);
          point_of.push_back(p);
        }
        t[k] = vertex_of[p];
      }
      const auto f = surface.add_face(t[0], t[1], t[2]);
      if (f == Surface::null_face())
        throw Meshing_error("The boundary of the mesh is no surface: its volume cannot be matched to the input's.");
      patch[f] = mesh.triangles.label[i];
    }
  }
};

/* How the points inside of a mesh follow those of its wall. */
class Inside_follower {
public:
  Inside_follower(const Boundary_surface& boundary, const Shift_holder& of_boundary, const Input_surface& input)
      : of_boundary_(of_boundary) {
    std::vector<Double_kernel::Triangle_3> triangles;
    for (auto f : boundary.surface.faces()) {
      std::array<std::size_t, 3> c;
      std::size_t k = 0;
      for (auto v : boundary.surface.vertices_around_face(boundary.surface.halfedge(f)))
        c[k++] = std::size_t(v);
      if (boundary.patch[f] == labels::wall) {
        corners_.push_back(c);
        const auto point = [&](std::size_t v) {
          const Vector_3d& p = of_boundary.from(v);
          return Double_kernel::Point_3(p.x, p.y, p.z);
        };
        triangles.emplace_back(point(c[0]), point(c[1]), point(c[2]));
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

// Tetrahedra keep a fair part of their volume: those at fault hold their corners back, and then those around. If that
// comes to no end nothing moves at all.
inline void keep_tetrahedra(const Mixed_mesh& mesh, Shift_holder& shifts) {
  const double least = 0.3; // of the volume
  for (int round = 0; round < 12; ++round) {
    std::vector<std::size_t> at_fault;
    for (const auto& t : mesh.tetrahedra.vertices) {
      const double before = signed_volume(shifts.from(t[0]), shifts.from(t[1]), shifts.from(t[2]), shifts.from(t[3]));
      if (!(signed_volume(shifts[t[0]], shifts[t[1]], shifts[t[2]], shifts[t[3]]) > least * before))
        at_fault.insert(at_fault.end(), t.begin(), t.end());
    }
    if (at_fault.empty())
      return;
    hold_back(std::move(at_fault), shifts);
  }
  shifts.hold_all_back();
}

CGAL_TUBULAR_MESHING_INLINE Preserve_volume_report preserve_volume(Mixed_mesh& mesh, const Surface& input,
                                                                   Face_patch_map input_patch, Length_function radius,
                                                                   const Preserve_volume_options& options) {
  const Input_surface truth(input, input_patch);
  Boundary_surface boundary(mesh);
  Preserve_volume_report report;
  report.input_volume = truth.volume();
  report.volume_before = enclosed_volume(boundary.surface);
  Shift_holder of_boundary = wanted_shifts(boundary.surface, boundary.patch, truth, options.number_of_threads);
  move_without_crossings(boundary.surface, of_boundary);
  Shift_holder shifts = shifts_of_all(mesh, boundary, of_boundary, truth, radius, options.number_of_threads);
  keep_tetrahedra(mesh, shifts);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    mesh.points[i] = shifts.point(i);
  for (auto v : boundary.surface.vertices())
    boundary.surface.point(v) = mesh.points[boundary.point_of[std::size_t(v)]];
  describe(boundary.surface, boundary.patch, shifts, report);
  report.held_back += of_boundary.number_held_back();
  return report;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_PRESERVE_VOLUME_IMPL_H
