// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_MESHER_IMPL_H
#define CGAL_TUBULAR_MESHING_PIPELINES_MESHER_IMPL_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_metric_field.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/Fields/Local_radius.h>
#include <CGAL/Tubular_meshing/Fields/Refined_metric_field.h>
#include <CGAL/Tubular_meshing/Hexahedra/subdivide_into_hexahedra.h>
#include <CGAL/Tubular_meshing/Layers/append_mesh.h>
#include <CGAL/Tubular_meshing/Layers/boundary_layer_heights.h>
#include <CGAL/Tubular_meshing/Layers/unfold_wall.h>
#include <CGAL/Tubular_meshing/Volume/move_boundary_to_surface.h>
#include <CGAL/Tubular_meshing/Volume/preserve_volume.h>
#include <CGAL/Tubular_meshing/Pipelines/Element_target.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesher.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Element_counts.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Lumen_integrator.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Model_in_its_frame.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/check_mesh_of_model.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/check_requests.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/hexahedral_sentences.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/mesh_by_blocks.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/optimize_subdivided.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

namespace internal {

inline std::size_t number_of_cells(const Mixed_mesh& mesh) {
  return mesh.number_of_cells();
}

} // namespace internal

class Mesher::Impl {
public:
  Impl(std::shared_ptr<const Tubular_model> model, const Mesher_options& options)
      : model_(std::move(model))
      , options_(options)
      , frame_(*model_) {
    frame_.scale_lengths(options_.size);
    frame_.scale_lengths(options_.metric);
    internal::check_requests(options_.size.size_requests, *model_);
    options_.size.size_requests = frame_.in_frame(std::move(options_.size.size_requests));
  }

  const Tubular_model& model() const { return *model_; }
  const Mesher_report& report() const { return report_; }
  Remeshed_surface take_kept_surface() { return std::exchange(kept_, Remeshed_surface()); }
  Block_structure take_block_structure() { return std::exchange(structure_, Block_structure()); }

  double points() const { return options_.size.points_per_circumference; }
  void set_points(double points) {
    const double factor = points / options_.size.points_per_circumference, least = 3;
    for (double* n : {&options_.metric.curvature_points, &options_.metric.points_per_circumference})
      *n = points < least ? points : (std::max)(factor * *n, least);
    options_.size.points_per_circumference = points;
    size_.reset();
  }

  double estimated_number_of_tetrahedra() { return size().estimated_number_of_tetrahedra(); }

  Mesh_estimate estimate(Mesh_type type, Surface_elements elements) {
    int layers = 0;
    double thickness = 0;
    if (options_.has_boundary_layer()) {
      const internal::Boundary_layer_heights heights(options_.boundary_layer);
      layers = heights.layers;
      thickness = (std::min)(heights.total(), 0.95);
    }
    const Centerline_sizing_field& h = size();
    const Local_radius& r = radius();
    stage("estimate");
    internal::Lumen_integrator integrator(frame_.surface(), h, r, thickness, options_.size.number_of_threads);
    const bool has_metric = type == Mesh_type::anisotropic || elements == Surface_elements::anisotropic_triangles;
    if (has_metric) {
      const Labelled_surface& s = frame_.surface();
      const Centerline_metric_field metric(s.surface, s.patch, frame_.centerlines(), options_.metric);
      options_.size.size_requests.empty() ? integrator.add_metric(metric) : integrator.add_metric(refined(metric));
    }
    Mesh_estimate result;
    result.integrals = integrator.integrals();
    result.smallest_size = frame_.length_from_frame(integrator.smallest_size());
    result.largest_size = frame_.length_from_frame(integrator.largest_size());
    for (const Centerline_graph::Branch& b : model_->centerlines.branches()) {
      result.vessel_length += b.length;
      result.smallest_radius = (std::min)(result.smallest_radius, b.min_radius);
      result.largest_radius = (std::max)(result.largest_radius, b.max_radius);
    }
    const bool in_blocks = (type == Mesh_type::hexahedral && options_.hexahedral_method == Hexahedral_method::blocks) ||
                           (type == Mesh_type::surface && elements == Surface_elements::structured_quads);
    if (in_blocks && !has_blocks(result))
      result.method = Hexahedral_method::subdivision;
    if (type == Mesh_type::hexahedral && options_.hexahedral_method == Hexahedral_method::subdivision)
      result.method = Hexahedral_method::subdivision;
    const double openings = double(model_->openings.size());
    if (type == Mesh_type::surface)
      internal::count_facets(result, elements, points(), openings);
    else
      internal::count_cells(result, type, layers, points(), coarsening_for_subdivision(), openings);
    internal::estimate_cost(result, type, double(model_->surface.number_of_faces()));
    return result;
  }

  /* Makes a mesh; again with other N, until it has the number of elements that is wanted. The number goes with a power
   * of N; `first` gives the N to begin with. */
  template <class Make, class Count, class First>
  auto fitted(const Make& make, const Count& count, double power, const First& first) {
    if (options_.number_of_elements == 0)
      return make();
    Element_target target(options_.number_of_elements,
                          first(options_.number_of_elements, points(), estimated_number_of_tetrahedra()), power);
    for (;;) {
      set_points(target.points());
      auto mesh = make();
      if (target.add(count(mesh)))
        return mesh;
    }
  }

  /* Runs what makes a mesh in the frame, and brings the mesh back from there, or the places of what is thrown. */
  template <class Make> auto made(const Make& make) {
    report_ = Mesher_report();
    kept_ = Remeshed_surface();
    structure_ = Block_structure();
    moves_wall_ = options_.preserve_volume;
    coarsening_ = 1;
    try {
      auto mesh = make();
      frame_.bring_back(mesh);
      frame_.bring_back(kept_);
      return mesh;
    } catch (Error& e) {
      e.transform_places([&](const Place& p) { return frame_.from_frame(p); });
      e.set_stage(stage_);
      throw;
    }
  }

  Mixed_mesh isotropic() {
    return made([&] {
      Mixed_mesh mesh = isotropic_in_frame(options_.surface_mesher);
      name_patches(mesh);
      return mesh;
    });
  }

  Mixed_mesh anisotropic() {
    return made([&] {
      if (options_.has_boundary_layer())
        throw Parameter_error("An anisotropic mesh has its layers in tetrahedra: leave the layers of prisms out, or "
                              "make an isotropic mesh.");
      moves_wall_ = false; // remeshing would bring it back to the surface
      Mixed_mesh mesh = isotropic_in_frame(Surface_mesher::parametric);
      kept_ = Remeshed_surface(); // remeshing does not keep it
      const Labelled_surface& wall = by_patches_ ? by_patches_->surface : frame_.surface();
      stage("metric field");
      const Centerline_metric_field metric(wall.surface, wall.patch, frame_.centerlines(), options_.metric);
      options_.remeshing.boundary_layer_patches = {labels::wall};
      const auto remesh = [&](const auto& field) {
        stage("anisotropic remeshing");
        internal::anisotropic_tetrahedral_remeshing(mesh, wall.surface, wall.patch, field, options_.remeshing);
      };
      options_.size.size_requests.empty() ? remesh(metric) : remesh(refined(metric));
      stage("check");
      internal::check_differences(mesh, *model_, frame_.surface().surface);
      moves_wall_ = options_.preserve_volume;
      give_volume_to(mesh);
      mesh.region_names = {{labels::lumen, "lumen"}};
      name_patches(mesh);
      return mesh;
    });
  }

  Mixed_mesh mixed() {
    return made([&] {
      internal::check_keeps_boundary(options_.volume_mesher);
      check_memory();
      Fill_with_pyramids_and_tetrahedra_options pyramids = options_.pyramids;
      pyramids.split_quads = !options_.has_boundary_layer(); // not the far sides of hexahedra
      kept_ = quads_in_frame();
      give_volume_to(kept_);
      Mixed_mesh mesh =
          fill_within_layers(kept_, [&](const Surface& closed, Face_patch_map patch, Mixed_mesh& filling) {
            stage("pyramids and tetrahedra");
            internal::fill_with_pyramids_and_tetrahedra(closed, patch, size(), filling, pyramids);
          });
      name_patches(mesh);
      add_wall(mesh);
      stage("check");
      internal::check_differences(mesh, *model_, frame_.surface().surface);
      return mesh;
    });
  }

  Mixed_mesh hexahedral() {
    return made([&] {
      check_memory();
      std::optional<Mixed_mesh> mesh;
      if (options_.hexahedral_method == Hexahedral_method::blocks)
        mesh = by_blocks(options_.hexahedral_fallback);
      if (!mesh)
        mesh = by_subdivision();
      name_patches(*mesh);
      add_wall(*mesh);
      stage("check");
      internal::check_differences(*mesh, *model_, frame_.surface().surface);
      return std::move(*mesh);
    });
  }

  Remeshed_surface surface(Surface_elements elements) {
    return made([&] {
      if (elements == Surface_elements::structured_quads)
        return structured_quads_in_frame();
      Remeshed_surface result = surface_in_frame(elements);
      give_volume_to(result);
      return result;
    });
  }

private:
  // The surface as it was cut, in patches, and their maps.
  struct Patches {
    Labelled_surface surface;
    Surface_cut cut;
    std::vector<Patch_parameterization> maps;
  };

  // Measures the blocks; false where there are none, for which the result has the reason.
  bool has_blocks(Mesh_estimate& result) {
    internal::Mesh_by_blocks blocks(*model_, frame_, size(), options_);
    Hexahedral_report report;
    const std::optional<internal::Length_of_blocks> length = blocks.length(report);
    bring_back_places(report);
    if (length) {
      result.integrals.rows_of_blocks = double(length->rows);
      result.integrals.domes_of_blocks = double(length->domes);
    } else
      result.fallbacks.push_back(
          "There are no blocks of hexahedra along the vessels: " + internal::why_no_blocks(report) +
          (options_.hexahedral_fallback == Hexahedral_fallback::none ? " Without a fallback there will be no mesh."
                                                                     : " All hexahedra are made by subdivision."));
    return bool(length);
  }

  void stage(const char* name) {
    stage_ = name;
    if (options_.observer)
      options_.observer(name);
  }

  const Centerline_sizing_field& size() {
    if (!size_) {
      stage("size field");
      size_.emplace(radius(), options_.size);
    }
    return *size_;
  }

  /* The mesh size, or that of cells which are to be subdivided: larger. */
  struct Scaled_size {
    const Centerline_sizing_field* size;
    double factor;
    double operator()(const Point_3& p) const { return factor * (*size)(p); }
  };
  Scaled_size scaled_size() {
    const Centerline_sizing_field& field = size();
    return {&field, coarsening_};
  }

  // The one radius that sizes, layers and walls are relative to.
  const Local_radius& radius() {
    if (!radius_) {
      const Labelled_surface& s = frame_.surface();
      Shape_radius_options shape;
      shape.number_of_threads = options_.size.number_of_threads;
      radius_.emplace(Centerline_field(frame_.centerlines()), Wall_distance(s.surface, s.patch, labels::wall), shape);
    }
    return *radius_;
  }

  // A metric with what is wanted beside it.
  Refined_metric_field refined(const Centerline_metric_field& metric) {
    Centerline_sizing_field_options without = options_.size;
    without.size_requests = Size_requests();
    return Refined_metric_field(metric, Centerline_sizing_field(radius(), without), size());
  }

  const Patches& patches() {
    if (!by_patches_) {
      stage("cut");
      Patches p{frame_.copy_of_surface(), {}, {}};
      p.cut = internal::cut_by_centerlines(p.surface.surface, frame_.centerlines(), p.surface.patch, options_.cut);
      stage("parameterization");
      p.maps = internal::parameterize_patches(p.surface.surface, p.cut, options_.parameterization);
      by_patches_.emplace(std::move(p));
    }
    return *by_patches_;
  }

  template <class Size> Remeshed_surface triangles_in_frame(const Size& size) {
    const Patches& p = patches();
    stage("surface mesh");
    return remesh_patches(p.surface.surface, p.cut, p.maps, size, options_.surface);
  }

  Remeshed_surface surface_in_frame(Surface_elements elements) {
    if (elements != Surface_elements::anisotropic_triangles)
      internal::check_memory(internal::estimated_number_of_triangles(frame_.surface().surface, size()), "triangles");
    if (elements == Surface_elements::quads)
      return quads_in_frame();
    if (elements == Surface_elements::triangles)
      return triangles_in_frame(size());
    stage("metric field");
    const Centerline_metric_field metric(frame_.surface().surface, frame_.surface().patch, frame_.centerlines(),
                                         options_.metric);
    return options_.size.size_requests.empty() ? triangles_in_frame(metric) : triangles_in_frame(refined(metric));
  }

  // The boundary of blocks.
  Remeshed_surface structured_quads_in_frame() {
    if (options_.has_boundary_layer())
      throw Parameter_error("Layers inside the lumen are of a mesh of cells; a surface has none.");
    check_memory();
    const Mixed_mesh mesh = *by_blocks(Hexahedral_fallback::none);
    structure_ = Block_structure(); // of points that are not those of the surface
    Remeshed_surface result;
    std::vector<Surface::Vertex_index> vertex_of(mesh.points.size(), Surface::null_vertex());
    for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
      std::array<Surface::Vertex_index, 4> corners;
      for (std::size_t k = 0; k < 4; ++k) {
        Surface::Vertex_index& v = vertex_of[mesh.quads.vertices[i][k]];
        if (v == Surface::null_vertex())
          v = result.surface.add_vertex(mesh.points[mesh.quads.vertices[i][k]]);
        corners[k] = v;
      }
      const Surface::Face_index f = result.surface.add_face(corners);
      if (f == Surface::null_face())
        throw Meshing_error("The boundary of the blocks is no surface: it meets itself at an edge or a vertex.");
      result.patch[f] = mesh.quads.label[i];
    }
    return result;
  }

  Remeshed_surface quads_in_frame() {
    size();
    const Patches& p = patches();
    stage("quads");
    return internal::quadrangulate_patches(p.surface.surface, p.cut, p.maps, size(), options_.quads);
  }

  Mixed_mesh isotropic_in_frame(Surface_mesher mesher) {
    check_memory();
    if (mesher == Surface_mesher::mesh_3)
      return by_mesh_3();
    try {
      return by_patches();
    } catch (const Meshing_error& e) {
      if (options_.has_boundary_layer()) // Mesh_3 keeps no layer's side
        throw;
      report_.fallbacks.push_back(fallback_sentence(e));
    } catch (const Parameter_error& e) {
      // the sizes are in order: where a patch asks for too many triangles, it is the patch that is not
      if (stage_ != "surface mesh" || options_.has_boundary_layer())
        throw;
      report_.fallbacks.push_back(fallback_sentence(e));
    }
    kept_ = Remeshed_surface();
    return by_mesh_3();
  }

  std::string fallback_sentence(Error e) const {
    e.transform_places([&](const Place& p) { return frame_.from_frame(p); });
    return "Mesh_3 made this mesh, since meshing by patches failed at the stage \"" + stage_ + "\": " + e.what();
  }

  /* The surface patch by patch in the parametric plane, then the lumen between its triangles. */
  Mixed_mesh by_patches() {
    const Scaled_size size = scaled_size();
    kept_ = triangles_in_frame(size);
    const Labelled_surface& wall = patches().surface;
    check_layers_can_be_kept(options_.volume_mesher);
    const bool keeps = options_.volume_mesher != Volume_mesher::mesh_3;
    if (keeps)
      give_volume_to(kept_);
    Mixed_mesh mesh = fill_within_layers(kept_, [&](const Surface& closed, Face_patch_map patch, Mixed_mesh& filling) {
      stage("tetrahedra");
      if (keeps)
        internal::fill_keeping_boundary(closed, patch, size, filling, options_.filling);
      else
        internal::fill_with_mesh_3(closed, patch, size, filling, options_.mesh_3);
      stage("optimization");
      Optimize_tetrahedra_options optimization = options_.optimization;
      optimization.keep_boundary = keeps;
      internal::optimize_tetrahedra(filling, wall.surface, wall.patch, optimization);
    });
    stage("check");
    internal::check_differences(mesh, *model_, frame_.surface().surface);
    if (!keeps)
      give_volume_to(mesh);
    return mesh;
  }

  /* Surface and lumen at once; finer, by a factor of at most two, where the mesh size is too coarse for the topology.
   */
  Mixed_mesh by_mesh_3() {
    check_layers_can_be_kept(Volume_mesher::mesh_3);
    const Labelled_surface& s = frame_.surface();
    std::string differences;
    for (double factor : {1., 0.7, 0.5}) {
      Mixed_mesh mesh;
      stage("tetrahedra");
      internal::fill_with_mesh_3(
          s.surface, s.patch, [&](const Point_3& p) { return factor * scaled_size()(p); }, mesh, options_.mesh_3);
      stage("optimization");
      internal::optimize_tetrahedra(mesh, s.surface, s.patch, options_.optimization);
      stage("check");
      differences = internal::differences(mesh, *model_, frame_.surface().surface);
      if (differences.empty()) {
        give_volume_to(mesh);
        return mesh;
      }
    }
    throw Meshing_error("The mesh came out with " + differences +
                        ": the surface may intersect itself, or have parts much narrower than the mesh size there.");
  }

  // The local radius, as far as the mesh size goes with it.
  auto limited_radius() {
    return [&field = size(), points = points()](const Point_3& p) { return field(p) * points / (2 * CGAL_PI); };
  }

  /* Hexahedra in blocks; none where these cannot be had and another method is to be taken. */
  std::optional<Mixed_mesh> by_blocks(Hexahedral_fallback fallback) {
    Hexahedral_report& report = report_.hexahedral;
    const Centerline_sizing_field& field = size();
    stage("blocks");
    internal::Mesh_by_blocks blocks(*model_, frame_, field, options_);
    std::optional<Mixed_mesh> mesh = blocks.make(report, fallback == Hexahedral_fallback::mixed);
    bring_back_places(report);
    std::string why;
    if (!mesh)
      why = "There are no blocks of hexahedra along the vessels: " + internal::why_no_blocks(report) +
            (blocks.why_not_filled().empty() ? "" : " " + internal::why_not_filled(blocks.why_not_filled()));
    while (mesh) {
      try {
        finish(blocks, *mesh);
        structure_ = blocks.take_structure();
        if (blocks.has_filled_junctions())
          report_.fallbacks.push_back(internal::filled_junctions(report, blocks.fineness()));
        return mesh;
      } catch (Meshing_error& e) {
        e.transform_places([&](const Place& p) { return frame_.from_frame(p); });
        const std::vector<Place_without_blocks> places = std::move(report.places_without_blocks);
        report = Hexahedral_report(); // what it says is of blocks that are not used
        report_.boundary_layer = Layer_report();
        report_.volume = Preserve_volume_report();
        why = std::string("Hexahedra in blocks are not valid: ") + e.what();
        mesh.reset();
        if (blocks.has_filled_junctions()) {
          for (const Place_without_blocks& p : places)
            report.places_without_blocks.push_back({p.place, p.reason});
          why = "There are no blocks of hexahedra along the vessels: " + internal::why_no_blocks(report) + " " +
                internal::why_not_filled(e.what());
          const Hexahedral_report without = report;
          stage("blocks");
          mesh = blocks.make_finer(report);
          if (!mesh)
            report = without;
          else
            bring_back_places(report);
        }
      }
    }
    if (fallback == Hexahedral_fallback::none)
      throw Meshing_error(why + " By subdivision there are hexahedra of any shape, and surfaces of any shape in quads "
                                "that are not structured.");
    report_.fallbacks.push_back(why + " All hexahedra are made by subdivision.");
    return std::nullopt;
  }

  // Gives blocks the surface's volume, and layers along the wall.
  void finish(const internal::Mesh_by_blocks& blocks, Mixed_mesh& mesh) {
    stage("check");
    internal::check_differences(mesh, *model_, frame_.surface().surface);
    if (moves_wall_) {
      give_volume_to(mesh);
      stage("optimization");
      blocks.optimize_inside(mesh);
    }
    if (!options_.has_boundary_layer())
      return;
    stage("boundary layer");
    report_.boundary_layer = blocks.insert_layers(mesh, radius(), report_.hexahedral);
    report_.boundary_layer.worst_place = frame_.from_frame(report_.boundary_layer.worst_place);
    blocks.optimize_layers(mesh);
    stage("check");
    internal::check_differences(mesh, *model_, frame_.surface().surface);
  }

  void bring_back_places(Hexahedral_report& report) const {
    for (Place_without_blocks& p : report.places_without_blocks)
      p.place = frame_.from_frame(p.place);
  }

  /* Tetrahedra and prisms of a coarser mesh, subdivided: four hexahedra of each tetrahedron are as many as there are
   * tetrahedra of 1.6 times smaller edges. A coarse mesh is no coarser than its topology can bear. */
  Mixed_mesh by_subdivision() {
    report_.hexahedral.method = Hexahedral_method::subdivision;
    moves_wall_ = false; // its new vertices are to be on the surface first
    coarsening_ = coarsening_for_subdivision();
    Mixed_mesh mesh = isotropic_in_frame(options_.surface_mesher);
    kept_ = Remeshed_surface(); // its triangles are subdivided
    stage("subdivision");
    mesh = subdivide_into_hexahedra(mesh);
    const Labelled_surface& s = frame_.surface();
    Move_boundary_to_surface_options moving;
    moving.number_of_threads = options_.size.number_of_threads;
    report_.hexahedral.boundary =
        internal::move_boundary_to_surface(mesh, s.surface, s.patch, limited_radius(), moving);
    frame_.bring_back(report_.hexahedral.boundary);
    stage("optimization of hexahedra");
    Optimize_hexahedra_options optimization = options_.hexahedra;
    optimization.number_of_threads = options_.size.number_of_threads;
    report_.hexahedral.optimization =
        internal::optimize_subdivided(mesh, s, optimization, options_.has_boundary_layer());
    moves_wall_ = options_.preserve_volume;
    move_wall_of(mesh);
    return mesh;
  }

  double coarsening_for_subdivision() const { return internal::coarsening_for_subdivision(points()); }

  void add_wall(Mixed_mesh& mesh) {
    if (!options_.wall)
      return;
    stage("wall");
    report_.wall = internal::extrude_wall(mesh, radius(), frame_.in_frame(*options_.wall));
    report_.wall.worst_place = frame_.from_frame(report_.wall.worst_place);
  }

  /* Meshes the lumen by fill(surface, patch, mesh): all of it, or, where layers are wanted along the wall, what they
   * leave of it. */
  template <class Fill> Mixed_mesh fill_within_layers(Remeshed_surface& surface, const Fill& fill) {
    Mixed_mesh mesh;
    if (!options_.has_boundary_layer()) {
      fill(surface.surface, surface.patch, mesh);
      return mesh;
    }
    stage("boundary layer");
    unfold(surface);
    Boundary_layer layer =
        internal::extrude_boundary_layer(surface.surface, surface.patch, radius(), options_.boundary_layer);
    report_.boundary_layer = layer.report;
    report_.boundary_layer.worst_place = frame_.from_frame(layer.report.worst_place);
    try {
      fill(layer.inner, layer.patch, mesh);
    } catch (const Meshing_error&) {
      throw Meshing_error("Inside of the boundary layers the lumen cannot be filled: ask for fewer or thinner layers, "
                          "or for a finer mesh.");
    }
    append_mesh(layer.layers, mesh, layer.mesh_points);
    return std::move(layer.layers);
  }

  // Folds that leave layers no room.
  void unfold(Remeshed_surface& surface) {
    const internal::Unfolded_wall unfolded = internal::unfold_wall(surface.surface, surface.patch);
    if (unfolded.vertices == 0)
      return;
    const Point_3 place = frame_.from_frame(unfolded.place);
    std::ostringstream s;
    s.precision(6);
    s << "To make room for layers in folds of the wall, " << unfolded.vertices << " of its vertices were moved, one by "
      << frame_.length_from_frame(unfolded.distance) << " near (" << place.x() << ", " << place.y() << ", " << place.z()
      << ").";
    report_.fallbacks.push_back(s.str());
  }

  // --- the volume of the surface ---

  template <class Report> void note_volume(Report report) {
    frame_.bring_back(report);
    report_.volume = std::move(report);
  }
  Preserve_volume_options volume_options() const {
    Preserve_volume_options result;
    result.number_of_threads = options_.size.number_of_threads;
    return result;
  }

  // To a surface mesh that is kept from here on.
  void give_volume_to(Remeshed_surface& mesh) {
    if (!moves_wall_)
      return;
    stage("volume");
    const Labelled_surface& s = frame_.surface();
    note_volume(internal::preserve_volume(mesh.surface, mesh.patch, s.surface, s.patch, volume_options()));
    if (mesh.quads.wall_quads() > 0)
      internal::measure_quads(mesh);
  }

  // To a mesh that has brought its boundary to the surface.
  void move_wall_of(Mixed_mesh& mesh) {
    if (!moves_wall_)
      return;
    stage("volume");
    const Labelled_surface& s = frame_.surface();
    note_volume(internal::preserve_volume(mesh, s.surface, s.patch, limited_radius(), volume_options()));
  }

  // The same to a valid one; it is still valid then.
  void give_volume_to(Mixed_mesh& mesh) {
    if (!moves_wall_)
      return;
    move_wall_of(mesh);
    stage("check");
    internal::check_differences(mesh, *model_, frame_.surface().surface);
  }

  void check_layers_can_be_kept(Volume_mesher mesher) const {
    if (options_.has_boundary_layer() && mesher == Volume_mesher::mesh_3)
      throw Meshing_error(
          "Layers inside the lumen need a mesher that keeps their sides: build this program where CMake "
          "finds TetGen (libtet1.5-dev), or CGAL 6.1 or later, and choose one of these.");
  }
  void check_memory() { internal::check_memory(size().estimated_number_of_tetrahedra()); }
  void name_patches(Mixed_mesh& mesh) const {
    mesh.patch_names = patch_names(*model_);
    mesh.patch_ids = model_->patch_ids;
  }

  std::shared_ptr<const Tubular_model> model_;
  Mesher_options options_;
  internal::Model_in_its_frame frame_;
  std::optional<Local_radius> radius_;
  std::optional<Centerline_sizing_field> size_;
  std::optional<Patches> by_patches_;
  Remeshed_surface kept_;
  Block_structure structure_;
  Mesher_report report_;
  std::string stage_;
  bool moves_wall_ = true;
  double coarsening_ = 1; // of the mesh size, for cells that are to be subdivided
};

CGAL_TUBULAR_MESHING_INLINE Mesher::Mesher(const Tubular_model& model, const Mesher_options& options)
    : impl_(new Impl(std::shared_ptr<const Tubular_model>(std::shared_ptr<const Tubular_model>(), &model), options)) {}
CGAL_TUBULAR_MESHING_INLINE Mesher::Mesher(Tubular_model&& model, const Mesher_options& options)
    : impl_(new Impl(std::make_shared<const Tubular_model>(std::move(model)), options)) {}
CGAL_TUBULAR_MESHING_INLINE Mesher::Mesher(Mesher&&) = default;
CGAL_TUBULAR_MESHING_INLINE Mesher& Mesher::operator=(Mesher&&) = default;
CGAL_TUBULAR_MESHING_INLINE Mesher::~Mesher() = default;

CGAL_TUBULAR_MESHING_INLINE const Tubular_model& Mesher::model() const {
  return impl_->model();
}
CGAL_TUBULAR_MESHING_INLINE void Mesher::set_points_per_circumference(double points) {
  impl_->set_points(points);
}
CGAL_TUBULAR_MESHING_INLINE double Mesher::points_per_circumference() const {
  return impl_->points();
}
CGAL_TUBULAR_MESHING_INLINE double Mesher::estimated_number_of_tetrahedra() {
  return impl_->estimated_number_of_tetrahedra();
}
CGAL_TUBULAR_MESHING_INLINE Mesh_estimate Mesher::estimate(Mesh_type type, Surface_elements elements) {
  return impl_->estimate(type, elements);
}
CGAL_TUBULAR_MESHING_INLINE Mixed_mesh Mesher::isotropic() {
  return impl_->fitted([&] { return impl_->isotropic(); }, internal::number_of_cells, 3, Element_target::first_points);
}
CGAL_TUBULAR_MESHING_INLINE Mixed_mesh Mesher::anisotropic() {
  return impl_->fitted([&] { return impl_->anisotropic(); }, internal::number_of_cells, Element_target::power_of_layers,
                       Element_target::first_points_of_layers);
}
CGAL_TUBULAR_MESHING_INLINE Mixed_mesh Mesher::mixed() {
  return impl_->fitted([&] { return impl_->mixed(); }, internal::number_of_cells, 3, Element_target::first_points);
}
CGAL_TUBULAR_MESHING_INLINE Mixed_mesh Mesher::hexahedral() {
  return impl_->fitted([&] { return impl_->hexahedral(); }, internal::number_of_cells, 3, Element_target::first_points);
}
CGAL_TUBULAR_MESHING_INLINE Remeshed_surface Mesher::surface(Surface_elements elements) {
  return impl_->fitted([&] { return impl_->surface(elements); },
                       [](const Remeshed_surface& s) { return std::size_t(s.surface.number_of_faces()); }, 2,
                       Element_target::first_points);
}
CGAL_TUBULAR_MESHING_INLINE Block_structure Mesher::block_structure() {
  return impl_->take_block_structure();
}

CGAL_TUBULAR_MESHING_INLINE Remeshed_surface Mesher::kept_surface() {
  return impl_->take_kept_surface();
}
CGAL_TUBULAR_MESHING_INLINE const Mesher_report& Mesher::report() const {
  return impl_->report();
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PIPELINES_MESHER_IMPL_H
