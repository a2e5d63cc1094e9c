// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LAYER_LEVELS_H
#define CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LAYER_LEVELS_H

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Where the sides of layers are between a surface, 0, and the far side of the last one, 1: the same at all vertices, or,
 * of two walls whose thicknesses are in no fixed ratio, of each wall the same in its part of the whole. */
class Layer_levels {
public:
  Layer_levels() = default;
  Layer_levels(std::vector<double> levels)
      : levels_(std::move(levels)) {}

  /* \param inner, outer of each wall from 0 to 1
   * \param shares of the inner wall in the whole, one a vertex */
  Layer_levels(const std::vector<double>& inner, const std::vector<double>& outer, std::vector<double> shares)
      : levels_(inner)
      , split_(inner.size() - 1)
      , shares_(std::move(shares)) {
    levels_.insert(levels_.end(), outer.begin() + 1, outer.end());
  }

  std::size_t size() const { return levels_.size(); }

  double operator()(std::uint32_t v, std::size_t k) const {
    if (shares_.empty())
      return levels_[k];
    const double share = shares_[v];
    return k <= split_ ? share * levels_[k] : share + (1 - share) * levels_[k];
  }

private:
  std::vector<double> levels_;
  std::size_t split_ = 0;
  std::vector<double> shares_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LAYER_LEVELS_H
