// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_PARAMETERIZATION_LAPLACE_SYSTEM_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_PARAMETERIZATION_LAPLACE_SYSTEM_H

#include <CGAL/Tubular_meshing/Patches/internal/parameterization/edge_weights.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Σ_j w_ij (x_i − x_j) = b_i for each vertex i that is not fixed, one column of x and b a function. Fixed rows of x are
 * given, the others are found. About O(n^1.5) for the vertices of a surface. */
class Laplace_system {
public:
  typedef Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic> Columns;

  Laplace_system(const std::vector<Weighted_edge>& edges, const std::vector<char>& is_fixed)
      : edges_(edges)
      , row_(is_fixed.size(), -1) {
    for (std::size_t i = 0; i < is_fixed.size(); ++i)
      if (!is_fixed[i])
        row_[i] = rows_++;
  }

  // False, if it has no solution in finite numbers.
  bool solve(const Columns& b, Columns& x) const {
    if (rows_ == 0)
      return true;
    bool symmetric = true;
    for (const Weighted_edge& e : edges_)
      symmetric = symmetric && e.of_a == e.of_b;
    Columns rhs(rows_, x.cols()), found;
    for (std::size_t i = 0; i < row_.size(); ++i)
      if (row_[i] >= 0)
        rhs.row(row_[i]) = b.row(Eigen::Index(i));
    for (const Weighted_edge& e : edges_) {
      move_fixed(e.a, e.b, e.of_b, x, rhs);
      move_fixed(e.b, e.a, e.of_a, x, rhs);
    }
    const bool solved = symmetric ? solve_symmetric(rhs, found) : solve_general(rhs, found);
    if (!solved || !found.allFinite())
      return false;
    for (std::size_t i = 0; i < row_.size(); ++i)
      if (row_[i] >= 0)
        x.row(Eigen::Index(i)) = found.row(row_[i]);
    return true;
  }

private:
  typedef Eigen::SparseMatrix<double> Matrix;

  void move_fixed(int i, int j, double w, const Columns& x, Columns& rhs) const {
    if (row_[std::size_t(i)] >= 0 && row_[std::size_t(j)] < 0)
      rhs.row(row_[std::size_t(i)]) += w * x.row(j);
  }

  // Of a symmetric matrix, the lower half.
  Matrix matrix(bool lower_half) const {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(4 * edges_.size());
    const auto add = [&](int i, int j, double w) {
      const int r = row_[std::size_t(i)], c = row_[std::size_t(j)];
      if (r < 0)
        return;
      entries.emplace_back(r, r, w);
      if (c >= 0 && (!lower_half || c < r))
        entries.emplace_back(r, c, -w);
    };
    for (const Weighted_edge& e : edges_) {
      add(e.a, e.b, e.of_b);
      add(e.b, e.a, e.of_a);
    }
    Matrix m(rows_, rows_);
    m.setFromTriplets(entries.begin(), entries.end());
    return m;
  }

  bool solve_symmetric(const Columns& rhs, Columns& x) const {
    const Eigen::SimplicialLDLT<Matrix> solver(matrix(true));
    if (solver.info() != Eigen::Success)
      return false;
    x = solver.solve(rhs);
    return true;
  }

  bool solve_general(const Columns& rhs, Columns& x) const {
    Matrix m = matrix(false);
    scale_rows(m, x = rhs);
    m.makeCompressed();
    Eigen::SparseLU<Matrix> solver(m);
    if (solver.info() != Eigen::Success)
      return false;
    x = solver.solve(Columns(x));
    return true;
  }

  // To a diagonal of ones, as each vertex has a scale of its own.
  static void scale_rows(Matrix& m, Columns& rhs) {
    const Eigen::VectorXd scale = m.diagonal().cwiseInverse();
    m = Matrix(scale.asDiagonal() * m);
    rhs = Columns(scale.asDiagonal() * rhs);
  }

  const std::vector<Weighted_edge>& edges_;
  std::vector<int> row_; // −1 of fixed vertices
  int rows_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_PARAMETERIZATION_LAPLACE_SYSTEM_H
