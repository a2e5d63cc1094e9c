// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_MAKE_MESH_H
#define CGAL_TUBULAR_MESHING_PIPELINES_MAKE_MESH_H

#include <CGAL/Tubular_meshing/Pipelines/Mesher.h>

#include <utility>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingPipelines
 *
 * The pipelines in one call each. All of these functions take
 *  - a `Tubular_model`, see make_tubular_model();
 *  - or a surface, a model of `FaceListGraph` over any kernel, and its centerlines, a `Centerline_polylines`;
 *  - or a surface alone, whose centerlines are computed;
 *
 * and the named parameters of Mesher; from a surface, those of make_tubular_model() as well, and `vertex_point_map`.
 * Who needs several meshes of one model, the surface mesh that a mesh keeps, or the reports, makes a Mesher instead.
 *
 * \throws Input_error as make_tubular_model() does
 * \throws Parameter_error, Meshing_error as Mesher does
 */
///@{

/// Mesher::isotropic(): tetrahedra of mesh size h = 2 π r / N.
template <class... Arguments> Mixed_mesh make_isotropic_mesh(Arguments&&... model_or_surface) {
  return Mesher(std::forward<Arguments>(model_or_surface)...).isotropic();
}

/// Mesher::anisotropic(): tetrahedra in layers along the wall.
template <class... Arguments> Mixed_mesh make_anisotropic_mesh(Arguments&&... model_or_surface) {
  return Mesher(std::forward<Arguments>(model_or_surface)...).anisotropic();
}

/// Mesher::mixed(): quads on the wall, pyramids, tetrahedra, and hexahedra in layers.
template <class... Arguments> Mixed_mesh make_mixed_mesh(Arguments&&... model_or_surface) {
  return Mesher(std::forward<Arguments>(model_or_surface)...).mixed();
}

/// Mesher::hexahedral(): hexahedra alone.
template <class... Arguments> Mixed_mesh make_hexahedral_mesh(Arguments&&... model_or_surface) {
  return Mesher(std::forward<Arguments>(model_or_surface)...).hexahedral();
}

/// Mesher::surface(): isotropic triangles.
template <class... Arguments> Remeshed_surface make_isotropic_surface_mesh(Arguments&&... model_or_surface) {
  return Mesher(std::forward<Arguments>(model_or_surface)...).surface(Surface_elements::triangles);
}

/// Mesher::surface(): triangles that are stretched along the vessel and round it, as its curvatures allow.
template <class... Arguments> Remeshed_surface make_anisotropic_surface_mesh(Arguments&&... model_or_surface) {
  return Mesher(std::forward<Arguments>(model_or_surface)...).surface(Surface_elements::anisotropic_triangles);
}

/// Mesher::surface(): quads.
template <class... Arguments> Remeshed_surface make_quad_surface_mesh(Arguments&&... model_or_surface) {
  return Mesher(std::forward<Arguments>(model_or_surface)...).surface(Surface_elements::quads);
}

///@}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PIPELINES_MAKE_MESH_H
