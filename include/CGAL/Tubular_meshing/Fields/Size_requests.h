// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_SIZE_REQUESTS_H
#define CGAL_TUBULAR_MESHING_FIELDS_SIZE_REQUESTS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingFields
 *
 * What a user wants of the mesh size beside N points round each vessel: finer or coarser places, branches, and sizes
 * given on the surface. Where several apply, given sizes take the place of 2 π r / N first, and all factors divide
 * them; limits of the size and the gradation come after, so that sizes pass over to those around.
 */
struct Size_requests {
  /// Sizes in a ball are divided by the factor, above 0 and at most 100; by one below 1 they become larger.
  struct Ball {
    Point_3 center;
    double radius = 0, factor = 1;
  };
  /// Sizes in a branch of the centerlines, by its index, likewise.
  struct Branch {
    std::size_t branch = 0;
    double factor = 1;
  };
  /// A triangle of the surface, and the sizes at its corners, linear in between. Sizes that are not above 0, or not
  /// finite, are none: there it is 2 π r / N.
  struct Sized_triangle {
    std::array<Point_3, 3> corners;
    std::array<double, 3> sizes;
  };

  std::vector<Ball> balls;
  std::vector<Branch> branches;
  std::vector<Sized_triangle> surface; ///< sizes inside the lumen are those of its nearest point

  bool empty() const { return balls.empty() && branches.empty() && surface.empty(); }
};

/*! \ingroup PkgTubularMeshingFields
 * The sizes at the points of a surface as a request.
 * \param points, triangles the surface
 * \param sizes one a point */
inline void request_sizes(const std::vector<Point_3>& points, const std::vector<std::array<std::size_t, 3>>& triangles,
                          const std::vector<double>& sizes, Size_requests& requests) {
  for (const auto& t : triangles)
    requests.surface.push_back({{points[t[0]], points[t[1]], points[t[2]]}, {sizes[t[0]], sizes[t[1]], sizes[t[2]]}});
}

namespace internal {

/* The requests as a function, made ready for fast queries in O(n log n). */
class Requested_sizes {
public:
  /* \throws Parameter_error if a factor or a radius is out of its range */
  explicit Requested_sizes(const Size_requests& requests)
      : requests_(requests) {
    for (const Size_requests::Ball& b : requests.balls) {
      check_factor(b.factor);
      if (!(b.radius > 0) || !std::isfinite(b.radius))
        throw Parameter_error("A ball in which the mesh is to be refined has a radius that is not above 0.");
    }
    for (const Size_requests::Branch& b : requests.branches) {
      check_factor(b.factor);
      factor_of_branch_.emplace(b.branch, 1.).first->second *= b.factor;
    }
    std::vector<Double_kernel::Triangle_3> triangles;
    for (const auto& t : requests.surface)
      triangles.emplace_back(to_double_point(t.corners[0]), to_double_point(t.corners[1]),
                             to_double_point(t.corners[2]));
    if (!triangles.empty())
      tree_ = Nearest_tree<Double_kernel::Triangle_3>(std::move(triangles));
  }

  /* What the size `h` at a point becomes; `on_wall` is the nearest point of the wall. Safe from several threads. */
  double operator()(const Point_3& p, const Point_3& on_wall, std::size_t branch, double h) const {
    if (!tree_.empty())
      h = size_on_surface(on_wall, h);
    const auto of_branch = factor_of_branch_.find(branch);
    if (of_branch != factor_of_branch_.end())
      h /= of_branch->second;
    for (const Size_requests::Ball& b : requests_.balls)
      if (squared_distance(p, b.center) <= b.radius * b.radius)
        h /= b.factor;
    return h;
  }

  /* How wide a cell that the size is sampled in may be, whose center is p: no ball slips through, and sizes given on
   * the surface are seen as they vary. */
  double width(const Point_3& p, double width, double size) const {
    for (const Size_requests::Ball& b : requests_.balls)
      width = (std::min)(width, (std::max)(b.radius / 2, std::sqrt(squared_distance(p, b.center)) - b.radius));
    return tree_.empty() ? width : (std::min)(width, 4 * size);
  }

private:
  static void check_factor(double factor) {
    if (!(factor > 0 && factor <= 100))
      throw Parameter_error("The factor of a refinement is " + std::to_string(factor) +
                            ": give the number that mesh sizes are divided by, above 0 and at most 100.");
  }

  double size_on_surface(const Point_3& on_wall, double otherwise) const {
    const auto found = tree_.nearest(to_double_point(on_wall));
    if (found.index >= tree_.size())
      return otherwise;
    const Double_kernel::Triangle_3& t = tree_.shape(found.index);
    const auto& sizes = requests_.surface[found.index].sizes;
    const auto area = [&](const auto& a, const auto& b) {
      return std::sqrt(CGAL::cross_product(a - found.point, b - found.point).squared_length());
    };
    const std::array<double, 3> weights = {area(t[1], t[2]), area(t[2], t[0]), area(t[0], t[1])};
    double sum = 0, total = 0;
    for (std::size_t i = 0; i < 3; ++i)
      if (sizes[i] > 0 && std::isfinite(sizes[i])) {
        sum += weights[i] * sizes[i];
        total += weights[i];
      }
    return total > 0 ? sum / total : otherwise;
  }

  Size_requests requests_;
  std::map<std::size_t, double> factor_of_branch_;
  Nearest_tree<Double_kernel::Triangle_3> tree_;
};

} // namespace internal
} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_FIELDS_SIZE_REQUESTS_H
