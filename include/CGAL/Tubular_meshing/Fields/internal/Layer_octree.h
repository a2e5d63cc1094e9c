// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_LAYER_OCTREE_H
#define CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_LAYER_OCTREE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Fields/internal/Corner_octree.h>
#include <CGAL/Tubular_meshing/Fields/internal/Wall_frames.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* All that varies slowly in a boundary layer, continuous in space: the directions and curvatures of the nearest wall,
 * and the local radius. What is taken from the nearest point of the wall jumps where another part of it becomes the
 * nearest; interpolated between the corners of an octree it does not. A tensor that interpolates directions need not be
 * a dyad: where it is not, sizes are blended in the logarithmic sense. */
class Layer_octree {
public:
  struct State {
    Direction_tensor across_wall; // n nᵀ, or a mean of such
    Direction_tensor along;       // the same of the centerline's direction in the tangent plane
    double bend_along, bend_across, curvature_along, curvature_across;
    double radius, distance; // the distance to the wall: exact at corners, good where the wall is far
    std::uint32_t near_face; // of the wall: the one nearest to a corner nearby
  };

  Layer_octree() = default;

  /* `radius`: the local radius, safe to call from several threads. */
  Layer_octree(const Wall_frames& wall, Length_function radius, int threads) {
    const auto need = [&](const Corner_octree::Position& x, double) {
      const Double_kernel::Point_3 p(x[0], x[1], x[2]);
      const auto found = wall.tree().nearest(p);
      const double r = radius(Point_3(x[0], x[1], x[2])), d = std::sqrt(found.squared_distance);
      const bool outside = dot(Vector_3d(p) - Vector_3d(found.point), wall.at(found.index, found.point).normal) > 0;
      // beyond an opening the wall's normal does not tell; but no point of the lumen is further away than its radius
      return Corner_octree::Need{(std::max)(outside ? d : 0, d - r),
                                 (std::min)((std::max)(leaf_at_wall * r, d), leaf_inside * r)};
    };
    tree_ = Corner_octree(wall.tree().bbox(), need, threads);
    values_.resize(tree_.number_of_corners());
    near_face_.resize(tree_.number_of_corners());
    tree_.for_each_corner(
        [&](std::size_t i, const Corner_octree::Position& x) {
          values_[i] =
              sample(wall, radius(Point_3(x[0], x[1], x[2])), Double_kernel::Point_3(x[0], x[1], x[2]), near_face_[i]);
        },
        threads);
    tree_.for_each_hanging_corner(
        [&](std::uint32_t corner, const Corner_octree::Place& place) { values_[corner] = interpolate(place); });
    tree_.release_corners();
  }

  State operator()(double x, double y, double z) const {
    const Corner_octree::Place place = tree_.locate(x, y, z);
    const Values v = interpolate(place);
    State s = {{v[0], v[1], v[2], v[3], v[4], 1 - v[0] - v[3]},
               {v[5], v[6], v[7], v[8], v[9], 1 - v[5] - v[8]},
               v[10],
               v[11],
               v[12],
               v[13],
               v[14],
               v[15],
               near_face_[place.corners[(place.t[0] > 0.5) + 2 * (place.t[1] > 0.5) + 4 * (place.t[2] > 0.5)]]};
    sharpen(s);
    return s;
  }

  std::size_t number_of_leaves() const { return tree_.number_of_leaves(); }
  std::size_t number_of_corners() const { return values_.size(); }

private:
  /* In local radii, the distance over which directions blend; sharpen() undoes most of what interpolation blurs within
   * it. At the wall elements are twenty times as long as high: where the normal is off by three degrees their height is
   * off by its like. */
  static constexpr double leaf_at_wall = 0.2, leaf_inside = 0.45;

  // Of each tensor five entries, for the traces are one; floats, so that a corner is one line of the cache.
  typedef std::array<float, 16> Values;

  /* Where directions turn by a few degrees within a leaf, as round a tube, their mean is no dyad any more: eigenvalues
   * of 0.95 and 0.05, say. McWeeny's polynomial 3 N² - 2 N³ brings them back to 0.993 and 0.007, and leaves those of an
   * even mixture, where there is no direction, as they are. With X = I - N, the new T = X T X keeps the three shares,
   * that of the third direction X - T included, positive semidefinite of sum I. */
  static void sharpen(State& s) {
    const Direction_tensor one, n = s.across_wall, n2 = product(n, n), n3 = product(n2, n);
    s.across_wall = 3 * n2 - 2 * n3;
    const Direction_tensor x = one - s.across_wall;
    const Direction_tensor& t = s.along;
    const Vector_3d r0(x.xx, x.xy, x.xz), r1(x.xy, x.yy, x.yz), r2(x.xz, x.yz, x.zz);
    s.along =
        Direction_tensor(t.dot(r0, r0), t.dot(r0, r1), t.dot(r0, r2), t.dot(r1, r1), t.dot(r1, r2), t.dot(r2, r2));
  }

  // Of tensors that commute.
  static Direction_tensor product(const Direction_tensor& a, const Direction_tensor& b) {
    return {a.xx * b.xx + a.xy * b.xy + a.xz * b.xz, a.xx * b.xy + a.xy * b.yy + a.xz * b.yz,
            a.xx * b.xz + a.xy * b.yz + a.xz * b.zz, a.xy * b.xy + a.yy * b.yy + a.yz * b.yz,
            a.xy * b.xz + a.yy * b.yz + a.yz * b.zz, a.xz * b.xz + a.yz * b.yz + a.zz * b.zz};
  }

  static Values sample(const Wall_frames& wall, double radius, const Double_kernel::Point_3& p,
                       std::uint32_t& near_face) {
    const auto found = wall.tree().nearest(p);
    near_face = std::uint32_t(found.index);
    const Wall_frame f = wall.at(found.index, found.point);
    const Direction_tensor n = Direction_tensor::dyad(f.normal);
    const auto as_float = [](double x) { return float(x); };
    return {as_float(n.xx),
            as_float(n.xy),
            as_float(n.xz),
            as_float(n.yy),
            as_float(n.yz),
            as_float(f.along.xx),
            as_float(f.along.xy),
            as_float(f.along.xz),
            as_float(f.along.yy),
            as_float(f.along.yz),
            as_float(f.bend_along),
            as_float(f.bend_across),
            as_float(f.curvature_along),
            as_float(f.curvature_across),
            as_float(radius),
            as_float(std::sqrt(found.squared_distance))};
  }

  Values interpolate(const Corner_octree::Place& place) const {
    Values result = {};
    for (int c = 0; c < 8; ++c) {
      const float w = float(place.weight(c));
      const Values& v = values_[place.corners[c]];
      for (std::size_t k = 0; k < v.size(); ++k)
        result[k] += w * v[k];
    }
    return result;
  }

  Corner_octree tree_;
  std::vector<Values> values_; // one a corner
  std::vector<std::uint32_t> near_face_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_LAYER_OCTREE_H
