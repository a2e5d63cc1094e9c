// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_SECTIONS_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_SECTIONS_H

#include <CGAL/Tubular_meshing/Centerlines/cross_sections.h>
#include <CGAL/Tubular_meshing/Centerlines/zero_d_model.h>
#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO {

/*! \ingroup PkgTubularMeshingIO
 * Whether write_sections() knows the extension of the file: .csv or .vtp. */
bool is_supported_sections_format(const std::string& file);

/*! \ingroup PkgTubularMeshingIO
 * writes cross-sections into a file that the caller commits: use it to write several files all or none. */
void write_sections(Output_file& file, const std::vector<Cross_section>& sections);

/*! \ingroup PkgTubularMeshingIO
 *
 * writes the cross-sections of branches: `.csv`, a line each; or `.vtp` (zlib), a polyline a branch through the points
 * of the centerline, with the values as point arrays and `branch` as a cell array as well; a branch of one section is a
 * vertex.
 *
 * | column, or point array | |
 * |---|---|
 * | `branch`, `abscissa` | the place; `x`, `y`, `z` in `.csv` |
 * | `normal_x`, `normal_y`, `normal_z`; `normal` | of the plane |
 * | `center_x`, `center_y`, `center_z`; `center` | centroid of the section |
 * | `area`, `perimeter`, `hydraulic_diameter` | of the section; 0 where there is none |
 * | `inscribed_radius` | of the centerline |
 * | `eccentricity` | of the ellipse of the same second moments |
 * | `curvature`, `torsion` | of the centerline |
 *
 * Numbers are kept to the last bit. The file is written whole or not at all. Linear.
 *
 * \param file the name of the file
 * \param sections in the order of their branches, as cross_sections() gives them
 *
 * \exception Output_error if the file cannot be written
 */
inline void write_sections(const std::string& file, const std::vector<Cross_section>& sections) {
  Output_file out(file);
  write_sections(out, sections);
  out.commit();
}

/*! \ingroup PkgTubularMeshingIO
 * writes a zero-dimensional model into a file that the caller commits. */
void write_zero_d_model(Output_file& file, const Zero_d_model& model);

/*! \ingroup PkgTubularMeshingIO
 *
 * writes a zero-dimensional model as the input of SimVascular's svZeroDSolver, a JSON file that the solver runs as it
 * is: vessels of type `BloodVessel`, `branch0_seg0` and on, junctions, and boundary conditions with the names of the
 * openings. Units are centimetres, grams and seconds. Ten cycles of one second are computed, of a steady flow.
 *
 * \param file the name of the file
 * \param model see make_zero_d_model()
 *
 * \exception Output_error if the file cannot be written
 */
inline void write_zero_d_model(const std::string& file, const Zero_d_model& model) {
  Output_file out(file);
  write_zero_d_model(out, model);
  out.commit();
}

} // namespace CGAL::Tubular_meshing::IO

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/IO/write_sections_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_SECTIONS_H
