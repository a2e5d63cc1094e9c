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

#include <CGAL/Tubular_meshing/Volume/internal/tetgen/Filling_arrays.h>
#include <CGAL/Tubular_meshing/internal/Vector_3d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* TetGen asks a plain function whether to split a tetrahedron. What that needs to know stands in a static variable: a
 * process runs TetGen once (see Child_process.h). */
template <class Size> class Tetgen_size_criterion {
public:
  explicit Tetgen_size_criterion(const Size& size) { size_of_run() = &size; }

  /* Where the circumscribed radius exceeds 0.8 h the circumcenter becomes a point: the mean edge inside is 1.08 h then,
   * with about as many tetrahedra as Mesh_3 makes. Bounds on volume, longest or mean edge that give the same number
   * were measured to leave up to twice as many slivers. */
  static bool is_too_large(double* a, double* b, double* c, double* d, double*, double) {
    const Vector_3d p(a[0], a[1], a[2]);
    const Vector_3d u = Vector_3d(b[0], b[1], b[2]) - p, v = Vector_3d(c[0], c[1], c[2]) - p,
                    w = Vector_3d(d[0], d[1], d[2]) - p;
    const Vector_3d numerator =
        squared_norm(u) * cross(v, w) + squared_norm(v) * cross(w, u) + squared_norm(w) * cross(u, v);
    const Vector_3d center = p + 0.25 * (u + v + w);
    const double bound = radius_bound * (*size_of_run())(std::array<double, 3>{center.x, center.y, center.z});
    const double denominator = 2 * dot(u, cross(v, w));
    return squared_norm(numerator) > bound * bound * denominator * denominator;
  }

private:
  static constexpr double radius_bound = 0.8;

  static const Size*& size_of_run() {
    static const Size* size = nullptr;
    return size;
  }
};

inline void give_to_tetgen(const Boundary_arrays& boundary, tetgenio& in) {
  in.numberofpoints = int(boundary.points.size());
  in.pointlist = new double[3 * boundary.points.size()];
  double* coordinate = in.pointlist;
  for (const auto& p : boundary.points)
    coordinate = std::copy(p.begin(), p.end(), coordinate);
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

inline void take_from_tetgen(const tetgenio& out, std::size_t boundary_points, Filling_arrays& filling) {
  for (std::size_t i = boundary_points; i < std::size_t(out.numberofpoints); ++i)
    filling.inner_points.push_back({out.pointlist[3 * i], out.pointlist[3 * i + 1], out.pointlist[3 * i + 2]});
  filling.tetrahedra.reserve(std::size_t(out.numberoftetrahedra));
  for (const int* t = out.tetrahedronlist; t != out.tetrahedronlist + 4 * std::size_t(out.numberoftetrahedra); t += 4)
    filling.tetrahedra.push_back({std::uint32_t(t[0]), std::uint32_t(t[1]), std::uint32_t(t[2]), std::uint32_t(t[3])});
}

/* Fills a closed surface by TetGen, in this process: tetrahedra as large as `size(std::array<double, 3>)` says, and at
 * most `most_points` points inside. Returns 0, or the number that TetGen throws; may crash. */
template <class Size>
int run_tetgen(const Boundary_arrays& boundary, const Size& size, std::size_t most_points, Filling_arrays& filling) {
  tetgenio in, out;
  give_to_tetgen(boundary, in);
  in.tetunsuitable = Tetgen_size_criterion<Size>::is_too_large;
  const Tetgen_size_criterion<Size> criterion(size);
  // p: the surface, Y: kept, M: triangle by triangle, even where they are coplanar; q: refined; J: no vertex renumbered
  std::string switches = "pYMqJQS" + std::to_string((std::min)(most_points, std::size_t(1000000000)));
  try {
    tetrahedralize(&switches[0], &in, &out);
  } catch (int code) {
    return code != 0 ? code : 255;
  }
  take_from_tetgen(out, boundary.points.size(), filling);
  return 0;
}

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_TETGEN_RUN_TETGEN_H
