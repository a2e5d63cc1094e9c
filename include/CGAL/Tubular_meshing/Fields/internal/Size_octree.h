// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_SIZE_OCTREE_H
#define CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_SIZE_OCTREE_H

#include <CGAL/Tubular_meshing/internal/parallel.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* A positive function on space, sampled at the corners of an octree that is as fine as the function asks for, limited
 * in its growth, and interpolated. A query costs a descent through the tree (about 0.1 µs) instead of a search for the
 * nearest wall and the nearest centerline (about 5 µs), which is what makes it fit for a mesher's inner loop.
 *
 * Building: O(n log n) in the number n of leaves, each corner sampled once.
 */
class Size_octree {
public:
  typedef std::array<double, 3> Position;

  /* What the function says at a position: its value, how far away the domain is (0 inside; only there is the value
   * asked for), and how wide a leaf may be that represents it. */
  struct Sample {
    double size;
    double distance_to_domain;
    double leaf_width;
  };

  Size_octree() = default;

  /* `sample(Position) -> Sample`, safe to call from several threads; a leaf that touches the domain is no wider
   * than the sample at its center allows; |size(x) - size(y)| <= slope |x - y| along the tree's edges. */
  template <class Function> Size_octree(const Bbox_3& box, const Function& sample, double slope, int threads) {
    const double dx = box.xmax() - box.xmin(), dy = box.ymax() - box.ymin(), dz = box.zmax() - box.zmin();
    edge_ = (std::max)({dx, dy, dz}) * 1.0625;
    origin_ = {(box.xmin() + box.xmax() - edge_) / 2, (box.ymin() + box.ymax() - edge_) / 2,
               (box.zmin() + box.zmax() - edge_) / 2};
    refine(sample, threads);
    sample_corners(sample, threads);
    limit_growth(slope);
  }

  double operator()(double x, double y, double z) const {
    const Cell_position at = locate(x, y, z);
    const Node& leaf = nodes_[at.node];
    const double w = double(1u << (max_depth - leaf.depth));
    const double u = at.local[0] / w, v = at.local[1] / w, t = at.local[2] / w;
    const std::uint32_t* c = &leaf_corners_[8 * leaf.first];
    const auto along_x = [&](int i) { return values_[c[i]] + u * (values_[c[i + 1]] - values_[c[i]]); };
    const double y0 = along_x(0) + v * (along_x(2) - along_x(0));
    const double y1 = along_x(4) + v * (along_x(6) - along_x(4));
    return y0 + t * (y1 - y0);
  }

  /* The integral of 1 / size³ over the leaves whose center lies in the domain. */
  double number_of_cubes() const {
    double sum = 0;
    for (const auto& leaf : leaves_in_domain_) {
      double size = 0;
      for (int c = 0; c < 8; ++c)
        size += values_[leaf_corners_[8 * std::size_t(leaf.first) + c]] / 8;
      sum += std::pow(leaf.second / size, 3);
    }
    return sum;
  }

  std::size_t number_of_leaves() const { return leaf_corners_.size() / 8; }
  std::size_t number_of_samples() const { return values_.size(); }

private:
  static constexpr int max_depth = 20; // corners have 21-bit coordinates: three fit into a 64-bit key

  struct Node {
    std::uint32_t first; // first of eight children; for a leaf, its number
    std::uint8_t depth;
    bool is_leaf;
  };
  struct Cell_position {
    std::uint32_t node;
    std::array<double, 3> local; // in lattice units from the leaf's lower corner
  };
  typedef std::array<std::uint32_t, 3> Lattice_point;

  Position position(const std::array<double, 3>& lattice) const {
    const double s = edge_ / double(1u << max_depth);
    return {origin_[0] + s * lattice[0], origin_[1] + s * lattice[1], origin_[2] + s * lattice[2]};
  }

  Cell_position locate(double x, double y, double z) const {
    const double side = double(1u << max_depth), scale = side / edge_;
    const auto to_lattice = [&](double c, double o) { return (std::min)((std::max)((c - o) * scale, 0.), side - 0.5); };
    std::array<double, 3> p = {to_lattice(x, origin_[0]), to_lattice(y, origin_[1]), to_lattice(z, origin_[2])};
    const std::array<std::uint32_t, 3> i = {std::uint32_t(p[0]), std::uint32_t(p[1]), std::uint32_t(p[2])};
    std::uint32_t n = 0;
    int bit = max_depth;
    while (!nodes_[n].is_leaf) {
      --bit;
      n = nodes_[n].first + (((i[0] >> bit) & 1u) | (((i[1] >> bit) & 1u) << 1) | (((i[2] >> bit) & 1u) << 2));
    }
    const std::uint32_t mask = ~((1u << bit) - 1u);
    for (int k = 0; k < 3; ++k)
      p[k] -= double(i[k] & mask);
    return {n, p};
  }

  // Level by level, so that the samples of a level can be taken in parallel.
  template <class Function> void refine(const Function& sample, int threads) {
    std::vector<Lattice_point> lower = {{0, 0, 0}}; // corner of each node
    std::vector<Sample> samples;
    nodes_.push_back({0, 0, true});
    for (std::size_t begin = 0, depth = 0; begin < nodes_.size(); ++depth) {
      const std::size_t end = nodes_.size();
      const std::uint32_t width = 1u << (max_depth - depth);
      const double edge = edge_ / double(1u << depth), half = width / 2.;
      samples.resize(end - begin);
      for_each_range(end - begin, threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) {
          const Lattice_point& l = lower[begin + k];
          samples[k] = sample(position({l[0] + half, l[1] + half, l[2] + half}));
        }
      });
      for (std::size_t n = begin; n < end; ++n) {
        const Sample& s = samples[n - begin];
        const bool may_touch_domain = s.distance_to_domain <= 0.87 * edge; // half the diagonal
        if (depth + 1 < max_depth && may_touch_domain && edge > s.leaf_width)
          split(n, width / 2, lower);
        else {
          nodes_[n].first = std::uint32_t(leaf_lower_.size());
          if (s.distance_to_domain == 0)
            leaves_in_domain_.emplace_back(nodes_[n].first, edge);
          leaf_lower_.push_back({lower[n], width});
        }
      }
      begin = end;
    }
  }

  void split(std::size_t n, std::uint32_t width, std::vector<Lattice_point>& lower) {
    nodes_[n].is_leaf = false;
    nodes_[n].first = std::uint32_t(nodes_.size());
    const std::uint8_t depth = std::uint8_t(nodes_[n].depth + 1);
    const Lattice_point l = lower[n];
    for (std::uint32_t c = 0; c < 8; ++c) {
      nodes_.push_back({0, depth, true});
      lower.push_back(corner(l, width, c));
    }
  }

  static Lattice_point corner(const Lattice_point& l, std::uint32_t width, std::uint32_t c) {
    return {l[0] + (c & 1u) * width, l[1] + ((c >> 1) & 1u) * width, l[2] + ((c >> 2) & 1u) * width};
  }

  template <class Function> void sample_corners(const Function& sample, int threads) {
    std::unordered_map<std::uint64_t, std::uint32_t> index;
    index.reserve(2 * leaf_lower_.size());
    leaf_corners_.reserve(8 * leaf_lower_.size());
    for (const auto& leaf : leaf_lower_)
      for (std::uint32_t c = 0; c < 8; ++c) {
        const Lattice_point p = corner(leaf.first, leaf.second, c);
        const std::uint64_t key = (std::uint64_t(p[0]) << 42) | (std::uint64_t(p[1]) << 21) | p[2];
        const auto inserted = index.emplace(key, std::uint32_t(corners_.size()));
        if (inserted.second)
          corners_.push_back(p);
        leaf_corners_.push_back(inserted.first->second);
      }
    values_.resize(corners_.size());
    for_each_range(corners_.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        values_[i] = sample(position({double(corners_[i][0]), double(corners_[i][1]), double(corners_[i][2])})).size;
    });
  }

  // The leaves at each corner, in one array: those of corner i are from first[i] to first[i + 1].
  struct Leaves_of_corners {
    std::vector<std::uint32_t> first, leaves;
  };

  Leaves_of_corners leaves_of_corners() const {
    Leaves_of_corners result;
    result.first.assign(corners_.size() + 1, 0);
    for (std::uint32_t corner : leaf_corners_)
      ++result.first[corner + 1];
    std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
    std::vector<std::uint32_t> next(result.first.begin(), result.first.end() - 1);
    result.leaves.resize(leaf_corners_.size());
    for (std::size_t i = 0; i < leaf_corners_.size(); ++i)
      result.leaves[next[leaf_corners_[i]]++] = std::uint32_t(i / 8);
    return result;
  }

  // Calls lower(q, bound) for each neighbour q of a corner whose value is above what the corner's value allows.
  template <class Lower>
  void for_each_too_large(std::uint32_t corner, double slope, const Leaves_of_corners& around, const Lower& lower) {
    const double unit = edge_ / double(1u << max_depth), value = values_[corner];
    for (std::uint32_t k = around.first[corner]; k < around.first[corner + 1]; ++k)
      for (int c = 0; c < 8; ++c) {
        const std::uint32_t q = leaf_corners_[8 * std::size_t(around.leaves[k]) + c];
        if (!(value < values_[q]))
          continue;
        const double bound = value + slope * unit * lattice_distance(corners_[corner], corners_[q]);
        if (bound < values_[q])
          lower(q, bound);
      }
  }

  // Dijkstra's algorithm from all corners that limit a neighbour: the smallest sizes spread first.
  void limit_growth(double slope) {
    const Leaves_of_corners around = leaves_of_corners();
    typedef std::pair<double, std::uint32_t> Entry;
    std::vector<Entry> initial;
    for (std::uint32_t i = 0; i < values_.size(); ++i) {
      bool limits = false;
      for_each_too_large(i, slope, around, [&](std::uint32_t, double) { limits = true; });
      if (limits)
        initial.emplace_back(values_[i], i);
    }
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue(std::greater<Entry>(),
                                                                              std::move(initial));
    while (!queue.empty()) {
      const Entry e = queue.top();
      queue.pop();
      if (e.first > values_[e.second])
        continue;
      for_each_too_large(e.second, slope, around, [&](std::uint32_t q, double bound) {
        values_[q] = bound;
        queue.emplace(bound, q);
      });
    }
    corners_ = std::vector<Lattice_point>();
    leaf_lower_ = std::vector<std::pair<Lattice_point, std::uint32_t>>();
  }

  static double lattice_distance(const Lattice_point& a, const Lattice_point& b) {
    const double x = double(a[0]) - b[0], y = double(a[1]) - b[1], z = double(a[2]) - b[2];
    return std::sqrt(x * x + y * y + z * z);
  }

  Position origin_ = {0, 0, 0};
  double edge_ = 1;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> leaf_corners_;                        // eight a leaf, x fastest
  std::vector<double> values_;                                     // one a corner
  std::vector<std::pair<std::uint32_t, double>> leaves_in_domain_; // by their centers, and their edges

  // of use while building only
  std::vector<std::pair<Lattice_point, std::uint32_t>> leaf_lower_;
  std::vector<Lattice_point> corners_;
};

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_SIZE_OCTREE_H
