// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Generated vessels of known openings and parts go through what the tool does before it meshes: a count that is wrong,
// or an error, is told with the case's number. A damaged surface may be refused.
//
//   fuzz_vessels [NUMBER OF CASES] [FIRST] [FILE]
//
// With a FILE the surface of the first case is written there, to be looked at, and nothing else is done.

#include "Generated_vessels.h"

#include <CGAL/Tubular_meshing/IO/write_surface.h>
#include <CGAL/Tubular_meshing/Openings/labelled_ends.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Repair/carry_labels.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>
#include <CGAL/Tubular_meshing/Repair/split_into_parts.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <vector>

namespace {

using vessels::Case;
using vessels::Mesh;
namespace tubular = CGAL::Tubular_meshing;

enum class Outcome { right, refused, wrong };

Outcome check(const Case& c) {
  std::vector<tubular::Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  for (auto v : c.mesh.vertices())
    points.push_back(c.mesh.point(v));
  for (auto f : c.mesh.faces()) {
    const auto h = c.mesh.halfedge(f);
    triangles.push_back(
        {std::size_t(c.mesh.source(h)), std::size_t(c.mesh.target(h)), std::size_t(c.mesh.target(c.mesh.next(h)))});
  }
  std::size_t openings = 0, parts = 0;
  try {
    Mesh repaired;
    tubular::repair_surface(points, triangles, repaired, tubular::parameters::number_of_parts(std::size_t(0)));
    if (!c.labels.empty()) {
      auto label = repaired.add_property_map<Mesh::Face_index, int>("f:label", 0).first;
      tubular::carry_labels(points, triangles, c.labels, repaired, label);
      tubular::open_labelled_ends(repaired, label);
      repaired.remove_property_map(label);
    }
    for (const Mesh& part : tubular::split_into_parts(repaired)) {
      openings += tubular::make_tubular_model(part).openings.size();
      ++parts;
    }
  } catch (const std::exception& e) {
    std::printf("REFUSED %s\n  %s\n", c.what.c_str(), e.what());
    return Outcome::refused;
  }
  if (openings == c.openings && parts == c.parts)
    return Outcome::right;
  std::printf("WRONG %s\n  %zu openings instead of %zu, %zu parts instead of %zu\n", c.what.c_str(), openings,
              c.openings, parts, c.parts);
  return Outcome::wrong;
}

} // namespace

int main(int argc, char* argv[]) {
  const unsigned number = argc > 1 ? unsigned(std::atoi(argv[1])) : 40,
                 first = argc > 2 ? unsigned(std::atoi(argv[2])) : 0;
  if (argc > 3) {
    tubular::IO::write_surface(argv[3], vessels::make_case(first).mesh);
    return 0;
  }
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ); // failures are seen at once
  const auto start = std::chrono::steady_clock::now();
  unsigned counts[3] = {0, 0, 0}, damaged_refused = 0;
  for (unsigned i = first; i < first + number; ++i) {
    const Case c = vessels::make_case(i);
    const Outcome outcome = check(c);
    ++counts[int(outcome)];
    damaged_refused += outcome == Outcome::refused && c.is_damaged ? 1 : 0;
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::printf("%u cases: %u right, %u refused (%u of them damaged), %u wrong; %.1f s\n", number, counts[0], counts[1],
              damaged_refused, counts[2], seconds);
  return counts[1] == damaged_refused && counts[2] == 0 ? 0 : 1;
}
