// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_LATTICE_FACTOR_H
#define CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_LATTICE_FACTOR_H

#include <CGAL/Tubular_meshing/Quadratic/internal/Lattice_matrix.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

typedef std::vector<double> Barycentric; // coordinates in a simplex

/* The points of a simplex's lattice of a degree, as multi-indices that add up to it. */
inline std::vector<std::vector<int>> multi_indices(std::size_t corners, int degree) {
  if (corners == 1)
    return {{degree}};
  std::vector<std::vector<int>> result;
  for (int i = degree; i >= 0; --i)
    for (std::vector<int> rest : multi_indices(corners - 1, degree - i)) {
      rest.insert(rest.begin(), i);
      result.push_back(rest);
    }
  return result;
}

inline double bernstein(const std::vector<int>& index, const Barycentric& at) {
  double value = 1;
  int sum = 0;
  for (std::size_t k = 0; k < index.size(); ++k)
    for (int i = 1; i <= index[k]; ++i)
      value *= at[k] * double(++sum) / i; // the multinomial coefficient along the way
  return value;
}

/* A line, triangle or tetrahedron, of which reference cells are products: its matrices for fields, which are given by
 * their values at the lattice of a low degree, and for the determinant of three fields, which is of a higher one. */
class Lattice_factor {
public:
  Lattice_factor(std::size_t corners, int field_degree, int degree)
      : corners_(corners) {
    const auto fields = lattice(field_degree), values = lattice(degree);
    const Lattice_matrix of_fields = bernstein_at(field_degree, fields);
    fields_to_bernstein = of_fields.inverse();
    fields_to_values = bernstein_at(field_degree, values).times(fields_to_bernstein);
    values_to_bernstein = bernstein_at(degree, values).inverse();
    for (const auto& child : children_of_simplex()) {
      std::vector<Barycentric> points;
      for (const Barycentric& b : fields) {
        Barycentric p(corners, 0);
        for (std::size_t k = 0; k < corners; ++k)
          for (std::size_t i = 0; i < corners; ++i)
            p[i] += b[k] * child[k][i];
        points.push_back(p);
      }
      children.push_back(bernstein_at(field_degree, points).times(fields_to_bernstein));
    }
  }

  Lattice_matrix fields_to_values, fields_to_bernstein, values_to_bernstein;
  std::vector<Lattice_matrix> children; // from the fields to those of the halves, quarters or eighths

  std::size_t fields() const { return fields_to_values.columns(); }
  std::size_t values() const { return fields_to_values.rows(); }

private:
  std::vector<Barycentric> lattice(int degree) const {
    std::vector<Barycentric> result;
    for (const auto& index : multi_indices(corners_, degree)) {
      result.emplace_back();
      for (int i : index)
        result.back().push_back(double(i) / degree);
    }
    return result;
  }

  Lattice_matrix bernstein_at(int degree, const std::vector<Barycentric>& points) const {
    const auto functions = multi_indices(corners_, degree);
    Lattice_matrix m(points.size(), functions.size());
    for (std::size_t r = 0; r < points.size(); ++r)
      for (std::size_t c = 0; c < functions.size(); ++c)
        m(r, c) = bernstein(functions[c], points[r]);
    return m;
  }

  // Corners, and middles of edges, in barycentric coordinates.
  Barycentric middle(std::size_t i, std::size_t j) const {
    Barycentric b(corners_, 0);
    b[i] += 0.5;
    b[j] += 0.5;
    return b;
  }

  std::vector<std::vector<Barycentric>> children_of_simplex() const {
    std::vector<std::vector<Barycentric>> result;
    for (std::size_t k = 0; k < corners_; ++k) {
      result.emplace_back();
      for (std::size_t i = 0; i < corners_; ++i)
        result.back().push_back(middle(k, i));
    }
    if (corners_ == 3)
      result.push_back({middle(0, 1), middle(1, 2), middle(2, 0)});
    if (corners_ == 4) // the octahedron that is left, round one of its diagonals
      for (const auto& e :
           std::array<std::array<std::size_t, 4>, 4>{{{{0, 1, 1, 2}}, {{1, 2, 2, 3}}, {{2, 3, 0, 3}}, {{0, 3, 0, 1}}}})
        result.push_back({middle(0, 2), middle(1, 3), middle(e[0], e[1]), middle(e[2], e[3])});
    return result;
  }

  std::size_t corners_;
};

/* A line, of fields of the second degree; and so on. Determinants of the derivatives of a quadratic map are of these
 * degrees at most. */
inline const Lattice_factor& line_factor() {
  static const Lattice_factor factor(2, 2, 5);
  return factor;
}
inline const Lattice_factor& triangle_factor() {
  static const Lattice_factor factor(3, 2, 4);
  return factor;
}
inline const Lattice_factor& tetrahedron_factor() {
  static const Lattice_factor factor(4, 1, 3);
  return factor;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_LATTICE_FACTOR_H
