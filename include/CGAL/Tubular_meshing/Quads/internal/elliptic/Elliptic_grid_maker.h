// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_INTERNAL_ELLIPTIC_ELLIPTIC_GRID_MAKER_H
#define CGAL_TUBULAR_MESHING_QUADS_INTERNAL_ELLIPTIC_ELLIPTIC_GRID_MAKER_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Quads/internal/elliptic/Annular_chart.h>
#include <CGAL/Tubular_meshing/Quads/internal/elliptic/Winslow_smoother.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Makes the grid of an annular patch, in the coordinates of its chart. */
class Elliptic_grid_maker {
public:
  typedef Annular_chart Chart;
  typedef std::array<std::vector<Patch_location>, 2> Loop_points;

  Elliptic_grid_maker(const Patch_parameterization& map, const Loop_points& ends)
      : chart_(map)
      , ends_(ends)
      , columns_(ends[0].size()) {
    if (!chart_.is_unrolled())
      throw Meshing_error("The hole of an annular patch of " + std::to_string(map.number_of_triangles()) +
                          " triangles winds so much in the plane that it has no middle; cut the patch once more (see "
                          "cut_by_centerlines()).");
    std::reverse(ends_[1].begin() + 1, ends_[1].end());
    for (std::size_t l = 0; l < 2; ++l) {
      row_[l] = chart_.row(ends_[l]);
      check_order(l);
    }
    match_rows();
  }

  /* Rows as many and as high as a size wants on the mean. */
  void divide_into_rows(Length_function size, std::size_t rows) {
    const std::size_t lines = (std::min)(columns_, std::size_t(12)), steps = 256;
    std::vector<double> heights(steps + 1, 0.);
    for (std::size_t l = 0; l < lines; ++l) {
      const std::size_t i = l * columns_ / lines;
      int hint = -1;
      Vector_3d last = vector_at(between(i, 0), hint);
      for (std::size_t k = 1; k <= steps; ++k) {
        const Vector_3d p = vector_at(between(i, double(k) / double(steps)), hint);
        heights[k] += norm(p - last) / (double(lines) * size(as<Point_3>(0.5 * (last + p))));
        last = p;
      }
    }
    for (std::size_t k = 0; k < steps; ++k)
      heights[k + 1] += heights[k];
    set_rows(heights, rows > 0 ? rows : (std::max)(std::size_t(1), std::size_t(std::lround(heights.back()))));
  }

  /* From the straight grid, with smaller and smaller steps until no cell is folded; over-relaxed ones first, as waves as
   * long as the grid die slowly. */
  void smooth() {
    const Ring_nodes straight = nodes_;
    for (double part = 1.5; part > 0.2; part /= 2) {
      nodes_ = straight;
      if (smooth(part))
        break;
    }
    if (!(best_score_ > 0))
      throw Meshing_error("The grid of " + std::to_string(columns_) + " columns and " + std::to_string(nodes_.rows) +
                          " rows on an annular patch has folded cells near " + place_of(folded_at_) +
                          "; take smaller sizes there, or more points on its loops.");
  }

  const Ring_nodes& nodes() const { return best_; }
  const std::vector<Patch_location>& locations() const { return best_locations_; }
  /* The first node of row 0 is the first point of loop 0; column i ends at this point of loop 1. */
  std::size_t point_of_loop_1(std::size_t i) const { return (columns_ - (i + shift_) % columns_) % columns_; }

private:
  static constexpr std::size_t sweeps = 24, most_sweeps = 50; // while cells are folded, the latter

  void check_order(std::size_t l) const {
    const std::vector<Eigen::Vector2d>& row = row_[l];
    for (std::size_t i = 0; i < columns_; ++i)
      if (!((i + 1 < columns_ ? row[i + 1].x() : row[0].x() + Chart::period) > row[i].x()))
        throw Input_error("Point " + std::to_string(l == 0 ? i : columns_ - i) + " of loop " + std::to_string(l) +
                          " of an annular patch and the next one are not in the order of the loop.");
  }

  // Which point of loop 1 comes after how many on which column: where columns turn least.
  void match_rows() {
    double least = (std::numeric_limits<double>::max)(), turns = 0;
    for (std::size_t k = 0; k < columns_; ++k) {
      double sum = 0, squares = 0;
      for (std::size_t i = 0; i < columns_; ++i)
        sum += end_of(i, k).x() - row_[0][i].x();
      const double whole = Chart::period * std::round(sum / double(columns_) / Chart::period);
      for (std::size_t i = 0; i < columns_; ++i) {
        const double d = end_of(i, k).x() - row_[0][i].x() - whole;
        squares += d * d;
      }
      if (squares < least) {
        least = squares;
        shift_ = k;
        turns = whole;
      }
    }
    std::vector<Eigen::Vector2d> matched;
    std::vector<Patch_location> locations;
    for (std::size_t i = 0; i < columns_; ++i) {
      matched.push_back(end_of(i, shift_) - Eigen::Vector2d(turns, 0));
      locations.push_back(ends_[1][(i + shift_) % columns_]);
    }
    row_[1] = matched;
    ends_[1] = locations;
  }
  Eigen::Vector2d end_of(std::size_t i, std::size_t k) const {
    const std::size_t m = i + k;
    return m < columns_ ? row_[1][m] : Eigen::Vector2d(row_[1][m - columns_] + Eigen::Vector2d(Chart::period, 0));
  }

  Eigen::Vector2d between(std::size_t i, double t) const { return (1 - t) * row_[0][i] + t * row_[1][i]; }
  Vector_3d vector_at(const Eigen::Vector2d& w, int& hint) const {
    const Patch_location at = chart_.locate(w, hint);
    hint = at.triangle;
    return Vector_3d(chart_.map().point(at));
  }

  void set_rows(const std::vector<double>& heights, std::size_t rows) {
    nodes_.columns = columns_;
    nodes_.rows = rows;
    nodes_.period = Chart::period;
    nodes_.places.clear();
    for (std::size_t j = 0; j <= rows; ++j) {
      const double wanted = heights.back() * double(j) / double(rows);
      std::size_t k = std::size_t(std::lower_bound(heights.begin(), heights.end(), wanted) - heights.begin());
      k = (std::min)((std::max)(k, std::size_t(1)), heights.size() - 1);
      const double part = (wanted - heights[k - 1]) / (heights[k] - heights[k - 1]);
      const double t = j == rows ? 1 : (double(k - 1) + part) / double(heights.size() - 1);
      for (std::size_t i = 0; i < columns_; ++i)
        nodes_.places.push_back(between(i, t));
    }
  }

  void place_on_surface() {
    locations_.resize(nodes_.places.size());
    points_.resize(nodes_.places.size());
    std::copy(ends_[0].begin(), ends_[0].end(), locations_.begin());
    std::copy(ends_[1].begin(), ends_[1].end(), locations_.end() - std::ptrdiff_t(columns_));
    for (std::size_t n = columns_; n < nodes_.places.size() - columns_; ++n)
      locations_[n] = chart_.locate(nodes_.places[n], locations_[n - columns_].triangle);
    for (std::size_t n = 0; n < points_.size(); ++n)
      points_[n] = Vector_3d(chart_.map().point(locations_[n]));
  }

  // The corners of cell (i, j), as Winslow_smoother numbers them.
  std::array<Vector_3d, 4> corners(std::size_t i, std::size_t j) const {
    const std::size_t a = j * columns_ + i, b = j * columns_ + (i + 1) % columns_;
    return {{points_[a], points_[b], points_[b + columns_], points_[a + columns_]}};
  }

  // At each corner of a cell, the metric in which its sides have the lengths and the angle that they have in space.
  void update_metrics(Winslow_smoother& smoother) const {
    for (std::size_t j = 0; j < nodes_.rows; ++j)
      for (std::size_t i = 0; i < columns_; ++i) {
        const std::array<Vector_3d, 4> p = corners(i, j);
        for (std::size_t k = 0; k < 4; ++k) {
          const Vector_3d a = k < 2 ? p[1] - p[0] : p[2] - p[3], b = k == 1 || k == 2 ? p[2] - p[1] : p[3] - p[0];
          const auto sides = smoother.corner(i, j, k);
          Eigen::Matrix2d plane, space;
          plane << sides.a, sides.b;
          space << dot(a, a), dot(a, b), dot(a, b), dot(b, b);
          if (!(space.determinant() > 1e-6 * dot(a, a) * dot(b, b)) || !(plane.determinant() > 0))
            continue; // as it was
          const Eigen::Matrix2d inverse = plane.inverse(), metric = inverse.transpose() * space * inverse;
          smoother.cell(i, j).metric[k] = metric / std::sqrt(metric.determinant());
        }
      }
  }
  void set_shapes(Winslow_smoother& smoother) const {
    for (std::size_t j = 0; j < nodes_.rows; ++j)
      for (std::size_t i = 0; i < columns_; ++i) {
        const std::array<Vector_3d, 4> p = corners(i, j);
        const double width = norm(p[1] - p[0] + p[2] - p[3]), height = norm(p[3] - p[0] + p[2] - p[1]);
        if (width > 0 && height > 0)
          smoother.cell(i, j).beta = height / width;
      }
  }

  // False if cells are folded in the end.
  bool smooth(double part) {
    const double small = 2e-3;
    Winslow_smoother smoother(nodes_);
    place_on_surface();
    set_shapes(smoother);
    bool valid = keep_if_better(smoother);
    for (std::size_t k = 0; k < most_sweeps; ++k) {
      update_metrics(smoother);
      const double greatest = smoother.sweep(part);
      place_on_surface();
      valid = keep_if_better(smoother);
      if (valid && (greatest < small || k + 1 >= sweeps))
        break;
    }
    return valid;
  }

  // By the least and the mean (14) on the surface. False if a cell is folded.
  bool keep_if_better(const Winslow_smoother& smoother) {
    double least = smoother.least_corner() > 0 ? 1 : 0, sum = 0;
    for (std::size_t j = 0; j < nodes_.rows; ++j)
      for (std::size_t i = 0; i < columns_; ++i) {
        const double eta = unfolded_eta(corners(i, j));
        if (!(eta > 0))
          folded_at_ = corners(i, j)[0];
        least = (std::min)(least, eta);
        sum += eta;
      }
    const double score = least > 0 ? least + sum / double(nodes_.number_of_cells()) : 0;
    if (score > best_score_) {
      best_score_ = score;
      best_ = nodes_;
      best_locations_ = locations_;
    }
    return score > 0;
  }

  // (14), 0 if a corner turns the other way.
  static double unfolded_eta(const std::array<Vector_3d, 4>& p) {
    const Vector_3d normal = cross(p[2] - p[0], p[3] - p[1]);
    for (std::size_t k = 0; k < 4; ++k)
      if (!(dot(cross(p[(k + 1) % 4] - p[k], p[(k + 3) % 4] - p[k]), normal) > 0))
        return 0;
    return quad_eta(p);
  }

  const Chart chart_;
  Loop_points ends_; // both in the direction of loop 0, those of loop 1 beginning at the end of column 0
  const std::size_t columns_;
  std::array<std::vector<Eigen::Vector2d>, 2> row_;
  std::size_t shift_ = 0;
  Ring_nodes nodes_, best_;
  std::vector<Patch_location> locations_, best_locations_;
  std::vector<Vector_3d> points_; // of the nodes as they are
  double best_score_ = 0;
  Vector_3d folded_at_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADS_INTERNAL_ELLIPTIC_ELLIPTIC_GRID_MAKER_H
