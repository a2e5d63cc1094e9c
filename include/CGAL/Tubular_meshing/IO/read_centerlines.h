// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_READ_CENTERLINES_H
#define CGAL_TUBULAR_MESHING_IO_READ_CENTERLINES_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <string>

namespace CGAL::Tubular_meshing::IO {

/*! \ingroup PkgTubularMeshingIO
 *
 * reads centerlines: the lines of a file, as they stand there.
 *
 * The extension of the file names its format: legacy VTK (POLYDATA with LINES, UNSTRUCTURED_GRID with cells of type
 * line or polyline; ASCII or binary, versions up to 4.2 and 5.x), VTP (as read_triangle_soup()), MSH 2.2 and 4.1 (line
 * elements; ASCII or binary). The point array `MaximumInscribedSphereRadius`, which VMTK writes, becomes the radius.
 *
 * \param file the name of the file
 * \param centerlines receives the points, the radii (none, if the file has none) and the lines; single segments stay
 *        lines of two points, which Centerline_graph chains
 *
 * Linear in the size of the file, in time and in memory; n log n in the number of nodes of a .msh file.
 *
 * \exception Input_error if the file cannot be read, is of no known format, damaged or truncated, has a coordinate or a
 * radius that is not finite or an index that is out of range, or contains no line
 */
void read_centerlines(const std::string& file, Centerline_polylines& centerlines);

} // namespace CGAL::Tubular_meshing::IO

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/IO/read_centerlines_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_IO_READ_CENTERLINES_H
