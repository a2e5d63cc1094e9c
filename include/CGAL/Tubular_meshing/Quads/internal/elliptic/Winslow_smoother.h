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

  // χ of the Jacobian: itself, or above zero if cells are to be unfolded. Else not positive if folded.
  double positive_part(double jacobian) const {
    return epsilon_ > 0 ? (jacobian + std::sqrt(jacobian * jacobian + epsilon_ * epsilon_)) / 2 : jacobian;
  }

  double value_of(const Corner& c, const Cell& cell, std::size_t k) const {
    const double chi = positive_part(c.jacobian());
    if (!(chi > 0))
      return std::numeric_limits<double>::infinity();
    const Eigen::Matrix2d& metric = cell.metric[k];
    return (cell.beta * c.a.dot(metric * c.a) + c.b.dot(metric * c.b) / cell.beta) / 2 / chi;
  }

  // As a function of a node on which a and b depend by the factors da and db. Infinite if folded, and ε is 0.
  void add_corner(const Corner& c, const Cell& cell, std::size_t k, double da, double db, Energy& e) const {
    const double j = c.jacobian(), chi = positive_part(j);
    if (!(chi > 0)) {
      e.value = std::numeric_limits<double>::infinity();
      return;
    }
    const double root = 2 * chi - j;
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

  // What the energy of a node depends on: the nodes around it, row after row, itself in the middle; and its cells.
  struct Star {
    std::array<Eigen::Vector2d, 9> places;
    std::array<const Cell*, 4> cells;
  };

  Star star(std::size_t i, std::size_t j) const {
    const std::size_t left = i > 0 ? i - 1 : nodes_.columns - 1, below = (j - 1) * nodes_.columns,
                      beside = below + nodes_.columns;
    Star star;
    for (std::size_t row = 0; row < 3; ++row) {
      star.places[3 * row] = nodes_(left, j - 1 + row) - Eigen::Vector2d(i > 0 ? 0 : nodes_.period, 0);
      star.places[3 * row + 1] = nodes_(i, j - 1 + row);
      star.places[3 * row + 2] = nodes_(i + 1, j - 1 + row);
    }
    star.cells = {{&cells_[below + left], &cells_[below + i], &cells_[beside + left], &cells_[beside + i]}};
    return star;
  }

  // use(corner, its cell, its number there, da, db) for all corners that depend on the node, three of each cell.
  template <class Use> static void for_each_corner(const Star& star, Use use) {
    for (std::size_t n = 0; n < 4; ++n) {
      const bool is_left = n % 2 == 0, is_below = n < 2;
      const Eigen::Vector2d* const p = &star.places[(is_left ? 0 : 1) + (is_below ? 0 : 3)];
      for (std::size_t k = 0; k < 4; ++k) {
        const bool right = k == 1 || k == 2, top = k > 1;
        const double da = top == is_below ? (is_left ? 1 : -1) : 0, db = right == is_left ? (is_below ? 1 : -1) : 0;
        const Eigen::Vector2d* const side_a = p + (top ? 3 : 0);
        const Eigen::Vector2d* const side_b = p + (right ? 1 : 0);
        if (da != 0 || db != 0)
          use(Corner{side_a[1] - side_a[0], side_b[3] - side_b[0]}, *star.cells[n], k, da, db);
      }
    }
  }

  Energy energy(const Star& star) const {
    Energy e;
    for_each_corner(star, [&](const Corner& c, const Cell& cell, std::size_t k, double da, double db) {
      add_corner(c, cell, k, da, db, e);
    });
    return e;
  }
  double energy_value(const Star& star) const {
    double sum = 0;
    for_each_corner(
        star, [&](const Corner& c, const Cell& cell, std::size_t k, double, double) { sum += value_of(c, cell, k); });
    return sum;
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
    Star around = star(i, j);
    Eigen::Vector2d& place = around.places[4];
    const Energy before = energy(around);
    const Eigen::Vector2d old = place;
    Eigen::Vector2d by = part * step(before);
    for (int k = 0; k < most_halvings; ++k, by /= 2) {
      place = old + by;
      if (energy_value(around) < before.value) {
        nodes_.at(i, j) = place;
        return by.norm() / (std::max)((around.places[5] - old).norm(), (around.places[7] - old).norm());
      }
    }
    return 0;
  }

  Ring_nodes& nodes_;
  std::vector<Cell> cells_;
  double epsilon_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADS_INTERNAL_ELLIPTIC_WINSLOW_SMOOTHER_H
