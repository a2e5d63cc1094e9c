// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_QUAD_SMOOTHER_H
#define CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_QUAD_SMOOTHER_H

#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Quad_patch.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Sheet.h>
#include <CGAL/Tubular_meshing/base/Plane_frame.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Moves vertices on the sheet.
 *
 * relax() makes Σ ((|a|² + |b|²) / 2 J)² least over all corners, a and b the sides there and J = a × b about the
 * surface's normal: 1 for a square, without bound as an angle comes near 0 or π. So no quad turns over that did not
 * before; where some do, J is made (J + √(J² + ε²)) / 2 first, with ε of their size, which turns them back.
 *
 * raise_worst() makes the worst quads better: Σ (1 − quality)^p about each vertex, with a large p. */
class Quad_smoother {
public:
  Quad_smoother(Quad_patch& mesh, const Sheet& sheet)
      : mesh_(mesh)
      , sheet_(sheet) {}

  std::vector<int> inner_vertices() const {
    std::vector<int> result;
    for (int v = int(mesh_.on_loops); v < int(mesh_.places.size()); ++v)
      if (mesh_.valence(v) > 0)
        result.push_back(v);
    return result;
  }

  void relax(const std::vector<int>& vertices, int most_sweeps) {
    const double small = 0.01;
    for (int k = 0; k < most_sweeps; ++k) {
      double greatest = 0;
      for (int v : vertices)
        if (!mesh_.is_fixed(v))
          greatest = (std::max)(greatest, relax(v));
      if (greatest < small)
        break;
    }
  }

  /* Of the vertices, those of quads that are worse than `quality`. */
  void raise_worst(const std::vector<int>& vertices, double quality, int rounds) {
    for (int round = 0; round < rounds; ++round) {
      bool moved = false;
      for (int v : vertices)
        if (!mesh_.is_fixed(v) && worst_at(v) < quality)
          moved = search(v) || moved;
      if (!moved)
        break;
    }
  }

  double worst_at(int v) const {
    double least = 1;
    for (int q : mesh_.quads_at(v))
      least = (std::min)(least, mesh_.quality(q));
    return least;
  }

private:
  struct Energy {
    double value = 0;
    Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
    Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
  };
  enum Role { is_corner, is_after, is_before };

  const Sheet_place& place(int v) const { return mesh_.places[std::size_t(v)]; }

  // The share of corner k of a quad, as a function of the vertex with the given role.
  void add_corner(int q, std::size_t k, Role role, const Plane_frame& along, double epsilon, Energy& e) const {
    const auto t = [&](const Vector_3d& v) { return Eigen::Vector2d(dot(v, along.u), dot(v, along.v)); };
    const Quad_patch::Quad& c = mesh_.quad(q);
    const Sheet_place& at = place(c[k]);
    const Vector_3d a = place(c[(k + 1) % 4]).point - at.point, b = place(c[(k + 3) % 4]).point - at.point;
    const double j = dot(at.normal, cross(a, b)), root = std::hypot(j, epsilon), chi = (j + root) / 2;
    if (!(chi > 0)) {
      e.value = std::numeric_limits<double>::infinity();
      return;
    }
    const double chi1 = root > 0 ? (1 + j / root) / 2 : 1;
    const double chi2 = root > 0 ? epsilon * epsilon / (2 * root * root * root) : 0;
    const double f = (squared_norm(a) + squared_norm(b)) / (2 * chi);
    const Eigen::Vector2d dj = t(role == is_corner  ? cross(at.normal, b - a)
                                 : role == is_after ? cross(b, at.normal)
                                                    : cross(at.normal, a));
    const Eigen::Vector2d half_ds = t(role == is_corner ? -1 * (a + b) : role == is_after ? a : b);
    const Eigen::Vector2d g = (half_ds - f * chi1 * dj) / chi;
    const Eigen::Matrix2d mixed = chi1 * g * dj.transpose();
    const Eigen::Matrix2d h = ((role == is_corner ? 2 : 1) * Eigen::Matrix2d::Identity() -
                               f * chi2 * dj * dj.transpose() - mixed - mixed.transpose()) /
                              chi;
    e.value += f * f;
    e.gradient += 2 * f * g;
    e.hessian += 2 * (g * g.transpose() + f * h);
  }

  Energy energy(int v, double epsilon) const {
    Energy e;
    const Plane_frame along(place(v).point, place(v).normal);
    for (int q : mesh_.quads_at(v)) {
      const std::size_t k = mesh_.corner(q, v);
      add_corner(q, k, is_corner, along, epsilon, e);
      add_corner(q, (k + 3) % 4, is_after, along, epsilon, e);
      add_corner(q, (k + 1) % 4, is_before, along, epsilon, e);
    }
    return e;
  }

  // Of the sides at a vertex: the mean of the squared lengths; and the least J.
  void measure(int v, double& squared_size, double& least) const {
    double sum = 0;
    least = (std::numeric_limits<double>::max)();
    for (int q : mesh_.quads_at(v)) {
      sum += squared_norm(mesh_.point(mesh_.after(q, v)) - mesh_.point(v));
      for (std::size_t k = 0; k < 4; ++k) {
        const Quad_patch::Quad& c = mesh_.quad(q);
        const Sheet_place& at = place(c[k]);
        least = (std::min)(least, dot(at.normal, cross(place(c[(k + 1) % 4]).point - at.point,
                                                       place(c[(k + 3) % 4]).point - at.point)));
      }
    }
    squared_size = sum / double(mesh_.valence(v));
  }

  // A step of Newton's method, or less. Returns the move relative to the size.
  double relax(int v) {
    const int most_halvings = 6;
    double squared_size, least;
    measure(v, squared_size, least);
    if (!(squared_size > 0))
      return 0;
    const double epsilon = least > 1e-3 * squared_size ? 0 : 0.1 * squared_size - least;
    const Energy before = energy(v, epsilon);
    if (!std::isfinite(before.value))
      return 0;
    const double trace = before.hessian.trace(), size = std::sqrt(squared_size);
    Eigen::Vector2d step = before.hessian.determinant() > 1e-6 * trace * trace && trace > 0
                               ? Eigen::Vector2d(-before.hessian.inverse() * before.gradient)
                               : Eigen::Vector2d(-0.3 * size * before.gradient.normalized());
    if (!(step.norm() <= 0.5 * size))
      step *= 0.5 * size / step.norm();
    for (int k = 0; k < most_halvings && step.norm() > 1e-4 * size; ++k, step /= 2)
      if (try_step(v, step, [&] { return energy(v, epsilon).value < before.value; }))
        return step.norm() / size;
    return 0;
  }

  // Moves a vertex along its tangents, if it stays in the patch and the test likes it there.
  template <class Test> bool try_step(int v, const Eigen::Vector2d& step, const Test& test) {
    const Sheet_place old = place(v);
    const Plane_frame along(old.point, old.normal);
    Sheet_place& now = mesh_.places[std::size_t(v)];
    if (sheet_.move(old, step.x() * along.u + step.y() * along.v, now) && test())
      return true;
    now = old;
    return false;
  }

  double badness(int v) const {
    double sum = 0;
    for (int q : mesh_.quads_at(v)) {
      const double lack = 1 - mesh_.quality(q), squared = lack * lack, fourth = squared * squared;
      sum += fourth * fourth * (lack > 1 ? 100 : 1); // what turns over counts most
    }
    return sum;
  }

  // The best of steps in twelve directions, halved until they are small.
  bool search(int v) {
    const int directions = 12;
    double squared_size, least;
    measure(v, squared_size, least);
    double best = badness(v);
    const double first = best;
    for (double length = 0.2 * std::sqrt(squared_size), end = length / 12; length > end; length /= 2)
      for (int k = 0; k < directions; ++k) {
        const double angle = 2 * CGAL_PI * k / directions;
        const auto is_better = [&] {
          const double now = badness(v);
          if (!(now < (1 - 1e-3) * best))
            return false;
          best = now;
          return true;
        };
        if (try_step(v, length * Eigen::Vector2d(std::cos(angle), std::sin(angle)), is_better))
          --k; // once more the same way
      }
    return best < first;
  }

  Quad_patch& mesh_;
  const Sheet& sheet_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_QUAD_SMOOTHER_H
