// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_LATTICE_MATRIX_H
#define CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_LATTICE_MATRIX_H

#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A small dense matrix, from values at the points of one lattice to those at another's. */
class Lattice_matrix {
public:
  Lattice_matrix() = default;
  Lattice_matrix(std::size_t rows, std::size_t columns)
      : rows_(rows)
      , columns_(columns)
      , values_(rows * columns, 0) {}

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  double& operator()(std::size_t r, std::size_t c) { return values_[r * columns_ + c]; }
  double operator()(std::size_t r, std::size_t c) const { return values_[r * columns_ + c]; }

  Lattice_matrix times(const Lattice_matrix& m) const {
    Lattice_matrix result(rows_, m.columns_);
    for (std::size_t r = 0; r < rows_; ++r)
      for (std::size_t k = 0; k < columns_; ++k)
        for (std::size_t c = 0; c < m.columns_; ++c)
          result(r, c) += (*this)(r, k) * m(k, c);
    return result;
  }

  // By Gauss and Jordan, with pivots.
  Lattice_matrix inverse() const {
    Lattice_matrix a = *this, b(rows_, rows_);
    for (std::size_t i = 0; i < rows_; ++i)
      b(i, i) = 1;
    for (std::size_t k = 0; k < rows_; ++k) {
      std::size_t pivot = k;
      for (std::size_t i = k + 1; i < rows_; ++i)
        if (std::abs(a(i, k)) > std::abs(a(pivot, k)))
          pivot = i;
      for (std::size_t c = 0; c < rows_; ++c) {
        std::swap(a(k, c), a(pivot, c));
        std::swap(b(k, c), b(pivot, c));
      }
      const double d = 1 / a(k, k);
      for (std::size_t c = 0; c < rows_; ++c) {
        a(k, c) *= d;
        b(k, c) *= d;
      }
      for (std::size_t i = 0; i < rows_; ++i) {
        const double f = a(i, k);
        if (i == k || f == 0)
          continue;
        for (std::size_t c = 0; c < rows_; ++c) {
          a(i, c) -= f * a(k, c);
          b(i, c) -= f * b(k, c);
        }
      }
    }
    return b;
  }

  /* Of an array in three dimensions, of sizes inner, columns() and outer, the inner one running fastest: maps the one in
   * the middle. */
  template <class T> void apply(const T* in, T* out, std::size_t inner, std::size_t outer) const {
    for (std::size_t o = 0; o < outer; ++o, in += columns_ * inner, out += rows_ * inner)
      for (std::size_t r = 0; r < rows_; ++r) {
        T* const to = out + r * inner;
        std::fill(to, to + inner, T());
        for (std::size_t c = 0; c < columns_; ++c) {
          const double m = (*this)(r, c);
          const T* const from = in + c * inner;
          for (std::size_t i = 0; i < inner; ++i)
            to[i] += m * from[i];
        }
      }
  }

private:
  std::size_t rows_ = 0, columns_ = 0;
  std::vector<double> values_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_LATTICE_MATRIX_H
