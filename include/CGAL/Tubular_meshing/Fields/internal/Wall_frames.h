// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_WALL_FRAMES_H
#define CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_WALL_FRAMES_H

#include <CGAL/Tubular_meshing/Fields/internal/Indexed_wall.h>
#include <CGAL/Tubular_meshing/Fields/internal/Wall_frame.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Corner_tree.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The frames of all points of the wall: computed at its vertices, interpolated in its triangles. */
class Wall_frames {
public:
  /* `radius(v)`: the local radius at a vertex; `direction(v)`: the unit vector e_t there; both safe to call from
   * several threads. Curvatures are averaged within `smoothing` radii, directions within half a radius. O(n). */
  Wall_frames(Indexed_wall wall, Function_view<double(Indexed_wall::Index)> radius,
              Function_view<Vector_3d(Indexed_wall::Index)> direction, double smoothing, int threads)
      : wall_(std::move(wall))
      , tree_(wall_.make_tree())
      , threads_(threads) {
    const std::size_t n = wall_.number_of_vertices();
    std::vector<double> r(n), reach(n);
    std::vector<Vector_3d> e_t(n);
    for_each_vertex([&](Indexed_wall::Index v, Wall_neighborhood&) {
      r[v] = radius(v);
      reach[v] = smoothing * r[v];
      e_t[v] = direction(v);
    });
    const Wall_frame_measurer measurer(wall_, std::move(reach), threads);
    frames_.resize(n);
    for_each_vertex([&](Indexed_wall::Index v, Wall_neighborhood& near) {
      frames_[v] = measurer.measured(v, mean_direction(e_t, near, v, 0.5 * r[v]), near);
    });
  }

  const Corner_tree<Double_kernel::Triangle_3>& tree() const { return tree_; }

  /* At a point of a triangle, both as the tree has found them. */
  Wall_frame at(std::size_t triangle, const Double_kernel::Point_3& p) const {
    const auto& t = wall_.triangles()[triangle];
    const std::array<double, 3> b = barycentric(t, Vector_3d(p));
    Wall_frame f;
    f.normal = Vector_3d(0, 0, 0);
    f.along = Direction_tensor(0, 0, 0, 0, 0, 0);
    for (int i = 0; i < 3; ++i) {
      const Wall_frame& g = frames_[t[i]];
      f.normal += b[i] * g.normal;
      f.along += b[i] * g.along;
      f.bend_along += b[i] * g.bend_along;
      f.bend_across += b[i] * g.bend_across;
      f.curvature_along += b[i] * g.curvature_along;
      f.curvature_across += b[i] * g.curvature_across;
    }
    f.normal = squared_norm(f.normal) > 0 ? normalized(f.normal) : frames_[t[0]].normal;
    f.along = tangential(f.along, f.normal);
    return f;
  }

private:
  template <class Body> void for_each_vertex(const Body& body) const {
    for_each_range(wall_.number_of_vertices(), threads_, [&](std::size_t first, std::size_t last) {
      Wall_neighborhood near(wall_);
      for (std::size_t v = first; v < last; ++v)
        body(Indexed_wall::Index(v), near);
    });
  }

  static Direction_tensor mean_direction(const std::vector<Vector_3d>& e_t, Wall_neighborhood& near,
                                         Indexed_wall::Index v, double r) {
    Direction_tensor sum(0, 0, 0, 0, 0, 0);
    double total = 0;
    near.for_each(v, r, [&](Indexed_wall::Index w, double weight) {
      sum += weight * Direction_tensor::dyad(e_t[w]);
      total += weight;
    });
    return (1 / total) * sum;
  }

  std::array<double, 3> barycentric(const std::array<Indexed_wall::Index, 3>& t, const Vector_3d& p) const {
    const Vector_3d n = wall_.doubled_area(t);
    const double n2 = squared_norm(n);
    std::array<double, 3> b;
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      const Vector_3d &q = wall_.point(t[(i + 1) % 3]), &r = wall_.point(t[(i + 2) % 3]);
      b[i] = (std::min)((std::max)(dot(cross(q - p, r - p), n) / n2, 0.), 1.);
      sum += b[i];
    }
    for (double& x : b)
      x = sum > 0 ? x / sum : 1. / 3;
    return b;
  }

  Indexed_wall wall_;
  Corner_tree<Double_kernel::Triangle_3> tree_;
  int threads_;
  std::vector<Wall_frame> frames_; // one a vertex
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_WALL_FRAMES_H
