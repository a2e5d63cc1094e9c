// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PRESERVING_SHIFT_HOLDER_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PRESERVING_SHIFT_HOLDER_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Shifts of points, each of which can be held back: to half of the way, a quarter, an eighth, and then to where the
 * point came from. */
class Shift_holder {
public:
  Shift_holder(std::vector<Vector_3d> from, std::vector<Vector_3d> shift)
      : from_(std::move(from))
      , shift_(std::move(shift))
      , part_(from_.size(), 1) {}

  std::size_t size() const { return from_.size(); }
  Vector_3d operator[](std::size_t i) const { return from_[i] + part_[i] * shift_[i]; }
  Point_3 point(std::size_t i) const {
    const Vector_3d p = (*this)[i];
    return Point_3(p.x, p.y, p.z);
  }
  const Vector_3d& from(std::size_t i) const { return from_[i]; }
  Vector_3d shift(std::size_t i) const { return part_[i] * shift_[i]; }

  bool is_moved(std::size_t i) const { return part_[i] > 0 && squared_norm(shift_[i]) > 0; }

  // False if it is there already.
  bool hold_back(std::size_t i) {
    if (part_[i] == 0)
      return false;
    part_[i] = part_[i] > 0.2 ? part_[i] / 2 : 0;
    return true;
  }

  void hold_all_back() { part_.assign(part_.size(), 0); }

  std::size_t number_held_back() const {
    return std::size_t(std::count_if(part_.begin(), part_.end(), [](double p) { return p < 1; }));
  }
  double largest() const {
    double result = 0;
    for (std::size_t i = 0; i < size(); ++i)
      result = (std::max)(result, norm(shift(i)));
    return result;
  }

private:
  std::vector<Vector_3d> from_, shift_;
  std::vector<double> part_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PRESERVING_SHIFT_HOLDER_H
