// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_MESHER_IMPL_H
#define CGAL_TUBULAR_MESHING_PIPELINES_MESHER_IMPL_H

#include <CGAL/Tubular_meshing/Fields/Centerline_metric_field.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/Fields/Local_radius.h>
#include <CGAL/Tubular_meshing/Fields/Refined_metric_field.h>
#include <CGAL/Tubular_meshing/Layers/append_mesh.h>
#include <CGAL/Tubular_meshing/Layers/unfold_wall.h>
#include <CGAL/Tubular_meshing/Pipelines/Element_target.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesher.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Element_counts.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Hexahedral_mesher.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Lumen_integrator.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Mesher_core.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/check_mesh_of_model.h>
#include <CGAL/Tubular_meshing/base/Task_beside.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <future>
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

class Mesher::Impl : public internal::Mesher_core {
public:
  using Mesher_core::Mesher_core;

  Remeshed_surface take_kept_surface() { return std::exchange(kept_, Remeshed_surface()); }
  Block_structure take_block_structure() { return std::exchange(structure_, Block_structure()); }

  double local_radius(const Point_3& p) { return frame_.length_from_frame(radius()(frame_.to_frame(p))); }

  double estimated_number_of_tetrahedra() { return size().estimated_number_of_tetrahedra(); }

  Mesh_estimate estimate(Mesh_type type, Surface_elements elements) {
    const internal::Layers_in_lumen layers(options_);
    const Centerline_sizing_field& h = size();
    const Local_radius& r = radius();
    stage("estimate");
    internal::Lumen_integrator integrator(frame_.surface(), h, r, layers.thickness, options_.size.number_of_threads);
    if (internal::has_metric(type, elements)) {
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
    if (internal::is_in_blocks(type, elements, options_) && !hexahedra_.has_blocks(result))
      result.method = Hexahedral_method::subdivision;
    if (type == Mesh_type::hexahedral && options_.hexahedral_method == Hexahedral_method::subdivision)
      result.method = Hexahedral_method::subdivision;
    const double openings = double(model_->openings.size());
    if (type == Mesh_type::surface)
      internal::count_facets(result, elements, points(), openings);
    else
      internal::count_cells(result, type, layers.number, points(), internal::coarsening_for_subdivision(points()),
                            openings);
    internal::estimate_cost(result, type, double(model_->surface.number_of_faces()));
    return result;
  }

  /* Makes a mesh; again with other N, until it has the number of elements that is wanted, which goes with a power of
   * N. */
  template <class Make, class Count>
  auto fitted(Mesh_type type, Surface_elements elements, double power, const Make& make, const Count& count) {
    if (options_.number_of_elements == 0)
      return make();
    const auto expected = [&](double n) {
      set_points(n);
      const Mesh_estimate e = estimate(type, elements);
      return type == Mesh_type::surface ? e.facets() : e.cells();
    };
    const double wanted = options_.number_of_elements;
    Element_target target(wanted, Element_target::first_points(wanted, points(), power, expected), power);
    for (;;) {
      set_points(target.points());
      auto mesh = make();
      if (target.add(count(mesh)))
        return mesh;
    }
  }
  template <class Make> Mixed_mesh fitted(Mesh_type type, const Make& make) {
    const double power = type == Mesh_type::anisotropic ? Element_target::power_of_layers : 3;
    return fitted(type, Surface_elements::triangles, power, make, internal::number_of_cells);
  }

  /* Runs what makes a mesh in the frame, and brings the mesh back from there, or the places of what is thrown. */
  template <class Make> auto made(const Make& make) {
    report_ = Mesher_report();
    kept_ = Remeshed_surface();
    structure_ = Block_structure();
    moves_wall_ = options_.preserve_volume;
    coarsening_ = coarsening_inside_ = 1;
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
      Mixed_mesh mesh = to_be_remeshed();
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
      check(mesh);
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
      size_and_cut();
      check_fits_into_memory();
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
      check(mesh);
      return mesh;
    });
  }

  Mixed_mesh hexahedral() {
    return made([&] {
      check_fits_into_memory();
      std::optional<Mixed_mesh> mesh;
      if (options_.hexahedral_method == Hexahedral_method::blocks)
        mesh = hexahedra_.by_blocks(options_.hexahedral_fallback, structure_);
      if (!mesh)
        mesh = hexahedra_.by_subdivision([&] {
          coarsening_ = internal::coarsening_for_subdivision(points());
          Mixed_mesh coarse = isotropic_in_frame(options_.surface_mesher);
          kept_ = Remeshed_surface(); // its triangles are subdivided
          return coarse;
        });
      name_patches(*mesh);
      add_wall(*mesh);
      check(*mesh);
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

  /* The mesh size, or that of cells which are to be subdivided or remeshed: larger. */
  struct Scaled_size {
    const Centerline_sizing_field* size;
    double factor;
    double operator()(const Point_3& p) const { return factor * (*size)(p); }
  };
  Scaled_size scaled_size() {
    const Centerline_sizing_field& field = size();
    return {&field, coarsening_};
  }

  // A metric with what is wanted beside it.
  Refined_metric_field refined(const Centerline_metric_field& metric) {
    Centerline_sizing_field_options without = options_.size;
    without.size_requests = Size_requests();
    return Refined_metric_field(metric, Centerline_sizing_field(radius(), without), size());
  }

  // Without maps yet.
  Patches cut() const {
    Patches p{frame_.copy_of_surface(), {}, {}};
    p.cut = internal::cut_by_centerlines(p.surface.surface, frame_.centerlines(), p.surface.patch, options_.cut);
    return p;
  }

  /* The mesh size, and the cut beside it, which is the work of one thread: patches() takes it, or what it has thrown. */
  void size_and_cut() {
    if (size_ || by_patches_ || cut_.valid())
      return;
    std::packaged_task<Patches()> cutting([this] { return cut(); });
    cut_ = cutting.get_future();
    internal::run_on(options_.size.number_of_threads, [&] {
      internal::Task_beside beside;
      beside.run([&] { cutting(); });
      size();
      beside.wait();
    });
  }

  const Patches& patches() {
    if (!by_patches_) {
      stage("cut");
      Patches p = cut_.valid() ? cut_.get() : cut();
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
    if (elements != Surface_elements::anisotropic_triangles) {
      size_and_cut();
      internal::check_memory(internal::estimated_number_of_triangles(frame_.surface().surface, size()), "triangles");
    }
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
    check_fits_into_memory();
    Block_structure structure; // of points that are not those of the surface
    const Mixed_mesh mesh = *hexahedra_.by_blocks(Hexahedral_fallback::none, structure);
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
    if (mesher != Surface_mesher::mesh_3)
      size_and_cut();
    check_fits_into_memory();
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

  /* What remeshing starts from: tetrahedra about as coarse as the remesher has them itself before it refines its mesh, so
   * that there are few to collapse; triangles less so, as larger ones would cross a surface's creases. At full size where
   * that is too coarse for the surface. */
  Mixed_mesh to_be_remeshed() {
    if (!options_.remeshing.keep_boundary) {
      coarsening_ = internal::coarsening_for_remeshing(points());
      coarsening_inside_ = internal::coarsening_inside_for_remeshing;
    }
    if (coarsening_ > 1) {
      size_and_cut();
      check_fits_into_memory();
      try {
        return by_patches();
      } catch (const Meshing_error&) {
      } catch (const Parameter_error&) { // if it is not for the coarse size, it is thrown again
      }
      coarsening_ = 1;
    }
    return isotropic_in_frame(Surface_mesher::parametric);
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
      const auto optimization = [this] { stage("optimization"); };
      if (keeps) {
        Fill_keeping_boundary_options filling_options = options_.filling;
        filling_options.optimization_passes = options_.optimization.optimization_passes;
        const Scaled_size inside{size.size, (std::max)(size.factor, coarsening_inside_)};
        internal::fill_keeping_boundary(closed, patch, inside, filling, filling_options, optimization);
        return;
      }
      internal::fill_with_mesh_3(closed, patch, size, filling, options_.mesh_3);
      optimization();
      internal::optimize_tetrahedra(filling, wall.surface, wall.patch, options_.optimization);
    });
    check(mesh);
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
      report_.check = Mesh_check(mesh, options_.size.number_of_threads);
      differences = internal::differences(mesh, *model_, frame_.surface().surface, report_.check);
      if (differences.empty()) {
        give_volume_to(mesh);
        return mesh;
      }
    }
    throw Meshing_error("The mesh came out with " + differences +
                        ": the surface may intersect itself, or have parts much narrower than the mesh size there.");
  }

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

  void check_layers_can_be_kept(Volume_mesher mesher) const {
    if (options_.has_boundary_layer() && mesher == Volume_mesher::mesh_3)
      throw Meshing_error(
          "Layers inside the lumen need a mesher that keeps their sides: build this program where CMake "
          "finds TetGen (libtet1.5-dev), or CGAL 6.1 or later, and choose one of these.");
  }
  void name_patches(Mixed_mesh& mesh) const {
    mesh.patch_names = patch_names(*model_);
    mesh.patch_ids = model_->patch_ids;
  }

  internal::Hexahedral_mesher hexahedra_{*this};
  std::future<Patches> cut_; // until it is taken from there
  std::optional<Patches> by_patches_;
  Remeshed_surface kept_;
  Block_structure structure_;
  double coarsening_ = 1;        // of the mesh size, for cells that are to be subdivided or remeshed
  double coarsening_inside_ = 1; // the same of tetrahedra between triangles, if it is larger
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
  return impl_->fitted(Mesh_type::isotropic, [&] { return impl_->isotropic(); });
}
CGAL_TUBULAR_MESHING_INLINE Mixed_mesh Mesher::anisotropic() {
  return impl_->fitted(Mesh_type::anisotropic, [&] { return impl_->anisotropic(); });
}
CGAL_TUBULAR_MESHING_INLINE Mixed_mesh Mesher::mixed() {
  return impl_->fitted(Mesh_type::mixed, [&] { return impl_->mixed(); });
}
CGAL_TUBULAR_MESHING_INLINE Mixed_mesh Mesher::hexahedral() {
  return impl_->fitted(Mesh_type::hexahedral, [&] { return impl_->hexahedral(); });
}
CGAL_TUBULAR_MESHING_INLINE Remeshed_surface Mesher::surface(Surface_elements elements) {
  return impl_->fitted(
      Mesh_type::surface, elements, 2, [&] { return impl_->surface(elements); },
      [](const Remeshed_surface& s) { return std::size_t(s.surface.number_of_faces()); });
}
CGAL_TUBULAR_MESHING_INLINE Block_structure Mesher::block_structure() {
  return impl_->take_block_structure();
}

CGAL_TUBULAR_MESHING_INLINE double Mesher::local_radius(const Point_3& p) {
  return impl_->local_radius(p);
}
CGAL_TUBULAR_MESHING_INLINE Remeshed_surface Mesher::kept_surface() {
  return impl_->take_kept_surface();
}
CGAL_TUBULAR_MESHING_INLINE const Mesher_report& Mesher::report() const {
  return impl_->report();
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PIPELINES_MESHER_IMPL_H
