// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_BLOCK_BUILDER_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_BLOCK_BUILDER_H

#include <CGAL/Tubular_meshing/Hexahedra/internal/Disc_grid.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Junction_partition.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Vessel_network.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Wall_of_lumen.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Plane_frame.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Points of the wall round a vessel, from its axis 0 on, counterclockwise seen against the direction of its path, and
 * the point inside from which they are seen. */
struct Wall_ring {
  Vector_3d center;
  std::vector<Vector_3d> points;

  // Between two points, where the step is no whole number.
  Vector_3d at(double step) const {
    const double whole = std::floor(step);
    const std::size_t n = points.size(), i = std::size_t(whole) % n;
    const double t = step - whole;
    return (1 - t) * points[i] + t * points[(i + 1) % n];
  }
};

/* Builds hexahedra along the vessels of a network. */
class Block_builder {
public:
  typedef std::uint32_t Index;

  Block_builder(const Vessel_network& network, const Wall_of_lumen& wall,
                const std::map<int, std::vector<Vector_3d>>& rims, Length_function size, int subdivision)
      : network_(network)
      , wall_(wall)
      , rims_(rims)
      , size_(size)
      , disc_(subdivision)
      , s_(subdivision)
      , around_(8 * subdivision) {}

  // Which junctions have no partition.
  const std::vector<std::size_t>& refused() const { return refused_; }

  Mixed_mesh build() {
    junctions_.resize(network_.nodes.size());
    for (std::size_t n = 0; n < network_.nodes.size(); ++n)
      if (network_.nodes[n].is_junction())
        make_junction(n);
    if (refused_.empty())
      for (std::size_t v = 0; v < network_.vessels.size(); ++v)
        make_vessel(v);
    return std::move(mesh_);
  }

private:
  static constexpr double corner_distance = 0.72; // of the core's corners from the center, 1 at the wall

  // The vertices of a section: those of the core, and of the wall round it.
  struct Section {
    std::vector<Index> core, wall;
    std::vector<Index> dome; // of a blind end: on the wall, above those of the core
  };
  struct Junction {
    Junction_partition partition;
    Vector_3d center;
    std::vector<Vector_3d> directions; // of the vessels
    double reach; // how far from the center its wall is at most
    std::vector<Wall_ring> rings; // of each region, counterclockwise about its direction outward
    std::vector<Section> sections;
  };

  // --- junctions ---

  /* How far from the node a vessel leaves the others' tubes. */
  double exit_abscissa(const std::vector<Vessel_path>& paths, std::size_t i) const {
    const Vessel_path& path = paths[i];
    const double step = path.radius(0) / 8, last = (std::min)(path.length(), 12 * path.radius(0));
    double exit = 0;
    for (double a = 0; a < last; a += step) {
      const Vector_3d p = path.point(a);
      bool inside = false;
      for (std::size_t j = 0; j < paths.size() && !inside; ++j)
        if (j != i)
          inside = is_within(p, paths[j]);
      if (!inside)
        break;
      exit = a + step;
    }
    return (std::min)(exit, path.length());
  }
  static bool is_within(const Vector_3d& p, const Vessel_path& path) {
    double nearest = (std::numeric_limits<double>::infinity)(), radius = 0;
    for (std::size_t k = 0; k + 1 < path.points.size(); ++k) {
      const Vector_3d a = path.points[k], d = path.points[k + 1] - a;
      const double t = (std::min)((std::max)(dot(p - a, d) / squared_norm(d), 0.), 1.);
      const double d2 = squared_norm(a + t * d - p);
      if (d2 < nearest) {
        nearest = d2;
        radius = (1 - t) * path.radii[k] + t * path.radii[k + 1];
      }
      if (path.abscissa[k] > 20 * path.radii[0])
        break;
    }
    return nearest < radius * radius;
  }

  void make_junction(std::size_t n) {
    const Vessel_network::Node& node = network_.nodes[n];
    Junction& j = junctions_[n];
    std::vector<Vessel_path> paths;
    for (const auto& e : node.ends)
      paths.push_back(network_.path_from(e));
    std::vector<double> exits, radii;
    Vector_3d sum;
    double weights = 0;
    for (std::size_t i = 0; i < paths.size(); ++i) {
      exits.push_back(exit_abscissa(paths, i));
      const double r = paths[i].radius((std::min)(1.5 * exits[i], paths[i].length()));
      radii.push_back(r);
      const double w = 1 / (r * r * r * r);
      sum += w * paths[i].point((std::max)(exits[i] - r, 0.));
      weights += w;
    }
    j.center = (1 / weights) * sum;
    j.reach = 4 * *std::max_element(radii.begin(), radii.end());
    std::vector<Vector_3d>& directions = j.directions;
    for (std::size_t i = 0; i < paths.size(); ++i)
      directions.push_back(
          normalized(paths[i].point((std::min)(exits[i] + 0.75 * radii[i], paths[i].length())) - j.center));
#ifdef HXDEBUG
    std::printf("junction %zu node (%.4f %.4f %.4f) center (%.4f %.4f %.4f)\n", n, node.point.x, node.point.y,
                node.point.z, j.center.x, j.center.y, j.center.z);
    for (std::size_t i = 0; i < paths.size(); ++i)
      std::printf("   vessel %zu length %.4f exit %.4f radius %.4f at node %.4f direction %.3f %.3f %.3f\n",
                  node.ends[i].vessel, paths[i].length(), exits[i], radii[i], paths[i].radii[0], directions[i].x,
                  directions[i].y, directions[i].z);
#endif
    const auto partition = Junction_partitioner(directions).partition();
    if (!partition) {
      refused_.push_back(n);
      return;
    }
    j.partition = *partition;
    make_junction_vertices(j);
  }

  static Vector_3d between(const Vector_3d& a, const Vector_3d& b, double t) {
    const double angle = std::atan2(norm(cross(a, b)), dot(a, b));
    if (angle < 1e-6)
      return a;
    return (std::sin((1 - t) * angle) / std::sin(angle)) * a + (std::sin(t * angle) / std::sin(angle)) * b;
  }

  // The wall seen from p, no farther than the bound.
  Vector_3d wall_from(const Vector_3d& p, const Vector_3d& d, double bound) const {
    const double hit = wall_.along(p, d, bound);
    return hit < bound ? p + hit * d : wall_.nearest(p + 0.5 * bound * d);
  }

  // A direction between two vessels, turned toward the one on the left of the side.
  static Vector_3d turned(const Junction& j, const Junction_partition::Side& side, const Vector_3d& d, double angle) {
    const Vector_3d across = j.directions[side.regions[0]] - j.directions[side.regions[1]];
    return std::cos(angle) * d + std::sin(angle) * normalized(across - dot(across, d) * d);
  }

  /* By how much a direction between two vessels is to be turned to see the crotch between them: where the wall is
   * nearest. */
  double turn_to_crotch(const Junction& j, const Junction_partition::Side& side, const Vector_3d& d) const {
    constexpr int steps = 8;
    double step = 0.06, middle = 0;
    const auto cost = [&](double angle) {
      return wall_.along(j.center, turned(j, side, d, angle), j.reach) * (1 + 3 * angle * angle);
    };
    for (int round = 0; round < 3; ++round) {
      double least = (std::numeric_limits<double>::infinity)(), best = middle;
      for (int k = -steps; k <= steps; ++k) {
        const double c = cost(middle + step * k);
        if (c < least) {
          least = c;
          best = middle + step * k;
        }
      }
      middle = best;
      step /= steps;
    }
    return middle;
  }

  /* The same along a side, from `first` at its one end to `last` at the other. */
  std::vector<double> turns_to_crotch(const Junction& j, const Junction_partition::Side& side,
                                      const std::vector<Vector_3d>& directions, double first, double last) const {
    std::vector<double> result(directions.size(), first);
    result.back() = last;
    for (std::size_t i = 1; i + 1 < directions.size(); ++i)
      result[i] = turn_to_crotch(j, side, directions[i]);
    for (int round = 0; round < 2; ++round) {
      const std::vector<double> before = result;
      for (std::size_t i = 1; i + 1 < result.size(); ++i)
        result[i] = 0.5 * before[i] + 0.25 * (before[i - 1] + before[i + 1]);
    }
    return result;
  }

  void make_junction_vertices(Junction& j) {
    const Junction_partition& p = j.partition;
    // the wall along each side, both corners included
    std::vector<std::vector<Vector_3d>> side_points(p.sides.size());
    std::vector<Vector_3d> corner_points;
    // a corner between two vessels lies in their crotch
    std::vector<std::vector<std::size_t>> sides_at(p.corners.size());
    for (std::size_t k = 0; k < p.sides.size(); ++k) {
      sides_at[p.sides[k].from].push_back(k);
      sides_at[p.sides[k].to].push_back(k);
    }
    std::vector<double> corner_turn(p.corners.size(), 0);
    for (std::size_t c = 0; c < p.corners.size(); ++c) {
      const auto& side = p.sides[sides_at[c].front()];
      if (sides_at[c].size() == 2)
        corner_turn[c] = turn_to_crotch(j, side, p.corners[c]);
      corner_points.push_back(wall_from(j.center, turned(j, side, p.corners[c], corner_turn[c]), j.reach));
    }
    for (std::size_t k = 0; k < p.sides.size(); ++k) {
      const auto& side = p.sides[k];
      std::vector<Vector_3d>& points = side_points[k];
      std::vector<Vector_3d> directions;
      for (int i = 0; i <= 2 * s_; ++i)
        directions.push_back(i <= s_ ? between(p.corners[side.from], side.middle, double(i) / s_)
                                     : between(side.middle, p.corners[side.to], double(i - s_) / s_));
      const std::vector<double> turns = turns_to_crotch(j, side, directions, corner_turn[side.from], corner_turn[side.to]);
      points.push_back(corner_points[side.from]);
      for (int i = 1; i < 2 * s_; ++i)
        points.push_back(wall_from(j.center, turned(j, side, directions[i], turns[i]), j.reach));
      points.push_back(corner_points[side.to]);
    }
#ifdef HXDEBUG
    for (std::size_t k = 0; k < p.sides.size(); ++k)
      for (std::size_t i = 0; i < side_points[k].size(); ++i)
        std::printf("    side %zu regions %zu %zu point %.3f %.3f %.3f distance %.3f wall %.4f\n", k, p.sides[k].regions[0], p.sides[k].regions[1], side_points[k][i].x, side_points[k][i].y, side_points[k][i].z, norm(side_points[k][i] - j.center), wall_.distance(side_points[k][i]));
#endif
    std::vector<Index> corner_wall, side_wall(p.sides.size() * (2 * s_ + 1));
    for (const Vector_3d& q : corner_points)
      corner_wall.push_back(add(q));
    const auto wall_at = [&](std::size_t side, int i) -> Index& { return side_wall[side * (2 * s_ + 1) + i]; };
    for (std::size_t k = 0; k < p.sides.size(); ++k) {
      wall_at(k, 0) = corner_wall[p.sides[k].from];
      wall_at(k, 2 * s_) = corner_wall[p.sides[k].to];
      for (int i = 1; i < 2 * s_; ++i)
        wall_at(k, i) = add(side_points[k][i]);
    }
    // the core: a vertex is known by its center, its corner and place on the axis, or its side and place in the square
    std::map<std::array<std::size_t, 4>, Index> core;
    for (const Junction_partition::Region& r : p.regions) {
      Wall_ring ring{j.center, {}};
      Section section;
      for (std::size_t q = 0; q < 4; ++q)
        for (int i = 0; i < 2 * s_; ++i) {
          const int k = r.forward[q] ? i : 2 * s_ - i;
          ring.points.push_back(side_points[r.sides[q]][k]);
          section.wall.push_back(wall_at(r.sides[q], k));
        }
      for (std::size_t v = 0; v < disc_.size(); ++v) {
        const Disc_grid::Place& place = disc_.place(v);
        std::array<std::size_t, 4> key{{0, 0, 0, 0}};
        if (place.y > 0)
          key = {{2, r.sides[place.quadrant], std::size_t(r.forward[place.quadrant] ? place.x : place.y),
                  std::size_t(r.forward[place.quadrant] ? place.y : place.x)}};
        else if (place.x > 0)
          key = {{1, r.corners[place.quadrant], std::size_t(place.x), 0}};
        const auto found = core.find(key);
        if (found != core.end()) {
          section.core.push_back(found->second);
          continue;
        }
        section.core.push_back(add(core_point(ring, v)));
        core.emplace(key, section.core.back());
      }
      j.rings.push_back(std::move(ring));
      j.sections.push_back(std::move(section));
    }
  }

  Vector_3d core_point(const Wall_ring& ring, std::size_t v) const {
    const Disc_grid::Polar p = disc_.polar(v, corner_distance);
    return ring.center + p.distance * (ring.at(p.step) - ring.center);
  }

  // --- vessels ---

  /* Axes across a path that turn no more than the path does. */
  struct Frames {
    std::vector<double> abscissa;
    std::vector<Vector_3d> tangent, u;

    Frames(const Vessel_path& path, std::size_t n) {
      for (std::size_t i = 0; i <= n; ++i) {
        const double a = path.length() * double(i) / double(n);
        const Vector_3d t = path.tangent(a, 1.5 * path.radius(a));
        abscissa.push_back(a);
        Vector_3d w = i == 0 ? Plane_frame(path.points[0], t).u : u.back();
        w = normalized(w - dot(w, t) * t);
        tangent.push_back(t);
        u.push_back(w);
      }
    }
    std::pair<Vector_3d, Vector_3d> at(double a) const {
      const auto next = std::upper_bound(abscissa.begin() + 1, abscissa.end() - 1, a);
      const std::size_t i = std::size_t(next - abscissa.begin()) - 1;
      const double t = (std::min)((std::max)((a - abscissa[i]) / (abscissa[i + 1] - abscissa[i]), 0.), 1.);
      const Vector_3d d = normalized((1 - t) * tangent[i] + t * tangent[i + 1]);
      const Vector_3d w = (1 - t) * u[i] + t * u[i + 1];
      return {d, normalized(w - dot(w, d) * d)};
    }
  };

  // The mean angle by which a ring is turned against the axes, and how far it reaches along the path, and back.
  struct Ring_place {
    double turn, ahead, behind;
  };
  Ring_place place_of(const Wall_ring& ring, const Vector_3d& tangent, const Vector_3d& u) const {
    const Vector_3d w = cross(tangent, u);
    double c = 0, s = 0, ahead = 0, behind = 0;
    for (int a = 0; a < around_; ++a) {
      const Vector_3d d = ring.points[a] - ring.center;
      const double angle = std::atan2(dot(d, w), dot(d, u)) - 2 * pi * a / around_;
      const double weight = std::hypot(dot(d, w), dot(d, u));
      c += weight * std::cos(angle);
      s += weight * std::sin(angle);
      ahead = (std::max)(ahead, dot(d, tangent));
      behind = (std::max)(behind, -dot(d, tangent));
    }
    return {std::atan2(s, c), ahead, behind};
  }

  // How far a ring reaches beyond a plane.
  static double reach(const Wall_ring& ring, const Vector_3d& p, const Vector_3d& normal) {
    double most = -(std::numeric_limits<double>::infinity)();
    for (const Vector_3d& q : ring.points)
      most = (std::max)(most, dot(q - p, normal));
    return most;
  }

  Wall_ring planar_ring(const Vector_3d& center, const Vector_3d& tangent, const Vector_3d& u, double turn) const {
    Wall_ring ring{center, {}};
    const Vector_3d w = cross(tangent, u);
    const double bound = 4 * wall_.distance(center);
    for (int a = 0; a < around_; ++a) {
      const double angle = turn + 2 * pi * a / around_;
      ring.points.push_back(wall_from(center, std::cos(angle) * u + std::sin(angle) * w, bound));
    }
    return ring;
  }

  // Round a blind end, half of the way from the vessel's side to its tip.
  Wall_ring dome_ring(const Vector_3d& center, const Vector_3d& tangent, const Vector_3d& u, double turn,
                      double ahead) const {
    Wall_ring ring{center, {}};
    const Vector_3d w = cross(tangent, u);
    const double bound = 4 * wall_.distance(center);
    for (int a = 0; a < around_; ++a) {
      const double angle = turn + 2 * pi * a / around_;
      const Vector_3d d = std::cos(angle) * u + std::sin(angle) * w + ahead * tangent;
      ring.points.push_back(wall_from(center, normalized(d), bound));
    }
    return ring;
  }

  /* The end of the core in a blind end, and what lies above it on the wall. */
  Section dome_section(const Wall_ring& ring, const Vector_3d& out) {
    Section section;
    for (const Vector_3d& p : ring.points)
      section.wall.push_back(add(p));
    section.dome.resize(disc_.size());
    for (int a = 0; a < around_; ++a)
      section.dome[disc_.boundary()[a]] = section.wall[a];
    const double bound = 4 * wall_.distance(ring.center);
    constexpr double core = 0.6; // of the way to the wall
    for (std::size_t v = 0; v < disc_.size(); ++v) {
      const Disc_grid::Place& place = disc_.place(v);
      const Disc_grid::Polar polar = disc_.polar(v, corner_distance);
      const Vector_3d d = ring.at(polar.step) - ring.center, across = normalized(d - dot(d, out) * out);
      const double tilt = double((std::max)(place.x, place.y)) / s_ * pi / 4;
      const Vector_3d top = (std::max)(place.x, place.y) == s_
                                ? ring.at(polar.step)
                                : wall_from(ring.center, normalized(std::cos(tilt) * out + std::sin(tilt) * across), bound);
      if ((std::max)(place.x, place.y) < s_)
        section.dome[v] = add(top);
      section.core.push_back(add(ring.center + core * (top - ring.center)));
    }
    return section;
  }

  // Round an opening: at equal distances along its rim, counterclockwise about the direction.
  Wall_ring rim_ring(int opening, const Vector_3d& tangent, const Vector_3d& u, double turn) const {
    std::vector<Vector_3d> rim = rims_.at(opening);
    Vector_3d center, normal;
    double area = 0;
    for (std::size_t i = 1; i + 1 < rim.size(); ++i)
      normal += cross(rim[i] - rim[0], rim[i + 1] - rim[0]);
    const Vector_3d unit = normalized(normal);
    for (std::size_t i = 1; i + 1 < rim.size(); ++i) {
      const double t = dot(unit, cross(rim[i] - rim[0], rim[i + 1] - rim[0]));
      center += (t / 3) * (rim[0] + rim[i] + rim[i + 1]);
      area += t;
    }
    center = (1 / area) * center;
    if (dot(normal, tangent) < 0)
      std::reverse(rim.begin(), rim.end());
    std::vector<double> at{0};
    for (std::size_t i = 0; i < rim.size(); ++i)
      at.push_back(at.back() + norm(rim[(i + 1) % rim.size()] - rim[i]));
    const auto point = [&](double t) {
      t = t - std::floor(t / at.back()) * at.back();
      const std::size_t i =
          (std::min)(std::size_t(std::upper_bound(at.begin() + 1, at.end(), t) - at.begin()) - 1, rim.size() - 1);
      return rim[i] + ((t - at[i]) / (at[i + 1] - at[i])) * (rim[(i + 1) % rim.size()] - rim[i]);
    };
    // the start for which the points' angles are those wanted on the mean
    Wall_ring ring{center, {}};
    double start = 0;
    for (int round = 0; round < 8; ++round) {
      ring.points.clear();
      for (int a = 0; a < around_; ++a)
        ring.points.push_back(point(start + at.back() * a / around_));
      const double off = place_of(ring, tangent, u).turn - turn;
      start -= std::remainder(off, 2 * pi) / (2 * pi) * at.back();
    }
    return ring;
  }

  Section section_of(const Wall_ring& ring) {
    Section section;
    for (std::size_t v = 0; v < disc_.size(); ++v)
      section.core.push_back(add(core_point(ring, v)));
    for (const Vector_3d& p : ring.points)
      section.wall.push_back(add(p));
    return section;
  }

  // As seen by a vessel that ends there, its axis 0 on the junction's axis `turns`.
  Section mirrored(const Section& section, int turns) const {
    Section result;
    for (std::size_t v = 0; v < disc_.size(); ++v)
      result.core.push_back(section.core[disc_.mirrored(v, turns)]);
    for (int a = 0; a < around_; ++a)
      result.wall.push_back(section.wall[std::size_t(2 * s_ * turns - a + 2 * around_) % around_]);
    return result;
  }
  Wall_ring mirrored(const Wall_ring& ring, int turns) const {
    Wall_ring result{ring.center, {}};
    for (int a = 0; a < around_; ++a)
      result.points.push_back(ring.points[std::size_t(2 * s_ * turns - a + 2 * around_) % around_]);
    return result;
  }

  std::size_t region_of(std::size_t node, std::size_t vessel, bool last) const {
    const auto& ends = network_.nodes[node].ends;
    std::size_t i = 0;
    while (ends[i].vessel != vessel || ends[i].last != last)
      ++i;
    return i;
  }

  // The vessel's path from center to center.
  Vessel_path path_of(std::size_t v) const {
    const auto& vessel = network_.vessels[v];
    const Vessel_path& path = vessel.path;
    std::array<double, 2> skipped{{0, 0}};
    std::array<Vector_3d, 2> end{{path.points.front(), path.points.back()}};
    for (int e = 0; e < 2; ++e) {
      const auto& node = network_.nodes[vessel.nodes[e]];
      if (node.is_junction()) {
        end[e] = junctions_[vessel.nodes[e]].center;
        std::vector<Vessel_path> paths;
        for (const auto& x : node.ends)
          paths.push_back(network_.path_from(x));
        skipped[e] = exit_abscissa(paths, region_of(vessel.nodes[e], v, e == 1));
      } else if (node.opening)
        end[e] = rim_center(node.opening);
      else {
        const Vessel_path from_tip = e == 0 ? path : path.reversed();
        skipped[e] = dome_depth(from_tip);
        end[e] = from_tip.point(skipped[e]);
      }
    }
    const double sum = skipped[0] + skipped[1];
    if (sum > 0.8 * path.length()) {
      skipped[0] *= 0.8 * path.length() / sum;
      skipped[1] *= 0.8 * path.length() / sum;
    }
    Vessel_path result;
    result.push_back(end[0], path.radii.front());
    const double first = skipped[0], last = path.length() - skipped[1];
    if (first > 0)
      result.push_back(path.point(first), path.radius(first));
    for (std::size_t i = 0; i < path.points.size(); ++i)
      if (path.abscissa[i] > first && path.abscissa[i] < last)
        result.push_back(path.points[i], path.radii[i]);
    if (last < path.length())
      result.push_back(path.point(last), path.radius(last));
    result.push_back(end[1], path.radii.back());
    return smoothed(result);
  }

  // Sampled finely, and without bends that are sharp against the vessel's width.
  static Vessel_path smoothed(const Vessel_path& path) {
    Vessel_path result;
    double least = path.radii[0];
    for (double r : path.radii)
      least = (std::min)(least, r);
    const std::size_t n = std::size_t((std::min)((std::max)(std::ceil(4 * path.length() / least), 16.), 4000.));
    std::vector<Vector_3d> p;
    for (std::size_t i = 0; i <= n; ++i)
      p.push_back(path.point(path.length() * double(i) / double(n)));
    const double step = path.length() / double(n);
    for (int round = 0; round < 400; ++round) {
      std::vector<Vector_3d> q = p;
      for (std::size_t i = 1; i < n; ++i) {
        const double r = path.radius(step * double(i)), width = smoothing_ * r; // of the kernel
        if (double(round) < 2 * width * width / (step * step))
          q[i] = 0.5 * p[i] + 0.25 * (p[i - 1] + p[i + 1]);
      }
      p.swap(q);
    }
    for (std::size_t i = 0; i <= n; ++i)
      result.push_back(p[i], path.radius(step * double(i)));
    return result;
  }
  static inline double smoothing_ = 0.7;
  /* How far inside of a blind end's tip the ball lies that touches the wall beside it. */
  double dome_depth(const Vessel_path& path) const {
    const Vector_3d out = -1 * path.tangent(0, path.radii.front());
    const double gap = wall_.along(path.points.front(), out, 2 * wall_.distance(path.points.front()));
    double a = 0;
    while (a < 0.7 * path.length() && wall_.distance(path.point(a)) > 0.95 * (a + gap))
      a += 0.05 * (path.radius(a) + 0.01 * path.length());
    return (std::min)(a, 0.7 * path.length());
  }
  Vector_3d rim_center(int opening) const {
    Vector_3d sum;
    for (const Vector_3d& p : rims_.at(opening))
      sum += p;
    return (1. / double(rims_.at(opening).size())) * sum;
  }

  void make_vessel(std::size_t v) {
    const auto& vessel = network_.vessels[v];
    const Vessel_path path = path_of(v);
    const double length = path.length();
    const Frames frames(path, (std::max)(std::size_t(20), 4 * path.points.size()));
    const auto [t0, u0] = frames.at(0);
    const auto [t1, u1] = frames.at(length);

    // the rings at both ends, and how they are turned
    std::array<Wall_ring, 2> ring;
    std::array<Section, 2> section;
    std::array<bool, 2> junction;
    std::array<std::optional<double>, 2> turn;
    int turns = 0;
    for (int e = 0; e < 2; ++e) {
      const std::size_t n = vessel.nodes[e];
      junction[e] = network_.nodes[n].is_junction();
      if (!junction[e])
        continue;
      const std::size_t r = region_of(n, v, e == 1);
      ring[e] = junctions_[n].rings[r];
      section[e] = junctions_[n].sections[r];
    }
    if (junction[0])
      turn[0] = place_of(ring[0], t0, u0).turn;
    if (junction[1]) {
      const double own = place_of(mirrored(ring[1], 0), t1, u1).turn; // a quarter less for each of the turns
      const double wanted = turn[0] ? *turn[0] : own;
      turns = ((int(std::lround((own - wanted) / (pi / 2))) % 4) + 4) % 4;
      turn[1] = wanted + std::remainder(own - turns * pi / 2 - wanted, 2 * pi);
      ring[1] = mirrored(ring[1], turns);
      section[1] = mirrored(section[1], turns);
    }
    if (!turn[0])
      turn[0] = turn[1] ? *turn[1] : 0;
    if (!turn[1])
      turn[1] = *turn[0];
    for (int e = 0; e < 2; ++e)
      if (!junction[e]) {
        const auto [t, u] = frames.at(e == 0 ? 0 : length);
        const int opening = network_.nodes[vessel.nodes[e]].opening;
        ring[e] =
            opening ? rim_ring(opening, t, u, *turn[e]) : planar_ring(path.point(e == 0 ? 0 : length), t, u, *turn[e]);
        section[e] = section_of(ring[e]);
      }

    // where sections are planar
    const double step = 0.05 * (path.radius(0) + path.radius(length));
    double first = 0, last = 0;
    while (first < length && reach(ring[0], path.point(first), frames.at(first).first) > -0.4 * path.radius(first))
      first += step;
    while (last < length && reach(ring[1], path.point(length - last), -1 * frames.at(length - last).first) >
                                -0.4 * path.radius(length - last))
      last += step;
    if (first + last > length) {
      const double f = length / (first + last);
      first *= f;
      last *= f;
    }
    last = length - last;
    const auto turn_at = [&](double a) {
      const double t = (std::min)((std::max)((a - first) / (std::max)(last - first, 1e-12 * length), 0.), 1.);
      return *turn[0] + t * (*turn[1] - *turn[0]);
    };
    const auto planar = [&](double a) {
      const auto [t, u] = frames.at(a);
      return planar_ring(path.point(a), t, u, turn_at(a));
    };
    const Wall_ring ring_first = planar(first), ring_last = planar(last);

    const std::vector<double> stations = stations_of(path);
    Section before = section[0];
    for (std::size_t i = 1; i < stations.size(); ++i) {
      const double a = stations[i];
      Section next;
      if (i + 1 == stations.size())
        next = section[1];
      else if (a < first)
        next = section_of(mixed(ring[0], ring_first, path, a, a / first));
      else if (a > last)
        next = section_of(mixed(ring_last, ring[1], path, a, (a - last) / (length - last)));
      else
        next = section_of(planar(a));
      add_cells(before, next);
      before = std::move(next);
    }
    for (int e = 0; e < 2; ++e)
      if (network_.nodes[vessel.nodes[e]].opening)
        add_cap(section[e], e == 0, network_.nodes[vessel.nodes[e]].opening);
      else if (!junction[e])
        add_dome(section[e], e == 0);
  }

  Wall_ring mixed(const Wall_ring& from, const Wall_ring& to, const Vessel_path& path, double a, double t) const {
    Wall_ring result{path.point(a), {}};
    for (int i = 0; i < around_; ++i)
      result.points.push_back(wall_.nearest((1 - t) * from.points[i] + t * to.points[i]));
    return result;
  }

  std::vector<double> stations_of(const Vessel_path& path) const {
    const std::size_t n = (std::max)(std::size_t(64), 4 * path.points.size());
    std::vector<double> sum{0};
    for (std::size_t i = 0; i < n; ++i) {
      const double a = path.length() * (double(i) + 0.5) / double(n);
      const Vector_3d p = path.point(a);
      sum.push_back(sum.back() + path.length() / double(n) / size_(Point_3(p.x, p.y, p.z)));
    }
    const std::size_t rows = (std::max)(std::size_t(4), std::size_t(std::lround(sum.back())));
    std::vector<double> result{0};
    std::size_t i = 0;
    for (std::size_t k = 1; k < rows; ++k) {
      const double wanted = sum.back() * double(k) / double(rows);
      while (sum[i + 1] < wanted)
        ++i;
      result.push_back(path.length() / double(n) * (double(i) + (wanted - sum[i]) / (sum[i + 1] - sum[i])));
    }
    result.push_back(path.length());
    return result;
  }

  // --- the mesh ---

  Index add(const Vector_3d& p) {
    mesh_.points.emplace_back(p.x, p.y, p.z);
    return Index(mesh_.points.size() - 1);
  }

  void add_cells(const Section& a, const Section& b) {
    for (const auto& q : disc_.quads())
      mesh_.hexahedra.push_back({{a.core[q[0]], a.core[q[1]], a.core[q[2]], a.core[q[3]], b.core[q[0]], b.core[q[1]],
                                  b.core[q[2]], b.core[q[3]]}},
                                labels::lumen);
    for (int i = 0; i < around_; ++i) {
      const int j = (i + 1) % around_;
      const std::size_t c = disc_.boundary()[i], d = disc_.boundary()[j];
      mesh_.hexahedra.push_back(
          {{a.core[c], a.wall[i], a.wall[j], a.core[d], b.core[c], b.wall[i], b.wall[j], b.core[d]}}, labels::lumen);
      mesh_.quads.push_back({{a.wall[i], a.wall[j], b.wall[j], b.wall[i]}}, labels::wall);
    }
  }

  void add_dome(const Section& s, bool first) {
    for (const auto& q : disc_.quads()) {
      std::array<Index, 4> low, high;
      for (int i = 0; i < 4; ++i) {
        low[i] = s.core[q[first ? 3 - i : i]];
        high[i] = s.dome[q[first ? 3 - i : i]];
      }
      mesh_.hexahedra.push_back({{low[0], low[1], low[2], low[3], high[0], high[1], high[2], high[3]}}, labels::lumen);
      mesh_.quads.push_back({{high[0], high[1], high[2], high[3]}}, labels::wall);
    }
  }

  void add_cap(const Section& s, bool first, int patch) {
    const auto add_quad = [&](Index p, Index q, Index r, Index t) {
      first ? mesh_.quads.push_back({{p, t, r, q}}, patch) : mesh_.quads.push_back({{p, q, r, t}}, patch);
    };
    for (const auto& q : disc_.quads())
      add_quad(s.core[q[0]], s.core[q[1]], s.core[q[2]], s.core[q[3]]);
    for (int i = 0; i < around_; ++i) {
      const int j = (i + 1) % around_;
      add_quad(s.core[disc_.boundary()[i]], s.wall[i], s.wall[j], s.core[disc_.boundary()[j]]);
    }
  }

  const Vessel_network& network_;
  const Wall_of_lumen& wall_;
  const std::map<int, std::vector<Vector_3d>>& rims_;
  Length_function size_;
  Disc_grid disc_;
  int s_, around_;
  std::vector<Junction> junctions_;
  std::vector<std::size_t> refused_;
  Mixed_mesh mesh_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_BLOCK_BUILDER_H
