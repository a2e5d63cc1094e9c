// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_INTERNAL_FINGERPRINT_H
#define CGAL_TUBULAR_MESHING_QUALITY_INTERNAL_FINGERPRINT_H

#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Tells meshes apart whose elements or labels differ, or their numbers of points; where the points are does not matter.
 * O(n), by blocks that do not depend on the threads. */
class Fingerprint {
public:
  Fingerprint(const Mixed_mesh& mesh, int threads)
      : threads_(threads) {
    add(std::vector<std::size_t>{mesh.points.size()});
    add_elements(mesh.tetrahedra);
    add_elements(mesh.pyramids);
    add_elements(mesh.prisms);
    add_elements(mesh.hexahedra);
    add_elements(mesh.triangles);
    add_elements(mesh.quads);
  }

  bool operator==(const Fingerprint& other) const { return value_ == other.value_; }

private:
  template <std::size_t N> void add_elements(const Element_block<N>& elements) {
    add(elements.vertices);
    add(elements.label);
  }

  template <class T> void add(const std::vector<T>& values) {
    combine(values.size());
    const std::size_t width = 1 << 15;
    std::vector<std::size_t> hashes((values.size() + width - 1) / width);
    for_each_task(hashes.size(), threads_, [&](std::size_t b) {
      const std::size_t first = b * width, n = (std::min)(width, values.size() - first);
      hashes[b] = std::hash<std::string_view>()(
          std::string_view(reinterpret_cast<const char*>(values.data() + first), n * sizeof(T)));
    });
    for (std::size_t h : hashes)
      combine(h);
  }

  void combine(std::size_t h) { value_ = (value_ ^ h) * 0x9e3779b97f4a7c15u + (value_ >> 29); }

  int threads_;
  std::size_t value_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUALITY_INTERNAL_FINGERPRINT_H
