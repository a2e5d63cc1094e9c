// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_KERNEL_H
#define CGAL_TUBULAR_MESHING_BASE_KERNEL_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingBase
 *
 * The kernel in which the package computes: coordinates are doubles. Surfaces of any other kernel are converted where
 * they come in, and back where they go out.
 */
typedef Exact_predicates_inexact_constructions_kernel Kernel;

typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;

/*! \ingroup PkgTubularMeshingBase
 *
 * The surface that the package's stages pass on. Functions that read a surface take any model of `FaceListGraph` too.
 */
typedef CGAL::Surface_mesh<Point_3> Surface;

/// The label of each face of a Surface: its property map `f:patch`.
typedef Surface::Property_map<Surface::Face_index, int> Face_patch_map;

namespace internal {

typedef std::size_t size_type;
typedef Surface::Vertex_index Vertex;
typedef Surface::Halfedge_index Halfedge;
typedef Surface::Edge_index Edge;
typedef Surface::Face_index Face;

} // namespace internal
} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_BASE_KERNEL_H
