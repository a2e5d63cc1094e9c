// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_FAIL_QUADRATIC_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_FAIL_QUADRATIC_H

#include <CGAL/Tubular_meshing/IO/internal/Input_file.h>

#include <string>

namespace CGAL::Tubular_meshing::IO::internal {

// Of a mesh that read_mesh() would have to straighten; which: "cell 7".
[[noreturn]] inline void fail_quadratic(const Input_file& file, const std::string& which) {
  file.fail("cannot be used: " + which +
            " is quadratic, and only linear meshes are read; make it without --order 2, or save it with elements of "
            "first order");
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_FAIL_QUADRATIC_H
