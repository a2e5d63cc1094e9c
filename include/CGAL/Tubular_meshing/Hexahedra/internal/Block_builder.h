// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_BLOCK_BUILDER_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_BLOCK_BUILDER_H

#include <CGAL/Tubular_meshing/Hexahedra/Block_structure.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Disc_grid.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Junction_shape.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Vessel_network.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Vessel_section.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Wall_of_lumen.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Wall_rings.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
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

/* The hexahedra along the vessels of a network, and what each belongs to. */
struct Network_blocks {
  Mixed_mesh mesh;
  std::vector<std::uint32_t> node; // of each hexahedron: the one of its vessel's two that is nearer
  std::vector<double> twist;       // of each vessel, in radians, from its one end to the other
  std::vector<std::size_t> first;  // hexahedron of each vessel, and one more
  Block_structure structure;
};

/* Builds hexahedra along the vessels of a network, from section to section: a core of squares, and a ring round it up
 * to the wall. At a junction, vessels share the halves or quarters of their sections. */
class Block_builder {
public:
  typedef std::uint32_t Index;

  /* `shapes`: one a node, of the junctions. `core`: how far from the center the core's corners are, 1 being the wall. */
  Block_builder(const Vessel_network& network, const std::vector<std::optional<Junction_shape>>& shapes,
                const Wall_of_lumen& wall, const Wall_rings& rings, const Opening_rims& rims, Length_function size,
                double core)
      : network_(network)
      , shapes_(shapes)
      , wall_(wall)
      , rings_(rings)
      , rims_(rims)
      , size_(size)
      , disc_(rings.around() / 8)
      , s_(rings.around() / 8)
      , around_(rings.around())
      , core_(core) {}

  Network_blocks build() {
    return build([](std::size_t) { return true; });
  }

  // Only the vessels that are wanted.
  template <class Wanted> Network_blocks build(const Wanted& wanted) {
    junctions_.resize(network_.nodes.size());
    blocks_.first.assign(network_.vessels.size() + 1, 0);
    for (std::size_t v = 0; v < network_.vessels.size(); ++v)
      if (wanted(v)) {
        for (std::size_t n : network_.vessels[v].nodes)
          if (shapes_[n] && junctions_[n].empty())
            add_junction(n);
        add_vessel(v);
        blocks_.first[v + 1] = blocks_.mesh.hexahedra.size();
      } else
        blocks_.first[v + 1] = blocks_.first[v];
    return std::move(blocks_);
  }

private:
  static constexpr double dome_ahead = 0.3; // by how much the last ring of a blind end leads to its tip

  typedef Vessel_section Section;

  // One end of a vessel.
  struct End {
    Wall_ring ring;
    Section section;
    std::optional<double> turn; // of the ring; none where it may be turned as one likes
  };

  // --- junctions ---

  void add_junction(std::size_t n) {
    const Junction_shape& shape = *shapes_[n];
    const Junction_partition& p = *shape.partition;
    std::vector<Index> corner_wall;
    for (const Vector_3d& q : shape.corner_points)
      corner_wall.push_back(add(q));
    std::vector<std::vector<Index>> side_wall;
    for (std::size_t k = 0; k < p.sides.size(); ++k) {
      const std::vector<Vector_3d>& points = shape.side_points[k];
      std::vector<Index> wall{corner_wall[p.sides[k].from]};
      for (std::size_t i = 1; i + 1 < points.size(); ++i)
        wall.push_back(add(points[i]));
      wall.push_back(corner_wall[p.sides[k].to]);
      side_wall.push_back(std::move(wall));
    }
    // vertices of the core are the center's, of an axis that leads to a corner, or of a square inside of a side
    std::map<std::array<std::size_t, 4>, Index> core;
    for (std::size_t region = 0; region < p.regions.size(); ++region) {
      const Junction_partition::Region& r = p.regions[region];
      const Wall_ring ring = shape.ring(region);
      Section section;
      for (std::size_t q = 0; q < 4; ++q)
        for (int i = 0; i < 2 * s_; ++i)
          section.wall.push_back(side_wall[r.sides[q]][r.forward[q] ? i : 2 * s_ - i]);
      for (std::size_t v = 0; v < disc_.size(); ++v) {
        const Disc_grid::Place& place = disc_.place(v);
        const bool forward = r.forward[place.quadrant];
        const std::size_t x = std::size_t(forward ? place.x : place.y), y = std::size_t(forward ? place.y : place.x);
        std::array<std::size_t, 4> key{{0, 0, 0, 0}};
        if (place.y > 0)
          key = {{2, r.sides[place.quadrant], x, y}};
        else if (place.x > 0)
          key = {{1, r.corners[place.quadrant], std::size_t(place.x), 0}};
        const auto [found, is_new] = core.emplace(key, Index(0));
        if (is_new)
          found->second = add(core_point(ring, v, junction_core()));
        section.core.push_back(found->second);
      }
      junctions_[n].push_back(std::move(section));
    }
  }

  // --- vessels ---

  // In the crotches of a junction the ring needs more room than elsewhere.
  double junction_core() const { return (std::min)(core_, 0.55); }

  Vector_3d core_point(const Wall_ring& ring, std::size_t v, double core) const {
    const Disc_grid::Polar p = disc_.polar(v, core);
    return ring.center + p.distance * (ring.at(p.step) - ring.center);
  }

  Section section_of(const Wall_ring& ring, double core) {
    Section section;
    for (std::size_t v = 0; v < disc_.size(); ++v)
      section.core.push_back(add(core_point(ring, v, core)));
    for (const Vector_3d& p : ring.points)
      section.wall.push_back(add(p));
    return section;
  }

  /* The end of the core in a blind end, and the wall beyond. */
  Section dome_section(const Wall_ring& ring, const Vector_3d& out) {
    constexpr double height = 0.6; // of the core, 1 being the wall
    Section section;
    for (const Vector_3d& p : ring.points)
      section.wall.push_back(add(p));
    section.dome.resize(disc_.size());
    for (int a = 0; a < around_; ++a)
      section.dome[disc_.boundary()[a]] = section.wall[a];
    const double bound = rings_.reach(ring.center);
    for (std::size_t v = 0; v < disc_.size(); ++v) {
      const Disc_grid::Place& place = disc_.place(v);
      const int from_center = (std::max)(place.x, place.y);
      Vector_3d top = ring.at(disc_.polar(v, core_).step);
      if (from_center < s_) {
        const Vector_3d d = top - ring.center, across = normalized(d - dot(d, out) * out);
        const double tilt = double(from_center) / s_ * std::atan(1 / dome_ahead);
        top = rings_.seen(ring.center, normalized(std::cos(tilt) * out + std::sin(tilt) * across), bound);
        section.dome[v] = add(top);
      }
      section.core.push_back(add(ring.center + height * (top - ring.center)));
    }
    return section;
  }

  // As a vessel sees it that ends there, its axis 0 on the junction's axis `turns`.
  Section mirrored(const Section& section, int turns) const {
    Section result;
    for (std::size_t v = 0; v < disc_.size(); ++v)
      result.core.push_back(section.core[disc_.mirrored(v, turns)]);
    for (int a = 0; a < around_; ++a)
      result.wall.push_back(section.wall[mirrored_step(a, turns)]);
    return result;
  }
  Wall_ring mirrored(const Wall_ring& ring, int turns) const {
    Wall_ring result{ring.center, {}};
    for (int a = 0; a < around_; ++a)
      result.points.push_back(ring.points[mirrored_step(a, turns)]);
    return result;
  }
  std::size_t mirrored_step(int a, int turns) const {
    return std::size_t(2 * s_ * turns - a + 2 * around_) % std::size_t(around_);
  }

  /* How far inside of a blind end's tip the last section is: half a radius from the center of the largest ball there, in
   * a round end the one that touches the wall beside the tip, too. Where the wall opens by less than `slope`, it is that
   * of a vessel that tapers; a steeper spike at the tip belongs to the end. */
  double dome_depth(const Vessel_path& path) const {
    constexpr double slope = 0.3;
    const Vector_3d tip = path.points.front(), out = -1 * path.tangent(0, path.radii.front());
    const double gap = wall_.along(tip, out, 2 * wall_.distance(tip));
    double depth = 0, best = 0;
    for (double a = 0; a < 0.7 * path.length(); a += 0.05 * path.radius(a) + 0.001 * path.length()) {
      const double r = (std::min)(wall_.distance(path.point(a)), a + gap);
      if (r - slope * a > best) {
        best = r - slope * a;
        depth = a - 0.5 * r;
      }
    }
    return (std::max)(depth, 0.);
  }

  // From the center of the first section to that of the last.
  Vessel_path path_of(std::size_t v) const {
    const auto& vessel = network_.vessels[v];
    const Vessel_path& path = vessel.path;
    std::array<double, 2> skipped{{0, 0}};
    std::array<Vector_3d, 2> end{{path.points.front(), path.points.back()}};
    for (int e = 0; e < 2; ++e) {
      const std::size_t n = vessel.nodes[e];
      if (shapes_[n]) {
        end[e] = shapes_[n]->center;
        skipped[e] = shapes_[n]->exits[network_.place_at(n, v, e == 1)];
      } else if (const int opening = network_.nodes[n].opening)
        end[e] = rims_.at(opening).center;
      else {
        const Vessel_path from_tip = e == 0 ? path : path.reversed();
        skipped[e] = dome_depth(from_tip);
        end[e] = from_tip.point(skipped[e]);
      }
    }
    const double sum = skipped[0] + skipped[1], most = 0.8 * path.length();
    if (sum > most)
      for (double& x : skipped)
        x *= most / sum;
    const double first = skipped[0], last = path.length() - skipped[1];
    Vessel_path result;
    result.push_back(end[0], path.radii.front());
    if (first > 0)
      result.push_back(path.point(first), path.radius(first));
    for (std::size_t i = 0; i < path.points.size(); ++i)
      if (path.abscissa[i] > first && path.abscissa[i] < last)
        result.push_back(path.points[i], path.radii[i]);
    if (last < path.length())
      result.push_back(path.point(last), path.radius(last));
    result.push_back(end[1], path.radii.back());
    return result.smoothed();
  }

  /* Both ends of a vessel, turned against each other by less than an eighth of a circle. */
  std::array<End, 2> ends_of(std::size_t v, const Vessel_path& path, const Path_frames& frames) {
    const auto& nodes = network_.vessels[v].nodes;
    std::array<End, 2> ends;
    const std::array<double, 2> abscissa{{0, path.length()}};
    for (int e = 0; e < 2; ++e)
      if (shapes_[nodes[e]]) {
        const std::size_t region = network_.place_at(nodes[e], v, e == 1);
        ends[e].ring = shapes_[nodes[e]]->ring(region);
        ends[e].section = junctions_[nodes[e]][region];
      }
    if (shapes_[nodes[0]])
      ends[0].turn = ends[0].ring.turn(frames.at(0));
    if (shapes_[nodes[1]]) {
      const double own = mirrored(ends[1].ring, 0).turn(frames.at(path.length())); // a quarter less for each turn
      const double wanted = ends[0].turn.value_or(own);
      const int turns = ((int(std::lround((own - wanted) / (pi / 2))) % 4) + 4) % 4;
      ends[1].turn = wanted + std::remainder(own - turns * pi / 2 - wanted, 2 * pi);
      ends[1].ring = mirrored(ends[1].ring, turns);
      ends[1].section = mirrored(ends[1].section, turns);
    }
    for (int e = 0; e < 2; ++e)
      if (!shapes_[nodes[e]]) {
        ends[e].turn = ends[1 - e].turn.value_or(0);
        const Path_frames::Frame frame = frames.at(abscissa[e]);
        if (const int opening = network_.nodes[nodes[e]].opening) {
          ends[e].ring = rings_.on_rim(opening, frame, *ends[e].turn);
          ends[e].section = section_of(ends[e].ring, core_);
        } else {
          const double ahead = e == 1 ? dome_ahead : -dome_ahead;
          ends[e].ring = rings_.across(path.point(abscissa[e]), frame, *ends[e].turn, 0, ahead);
          ends[e].section = dome_section(ends[e].ring, (e == 1 ? 1. : -1.) * frame.tangent);
        }
      }
    return ends;
  }

  void add_vessel(std::size_t v) {
    const auto& nodes = network_.vessels[v].nodes;
    const Vessel_path path = path_of(v);
    const Path_frames frames(path);
    const double length = path.length();
    const std::array<End, 2> ends = ends_of(v, path, frames);
    blocks_.twist.push_back(*ends[1].turn - *ends[0].turn);

    // sections are planar from `first` to `last`, clear of both ends
    constexpr double clearance = 0.4; // in radii
    const double step = 0.05 * (path.radius(0) + path.radius(length));
    double first = 0, last = 0;
    while (first < length &&
           ends[0].ring.reach(path.point(first), frames.at(first).tangent) > -clearance * path.radius(first))
      first += step;
    while (last < length && ends[1].ring.reach(path.point(length - last), -1 * frames.at(length - last).tangent) >
                                -clearance * path.radius(length - last))
      last += step;
    if (first + last > length) {
      const double sum = first + last;
      first *= length / sum;
      last *= length / sum;
    }
    last = length - last;
    const auto planar = [&](double a) {
      const double t = last > first ? (std::min)((std::max)((a - first) / (last - first), 0.), 1.) : 0.5;
      return rings_.across(path.point(a), frames.at(a), *ends[0].turn + t * blocks_.twist.back(), path.radius(a));
    };
    const Wall_ring ring_first = planar(first), ring_last = planar(last);

    const std::vector<double> stations = stations_of(path);
    Section_joiner cells(disc_, blocks_.mesh.hexahedra, blocks_.mesh.quads);
    Section before = ends[0].section;
    for (std::size_t i = 1; i < stations.size(); ++i) {
      const double a = stations[i];
      const Vector_3d center = path.point(a);
      const auto between = [&](const Wall_ring& end, const Wall_ring& section, double t, bool is_junction) {
        const double core = is_junction ? (1 - t) * junction_core() + t * core_ : core_;
        return section_of(rings_.between(end, section, t, center), core);
      };
      Section next =
          i + 1 == stations.size() ? ends[1].section
          : a < first              ? between(ends[0].ring, ring_first, a / first, shapes_[nodes[0]].has_value())
          : a > last ? between(ends[1].ring, ring_last, (length - a) / (length - last), shapes_[nodes[1]].has_value())
                     : section_of(planar(a), core_);
      cells.add_between(before, next, labels::lumen);
      set_node(nodes[2 * i <= stations.size() ? 0 : 1]);
      before = std::move(next);
    }
    const Disc_grid coarse(1);
    Section_joiner blocks(coarse, blocks_.structure.hexahedra, blocks_.structure.quads);
    const int branch = int(network_.vessels[v].branch);
    const std::array<Section, 2> corners{{ends[0].section.corners(disc_), ends[1].section.corners(disc_)}};
    blocks.add_between(corners[0], corners[1], branch);
    for (int e = 0; e < 2; ++e)
      if (const int opening = network_.nodes[nodes[e]].opening) {
        cells.add_cap(ends[e].section, e == 0, opening);
        blocks.add_cap(corners[e], e == 0, opening);
      } else if (!shapes_[nodes[e]]) {
        cells.add_dome(ends[e].section, e == 0, labels::lumen);
        set_node(nodes[e]);
        blocks.add_dome(corners[e], e == 0, branch);
      }
  }

  // Where the sections of a path are: at distances that go with the mesh size; four rows at least.
  std::vector<double> stations_of(const Vessel_path& path) const {
    constexpr std::size_t least_rows = 4;
    const std::size_t n = (std::max)(std::size_t(64), path.points.size());
    std::vector<double> sum{0};
    for (std::size_t i = 0; i < n; ++i) {
      const Vector_3d p = path.point(path.length() * (double(i) + 0.5) / double(n));
      sum.push_back(sum.back() + path.length() / double(n) / size_(Point_3(p.x, p.y, p.z)));
    }
    const std::size_t rows = (std::max)(least_rows, std::size_t(std::lround(sum.back())));
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
    blocks_.mesh.points.emplace_back(p.x, p.y, p.z);
    return Index(blocks_.mesh.points.size() - 1);
  }

  // Of the hexahedra that have none yet.
  void set_node(std::size_t node) { blocks_.node.resize(blocks_.mesh.hexahedra.size(), std::uint32_t(node)); }

  const Vessel_network& network_;
  const std::vector<std::optional<Junction_shape>>& shapes_;
  const Wall_of_lumen& wall_;
  const Wall_rings& rings_;
  const Opening_rims& rims_;
  Length_function size_;
  Disc_grid disc_;
  int s_, around_;
  double core_;
  std::vector<std::vector<Section>> junctions_; // of each node, one a region
  Network_blocks blocks_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_BLOCK_BUILDER_H
