// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_EXTENSION_EXTENSION_BAND_H
#define CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_EXTENSION_EXTENSION_BAND_H

#include <CGAL/Tubular_meshing/Openings/internal/extension/Extension_profile.h>
#include <CGAL/Tubular_meshing/Rims/planar_cap.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The triangles between the rim, which is oblique, uneven or fine as it comes, and the first regular ring of an
 * extension. They are made in the plane, where the unrolled tube becomes an annulus by the exponential map: that is
 * conformal, so that Delaunay triangles of the annulus are good ones on the tube. Points between rim and ring are those
 * of hexagonal lattices, halved where the rim is finer, and smoothed. */
class Extension_band {
  typedef Kernel::Point_2 Point_2;

public:
  /* Vertices are numbered: those of the rim, those of the ring, the others. */
  std::vector<Unrolled_point> points;
  std::vector<Index_triangle> triangles;

  /* The least height of the ring: there the straight edges of the rim cannot meet it in the annulus. */
  static double least_height(const Extension_profile& profile) {
    double height = profile.highest();
    for (std::size_t i = 0; i < profile.size(); ++i) {
      const Point_2 a = on_annulus(profile.rim(i)), b = on_annulus(profile.rim(i + 1));
      const double distance = std::sqrt(CGAL::squared_distance(Kernel::Segment_2(a, b), Point_2(0, 0)));
      height = (std::max)(height, 0.1 - std::log((std::max)(distance, 1e-9)));
    }
    return height;
  }

  explicit Extension_band(const Extension_profile& profile)
      : profile_(profile)
      , rim_size_(profile.size())
      , spacing_(profile.edge_length()) {
    for (std::size_t i = 0; i < rim_size_; ++i) {
      points.push_back(profile.rim(i));
      sizes_.push_back((std::min)(spacing_, (std::max)(profile.rim_edge(i), profile.rim_edge(i + rim_size_ - 1))));
    }
    place_ring();
    fixed_ = points.size();
    place_lattice();
    triangulate();
    split_shortcuts();
    for (int i = 0; i < 4 && points.size() > fixed_; ++i) {
      smooth();
      triangulate();
      split_shortcuts();
    }
  }

  /* The angle of the first corner of the ring. */
  double ring_phase() const { return points[rim_size_].angle; }
  double ring_height() const { return points[rim_size_].height; }

private:
  static constexpr double row = 0.8660254037844386; // height of an equilateral triangle
  static constexpr double growth = 0.7;             // of the edge length with the distance from a fine place of the rim
  static constexpr int finest_level = 5;

  static Point_2 on_annulus(const Unrolled_point& p) {
    const double r = std::exp(-p.height);
    return Point_2(r * std::cos(p.angle), r * std::sin(p.angle));
  }

  // A row above the rim, or more where the rim is finer than the ring. The corners stand between those of the rim.
  void place_ring() {
    double height = least_height(profile_), x = 0, y = 0;
    const int corners = profile_.corners();
    for (std::size_t i = 0; i < rim_size_; ++i) {
      height = (std::max)(height, points[i].height + row * spacing_ + (spacing_ - sizes_[i]));
      x += std::cos(corners * points[i].angle);
      y += std::sin(corners * points[i].angle);
    }
    if (height > profile_.end() - 0.6 * row * spacing_)
      height = profile_.end();
    const double phase = (std::atan2(y, x) + CGAL_PI) / corners;
    for (int i = 0; i < corners; ++i)
      points.push_back({phase + i * 2 * CGAL_PI / corners, height});
  }

  // Calls f(i, dx) for the rim's vertices within an angle, dx being the angle from there to i.
  template <class F> void for_rim_near(double angle, double within, F f) const {
    const std::size_t here = profile_.rim_at(angle).first;
    auto offset = [&](std::size_t i) { return std::remainder(profile_.rim(i).angle - angle, 2 * CGAL_PI); };
    for (std::size_t k = 0; k < rim_size_; ++k) {
      const std::size_t i = (here + rim_size_ - k) % rim_size_;
      f(i, offset(i));
      if (std::abs(offset(i)) > within)
        break;
    }
    for (std::size_t k = 1; k < rim_size_; ++k) {
      const std::size_t i = (here + k) % rim_size_;
      f(i, offset(i));
      if (std::abs(offset(i)) > within)
        break;
    }
  }

  // The edge length that fits at a point.
  double size_at(const Unrolled_point& p) const {
    double size = spacing_;
    for_rim_near(p.angle, spacing_ / growth, [&](std::size_t i, double dx) {
      size = (std::min)(size, sizes_[i] + growth * std::hypot(dx, points[i].height - p.height));
    });
    return size;
  }

  // Above the rim's edges, and not too close to them.
  bool is_clear_of_rim(const Unrolled_point& p, double distance) const {
    const std::size_t below = profile_.rim_at(p.angle).first;
    if (!is_inside_chord(p, below))
      return false;
    bool clear = true;
    for_rim_near(p.angle, distance, [&](std::size_t i, double dx) {
      const Unrolled_point &a = profile_.rim(i), &b = profile_.rim(i + 1);
      const double ex = std::remainder(b.angle - a.angle, 2 * CGAL_PI), ey = b.height - a.height;
      const double length2 = ex * ex + ey * ey, px = -dx, py = p.height - a.height;
      const double t = length2 > 0 ? (std::min)(1., (std::max)(0., (px * ex + py * ey) / length2)) : 0;
      clear = clear && std::hypot(px - t * ex, py - t * ey) >= distance;
    });
    return clear;
  }
  bool is_inside_chord(const Unrolled_point& p, std::size_t edge) const {
    return CGAL::left_turn(on_annulus(profile_.rim(edge)), on_annulus(profile_.rim(edge + 1)), on_annulus(p));
  }

  // Rows of lattices below the ring, at each place that of the level whose spacing fits there.
  void place_lattice() {
    const Unrolled_point first = points[rim_size_];
    std::map<std::pair<long, long>, std::vector<std::size_t>> grid; // of cells as wide as the coarsest spacing
    const long columns = profile_.corners();
    auto cell_of = [&](const Unrolled_point& p) {
      const double x = (p.angle - first.angle) / (2 * CGAL_PI);
      return std::pair<long, long>(long(std::floor((x - std::floor(x)) * double(columns))) % columns,
                                   long(std::floor((first.height - p.height) / spacing_)));
    };
    auto is_free = [&](const Unrolled_point& p, double distance) {
      const auto cell = cell_of(p);
      for (long dx = -1; dx <= 1; ++dx)
        for (long dy = -1; dy <= 1; ++dy) {
          const auto found = grid.find({(cell.first + dx + columns) % columns, cell.second + dy});
          if (found == grid.end())
            continue;
          for (std::size_t q : found->second)
            if (std::hypot(std::remainder(points[q].angle - p.angle, 2 * CGAL_PI), points[q].height - p.height) <
                distance)
              return false;
        }
      return true;
    };
    double spacing = spacing_;
    const double finest = *std::min_element(sizes_.begin(), sizes_.end());
    for (int level = 0; level <= finest_level && 1.4 * spacing > finest; ++level, spacing /= 2) {
      const long in_row = columns << level;
      for (long k = 1; first.height - double(k) * row * spacing > profile_.lowest(); ++k)
        for (long i = 0; i < in_row; ++i) {
          const Unrolled_point p{first.angle + (double(i) + 0.5 * double(k % 2)) * spacing,
                                 first.height - double(k) * row * spacing};
          const double size = size_at(p);
          if (size <= 0.7 * spacing || (level > 0 && size > 1.4 * spacing) || !is_clear_of_rim(p, 0.6 * size) ||
              !is_free(p, 0.7 * size))
            continue;
          grid[cell_of(p)].push_back(points.size());
          points.push_back(p);
        }
    }
  }

  // What is reached from outside without crossing the rim is no part; neither is what the ring encloses.
  void triangulate() {
    std::vector<Point_2> places;
    for (const Unrolled_point& p : points)
      places.push_back(on_annulus(p));
    std::vector<std::array<std::size_t, 2>> sides;
    for (std::size_t i = 0; i < rim_size_; ++i)
      sides.push_back({i, (i + 1) % rim_size_});
    const std::size_t corners = fixed_ - rim_size_;
    for (std::size_t i = 0; i < corners; ++i)
      sides.push_back({rim_size_ + i, rim_size_ + (i + 1) % corners});
    auto is_of_ring = [&](std::size_t i) { return i >= rim_size_ && i < fixed_; };
    triangles.clear();
    for (const Index_triangle& t : triangulate_inside(places, sides))
      if (!(is_of_ring(t[0]) && is_of_ring(t[1]) && is_of_ring(t[2])))
        triangles.push_back(t);
  }

  // Edges from the rim to the rim that are no edges of it may be in the wall already: each gets a point in its middle.
  void split_shortcuts() {
    for (;;) {
      std::set<std::pair<std::size_t, std::size_t>> shortcuts;
      for (const Index_triangle& t : triangles)
        for (int k = 0; k < 3; ++k) {
          const std::size_t a = (std::min)(t[k], t[(k + 1) % 3]), b = (std::max)(t[k], t[(k + 1) % 3]);
          if (b < rim_size_ && b - a != 1 && b - a != rim_size_ - 1)
            shortcuts.emplace(a, b);
        }
      if (shortcuts.empty())
        return;
      for (const auto& s : shortcuts) {
        const Point_2 m = CGAL::midpoint(on_annulus(points[s.first]), on_annulus(points[s.second]));
        points.push_back({std::atan2(m.y(), m.x()), -std::log(std::hypot(m.x(), m.y()))});
      }
      triangulate();
    }
  }

  // Moves each free point towards the mean of its neighbours, unless a triangle would turn over.
  void smooth() {
    std::vector<std::vector<std::size_t>> around(points.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (std::size_t v : triangles[t])
        around[v].push_back(t);
    for (std::size_t v = fixed_; v < points.size(); ++v) {
      double dx = 0, dy = 0, n = 0;
      for (std::size_t t : around[v])
        for (std::size_t w : triangles[t]) {
          dx += std::remainder(points[w].angle - points[v].angle, 2 * CGAL_PI);
          dy += points[w].height - points[v].height;
          n += w == v ? 0 : 1;
        }
      if (n == 0)
        continue;
      const Unrolled_point before = points[v];
      points[v] = {before.angle + dx / n, before.height + dy / n};
      for (std::size_t t : around[v])
        if (!CGAL::left_turn(on_annulus(points[triangles[t][0]]), on_annulus(points[triangles[t][1]]),
                             on_annulus(points[triangles[t][2]]))) {
          points[v] = before;
          break;
        }
    }
  }

  const Extension_profile& profile_;
  const std::size_t rim_size_;
  const double spacing_; // of the ring
  std::size_t fixed_ = 0;
  std::vector<double> sizes_; // of the edges at each vertex of the rim
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_EXTENSION_EXTENSION_BAND_H
