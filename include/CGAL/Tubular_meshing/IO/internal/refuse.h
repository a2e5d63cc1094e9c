// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_REFUSE_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_REFUSE_H

#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <string>

namespace CGAL::Tubular_meshing::IO::internal {

constexpr const char* write_vtu_instead = "write a .vtu file instead";

// One sentence: the file, why a writer does not write it, and what to do.
[[noreturn]] inline void refuse(const std::string& file, const std::string& reason, const std::string& help) {
  throw Output_error("The file \"" + file + "\" cannot be written: " + reason + "; " + help + ".");
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_REFUSE_H
