// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_RECOMBINE_TRIANGLES_H
#define CGAL_TUBULAR_MESHING_QUADS_RECOMBINE_TRIANGLES_H

#include <CGAL/Tubular_meshing/Quads/blossom_recombination.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/property_map.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingQuads
 *
 * What recombine_triangles() did. */
struct Recombination_report {
  std::size_t quads = 0;
  std::size_t triangles = 0;      ///< that are left, single
  std::size_t split_vertices = 0; ///< of the border
  std::size_t invalid_quads = 0;  ///< of \f$ \eta_q = 0 \f$, with an angle of π or more
};

/*! \ingroup PkgTubularMeshingQuads
 *
 * Quads and triangles, all counterclockwise, and of which patch they are. The first points are the given ones. */
struct Recombined_triangles {
  std::vector<Point_3> points;
  std::vector<std::array<std::size_t, 4>> quads;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<int> quad_patches, triangle_patches;
  Recombination_report report;
};

namespace internal {

// \param patches those of the faces, in their order
Recombination_report recombine_faces(Surface& surface, const std::vector<int>& patches);

} // namespace internal

/*! \ingroup PkgTubularMeshingQuads
 *
 * makes quads of triangles, two of each: those pairs of neighbours for which \f$ \sum (1 - \eta_q) \f$, by (14), is
 * smallest among all ways to leave as few triangles as possible. That is a matching of minimum cost in the dual graph,
 * \cgalCite{remacle2012}.
 *
 * A connected part of a patch with an even number of triangles, which is one whose border has an even number of edges,
 * becomes quads altogether, but for rare shapes. Where neighbours cannot all be paired, as with triangles in corners,
 * vertices of the border are split, as few as possible: the border keeps its vertex, the triangles inside get a new
 * one, on them, and the edge between the two makes quads of the two triangles at the border. A quad with an angle of π
 * or more is made only where eight splits would not avoid it. Of an odd number of triangles, one is left.
 *
 * The border itself stays as it is: all its edges and vertices.
 *
 * \param points points of any kernel
 * \param triangles counterclockwise, by the indices of their points
 * \param patches one number a triangle, or none at all: triangles of different patches are not joined
 *
 * O(n² log n) at worst; measured, n^1.5: 0.4 s for 100,000 triangles, 12 s for a million.
 *
 * \throws Input_error if triangles refer to points that are not there, or twice to the same one, if points are not
 *   finite, or if an edge has more than two triangles, or two that are turned differently
 * \throws Meshing_error if this program was built without LEMON, see has_lemon()
 */
Recombined_triangles recombine_triangles(const std::vector<Point_3>& points,
                                         const std::vector<std::array<std::size_t, 3>>& triangles,
                                         const std::vector<int>& patches = {});

template <class Point, class = std::enable_if_t<!std::is_same<Point, Point_3>::value>>
Recombined_triangles recombine_triangles(const std::vector<Point>& points,
                                         const std::vector<std::array<std::size_t, 3>>& triangles,
                                         const std::vector<int>& patches = {}) {
  std::vector<Point_3> core;
  for (const Point& p : points)
    core.push_back(internal::to_core(p));
  return recombine_triangles(core, triangles, patches);
}

/*! \ingroup PkgTubularMeshingQuads
 *
 * The same for a surface, in place: of each two faces, one is removed. The vertices of a Surface, and its faces of
 * which a quad is made, keep their properties; removed elements remain until `collect_garbage()`. Any other surface is
 * replaced by a copy.
 *
 * \param surface a model of `MutableFaceGraph`, of triangles
 * \param np an optional sequence of named parameters among the ones listed below, and `vertex_point_map`
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{face_patch_map}
 *     \cgalParamDescription{the patch of each face: faces of different patches are not joined. New faces of a copy get
 *       theirs}
 *     \cgalParamType{a property map from faces to `int`; readable, and writable where the surface is no Surface}
 *     \cgalParamDefault{one patch}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 */
template <class FaceGraph, class T, class Tag, class Base>
Recombination_report recombine_triangles(FaceGraph& surface, const CGAL::Named_function_parameters<T, Tag, Base>& np) {
  typedef CGAL::Named_function_parameters<T, Tag, Base> Parameters;
  typedef typename boost::graph_traits<FaceGraph>::face_descriptor Face;
  const auto patch = CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter(np, internal_np::face_patch_map), Constant_property_map<Face, int>(0));
  std::vector<int> patches;
  for (Face f : faces(surface))
    patches.push_back(int(get(patch, f)));
  if constexpr (internal::is_core_surface<FaceGraph, Parameters>)
    return internal::recombine_faces(surface, patches);
  else {
    Labelled_surface copy = internal::labelled_copy(surface, patch, np);
    const Recombination_report report = internal::recombine_faces(copy.surface, patches);
    internal::copy_from_core(copy.surface, copy.patch, surface, patch, np);
    return report;
  }
}
template <class FaceGraph> Recombination_report recombine_triangles(FaceGraph& surface) {
  return recombine_triangles(surface, CGAL::parameters::default_values());
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Quads/recombine_triangles_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_QUADS_RECOMBINE_TRIANGLES_H
