// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_QUADRATIC_CELL_H
#define CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_QUADRATIC_CELL_H

#include <CGAL/Tubular_meshing/Quadratic/Quadratic_mesh.h>
#include <CGAL/Tubular_meshing/Quadratic/internal/Lattice_factor.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

// The middle of a quad of eight nodes.
template <class Corners, class Edges> Vector_3d middle_of_quad(const Corners& corners, const Edges& edges) {
  Vector_3d c, e;
  for (std::size_t k = 0; k < 4; ++k) {
    c += corners(k);
    e += edges(k);
  }
  return 0.5 * e + -0.25 * c;
}

/* The nodes of a quadratic cell, with those that a serendipity element does not have but implies. */
class Cell_points {
public:
  std::array<Vector_3d, 27> point; // corners, edges, quads, the middle: as Element_nodes has them
  Element_type type;

  // Those of the quads, and then of the middle, from the others.
  void imply_quads() {
    const Element_topology& t = topology_of(type);
    for (std::size_t q = 0; q < t.number_of_quads; ++q)
      point[t.corners + t.number_of_edges + q] = middle_of_quad([&](std::size_t k) { return corner_of_quad(q, k); },
                                                                [&](std::size_t k) { return edge_of_quad(q, k); });
  }
  void imply_middle() {
    if (type != Element_type::hexahedron)
      return;
    Vector_3d corners, edges, quads;
    for (std::size_t k = 0; k < 8; ++k)
      corners += point[k];
    for (std::size_t k = 8; k < 20; ++k)
      edges += point[k];
    for (std::size_t k = 20; k < 26; ++k)
      quads += point[k];
    point[26] = 0.5 * quads + -0.25 * edges + 0.125 * corners;
  }

  Vector_3d corner_of_quad(std::size_t q, std::size_t k) const {
    return point[std::size_t(topology_of(type).quads[q][k])];
  }
  Vector_3d edge_of_quad(std::size_t q, std::size_t k) const {
    const Element_topology& t = topology_of(type);
    return edge(t.quads[q][k], t.quads[q][(k + 1) % 4]);
  }
  // Of the edge between two corners.
  Vector_3d edge(int a, int b) const {
    const Element_topology& t = topology_of(type);
    std::size_t k = 0;
    while (k + 1 < t.number_of_edges && !(t.edges[k][0] == a && t.edges[k][1] == b) &&
           !(t.edges[k][0] == b && t.edges[k][1] == a))
      ++k;
    return point[t.corners + k];
  }
};

enum class Cell_validity { valid, invalid, unproved };

struct Jacobian_bounds {
  double lower, upper; // of the least value
};

/* The Jacobian of a quadratic cell, bounded from both sides.
 *
 * The derivatives of the map from the reference cell are three fields, polynomials of the second degree, along the
 * directions that the cell's edges have. Their determinant is a polynomial too; in Bernstein's basis its coefficients
 * bound it (Johnen, Remacle, Geuzaine 2013), and those of the parts of a cell ever more closely. On a pyramid the map is
 * rational; in the coordinates that collapse a cube's side into the apex it is a polynomial, and both derivatives across
 * are so when divided by the distance from the apex, which leaves the sign of the determinant and all proportions.
 *
 * The scaled Jacobian is, at each point, the determinant divided by the product of the fields' lengths: as at the
 * corners of linear cells. Where more than three directions of edges meet, it is the least of those at the corners. */
class Quadratic_cell {
public:
  explicit Quadratic_cell(const Cell_points& cell)
      : type_(cell.type) {
    if (type_ == Element_type::tetrahedron)
      make_tetrahedron(cell);
    else if (type_ == Element_type::prism)
      make_prism(cell);
    else
      make_cube(type_ == Element_type::hexahedron ? hexahedron_lattice(cell) : pyramid_lattice(cell));
  }

  /* Whether the Jacobian is positive everywhere. */
  Cell_validity validity() const {
    std::vector<std::pair<Fields, int>> parts = {{fields_, 0}};
    for (std::size_t n = 0; !parts.empty(); ++n) {
      const Fields part = parts.back().first;
      const int depth = parts.back().second;
      parts.pop_back();
      const Range range = determinant(part);
      if (range.sample <= 0)
        return Cell_validity::invalid;
      if (range.lower > 0)
        continue;
      if (depth == deepest || n > most_parts)
        return Cell_validity::unproved;
      for (std::size_t c = 0; c < number_of_children(); ++c)
        parts.emplace_back(child(part, c), depth + 1);
    }
    return Cell_validity::valid;
  }

  /* Of the least scaled Jacobian; they differ by no more than a part of the upper one, if so many parts of the cell are
   * enough for that, and the cell is valid. */
  Jacobian_bounds scaled_jacobian(double tolerance, std::size_t most) const {
    std::priority_queue<Part> parts;
    double upper = 1;
    Values at;
    const auto add = [&](const Fields& fields) {
      evaluate(fields, at);
      upper = (std::min)(upper, at.range.sample <= 0 ? 0. : upper);
      upper = (std::min)(upper, least_at_points(fields));
      parts.push({at.range.lower > 0 ? scaled_bound(fields, at) : -1, fields});
    };
    add(fields_);
    for (std::size_t n = 1; n < most && upper > 0 && parts.top().lower < (1 - tolerance) * upper; n += 8) {
      const Fields worst = parts.top().fields;
      parts.pop();
      for (std::size_t c = 0; c < number_of_children(); ++c)
        add(child(worst, c));
    }
    return {(std::min)(parts.top().lower, upper), upper};
  }

private:
  static constexpr int deepest = 8;
  static constexpr std::size_t most_parts = 600;
  typedef std::array<Vector_3d, 27> Field;
  typedef std::array<Field, 3> Fields;

  struct Range {
    double lower, sample; // a lower bound, and the least of the values at some points
  };
  struct Part {
    double lower;
    Fields fields;
    bool operator<(const Part& p) const { return lower > p.lower; } // the lowest first
  };

  // --- the fields ---

  void make_tetrahedron(const Cell_points& cell) {
    const auto& p = cell.point;
    // along the edge from 0 to k, at each corner
    for (std::size_t k = 1; k < 4; ++k)
      for (std::size_t at = 0; at < 4; ++at) {
        const double at_0 = at == 0, at_k = at == k;
        Vector_3d d = (4 * at_k - 1) * p[k] + -(4 * at_0 - 1) * p[0];
        if (at != k)
          d += 4. * cell.edge(int(at), int(k));
        if (at != 0)
          d += -4. * cell.edge(int(at), 0);
        fields_[k - 1][at] = d;
      }
  }

  static const Lattice_matrix& derivative_on_line() {
    static const Lattice_matrix matrix = [] {
      const double d[3][3] = {{-3, 4, -1}, {-1, 0, 1}, {1, -4, 3}};
      Lattice_matrix m(3, 3);
      for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c)
          m(r, c) = d[r][c];
      return m;
    }();
    return matrix;
  }

  /* From the points of a triangle's lattice, 0 01 02 1 12 2, to the derivative along the edge from 0 to k. */
  static Lattice_matrix derivative_on_triangle(std::size_t k) {
    const auto points = multi_indices(3, 2);
    Lattice_matrix m(6, 6);
    for (std::size_t r = 0; r < 6; ++r) {
      const double b[3] = {points[r][0] / 2., points[r][1] / 2., points[r][2] / 2.};
      double slope[3] = {-1, 0, 0};
      slope[k] = 1;
      for (std::size_t c = 0; c < 6; ++c) {
        std::vector<std::size_t> corners; // of the function: one twice, or two
        for (std::size_t i = 0; i < 3; ++i)
          for (int n = 0; n < points[c][i]; ++n)
            corners.push_back(i);
        const std::size_t i = corners[0], j = corners[1];
        m(r, c) = i == j ? (4 * b[i] - 1) * slope[i] : 4 * (b[i] * slope[j] + b[j] * slope[i]);
      }
    }
    return m;
  }

  void make_prism(const Cell_points& cell) {
    static const Lattice_matrix along_1 = derivative_on_triangle(1), along_2 = derivative_on_triangle(2);
    // the nodes as the lattice has them: three triangles above each other
    static const std::array<std::size_t, 18> order = {0, 6, 8, 1, 7, 2, 12, 15, 17, 13, 16, 14, 3, 9, 11, 4, 10, 5};
    Field x;
    for (std::size_t i = 0; i < 18; ++i)
      x[i] = cell.point[order[i]];
    along_1.apply(x.data(), fields_[0].data(), 1, 3);
    along_2.apply(x.data(), fields_[1].data(), 1, 3);
    derivative_on_line().apply(x.data(), fields_[2].data(), 6, 1);
  }

  // Where a node of a hexahedron is in a lattice of 3 x 3 x 3.
  static const std::array<std::size_t, 27>& places_in_cube() {
    static const std::array<std::size_t, 27> places = [] {
      const int corner[8][3] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}};
      const Element_topology& t = topology_of(Element_type::hexahedron);
      std::array<std::size_t, 27> result;
      const auto place = [&](const int* first, std::size_t n) {
        int sum[3] = {0, 0, 0};
        for (std::size_t i = 0; i < n; ++i)
          for (std::size_t k = 0; k < 3; ++k)
            sum[k] += corner[first[i]][k];
        const int m = int(n);
        return std::size_t(sum[0] / m + 3 * (sum[1] / m) + 9 * (sum[2] / m));
      };
      for (int c = 0; c < 8; ++c)
        result[std::size_t(c)] = place(&c, 1);
      for (std::size_t e = 0; e < 12; ++e)
        result[8 + e] = place(t.edges[e].data(), 2);
      for (std::size_t q = 0; q < 6; ++q)
        result[20 + q] = place(t.quads[q].data(), 4);
      result[26] = 13;
      return result;
    }();
    return places;
  }

  static Field hexahedron_lattice(const Cell_points& cell) {
    Field x;
    for (std::size_t i = 0; i < 27; ++i)
      x[places_in_cube()[i]] = cell.point[i];
    return x;
  }

  /* The points where the pyramid's map takes the lattice of the cube that it is in collapsed coordinates. The middle of
   * the base, where it has a node of its own, adds a bubble to what its edges imply. */
  static Field pyramid_lattice(const Cell_points& cell) {
    const auto& p = cell.point;
    Field x;
    x[0] = p[0], x[2] = p[1], x[8] = p[2], x[6] = p[3];
    x[1] = p[5], x[5] = p[6], x[7] = p[7], x[3] = p[8];
    x[4] = p[13];
    const std::size_t corner[4] = {9, 11, 17, 15}, side[4] = {10, 14, 16, 12};
    Vector_3d corners, base_edges, apex_edges;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t next = (k + 1) % 4;
      x[corner[k]] = p[9 + k];
      x[side[k]] = -0.125 * (p[k] + p[next]) + 0.25 * p[5 + k] + 0.5 * (p[9 + k] + p[9 + next]);
      corners += p[k];
      base_edges += p[5 + k];
      apex_edges += p[9 + k];
    }
    const Vector_3d bubble = p[13] - (0.5 * base_edges + -0.25 * corners);
    x[13] = -0.125 * corners + 0.125 * base_edges + 0.25 * apex_edges + 0.25 * bubble;
    for (std::size_t i = 18; i < 27; ++i)
      x[i] = p[4];
    return x;
  }

  void make_cube(const Field& x) {
    const Lattice_matrix& d = derivative_on_line();
    d.apply(x.data(), fields_[0].data(), 1, 9);
    d.apply(x.data(), fields_[1].data(), 3, 3);
    d.apply(x.data(), fields_[2].data(), 9, 1);
    if (type_ == Element_type::pyramid)
      for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t i = 0; i < 9; ++i) { // divided by 1 - z, which leaves them linear in z
          fields_[k][9 + i] = 2. * fields_[k][9 + i];
          fields_[k][18 + i] = 2. * fields_[k][9 + i] - fields_[k][i];
        }
  }

  // --- products of lattices ---

  std::array<const Lattice_factor*, 3> factors() const {
    if (type_ == Element_type::tetrahedron)
      return {&tetrahedron_factor(), nullptr, nullptr};
    if (type_ == Element_type::prism)
      return {&triangle_factor(), &line_factor(), nullptr};
    return {&line_factor(), &line_factor(), &line_factor()};
  }

  std::size_t number_of_children() const { return 8; } // of a tetrahedron, a prism, a cube

  /* Maps along all of the factors; `matrix(factor, k)` is that of the k-th. The arrays hold the largest of lattices. */
  template <class T, class Matrix> void map(const T* in, T* out, T* scratch, const Matrix& matrix) const {
    const auto f = factors();
    std::array<std::size_t, 3> size = {1, 1, 1};
    std::size_t n = 0;
    for (; n < 3 && f[n] != nullptr; ++n)
      size[n] = matrix(*f[n], n).columns();
    const T* from = in;
    for (std::size_t k = 0; k < n; ++k) {
      T* const to = (n - k) % 2 == 1 ? out : scratch;
      const std::size_t inner = k == 0 ? 1 : k == 1 ? size[0] : size[0] * size[1];
      const std::size_t outer = k == 0 ? size[1] * size[2] : k == 1 ? size[2] : 1;
      matrix(*f[k], k).apply(from, to, inner, outer);
      size[k] = matrix(*f[k], k).rows();
      from = to;
    }
  }

  Fields child(const Fields& fields, std::size_t number) const {
    Fields result;
    Field scratch;
    const auto f = factors();
    std::array<std::size_t, 3> part = {0, 0, 0};
    for (std::size_t k = 0; k < 3 && f[k] != nullptr; ++k) {
      part[k] = number % f[k]->children.size();
      number /= f[k]->children.size();
    }
    for (std::size_t d = 0; d < 3; ++d)
      map(fields[d].data(), result[d].data(), scratch.data(),
          [&](const Lattice_factor& factor, std::size_t k) -> const Lattice_matrix& {
            return factor.children[part[k]];
          });
    return result;
  }

  std::size_t number_of_values() const {
    std::size_t n = 1;
    for (const Lattice_factor* f : factors())
      n *= f == nullptr ? 1 : f->values();
    return n;
  }
  std::size_t number_of_fields() const {
    std::size_t n = 1;
    for (const Lattice_factor* f : factors())
      n *= f == nullptr ? 1 : f->fields();
    return n;
  }

  // The fields at the points of the lattice of their determinant, and the coefficients of the determinant.
  struct Values {
    std::array<std::array<Vector_3d, 216>, 3> fields;
    std::array<double, 216> coefficients;
    Range range;
  };

  static const Lattice_matrix& to_bernstein(const Lattice_factor& f, std::size_t) { return f.values_to_bernstein; }

  void evaluate(const Fields& fields, Values& at) const {
    std::array<Vector_3d, 216> scratch;
    for (std::size_t d = 0; d < 3; ++d)
      map(fields[d].data(), at.fields[d].data(), scratch.data(),
          [](const Lattice_factor& f, std::size_t) -> const Lattice_matrix& { return f.fields_to_values; });
    std::array<double, 216> values, numbers;
    const std::size_t n = number_of_values();
    at.range = {0, (std::numeric_limits<double>::infinity)()};
    double scale = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Vector_3d &u = at.fields[0][i], &v = at.fields[1][i], &w = at.fields[2][i];
      values[i] = dot(cross(u, v), w);
      at.range.sample = (std::min)(at.range.sample, values[i]);
      scale = (std::max)(scale, squared_norm(u) * squared_norm(v) * squared_norm(w));
    }
    map(values.data(), at.coefficients.data(), numbers.data(), &to_bernstein);
    const double rounding = 1e-12 * std::sqrt(scale); // the matrices' norms times the last bits
    for (std::size_t i = 0; i < n; ++i)
      at.coefficients[i] -= rounding;
    at.range.lower = *std::min_element(at.coefficients.begin(), at.coefficients.begin() + std::ptrdiff_t(n));
  }

  Range determinant(const Fields& fields) const {
    Values at;
    evaluate(fields, at);
    return at.range;
  }

  // --- scaling ---

  // The direction of an edge: a field, or where `from` is k > 0, a field less the (k-1)-th.
  struct Direction {
    std::size_t field, from;
    template <class Array> Vector_3d of(const Array& fields, std::size_t i) const {
      return from == 0 ? fields[field][i] : fields[field][i] - fields[from - 1][i];
    }
  };
  typedef std::array<std::size_t, 3> Corner_of_directions; // which of them meet at a corner

  /* Directions of edges, and which of them meet at the corners. */
  const std::vector<Direction>& directions() const {
    static const std::vector<Direction> cube = {{0, 0}, {1, 0}, {2, 0}}, prism = {{0, 0}, {1, 0}, {2, 0}, {1, 1}},
                                        tetrahedron = {{0, 0}, {1, 0}, {2, 0}, {1, 1}, {2, 1}, {2, 2}};
    return type_ == Element_type::tetrahedron ? tetrahedron : type_ == Element_type::prism ? prism : cube;
  }
  const std::vector<Corner_of_directions>& corners() const {
    static const std::vector<Corner_of_directions> cube = {{{0, 1, 2}}},
                                                   prism = {{{0, 1, 2}}, {{0, 3, 2}}, {{1, 3, 2}}},
                                                   tetrahedron = {{{0, 1, 2}}, {{0, 3, 4}}, {{1, 3, 5}}, {{2, 4, 5}}};
    return type_ == Element_type::tetrahedron ? tetrahedron : type_ == Element_type::prism ? prism : cube;
  }

  double least_at_points(const Fields& fields) const {
    double least = 1;
    for (std::size_t i = 0, n = number_of_fields(); i < n; ++i) {
      const double det = dot(cross(fields[0][i], fields[1][i]), fields[2][i]);
      std::array<double, 6> length;
      for (std::size_t d = 0; d < directions().size(); ++d)
        length[d] = norm(directions()[d].of(fields, i));
      for (const auto& c : corners()) {
        const double product = length[c[0]] * length[c[1]] * length[c[2]];
        least = (std::min)(least, product > 0 ? det / product : 0);
      }
    }
    return least;
  }

  /* A lower bound of the scaled Jacobian where the determinant's coefficients are positive. A direction's length is no
   * more than its component a along a fixed unit vector, and the largest square of what is across, over twice the least
   * of a: a polynomial of the fields' degree. The product of three of these has that of the determinant, and a quotient
   * of polynomials is no less than the least of the quotients of their coefficients. */
  double scaled_bound(const Fields& fields, const Values& at) const {
    Fields control;
    Field scratch;
    for (std::size_t d = 0; d < 3; ++d)
      map(fields[d].data(), control[d].data(), scratch.data(),
          [](const Lattice_factor& f, std::size_t) -> const Lattice_matrix& { return f.fields_to_bernstein; });
    const std::size_t n = number_of_values();
    std::array<std::array<double, 216>, 6> length;
    for (std::size_t d = 0; d < directions().size(); ++d)
      if (!bound_lengths(directions()[d], control, at, length[d]))
        return -1;
    double least = 1;
    std::array<double, 216> product, coefficients, numbers;
    for (const auto& c : corners()) {
      for (std::size_t i = 0; i < n; ++i)
        product[i] = length[c[0]][i] * length[c[1]][i] * length[c[2]][i];
      map(product.data(), coefficients.data(), numbers.data(), &to_bernstein);
      const double rounding = 1e-12 * *std::max_element(product.begin(), product.begin() + std::ptrdiff_t(n));
      for (std::size_t i = 0; i < n; ++i) {
        if (!(coefficients[i] > 0))
          return -1;
        least = (std::min)(least, at.coefficients[i] / (coefficients[i] + rounding));
      }
    }
    return least;
  }

  // Whether the direction turns so little that its length can be bounded.
  bool bound_lengths(const Direction& direction, const Fields& control, const Values& at,
                     std::array<double, 216>& length) const {
    Vector_3d mean;
    for (std::size_t i = 0, n = number_of_fields(); i < n; ++i)
      mean += direction.of(control, i);
    mean = normalized(mean);
    double least = (std::numeric_limits<double>::infinity)(), across = 0;
    for (std::size_t i = 0, n = number_of_fields(); i < n; ++i) {
      const Vector_3d d = direction.of(control, i);
      const double along = dot(d, mean);
      least = (std::min)(least, along);
      across = (std::max)(across, squared_norm(d - along * mean));
    }
    if (!(least > 0))
      return false;
    for (std::size_t i = 0, n = number_of_values(); i < n; ++i)
      length[i] = dot(direction.of(at.fields, i), mean) + across / (2 * least);
    return true;
  }

  Element_type type_;
  Fields fields_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_QUADRATIC_CELL_H
