// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_ELEMENT_TARGET_H
#define CGAL_TUBULAR_MESHING_PIPELINES_ELEMENT_TARGET_H

#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPipelines
 *
 * Finds the number N of points per circumference with which a mesh has about a number of elements: a loop makes meshes
 * with points(), and tells of them, until add() says that it is done.
 *
 * The number of elements goes with a power of N: at first that which is given (3 for cells, 2 for faces), then that of
 * the meshes made so far. As soon as there is one mesh with fewer and one with more, the next ones are between them. The
 * number may grow with any power of N, by steps, and need not grow everywhere. With the N of first_points() one mesh is
 * the rule.
 */
class Element_target {
public:
  static constexpr double tolerance = 0.1;
  static constexpr std::size_t most_tries = 12;

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

  /*! The first N, by estimates, which are quick beside a mesh.
   * \param elements the number wanted
   * \param points some N
   * \param power of N that the number of elements goes with
   * \param expected the number of elements with an N; called last with the N that is returned */
  template <class Expected>
  static double first_points(double elements, double points, double power, const Expected& expected) {
    const int most_rounds = 6;
    const double near = 0.02;
    for (int round = 0;; ++round) {
      const double n = expected(points);
      if (round == most_rounds || !(n > 0) || std::abs(n / elements - 1) < near)
        return points;
      points = limited(points * std::pow(elements / n, 1 / power));
    }
  }

  /// Of anisotropic meshes, which have layers.
  static constexpr double power_of_layers = 2.3;

  /// N, to be tried next.
  double points() const { return points_; }

  /*! Whether the mesh that points() has made, of so many elements, is one of the number wanted, but for a tenth.
   * \throws Meshing_error if it is not, and no other N promises a better one */
  bool add(std::size_t elements) {
    const Try t = {std::log(points_), std::log(double((std::max)(elements, std::size_t(1))) / wanted_), tries_.size()};
    tries_.insert(std::upper_bound(tries_.begin(), tries_.end(), t), t);
    if (std::abs(double(elements) - wanted_) <= tolerance * wanted_)
      return true;
    const double next = limited(std::exp(proposed()));
    if (tries_.size() == most_tries || is_tried(next))
      fail();
    points_ = next;
    return false;
  }

private:
  // A mesh, by logarithms: of N, and of its elements against those wanted.
  struct Try {
    double n, excess;
    std::size_t turn; // when it was made
    bool operator<(const Try& t) const { return n < t.n; }
  };

  static constexpr double least_points = 3, most_points = 1e4;
  static double limited(double points) { return (std::min)((std::max)(points, least_points), most_points); }

  // Of two meshes whose N are neighbours, one with fewer and one with more elements than wanted: those next to the
  // number. Where a mesh has fewer than another one of a smaller N, there are several.
  std::size_t first_of_bracket() const {
    std::size_t best = tries_.size();
    const auto error = [&](std::size_t i) { return std::abs(tries_[i].excess) + std::abs(tries_[i + 1].excess); };
    for (std::size_t i = 0; i + 1 < tries_.size(); ++i)
      if ((tries_[i].excess < 0) != (tries_[i + 1].excess < 0) && (best == tries_.size() || error(i) < error(best)))
        best = i;
    return best;
  }

  double proposed() const {
    const std::size_t first = first_of_bracket();
    return first == tries_.size() ? beyond_all() : between(tries_[first], tries_[first + 1]);
  }

  /* As a power of N has it that goes through both. Where the number jumps, that comes to lie beside one of them again and
   * again: then in the middle; and it is not nearer to one of the two than an eighth of the way. */
  double between(const Try& a, const Try& b) const {
    const std::size_t older = (std::min)(a.turn, b.turn);
    const double share = a.excess / (a.excess - b.excess), least = 1. / 8;
    if (older + 2 < tries_.size())
      return (a.n + b.n) / 2;
    return a.n + (std::min)((std::max)(share, least), 1 - least) * (b.n - a.n);
  }

  /* Further than the mesh next to the number of wanted ones, with the power between it and its neighbour, so far as that
   * is likely. More elements are made with care: a mesh that is much too large takes long. */
  double beyond_all() const {
    const double least_power = 0.4, most_power = 5, finer = std::log(3.), coarser = std::log(6.);
    const bool too_many = tries_.front().excess > 0;
    const std::size_t last = tries_.size() - 1;
    const Try& nearest = tries_[too_many ? 0 : last];
    double power = power_;
    if (last > 0) {
      const Try& next = tries_[too_many ? 1 : last - 1];
      power = (next.excess - nearest.excess) / (next.n - nearest.n);
    }
    power = (std::min)((std::max)(power, least_power), most_power);
    return nearest.n + (std::min)((std::max)(-nearest.excess / power, -coarser), finer);
  }

  bool is_tried(double points) const {
    return std::any_of(tries_.begin(), tries_.end(),
                       [&](const Try& t) { return std::abs(t.n - std::log(points)) <= 1e-3; });
  }

  [[noreturn]] void fail() const {
    const auto best = std::min_element(tries_.begin(), tries_.end(), [&](const Try& a, const Try& b) {
      return std::abs(a.excess) < std::abs(b.excess);
    });
    const auto text = [](double x) { return std::to_string(std::llround(x)); };
    std::string advice = "ask for another number, or leave the limits of the mesh size out.";
    if (std::exp(best->n) <= 1.001 * least_points && best->excess > 0)
      advice = "that is the coarsest one: ask for more.";
    throw Meshing_error("A mesh of " + text(wanted_) + " elements was not found: the nearest one, with " +
                        std::to_string(std::exp(best->n)) + " points per circumference, has " +
                        text(wanted_ * std::exp(best->excess)) + "; " + advice);
  }

  double wanted_, power_, points_;
  std::vector<Try> tries_; // by N
};

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PIPELINES_ELEMENT_TARGET_H
