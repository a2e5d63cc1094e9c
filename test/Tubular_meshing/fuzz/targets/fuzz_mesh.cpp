// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Any bytes are a mesh, or an Input_error. In a .mesh file what stands behind the first zero byte is its .sol file.

#include "Fuzzed_file.h"

#include <CGAL/Tubular_meshing/IO/read_mesh.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>

template <class Mesh> void check(const Mesh& mesh) {
  CGAL::Tubular_meshing::IO::internal::for_each_block(mesh, [&](const auto& block, const auto&) {
    for (const auto& element : block.vertices)
      for (std::size_t i : element)
        if (i >= mesh.points.size())
          std::abort();
  });
  for (const auto& array : mesh.point_arrays)
    if (array.values.size() != std::size_t(array.components) * mesh.points.size())
      std::abort();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::Scratch_file& file = fuzz::scratch_file();
  const std::uint8_t *end = data + size, *zero = fuzz::format() == "mesh" ? std::find(data, end, 0) : end;
  file.write(data, std::size_t(zero - data));
  if (zero != end)
    file.write_companion("sol", zero + 1, std::size_t(end - zero - 1));
  else
    file.remove_companion("sol");
  try {
    CGAL::Tubular_meshing::Mixed_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
    CGAL::Tubular_meshing::IO::read_mesh(file.name(), mesh);
    check(mesh);
  } catch (const CGAL::Tubular_meshing::Input_error&) {
  }
  return 0;
}
