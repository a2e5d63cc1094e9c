// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_POLYGON_SOUP_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_POLYGON_SOUP_H

#include <CGAL/Tubular_meshing/IO/internal/Input_file.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Triangle_soup.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

using Tubular_meshing::internal::Coordinates;
using Tubular_meshing::internal::cross;
using Tubular_meshing::internal::dot;
using Tubular_meshing::internal::drop_degenerate_and_duplicate;
using Tubular_meshing::internal::drop_unused_points;
using Tubular_meshing::internal::Index_triangle;
using Tubular_meshing::internal::merge_points;
using Tubular_meshing::internal::minus;

// Polygons as they come from a file, nothing checked yet: corners of polygon i end before ends[i].
struct Polygon_soup {
  std::vector<Coordinates> points;
  std::vector<std::int64_t> corners;
  std::vector<std::size_t> ends;

  // Arrays of one number each, by name: at points, and at the cells of the file.
  typedef std::map<std::string, std::vector<double>> Arrays;
  Arrays point_arrays, cell_arrays;
  Label_names region_names;       // of dimension 3, as of materials
  std::vector<std::size_t> cells; // the cell that polygon i is, or is a part of; empty: cell i

  // Named sets of polygons: solids, groups.
  std::string group_kind;
  std::vector<int> groups; // one a polygon
  Label_names names;       // of groups; of labels in an array

  void end_polygon() { ends.push_back(corners.size()); }
  void end_polygon(std::size_t cell) {
    cells.push_back(cell);
    end_polygon();
  }
  std::size_t cell_of(std::size_t polygon) const { return cells.empty() ? polygon : cells[polygon]; }
};

// Continues arrays by those of another piece of the file; what not all pieces have is dropped.
inline void append_arrays(Polygon_soup::Arrays& arrays, Polygon_soup::Arrays piece, bool is_first) {
  if (is_first) {
    arrays.swap(piece);
    return;
  }
  for (auto a = arrays.begin(); a != arrays.end();) {
    const auto more = piece.find(a->first);
    if (more == piece.end()) {
      a = arrays.erase(a);
      continue;
    }
    a->second.insert(a->second.end(), more->second.begin(), more->second.end());
    ++a;
  }
}

// Numbers names in the order in which they first come.
class Group_names {
public:
  explicit Group_names(Label_names& names)
      : names_(names) {}

  // Groups without a name are each their own.
  int number_of(const std::string& name) {
    const int next = ++last_;
    if (name.empty())
      return next;
    const auto known = numbers_.emplace(name, next);
    if (!known.second) {
      --last_;
      return known.first->second;
    }
    names_[next] = name;
    return next;
  }

private:
  Label_names& names_;
  std::map<std::string, int> numbers_;
  int last_ = 0;
};

inline Coordinates coordinates(const Point_3& p) {
  return {p.x(), p.y(), p.z()};
}
inline Point_3 to_point(const Coordinates& p) {
  return Point_3(p[0], p[1], p[2]);
}
inline std::vector<Point_3> to_points(const std::vector<Coordinates>& coordinates) {
  std::vector<Point_3> points;
  points.reserve(coordinates.size());
  for (const Coordinates& p : coordinates)
    points.push_back(to_point(p));
  return points;
}

inline void check_finite(const Coordinates& p, std::size_t i, const Input_file& file) {
  for (int k = 0; k < 3; ++k)
    if (!std::isfinite(p[k]))
      file.fail("cannot be used: the " + std::string(1, "xyz"[k]) + " coordinate of vertex " + std::to_string(i) +
                " (counted from 0) is not a finite number");
}
inline void check_finite(const std::vector<Coordinates>& points, const Input_file& file) {
  for (std::size_t i = 0; i < points.size(); ++i)
    check_finite(points[i], i, file);
}

inline void check_finite(const std::vector<Point_3>& points, const Input_file& file) {
  for (std::size_t i = 0; i < points.size(); ++i)
    check_finite(coordinates(points[i]), i, file);
}

inline void check_index(std::int64_t i, std::size_t n, const char* what, std::size_t number, const Input_file& file) {
  if (i < 0 || static_cast<std::uint64_t>(i) >= n)
    file.fail("cannot be used: " + std::string(what) + " " + std::to_string(number) +
              " (counted from 0) refers to vertex " + std::to_string(i) + ", but the file has only the vertices 0 to " +
              std::to_string(n - 1) + " (or none)");
}

// Cuts one polygon into triangles by clipping ears in the plane of its (Newell) normal: right for non-convex
// polygons too. O(k^2) for usual polygons of k corners, O(k^3) at worst. Not CGAL's triangulate_hole_polyline(), which
// gives no triangles at all for a polygon that cannot be cut without flat ones, or that crosses itself: the surface would
// get holes.
class Ear_clipper {
public:
  Ear_clipper(const std::vector<Coordinates>& points, std::vector<std::size_t> ring)
      : points_(points)
      , ring_(std::move(ring))
      , normal_{0, 0, 0} {
    for (std::size_t i = 1; i + 1 < ring_.size(); ++i) {
      const Coordinates n = turn(ring_[0], ring_[i], ring_[i + 1]);
      for (int k = 0; k < 3; ++k)
        normal_[k] += n[k];
    }
  }

  void clip(std::vector<Index_triangle>& triangles) {
    std::size_t i = 0, misses = 0;
    while (ring_.size() > 3) {
      // a polygon that crosses itself may run out of ears: then any corner goes
      if (misses < ring_.size() && !is_ear(i)) {
        i = (i + 1) % ring_.size();
        ++misses;
        continue;
      }
      triangles.push_back({previous(i), ring_[i], next(i)});
      ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(i));
      // on to the corner after next, so that a convex polygon is not cut into one fan of slivers
      i = (i + 1) % ring_.size();
      misses = 0;
    }
    triangles.push_back({ring_[0], ring_[1], ring_[2]});
  }

private:
  std::size_t previous(std::size_t i) const { return ring_[(i + ring_.size() - 1) % ring_.size()]; }
  std::size_t next(std::size_t i) const { return ring_[(i + 1) % ring_.size()]; }

  Coordinates turn(std::size_t a, std::size_t b, std::size_t c) const {
    return cross(minus(points_[b], points_[a]), minus(points_[c], points_[a]));
  }
  double area(std::size_t a, std::size_t b, std::size_t c) const { return dot(turn(a, b, c), normal_); }

  bool is_ear(std::size_t i) const {
    const std::size_t a = previous(i), b = ring_[i], c = next(i);
    if (!(area(a, b, c) > 0))
      return false;
    return std::none_of(ring_.begin(), ring_.end(), [&](std::size_t p) {
      return p != a && p != b && p != c && area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0;
    });
  }

  const std::vector<Coordinates>& points_;
  std::vector<std::size_t> ring_;
  Coordinates normal_;
};

// The triangles of the polygons, after checking all that a file can get wrong; of each, the polygon that it is of.
inline std::vector<Index_triangle> triangulate(const Polygon_soup& soup, const Input_file& file,
                                               std::vector<std::size_t>& polygon) {
  // more corners than any exporter writes: refused, since the cost of clipping grows fast with it
  const std::size_t most_corners = 256;

  check_finite(soup.points, file);
  std::vector<Index_triangle> triangles;
  triangles.reserve(soup.ends.size());
  std::size_t begin = 0;
  for (std::size_t f = 0; f < soup.ends.size(); begin = soup.ends[f], ++f) {
    const std::size_t k = soup.ends[f] - begin;
    if (k < 3)
      continue;
    if (k > most_corners)
      file.fail("cannot be used: face " + std::to_string(f) + " has " + std::to_string(k) +
                " corners; triangulate the surface first");
    for (std::size_t i = begin; i < soup.ends[f]; ++i)
      check_index(soup.corners[i], soup.points.size(), "face", f, file);
    const auto corner = soup.corners.begin() + static_cast<std::ptrdiff_t>(begin);
    if (k == 3)
      triangles.push_back({static_cast<std::size_t>(corner[0]), static_cast<std::size_t>(corner[1]),
                           static_cast<std::size_t>(corner[2])});
    else
      Ear_clipper(soup.points, {corner, corner + static_cast<std::ptrdiff_t>(k)}).clip(triangles);
    polygon.resize(triangles.size(), f);
  }
  if (triangles.empty())
    file.fail("contains no triangles; check that it is a surface, and the right file");
  return triangles;
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_POLYGON_SOUP_H
