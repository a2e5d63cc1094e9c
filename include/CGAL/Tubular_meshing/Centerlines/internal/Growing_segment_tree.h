// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_GROWING_SEGMENT_TREE_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_GROWING_SEGMENT_TREE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>

#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The nearest of a growing set of segments: a row of static trees, each more than twice as large as the next (the
 * logarithmic method of Bentley and Saxe). A segment is rebuilt into a larger tree O(log n) times in all. Segments are
 * numbered in the order in which they come. */
class Growing_segment_tree {
public:
  typedef Double_kernel::Segment_3 Segment;
  typedef Nearest_tree<Segment>::Result Result;

  std::size_t size() const { return size_; }

  void insert(std::vector<Segment> batch) {
    if (batch.empty())
      return;
    size_ += batch.size();
    while (!trees_.empty() && trees_.back().size() <= 2 * batch.size()) {
      std::vector<Segment> merged;
      merged.reserve(trees_.back().size() + batch.size());
      for (std::size_t i = 0; i < trees_.back().size(); ++i)
        merged.push_back(trees_.back().shape(i));
      merged.insert(merged.end(), batch.begin(), batch.end());
      batch.swap(merged);
      trees_.pop_back();
    }
    trees_.emplace_back(std::move(batch));
  }

  /* `index` is size() if there are no segments. */
  Result nearest(const Double_kernel::Point_3& q) const {
    Result best = {size(), q, (std::numeric_limits<double>::infinity)()};
    std::size_t offset = 0;
    for (const Nearest_tree<Segment>& tree : trees_) {
      Result here = tree.nearest(q, best.squared_distance);
      if (here.index < tree.size()) {
        here.index += offset;
        best = here;
      }
      offset += tree.size();
    }
    return best;
  }

private:
  std::vector<Nearest_tree<Segment>> trees_;
  std::size_t size_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_GROWING_SEGMENT_TREE_H
