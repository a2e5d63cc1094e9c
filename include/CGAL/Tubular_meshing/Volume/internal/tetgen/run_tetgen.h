// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The only file that knows TetGen's own header, whose macros it takes away again: a program that wants them includes
// <tetgen.h> first.

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_TETGEN_RUN_TETGEN_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_TETGEN_RUN_TETGEN_H

#ifndef tetgenH
#pragma push_macro("REAL")
#pragma push_macro("TETLIBRARY")
#undef REAL
#undef TETLIBRARY
#define TETLIBRARY // failures are thrown
#include <tetgen.h>
#undef FILENAMESIZE
#undef INPUTLINESIZE
#undef fastlookup
#undef fsymself
#undef fnextself
#undef setvertices
#undef setshvertices
#undef issubface
#undef isshtet
#undef isshsubseg
#undef issubseg
#pragma pop_macro("TETLIBRARY")
#pragma pop_macro("REAL")
#endif

#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Recovered_boundary.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace CGAL::Tubular_meshing::internal {

inline void give_to_tetgen(const Boundary_arrays& boundary, tetgenio& in) {
  in.numberofpoints = int(boundary.points.size());
  in.pointlist = new double[3 * boundary.points.size()];
  double* coordinate = in.pointlist;
  for (const auto& p : boundary.points)
    for (double x : {p.x, p.y, p.z})
      *coordinate++ = x;
  in.facetlist = new tetgenio::facet[boundary.triangles.size()];
  for (const auto& t : boundary.triangles) {
    tetgenio::facet& facet = in.facetlist[in.numberoffacets++];
    tetgenio::init(&facet);
    facet.polygonlist = new tetgenio::polygon[1];
    facet.numberofpolygons = 1;
    tetgenio::init(facet.polygonlist);
    facet.polygonlist->vertexlist = new int[3];
    facet.polygonlist->numberofvertices = 3;
    std::copy(t.begin(), t.end(), facet.polygonlist->vertexlist);
  }
}

inline void take_from_tetgen(const tetgenio& out, std::size_t boundary_points, Recovered_boundary& recovered) {
  for (std::size_t i = boundary_points; i < std::size_t(out.numberofpoints); ++i)
    recovered.inner_points.push_back({out.pointlist[3 * i], out.pointlist[3 * i + 1], out.pointlist[3 * i + 2]});
  recovered.tetrahedra.reserve(std::size_t(out.numberoftetrahedra));
  for (const int* t = out.tetrahedronlist; t != out.tetrahedronlist + 4 * std::size_t(out.numberoftetrahedra); t += 4)
    recovered.tetrahedra.push_back(
        {std::uint32_t(t[0]), std::uint32_t(t[1]), std::uint32_t(t[2]), std::uint32_t(t[3])});
}

/* Fills a closed surface with tetrahedra of its own points, and of as few others as that takes, by TetGen, in this
 * process. Returns 0, or the number that TetGen throws; may crash. */
inline int run_tetgen(const Boundary_arrays& boundary, Recovered_boundary& recovered) {
  tetgenio in, out;
  give_to_tetgen(boundary, in);
  // p: the surface, Y: kept, M: triangle by triangle even where they are coplanar, J: its vertices keep their numbers
  char switches[] = "pYMJQ";
  try {
    tetrahedralize(switches, &in, &out);
  } catch (int code) {
    return code != 0 ? code : 255;
  }
  take_from_tetgen(out, boundary.points.size(), recovered);
  return 0;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_TETGEN_RUN_TETGEN_H
