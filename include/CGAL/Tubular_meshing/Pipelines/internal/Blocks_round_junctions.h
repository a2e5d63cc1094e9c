// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_BLOCKS_ROUND_JUNCTIONS_H
#define CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_BLOCKS_ROUND_JUNCTIONS_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Hexahedra/hexahedral_blocks.h>
#include <CGAL/Tubular_meshing/Layers/append_mesh.h>
#include <CGAL/Tubular_meshing/Patches/cut_by_centerlines.h>
#include <CGAL/Tubular_meshing/Pipelines/Hexahedral_report.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesher_options.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Junction_filler.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Lumen_divider.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Model_in_its_frame.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Labelled_surface.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Blocks along the vessels up to those junctions that are to have none; these are filled with pyramids and tetrahedra.
 * The lumen is divided by the cuts that patches of the wall have across the vessels. */
class Blocks_round_junctions {
public:
  Blocks_round_junctions(const Model_in_its_frame& frame, const Centerline_graph& graph,
                         const Hexahedral_blocks_options& blocks, const Mesher_options& options)
      : frame_(frame)
      , surface_(frame.copy_of_surface())
      , graph_(graph)
      , blocks_(blocks)
      , options_(options)
      , cut_(cut())
      , is_filled_(cut_.patches.size(), 0) {
    int largest = labels::wall;
    for (Face f : surface_.surface.faces())
      largest = (std::max)(largest, surface_.patch[f]);
    first_cap_ = largest + 1;
  }

  /* Of what is refused, in the whole lumen. Further junctions without blocks are found then. Throws Meshing_error if a
   * place is no junction and no vessel's end, or cannot be filled, with the size inside. The report gets the places, and
   * what fills them. */
  Mixed_mesh make(const std::vector<Refused_blocks>& refused, Length_function size, Length_function size_inside,
                  Hexahedral_report& report) {
    constexpr int most_rounds = 6;
    leave_out(surface_.surface, cut_, {}, refused);
    for (int round = 0; round < most_rounds; ++round) {
      const Lumen_divider divider(surface_, cut_, graph_, is_filled_, first_cap_);
      if (std::optional<Mixed_mesh> mesh = blocks_of(divider, size, report)) {
        fill(divider, size_inside, *mesh, report);
        return std::move(*mesh);
      }
    }
    throw Meshing_error("there are always more junctions without blocks");
  }

  /* Puts layers along the wall of the mesh that was made; the report gets what fills junctions within them. */
  Layer_report insert_layers(Mixed_mesh& mesh, Length_function radius, Length_function size_inside,
                             Hexahedral_report& report) const {
    std::vector<Junction_filler::Number_of_cells> numbers;
    const Layer_report result = filler_->insert_layers(radius, size_inside, mesh, numbers);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      report.places_without_blocks[k].pyramids = numbers[k].pyramids;
      report.places_without_blocks[k].tetrahedra = numbers[k].tetrahedra;
    }
    return result;
  }

private:
  // A place where there are no blocks, by the patch of the whole that is filled for it.
  struct Reason {
    std::size_t patch;
    Point_3 place;
    std::string reason;
    bool is_junction;
  };

  // A junction may be longer by the clearance than else a patch, for not to be cut again.
  Surface_cut cut() {
    Cut_by_centerlines_options options = options_.cut;
    options.aspect_ratio += 2 * clearance;
    return internal::cut_by_centerlines(surface_.surface, graph_, surface_.patch, options, clearance);
  }

  /* Chooses the patches nearest to what is refused, of the whole or of a part, that are to be filled. */
  void leave_out(const Surface& surface, const Surface_cut& cut, const std::vector<std::size_t>& whole_patch,
                 const std::vector<Refused_blocks>& refused) {
    std::vector<Double_kernel::Triangle_3> triangles;
    std::vector<std::size_t> patch_of; // of each
    for (std::size_t p = 0; p < cut.patches.size(); ++p)
      for (Face f : cut.patches[p].faces) {
        const Halfedge h = surface.halfedge(f);
        triangles.emplace_back(to_double_point(surface.point(surface.source(h))),
                               to_double_point(surface.point(surface.target(h))),
                               to_double_point(surface.point(surface.target(surface.next(h)))));
        patch_of.push_back(whole_patch.empty() ? p : whole_patch[p]);
      }
    const Nearest_tree<Double_kernel::Triangle_3> tree(std::move(triangles));
    for (const Refused_blocks& r : refused) {
      if (!r.can_be_left_out)
        throw Meshing_error(r.reason);
      const std::size_t patch = patch_of[tree.nearest(to_double_point(r.place)).index];
      is_filled_[patch] = 1;
      reasons_.push_back({patch, r.place, r.reason, r.is_junction});
    }
  }

  // Of the parts that are not filled; none if there are others that must be.
  std::optional<Mixed_mesh> blocks_of(const Lumen_divider& divider, Length_function size, Hexahedral_report& report) {
    Mixed_mesh mesh;
    report.number_of_blocks = report.number_of_junctions = report.irregular_edges = 0;
    report.twist.clear();
    report.optimization = Optimize_hexahedra_report();
    bool is_complete = true;
    for (std::size_t k = 0; k < divider.number_of_parts(); ++k) {
      if (divider.kind_of(k) != 0)
        continue;
      const Lumen_part part = divider.part(k);
      const Hexahedral_blocks blocks =
          internal::make_hexahedral_blocks(part.surface.surface, part.surface.patch, part.graph, size, blocks_);
      if (!blocks.refused.empty()) {
        leave_out(part.surface.surface, part.cut, part.whole_patch, blocks.refused);
        is_complete = false;
        continue;
      }
      add(report, blocks, mesh.hexahedra.size());
      append_mesh(mesh, blocks.mesh, {}, no_interface);
    }
    if (is_complete && mesh.hexahedra.size() == 0)
      throw Meshing_error("no vessel is left for blocks");
    return is_complete ? std::optional<Mixed_mesh>(std::move(mesh)) : std::nullopt;
  }

  // `hexahedra`: how many those have that were added before.
  static void add(Hexahedral_report& report, const Hexahedral_blocks& blocks, std::size_t hexahedra) {
    report.number_of_junctions += blocks.junctions;
    report.number_of_blocks += blocks.structure.hexahedra.size();
    report.irregular_edges += blocks.irregular_edges;
    report.points_per_circumference = blocks.points_per_circumference;
    report.twist.insert(report.twist.end(), blocks.twist.begin(), blocks.twist.end());
    Optimize_hexahedra_report& all = report.optimization;
    const Optimize_hexahedra_report& part = blocks.optimization;
    for (double Optimize_hexahedra_report::*least :
         {&Optimize_hexahedra_report::min_scaled_jacobian_before, &Optimize_hexahedra_report::min_scaled_jacobian})
      all.*least = hexahedra == 0 ? part.*least : (std::min)(all.*least, part.*least);
    const double share = double(blocks.mesh.hexahedra.size()) / double(hexahedra + blocks.mesh.hexahedra.size());
    for (double Optimize_hexahedra_report::*mean :
         {&Optimize_hexahedra_report::mean_scaled_jacobian_before, &Optimize_hexahedra_report::mean_scaled_jacobian})
      all.*mean += share * (part.*mean - all.*mean);
    for (std::size_t Optimize_hexahedra_report::*number :
         {&Optimize_hexahedra_report::inverted_before, &Optimize_hexahedra_report::inverted,
          &Optimize_hexahedra_report::below_wanted_before, &Optimize_hexahedra_report::below_wanted,
          &Optimize_hexahedra_report::sweeps, &Optimize_hexahedra_report::held_vertices})
      all.*number += part.*number;
    all.movable_vertices = (std::max)(all.movable_vertices, part.movable_vertices);
  }

  void fill(const Lumen_divider& divider, Length_function size, Mixed_mesh& mesh, Hexahedral_report& report) {
    filler_.emplace(mesh, first_cap_, options_);
    std::vector<Place_without_blocks> others; // that are filled together with one before
    for (std::size_t k = 0; k < divider.number_of_parts(); ++k) {
      if (divider.kind_of(k) == 0)
        continue;
      const Lumen_part part = divider.part(k);
      std::vector<Reason> here;
      for (const Reason& r : reasons_)
        if (std::find(part.whole_patch.begin(), part.whole_patch.end(), r.patch) != part.whole_patch.end())
          here.push_back(r);
      const Reason& reason = here.front();
      for (std::size_t i = 1; i < here.size(); ++i)
        others.push_back({here[i].place, here[i].reason});
      try {
        const Junction_filler::Number_of_cells n = filler_->fill(part, size, mesh);
        report.places_without_blocks.push_back({reason.place, reason.reason, n.pyramids, n.tetrahedra});
        report.number_of_junctions += reason.is_junction;
      } catch (Error& e) {
        e.transform_places([&](const Place& p) { return frame_.from_frame(p); });
        throw Meshing_error(reason.reason + ", and what it leaves cannot be filled: " + e.what());
      }
    }
    report.places_without_blocks.insert(report.places_without_blocks.end(), others.begin(), others.end());
  }

  static constexpr int no_interface = 0; // no facet has this label
  // Of cuts from junctions, in radii: where two vessels leave each other, layers need room between their cuts.
  static constexpr double clearance = 1;

  const Model_in_its_frame& frame_;
  Labelled_surface surface_;
  const Centerline_graph& graph_;
  const Hexahedral_blocks_options& blocks_;
  const Mesher_options& options_;
  Surface_cut cut_;
  std::vector<char> is_filled_; // of each patch
  std::vector<Reason> reasons_;
  int first_cap_ = 0;
  std::optional<Junction_filler> filler_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_BLOCKS_ROUND_JUNCTIONS_H
