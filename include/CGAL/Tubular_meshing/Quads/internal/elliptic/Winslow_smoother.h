// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_INTERNAL_ELLIPTIC_WINSLOW_SMOOTHER_H
#define CGAL_TUBULAR_MESHING_QUADS_INTERNAL_ELLIPTIC_WINSLOW_SMOOTHER_H

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Nodes of a grid that is periodic along its rows; X grows by the period once around. */
struct Ring_nodes {
  std::size_t columns = 0, rows = 0; // rows of cells: of nodes, one more
  double period = 0;
  std::vector<Eigen::Vector2d> places; // row after row

  Eigen::Vector2d& at(std::size_t i, std::size_t j) { return places[j * columns + i]; }
  // i up to twice the columns
  Eigen::Vector2d operator()(std::size_t i, std::size_t j) const {
    return i < columns ? places[j * columns + i]
                       : Eigen::Vector2d(places[j * columns + i - columns] + Eigen::Vector2d(period, 0));
  }
  std::size_t number_of_cells() const { return columns * rows; }
};

/* The elliptic smoother of A. M. Winslow in its variational form (J. U. Brackbill, J. S. Saltzman, *Adaptive zoning for
 * singular problems in two dimensions*, J. Comput. Phys. 46, 1982), in a metric: makes ∫ (β |x,ξ|² + |x,η|² / β) / J
 * least, whose Euler equations are those by which ξ and η are harmonic functions on the surface. A cell's share is one
 * if it is a rectangle on the surface whose height is β times its width: β takes the place of control functions.
 *
 * The share of a cell grows without bound as an angle of it comes near 0 or π. So no cell folds that was not folded
 * before; and where some are, J is made (J + √(J² + ε²)) / 2 first, with ε of their size, which unfolds them. */
class Winslow_smoother {
public:
  struct Cell {
    std::array<Eigen::Matrix2d, 4> metric; // of determinant one, at the corners: see corner()
    double beta = 1;
    Cell() { metric.fill(Eigen::Matrix2d::Identity()); }
  };

  // A corner of a cell: the sides there, in the directions of ξ and η.
  struct Corner {
    Eigen::Vector2d a, b;
    double jacobian() const { return a.x() * b.y() - a.y() * b.x(); }
  };
  explicit Winslow_smoother(Ring_nodes& nodes)
      : nodes_(nodes)
      , cells_(nodes.number_of_cells()) {}

  Cell& cell(std::size_t i, std::size_t j) { return cells_[j * nodes_.columns + i]; }

  // Corner 0 is at (i, j), 1 at (i + 1, j), 2 at (i + 1, j + 1), 3 at (i, j + 1).
  Corner corner(std::size_t i, std::size_t j, std::size_t k) const {
    const std::size_t right = k == 1 || k == 2 ? 1 : 0, top = k / 2;
    return {nodes_(i + 1, j + top) - nodes_(i, j + top), nodes_(i + right, j + 1) - nodes_(i + right, j)};
  }

  /* Twice the least area, in the coordinates, of the four corners of all cells: not positive if one is folded. */
  double least_corner() const {
    double least = (std::numeric_limits<double>::max)();
    for (std::size_t j = 0; j < nodes_.rows; ++j)
      for (std::size_t i = 0; i < nodes_.columns; ++i)
        for (std::size_t k = 0; k < 4; ++k)
          least = (std::min)(least, corner(i, j, k).jacobian());
    return least;
  }

  /* Moves each node inside towards where its cells are best, by the given part of a Newton step or less. Returns the
   * greatest move, relative to the cells around. */
  double sweep(double part) {
    const double least = least_corner();
    epsilon_ = least > 0 ? 0 : 1e-3 * mean_corner() - least;
    double greatest = 0;
    for (std::size_t j = 1; j < nodes_.rows; ++j)
      for (std::size_t i = 0; i < nodes_.columns; ++i)
        greatest = (std::max)(greatest, move(i, j, part));
    return greatest;
  }

private:
  struct Energy {
    double value = 0;
    Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
    Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
  };

  double mean_corner() const { // by the area of the ring
    double sum = 0;
    for (std::size_t i = 0; i < nodes_.columns; ++i)
      sum += nodes_(i, nodes_.rows).y() - nodes_(i, 0).y();
    return nodes_.period * sum / double(nodes_.columns) / double(nodes_.number_of_cells());
  }

  // As a function of a node on which a and b depend by the factors da and db. Infinite if folded, and ε is 0.
  void add_corner(const Corner& c, const Cell& cell, std::size_t k, double da, double db, Energy& e) const {
    if (da == 0 && db == 0)
      return;
    const double j = c.jacobian(), root = std::hypot(j, epsilon_), chi = epsilon_ > 0 ? (j + root) / 2 : j;
    if (!(chi > 0)) {
      e.value = std::numeric_limits<double>::infinity();
      return;
    }
    const double chi1 = epsilon_ > 0 ? (1 + j / root) / 2 : 1;
    const double chi2 = epsilon_ > 0 ? epsilon_ * epsilon_ / (2 * root * root * root) : 0;
    const Eigen::Matrix2d& metric = cell.metric[k];
    const Eigen::Vector2d ma = cell.beta * (metric * c.a), mb = 1 / cell.beta * (metric * c.b);
    const double value = (c.a.dot(ma) + c.b.dot(mb)) / 2 / chi;
    const Eigen::Vector2d dj(da * c.b.y() - db * c.a.y(), db * c.a.x() - da * c.b.x());
    const Eigen::Vector2d gradient = (da * ma + db * mb - value * chi1 * dj) / chi;
    const Eigen::Matrix2d mixed = chi1 * gradient * dj.transpose();
    e.value += value;
    e.gradient += gradient;
    e.hessian += ((da * da * cell.beta + db * db / cell.beta) * metric - value * chi2 * dj * dj.transpose() - mixed -
                  mixed.transpose()) /
                 chi;
  }

  Energy energy(std::size_t i, std::size_t j) const {
    Energy e;
    const std::size_t left = i > 0 ? i - 1 : nodes_.columns - 1;
    for (std::size_t k = 0; k < 4; ++k) {
      add_corner(corner(i, j, k), cells_[j * nodes_.columns + i], k, k < 2 ? -1 : 0, k == 0 || k == 3 ? -1 : 0, e);
      add_corner(corner(left, j, k), cells_[j * nodes_.columns + left], k, k < 2 ? 1 : 0, k == 1 || k == 2 ? -1 : 0, e);
      add_corner(corner(i, j - 1, k), cells_[(j - 1) * nodes_.columns + i], k, k < 2 ? 0 : -1, k == 0 || k == 3 ? 1 : 0,
                 e);
      add_corner(corner(left, j - 1, k), cells_[(j - 1) * nodes_.columns + left], k, k < 2 ? 0 : 1,
                 k == 1 || k == 2 ? 1 : 0, e);
    }
    return e;
  }

  // Where the energy is not convex, down its gradient, as far as the trace of its second derivatives lets expect.
  static Eigen::Vector2d step(const Energy& e) {
    const double trace = e.hessian.trace();
    if (e.hessian.determinant() > 1e-6 * trace * trace && trace > 0)
      return -e.hessian.inverse() * e.gradient;
    return -e.gradient / (std::max)(e.hessian.norm(), (std::numeric_limits<double>::min)());
  }

  double move(std::size_t i, std::size_t j, double part) {
    const int most_halvings = 10;
    const Energy before = energy(i, j);
    const Eigen::Vector2d place = nodes_.at(i, j);
    Eigen::Vector2d by = part * step(before);
    for (int k = 0; k < most_halvings; ++k, by /= 2) {
      nodes_.at(i, j) = place + by;
      if (energy(i, j).value < before.value)
        return by.norm() / (std::max)((nodes_(i + 1, j) - place).norm(), (nodes_(i, j + 1) - place).norm());
    }
    nodes_.at(i, j) = place;
    return 0;
  }

  Ring_nodes& nodes_;
  std::vector<Cell> cells_;
  double epsilon_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADS_INTERNAL_ELLIPTIC_WINSLOW_SMOOTHER_H
