// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADRATIC_QUADRATIC_QUALITY_IMPL_H
#define CGAL_TUBULAR_MESHING_QUADRATIC_QUADRATIC_QUALITY_IMPL_H

#include <CGAL/Tubular_meshing/Quadratic/internal/Quadratic_cell.h>
#include <CGAL/Tubular_meshing/Quadratic/quadratic_quality.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

namespace internal {

inline Cell_points cell_points(const Quadratic_mesh& mesh, Element_type type, const std::uint32_t* corners,
                               std::size_t number) {
  const Element_nodes nodes = mesh.nodes(type, corners, number);
  Cell_points cell;
  cell.type = type;
  for (std::size_t i = 0; i < nodes.size; ++i)
    cell.point[i] = Vector_3d(mesh.node(nodes[i]));
  if (!mesh.is_complete) {
    cell.imply_quads();
    cell.imply_middle();
  }
  return cell;
}

constexpr std::size_t most_parts_for_one = 20000; // of a cell of which it is asked for by itself

/* Integrates over the facets of the lumen. */
class Curved_lumen_measurer {
public:
  explicit Curved_lumen_measurer(const Quadratic_mesh& mesh)
      : mesh_(mesh)
      , origin_(mesh.linear.points.empty() ? Vector_3d() : Vector_3d(mesh.linear.points.front())) {}

  void add(Element_type type, const std::uint32_t* corners, int label) {
    const Cell_points facet = cell_points(mesh_, type, corners, 0);
    static const std::array<double, 3> at = {0.112701665379258, 0.5, 0.887298334620742};
    static const std::array<double, 3> weight = {5. / 18, 8. / 18, 5. / 18}; // Gauss, exact to the fifth degree
    Vector_3d area;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        Vector_3d x, normal;
        const bool is_triangle = type == Element_type::triangle;
        is_triangle ? at_triangle(facet, at[i], at[j] * (1 - at[i]), x, normal)
                    : at_quad(facet, at[i], at[j], x, normal);
        const double w = weight[i] * weight[j] * (is_triangle ? 1 - at[i] : 1);
        sums_.volumes += w * dot(x - origin_, normal);
        area += w * normal;
        sums_.wall_area += label == labels::wall ? w * norm(normal) : 0;
      }
    if (label != labels::wall)
      sums_.openings[label] += area;
  }

  Lumen_measures measures() const { return sums_.measures(3); }

private:
  static void at_triangle(const Cell_points& t, double u, double v, Vector_3d& x, Vector_3d& normal) {
    const auto& p = t.point;
    const double w = 1 - u - v;
    x = w * (2 * w - 1) * p[0] + u * (2 * u - 1) * p[1] + v * (2 * v - 1) * p[2] + 4 * w * u * p[3] + 4 * u * v * p[4] +
        4 * v * w * p[5];
    const Vector_3d along_u = (1 - 4 * w) * p[0] + (4 * u - 1) * p[1] + 4 * (w - u) * p[3] + 4 * v * (p[4] - p[5]);
    const Vector_3d along_v = (1 - 4 * w) * p[0] + (4 * v - 1) * p[2] + 4 * (w - v) * p[5] + 4 * u * (p[4] - p[3]);
    normal = cross(along_u, along_v);
  }

  static void at_quad(const Cell_points& q, double u, double v, Vector_3d& x, Vector_3d& normal) {
    static const std::array<std::size_t, 9> order = {0, 4, 1, 7, 8, 5, 3, 6, 2}; // row by row
    const auto values = [](double t) {
      return std::array<double, 3>{(1 - t) * (1 - 2 * t), 4 * t * (1 - t), t * (2 * t - 1)};
    };
    const auto slopes = [](double t) { return std::array<double, 3>{4 * t - 3, 4 - 8 * t, 4 * t - 1}; };
    const auto a = values(u), b = values(v), da = slopes(u), db = slopes(v);
    x = Vector_3d();
    Vector_3d along_u, along_v;
    for (std::size_t i = 0; i < 9; ++i) {
      const Vector_3d& p = q.point[order[i]];
      x += a[i % 3] * b[i / 3] * p;
      along_u += da[i % 3] * b[i / 3] * p;
      along_v += a[i % 3] * db[i / 3] * p;
    }
    normal = cross(along_u, along_v);
  }

  const Quadratic_mesh& mesh_;
  const Vector_3d origin_; // near by, against cancellation
  Lumen_sums sums_;
};

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Scaled_jacobian_bounds scaled_jacobian_bounds(const Quadratic_mesh& mesh, Element_type type,
                                                                          std::size_t number, double tolerance) {
  internal::Jacobian_bounds bounds = {0, 0};
  internal::for_each_block_of_cells(mesh.linear, [&](Element_type t, const auto& block) {
    if (t == type)
      bounds = internal::Quadratic_cell(internal::cell_points(mesh, type, block.vertices[number].data(), number))
                   .scaled_jacobian(tolerance, internal::most_parts_for_one);
  });
  return {bounds.lower, bounds.upper};
}

CGAL_TUBULAR_MESHING_INLINE Quadratic_quality_report quality_report(const Quadratic_mesh& mesh, int number_of_threads) {
  const double tolerance = 0.1;
  const std::size_t most_parts = 129;
  Quadratic_quality_report report;
  std::vector<double> all;
  internal::for_each_block_of_cells(mesh.linear, [&](Element_type type, const auto& block) {
    std::vector<double> values(block.size());
    std::vector<char> state(block.size(), 0); // 1: invalid, 2: unproved
    internal::for_each_range(block.size(), number_of_threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const internal::Quadratic_cell cell(internal::cell_points(mesh, type, block.vertices[i].data(), i));
        const internal::Jacobian_bounds bounds = cell.scaled_jacobian(tolerance, most_parts);
        if (bounds.lower > 0) {
          values[i] = bounds.lower;
          continue;
        }
        values[i] = (std::min)(bounds.upper, 0.);
        const internal::Cell_validity validity = cell.validity();
        state[i] = validity == internal::Cell_validity::invalid    ? 1
                   : validity == internal::Cell_validity::unproved ? 2
                                                                   : 0;
      }
    });
    report.invalid += std::size_t(std::count(state.begin(), state.end(), 1));
    report.unproved += std::size_t(std::count(state.begin(), state.end(), 2));
    all.insert(all.end(), values.begin(), values.end());
    Measure_statistics& statistics = type == Element_type::tetrahedron ? report.tetrahedra
                                     : type == Element_type::pyramid   ? report.pyramids
                                     : type == Element_type::prism     ? report.prisms
                                                                       : report.hexahedra;
    statistics = Measure_statistics(std::move(values));
  });
  report.scaled_jacobian = Measure_statistics(std::move(all));
  return report;
}

CGAL_TUBULAR_MESHING_INLINE Lumen_measures lumen_measures(const Quadratic_mesh& mesh, std::size_t number_of_openings) {
  internal::Curved_lumen_measurer measurer(mesh);
  internal::for_each_block_of_facets(mesh.linear, [&](Element_type type, const auto& block) {
    for (std::size_t i = 0; i < block.size(); ++i)
      if (internal::bounds_lumen(block.label[i], number_of_openings))
        measurer.add(type, block.vertices[i].data(), block.label[i]);
  });
  return measurer.measures();
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_QUADRATIC_QUADRATIC_QUALITY_IMPL_H
