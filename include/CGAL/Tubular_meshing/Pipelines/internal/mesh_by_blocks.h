// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_MESH_BY_BLOCKS_H
#define CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_MESH_BY_BLOCKS_H

#include <CGAL/Tubular_meshing/Centerlines/build_centerline_graph.h>
#include <CGAL/Tubular_meshing/Centerlines/compute_centerlines.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/Hexahedra/hexahedral_blocks.h>
#include <CGAL/Tubular_meshing/Hexahedra/insert_wall_layers.h>
#include <CGAL/Tubular_meshing/Hexahedra/optimize_hexahedra.h>
#include <CGAL/Tubular_meshing/Layers/boundary_layer_heights.h>
#include <CGAL/Tubular_meshing/Pipelines/Hexahedral_report.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesher_options.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Blocks_round_junctions.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Model_in_its_frame.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Makes hexahedra in blocks along the vessels of a model, in the model's frame. Vessels that have no centerline, such as
 * sacs, get one first. */
class Mesh_by_blocks {
public:
  Mesh_by_blocks(const Tubular_model& model, const Model_in_its_frame& frame, const Centerline_sizing_field& size,
                 const Mesher_options& options)
      : model_(model)
      , frame_(frame)
      , size_(size)
      , options_(options)
      , graph_(frame.centerlines()) {
    blocks_options_.points_per_circumference = options.size.points_per_circumference;
    blocks_options_.number_of_threads = options.size.number_of_threads;
    if (options.has_boundary_layer())
      blocks_options_.layer_thickness = (std::min)(Boundary_layer_heights(options.boundary_layer).total(), 0.8);
  }

  /* None where blocks cannot be had: the report says why. Junctions that have none may be filled in another way, if
   * that is wanted. */
  std::optional<Mixed_mesh> make(Hexahedral_report& report, bool may_fill_junctions) {
    Hexahedral_blocks blocks = made();
    for (int generation = 0; generation < most_generations && add_lines(blocks); ++generation)
      blocks = made();
    if (!blocks.refused.empty() && may_fill_junctions) {
      refused_ = blocks.refused;
      if (std::optional<Mixed_mesh> mesh = with_junctions_filled(report))
        return mesh;
    }
    report.number_of_junctions = blocks.junctions;
    if (!blocks.refused.empty()) {
      for (const Refused_blocks& r : blocks.refused)
        report.places_without_blocks.push_back({r.place, r.reason});
      return std::nullopt;
    }
    report.method = Hexahedral_method::blocks;
    report.number_of_blocks = blocks.structure.hexahedra.size();
    report.irregular_edges = blocks.irregular_edges;
    report.points_per_circumference = blocks.points_per_circumference;
    report.twist = blocks.twist;
    report.optimization = blocks.optimization;
    structure_ = std::move(blocks.structure);
    blocks.mesh.region_names = {{labels::lumen, "lumen"}};
    return std::move(blocks.mesh);
  }

  /* How long the blocks of such a mesh are, in little time: whether there are any is tried with eight points round a
   * vessel. */
  std::optional<Length_of_blocks> length(Hexahedral_report& report) {
    const Labelled_surface& s = frame_.surface();
    blocks_options_.points_per_circumference = 8;
    const Scaled_size coarse{size_, options_.size.points_per_circumference / 8};
    const auto tried = [&] {
      return internal::make_hexahedral_blocks(s.surface, s.patch, graph_, coarse, blocks_options_);
    };
    Hexahedral_blocks blocks = tried();
    for (int generation = 0; generation < most_generations && add_lines(blocks); ++generation)
      blocks = tried();
    report.number_of_junctions = blocks.junctions;
    for (const Refused_blocks& r : blocks.refused)
      report.places_without_blocks.push_back({r.place, r.reason});
    if (!blocks.refused.empty())
      return std::nullopt;
    return internal::length_of_blocks(s.surface, s.patch, graph_, scaled_size(), blocks_options_);
  }

  // The size of the cells in junctions that are filled, in mesh sizes.
  double fineness() const { return fineness_; }

  bool has_filled_junctions() const { return round_junctions_.has_value(); }

  // The same as before, with finer cells in the junctions that are filled; none if that cannot be done.
  std::optional<Mixed_mesh> make_finer(Hexahedral_report& report) {
    fineness_ *= finer;
    return with_junctions_filled(report);
  }

  // Why junctions could not be filled, if that was wanted: part of a sentence.
  const std::string& why_not_filled() const { return why_not_filled_; }

  // Of the mesh that was made; empty where junctions are filled.
  Block_structure take_structure() { return std::move(structure_); }

  /* Improves what is inside of a boundary that has been moved, and stays. */
  void optimize_inside(Mixed_mesh& mesh) const { optimize_inside(mesh, Optimize_hexahedra_options()); }

  // The same where layers have made bad hexahedra; they keep their proportions.
  void optimize_layers(Mixed_mesh& mesh) const {
    Optimize_hexahedra_options optimization;
    optimization.quality_wanted = 0.15;
    optimization.tempering = 0;
    optimize_inside(mesh, optimization);
  }

  // Cuts the hexahedra along the wall; junctions that are filled get layers, too, and the report what is left of them.
  Layer_report insert_layers(Mixed_mesh& mesh, Length_function radius, Hexahedral_report& report) const {
    if (round_junctions_)
      try {
        return round_junctions_->insert_layers(mesh, radius, scaled_size(fineness_), report);
      } catch (Input_error& e) { // of quads that have been made here
        e.transform_places([&](const Place& p) { return frame_.from_frame(p); });
        throw Meshing_error(std::string(e.what()));
      }
    return internal::insert_wall_layers(mesh, radius, options_.boundary_layer);
  }

private:
  static constexpr double finer = 0.7, finest = 0.4;
  static constexpr int most_generations = 2; // vessels without a centerline may leave others

  void optimize_inside(Mixed_mesh& mesh, Optimize_hexahedra_options optimization) const {
    std::vector<bool> fixed(mesh.points.size());
    for (const auto& q : mesh.quads.vertices)
      for (std::uint32_t v : q)
        fixed[v] = true;
    optimization.fixed_vertices = &fixed;
    optimization.number_of_threads = options_.size.number_of_threads;
    internal::optimize_hexahedra(mesh, frame_.surface().surface, frame_.surface().patch, optimization);
  }

  /* The mesh size of N as blocks have it. */
  struct Scaled_size {
    const Centerline_sizing_field& size;
    double factor;
    double operator()(const Point_3& p) const { return factor * size(p); }
  };
  Scaled_size scaled_size(double factor = 1) const {
    const double points = options_.size.points_per_circumference;
    return {size_, factor * points / double(blocks_points(points))};
  }

  Hexahedral_blocks made() const {
    const Labelled_surface& s = frame_.surface();
    return internal::make_hexahedral_blocks(s.surface, s.patch, graph_, scaled_size(), blocks_options_);
  }

  /* Where cells of the mesh size do not fit in sharp crotches, finer ones may. None where that cannot be done:
   * why_not_filled() says why. */
  std::optional<Mixed_mesh> with_junctions_filled(Hexahedral_report& report) {
    if (!std::all_of(refused_.begin(), refused_.end(), [](const Refused_blocks& r) { return r.can_be_left_out; })) {
      why_not_filled_ = "it is not a junction that lacks blocks";
      return std::nullopt;
    }
    for (; fineness_ > finest; fineness_ *= finer)
      try {
        report = Hexahedral_report();
        round_junctions_.emplace(frame_, graph_, blocks_options_, options_);
        Mixed_mesh mesh = round_junctions_->make(refused_, scaled_size(), scaled_size(fineness_), report);
        mesh.region_names = {{labels::lumen, "lumen"}};
        return mesh;
      } catch (const Error& e) {
        why_not_filled_ = e.what();
        round_junctions_.reset();
        report = Hexahedral_report();
      }
    return std::nullopt;
  }

  /* Adds lines to the tips of parts that were missed: no line leads to some vertices, as on spikes. False if there are
   * none, or no line leads there. */
  bool add_lines(const Hexahedral_blocks& blocks) {
    const std::size_t before = missed_parts_.size();
    for (const Refused_blocks& r : blocks.refused)
      if (!r.missed.empty())
        missed_parts_.push_back(r.missed);
    if (missed_parts_.size() == before)
      return false;
    const Labelled_surface& s = frame_.surface();
    std::vector<std::pair<Point_3, int>> ends;
    for (const Opening& o : model_.openings)
      ends.emplace_back(frame_.to_frame(o.center), o.patch);
    if (ends.size() < 2)
      return false;
    const Build_centerline_graph_options merging;
    Centerline_computation computation(s.surface, s.patch, ends, true, true, options_.size.number_of_threads);
    Centerline_graph graph;
    computation.add_ends(tips_of_blind_ends());
    computation.make_graph(graph, merging);
    bool is_longer = false;
    for (const std::vector<Vertex>& part : missed_parts_)
      is_longer =
          std::any_of(part.begin(), part.end(), [&](Vertex v) { return computation.add_ends({v}); }) || is_longer;
    if (is_longer) {
      computation.make_graph(graph, merging);
      graph_ = std::move(graph);
    }
    return is_longer;
  }

  // The vertices of the wall nearest to the graph's ends that are no openings.
  std::vector<Vertex> tips_of_blind_ends() const {
    const Surface& surface = frame_.surface().surface;
    std::vector<Face> faces;
    std::vector<Double_kernel::Triangle_3> triangles;
    const auto corner = [&](Halfedge h) { return to_double_point(surface.point(surface.target(h))); };
    for (Face f : surface.faces())
      if (frame_.surface().patch[f] == labels::wall) {
        const Halfedge h = surface.halfedge(f);
        faces.push_back(f);
        triangles.emplace_back(corner(h), corner(surface.next(h)), corner(surface.prev(h)));
      }
    const Nearest_tree<Double_kernel::Triangle_3> wall(std::move(triangles));
    std::vector<Vertex> tips;
    for (const Centerline_graph::Node& node : graph_.nodes()) {
      const Point_3& end = graph_.points()[node.point];
      if (!node.is_end() || is_at_opening(end, graph_.radii()[node.point]))
        continue;
      const auto vertices =
          surface.vertices_around_face(surface.halfedge(faces[wall.nearest(to_double_point(end)).index]));
      tips.push_back(*std::min_element(vertices.begin(), vertices.end(), [&](Vertex v, Vertex w) {
        return CGAL::squared_distance(surface.point(v), end) < CGAL::squared_distance(surface.point(w), end);
      }));
    }
    return tips;
  }

  bool is_at_opening(const Point_3& end, double radius) const {
    const double unit = frame_.length_from_frame(1);
    return std::any_of(model_.openings.begin(), model_.openings.end(), [&](const auto& o) {
      const double near = 1.5 * (std::max)(radius, o.radius / unit);
      return CGAL::squared_distance(frame_.to_frame(o.center), end) < near * near;
    });
  }

  const Tubular_model& model_;
  const Model_in_its_frame& frame_;
  const Centerline_sizing_field& size_;
  const Mesher_options& options_;
  Centerline_graph graph_;
  Hexahedral_blocks_options blocks_options_;
  std::vector<std::vector<Vertex>> missed_parts_;
  Block_structure structure_;
  std::vector<Refused_blocks> refused_;
  std::optional<Blocks_round_junctions> round_junctions_; // if some are filled in another way
  double fineness_ = 1;                                   // of what fills them
  std::string why_not_filled_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_MESH_BY_BLOCKS_H
