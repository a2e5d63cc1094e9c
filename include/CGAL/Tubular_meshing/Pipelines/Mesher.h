// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_MESHER_H
#define CGAL_TUBULAR_MESHING_PIPELINES_MESHER_H

#include <CGAL/Tubular_meshing/Hexahedra/Block_structure.h>
#include <CGAL/Tubular_meshing/Layers/Layer_report.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/Hexahedral_report.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesh_estimate.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesher_options.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Quality/Mesh_check.h>
#include <CGAL/Tubular_meshing/Volume/preserve_volume.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPipelines
 * What a Mesher reports beside its meshes. */
struct Mesher_report {
  std::vector<std::string> fallbacks; ///< a sentence each time another way was taken than the one chosen, and why
  Layer_report boundary_layer;        ///< where layers inside the lumen had to be thinner
  Layer_report wall;                  ///< likewise those of the wall of a mixed or hexahedral mesh
  Hexahedral_report hexahedral;       ///< how a hexahedral mesh was made
  Preserve_volume_report volume;      ///< how the mesh got the volume of the surface; all zero if it did not
  Mesh_check check;                   ///< of a volume mesh: spares mesh_report() most of its work
};

/*! \ingroup PkgTubularMeshingPipelines
 *
 * Makes meshes of a vessel or airway tree. It holds what they have in common (the model in a frame of its own, the mesh
 * size, the cut surface and the maps of its patches), each made once, when it is first needed; so that a second mesh of
 * another kind, or of the same kind with layers, costs less than a first one.
 *
 * Meshes are made in the model's own frame: around the origin, along its principal axes, of unit extent. The same model
 * in other units, or turned, gives the same mesh but for rounding.
 *
 * Every mesh is checked before it is returned: it is valid (see Validity_report), has the topology of the model's
 * surface, and facets on every opening.
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{points_per_circumference}
 *     \cgalParamDescription{N: the mesh size is h = 2 π r / N, see Centerline_sizing_field}
 *     \cgalParamType{double}
 *     \cgalParamDefault{20}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_elements}
 *     \cgalParamDescription{of a mesh, its cells, or of a surface its faces: N is found so that there are as many, but
 *       for a tenth, see Element_target; 0: N is `points_per_circumference`}
 *     \cgalParamType{double}
 *     \cgalParamDefault{0}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{size_requests}
 *     \cgalParamDescription{where the mesh is to be finer or coarser, and sizes given on the surface}
 *     \cgalParamType{Size_requests}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{surface_mesher}
 *     \cgalParamDescription{how isotropic meshes are made}
 *     \cgalParamType{`Surface_mesher`}
 *     \cgalParamDefault{`Surface_mesher::parametric`; `Surface_mesher::mesh_3` if the volume mesher is Mesh_3}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{volume_mesher}
 *     \cgalParamDescription{what fills a surface mesh}
 *     \cgalParamType{`Volume_mesher`}
 *     \cgalParamDefault{`default_volume_mesher()`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{boundary_layer_prisms}
 *     \cgalParamDescription{number of layers of prisms (on quads, of hexahedra) along the wall inside the lumen, of
 *       isotropic, mixed and hexahedral meshes; see extrude_boundary_layer(). They need TetGen or CGAL 6.1}
 *     \cgalParamType{int}
 *     \cgalParamDefault{0}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{wall_thickness}
 *     \cgalParamDescription{of the wall of a mixed or hexahedral mesh, in local radii, or lengths in the unit of the
 *       model; 0: there is none}
 *     \cgalParamType{double, or Wall_thickness}
 *     \cgalParamDefault{0}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{wall_materials}
 *     \cgalParamDescription{areas of the model's surface over which this wall is a region of its own, see
 *       extrude_wall(); by points in the frame of the model}
 *     \cgalParamType{Wall_materials}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{hexahedral_method}
 *     \cgalParamDescription{how a hexahedral mesh is made}
 *     \cgalParamType{`Hexahedral_method`}
 *     \cgalParamDefault{`Hexahedral_method::blocks`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{hexahedral_fallback}
 *     \cgalParamDescription{what is done where there are no blocks to be had: subdivision of the whole mesh, pyramids and
 *       tetrahedra in those junctions alone, or nothing}
 *     \cgalParamType{`Hexahedral_fallback`}
 *     \cgalParamDefault{`Hexahedral_fallback::subdivision`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{preserve_volume}
 *     \cgalParamDescription{whether the wall's vertices move so that the mesh has the volume of the surface, branch by
 *       branch, and its openings have their areas, see preserve_volume(); else
 *       they are on the surface, and the mesh is smaller}
 *     \cgalParamType{bool}
 *     \cgalParamDefault{`true`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads}
 *     \cgalParamDescription{0: all cores. Results do not depend on it}
 *     \cgalParamType{int}
 *     \cgalParamDefault{0}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{observer}
 *     \cgalParamDescription{a function object that is called with the name of each stage, as it begins}
 *     \cgalParamType{callable with a `const char*`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * and all named parameters of its stages: Centerline_sizing_field, Centerline_metric_field, cut_by_centerlines(),
 * remesh_patches(), quadrangulate_patches(), fill_keeping_boundary(), fill_with_mesh_3(), optimize_tetrahedra(), optimize_hexahedra(),
 * anisotropic_tetrahedral_remeshing(), extrude_boundary_layer(), extrude_wall(). From a surface, also those of
 * make_tubular_model().
 *
 * About O(n log n) in the sizes of the surface and of the result, but for the linear systems of the parameterization,
 * which take O(n^1.5) in those of patches.
 *
 * \throws Parameter_error if a parameter is out of its range, a branch to refine is not there, or a ball to refine in
 *   lies outside of the lumen
 * \throws Meshing_error if no valid mesh comes out, or the mesh would not fit into memory. Its places are in the frame
 *   of the model that was given; its stage() is the one that failed
 */
class Mesher {
public:
  /// Of a model that outlives the mesher.
  Mesher(const Tubular_model& model, const Mesher_options& options);
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Mesher(const Tubular_model& model, const NamedParameters& np = CGAL::parameters::default_values())
      : Mesher(model, Mesher_options(np)) {}

  /// Of a model that it keeps.
  Mesher(Tubular_model&& model, const Mesher_options& options);
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Mesher(Tubular_model&& model, const NamedParameters& np = CGAL::parameters::default_values())
      : Mesher(std::move(model), Mesher_options(np)) {}

  /// Of a surface and its centerlines.
  template <class FaceGraph, class NamedParameters = CGAL::parameters::Default_named_parameters>
  Mesher(const FaceGraph& surface, const Centerline_polylines& lines,
         const NamedParameters& np = CGAL::parameters::default_values())
      : Mesher(make_tubular_model(surface, lines, np), Mesher_options(np)) {}

  /// Of a surface alone: its centerlines are computed.
  template <class FaceGraph, class NamedParameters = CGAL::parameters::Default_named_parameters,
            class = std::enable_if_t<!std::is_same<FaceGraph, Tubular_model>::value>>
  explicit Mesher(const FaceGraph& surface, const NamedParameters& np = CGAL::parameters::default_values())
      : Mesher(make_tubular_model(surface, np), Mesher_options(np)) {}

  Mesher(Mesher&&);
  Mesher& operator=(Mesher&&);
  ~Mesher();

  const Tubular_model& model() const;

  /*! Changes N, for the meshes to come. The number of points on circles of curvature, of a metric, changes in
   * proportion.
   * \throws Parameter_error from the next mesh on, if it is less than 3 */
  void set_points_per_circumference(double points);
  double points_per_circumference() const;

  /// About how many tetrahedra an isotropic mesh has.
  double estimated_number_of_tetrahedra();

  /*! About how many cells a mesh of a type will have, with all that was asked for, and what it takes to make it. A wall
   * is added by Mesh_estimate::add_wall(), as it is to a mesh of triangles by extrude_wall(). It takes about as long as
   * the mesh size, which later meshes have then, and a metric if the mesh is to be anisotropic.
   * \param type of the mesh
   * \param elements of a surface mesh */
  Mesh_estimate estimate(Mesh_type type, Surface_elements elements = Surface_elements::triangles);

  /*! Isotropic tetrahedra of mesh size h (section 3.1 of the paper): region labels::lumen; patches wall, inlet,
   * outlet_1, …. The surface is meshed by patches and filled, its triangles kept; where a patch cannot be mapped or
   * meshed, or the lumen cannot be filled, Mesh_3 makes the mesh instead, and the report says so. */
  Mixed_mesh isotropic();

  /*! Anisotropic tetrahedra (section 3.3): thin layers along the wall, of sizes along it that follow its curvature and
   * the centerlines, isotropic in the core. The point array `metric` is the metric that was asked for. */
  Mixed_mesh anisotropic();

  /*! Mixed cells (sections 2.5 and 3.2): quads on the wall, pyramids on them, tetrahedra between, and hexahedra in the
   * vessel's wall, if one is wanted. Where no pyramid fits on a quad it is split, see
   * fill_with_pyramids_and_tetrahedra(); with layers inside that cannot be done.
   *
   * \throws Meshing_error also if this program was built without LEMON, or with neither TetGen nor CGAL 6.1 */
  Mixed_mesh mixed();

  /*! Hexahedra alone, but for junctions that Hexahedral_fallback::mixed has filled. By `hexahedral_method` these are
   * blocks along the vessels, or tetrahedra and prisms of a coarser mesh, subdivided. In the second way they come to any
   * shape that isotropic() meshes: the coarser mesh has 1.6 times the mesh size, so that there are about as many
   * hexahedra as there are tetrahedra in an isotropic mesh of the same N; each boundary layer of prisms is one of
   * hexahedra, and so is each of the vessel's wall, if one is wanted. New vertices are brought to the surface, and the
   * hexahedra are improved, see optimize_hexahedra(); then, unless `preserve_volume` is false, the wall is moved so that
   * the mesh has the surface's volume.
   *
   * Where blocks are asked for and cannot be had, `hexahedral_fallback` says what is done, and
   * Mesher_report::hexahedral what was, and why. kept_surface() is empty after a mesh by subdivision.
   *
   * \throws Meshing_error also if there are no blocks, and the fallback makes no mesh either */
  Mixed_mesh hexahedral();

  /*! The surface alone (sections 2.4, 2.5): closed, conforming, free of self-intersections, its vertices on the model's
   * surface, or, unless `preserve_volume` is false, next to it, so that it encloses the same volume. */
  Remeshed_surface surface(Surface_elements elements = Surface_elements::triangles);

  /*! Takes over the structure of the blocks that the last mesh is in, see make_block_mesh(); empty if it is in none. Its
   * branches are those that the blocks run along: where vessels had no centerline, such as sacs, there are more of them
   * than in the model. */
  Block_structure block_structure();

  /*! The local radius at p, see Local_radius, which sizes, layers and walls are relative to: for a wall around the mesh,
   * see extrude_wall(), without measuring the vessels again. The first call measures them, unless a mesh was made
   * before; the next may come from several threads. */
  double local_radius(const Point_3& p);

  /// Takes over the surface mesh that the last volume mesh was made from and kept; empty if there is none.
  Remeshed_surface kept_surface();

  /// Of the last mesh.
  const Mesher_report& report() const;

private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Pipelines/Mesher_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_PIPELINES_MESHER_H
