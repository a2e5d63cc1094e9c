// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_UNFINISHED_OUTPUTS_H
#define CGAL_TUBULAR_MESHING_IO_UNFINISHED_OUTPUTS_H

#include <CGAL/Tubular_meshing/base/config.h>

#include <filesystem>
#include <mutex>

namespace CGAL::Tubular_meshing::IO {

/*! \ingroup PkgTubularMeshingIO
 * Removes what outputs of this process, of any thread, have written and not committed, and lets none begin or be
 * committed from then on: the last that a program does which has to end without leaving its work in order, as after a
 * signal. Waits for a Commit_guard of another thread. Not to be called from a signal handler. */
void remove_unfinished_outputs();

/*! \ingroup PkgTubularMeshingIO
 * While one is there, remove_unfinished_outputs() waits: several outputs can be committed all or none. */
class Commit_guard {
public:
  Commit_guard();

private:
  std::unique_lock<std::recursive_mutex> lock_;
};

namespace internal {

/* That a file, or a folder with all that is in it, is not to stay unless it gets its name; it is made and added under one
 * Commit_guard. */
void add_unfinished(const std::filesystem::path& path);
void forget_unfinished(const std::filesystem::path& path) noexcept;

} // namespace internal
} // namespace CGAL::Tubular_meshing::IO

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/IO/unfinished_outputs_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_IO_UNFINISHED_OUTPUTS_H
