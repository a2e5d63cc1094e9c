// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_PARAMETERIZATION_PATCH_MAPPER_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_PARAMETERIZATION_PATCH_MAPPER_H

#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/Patches/internal/parameterization/Filled_patch.h>
#include <CGAL/Tubular_meshing/Patches/internal/parameterization/Laplace_system.h>
#include <CGAL/Tubular_meshing/Patches/internal/parameterization/Ring_map.h>
#include <CGAL/Tubular_meshing/Patches/internal/parameterization/check_bijection.h>
#include <CGAL/Tubular_meshing/Patches/internal/parameterization/edge_weights.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Maps a filled patch into the unit circle, by the first method of which a bijection comes. */
class Patch_mapper {
public:
  explicit Patch_mapper(const Filled_patch& patch)
      : patch_(patch)
      , uv_(patch.points.size(), Eigen::Vector2d::Zero()) {}

  // First step. Whether there is a map; it may be no bijection.
  bool map_conformally() { return is_mapped_ = find_conformal_map(); }

  // For each halfedge of the patch whether it is too long for a linear map to be near the conformal one: on the ring it
  // reaches further than an eighth of the way around, or as far inwards; or sizes differ by more than a factor of two
  // from one end to the other, as on a blind vessel; but not where all is too small for a conformal map in floating
  // point arithmetic. Empty if none is.
  std::vector<char> wide_halfedges() const {
    std::vector<char> is_wide;
    if (!is_mapped_)
      return is_wide;
    const double most_growth = std::log(2.), smallest = std::log(1e-8);
    const std::vector<double> scale = logarithms_of_scales();
    const double least = *std::max_element(scale.begin(), scale.end()) + smallest;
    const auto growth = [&](int h) {
      const double a = scale[std::size_t(source_of(patch_.triangles, h))];
      const double b = scale[std::size_t(target_of(patch_.triangles, h))];
      return (std::min)(a, b) < least ? 0 : std::abs(a - b);
    };
    for (int h = 0; h < int(3 * patch_.own_triangles); ++h)
      if ((patch_.loops.size() > 1 && length_on_ring(h) > CGAL_PI / 4) || growth(h) > most_growth) {
        is_wide.resize(3 * patch_.own_triangles, 0);
        is_wide[std::size_t(h)] = 1;
      }
    return is_wide;
  }

  // Second step. Returns the method, `first` or a later one; uv() and number_of_flips() are there then.
  Parameterization_method make_bijective(Parameterization_method first) {
    typedef Parameterization_method Method;
    const std::vector<int> flipped = is_mapped_ ? flipped_triangles(patch_, uv_) : std::vector<int>();
    flips_ = is_mapped_ ? flipped.size() : patch_.own_triangles;
    if (is_mapped_ && first <= Method::conformal && flips_ == 0 && are_loops_simple(patch_, uv_))
      return Method::conformal;
    if (is_mapped_ && first <= Method::conformal_repaired && is_outer_loop_in_order() && repair(flipped))
      return Method::conformal_repaired;
    put_on_circle(true);
    if (first <= Method::harmonic && map_inside(Edge_weights::clamped_cotangent))
      return Method::harmonic;
    put_on_circle(false);
    if (first <= Method::mean_value && map_inside(Edge_weights::mean_value))
      return Method::mean_value;
    if (first <= Method::uniform && map_inside(Edge_weights::uniform))
      return Method::uniform;
    for (double shortening : {4., 16., 64., 256.})
      if (map_inside(Edge_weights::shortened, shortening))
        return Method::shortened;
    throw Meshing_error("A patch of " + std::to_string(patch_.own_triangles) + " triangles near " +
                        place_of(patch_.points[0]) +
                        " could not be mapped onto the plane; it may be too long: cut it further, by a smaller aspect "
                        "ratio.");
  }

  const Plane_points& uv() const { return uv_; }
  std::size_t number_of_flips() const { return flips_; }

private:
  typedef Laplace_system::Columns Columns;

  // An annulus or a junction onto a ring; a disk by the ring's angles on its border.
  bool find_conformal_map() {
    if (patch_.pole >= 0) {
      Ring_map ring(patch_);
      if (!ring.compute())
        return false;
      for (std::size_t v = 0; v < uv_.size(); ++v)
        uv_[v] = ring.uv(int(v));
      for (int v : patch_.outer_loop())
        angles_.push_back(ring.angle(v));
    }
    if (patch_.loops.size() > 1)
      return true;
    put_on_circle(true);
    return place_free_vertices(Edge_weights::cotangent, patch_.is_outer);
  }

  // Of the patch's vertices: what the map multiplies lengths by, from the areas around.
  std::vector<double> logarithms_of_scales() const {
    std::vector<double> in_plane(uv_.size(), 0), in_space(uv_.size(), 0), scale(uv_.size(), 0);
    for (std::size_t t = 0; t < patch_.own_triangles; ++t) {
      const Patch_triangle& c = patch_.triangles[t];
      const Eigen::Vector2d &a = uv_[std::size_t(c[0])], &b = uv_[std::size_t(c[1])], &d = uv_[std::size_t(c[2])];
      const Vector_3d &p = patch_.points[std::size_t(c[0])], &q = patch_.points[std::size_t(c[1])],
                      &r = patch_.points[std::size_t(c[2])];
      for (int v : c) {
        in_plane[std::size_t(v)] += std::abs(plane_cross_product(b - a, d - a));
        in_space[std::size_t(v)] += norm(cross(q - p, r - p));
      }
    }
    for (std::size_t v = 0; v < scale.size(); ++v)
      if (in_plane[v] > 0 && in_space[v] > 0)
        scale[v] = 0.5 * std::log(in_plane[v] / in_space[v]);
    return scale;
  }

  // In the plane of the logarithm.
  double length_on_ring(int h) const {
    const auto ends = std::minmax({source_of(patch_.triangles, h), target_of(patch_.triangles, h)}); // same both ways
    const Eigen::Vector2d &a = uv_[std::size_t(ends.first)], &b = uv_[std::size_t(ends.second)];
    const double angle = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    return std::hypot(angle, std::log(b.norm() / a.norm()));
  }

  // The outer loop, by the ring's angles, if there are some and they ascend, else by its lengths.
  void put_on_circle(bool by_ring) {
    const std::vector<int>& loop = patch_.outer_loop();
    const std::vector<double> angle = by_ring && do_angles_ascend() ? angles_ : angles_by_length();
    for (std::size_t i = 0; i < loop.size(); ++i)
      uv_[std::size_t(loop[i])] = Eigen::Vector2d(std::cos(angle[i]), std::sin(angle[i]));
  }

  // By a millionth of their mean at least, and once around.
  bool do_angles_ascend() const {
    const double least = 1e-6 * 2 * CGAL_PI / double(angles_.size() + 1);
    double sum = 0;
    for (std::size_t i = 0; i < angles_.size(); ++i) {
      const double step = angles_[(i + 1) % angles_.size()] - angles_[i];
      const double in_turn = step - 2 * CGAL_PI * std::floor(step / (2 * CGAL_PI));
      if (!(in_turn > least))
        return false;
      sum += in_turn;
    }
    return !angles_.empty() && sum < 3 * CGAL_PI;
  }

  std::vector<double> angles_by_length() const {
    const std::vector<int>& loop = patch_.outer_loop();
    const double total = patch_.length(loop);
    const double least = 1e-6 * (total > 0 ? total : 1) / double(loop.size());
    std::vector<double> angle(1, 0.);
    for (std::size_t i = 0; i < loop.size(); ++i)
      angle.push_back(angle.back() + (std::max)(patch_.length(loop[i], loop[(i + 1) % loop.size()]), least));
    const double turn = 2 * CGAL_PI / angle.back();
    angle.pop_back();
    for (double& a : angle)
      a *= turn;
    return angle;
  }

  // Each free vertex into the weighted mean of its neighbours.
  bool place_free_vertices(Edge_weights kind, const std::vector<char>& is_fixed, double shortening = 1) {
    Columns x(Eigen::Index(uv_.size()), 2);
    for (std::size_t v = 0; v < uv_.size(); ++v)
      x.row(Eigen::Index(v)) = uv_[v].transpose();
    const std::vector<Weighted_edge> edges = edge_weights(patch_, kind, shortening);
    if (!Laplace_system(edges, is_fixed).solve(Columns::Zero(x.rows(), 2), x))
      return false;
    for (std::size_t v = 0; v < uv_.size(); ++v)
      uv_[v] = x.row(Eigen::Index(v)).transpose();
    return true;
  }

  bool map_inside(Edge_weights kind, double shortening = 1) {
    return place_free_vertices(kind, patch_.is_outer, shortening) && is_bijective(patch_, uv_);
  }

  // Keeps the conformal map but near the triangles that are flipped: there vertices go into means of their neighbours.
  bool repair(std::vector<int> flipped) {
    const Plane_points first = uv_;
    std::vector<char> is_fixed(uv_.size(), 1);
    for (int pass = 0; pass < 6; ++pass) {
      for (int t : flipped)
        for (int v : patch_.triangles[std::size_t(t)])
          is_fixed[std::size_t(v)] = patch_.is_outer[std::size_t(v)];
      release_neighbours(is_fixed);
      uv_ = first;
      if (!place_free_vertices(Edge_weights::mean_value, is_fixed))
        break;
      flipped = flipped_triangles(patch_, uv_);
      if (flipped.empty() && are_loops_simple(patch_, uv_))
        return true;
    }
    uv_ = first;
    return false;
  }

  void release_neighbours(std::vector<char>& is_fixed) const {
    const std::vector<char> before = is_fixed;
    for (const Patch_triangle& t : patch_.triangles) {
      bool touches = false;
      for (int v : t)
        touches = touches || !before[std::size_t(v)];
      for (int v : t)
        if (touches && !patch_.is_outer[std::size_t(v)])
          is_fixed[std::size_t(v)] = 0;
    }
  }

  // Repairing leaves the outer loop as it is, which must therefore be good.
  bool is_outer_loop_in_order() const { return patch_.loops.size() == 1 || do_angles_ascend(); }

  const Filled_patch& patch_;
  Plane_points uv_;
  std::vector<double> angles_; // of the outer loop, on the ring
  std::size_t flips_ = 0;
  bool is_mapped_ = false;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_PARAMETERIZATION_PATCH_MAPPER_H
