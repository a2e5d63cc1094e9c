// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_MESHER_OPTIONS_H
#define CGAL_TUBULAR_MESHING_PIPELINES_MESHER_OPTIONS_H

#include <CGAL/Tubular_meshing/Fields/Centerline_metric_field.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/Hexahedra/optimize_hexahedra.h>
#include <CGAL/Tubular_meshing/Layers/extrude_boundary_layer.h>
#include <CGAL/Tubular_meshing/Layers/extrude_wall.h>
#include <CGAL/Tubular_meshing/Patches/cut_by_centerlines.h>
#include <CGAL/Tubular_meshing/Patches/parameterize_patch.h>
#include <CGAL/Tubular_meshing/Patches/remesh_patches.h>
#include <CGAL/Tubular_meshing/Pipelines/Hexahedral_report.h>
#include <CGAL/Tubular_meshing/Quads/quadrangulate_patches.h>
#include <CGAL/Tubular_meshing/Volume/Volume_mesher.h>
#include <CGAL/Tubular_meshing/Volume/anisotropic_tetrahedral_remeshing.h>
#include <CGAL/Tubular_meshing/Volume/fill_keeping_boundary.h>
#include <CGAL/Tubular_meshing/Volume/fill_with_mesh_3.h>
#include <CGAL/Tubular_meshing/Volume/fill_with_pyramids_and_tetrahedra.h>
#include <CGAL/Tubular_meshing/Volume/optimize_tetrahedra.h>
#include <CGAL/Tubular_meshing/Volume/preserve_volume.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <algorithm>
#include <functional>
#include <optional>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPipelines
 * What meshes the surface of an isotropic mesh. */
enum class Surface_mesher {
  parametric, ///< patch by patch in the parametric plane, see remesh_patches(); then the lumen is filled
  mesh_3      ///< CGAL's Mesh_3, which meshes surface and lumen at once
};

/*! \ingroup PkgTubularMeshingPipelines
 * The elements of a surface mesh. */
enum class Surface_elements {
  triangles,             ///< isotropic, of mesh size h = 2 π r / N
  anisotropic_triangles, ///< of unit size in the metric of Centerline_metric_field
  quads,                 ///< of mesh size h; triangles on the caps, unless quads are wanted there too
  structured_quads       ///< the boundary of hexahedra in blocks, see make_hexahedral_blocks(): quads on the caps, too
};

/*! \ingroup PkgTubularMeshingPipelines
 *
 * All that a Mesher can be told: the options of its stages, and which stages these are. Named parameters set them by
 * their names, see Mesher; a program may set the members as well.
 */
struct Mesher_options {
  Centerline_sizing_field_options size;
  Centerline_metric_field_options metric;
  Cut_by_centerlines_options cut;
  Parameterize_patches_options parameterization;
  Remesh_patches_options surface;
  Quadrangulate_patches_options quads;
  Fill_with_mesh_3_options mesh_3;
  Fill_keeping_boundary_options filling;
  Fill_with_pyramids_and_tetrahedra_options pyramids;
  Optimize_tetrahedra_options optimization;
  Optimize_hexahedra_options hexahedra;
  Anisotropic_tetrahedral_remeshing_options remeshing;
  Extrude_boundary_layer_options boundary_layer;
  std::optional<Extrude_wall_options> wall; ///< of a mixed or hexahedral mesh; none: there is no wall

  Volume_mesher volume_mesher = default_volume_mesher(); ///< what fills the surface mesh
  Surface_mesher surface_mesher = Surface_mesher::parametric;
  Hexahedral_method hexahedral_method = Hexahedral_method::blocks; ///< of a hexahedral mesh
  Hexahedral_fallback hexahedral_fallback = Hexahedral_fallback::subdivision;
  double number_of_elements = 0;             ///< cells, of a surface faces, about as many as N is found for; 0: by N
  bool preserve_volume = true;               ///< whether the wall is moved so that the mesh has the surface's volume
  std::function<void(const char*)> observer; ///< receives the name of each stage as it begins

  // Of hexahedra by subdivision most are worse than that which is wanted of others, and would be moved: more sweeps, a
  // second ring, or a higher quality take long, and win a hundredth.
  static constexpr int sweeps_of_hexahedra = 4;
  static constexpr int rings_of_hexahedra = 1;
  static constexpr double quality_of_hexahedra = 0.4;

  Mesher_options() {
    hexahedra.number_of_sweeps = sweeps_of_hexahedra;
    hexahedra.number_of_rings = rings_of_hexahedra;
    hexahedra.quality_wanted = quality_of_hexahedra;
  }
  template <class NamedParameters>
  explicit Mesher_options(const NamedParameters& np)
      : size(np)
      , metric(np)
      , cut(np)
      , parameterization(np)
      , surface(np)
      , quads(np)
      , mesh_3(np)
      , filling(np)
      , pyramids(np)
      , optimization(np)
      , hexahedra(np)
      , remeshing(np)
      , boundary_layer(np) {
    using internal::choose;
    volume_mesher = choose(np, internal_np::volume_mesher, volume_mesher);
    hexahedra.number_of_sweeps = choose(np, internal_np::number_of_sweeps, sweeps_of_hexahedra);
    hexahedra.number_of_rings = choose(np, internal_np::number_of_rings, rings_of_hexahedra);
    hexahedra.quality_wanted = choose(np, internal_np::quality_wanted, quality_of_hexahedra);
    // Mesh_3 meshes the surface itself: patches before it would be work for nothing
    surface_mesher = choose(np, internal_np::surface_mesher,
                            volume_mesher == Volume_mesher::mesh_3 ? Surface_mesher::mesh_3 : surface_mesher);
    if (choose(np, internal_np::wall_thickness, Wall_thickness()).is_there())
      wall.emplace(np);
    hexahedral_method = choose(np, internal_np::hexahedral_method, hexahedral_method);
    hexahedral_fallback = choose(np, internal_np::hexahedral_fallback, hexahedral_fallback);
    number_of_elements = choose(np, internal_np::number_of_elements, number_of_elements);
    preserve_volume = choose(np, internal_np::preserve_volume, preserve_volume);
    observer = choose(np, internal_np::observer, observer);
  }

  /// Sets N; the points on circles of curvature go with those that were `given`, whatever N was in between.
  void set_points(double points, const Mesher_options& given) {
    const double before = given.size.points_per_circumference, factor = before > 0 ? points / before : 1, least = 3;
    const auto scaled = [&](double n) { return points < least ? points : (std::max)(factor * n, least); };
    metric.curvature_points = scaled(given.metric.curvature_points);
    metric.points_per_circumference = scaled(given.metric.points_per_circumference);
    size.points_per_circumference = points;
  }

  /// Whether layers of prisms or hexahedra are wanted inside the lumen.
  bool has_boundary_layer() const { return boundary_layer.boundary_layer_prisms.value_or(0) != 0; }
};

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PIPELINES_MESHER_OPTIONS_H
