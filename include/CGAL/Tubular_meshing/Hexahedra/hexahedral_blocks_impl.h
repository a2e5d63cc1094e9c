// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_HEXAHEDRAL_BLOCKS_IMPL_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_HEXAHEDRAL_BLOCKS_IMPL_H

#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Hexahedra/hexahedral_blocks.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Block_builder.h>
#include <CGAL/Tubular_meshing/Hexahedra/optimize_hexahedra.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Tries to make blocks, and finds where they do not fit. */
class Hexahedral_blocks_maker {
public:
  Hexahedral_blocks_maker(const Surface& surface, Face_patch_map patch, const Centerline_graph& graph,
                          Length_function size, const Hexahedral_blocks_options& options)
      : surface_(surface)
      , patch_(patch)
      , size_(size)
      , options_(options)
      , graph_(graph)
      , wall_(surface, patch)
      , rims_(opening_rims(surface, patch))
      , rings_(wall_, rims_, blocks_points(options.points_per_circumference))
      , network_(graph, rims_, nearness, {}) {}

  /* Where hexahedra do not untangle, the junction is made one with the nearest, if there is one as near. */
  Hexahedral_blocks make() {
    std::set<std::size_t> joined;
    for (int round = 0;; ++round) {
      Hexahedral_blocks result;
      prepare(result);
      if (!result.refused.empty())
        return result;
      Network_blocks blocks = builder(shapes_).build();
      check_cover(blocks.mesh, result); // before work that would be for nothing
      if (!result.refused.empty())
        return result;
      result.twist = blocks.twist;
      untangle(blocks, result);
      if (round == most_rounds || !join(tangled(blocks, 0), joined)) {
        improve(blocks, result);
        return result;
      }
      network_ = Vessel_network(graph_, rims_, nearness, joined);
    }
  }

  std::optional<Length_of_blocks> length() {
    Hexahedral_blocks result;
    prepare(result);
    if (!result.refused.empty())
      return std::nullopt;
    const std::size_t s = std::size_t(rings_.around()) / 8;
    Length_of_blocks length;
    for (const auto& n : network_.nodes)
      length.domes += n.is_blind();
    const std::size_t hexahedra = builder(shapes_).build().mesh.hexahedra.size();
    length.rows = (hexahedra - 4 * s * s * length.domes) / (4 * s * s + 8 * s);
    return length;
  }

private:
  static constexpr double nearness = 1.3;        // of junctions that are one, in radii
  static constexpr std::size_t most_vessels = 8; // of a junction
  static constexpr double fair = 0.15;           // the scaled Jacobian from which on a start is as good as any
  static constexpr double least = 0.02;          // that a hexahedron has in the end

  static constexpr int most_rounds = 1; // in which junctions are joined

  // Counts the blocks, and gives each junction its shape.
  void prepare(Hexahedral_blocks& result) {
    result.points_per_circumference = std::size_t(rings_.around());
    for (const auto& n : network_.nodes)
      result.junctions += n.is_junction();
    check_network(result);
    if (result.refused.empty())
      choose_starts(result);
  }

  /* Adds the vessels on which tangled junctions reach farthest into their neighbors. False if there is none. */
  bool join(const std::vector<std::size_t>& tangled, std::set<std::size_t>& joined) const {
    const std::size_t before = joined.size();
    for (std::size_t n : tangled) {
      double most = 0.7; // of a vessel's length, what junctions at both of its ends take up
      std::size_t branch = std::size_t(-1);
      for (const auto& e : network_.nodes[n].ends) {
        const auto& vessel = network_.vessels[e.vessel];
        const std::size_t other = vessel.nodes[e.last ? 0 : 1];
        if (!shapes_[n] || !shapes_[other] || other == n)
          continue;
        const double share = (shapes_[n]->exits[network_.place_at(n, e.vessel, e.last)] +
                              shapes_[other]->exits[network_.place_at(other, e.vessel, !e.last)]) /
                             vessel.path.length();
        if (share > most) {
          most = share;
          branch = vessel.branch;
        }
      }
      if (branch != std::size_t(-1))
        joined.insert(branch);
    }
    return joined.size() > before;
  }

  void refuse(Hexahedral_blocks& result, const Vector_3d& place, const std::string& reason) const {
    result.refused.push_back({as<Point_3>(place), reason, Surface::null_vertex()});
  }
  void refuse_node(Hexahedral_blocks& result, std::size_t node, const std::string& reason) const {
    refuse(result, network_.nodes[node].point, reason);
    result.refused.back().is_junction = network_.nodes[node].is_junction();
    result.refused.back().can_be_left_out = true;
  }

  void check_network(Hexahedral_blocks& result) const {
    for (int label : network_.openings_without_vessel)
      refuse(result, rims_.at(label).center, "no centerline leads to the opening");
    for (std::size_t n = 0; n < network_.nodes.size(); ++n) {
      const std::size_t vessels = network_.nodes[n].ends.size();
      if (vessels > most_vessels)
        refuse_node(result, n, std::to_string(vessels) + " vessels meet, more than " + std::to_string(most_vessels));
    }
    for (const auto& v : network_.vessels)
      if (v.path.points.size() < 2)
        refuse(result, network_.nodes[v.nodes[0]].point, "a vessel has no length");
  }

  // The scaled Jacobian of each hexahedron.
  std::vector<double> qualities(const Mixed_mesh& mesh) const {
    std::vector<double> result(mesh.hexahedra.size());
    for_each_range(result.size(), options_.number_of_threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        std::array<Vector_3d, 8> p;
        for (int k = 0; k < 8; ++k)
          p[k] = Vector_3d(mesh.points[mesh.hexahedra.vertices[i][k]]);
        result[i] = scaled_jacobian<8>(p);
      }
    });
    return result;
  }

  // By how much the hexahedra of each node fall short.
  std::vector<double> shortfalls(const Network_blocks& blocks, double wanted) const {
    std::vector<double> result(network_.nodes.size(), 0);
    const std::vector<double> q = qualities(blocks.mesh);
    for (std::size_t i = 0; i < q.size(); ++i)
      result[blocks.node[i]] += (std::max)(wanted - q[i], 0.);
    return result;
  }

  Block_builder builder(const std::vector<std::optional<Junction_shape>>& shapes) const {
    const double core = (std::min)(0.72, 0.9 - options_.layer_thickness);
    return Block_builder(network_, shapes, wall_, rings_, rims_, size_, core);
  }

  /* Gives each junction the start by which its hexahedra are best before optimization. */
  void choose_starts(Hexahedral_blocks& result) {
    const std::vector<Junction_start>& tries = Junction_start::tries();
    const std::size_t n = network_.nodes.size();
    std::vector<double> best(n, (std::numeric_limits<double>::infinity)());
    shapes_.assign(n, std::nullopt);
    std::vector<std::size_t> open; // junctions to try
    for (std::size_t i = 0; i < n; ++i)
      if (network_.nodes[i].is_junction())
        open.push_back(i);
    for (const Junction_start& start : tries) {
      std::vector<std::optional<Junction_shape>> shapes = shapes_;
      std::vector<std::optional<Junction_shape>> tried(open.size());
      for_each_task(open.size(), options_.number_of_threads, [&](std::size_t k) {
        tried[k].emplace(network_, open[k], rings_, wall_, start, rings_.around() / 4);
      });
      for (std::size_t k = 0; k < open.size(); ++k)
        if (tried[k]->partition)
          shapes[open[k]] = std::move(tried[k]);
      for (std::size_t i : open)
        if (!shapes[i]) {
          refuse_node(result, i, "the directions of the vessels that meet cannot be divided into regions");
          return;
        }
      const std::set<std::size_t> tried_nodes(open.begin(), open.end());
      const Network_blocks blocks = builder(shapes).build([&](std::size_t v) {
        const auto& nodes = network_.vessels[v].nodes;
        return tried_nodes.count(nodes[0]) > 0 || tried_nodes.count(nodes[1]) > 0;
      });
      const std::vector<double> shortfall = shortfalls(blocks, fair);
      std::vector<std::size_t> still_open;
      for (std::size_t i : open) {
        if (shortfall[i] < best[i]) {
          best[i] = shortfall[i];
          shapes_[i] = std::move(shapes[i]);
        }
        if (best[i] > 0)
          still_open.push_back(i);
      }
      open.swap(still_open);
      if (open.empty())
        break;
    }
  }

  Optimize_hexahedra_options optimization(double quality_wanted) const {
    Optimize_hexahedra_options options;
    options.number_of_threads = options_.number_of_threads;
    options.quality_wanted = quality_wanted;
    options.untangling_sweeps = 60; // what is not untangled then seldom is later
    return options;
  }

  void untangle(Network_blocks& blocks, Hexahedral_blocks& result) const {
    result.optimization = internal::optimize_hexahedra(blocks.mesh, surface_, patch_, optimization(0.1));
  }

  // Nodes with hexahedra that are not better than a bound.
  std::vector<std::size_t> tangled(const Network_blocks& blocks, double bound) const {
    std::vector<std::size_t> result;
    const std::vector<double> q = qualities(blocks.mesh);
    for (std::size_t i = 0; i < q.size(); ++i)
      if (!(q[i] > bound))
        result.push_back(blocks.node[i]);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  void improve(Network_blocks& blocks, Hexahedral_blocks& result) const {
    const Optimize_hexahedra_report untangled = result.optimization;
    result.optimization = internal::optimize_hexahedra(blocks.mesh, surface_, patch_, optimization(0.5));
    result.optimization.inverted_before = untangled.inverted_before;
    result.optimization.min_scaled_jacobian_before = untangled.min_scaled_jacobian_before;
    result.optimization.mean_scaled_jacobian_before = untangled.mean_scaled_jacobian_before;
    for (std::size_t n : tangled(blocks, least))
      refuse_node(result, n,
                  network_.nodes[n].is_junction() ? "the hexahedra of a junction do not untangle"
                                                  : "the hexahedra of a vessel's end do not untangle");
    if (result.refused.empty())
      check_cover(blocks.mesh, result);
    result.mesh = std::move(blocks.mesh);
    result.structure = std::move(blocks.structure);
    result.irregular_edges = irregular_edges();
  }

  /* Along the core's corners, three blocks meet, and as many round the tip of a blind end; at the corner of a junction
   * between k vessels 2 k do, in the core and in the ring. */
  std::size_t irregular_edges() const {
    std::size_t result = 0;
    for (const auto& v : network_.vessels) {
      result += 4;
      for (std::size_t n : v.nodes)
        result += network_.nodes[n].is_blind() ? 8 : 0;
    }
    for (const auto& shape : shapes_)
      if (shape)
        for (std::size_t c = 0; c < shape->partition->corners.size(); ++c)
          result += shape->partition->degree(c) == 2 ? 0 : 2;
    return result;
  }

  /* Refuses a mesh that misses parts of the surface, by more than a radius of the vessel nearest to them. */
  void check_cover(const Mixed_mesh& mesh, Hexahedral_blocks& result) const {
    constexpr double most = 1;
    const double size_of_radius = 2 * pi / options_.points_per_circumference;
    std::vector<std::array<Point_3, 3>> triangles;
    for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
      const auto& q = mesh.quads.vertices[i];
      triangles.push_back({mesh.points[q[0]], mesh.points[q[1]], mesh.points[q[2]]});
      triangles.push_back({mesh.points[q[0]], mesh.points[q[2]], mesh.points[q[3]]});
    }
    const Wall_distance distance(triangles);
    std::vector<double> missed(surface_.number_of_vertices(), 0); // in radii
    for_each_range(missed.size(), options_.number_of_threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const Point_3& p = surface_.point(Vertex(Surface::size_type(i)));
        const Wall_distance::Place q = distance.closest_place(p);
        const auto t = distance.triangle(q.triangle);
        const double edge = std::pow(CGAL::cross_product(t[1] - t[0], t[2] - t[0]).squared_length(), 0.25);
        // of a quad and of the size, as that is small where the wall has a pit or a spike
        const double radius = (std::max)(edge, size_(q.point)) / size_of_radius;
        missed[i] = std::sqrt(CGAL::squared_distance(p, q.point)) / radius;
      }
    });
    std::vector<std::pair<double, std::size_t>> worst;
    for (std::size_t i = 0; i < missed.size(); ++i)
      if (missed[i] > most)
        worst.emplace_back(-missed[i], i);
    std::sort(worst.begin(), worst.end());
    for (const auto& [m, i] : worst)
      if (missed[i] > most) { // no part that has been found already
        const Vertex tip = Vertex(Surface::size_type(i));
        result.refused.push_back({surface_.point(tip), "a part of the vessel has no centerline", tip});
        forget_part(tip, most / 2, missed);
      }
  }

  // Sets to 0 what is missed by more than a bound, from a vertex on.
  void forget_part(Vertex from, double bound, std::vector<double>& missed) const {
    std::vector<Vertex> part{from};
    missed[from] = 0;
    while (!part.empty()) {
      const Vertex v = part.back();
      part.pop_back();
      for (Vertex w : CGAL::vertices_around_target(surface_.halfedge(v), surface_))
        if (missed[w] > bound) {
          missed[w] = 0;
          part.push_back(w);
        }
    }
  }

  const Surface& surface_;
  Face_patch_map patch_;
  Length_function size_;
  const Hexahedral_blocks_options& options_;
  const Centerline_graph& graph_;
  Wall_of_lumen wall_;
  Opening_rims rims_;
  Wall_rings rings_;
  Vessel_network network_;
  std::vector<std::optional<Junction_shape>> shapes_; // of each node that is a junction
};

CGAL_TUBULAR_MESHING_INLINE Hexahedral_blocks make_hexahedral_blocks(const Surface& surface, Face_patch_map patch,
                                                                     const Centerline_graph& graph,
                                                                     Length_function size,
                                                                     const Hexahedral_blocks_options& options) {
  if (!(options.points_per_circumference >= 8))
    throw Parameter_error("Hexahedra in blocks need 8 points round a vessel, or more.");
  if (!(options.layer_thickness >= 0 && options.layer_thickness <= 0.8))
    throw Parameter_error("Layers along the wall may take up 0.8 radii of a vessel, not more.");
  return Hexahedral_blocks_maker(surface, patch, graph, size, options).make();
}

CGAL_TUBULAR_MESHING_INLINE std::optional<Length_of_blocks>
length_of_blocks(const Surface& surface, Face_patch_map patch, const Centerline_graph& graph, Length_function size,
                 const Hexahedral_blocks_options& options) {
  return Hexahedral_blocks_maker(surface, patch, graph, size, options).length();
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_HEXAHEDRAL_BLOCKS_IMPL_H
