// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_CHAIN_LINES_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_CHAIN_LINES_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

typedef std::vector<std::size_t> Index_line;

/* Numbers points so that points closer than `epsilon` get the same number (that of the first of them). A hash grid
 * whose cells are 16 epsilon wide: nearly every point looks into one cell. */
class Point_welder {
public:
  Point_welder(const std::vector<Double_kernel::Point_3>& points, double epsilon)
      : points_(points)
      , epsilon_(epsilon) {}

  std::size_t number(std::size_t i) {
    const Double_kernel::Point_3& p = points_[i];
    const Cell low = cell(p, -epsilon_), high = cell(p, epsilon_);
    for (std::int64_t x = low[0]; x <= high[0]; ++x)
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
        for (std::int64_t z = low[2]; z <= high[2]; ++z) {
          const auto found = grid_.find(Cell{{x, y, z}});
          if (found == grid_.end())
            continue;
          for (std::size_t j : found->second)
            if (CGAL::squared_distance(points_[j], p) <= epsilon_ * epsilon_)
              return j;
        }
    grid_[cell(p, 0)].push_back(i);
    return i;
  }

private:
  typedef std::array<std::int64_t, 3> Cell;
  struct Hash {
    std::size_t operator()(const Cell& c) const {
      return std::size_t(c[0]) * 73856093u ^ std::size_t(c[1]) * 19349663u ^ std::size_t(c[2]) * 83492791u;
    }
  };

  Cell cell(const Double_kernel::Point_3& p, double shift) const {
    const double width = 16 * epsilon_;
    return Cell{{std::int64_t(std::floor((p.x() + shift) / width)), std::int64_t(std::floor((p.y() + shift) / width)),
                 std::int64_t(std::floor((p.z() + shift) / width))}};
  }

  const std::vector<Double_kernel::Point_3>& points_;
  double epsilon_;
  std::unordered_map<Cell, std::vector<std::size_t>, Hash> grid_;
};

/* Joins lines end to end: where exactly two line ends meet and the path goes on (VMTK's lines start at a common point
 * and run side by side: that is a U-turn, not a path). Ends meet if they are the same point, or coincide within
 * `epsilon`. Repeated segments count once. Deterministic; O(n log n). */
class Line_chainer {
public:
  Line_chainer(const std::vector<Double_kernel::Point_3>& points, std::vector<Index_line> lines, double epsilon)
      : points_(points)
      , lines_(std::move(lines)) {
    weld_ends(epsilon);
    drop_repeated_segments();
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      ends_[lines_[i].front()].push_back(2 * i);
      ends_[lines_[i].back()].push_back(2 * i + 1);
    }
  }

  std::vector<Index_line> chains() {
    std::vector<Index_line> result;
    used_.assign(lines_.size(), false);
    for (std::size_t i = 0; i < lines_.size(); ++i) // open chains from their ends, in the order of the lines
      for (std::size_t end : {2 * i, 2 * i + 1})
        if (!used_[i] && continuation(end) == none)
          result.push_back(chain_from(end));
    for (std::size_t i = 0; i < lines_.size(); ++i) // what is left is closed
      if (!used_[i])
        result.push_back(chain_from(2 * i));
    return result;
  }

private:
  static constexpr std::size_t none = std::size_t(-1);

  void weld_ends(double epsilon) {
    Point_welder welder(points_, epsilon);
    for (Index_line& line : lines_) {
      line.front() = welder.number(line.front());
      line.back() = welder.number(line.back());
    }
  }

  void drop_repeated_segments() {
    std::map<std::pair<std::size_t, std::size_t>, bool> seen;
    lines_.erase(std::remove_if(lines_.begin(), lines_.end(),
                                [&](const Index_line& line) {
                                  if (line.size() != 2)
                                    return false;
                                  const auto key = std::minmax(line[0], line[1]);
                                  return line[0] == line[1] || !seen.insert(std::make_pair(key, true)).second;
                                }),
                 lines_.end());
  }

  // End 2 i is the front of line i, 2 i + 1 its back.
  std::size_t point_at(std::size_t end) const { return end % 2 ? lines_[end / 2].back() : lines_[end / 2].front(); }

  // The unit direction in which the line leaves its end.
  Double_kernel::Vector_3 direction_at(std::size_t end) const {
    const Index_line& line = lines_[end / 2];
    const Double_kernel::Point_3& p = points_[point_at(end)];
    for (std::size_t k = 1; k < line.size(); ++k) {
      const Double_kernel::Vector_3 d = points_[end % 2 ? line[line.size() - 1 - k] : line[k]] - p;
      if (d.squared_length() > 0)
        return d / std::sqrt(d.squared_length());
    }
    return Double_kernel::Vector_3(0, 0, 0);
  }

  // The end at which the path goes on, if there is one.
  std::size_t continuation(std::size_t end) const {
    const std::vector<std::size_t>& here = ends_.at(point_at(end));
    if (here.size() != 2 || here[0] / 2 == here[1] / 2)
      return none;
    const double sharpest = 0.9; // cosine: the lines leave the point in the same direction
    if (direction_at(here[0]) * direction_at(here[1]) > sharpest)
      return none;
    return here[0] == end ? here[1] : here[0];
  }

  Index_line chain_from(std::size_t end) {
    Index_line chain(1, point_at(end));
    while (end != none && !used_[end / 2]) {
      const Index_line& line = lines_[end / 2];
      used_[end / 2] = true;
      if (end % 2)
        chain.insert(chain.end(), line.rbegin() + 1, line.rend());
      else
        chain.insert(chain.end(), line.begin() + 1, line.end());
      end = continuation(end ^ 1);
    }
    return chain;
  }

  const std::vector<Double_kernel::Point_3>& points_;
  std::vector<Index_line> lines_;
  std::unordered_map<std::size_t, std::vector<std::size_t>> ends_; // point → line ends there
  std::vector<bool> used_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_CHAIN_LINES_H
