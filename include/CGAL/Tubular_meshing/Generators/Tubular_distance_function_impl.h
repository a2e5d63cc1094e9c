// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_DISTANCE_FUNCTION_IMPL_H
#define CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_DISTANCE_FUNCTION_IMPL_H

#include <CGAL/Tubular_meshing/Generators/Tubular_distance_function.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace CGAL::Tubular_meshing {

CGAL_TUBULAR_MESHING_INLINE Tubular_distance_function::Tubular_distance_function(const Tubular_skeleton& skeleton) {
  check_skeleton(skeleton);
  for (std::size_t b = 0; b < skeleton.branches.size(); ++b) {
    const auto& branch = skeleton.branches[b];
    double abscissa = 0;
    for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) {
      Segment s;
      s.from = Vec(branch.points[i]);
      s.along = Vec(branch.points[i + 1]) - s.from;
      s.length = internal::norm(s.along);
      s.radius = branch.radius[i];
      s.radius_change = branch.radius[i + 1] - branch.radius[i];
      s.abscissa = abscissa;
      s.branch = b;
      abscissa += s.length;
      segments_.push_back(s);
    }
  }
  nodes_.reserve(segments_.size());
  build(0, segments_.size());
}

CGAL_TUBULAR_MESHING_INLINE Tubular_distance_function::Value Tubular_distance_function::evaluate(const Vec& p) const {
  Hits hits;
  find_hits(p, hits);
  return blend(p, hits);
}

CGAL_TUBULAR_MESHING_INLINE bool Tubular_distance_function::has_surface_near(const Vec& p, double reach,
                                                                             double radius) const {
  std::array<std::uint32_t, 64> stack;
  std::size_t size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const Box_node& node = nodes_[stack[--size]];
    const double widest = blend_width * node.max_radius + reach;
    if (node.min_radius >= radius || distance_to_box(p, node) > node.max_radius + widest)
      continue;
    if (node.count == 0) {
      stack[size++] = node.first;
      stack[size++] = node.second;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Foot foot = nearest_on(segments_[i], p);
      const double r = foot.radius, d = std::sqrt(foot.squared_distance);
      if (r < radius && std::abs(d - r) <= reach + blend_width * r)
        return true;
    }
  }
  return false;
}

CGAL_TUBULAR_MESHING_INLINE std::array<Tubular_distance_function::Vec, 2>
Tubular_distance_function::bounding_box() const {
  const Box_node& root = nodes_[0];
  const Vec r(root.max_radius, root.max_radius, root.max_radius);
  return {{root.lower - r, root.upper + r}};
}

CGAL_TUBULAR_MESHING_INLINE std::uint32_t Tubular_distance_function::build(std::size_t begin, std::size_t end) {
  const std::uint32_t index = std::uint32_t(nodes_.size());
  nodes_.emplace_back();
  Box_node node = bounds(begin, end);
  if (end - begin <= 4) {
    node.first = std::uint32_t(begin);
    node.count = std::uint32_t(end - begin);
  } else {
    const Vec size = node.upper - node.lower;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t middle = begin + (end - begin) / 2;
    auto center = [axis](const Segment& s) { return s.from[axis] + 0.5 * s.along[axis]; };
    std::nth_element(segments_.begin() + std::ptrdiff_t(begin), segments_.begin() + std::ptrdiff_t(middle),
                     segments_.begin() + std::ptrdiff_t(end),
                     [&](const Segment& a, const Segment& b) { return center(a) < center(b); });
    node.count = 0;
    node.first = build(begin, middle);
    node.second = build(middle, end);
  }
  nodes_[index] = node;
  return index;
}

CGAL_TUBULAR_MESHING_INLINE Tubular_distance_function::Box_node
Tubular_distance_function::bounds(std::size_t begin, std::size_t end) const {
  const double big = (std::numeric_limits<double>::max)();
  Box_node node{Vec(big, big, big), Vec(-big, -big, -big), big, 0, 0, 0, 0};
  for (std::size_t i = begin; i < end; ++i) {
    const Segment& s = segments_[i];
    for (const Vec& p : {s.from, s.from + s.along}) {
      node.lower = Vec((std::min)(node.lower.x, p.x), (std::min)(node.lower.y, p.y), (std::min)(node.lower.z, p.z));
      node.upper = Vec((std::max)(node.upper.x, p.x), (std::max)(node.upper.y, p.y), (std::max)(node.upper.z, p.z));
    }
    for (double r : {s.radius, s.radius + s.radius_change}) {
      node.min_radius = (std::min)(node.min_radius, r);
      node.max_radius = (std::max)(node.max_radius, r);
    }
  }
  return node;
}

CGAL_TUBULAR_MESHING_INLINE double Tubular_distance_function::distance_to_box(const Vec& p, const Box_node& n) {
  const Vec d((std::max)({n.lower.x - p.x, p.x - n.upper.x, 0.}), (std::max)({n.lower.y - p.y, p.y - n.upper.y, 0.}),
              (std::max)({n.lower.z - p.z, p.z - n.upper.z, 0.}));
  return internal::norm(d);
}

CGAL_TUBULAR_MESHING_INLINE Tubular_distance_function::Foot Tubular_distance_function::nearest_on(const Segment& s,
                                                                                                  const Vec& p) {
  const Vec d = p - s.from;
  const double t = (std::min)((std::max)(internal::dot(d, s.along) / (s.length * s.length), 0.), 1.);
  return {t, internal::squared_norm(d - t * s.along), s.radius + t * s.radius_change};
}

CGAL_TUBULAR_MESHING_INLINE void Tubular_distance_function::find_hits(const Vec& p, Hits& hits) const {
  const double margin = blend_width + 0.15;
  double best = (std::numeric_limits<double>::max)();
  std::array<std::pair<double, std::uint32_t>, 64> stack;
  std::size_t size = 0;
  stack[size++] = {distance_to_box(p, nodes_[0]), 0};
  while (size > 0) {
    const auto [distance, index] = stack[--size];
    const Box_node& node = nodes_[index];
    if (distance - node.max_radius > best + margin * node.max_radius)
      continue;
    if (node.count > 0) {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        const Foot foot = nearest_on(segments_[i], p);
        best = (std::min)(best, std::sqrt(foot.squared_distance) - foot.radius);
        add_hit(i, foot, hits);
      }
      continue;
    }
    std::pair<double, std::uint32_t> near(distance_to_box(p, nodes_[node.first]), node.first),
        far(distance_to_box(p, nodes_[node.second]), node.second);
    if (far.first - nodes_[far.second].max_radius < near.first - nodes_[near.second].max_radius)
      std::swap(near, far);
    stack[size++] = far;
    stack[size++] = near;
  }
}

CGAL_TUBULAR_MESHING_INLINE void Tubular_distance_function::add_hit(std::uint32_t segment, const Foot& foot,
                                                                    Hits& hits) const {
  std::size_t i = 0;
  while (i < hits.size && segments_[hits.hit[i].segment].branch != segments_[segment].branch)
    ++i;
  if (i == hits.hit.size()) {
    for (i = 0; i + 1 < hits.size && value(hits.hit[i].foot) <= value(foot);)
      ++i;
    if (value(hits.hit[i].foot) <= value(foot))
      return;
  } else if (i == hits.size)
    ++hits.size;
  else if (hits.hit[i].foot.squared_distance <= foot.squared_distance)
    return;
  hits.hit[i] = Hit{segment, foot};
}

CGAL_TUBULAR_MESHING_INLINE Tubular_distance_function::Value Tubular_distance_function::blend(const Vec& p,
                                                                                              Hits& hits) const {
  std::sort(hits.hit.begin(), hits.hit.begin() + std::ptrdiff_t(hits.size),
            [](const Hit& a, const Hit& b) { return value(a.foot) < value(b.foot); });
  Value result;
  Vec gradient;
  for (std::size_t i = 0; i < hits.size; ++i) {
    const Segment& s = segments_[hits.hit[i].segment];
    const Foot& foot = hits.hit[i].foot;
    const Vec g = internal::normalized(p - s.from - foot.t * s.along);
    const double v = value(foot);
    if (i == 0) {
      result.value = v;
      result.radius = foot.radius;
      result.branch = s.branch;
      result.distance = std::sqrt(foot.squared_distance);
      result.abscissa = s.abscissa + foot.t * s.length;
      gradient = g;
      continue;
    }
    const double spread = (std::min)(1 - internal::dot(internal::normalized(gradient), g), 1.);
    const double width = blend_width * (std::min)(result.radius, foot.radius) * spread;
    if (!(v - result.value < width))
      continue;
    const double h = 1 - (v - result.value) / width;
    result.value -= h * h * width / 4;
    gradient = (1 - h / 2) * gradient + (h / 2) * g;
    result.radius += h / 2 * (foot.radius - result.radius);
    result.blended = true;
  }
  result.gradient = {{gradient.x, gradient.y, gradient.z}};
  return result;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_DISTANCE_FUNCTION_IMPL_H
