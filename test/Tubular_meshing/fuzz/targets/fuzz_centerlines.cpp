// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Any bytes are centerlines, or an Input_error.

#include "Fuzzed_file.h"

#include <CGAL/Tubular_meshing/IO/read_centerlines.h>

#include <CGAL/Simple_cartesian.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::Scratch_file& file = fuzz::scratch_file();
  file.write(data, size);
  try {
    CGAL::Tubular_meshing::Centerline_polylines<CGAL::Simple_cartesian<double>::Point_3> lines;
    CGAL::Tubular_meshing::IO::read_centerlines(file.name(), lines);
    for (const auto& line : lines.lines)
      for (std::size_t i : line)
        if (i >= lines.points.size())
          std::abort();
  } catch (const CGAL::Tubular_meshing::Input_error&) {
  }
  return 0;
}
