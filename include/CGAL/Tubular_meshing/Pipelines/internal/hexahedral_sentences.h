// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_HEXAHEDRAL_SENTENCES_H
#define CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_HEXAHEDRAL_SENTENCES_H

#include <CGAL/Tubular_meshing/Pipelines/Hexahedral_report.h>

#include <cstddef>
#include <sstream>
#include <string>

namespace CGAL::Tubular_meshing::internal {

/* The first place without blocks, and how many there are. */
inline std::string why_no_blocks(const Hexahedral_report& report) {
  const Place_without_blocks& first = report.places_without_blocks.front();
  std::ostringstream s;
  s.precision(6);
  s << "near (" << first.place.x() << ", " << first.place.y() << ", " << first.place.z() << "), " << first.reason;
  const std::size_t others = report.places_without_blocks.size() - 1;
  if (others > 0)
    s << "; " << others << (others == 1 ? " other place is like it" : " other places are like it");
  s << ".";
  return s.str();
}

inline std::string why_not_filled(const std::string& reason) {
  return "Nor can junctions alone be filled: " + reason + (reason.back() == '.' ? "" : ".");
}

/* What fills the places without blocks. `fineness`: its size, in mesh sizes. */
inline std::string filled_junctions(const Hexahedral_report& report, double fineness) {
  std::size_t pyramids = 0, tetrahedra = 0;
  for (const Place_without_blocks& p : report.places_without_blocks) {
    pyramids += p.pyramids;
    tetrahedra += p.tetrahedra;
  }
  std::ostringstream s;
  s.precision(2);
  s << "Where there are no blocks, at " << report.places_without_blocks.size()
    << " of the vessels' junctions and ends, " << pyramids << " pyramids and " << tetrahedra
    << " tetrahedra fill the lumen";
  if (fineness < 1)
    s << ", of " << fineness << " times the mesh size, as those of the mesh size do not fit";
  s << ".";
  return s.str();
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_HEXAHEDRAL_SENTENCES_H
