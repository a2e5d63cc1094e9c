// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Any triangles are repaired, or refused by an error of the package. The bytes are a soup: the first says how many
// points there are, of up to 64; each point is two bytes, in a grid of 8 x 8 x 8, so that points coincide and triangles
// degenerate often; each triangle is three.

#include <CGAL/Tubular_meshing/Repair/repair_surface.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point_3;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0)
    return 0;
  const std::size_t most_triangles = 256, number_of_points = 1 + data[0] % 64;
  std::size_t i = 1;
  std::vector<Point_3> points;
  for (; points.size() < number_of_points && i + 2 <= size; i += 2)
    points.emplace_back(data[i] & 7, (data[i] >> 3) & 7, data[i + 1] & 7);
  std::vector<std::array<std::size_t, 3>> triangles;
  for (; !points.empty() && triangles.size() < most_triangles && i + 3 <= size; i += 3)
    triangles.push_back({data[i] % points.size(), data[i + 1] % points.size(), data[i + 2] % points.size()});
  try {
    CGAL::Surface_mesh<Point_3> surface;
    CGAL::Tubular_meshing::repair_surface(points, triangles, surface);
    if (!surface.is_valid(false) || surface.number_of_faces() == 0)
      std::abort();
  } catch (const CGAL::Tubular_meshing::Input_error&) {
  } catch (const CGAL::Tubular_meshing::Meshing_error&) {
  }
  return 0;
}
