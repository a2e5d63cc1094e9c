// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_SUBDIVIDE_INTO_HEXAHEDRA_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_SUBDIVIDE_INTO_HEXAHEDRA_H

#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingHexahedra
 *
 * subdivides the cells of a mesh so that all are hexahedra, and conform.
 *
 * Every tetrahedron becomes four hexahedra, one at each of its vertices, with corners at the middles of its edges, of
 * its faces, and its own. Every prism becomes three, one along each of its lateral edges, which stay whole: layers of
 * prisms keep their number and their heights. Triangles become three quads around their centroid; quads of prisms' sides
 * become two.
 *
 * What is divided is decided edge by edge. The edges of triangles are, on both sides of every one; so are those that
 * share a quad with a divided one, across from it, and so on. Hence any mix of tetrahedra, prisms and hexahedra can be
 * subdivided: a hexahedron stays as it is, or becomes two, four or eight, and a prism whose lateral edges must be
 * divided becomes six. A mesh of hexahedra alone stays what it is.
 *
 * An affine tetrahedron gives four valid hexahedra, which have Jacobians above 0 wherever its own is. Where an edge
 * meets another at a small angle in the mesh, so it does in the hexahedra: these are no better than the cells they come
 * from, and optimize_hexahedra() is made to run after this.
 *
 * New points are the means of the corners around them: those of the boundary lie on its facets, not on a curved surface
 * that it stands for; move_boundary_to_surface() brings them there.
 *
 * Regions, patches, their names and ids stay. The mesh's first points are those that were given, in their order and bit
 * for bit; then come the middles of edges, of faces, and of cells. The three quads of a triangle, and all cells of a
 * cell, follow each other in the order of the given ones. Point arrays continue with the means of their values.
 *
 * About linear in the number of cells, if no vertex has many more edges than others.
 *
 * \param mesh tetrahedra, prisms and hexahedra, conforming, with their labelled facets; or facets alone
 *
 * \throws Input_error if the mesh has pyramids, of which no hexahedra can be made; if an element names a point that is
 *   not there
 */
Mixed_mesh subdivide_into_hexahedra(const Mixed_mesh& mesh);

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Hexahedra/subdivide_into_hexahedra_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_SUBDIVIDE_INTO_HEXAHEDRA_H
