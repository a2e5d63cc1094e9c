// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes in parts for the tests of their files.

#ifndef TUBULAR_MESHING_TEST_PARTITIONED_MESHES_H
#define TUBULAR_MESHING_TEST_PARTITIONED_MESHES_H

#include "solver_meshes.h"

#include <CGAL/Tubular_meshing/Partition/Cell_partition.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

struct Partitioned {
  std::string name;
  Mesh mesh;
  TM::Cell_partition partition;
};

// In the order of the mesh, and as mixed as can be.
inline TM::Cell_partition in_order(const Mesh& m, std::size_t parts) {
  TM::Cell_partition p{parts, {}};
  for (std::size_t c = 0; c < m.number_of_cells(); ++c)
    p.part.push_back(std::uint32_t(c * parts / m.number_of_cells()));
  return p;
}
inline TM::Cell_partition scattered(const Mesh& m, std::size_t parts) {
  TM::Cell_partition p{parts, {}};
  for (std::size_t c = 0; c < m.number_of_cells(); ++c)
    p.part.push_back(std::uint32_t((c * 7) % parts));
  return p;
}

// With point arrays, and two points that no cell has.
inline Mesh with_arrays(Mesh m) {
  m.points.push_back(Point(-1, -2, -3));
  m.points.insert(m.points.begin(), Point(7, 8, 9));
  const auto shift = [](auto& block) {
    for (auto& vertices : block.vertices)
      for (auto& v : vertices)
        ++v;
  };
  shift(m.tetrahedra);
  shift(m.pyramids);
  shift(m.prisms);
  shift(m.hexahedra);
  shift(m.triangles);
  shift(m.quads);
  TM::Point_array number{"number", 1, {}}, metric{"metric", 6, {}};
  for (std::size_t i = 0; i < m.points.size(); ++i) {
    number.values.push_back(double(i) / 3);
    for (std::size_t k = 0; k < 6; ++k)
      metric.values.push_back(double(i * 6 + k) / 7);
  }
  m.point_arrays = {number, metric};
  return m;
}

inline std::vector<Partitioned> partitioned_samples() {
  std::vector<Partitioned> result;
  for (const Named_mesh& m : solver_meshes()) {
    result.push_back({m.name + "_3", m.mesh, in_order(m.mesh, 3)});
    result.push_back({m.name + "_scattered", m.mesh, scattered(m.mesh, 4)});
  }
  const Mesh larger = Layered_box::make(5, "HXWWTT", "111222");
  result.push_back({"larger_8", larger, in_order(larger, 8)});
  result.push_back({"larger_1", larger, in_order(larger, 1)});
  return result;
}

// Cells, then facets, by their kinds: corners and label.
struct Elements {
  std::vector<std::vector<std::int64_t>> corners;
  std::vector<int> region, patch;

  explicit Elements(const Mesh& m) {
    add(m.tetrahedra, true);
    add(m.pyramids, true);
    add(m.prisms, true);
    add(m.hexahedra, true);
    add(m.triangles, false);
    add(m.quads, false);
  }

private:
  template <class Block> void add(const Block& block, bool are_cells) {
    for (std::size_t i = 0; i < block.size(); ++i) {
      corners.emplace_back(block.vertices[i].begin(), block.vertices[i].end());
      region.push_back(are_cells ? block.label[i] : 0);
      patch.push_back(are_cells ? 0 : block.label[i]);
    }
  }
};

// For each facet the cells whose face it is, those of the lower region first.
inline std::vector<std::vector<std::size_t>> cells_behind_facets(const Mesh& m) {
  const Faces_of_cells cells(m);
  std::map<Corners, std::vector<std::size_t>> sides;
  for (std::size_t c = 0; c < cells.faces.size(); ++c)
    for (const Corners& f : cells.corners(c))
      sides[f].push_back(c);
  const Elements elements(m);
  std::vector<std::vector<std::size_t>> result;
  for (std::size_t f = m.number_of_cells(); f < elements.corners.size(); ++f) {
    result.push_back(sides.at(Corners(elements.corners[f].begin(), elements.corners[f].end())));
    std::stable_sort(result.back().begin(), result.back().end(),
                     [&](std::size_t a, std::size_t b) { return cells.region[a] < cells.region[b]; });
  }
  return result;
}

#endif // TUBULAR_MESHING_TEST_PARTITIONED_MESHES_H
