// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Any bytes are a surface, centerlines or a mesh, or an Input_error. `--reader=surface_stl` and the like say what the
// bytes are read as. In a .mesh file what stands behind the first zero byte is the .sol file beside it.

#include "Fuzzed_file.h"

#include <CGAL/Tubular_meshing/IO/internal/element_kinds.h>
#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/read_mesh.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

typedef CGAL::Tubular_meshing::Point_3 Point_3;
namespace Tubular = CGAL::Tubular_meshing;

std::string reader; // surface, centerlines or mesh
std::string format; // the extension of the file

void expect(bool condition) {
  if (!condition)
    std::abort();
}

void read_surface(const fuzz::Scratch_file& file) {
  CGAL::Surface_mesh<Point_3> surface;
  Tubular::IO::read_surface(file.name(), surface);
  expect(surface.is_valid(false) && surface.number_of_faces() > 0);
  const Tubular::IO::Surface_data data = Tubular::IO::read_surface_data(file.name());
  expect(data.labels.empty() || data.labels.label.size() == data.triangles.size());
}

void read_centerlines(const fuzz::Scratch_file& file) {
  Tubular::Centerline_polylines lines;
  Tubular::IO::read_centerlines(file.name(), lines);
  for (const auto& line : lines.lines)
    for (std::size_t i : line)
      expect(i < lines.points.size());
}

void read_mesh(const fuzz::Scratch_file& file) {
  Tubular::Mixed_mesh mesh;
  Tubular::IO::read_mesh(file.name(), mesh);
  Tubular::IO::internal::for_each_block(mesh, [&](const auto& block, const auto&) {
    for (const auto& element : block.vertices)
      for (std::size_t i : element)
        expect(i < mesh.points.size());
  });
  for (const auto& array : mesh.point_arrays)
    expect(array.values.size() == std::size_t(array.components) * mesh.points.size());
}

void write(const std::uint8_t* data, std::size_t size, const fuzz::Scratch_file& file) {
  const std::uint8_t *end = data + size, *zero = format == "mesh" ? std::find(data, end, 0) : end;
  file.write(data, std::size_t(zero - data));
  if (zero != end)
    file.write_companion("sol", zero + 1, std::size_t(end - zero - 1));
  else
    file.remove_companion("sol");
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  const std::string option = "--reader=";
  for (int i = 1; i < *argc; ++i) {
    const std::string word = (*argv)[i];
    const std::size_t separator = word.find('_');
    if (word.compare(0, option.size(), option) != 0 || separator == word.npos)
      continue;
    reader = word.substr(option.size(), separator - option.size());
    format = word.substr(separator + 1);
  }
  if (reader != "surface" && reader != "centerlines" && reader != "mesh") {
    std::fprintf(stderr, "give --reader=surface_EXTENSION, centerlines_EXTENSION or mesh_EXTENSION\n");
    std::exit(2);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Scratch_file file(format);
  write(data, size, file);
  try {
    (reader == "surface" ? read_surface : reader == "mesh" ? read_mesh : read_centerlines)(file);
  } catch (const Tubular::Input_error&) {
  }
  return 0;
}
