// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_MESHER_CORE_H
#define CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_MESHER_CORE_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/Fields/Local_radius.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesher.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Model_in_its_frame.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/check_mesh_of_model.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/check_requests.h>
#include <CGAL/Tubular_meshing/Volume/preserve_volume.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace CGAL::Tubular_meshing::internal {

/* What all ways to a mesh have in common: the model in its frame, the radius and the mesh size, each made once, when it
 * is first needed; the stage it is at; and how a mesh gets the volume of the surface. */
class Mesher_core {
public:
  Mesher_core(std::shared_ptr<const Tubular_model> model, const Mesher_options& options)
      : model_(std::move(model))
      , options_(options)
      , given_(options)
      , frame_(*model_) {
    frame_.scale_lengths(options_.size);
    frame_.scale_lengths(options_.metric);
    check_requests(options_.size.size_requests, *model_);
    options_.size.size_requests = frame_.in_frame(std::move(options_.size.size_requests));
  }

  const Tubular_model& model() const { return *model_; }
  const Mesher_options& options() const { return options_; }
  const Model_in_its_frame& frame() const { return frame_; }
  Mesher_report& report() { return report_; }
  const Mesher_report& report() const { return report_; }

  double points() const { return options_.size.points_per_circumference; }
  void set_points(double points) {
    options_.set_points(points, given_);
    size_.reset();
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

  // The local radius, as far as the mesh size goes with it.
  auto limited_radius() {
    return [&field = size(), points = points()](const Point_3& p) { return field(p) * points / (2 * CGAL_PI); };
  }

  // Whether meshes are given the volume of the surface, from here on.
  void set_moves_wall(bool moves) { moves_wall_ = moves; }
  bool moves_wall() const { return moves_wall_; }

  // The volume of the surface, to a surface mesh that is kept from here on.
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
    check(mesh);
  }

  // That the mesh is one of the model.
  void check(const Mixed_mesh& mesh) {
    stage("check");
    report_.check = Mesh_check(mesh, options_.size.number_of_threads);
    check_differences(mesh, *model_, frame_.surface().surface, report_.check);
  }
  void check_fits_into_memory() { check_memory(size().estimated_number_of_tetrahedra()); }

protected:
  std::shared_ptr<const Tubular_model> model_;
  Mesher_options options_;
  Mesher_options given_;
  Model_in_its_frame frame_;
  std::optional<Local_radius> radius_;
  std::optional<Centerline_sizing_field> size_;
  Mesher_report report_;
  std::string stage_;
  bool moves_wall_ = true;

private:
  template <class Report> void note_volume(Report report) {
    frame_.bring_back(report);
    report_.volume = std::move(report);
  }
  Preserve_volume_options volume_options() const {
    Preserve_volume_options result;
    result.number_of_threads = options_.size.number_of_threads;
    return result;
  }
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_MESHER_CORE_H
