// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LOCATED_TRIANGLES_H
#define CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LOCATED_TRIANGLES_H

#include <CGAL/Tubular_meshing/Layers/Wall_array.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Finds the nearest point of triangles, and where in its triangle it is. O(log n) a query. */
class Located_triangles {
public:
  struct Place {
    std::size_t triangle;
    std::array<double, 3> weights; // of the corners; the sum is 1
  };

  explicit Located_triangles(const Wall_array& array)
      : triangles_(array.triangles) {
    std::vector<Double_kernel::Triangle_3> shapes;
    for (const auto& t : triangles_)
      shapes.emplace_back(to_double_point(array.points[t[0]]), to_double_point(array.points[t[1]]),
                          to_double_point(array.points[t[2]]));
    if (shapes.empty())
      throw Input_error("The array \"" + array.name + "\" has no values on the wall.");
    tree_ = Nearest_tree<Double_kernel::Triangle_3>(std::move(shapes));
  }

  Place operator()(const Point_3& p) const {
    const auto found = tree_.nearest(to_double_point(p));
    const std::size_t i = found.index < tree_.size() ? found.index : 0;
    const Double_kernel::Triangle_3& t = tree_.shape(i);
    const auto area = [&](const auto& a, const auto& b) {
      return std::sqrt(CGAL::cross_product(a - found.point, b - found.point).squared_length());
    };
    Place place = {i, {area(t[1], t[2]), area(t[2], t[0]), area(t[0], t[1])}};
    const double sum = place.weights[0] + place.weights[1] + place.weights[2];
    for (double& w : place.weights)
      w = sum > 0 ? w / sum : 1. / 3;
    return place;
  }

  const std::array<std::size_t, 3>& corners(std::size_t triangle) const { return triangles_[triangle]; }

private:
  std::vector<std::array<std::size_t, 3>> triangles_;
  Nearest_tree<Double_kernel::Triangle_3> tree_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LOCATED_TRIANGLES_H
