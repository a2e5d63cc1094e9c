// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_HDF5_AT_EXIT_H
#define CGAL_TUBULAR_MESHING_IO_HDF5_AT_EXIT_H

#include <CGAL/Tubular_meshing/base/config.h>

namespace CGAL::Tubular_meshing::IO {

/*! \ingroup PkgTubularMeshingIO
 *
 * keeps HDF5 from writing when the program ends. A file that could not be written whole, as on a full disk, stays open
 * in the library, which tries once more at the end of the program, and crashes there: the exit status is lost.
 *
 * For programs that close their HDF5 files themselves, before anything else uses HDF5; the package does not call it.
 * Does nothing where the package was built without HDF5.
 */
void leave_hdf5_alone_at_exit();

} // namespace CGAL::Tubular_meshing::IO

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/IO/hdf5_at_exit_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_IO_HDF5_AT_EXIT_H
