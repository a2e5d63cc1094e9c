// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_INTERNAL_ANNULAR_CURVE_CHAINS_H
#define CGAL_TUBULAR_MESHING_QUADS_INTERNAL_ANNULAR_CURVE_CHAINS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/Quads/internal/elliptic/Annular_chart.h>
#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Curve_divider.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Curve_gaps.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Divides the curves of a cut surface for grids: those that annular patches join, one after another, form a chain and
 * get the same even number of points, at equal distances unless another curve is close, and turned so that the grids
 * between them do not twist. */
class Curve_chains {
public:
  typedef Patch_parameterization Map;
  typedef std::vector<Curve_position> Points;

  Curve_chains(const Surface& surface, const Surface_cut& cut, const std::vector<Map>& maps, Length_function size)
      : cut_(cut)
      , maps_(maps)
      , patches_at_(cut.curves.size()) {
    for (const auto& curve : cut.curves)
      measure(surface, curve, size);
    set_distances();
    for (size_type k = 0; k < cut.patches.size(); ++k)
      if (is_tube(k))
        for (const Patch_loop& loop : cut.patches[k].loops)
          patches_at_[loop.curve].push_back(k);
  }

  /* The points of all curves. `fineness`, if given, is what the size is multiplied by, of each curve: that of a chain
   * is the least one. */
  std::vector<Points> divide(const std::vector<double>& fineness = {}) const {
    std::vector<Points> points(polylines_.size());
    std::vector<char> reached(polylines_.size(), 0);
    for (size_type c = 0; c < points.size(); ++c)
      if (!reached[c])
        divide_chain(chain_from(c, reached), fineness, points);
    return points;
  }

  bool is_tube(size_type k) const {
    const auto& loops = cut_.patches[k].loops;
    return loops.size() == 2 && loops[0].curve != loops[1].curve && maps_[k].number_of_loops() == 2;
  }

  /* The points of a tube's curves on its two loops, each in the order of its loop. */
  std::array<std::vector<Patch_location>, 2> on_loops(size_type k, const std::vector<Points>& points) const {
    const auto& loops = cut_.patches[k].loops;
    return {on_loop(k, 0, points[loops[0].curve]), on_loop(k, 1, points[loops[1].curve])};
  }

private:
  static constexpr size_type none = static_cast<size_type>(-1);
  struct Link {
    size_type curve, patch, before; // `before` is a curve of the chain that is divided earlier, none for the first
  };

  // What the size wants all along a curve.
  void measure(const Surface& surface, const Cut_curve& curve, Length_function size) {
    polylines_.emplace_back();
    std::vector<Point_3>& polyline = polylines_.back();
    for (auto v : curve.vertices)
      polyline.push_back(surface.point(v));
    double in_sizes = 0, length = 0;
    for (size_type i = 0; i < polyline.size(); ++i) {
      const Vector_3d a(polyline[i]), b(polyline[(i + 1) % polyline.size()]), middle = 0.5 * (a + b);
      length += norm(b - a);
      in_sizes += norm(b - a) / size(as<Point_3>(middle));
    }
    in_sizes_.push_back(in_sizes);
    lengths_.push_back(length);
  }

  // The distances on a curve are equal, but where another one of its patch comes close.
  void set_distances() {
    const double least = 0.3, of_gap = 1.5;
    const Curve_gaps gaps(cut_, polylines_);
    for (size_type c = 0; c < polylines_.size(); ++c) {
      const double h = lengths_[c] / in_sizes_[c];
      const auto distance = [&](const Curve_position& at) {
        return (std::max)(least * h, of_gap * gaps.gap(c, at.point, h / of_gap));
      };
      dividers_.emplace_back(polylines_[c], distance, false);
    }
  }

  std::vector<Link> chain_from(size_type c, std::vector<char>& reached) const {
    std::vector<Link> chain(1, {c, none, none});
    reached[c] = 1;
    for (size_type i = 0; i < chain.size(); ++i)
      for (size_type k : patches_at_[chain[i].curve]) {
        const auto& loops = cut_.patches[k].loops;
        const size_type other = loops[loops[0].curve == chain[i].curve ? 1 : 0].curve;
        if (!reached[other]) {
          reached[other] = 1;
          chain.push_back({other, k, chain[i].curve});
        }
      }
    return chain;
  }

  void divide_chain(const std::vector<Link>& chain, const std::vector<double>& fineness,
                    std::vector<Points>& points) const {
    const size_type fewest = 6; // a tube, not a prism
    double sum = 0, finest = 1;
    for (const Link& link : chain) {
      sum += in_sizes_[link.curve];
      finest = fineness.empty() ? 1 : (std::min)(finest, fineness[link.curve]);
    }
    const size_type n = (std::max)(fewest, 2 * size_type(std::lround(sum / double(chain.size()) / finest / 2)));
    for (const Link& link : chain) {
      const double start = link.before == none ? 0 : best_start(link, n, points[link.before]);
      points[link.curve] = points_from(link.curve, n, start);
    }
  }

  // The first of n points at a part of their distance.
  Points points_from(size_type c, size_type n, double start) const {
    return dividers_[c].divide_equally(polylines_[c], n, start);
  }

  std::vector<Patch_location> on_loop(size_type k, size_type l, const Points& points) const {
    const Patch_loop& loop = cut_.patches[k].loops[l];
    return internal::on_loop(maps_[k], l, loop, polylines_[loop.curve].size(), points);
  }

  // The mean place around the patch of points of one of its loops.
  double mean_angle(const Annular_chart& chart, size_type k, size_type c, const Points& points) const {
    double sum = 0;
    for (const auto& w : chart.row(on_loop(k, cut_.patches[k].loops[0].curve == c ? 0 : 1, points)))
      sum += w.x();
    return sum / double(points.size());
  }

  /* By which part of a distance the points of a curve must be moved so that they are opposite those before, on the mean
   * around: while they move by a whole one, the mean angle grows, or falls, by 2π / n. By any, if the patch between
   * cannot be unrolled: it gets no grid. */
  double best_start(const Link& link, size_type n, const Points& before) const {
    const Annular_chart chart(maps_[link.patch]);
    if (!chart.is_unrolled())
      return 0;
    const int steps = 20;
    const double step = Annular_chart::period / double(n);
    const auto angle_at = [&](double start) {
      return mean_angle(chart, link.patch, link.curve, points_from(link.curve, n, start));
    };
    const double target = mean_angle(chart, link.patch, link.before, before), first = angle_at(0);
    double low = 0, high = 1;
    // How far the mean has to go, in whole steps from 0 to 1, in its own direction.
    const double way = angle_at(0.25) - first;
    const double direction = way - step * std::round(way / step) >= 0 ? 1 : -1;
    double wanted = direction * (target - first) / step;
    wanted -= std::floor(wanted);
    for (int k = 0; k < steps; ++k) {
      const double middle = (low + high) / 2;
      double gone = direction * (angle_at(middle) - first) / step;
      gone -= std::floor(gone);
      (gone < wanted ? low : high) = middle;
    }
    return low;
  }

  const Surface_cut& cut_;
  const std::vector<Map>& maps_;
  std::vector<std::vector<Point_3>> polylines_; // the curves
  std::vector<double> lengths_, in_sizes_;      // of each, in space, and in units of the size
  std::vector<Curve_divider> dividers_;
  std::vector<std::vector<size_type>> patches_at_; // annular ones, of each curve
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADS_INTERNAL_ANNULAR_CURVE_CHAINS_H
