// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_JUNCTION_SHAPE_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_JUNCTION_SHAPE_H

#include <CGAL/Tubular_meshing/Hexahedra/internal/Junction_partition.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Vessel_network.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Wall_of_lumen.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Wall_rings.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Where a junction's blocks begin. What suits one junction does not suit another: several are tried. */
struct Junction_start {
  double depth = 1;      // of the center below the place where a vessel leaves the others, in its radii
  double weight = 4;     // with which power of their radii thin vessels draw the center to them
  double turning = 3;    // how much it costs to turn away from the bisector between vessels, to their crotch
  bool by_sight = false; // a vessel leaves the others where the wall comes between them, see parting_abscissas()

  static const std::vector<Junction_start>& tries() {
    static const std::vector<Junction_start> all = {
        {1, 4, 3},   {1, 4, 3, true},   {1, 4, 30},        {1, 2, 3},         {0.5, 4, 3},
        {1.5, 4, 3}, {1, 0, 3},         {0.5, 2, 3},       {1.5, 2, 30},      {0.5, 0, 30},
        {0.2, 3, 3}, {0.5, 4, 3, true}, {1.5, 2, 3, true}, {0.2, 2, 30, true}};
    return all;
  }
};

/* How far from their node the vessels leave each other's tubes. */
inline std::vector<double> exit_abscissas(const std::vector<Vessel_path>& paths) {
  std::vector<double> exits;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const double r = paths[i].radii.front(), last = (std::min)(paths[i].length(), 12 * r);
    double a = 0;
    const auto is_inside = [&](const Vector_3d& p) {
      for (std::size_t j = 0; j < paths.size(); ++j)
        if (j != i && paths[j].distance_in_radii(p, 20 * r) < 1)
          return true;
      return false;
    };
    while (a < last && is_inside(paths[i].point(a)))
      a += r / 8;
    exits.push_back((std::min)(a, paths[i].length()));
  }
  return exits;
}

/* How far from their node the wall comes between the vessels, beyond the places where they leave each other's tubes: up
 * to there, a section of one sees the other. */
inline std::vector<double> parting_abscissas(const std::vector<Vessel_path>& paths, std::vector<double> exits,
                                             const Wall_of_lumen& wall) {
  constexpr double farthest = 40; // in radii
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const double r = paths[i].radii.front(), last = (std::min)(paths[i].length(), farthest * r);
    const auto is_parted = [&](double a) {
      const Vector_3d p = paths[i].point(a);
      for (std::size_t j = 0; j < paths.size(); ++j) {
        if (j == i)
          continue;
        const double b = paths[j].nearest(p, 2 * farthest * r);
        if (b == 0) // beside the node: it leads the other way
          continue;
        const Vector_3d d = paths[j].point(b) - p;
        const double distance = norm(d);
        if (!(distance > 0) || !(wall.along(p, (1 / distance) * d, distance) < distance))
          return false;
      }
      return true;
    };
    while (exits[i] < last && !is_parted(exits[i]))
      exits[i] += r / 8;
    exits[i] = (std::min)(exits[i], last);
  }
  return exits;
}

/* A junction's center, the regions of its vessels as seen from there, and the wall between each two of them. */
class Junction_shape {
public:
  std::vector<double> exits; // of the vessels, see exit_abscissas()
  Vector_3d center;
  std::optional<Junction_partition> partition;     // none if there is none
  std::vector<Vector_3d> corner_points;            // on the wall
  std::vector<std::vector<Vector_3d>> side_points; // on the wall, from corner to corner, both included

  /* `steps`: from a corner to the next. */
  Junction_shape(const Vessel_network& network, std::size_t node, const Wall_rings& rings, const Wall_of_lumen& wall,
                 const Junction_start& start, int steps)
      : rings_(&rings)
      , wall_(&wall)
      , start_(start) {
    const std::vector<Vessel_path> paths = network.paths_from(node);
    exits = exit_abscissas(paths);
    if (start.by_sight) {
      std::vector<double> partings = parting_abscissas(paths, exits, wall);
      if (partings == exits) // as without
        return;
      exits = std::move(partings);
    }
    place(paths);
    partition = Junction_partitioner(directions_).partition();
    if (partition)
      find_wall(steps);
  }

  // Round one of the vessels.
  Wall_ring ring(std::size_t region) const {
    const Junction_partition::Region& r = partition->regions[region];
    Wall_ring result{center, {}};
    for (std::size_t q = 0; q < 4; ++q) {
      const std::vector<Vector_3d>& points = side_points[r.sides[q]];
      for (std::size_t i = 0; i + 1 < points.size(); ++i)
        result.points.push_back(points[r.forward[q] ? i : points.size() - 1 - i]);
    }
    return result;
  }

private:
  void place(const std::vector<Vessel_path>& paths) {
    Vector_3d sum;
    double weights = 0;
    std::vector<double> radii;
    for (std::size_t i = 0; i < paths.size(); ++i) {
      radii.push_back(paths[i].radius((std::min)(1.5 * exits[i], paths[i].length())));
      const double w = std::pow(radii[i], -start_.weight);
      sum += w * paths[i].point((std::max)(exits[i] - start_.depth * radii[i], 0.));
      weights += w;
    }
    center = (1 / weights) * sum;
    reach_ = 4 * *std::max_element(radii.begin(), radii.end());
    for (std::size_t i = 0; i < paths.size(); ++i)
      directions_.push_back(
          normalized(paths[i].point((std::min)(exits[i] + 0.75 * radii[i], paths[i].length())) - center));
  }

  void find_wall(int steps) {
    const Junction_partition& p = *partition;
    // a corner between two vessels lies in their crotch
    std::vector<std::vector<std::size_t>> sides_at(p.corners.size());
    for (std::size_t k = 0; k < p.sides.size(); ++k) {
      sides_at[p.sides[k].from].push_back(k);
      sides_at[p.sides[k].to].push_back(k);
    }
    std::vector<double> corner_turn(p.corners.size(), 0);
    for (std::size_t c = 0; c < p.corners.size(); ++c) {
      const Junction_partition::Side& side = p.sides[sides_at[c].front()];
      if (sides_at[c].size() == 2)
        corner_turn[c] = turn_to_crotch(side, p.corners[c]);
      corner_points.push_back(seen(turned(side, p.corners[c], corner_turn[c])));
    }
    for (const Junction_partition::Side& side : p.sides) {
      std::vector<Vector_3d> directions;
      for (int i = 0; i <= steps; ++i) {
        const double t = 2. * i / steps;
        directions.push_back(t <= 1 ? on_arc(p.corners[side.from], side.middle, t)
                                    : on_arc(side.middle, p.corners[side.to], t - 1));
      }
      const std::vector<double> turns = turns_to_crotch(side, directions, corner_turn[side.from], corner_turn[side.to]);
      std::vector<Vector_3d> points{corner_points[side.from]};
      for (int i = 1; i < steps; ++i)
        points.push_back(seen(turned(side, directions[i], turns[i])));
      points.push_back(corner_points[side.to]);
      side_points.push_back(std::move(points));
    }
  }

  Vector_3d seen(const Vector_3d& direction) const { return rings_->seen(center, direction, reach_); }

  static Vector_3d on_arc(const Vector_3d& a, const Vector_3d& b, double t) {
    const double angle = std::atan2(norm(cross(a, b)), dot(a, b));
    if (angle < 1e-6)
      return a;
    return (1 / std::sin(angle)) * (std::sin((1 - t) * angle) * a + std::sin(t * angle) * b);
  }

  // A direction between two vessels, turned toward the one on the left of the side.
  Vector_3d turned(const Junction_partition::Side& side, const Vector_3d& d, double angle) const {
    const Vector_3d across = directions_[side.regions[0]] - directions_[side.regions[1]];
    return std::cos(angle) * d + std::sin(angle) * normalized(across - dot(across, d) * d);
  }

  /* By how much a direction between two vessels is to be turned to see the crotch between them: where the wall is
   * nearest. */
  double turn_to_crotch(const Junction_partition::Side& side, const Vector_3d& d) const {
    constexpr int steps = 8;
    double step = 0.06, middle = 0;
    for (int round = 0; round < 3; ++round) {
      double least = (std::numeric_limits<double>::infinity)(), best = middle;
      for (int k = -steps; k <= steps; ++k) {
        const double angle = middle + step * k;
        const double cost = wall_->along(center, turned(side, d, angle), reach_) * (1 + start_.turning * angle * angle);
        if (cost < least) {
          least = cost;
          best = angle;
        }
      }
      middle = best;
      step /= steps;
    }
    return middle;
  }

  // The same along a side, from `first` at its one end to `last` at the other.
  std::vector<double> turns_to_crotch(const Junction_partition::Side& side, const std::vector<Vector_3d>& directions,
                                      double first, double last) const {
    std::vector<double> result(directions.size(), first);
    result.back() = last;
    for (std::size_t i = 1; i + 1 < directions.size(); ++i)
      result[i] = turn_to_crotch(side, directions[i]);
    for (int round = 0; round < 2; ++round) {
      const std::vector<double> before = result;
      for (std::size_t i = 1; i + 1 < result.size(); ++i)
        result[i] = 0.5 * before[i] + 0.25 * (before[i - 1] + before[i + 1]);
    }
    return result;
  }

  const Wall_rings* rings_;
  const Wall_of_lumen* wall_;
  Junction_start start_;
  std::vector<Vector_3d> directions_; // of the vessels
  double reach_ = 0;                  // how far from the center its wall is at most
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_JUNCTION_SHAPE_H
