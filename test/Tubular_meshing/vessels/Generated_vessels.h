// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESHING_TEST_VESSELS_GENERATED_VESSELS_H
#define TUBULAR_MESHING_TEST_VESSELS_GENERATED_VESSELS_H

#include "../round_ends.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

/* Vessels of random shape whose openings and parts are known: trees of which each end is open, flat, round or closed by a
 * dome of any height, with branches that are cut off flush with the wall or are stubs, with sacs, with labels, in any
 * unit and direction. Some are damaged, by spikes. The same number gives the same vessels. */
namespace vessels {

using namespace round_ends;

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

/* What a tree has at the side of its trunk. */
struct Side {
  bool has_branch = false, is_stub = false;
  bool has_sac = false;
};

/* A trunk that divides up to twice, and at most one branch and one sac at its side. */
class Tree_maker {
public:
  explicit Tree_maker(Dice& dice)
      : dice_(dice) {}

  Skeleton make(int divisions, const Side& side) {
    for (;;) {
      skeleton_ = Skeleton();
      skeleton_.nodes.push_back(Point(0, 0, 0));
      const Vector up(0, 0, 1);
      const double length = dice_.between(7, 10);
      side_ = Side_branch();
      sac_ = {0, 0};
      const bool has_node = side.has_branch || side.has_sac;
      if (has_node) {
        side_.node = add_node(Point(0, 0, length / 2));
        add_line(0, side_.node, 1, 1);
      }
      if (side.has_branch)
        grow_side_branch(side.is_stub);
      if (side.has_sac)
        grow_sac();
      grow(has_node ? side_.node : 0, up, 1, has_node ? length / 2 : length, divisions);
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
  bool is_sac(std::size_t node) const { return node >= sac_[0] && node < sac_[1]; }

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

  void grow_side_branch(bool is_stub) {
    side_.radius = dice_.between(0.3, 0.75);
    side_.angle = dice_.between(60, 90) * CGAL_PI / 180;
    const Vector up(0, 0, 1);
    side_.along = std::sin(side_.angle) * across(up) + std::cos(side_.angle) * up;
    const double length =
        is_stub ? 1 / std::sin(side_.angle) + dice_.between(1, 2) * side_.radius : 2 + 4 * side_.radius;
    side_.end = add_node(skeleton_.nodes[side_.node] + length * side_.along);
    add_line(side_.node, side_.end, side_.radius, side_.radius);
  }

  // Opposite to the side branch.
  void grow_sac() {
    const Vector up(0, 0, 1), out = side_.end > 0 ? Vector(-side_.along.x(), -side_.along.y(), 0) : across(up);
    const double radius = dice_.between(1.2, 3);
    const double neck = dice_.between(0.4, 0.8);
    const int lobes = radius > 1.6 ? dice_.number(0, 3) : 0;
    const double distance = radius + dice_.between(0.7, 1.6);
    sac_[0] = skeleton_.nodes.size();
    add_sac(skeleton_, side_.node, normalized(out) + dice_.between(-0.3, 0.3) * up, distance, radius, neck, lobes);
    sac_[1] = skeleton_.nodes.size();
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

  // Whether branches without a common node keep apart; a sac may sit close to the trunk.
  bool is_clear() const {
    const auto& branches = skeleton_.branches;
    for (std::size_t i = 0; i < branches.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const auto &a = branches[i], &b = branches[k];
        if (a.source == b.source || a.source == b.target || a.target == b.source || a.target == b.target)
          continue;
        const bool a_is_sac = is_sac(a.target), b_is_sac = is_sac(b.target);
        if ((a_is_sac && (b_is_sac || is_at_side(b))) || (b_is_sac && is_at_side(a)))
          continue;
        for (std::size_t p = 0; p < a.points.size(); ++p)
          for (std::size_t q = 0; q < b.points.size(); ++q)
            if (tubular::internal::point_distance(a.points[p], b.points[q]) < 1.5 * (a.radius[p] + b.radius[q]))
              return false;
      }
    return true;
  }

  bool is_at_side(const Skeleton::Branch& b) const { return b.source == side_.node || b.target == side_.node; }

  Dice& dice_;
  Skeleton skeleton_;
  Side_branch side_;
  std::array<std::size_t, 2> sac_ = {{0, 0}}; ///< its nodes: from and to
};

/* What a case is made of, and the truth about it. */
struct Case {
  Mesh mesh;
  std::vector<int> labels; ///< of its faces: 1 the wall, the others one end each; empty: none
  std::size_t openings = 0, parts = 0;
  bool is_damaged = false;
  std::string what; ///< for the person who looks into it
};

/* How the ends of a vessel are. */
enum class Style { open, flat, round, open_or_flat, domed };

inline const char* name_of(Kind kind) {
  return kind == Kind::open ? "open" : kind == Kind::flat ? "flat" : "round";
}

inline Kind kind_of_end(Style style, Dice& dice) {
  switch (style) {
  case Style::flat:
    return Kind::flat;
  case Style::round:
    return Kind::round;
  case Style::open_or_flat:
    return dice.is_under(0.5) ? Kind::open : Kind::flat;
  default:
    return Kind::open;
  }
}

/* One vessel, of its own size, around the origin; its ends' labels are numbered on from `last_label`. */
inline Mesh make_vessel(Dice& dice, Style style, int& last_label, Case& c) {
  Side side;
  side.has_branch = dice.is_under(0.4);
  side.has_sac = dice.is_under(0.25);
  const bool is_closed_round = style == Style::round || style == Style::domed;
  side.is_stub = is_closed_round && dice.is_under(0.5);
  const bool is_flush = side.has_branch && !is_closed_round && dice.is_under(0.7);
  Tree_maker maker(dice);
  const Skeleton tree = maker.make(dice.number(0, 2), side);
  Mesh mesh = round_tree(tree, dice.number(12, 28));
  Mesh::Property_map<Mesh::Face_index, int> label = mesh.add_property_map<Mesh::Face_index, int>("f:label", 1).first;
  c.what += " [tree of " + std::to_string(tree.branches.size()) + " branches" + (side.has_sac ? " with a sac" : "") +
            (side.has_branch && side.is_stub ? " with a stub" : "") + ":";
  for (const End& end : tree.ends()) {
    if (maker.is_sac(end.node))
      continue;
    const auto& branch = maker.side_branch();
    ++c.openings;
    if (is_flush && end.node == branch.end) {
      const double stub = dice.between(0.08, 0.3);
      const Vector out = branch.along - branch.along.z() * Vector(0, 0, 1); // across the trunk
      const Vector normal = out / std::sqrt(out.squared_length());
      cut_end(mesh, end.center, end.radius, tree.nodes[branch.node] + (1 + stub) * normal, normal);
      c.what += " flush, radius " + std::to_string(branch.radius) + ", " + std::to_string(stub) + " off";
      continue;
    }
    const Kind kind = kind_of_end(style, dice);
    const std::vector<Mesh::Face_index> cap = finish_end(mesh, end, kind);
    if (!cap.empty())
      ++last_label;
    for (auto f : cap)
      label[f] = last_label;
    c.what += std::string(" ") + (style == Style::domed ? "domed" : name_of(kind));
  }
  if (style == Style::domed) {
    const double height = dice.between(0.35, 1.6);
    for (const auto& dome : dome_openings(mesh, height)) {
      ++last_label;
      for (auto f : dome)
        label[f] = last_label;
    }
    c.what += ", of height " + std::to_string(height);
  }
  c.what += "]";
  mesh.collect_garbage();
  return mesh;
}

/* One whose surface does not cross itself: the generator's may, in the narrow folds between the lobes of a sac. */
inline Mesh make_clean_vessel(Dice& dice, Style style, int& last_label, Case& c) {
  for (;;) {
    Case tried = c;
    int label = last_label;
    Mesh mesh = make_vessel(dice, style, label, tried);
    if (CGAL::Polygon_mesh_processing::does_self_intersect(mesh))
      continue;
    last_label = label;
    c = tried;
    return mesh;
  }
}

/* Throws single vertices out of place, in or out, by less than a radius. */
inline void add_spikes(Dice& dice, Mesh& mesh, Case& c) {
  const int number = dice.number(1, 6);
  for (int k = 0; k < number; ++k) {
    const Mesh::Vertex_index v(Mesh::size_type(dice.number(0, int(mesh.number_of_vertices()) - 1)));
    double longest = 0;
    Vector normal(0, 0, 0);
    for (auto h : CGAL::halfedges_around_target(mesh.halfedge(v), mesh)) {
      longest = std::max(longest, tubular::internal::point_distance(mesh.point(v), mesh.point(mesh.source(h))));
      if (!mesh.is_border(h))
        normal = normal + tubular::internal::area_vector(h, mesh);
    }
    mesh.point(v) = mesh.point(v) + dice.between(-3, 3) * longest * normalized(normal);
  }
  c.is_damaged = true;
  c.what += " spikes: " + std::to_string(number);
}

inline Case make_case(unsigned number) {
  Dice dice(1000 + number);
  Case c;
  c.what = "case " + std::to_string(number) + ":";
  const int parts = dice.is_under(0.6) ? 1 : dice.number(2, 3);
  const bool has_labels = dice.is_under(0.4);
  int last_label = 1;
  for (int k = 0; k < parts; ++k) {
    const Style style = Style(dice.number(0, 4));
    Mesh part = make_clean_vessel(dice, style, last_label, c);
    const double size = k == 0 ? 1 : dice.between(0.5, 1);
    for (auto v : part.vertices()) {
      const Point& p = part.point(v);
      part.point(v) = Point(size * p.x() + 60. * k, size * p.y(), size * p.z());
    }
    auto label = part.add_property_map<Mesh::Face_index, int>("f:label", 1).first; // that which it has
    for (auto f : part.faces())
      c.labels.push_back(label[f]);
    part.remove_property_map(label);
    c.mesh += part;
  }
  if (!has_labels || last_label == 1)
    c.labels.clear();
  else
    c.what += " with labels";
  c.parts = std::size_t(parts);
  if (dice.is_under(0.15))
    add_spikes(dice, c.mesh, c);
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
