// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_HEXAHEDRAL_MESHER_H
#define CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_HEXAHEDRAL_MESHER_H

#include <CGAL/Tubular_meshing/Hexahedra/Block_structure.h>
#include <CGAL/Tubular_meshing/Hexahedra/subdivide_into_hexahedra.h>
#include <CGAL/Tubular_meshing/Pipelines/Hexahedral_report.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesh_estimate.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Mesher_core.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/hexahedral_sentences.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/mesh_by_blocks.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/optimize_subdivided.h>
#include <CGAL/Tubular_meshing/Volume/move_boundary_to_surface.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Makes hexahedra: in blocks along the vessels, or of the cells of a coarser mesh. */
class Hexahedral_mesher {
public:
  explicit Hexahedral_mesher(Mesher_core& core)
      : core_(core)
      , report_(core.report().hexahedral) {}

  /* Hexahedra in blocks, and their structure; none where these cannot be had and another method is to be taken. */
  std::optional<Mixed_mesh> by_blocks(Hexahedral_fallback fallback, Block_structure& structure) {
    const Centerline_sizing_field& size = core_.size();
    core_.stage("blocks");
    Mesh_by_blocks blocks(core_.model(), core_.frame(), size, core_.options());
    std::optional<Mixed_mesh> mesh = blocks.make(report_, fallback == Hexahedral_fallback::mixed);
    bring_back_places(report_);
    std::string why;
    if (!mesh)
      why = why_there_are_none(report_) +
            (blocks.why_not_filled().empty() ? "" : " " + why_not_filled(blocks.why_not_filled()));
    while (mesh)
      try {
        finish(blocks, *mesh);
        structure = blocks.take_structure();
        if (blocks.has_filled_junctions())
          core_.report().fallbacks.push_back(filled_junctions(report_, blocks.fineness()));
        return mesh;
      } catch (Meshing_error& e) {
        e.transform_places([&](const Place& p) { return core_.frame().from_frame(p); });
        why = std::string("Hexahedra in blocks are not valid: ") + e.what();
        mesh = after_invalid_ones(blocks, e.what(), why);
      }
    if (fallback == Hexahedral_fallback::none)
      throw Meshing_error(why + " By subdivision there are hexahedra of any shape, and surfaces of any shape in quads "
                                "that are not structured.");
    core_.report().fallbacks.push_back(why + " All hexahedra are made by subdivision.");
    return std::nullopt;
  }

  // Measures the blocks; false where there are none, for which the result has the reason.
  bool has_blocks(Mesh_estimate& result) {
    Mesh_by_blocks blocks(core_.model(), core_.frame(), core_.size(), core_.options());
    Hexahedral_report report;
    const std::optional<Length_of_blocks> length = blocks.length(report);
    bring_back_places(report);
    if (length) {
      result.integrals.rows_of_blocks = double(length->rows);
      result.integrals.domes_of_blocks = double(length->domes);
    } else
      result.fallbacks.push_back(why_there_are_none(report) +
                                 (core_.options().hexahedral_fallback == Hexahedral_fallback::none
                                      ? " Without a fallback there will be no mesh."
                                      : " All hexahedra are made by subdivision."));
    return bool(length);
  }

  /* Tetrahedra and prisms of a coarser mesh, coarse(), subdivided: four hexahedra of each tetrahedron are as many as
   * there are tetrahedra of 1.6 times smaller edges. */
  template <class Coarse> Mixed_mesh by_subdivision(const Coarse& coarse) {
    report_.method = Hexahedral_method::subdivision;
    core_.set_moves_wall(false); // its new vertices are to be on the surface first
    Mixed_mesh mesh = coarse();
    core_.stage("subdivision");
    mesh = subdivide_into_hexahedra(mesh);
    bring_to_surface(mesh);
    optimize(mesh);
    for (int round = 0; round < 2 && report_.boundary.held_back > 0; ++round)
      if (!bring_the_rest_to_surface(mesh))
        break;
    core_.frame().bring_back(report_.boundary);
    core_.set_moves_wall(core_.options().preserve_volume);
    core_.move_wall_of(mesh);
    return mesh;
  }

private:
  void bring_to_surface(Mixed_mesh& mesh) {
    const Labelled_surface& s = core_.frame().surface();
    Move_boundary_to_surface_options moving;
    moving.number_of_threads = core_.options().size.number_of_threads;
    report_.boundary = internal::move_boundary_to_surface(mesh, s.surface, s.patch, core_.limited_radius(), moving);
  }

  void optimize(Mixed_mesh& mesh) {
    core_.stage("optimization of hexahedra");
    Optimize_hexahedra_options optimization = core_.options().hexahedra;
    optimization.number_of_threads = core_.options().size.number_of_threads;
    report_.optimization =
        optimize_subdivided(mesh, core_.frame().surface(), optimization, core_.options().has_boundary_layer());
  }

  /* Vertices that cells and facets held back may go all of the way once these have been optimized. False, and all is as it
   * was, unless fewer are held back then, with no worse hexahedra. */
  bool bring_the_rest_to_surface(Mixed_mesh& mesh) {
    const Hexahedral_report before = report_;
    Mixed_mesh trial = mesh;
    bring_to_surface(trial);
    optimize(trial);
    const Optimize_hexahedra_report& first = before.optimization;
    if (report_.boundary.held_back >= before.boundary.held_back ||
        report_.optimization.min_scaled_jacobian < first.min_scaled_jacobian) {
      report_ = before;
      return false;
    }
    report_.boundary.largest_shift = (std::max)(report_.boundary.largest_shift, before.boundary.largest_shift);
    report_.optimization.min_scaled_jacobian_before = first.min_scaled_jacobian_before;
    report_.optimization.mean_scaled_jacobian_before = first.mean_scaled_jacobian_before;
    report_.optimization.inverted_before = first.inverted_before;
    report_.optimization.below_wanted_before = first.below_wanted_before;
    report_.optimization.sweeps += first.sweeps;
    mesh = std::move(trial);
    return true;
  }

  static std::string why_there_are_none(const Hexahedral_report& report) {
    return "There are no blocks of hexahedra along the vessels: " + why_no_blocks(report);
  }

  /* Where blocks were not valid: those with finer cells in the junctions that were filled, if any were, and `why` if
   * there are none. What the report said was of blocks that are not used. */
  std::optional<Mixed_mesh> after_invalid_ones(Mesh_by_blocks& blocks, const std::string& error, std::string& why) {
    const std::vector<Place_without_blocks> places = std::move(report_.places_without_blocks);
    report_ = Hexahedral_report();
    core_.report().boundary_layer = Layer_report();
    core_.report().volume = Preserve_volume_report();
    if (!blocks.has_filled_junctions())
      return std::nullopt;
    for (const Place_without_blocks& p : places)
      report_.places_without_blocks.push_back({p.place, p.reason});
    why = why_there_are_none(report_) + " " + why_not_filled(error);
    const Hexahedral_report without = report_;
    core_.stage("blocks");
    std::optional<Mixed_mesh> mesh = blocks.make_finer(report_);
    if (mesh)
      bring_back_places(report_);
    else
      report_ = without;
    return mesh;
  }

  // Gives blocks the surface's volume, and layers along the wall.
  void finish(const Mesh_by_blocks& blocks, Mixed_mesh& mesh) {
    core_.check(mesh);
    if (core_.moves_wall()) {
      core_.give_volume_to(mesh);
      core_.stage("optimization");
      blocks.optimize_inside(mesh);
    }
    if (!core_.options().has_boundary_layer())
      return;
    core_.stage("boundary layer");
    Layer_report& layers = core_.report().boundary_layer;
    layers = blocks.insert_layers(mesh, core_.radius(), report_);
    layers.worst_place = core_.frame().from_frame(layers.worst_place);
    blocks.optimize_layers(mesh);
    core_.check(mesh);
  }

  void bring_back_places(Hexahedral_report& report) const {
    for (Place_without_blocks& p : report.places_without_blocks)
      p.place = core_.frame().from_frame(p.place);
  }

  Mesher_core& core_;
  Hexahedral_report& report_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_HEXAHEDRAL_MESHER_H
