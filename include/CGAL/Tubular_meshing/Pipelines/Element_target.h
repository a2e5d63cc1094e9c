// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_ELEMENT_TARGET_H
#define CGAL_TUBULAR_MESHING_PIPELINES_ELEMENT_TARGET_H

#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPipelines
 *
 * Finds the number N of points per circumference with which a mesh has about a number of elements: a loop makes meshes
 * with points(), and tells of them, until add() says that it is done.
 *
 * The number of elements goes with a power of N: at first that which is given (3 for cells, 2 for faces), then that of
 * the meshes made so far. Two or three meshes are the rule.
 */
class Element_target {
public:
  static constexpr double tolerance = 0.1;
  static constexpr std::size_t most_tries = 8;

  /*! \param elements the number wanted
   * \param points the first N
   * \param power of N that the number of elements goes with
   * \throws Parameter_error if there are fewer than 10 elements wanted */
  Element_target(double elements, double points, double power)
      : wanted_(elements)
      , power_(power)
      , points_(limited(points)) {
    if (!(elements >= 10) || !(elements <= 1e10))
      throw Parameter_error("A mesh of " + std::to_string(elements) +
                            " elements cannot be made: give a number of at least 10.");
  }

  /*! The first N for a mesh of tetrahedra, or one with layers and walls of other cells beside them.
   * \param estimate of the number of tetrahedra with `points` */
  static double first_points(double elements, double points, double estimate) {
    return points * std::cbrt(elements / estimate);
  }

  /*! The first N for an anisotropic mesh: at the default layers it has about eight times as many tetrahedra, and they
   * take longer to make; so that the first one should not be the largest. */
  static double first_points_of_layers(double elements, double points, double estimate) {
    return points * std::pow(elements / (8 * estimate), 1 / power_of_layers);
  }

  static constexpr double power_of_layers = 2.3;

  /// N, to be tried next.
  double points() const { return points_; }

  /*! Whether the mesh that points() has made, of so many elements, is one of the number wanted, but for a tenth.
   * \throws Meshing_error if it is not, and no other N promises a better one */
  bool add(std::size_t elements) {
    tries_.emplace_back(points_, double((std::max)(elements, std::size_t(1))));
    if (std::abs(tries_.back().second - wanted_) <= tolerance * wanted_)
      return true;
    const double next = limited(proposed());
    if (tries_.size() == most_tries || is_tried(next))
      fail();
    points_ = next;
    return false;
  }

private:
  static double limited(double points) { return (std::min)((std::max)(points, 3.), 1e4); }

  // Between the two meshes next to the wanted number, if there are; else by the power, as it was between the last two.
  double proposed() const {
    const std::pair<double, double>*below = nullptr, *above = nullptr;
    for (const auto& t : tries_) {
      if (t.second < wanted_ && (!below || t.second > below->second))
        below = &t;
      if (t.second > wanted_ && (!above || t.second < above->second))
        above = &t;
    }
    const auto interpolated = [&](const auto& a, const auto& b) {
      const double share = std::log(wanted_ / a.second) / std::log(b.second / a.second);
      return std::exp(std::log(a.first) + share * std::log(b.first / a.first));
    };
    if (below && above)
      return tries_.size() < 5 ? interpolated(*below, *above) : std::sqrt(below->first * above->first);
    const auto& last = tries_.back();
    double power = power_;
    if (tries_.size() > 1) {
      const auto& before = tries_[tries_.size() - 2];
      power = std::log(last.second / before.second) / std::log(last.first / before.first);
    }
    if (!(power > 0.5))
      power = 0.5;
    const double step = std::pow(wanted_ / last.second, 1 / power);
    return last.first * (std::min)((std::max)(step, 0.2), 5.);
  }

  bool is_tried(double points) const {
    return std::any_of(tries_.begin(), tries_.end(),
                       [&](const auto& t) { return std::abs(t.first - points) <= 1e-3 * points; });
  }

  [[noreturn]] void fail() const {
    const auto best = std::min_element(tries_.begin(), tries_.end(), [&](const auto& a, const auto& b) {
      return std::abs(std::log(a.second / wanted_)) < std::abs(std::log(b.second / wanted_));
    });
    const auto text = [](double x) { return std::to_string((long long)(x)); };
    throw Meshing_error("A mesh of " + text(wanted_) + " elements was not found: the nearest one, with " +
                        std::to_string(best->first) + " points per circumference, has " + text(best->second) +
                        "; ask for another number, or leave the limits of the mesh size out.");
  }

  double wanted_, power_, points_;
  std::vector<std::pair<double, double>> tries_; // points, elements
};

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PIPELINES_ELEMENT_TARGET_H
