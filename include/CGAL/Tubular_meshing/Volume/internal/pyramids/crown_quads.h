// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_CROWN_QUADS_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_CROWN_QUADS_H

#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/Volume/internal/pyramids/Crowned_surface.h>
#include <CGAL/Tubular_meshing/base/Sentence.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

[[noreturn]] inline void refuse_quads(const Crowned_surface& crowned, const std::vector<std::size_t>& quads) {
  Sentence sentence = "No pyramid fits on the quad at " + place_of(crowned.middle(quads.front()));
  if (quads.size() > 1)
    sentence += ", and on " + std::to_string(quads.size() - 1) + (quads.size() == 2 ? " other" : " others");
  throw Meshing_error(
      sentence +
      ": it has a corner of 180 degrees or more, or is bent as much, as where two of its edges lie on the rim of an "
      "opening, or the surface meets itself there; repair it, mesh it finer, or let such quads be split.");
}

/* Makes two triangles of a quad: by the diagonal that makes them the better ones, and the flatter edge, unless it is an
 * edge of the surface already, as it may be where a vertex has two quads only. */
class Quad_splitter {
public:
  explicit Quad_splitter(Mixed_mesh& mesh)
      : mesh_(mesh) {
    add_edges(mesh.triangles);
    add_edges(mesh.quads);
  }

  void split(const std::vector<std::size_t>& quads) {
    Element_block<4> kept;
    auto next = quads.begin();
    for (std::size_t k = 0; k < mesh_.quads.size(); ++k) {
      const auto& q = mesh_.quads.vertices[k];
      const int label = mesh_.quads.label[k];
      if (next == quads.end() || *next != k) {
        kept.push_back(q, label);
        continue;
      }
      const std::size_t i = merit(q, 0) >= merit(q, 1) ? 0 : 1;
      for (const Triangle& t : halves(q, i))
        mesh_.triangles.push_back(t, label);
      edges_.insert(std::minmax(q[i], q[i + 2]));
      ++next;
    }
    mesh_.quads = std::move(kept);
  }

private:
  typedef std::array<std::uint32_t, 4> Quad;
  typedef std::array<std::uint32_t, 3> Triangle;

  template <std::size_t N> void add_edges(const Element_block<N>& faces) {
    for (const auto& f : faces.vertices)
      for (std::size_t i = 0; i < N; ++i)
        edges_.insert(std::minmax(f[i], f[(i + 1) % N]));
  }

  static std::array<Triangle, 2> halves(const Quad& q, std::size_t i) {
    return {{{q[i], q[i + 1], q[i + 2]}, {q[i], q[i + 2], q[(i + 3) % 4]}}};
  }

  // Of the diagonal from corner i.
  double merit(const Quad& q, std::size_t i) const {
    if (edges_.count(std::minmax(q[i], q[i + 2])) != 0)
      return -1;
    double worst = 1;
    std::array<Vector_3d, 2> normal;
    for (std::size_t k = 0; k < 2; ++k) {
      const Triangle t = halves(q, i)[k];
      const Vector_3d a(mesh_.points[t[0]]), b(mesh_.points[t[1]]), c(mesh_.points[t[2]]);
      worst = (std::min)(worst, triangle_gamma(a, b, c));
      normal[k] = normalized(cross(b - a, c - a));
    }
    return worst * (1 + dot(normal[0], normal[1]));
  }

  Mixed_mesh& mesh_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges_;
};

/* Crowns the quads of a surface. Those on which no pyramid fits are split into triangles first, if they may be; else
 * Meshing_error is thrown. */
inline Crowned_surface crown_quads(Mixed_mesh& surface, bool may_split) {
  for (;;) {
    Crowned_surface crowned(surface);
    std::vector<std::size_t> bad = crowned.quads_without_crown();
    if (bad.empty())
      bad = crowned.make_room();
    if (bad.empty())
      return crowned;
    if (!may_split)
      refuse_quads(crowned, bad);
    Quad_splitter(surface).split(bad); // there are fewer each time
  }
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_CROWN_QUADS_H
