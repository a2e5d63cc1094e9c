// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_FILL_KEEPING_BOUNDARY_H
#define CGAL_TUBULAR_MESHING_VOLUME_FILL_KEEPING_BOUNDARY_H

#include <CGAL/Tubular_meshing/Volume/Volume_mesher.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingVolume
 * The named parameters of fill_keeping_boundary(), as a struct. */
struct Fill_keeping_boundary_options {
  Volume_mesher volume_mesher = default_volume_mesher();
  bool in_child_process = false;
  double time_limit = 0; ///< 0 stands for the default
  int optimization_passes = 0;
  int number_of_threads = 0;

  Fill_keeping_boundary_options() = default;
  template <class NamedParameters> explicit Fill_keeping_boundary_options(const NamedParameters& np) {
    volume_mesher = internal::choose(np, internal_np::volume_mesher, volume_mesher);
    in_child_process = internal::choose(np, internal_np::in_child_process, in_child_process);
    time_limit = internal::choose(np, internal_np::time_limit, time_limit);
    optimization_passes = internal::choose(np, internal_np::optimization_passes, optimization_passes);
    number_of_threads = internal::choose(np, internal_np::number_of_threads, number_of_threads);
  }
};

namespace internal {

// before_optimization() is called when the surface is full.
void fill_keeping_boundary(
    const Surface& surface, Face_patch_map patch, Length_function size, Mixed_mesh& mesh,
    const Fill_keeping_boundary_options& options, Function_view<void()> before_optimization = [] {});

} // namespace internal

/*! \ingroup PkgTubularMeshingVolume
 *
 * fills a closed labelled surface with tetrahedra and keeps it as it is, facet for facet. The Delaunay triangulation of
 * the surface's points has nearly all of its triangles for facets as a rule. Those that are missing are recovered by
 * TetGen (\cgalCite{si2015}), or the whole surface is, by TetGen or by \cgal's own
 * `Conforming_constrained_Delaunay_triangulation_3`; where the latter needs points on the surface they are brought
 * inside again. Delaunay refinement adds points inside, as many as
 * the field asks for. What makes the mesh good is optimize_tetrahedra() with `keep_boundary(true)`, or
 * `optimization_passes` here, which does the same and is quicker, as neighbors are known.
 *
 * The surface is handed over in a frame of unit extent: units and distance from the origin make no difference. The
 * surface's points are connected by one thread, points inside are added by several: the result is the same for any
 * number. About linear in the number of tetrahedra.
 *
 * The mesher is foreign code, which can crash, or run for very long, and take this program with it. It is not run on a
 * surface that crosses itself, on which it may; a program that must go on all the same runs it in a child process:
 * whatever happens there becomes an exception.
 *
 * \tparam FaceGraph a model of `FaceListGraph`
 * \tparam FacePatchMap a readable property map from its faces to `int`
 *
 * \param surface a closed triangle mesh without self-intersections, its faces turned outward
 * \param patch the labels of its faces
 * \param size a model of `MeshDomainField_3`, or a function object of a point: the wanted length of edges. Inside,
 *   edges are 1.05 times as long on average. Must outlive the call only.
 * \param mesh is replaced: tetrahedra of region labels::lumen, and the surface's triangles. Its first points are the
 *   surface's, its triangles the surface's faces, both in their order, and bit for bit where the surface has doubles.
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{volume_mesher}
 *     \cgalParamDescription{what connects the surface's points: `Volume_mesher::tetgen` or `Volume_mesher::ccdt`}
 *     \cgalParamType{`Volume_mesher`}
 *     \cgalParamDefault{default_volume_mesher()}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{in_child_process}
 *     \cgalParamDescription{whether the mesher runs in a process of its own (POSIX `fork`), with a limit on its time,
 *       and prints nothing. Otherwise it runs in this process: calls from several threads follow each other}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{time_limit}
 *     \cgalParamDescription{seconds of processor time after which the mesher is stopped, in a child process}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{ten minutes, and a hundredth of a second for each triangle: a hundred times what it should
 *       take}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{optimization_passes}
 *     \cgalParamDescription{rounds of optimize_tetrahedra() inside; two are enough}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{`0`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads}
 *     \cgalParamDescription{of those that add points inside; 0: all cores. `size` must be safe to call from several
 *       threads at once, unless it is 1}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{`0`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the surface's vertices}
 *     \cgalParamType{a model of `ReadablePropertyMap`}
 *     \cgalParamDefault{`get(CGAL::vertex_point, surface)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Input_error if the surface has quads
 * \throws Meshing_error if the surface is not closed, if the mesher fails or cannot keep the surface, or if it is not
 *   there (see has_tetgen(), has_ccdt()): use fill_with_mesh_3() instead. `mesh` is then as it was.
 */
template <class FaceGraph, class FacePatchMap, class SizingField,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void fill_keeping_boundary(const FaceGraph& surface, FacePatchMap patch, const SizingField& size, Mixed_mesh& mesh,
                           const NamedParameters& np = CGAL::parameters::default_values()) {
  const internal::Core_labelled_surface<FaceGraph, FacePatchMap, NamedParameters> core(surface, patch, np);
  internal::fill_keeping_boundary(core.surface(), core.patch(), internal::Field_at_point<SizingField>(size), mesh,
                                  Fill_keeping_boundary_options(np));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Volume/fill_keeping_boundary_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_VOLUME_FILL_KEEPING_BOUNDARY_H
