// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_VESSEL_PATH_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_VESSEL_PATH_H

#include <CGAL/Tubular_meshing/base/Plane_frame.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A polyline with a radius at each point. */
struct Vessel_path {
  std::vector<Vector_3d> points;
  std::vector<double> radii, abscissa;

  void push_back(const Vector_3d& p, double r) {
    const double a = points.empty() ? 0 : abscissa.back() + norm(p - points.back());
    if (!points.empty() && a == abscissa.back())
      return;
    points.push_back(p);
    radii.push_back(r);
    abscissa.push_back(a);
  }
  double length() const { return abscissa.back(); }

  // A place on the path: the segment, and how far along.
  std::pair<std::size_t, double> at(double a) const {
    const auto next = std::upper_bound(abscissa.begin() + 1, abscissa.end() - 1, a);
    const std::size_t i = std::size_t(next - abscissa.begin()) - 1;
    return {i, (std::min)((std::max)((a - abscissa[i]) / (abscissa[i + 1] - abscissa[i]), 0.), 1.)};
  }
  Vector_3d point(double a) const {
    const auto [i, t] = at(a);
    return (1 - t) * points[i] + t * points[i + 1];
  }
  double radius(double a) const {
    const auto [i, t] = at(a);
    return (1 - t) * radii[i] + t * radii[i + 1];
  }
  // The direction of the chord over `width`.
  Vector_3d tangent(double a, double width) const {
    const double first = (std::max)(a - width / 2, 0.), last = (std::min)(a + width / 2, length());
    return normalized(point(last) - point(first));
  }
  // The place nearest to a point; only the first `most` of the path counts.
  double nearest(const Vector_3d& p, double most) const {
    double least = (std::numeric_limits<double>::infinity)(), place = 0;
    for (std::size_t k = 0; k + 1 < points.size() && abscissa[k] <= most; ++k) {
      const Vector_3d d = points[k + 1] - points[k];
      const double t = (std::min)((std::max)(dot(p - points[k], d) / squared_norm(d), 0.), 1.);
      const double d2 = squared_norm(points[k] + t * d - p);
      if (d2 < least) {
        least = d2;
        place = (1 - t) * abscissa[k] + t * abscissa[k + 1];
      }
    }
    return place;
  }
  // The distance of a point, in radii of the place nearest to it; only the first `most` of the path counts.
  double distance_in_radii(const Vector_3d& p, double most) const {
    const double place = nearest(p, most);
    return norm(point(place) - p) / radius(place);
  }
  // What is left of it beyond a place.
  Vessel_path from(double a) const {
    Vessel_path result;
    result.push_back(point(a), radius(a));
    for (std::size_t i = 0; i < points.size(); ++i)
      if (abscissa[i] > a)
        result.push_back(points[i], radii[i]);
    return result;
  }
  Vessel_path reversed() const {
    Vessel_path result;
    for (std::size_t i = points.size(); i-- > 0;)
      result.push_back(points[i], radii[i]);
    return result;
  }

  /* Sampled evenly, by steps of a quarter of the least radius, and without bends that are sharp against its width: by
   * a kernel whose width is 0.7 radii. */
  Vessel_path smoothed() const {
    constexpr double kernel = 0.7;
    const double least = *std::min_element(radii.begin(), radii.end());
    const std::size_t n = std::size_t((std::min)((std::max)(std::ceil(4 * length() / least), 16.), 4000.));
    const double step = length() / double(n);
    std::vector<Vector_3d> p;
    std::vector<double> rounds; // of the binomial filter, half a squared step each
    for (std::size_t i = 0; i <= n; ++i) {
      const double width = kernel * radius(step * double(i));
      p.push_back(point(step * double(i)));
      rounds.push_back(2 * width * width / (step * step));
    }
    const double most = *std::max_element(rounds.begin(), rounds.end());
    for (int round = 0; round < (std::min)(most, 400.); ++round) {
      const std::vector<Vector_3d> q = p;
      for (std::size_t i = 1; i < n; ++i)
        if (round < rounds[i])
          p[i] = 0.5 * q[i] + 0.25 * (q[i - 1] + q[i + 1]);
    }
    Vessel_path result;
    for (std::size_t i = 0; i <= n; ++i)
      result.push_back(p[i], radius(step * double(i)));
    return result;
  }
};

/* Axes across a path that turn no more than the path does. */
class Path_frames {
public:
  struct Frame {
    Vector_3d tangent, u;
    Vector_3d v() const { return cross(tangent, u); }
  };

  explicit Path_frames(const Vessel_path& path) {
    const std::size_t n = (std::max)(std::size_t(20), path.points.size());
    for (std::size_t i = 0; i <= n; ++i) {
      const double a = path.length() * double(i) / double(n);
      const Vector_3d t = path.tangent(a, 1.5 * path.radius(a));
      const Vector_3d w = i == 0 ? Plane_frame(path.points[0], t).u : frames_.back().u;
      abscissa_.push_back(a);
      frames_.push_back({t, normalized(w - dot(w, t) * t)});
    }
  }

  Frame at(double a) const {
    const auto next = std::upper_bound(abscissa_.begin() + 1, abscissa_.end() - 1, a);
    const std::size_t i = std::size_t(next - abscissa_.begin()) - 1;
    const double t = (std::min)((std::max)((a - abscissa_[i]) / (abscissa_[i + 1] - abscissa_[i]), 0.), 1.);
    const Vector_3d d = normalized((1 - t) * frames_[i].tangent + t * frames_[i + 1].tangent);
    const Vector_3d w = (1 - t) * frames_[i].u + t * frames_[i + 1].u;
    return {d, normalized(w - dot(w, d) * d)};
  }

private:
  std::vector<double> abscissa_;
  std::vector<Frame> frames_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_VESSEL_PATH_H
