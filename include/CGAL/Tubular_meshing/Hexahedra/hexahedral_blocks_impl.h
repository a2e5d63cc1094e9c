// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_HEXAHEDRAL_BLOCKS_IMPL_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_HEXAHEDRAL_BLOCKS_IMPL_H

#include <CGAL/Tubular_meshing/Hexahedra/hexahedral_blocks.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Block_builder.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Cover_of_lumen.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Sliding_surface.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Untangling_off_wall.h>
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

  /* Where hexahedra do not untangle, the junction is made one with the nearest, if there is one as near; else it begins
   * once more in another way. */
  Hexahedral_blocks make() {
    std::set<std::size_t> joined;
    for (int round = 0;; ++round) {
      Hexahedral_blocks result;
      prepare(result);
      if (!result.refused.empty())
        return result;
      for (int attempt = 0;; ++attempt) {
        result.refused.clear();
        result.mesh = Mixed_mesh();
        Network_blocks blocks = builder(shapes_).build();
        check_cover(blocks, result); // before work that would be for nothing
        if (!result.refused.empty())
          return result;
        result.twist = blocks.twist;
        untangle(blocks, result);
        if (attempt == 0 && round < most_rounds && join(tangled(blocks, 0), joined))
          break;
        untangle_off_wall(blocks);
        const bool is_last = attempt == most_attempts;
        if (!is_last && start_again(tangled(blocks, 0)))
          continue;
        const std::vector<std::size_t> failed = improve(blocks, result);
        if (is_last || !start_again(failed))
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

  static constexpr int most_rounds = 1;   // in which junctions are joined
  static constexpr int most_attempts = 2; // after the first, with other starts

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
    result.refused.push_back({as<Point_3>(place), reason, {}});
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

  // Gives each junction its first start.
  void choose_starts(Hexahedral_blocks& result) {
    const std::size_t n = network_.nodes.size();
    shapes_.assign(n, std::nullopt);
    used_starts_.assign(n, {});
    std::vector<std::size_t> junctions;
    for (std::size_t i = 0; i < n; ++i)
      if (network_.nodes[i].is_junction())
        junctions.push_back(i);
    choose_starts(junctions);
    for (std::size_t i : junctions)
      if (!shapes_[i])
        refuse_node(result, i, "the directions of the vessels that meet cannot be divided into regions");
  }

  /* Gives each of some junctions, of the starts that it has not had yet, the one by which its hexahedra are best before
   * optimization. False if there is none left for any. */
  bool choose_starts(std::vector<std::size_t> open) {
    const std::vector<Junction_start>& tries = Junction_start::tries();
    std::vector<double> best(network_.nodes.size(), (std::numeric_limits<double>::infinity)());
    std::vector<std::size_t> chosen(network_.nodes.size(), tries.size());
    for (std::size_t s = 0; s < tries.size() && !open.empty(); ++s) {
      std::vector<std::optional<Junction_shape>> shapes = shapes_;
      std::vector<std::optional<Junction_shape>> tried(open.size());
      for_each_task(open.size(), options_.number_of_threads, [&](std::size_t k) {
        if (used_starts_[open[k]].count(s) == 0)
          tried[k].emplace(network_, open[k], rings_, wall_, tries[s], rings_.around() / 4);
      });
      std::set<std::size_t> tried_nodes;
      for (std::size_t k = 0; k < open.size(); ++k)
        if (tried[k] && tried[k]->partition) {
          shapes[open[k]] = std::move(tried[k]);
          tried_nodes.insert(open[k]);
        }
      const Network_blocks blocks = builder(shapes).build([&](std::size_t v) {
        const auto& nodes = network_.vessels[v].nodes;
        const auto can_be_built = [&](std::size_t n) { return shapes[n] || !network_.nodes[n].is_junction(); };
        return (tried_nodes.count(nodes[0]) > 0 || tried_nodes.count(nodes[1]) > 0) && can_be_built(nodes[0]) &&
               can_be_built(nodes[1]);
      });
      const std::vector<double> shortfall = shortfalls(blocks, fair);
      std::vector<std::size_t> still_open;
      for (std::size_t i : open) {
        if (tried_nodes.count(i) > 0 && shortfall[i] < best[i]) {
          best[i] = shortfall[i];
          chosen[i] = s;
          shapes_[i] = std::move(shapes[i]);
        }
        if (best[i] > 0)
          still_open.push_back(i);
      }
      open.swap(still_open);
    }
    bool is_any = false;
    for (std::size_t i = 0; i < chosen.size(); ++i)
      if (chosen[i] < tries.size()) {
        used_starts_[i].insert(chosen[i]);
        is_any = true;
      }
    return is_any;
  }

  // False if there are none, or no other starts for them.
  bool start_again(const std::vector<std::size_t>& failed) {
    std::vector<std::size_t> junctions;
    for (std::size_t n : failed)
      if (shapes_[n])
        junctions.push_back(n);
    return !junctions.empty() && choose_starts(junctions);
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

  // What junctions have left of it, with the wall's vertices free for a while.
  void untangle_off_wall(Network_blocks& blocks) const {
    const std::vector<std::size_t> nodes = tangled(blocks, 0);
    if (nodes.empty())
      return;
    const Sliding_surface sliding(surface_, patch_);
    for (std::size_t n : nodes) {
      if (!shapes_[n])
        continue;
      Untangling_off_wall untangling(blocks.mesh, cover().hexahedra_round(n, blocks), wall_);
      if (untangling.run(surface_, patch_, sliding, options_.number_of_threads))
        untangling.bring_to(blocks.mesh);
    }
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

  Cover_of_lumen cover() const {
    return Cover_of_lumen(surface_, wall_, network_, size_, options_.points_per_circumference,
                          options_.number_of_threads);
  }

  // Refuses a mesh that misses parts of the surface.
  void check_cover(const Network_blocks& blocks, Hexahedral_blocks& result) const {
    for (std::vector<Vertex>& part : cover().missed_parts(blocks.mesh)) {
      const Point_3 tip = surface_.point(part.front());
      result.refused.push_back({tip, "a part of the vessel has no centerline", std::move(part)});
    }
  }

  // Returns the nodes that are refused then.
  std::vector<std::size_t> improve(Network_blocks& blocks, Hexahedral_blocks& result) const {
    const Optimize_hexahedra_report untangled = result.optimization;
    result.optimization = internal::optimize_hexahedra(blocks.mesh, surface_, patch_, optimization(0.5));
    result.optimization.inverted_before = untangled.inverted_before;
    result.optimization.min_scaled_jacobian_before = untangled.min_scaled_jacobian_before;
    result.optimization.mean_scaled_jacobian_before = untangled.mean_scaled_jacobian_before;
    const std::vector<std::size_t> failed = refuse_failed(blocks, result);
    if (failed.empty())
      check_cover(blocks, result);
    result.mesh = std::move(blocks.mesh);
    result.structure = std::move(blocks.structure);
    result.irregular_edges = irregular_edges();
    return failed;
  }

  // Nodes whose hexahedra are inverted, or do not fill their place exactly once.
  std::vector<std::size_t> refuse_failed(const Network_blocks& blocks, Hexahedral_blocks& result) const {
    std::vector<std::size_t> failed = tangled(blocks, least);
    for (std::size_t n : failed)
      refuse_node(result, n,
                  network_.nodes[n].is_junction() ? "the hexahedra of a junction do not untangle"
                                                  : "the hexahedra of a vessel's end do not untangle");
    const auto add = [&](const std::vector<std::size_t>& nodes, const std::string& reason) {
      for (std::size_t n : nodes)
        if (std::find(failed.begin(), failed.end(), n) == failed.end()) {
          failed.push_back(n);
          refuse_node(result, n, reason);
        }
    };
    add(cover().overlapping(blocks), "the hexahedra of a junction's vessels overlap");
    add(cover().with_pockets(blocks), "the hexahedra of a junction leave a part of the lumen out");
    return failed;
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
  std::vector<std::set<std::size_t>> used_starts_;    // of each node
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
