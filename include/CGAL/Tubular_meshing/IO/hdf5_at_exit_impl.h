// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_HDF5_AT_EXIT_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_HDF5_AT_EXIT_IMPL_H

#include <CGAL/Tubular_meshing/IO/hdf5_at_exit.h>

#ifdef CGAL_TUBULAR_MESHING_WITH_HDF5
#include <hdf5.h>
#endif

namespace CGAL::Tubular_meshing::IO {

CGAL_TUBULAR_MESHING_INLINE void leave_hdf5_alone_at_exit() {
#ifdef CGAL_TUBULAR_MESHING_WITH_HDF5
  H5dont_atexit();
#endif
}

} // namespace CGAL::Tubular_meshing::IO

#endif // CGAL_TUBULAR_MESHING_IO_HDF5_AT_EXIT_IMPL_H
