// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Any bytes are a surface, or an Input_error.

#include "Fuzzed_file.h"

#include <CGAL/Tubular_meshing/IO/read_surface.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::Scratch_file& file = fuzz::scratch_file();
  file.write(data, size);
  try {
    CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> surface;
    CGAL::Tubular_meshing::IO::read_surface(file.name(), surface);
    if (!surface.is_valid(false) || surface.number_of_faces() == 0)
      std::abort();
  } catch (const CGAL::Tubular_meshing::Input_error&) {
  }
  return 0;
}
