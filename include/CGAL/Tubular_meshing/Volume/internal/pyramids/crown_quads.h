// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_CROWN_QUADS_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_CROWN_QUADS_H

#include <CGAL/Tubular_meshing/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Quality/internal/element_measures.h>
#include <CGAL/Tubular_meshing/Volume/internal/pyramids/Crowned_surface.h>
#include <CGAL/Tubular_meshing/exceptions.h>
#include <CGAL/Tubular_meshing/internal/Vector_3d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

template <class Point>
[[noreturn]] void refuse_quads(const Crowned_surface<Point>& crowned, const std::vector<std::size_t>& quads) {
  const Vector_3d& p = crowned.middle(quads.front());
  std::ostringstream s;
  s << "No pyramid fits on the quad at (" << p.x << ", " << p.y << ", " << p.z << ")";
  if (quads.size() > 1)
    s << ", and on " << quads.size() - 1 << (quads.size() == 2 ? " other" : " others");
  s << ": it has a corner of 180 degrees or more, or is bent as much, as where two of its edges lie on the rim of an "
       "opening, or the surface meets itself there; mend it, mesh it finer, or let such quads be split.";
  throw Meshing_error(s.str());
}

// The two triangles of a quad: by the diagonal that makes them the better ones, and the flatter edge.
template <class Point>
std::array<std::array<std::uint32_t, 3>, 2> halves_of(const Mixed_mesh<Point>& mesh,
                                                      const std::array<std::uint32_t, 4>& q) {
  const auto halves = [&](std::size_t i) {
    return std::array<std::array<std::uint32_t, 3>, 2>{{{q[i], q[i + 1], q[i + 2]}, {q[i], q[i + 2], q[(i + 3) % 4]}}};
  };
  const auto merit = [&](std::size_t i) {
    double worst = 1;
    std::array<Vector_3d, 2> normal;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto t = halves(i)[k];
      const Vector_3d a(mesh.points[t[0]]), b(mesh.points[t[1]]), c(mesh.points[t[2]]);
      worst = (std::min)(worst, triangle_gamma(a, b, c));
      normal[k] = normalized(cross(b - a, c - a));
    }
    return worst * (1 + dot(normal[0], normal[1]));
  };
  return halves(merit(0) >= merit(1) ? 0 : 1);
}

template <class Point> void split_quads(Mixed_mesh<Point>& mesh, const std::vector<std::size_t>& quads) {
  Element_block<4> kept;
  auto next = quads.begin();
  for (std::size_t k = 0; k < mesh.quads.size(); ++k) {
    if (next == quads.end() || *next != k) {
      kept.push_back(mesh.quads.vertices[k], mesh.quads.label[k]);
      continue;
    }
    for (const auto& t : halves_of(mesh, mesh.quads.vertices[k]))
      mesh.triangles.push_back(t, mesh.quads.label[k]);
    ++next;
  }
  mesh.quads = std::move(kept);
}

/* Crowns the quads of a surface. Those on which no pyramid fits are split into triangles first, if they may be; else
 * Meshing_error is thrown. */
template <class Point> Crowned_surface<Point> crown_quads(Mixed_mesh<Point>& surface, bool may_split) {
  for (;;) {
    Crowned_surface<Point> crowned(surface);
    std::vector<std::size_t> bad = crowned.quads_without_crown();
    if (bad.empty())
      bad = crowned.make_room();
    if (bad.empty())
      return crowned;
    if (!may_split)
      refuse_quads(crowned, bad);
    split_quads(surface, bad); // there are fewer each time
  }
}

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_CROWN_QUADS_H
