// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_PARAMETERIZATION_RING_MAP_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_PARAMETERIZATION_RING_MAP_H

#include <CGAL/Tubular_meshing/Patches/internal/parameterization/Filled_patch.h>
#include <CGAL/Tubular_meshing/Patches/internal/parameterization/Laplace_system.h>
#include <CGAL/Tubular_meshing/Patches/internal/parameterization/edge_weights.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The conformal map of a filled patch without the triangles around its pole, an annulus, onto a ring: u + i v =
 * exp(h + i θ), where h is harmonic and constant on both loops, and θ, harmonic too, grows by 2π around them and is
 * free otherwise. If both are exact they are conjugate, and h reaches from −L at the inner loop to 0 at the outer one,
 * where 2π L = ∫|∇θ|², and 2π / L = ∫|∇h|² / L²; finite elements give an L too large and one too small.
 *
 * θ has several values on a seam, a way along edges from the inner loop to the outer one: on its left, it is less by 2π
 * than what is stored for the vertex. */
class Ring_map {
public:
  explicit Ring_map(const Filled_patch& patch)
      : patch_(patch)
      , inner_(patch.link(patch.pole))
      , is_inner_(patch.points.size(), 0)
      , around_pole_(patch.triangles.size(), 0)
      , turns_(patch.opposite.size(), 0) {
    for (int v : inner_)
      is_inner_[std::size_t(v)] = 1;
    for (const int* h = patch.outgoing.begin(patch.pole); h != patch.outgoing.end(patch.pole); ++h)
      around_pole_[std::size_t(triangle_of(*h))] = 1;
    weigh_edges();
  }

  // Whether it could be computed. Then uv() and angle() are there.
  bool compute() {
    mark_seam(find_seam());
    double energy_of_h, energy_of_angle;
    if (!solve_height(energy_of_h) || !solve_angle(energy_of_angle))
      return false;
    if (!(energy_of_h > 0) || !(energy_of_angle > 0))
      return false;
    height_of_ring_ = std::sqrt(energy_of_angle / energy_of_h); // the geometric mean of the two
    const double largest = 300;                                 // its exponential must have an inverse
    return height_of_ring_ < largest;
  }

  double angle(int v) const { return angle_(v, 0); }

  Eigen::Vector2d uv(int v) const {
    if (v == patch_.pole)
      return Eigen::Vector2d(0, 0);
    const double radius = std::exp(height_of_ring_ * height_(v, 0));
    return radius * Eigen::Vector2d(std::cos(angle(v)), std::sin(angle(v)));
  }

private:
  typedef Laplace_system::Columns Columns;

  void weigh_edges() {
    for (int h = 0; h < int(patch_.opposite.size()); ++h) {
      if (around_pole_[std::size_t(triangle_of(h))])
        continue;
      const double w = cotangent_at(patch_, previous_halfedge(h)) / 2;
      halfedges_.push_back(h);
      edges_.push_back({source_of(patch_.triangles, h), target_of(patch_.triangles, h), w, w});
    }
  }

  bool is_outside(int h) const { return h < 0 || around_pole_[std::size_t(triangle_of(h))]; }

  // The fewest edges from the inner loop to the outer one.
  std::vector<int> find_seam() const {
    std::vector<int> from(patch_.points.size(), -1), queue = inner_;
    for (int v : inner_)
      from[std::size_t(v)] = v;
    from[std::size_t(patch_.pole)] = patch_.pole;
    int last = -1;
    for (std::size_t i = 0; i < queue.size() && last < 0; ++i)
      if (patch_.is_outer[std::size_t(queue[i])])
        last = queue[i];
      else
        for (const int* h = patch_.outgoing.begin(queue[i]); h != patch_.outgoing.end(queue[i]); ++h) {
          const int w = target_of(patch_.triangles, *h);
          if (from[std::size_t(w)] >= 0)
            continue;
          from[std::size_t(w)] = queue[i];
          queue.push_back(w);
        }
    std::vector<int> seam(1, last);
    while (from[std::size_t(seam.back())] != seam.back())
      seam.push_back(from[std::size_t(seam.back())]);
    return std::vector<int>(seam.rbegin(), seam.rend());
  }

  // turns_ of the corners on the left of the seam.
  void mark_seam(const std::vector<int>& seam) {
    for (int h = patch_.halfedge_between(seam[0], seam[1]); !is_outside(h);
         h = patch_.opposite[std::size_t(previous_halfedge(h))])
      turns_[std::size_t(h)] = -1;
    for (std::size_t i = 1; i < seam.size(); ++i) {
      const int after = i + 1 < seam.size() ? seam[i + 1] : -1;
      for (int h = patch_.halfedge_between(seam[i - 1], seam[i]); !is_outside(h);) {
        const int out = next_halfedge(h);
        turns_[std::size_t(out)] = -1;
        h = target_of(patch_.triangles, out) == after ? -1 : patch_.opposite[std::size_t(out)];
      }
    }
  }

  // From −1 to 0.
  bool solve_height(double& energy) {
    const Eigen::Index n = Eigen::Index(patch_.points.size());
    std::vector<char> fixed = is_inner_;
    height_ = Columns::Zero(n, 1);
    for (int v : inner_)
      height_(v, 0) = -1;
    for (std::size_t i = 0; i < fixed.size(); ++i)
      fixed[i] = fixed[i] || patch_.is_outer[i] || int(i) == patch_.pole;
    if (!Laplace_system(edges_, fixed).solve(Columns::Zero(n, 1), height_))
      return false;
    energy = 0;
    for (const Weighted_edge& e : edges_)
      energy += e.of_a * std::pow(height_(e.b, 0) - height_(e.a, 0), 2);
    return true;
  }

  double jump(int h) const { return 2 * CGAL_PI * (turns_[std::size_t(next_halfedge(h))] - turns_[std::size_t(h)]); }

  bool solve_angle(double& energy) {
    const Eigen::Index n = Eigen::Index(patch_.points.size());
    std::vector<char> fixed(patch_.points.size(), 0);
    fixed[std::size_t(patch_.pole)] = fixed[std::size_t(inner_[0])] = 1;
    Columns b = Columns::Zero(n, 1);
    angle_ = Columns::Zero(n, 1);
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const double pull = edges_[i].of_a * jump(halfedges_[i]);
      b(edges_[i].a, 0) += pull;
      b(edges_[i].b, 0) -= pull;
    }
    if (!Laplace_system(edges_, fixed).solve(b, angle_))
      return false;
    energy = 0;
    for (std::size_t i = 0; i < edges_.size(); ++i)
      energy += edges_[i].of_a * std::pow(angle_(edges_[i].b, 0) - angle_(edges_[i].a, 0) + jump(halfedges_[i]), 2);
    return true;
  }

  const Filled_patch& patch_;
  const std::vector<int> inner_;
  std::vector<char> is_inner_, around_pole_;
  std::vector<signed char> turns_;   // of θ at each corner, beside what is stored for its vertex
  std::vector<int> halfedges_;       // off the pole,
  std::vector<Weighted_edge> edges_; // each with what its own triangle gives
  Columns height_, angle_;
  double height_of_ring_ = 0; // L
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_PARAMETERIZATION_RING_MAP_H
