// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_VESSEL_SECTION_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_VESSEL_SECTION_H

#include <CGAL/Tubular_meshing/Hexahedra/internal/Disc_grid.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The vertices of a vessel's section: those of the core, by a Disc_grid, and of the wall round it. */
struct Vessel_section {
  std::vector<std::uint32_t> core, wall;
  std::vector<std::uint32_t> dome; // of a blind end: on the wall, beyond those of the core

  // The corners of blocks: a section of Disc_grid(1).
  Vessel_section corners(const Disc_grid& disc) const {
    const std::size_t s = std::size_t(disc.subdivision());
    const Disc_grid coarse(1);
    Vessel_section result;
    for (std::size_t v = 0; v < coarse.size(); ++v) {
      const Disc_grid::Place& p = coarse.place(v);
      const std::size_t at = disc.vertex(p.quadrant, p.x * int(s), p.y * int(s));
      result.core.push_back(core[at]);
      if (!dome.empty())
        result.dome.push_back(dome[at]);
    }
    for (std::size_t i = 0; i < wall.size(); i += s)
      result.wall.push_back(wall[i]);
    return result;
  }
};

/* Adds the hexahedra between sections, and the quads of the boundary. */
class Section_joiner {
public:
  Section_joiner(const Disc_grid& disc, Element_block<8>& hexahedra, Element_block<4>& quads)
      : disc_(disc)
      , hexahedra_(hexahedra)
      , quads_(quads) {}

  void add_between(const Vessel_section& a, const Vessel_section& b, int label) {
    for (const auto& q : disc_.quads())
      hexahedra_.push_back({{a.core[q[0]], a.core[q[1]], a.core[q[2]], a.core[q[3]], b.core[q[0]], b.core[q[1]],
                             b.core[q[2]], b.core[q[3]]}},
                           label);
    for (std::size_t i = 0; i < around(); ++i) {
      const std::size_t j = (i + 1) % around(), c = disc_.boundary()[i], d = disc_.boundary()[j];
      hexahedra_.push_back({{a.core[c], a.wall[i], a.wall[j], a.core[d], b.core[c], b.wall[i], b.wall[j], b.core[d]}},
                           label);
      quads_.push_back({{a.wall[i], a.wall[j], b.wall[j], b.wall[i]}}, labels::wall);
    }
  }

  // Of a blind end; `first`: where the vessel begins.
  void add_dome(const Vessel_section& s, bool first, int label) {
    for (const auto& q : disc_.quads()) {
      std::array<std::uint32_t, 8> h;
      for (int i = 0; i < 4; ++i) {
        h[i] = s.core[q[first ? 3 - i : i]];
        h[i + 4] = s.dome[q[first ? 3 - i : i]];
      }
      hexahedra_.push_back(h, label);
      quads_.push_back({{h[4], h[5], h[6], h[7]}}, labels::wall);
    }
  }

  // Of an opening.
  void add_cap(const Vessel_section& s, bool first, int patch) {
    const auto add_quad = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r, std::uint32_t t) {
      first ? quads_.push_back({{p, t, r, q}}, patch) : quads_.push_back({{p, q, r, t}}, patch);
    };
    for (const auto& q : disc_.quads())
      add_quad(s.core[q[0]], s.core[q[1]], s.core[q[2]], s.core[q[3]]);
    for (std::size_t i = 0; i < around(); ++i) {
      const std::size_t j = (i + 1) % around();
      add_quad(s.core[disc_.boundary()[i]], s.wall[i], s.wall[j], s.core[disc_.boundary()[j]]);
    }
  }

private:
  std::size_t around() const { return disc_.boundary().size(); }

  const Disc_grid& disc_;
  Element_block<8>& hexahedra_;
  Element_block<4>& quads_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_VESSEL_SECTION_H
