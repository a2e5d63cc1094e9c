// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_TRIANGLE_SOUP_H
#define CGAL_TUBULAR_MESHING_BASE_TRIANGLE_SOUP_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

typedef std::array<double, 3> Coordinates;
typedef std::array<std::size_t, 3> Index_triangle;

/* Triangles as they come from a file: corners as indices of points. */
struct Triangle_soup {
  std::vector<Coordinates> points;
  std::vector<Index_triangle> triangles;
};

inline Coordinates minus(const Coordinates& a, const Coordinates& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Coordinates cross(const Coordinates& a, const Coordinates& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double dot(const Coordinates& a, const Coordinates& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Gives equal keys equal numbers, counted from 0 in the order in which they come: a hash table with open addressing.
template <class Key, class Hash> class Numbering {
public:
  Numbering(std::size_t most_keys, Hash hash = Hash())
      : hash_(hash) {
    std::size_t size = 16;
    while (size < 2 * most_keys)
      size *= 2;
    slots_.assign(size, none);
  }

  std::size_t number_of(const Key& key) {
    std::size_t s = hash_(key) & (slots_.size() - 1);
    for (; slots_[s] != none; s = (s + 1) & (slots_.size() - 1))
      if (keys_[slots_[s]] == key)
        return slots_[s];
    slots_[s] = keys_.size();
    keys_.push_back(key);
    return slots_[s];
  }

  std::vector<Key>& keys() { return keys_; }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  Hash hash_;
  std::vector<std::size_t> slots_;
  std::vector<Key> keys_;
};

inline std::uint64_t mixed_bits(std::uint64_t h) {
  h ^= h >> 32;
  h *= 0xd6e8feb86659fd93u;
  h ^= h >> 32;
  h *= 0xd6e8feb86659fd93u;
  return h ^ (h >> 32);
}

struct Hash_of_coordinates {
  std::size_t operator()(const Coordinates& p) const {
    std::uint64_t h = 0;
    for (double x : p) {
      std::uint64_t bits;
      x += 0.; // -0 equals 0, and must hash so
      std::memcpy(&bits, &x, sizeof bits);
      h = mixed_bits(h ^ bits) + 0x9e3779b97f4a7c15u;
    }
    return static_cast<std::size_t>(h);
  }
};

struct Hash_of_triangle {
  std::size_t operator()(const Index_triangle& t) const {
    return static_cast<std::size_t>(mixed_bits(mixed_bits(mixed_bits(t[0]) + t[1]) + t[2]));
  }
};

// Makes points of equal coordinates one point. O(n).
inline void merge_points(std::vector<Coordinates>& points, std::vector<Index_triangle>& triangles) {
  Numbering<Coordinates, Hash_of_coordinates> numbering(points.size());
  std::vector<std::size_t> merged(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    merged[i] = numbering.number_of(points[i]);
  for (Index_triangle& t : triangles)
    for (std::size_t& v : t)
      v = merged[v];
  points.swap(numbering.keys());
}

// Drops triangles of which two corners are one point, and all but the first of those with the same corners.
// Triangles of zero area with three corners stay: without them the surface would come apart. O(n).
inline void drop_degenerate_and_duplicate(std::vector<Index_triangle>& triangles) {
  Numbering<Index_triangle, Hash_of_triangle> seen(triangles.size());
  const auto superfluous = [&](const Index_triangle& t) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
      return true;
    Index_triangle sorted = t;
    std::sort(sorted.begin(), sorted.end());
    const std::size_t before = seen.keys().size();
    return seen.number_of(sorted) < before;
  };
  std::vector<Index_triangle> kept;
  kept.reserve(triangles.size());
  for (const Index_triangle& t : triangles)
    if (!superfluous(t))
      kept.push_back(t);
  triangles.swap(kept);
}

// Drops points that no triangle uses. O(n).
inline void drop_unused_points(std::vector<Coordinates>& points, std::vector<Index_triangle>& triangles) {
  const std::size_t unused = points.size();
  std::vector<std::size_t> number(points.size(), unused);
  for (const Index_triangle& t : triangles)
    for (std::size_t v : t)
      number[v] = 0;
  std::size_t n = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (number[i] != unused) {
      points[n] = points[i];
      number[i] = n++;
    }
  points.resize(n);
  for (Index_triangle& t : triangles)
    for (std::size_t& v : t)
      v = number[v];
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_TRIANGLE_SOUP_H
