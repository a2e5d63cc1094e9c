// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_CENTERLINES_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_CENTERLINES_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Centerlines/branched_centerlines.h>
#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <string>

namespace CGAL::Tubular_meshing::IO {

/*! \ingroup PkgTubularMeshingIO
 * Whether write_centerlines() knows the extension of the file: .vtp or .vtk. */
bool is_supported_centerlines_format(const std::string& file);

/*! \ingroup PkgTubularMeshingIO
 * writes centerlines into a file that the caller commits: use it to write several files all or none. */
void write_centerlines(Output_file& file, const Centerline_polylines& centerlines);
void write_centerlines(Output_file& file, const Centerline_graph& centerlines);
void write_centerlines(Output_file& file, const Branched_centerlines& centerlines);

/*! \ingroup PkgTubularMeshingIO
 *
 * writes centerlines, a polyline for each line or branch, with the radii as point array `MaximumInscribedSphereRadius`,
 * as VMTK does; Branched_centerlines also with the cell arrays of VMTK's branch extractor. .vtp (zlib) or legacy .vtk
 * (ASCII). read_centerlines() reads the same numbers back. The file is written
 * whole or not at all. Linear in the number of points.
 *
 * \tparam Centerlines `Centerline_polylines`, `Centerline_graph` or `Branched_centerlines`
 * \param file the name of the file
 * \param centerlines the centerlines
 *
 * \exception Output_error if the file cannot be written
 */
template <class Centerlines> void write_centerlines(const std::string& file, const Centerlines& centerlines) {
  Output_file out(file);
  write_centerlines(out, centerlines);
  out.commit();
}

} // namespace CGAL::Tubular_meshing::IO

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/IO/write_centerlines_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_CENTERLINES_H
