// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESHING_TEST_VESSELS_GENERATED_VESSELS_H
#define TUBULAR_MESHING_TEST_VESSELS_GENERATED_VESSELS_H

#include "../vessel_ends.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

/* Vessels of random shape whose openings and parts are known: trees of which each end is open, flat or round, with
 * branches that are cut off flush with the wall, in any unit and direction. The same number gives the same vessels. */
namespace vessels {

using namespace vessel_ends;

/* Reproducible on all platforms, unlike the distributions of the standard library. */
class Dice {
public:
  explicit Dice(unsigned seed)
      : random_(seed) {}

  double between(double a, double b) { return a + (b - a) * (random_() / 4294967296.); }
  int number(int from, int to) { return from + int(random_() % unsigned(to - from + 1)); }
  bool is_under(double probability) { return between(0, 1) < probability; }
  Vector direction() {
    for (;;) {
      const double z = between(-1, 1); // not as arguments of a call, which compilers evaluate in different orders
      const double y = between(-1, 1);
      const Vector v(between(-1, 1), y, z);
      const double l = std::sqrt(v.squared_length());
      if (l > 0.1 && l < 1)
        return v / l;
    }
  }

private:
  std::mt19937 random_;
};

/* A trunk that divides up to twice, and at most one branch at its side. */
class Tree_maker {
public:
  explicit Tree_maker(Dice& dice)
      : dice_(dice) {}

  /* The last end is that of the side branch, if there is one. */
  Skeleton make(int divisions, bool has_side_branch) {
    for (;;) {
      skeleton_ = Skeleton();
      skeleton_.nodes.push_back(Point(0, 0, 0));
      const Vector up(0, 0, 1);
      const double length = dice_.between(7, 10);
      side_ = Side_branch();
      if (has_side_branch)
        grow_side_branch(length);
      grow(has_side_branch ? side_.node : 0, up, 1, has_side_branch ? length / 2 : length, divisions);
      if (is_clear())
        return skeleton_;
    }
  }

  struct Side_branch {
    std::size_t node = 0, end = 0;
    Vector along = Vector(0, 0, 0);
    double radius = 0, angle = 0;
  };
  const Side_branch& side_branch() const { return side_; }

private:
  void add_line(std::size_t from, std::size_t to, double radius, double radius_at_end) {
    const Point p = skeleton_.nodes[from], q = skeleton_.nodes[to];
    skeleton_.add_branch(
        from, to, [=](double t) { return p + t * (q - p); },
        [=](double t) { return radius + t * (radius_at_end - radius); });
  }

  std::size_t add_node(const Point& p) {
    skeleton_.nodes.push_back(p);
    return skeleton_.nodes.size() - 1;
  }

  Vector across(const Vector& v) {
    for (;;) {
      const Vector d = CGAL::cross_product(v, dice_.direction());
      if (d.squared_length() > 0.1)
        return d / std::sqrt(d.squared_length());
    }
  }

  void grow_side_branch(double length) {
    side_.node = add_node(Point(0, 0, length / 2));
    add_line(0, side_.node, 1, 1);
    side_.radius = dice_.between(0.3, 0.75);
    side_.angle = dice_.between(60, 90) * CGAL_PI / 180;
    const Vector up(0, 0, 1);
    side_.along = std::sin(side_.angle) * across(up) + std::cos(side_.angle) * up;
    side_.end = add_node(skeleton_.nodes[side_.node] + (2 + 4 * side_.radius) * side_.along);
    add_line(side_.node, side_.end, side_.radius, side_.radius);
  }

  void grow(std::size_t from, const Vector& along, double radius, double length, int divisions) {
    const double taper = dice_.between(0.85, 1);
    const std::size_t to = add_node(skeleton_.nodes[from] + length * along);
    add_line(from, to, radius, taper * radius);
    if (divisions == 0)
      return;
    const Vector side = across(along);
    for (double sign : {-1., 1.}) {
      const double angle = dice_.between(25, 45) * CGAL_PI / 180;
      const double r = taper * radius * dice_.between(0.65, 0.85);
      grow(to, std::cos(angle) * along + sign * std::sin(angle) * side, r, r * dice_.between(6, 9), divisions - 1);
    }
  }

  // Whether branches without a common node keep apart.
  bool is_clear() const {
    const auto& branches = skeleton_.branches;
    for (std::size_t i = 0; i < branches.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const auto &a = branches[i], &b = branches[k];
        if (a.source == b.source || a.source == b.target || a.target == b.source || a.target == b.target)
          continue;
        for (std::size_t p = 0; p < a.points.size(); ++p)
          for (std::size_t q = 0; q < b.points.size(); ++q)
            if (tubular::internal::point_distance(a.points[p], b.points[q]) < 1.5 * (a.radius[p] + b.radius[q]))
              return false;
      }
    return true;
  }

  Dice& dice_;
  Skeleton skeleton_;
  Side_branch side_;
};

/* What a case is made of, and the truth about it. */
struct Case {
  Mesh mesh;
  std::size_t openings = 0, parts = 0;
  std::string what; ///< for the person who looks into it
};

inline const char* name_of(Kind kind) {
  return kind == Kind::open ? "open" : kind == Kind::flat ? "flat" : "round";
}

/* One vessel, of its own size, around the origin. */
inline Mesh make_vessel(Dice& dice, int style, Case& c) {
  const bool has_side_branch = dice.is_under(0.4);
  const bool is_flush = has_side_branch && style != 2 && dice.is_under(0.7);
  Tree_maker maker(dice);
  const Skeleton tree = maker.make(dice.number(0, 2), has_side_branch);
  Mesh mesh = round_tree(tree, dice.number(12, 28));
  c.what += " [tree of " + std::to_string(tree.branches.size()) + " branches:";
  for (const End& end : tree.ends()) {
    const auto& side = maker.side_branch();
    ++c.openings;
    if (is_flush && end.node == side.end) {
      const double stub = dice.between(0.08, 0.3);
      const Vector out = side.along - side.along.z() * Vector(0, 0, 1); // across the trunk
      const Vector normal = out / std::sqrt(out.squared_length());
      cut_end(mesh, end.center, end.radius, tree.nodes[side.node] + (1 + stub) * normal, normal);
      c.what += " flush, radius " + std::to_string(side.radius) + ", " + std::to_string(stub) + " off";
      continue;
    }
    const Kind kind = style == 0   ? Kind::open
                      : style == 1 ? Kind::flat
                      : style == 2 ? Kind::round
                                   : (dice.is_under(0.5) ? Kind::open : Kind::flat);
    finish_end(mesh, end, kind);
    c.what += std::string(" ") + name_of(kind);
  }
  c.what += "]";
  mesh.collect_garbage();
  return mesh;
}

inline Case make_case(unsigned number) {
  Dice dice(1000 + number);
  Case c;
  c.what = "case " + std::to_string(number) + ":";
  const int parts = dice.is_under(0.6) ? 1 : dice.number(2, 3);
  for (int k = 0; k < parts; ++k) {
    Mesh part = make_vessel(dice, dice.number(0, 3), c);
    const double size = k == 0 ? 1 : dice.between(0.5, 1);
    for (auto v : part.vertices()) {
      const Point& p = part.point(v);
      part.point(v) = Point(size * p.x() + 60. * k, size * p.y(), size * p.z());
    }
    c.mesh += part;
  }
  c.parts = std::size_t(parts);
  const double unit = std::pow(10, dice.between(-3, 3)), angle = dice.between(0, 2 * CGAL_PI);
  const Vector axis = dice.direction(), shift_direction = dice.direction();
  const Vector shift = 100 * dice.between(0, 1) * shift_direction;
  for (auto v : c.mesh.vertices()) { // Rodrigues' formula
    const Vector p = c.mesh.point(v) - CGAL::ORIGIN;
    const Vector turned = std::cos(angle) * p + std::sin(angle) * CGAL::cross_product(axis, p) +
                          (1 - std::cos(angle)) * (axis * p) * axis;
    c.mesh.point(v) = CGAL::ORIGIN + unit * (turned + shift);
  }
  c.what += " in units of " + std::to_string(unit);
  return c;
}

} // namespace vessels

#endif // TUBULAR_MESHING_TEST_VESSELS_GENERATED_VESSELS_H
