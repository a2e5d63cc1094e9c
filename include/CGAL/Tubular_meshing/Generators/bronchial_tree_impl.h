// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_GENERATORS_BRONCHIAL_TREE_IMPL_H
#define CGAL_TUBULAR_MESHING_GENERATORS_BRONCHIAL_TREE_IMPL_H

#include <CGAL/Tubular_meshing/Generators/Tubular_skeleton.h>
#include <CGAL/Tubular_meshing/Generators/bronchial_tree.h>
#include <CGAL/Tubular_meshing/Generators/internal/skeleton_curves.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace CGAL::Tubular_meshing {

namespace internal {

/* Divides space as a lung does: each branch supplies a box; its end is part of the way to the box's centre, and its two
 * children supply the two halves, the box being cut across its longest side. With sides in the ratio 1 : 2^(1/3) :
 * 2^(2/3) all boxes are similar, lengths shrink by 2^(-1/3) a generation (Weibel's rule), the planes of successive
 * bifurcations turn by 90 degrees, and branches of different boxes keep apart. The twigs of late generations would meet
 * the thick branches whose boxes they fill: a branch whose children would come too near to others remains an end.
 * Compare M. Tawhai et al., Generation of an anatomically based three-dimensional model of the conducting airways,
 * 2000. */
class Bronchial_tree_builder {
public:
  explicit Bronchial_tree_builder(std::size_t number_of_branches) {
    grow_trachea();
    for (std::size_t i = 0; shoots_.size() < number_of_branches; ++i) {
      if (i == shoots_.size())
        throw Parameter_error("a bronchial tree of " + std::to_string(number_of_branches) +
                              " branches has no room for them all; ask for fewer than " +
                              std::to_string(shoots_.size() + 1) + ".");
      const Shoot children[2] = {child(i, 0), child(i, 1)};
      if (has_room(children[0]) && has_room(children[1]))
        for (const Shoot& c : children)
          add(c);
    }
  }

  Tubular_skeleton skeleton() const {
    Tubular_skeleton s;
    s.nodes.push_back(shoots_[0].from);
    for (const Shoot& shoot : shoots_)
      s.nodes.push_back(shoot.to);
    for (std::size_t i = 0; i < shoots_.size(); ++i) {
      const Shoot& shoot = shoots_[i];
      const double r = shoot.radius();
      s.add_branch(i == 0 ? 0 : shoot.parent + 1, i + 1, shoot.curve(), Smooth_taper{r, r});
    }
    return s;
  }

  static constexpr double trachea_radius = 9;

private:
  struct Shoot {
    std::size_t parent;
    int generation;
    Point_3 from, to;
    Vector_3 start, finish;             // tangents
    std::array<double, 3> lower, upper; // of the box that its children share

    double radius() const { return trachea_radius * std::pow(0.5, generation / 3.); }
    Hermite_curve curve() const { return Hermite_curve(from, start, to, finish); }
  };
  struct Probe { // a point on a shoot's curve
    std::size_t shoot;
    Point_3 point;
  };
  typedef std::array<int, 3> Grid_cell;
  typedef std::unordered_map<std::int64_t, std::vector<Probe>> Grid;

  static double box_size() { return 290; }

  void grow_trachea() {
    const double x = box_size(), y = x * std::pow(0.5, 2 / 3.), z = x * std::pow(0.5, 1 / 3.);
    Shoot t;
    t.parent = 0;
    t.generation = 0;
    t.lower = {-x / 2, -y / 2, -z};
    t.upper = {x / 2, y / 2, 0};
    t.from = Point_3(0, 0, 0.2 * z);
    t.to = Point_3(0, 0, -0.22 * z);
    t.start = t.finish = Vector_3(0, 0, -1);
    add(t);
  }

  Shoot child(std::size_t i, int side) const {
    const Shoot& parent = shoots_[i];
    Shoot child;
    child.parent = i;
    child.generation = parent.generation + 1;
    child.lower = parent.lower;
    child.upper = parent.upper;
    const std::size_t axis = longest_side(parent);
    (side == 0 ? child.upper : child.lower)[axis] = (parent.lower[axis] + parent.upper[axis]) / 2;
    child.from = parent.to;
    const Vector_3 to_center = center(child) - child.from;
    child.to = child.from + reach * to_center;
    child.start = to_center + 0.3 * (parent.to - parent.from);
    child.finish = to_center - 0.15 * (parent.to - parent.from);
    return child;
  }

  void add(const Shoot& shoot) {
    const Hermite_curve curve = shoot.curve();
    if (grids_.size() <= std::size_t(shoot.generation))
      grids_.emplace_back();
    for (int k = 0; k <= probes; ++k) {
      const Point_3 p = curve(double(k) / probes);
      grids_.back()[grid_key(grid_cell(p, shoot.radius()))].push_back(Probe{shoots_.size(), p});
    }
    shoots_.push_back(shoot);
  }

  // Whether all branches but the parent and sibling are at a distance of 1.7 times the sum of the radii, or more.
  bool has_room(const Shoot& shoot) const {
    const Hermite_curve curve = shoot.curve();
    for (const Grid& grid : grids_)
      for (int k = 0; k <= probes; ++k)
        if (is_near_other(curve(double(k) / probes), shoot, grid,
                          trachea_radius * std::pow(0.5, (&grid - &grids_[0]) / 3.)))
          return false;
    return true;
  }

  bool is_near_other(const Point_3& p, const Shoot& shoot, const Grid& grid, double radius) const {
    const double least = clearance * (shoot.radius() + radius);
    const Grid_cell at = grid_cell(p, radius);
    for (int x = at[0] - 1; x <= at[0] + 1; ++x)
      for (int y = at[1] - 1; y <= at[1] + 1; ++y)
        for (int z = at[2] - 1; z <= at[2] + 1; ++z) {
          const auto found = grid.find(grid_key({{x, y, z}}));
          if (found == grid.end())
            continue;
          for (const Probe& probe : found->second)
            if (probe.shoot != shoot.parent && (probe.point - p).squared_length() < least * least)
              return true;
        }
    return false;
  }

  // One grid a generation; cells are as wide as the distance that matters to shoots of the same and later generations.
  static Grid_cell grid_cell(const Point_3& p, double radius) {
    const double size = clearance * 2 * radius;
    return {{int(std::floor(p.x() / size)), int(std::floor(p.y() / size)), int(std::floor(p.z() / size))}};
  }

  static std::int64_t grid_key(const Grid_cell& c) { return (std::int64_t(c[0]) * 2097152 + c[1]) * 2097152 + c[2]; }

  static std::size_t longest_side(const Shoot& s) {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (s.upper[i] - s.lower[i] > 1.01 * (s.upper[longest] - s.lower[longest]))
        longest = i;
    return longest;
  }

  static Point_3 center(const Shoot& s) {
    return Point_3((s.lower[0] + s.upper[0]) / 2, (s.lower[1] + s.upper[1]) / 2, (s.lower[2] + s.upper[2]) / 2);
  }

  static constexpr double reach = 0.62; // how far towards the centre of its box a branch goes

  static constexpr int probes = 16;
  static constexpr double clearance = 1.7; // of the sum of two radii

  std::vector<Shoot> shoots_;
  std::vector<Grid> grids_;
};

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Tubular_skeleton bronchial_tree(std::size_t number_of_branches) {
  if (number_of_branches % 2 == 0)
    throw Parameter_error("a bronchial tree has an odd number of branches, since each bifurcation adds two; " +
                          std::to_string(number_of_branches) + " is even: ask for one more or one less.");
  return internal::Bronchial_tree_builder(number_of_branches).skeleton();
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_GENERATORS_BRONCHIAL_TREE_IMPL_H
