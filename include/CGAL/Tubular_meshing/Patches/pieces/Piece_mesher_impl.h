// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PIECES_PIECE_MESHER_IMPL_H
#define CGAL_TUBULAR_MESHING_PATCHES_PIECES_PIECE_MESHER_IMPL_H

#include <CGAL/Tubular_meshing/Patches/pieces/Piece_mesher.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

CGAL_TUBULAR_MESHING_INLINE Piece_mesher::Piece_mesher(const Surface& surface, const Surface_cut& cut,
                                                       const std::vector<Map>& maps, int threads)
    : surface_(surface)
    , cut_(cut)
    , maps_(maps)
    , threads_(threads)
    , curve_points_(cut.curves.size()) {
  if (maps.size() != cut.patches.size())
    throw Input_error("There are " + std::to_string(maps.size()) + " parameterizations of " +
                      std::to_string(cut.patches.size()) + " patches; pass what parameterize_patches() returns.");
  for (size_type c = 0; c < cut.curves.size(); ++c) {
    polylines_.emplace_back();
    for (auto v : cut.curves[c].vertices)
      polylines_.back().push_back(surface.point(v));
    if (cut.curves[c].is_rim())
      rims_.push_back(c);
  }
  pieces_.resize(cut.patches.size() + rims_.size());
  fineness_.assign(pieces_.size(), 1);
}

CGAL_TUBULAR_MESHING_INLINE void Piece_mesher::mesh_finer(const std::vector<size_type>& pieces) {
  const double finer = 0.7;
  std::vector<char> concerned(pieces_.size(), 0);
  for (size_type k : pieces) {
    fineness_[k] *= finer;
    concerned[k] = 1;
  }
  mesh(std::move(concerned));
}

CGAL_TUBULAR_MESHING_INLINE void Piece_mesher::mesh(std::vector<char> concerned) {
  divide_curves(concerned);
  for_each_task(pieces_.size(), threads_, [&](size_type k) {
    if (!concerned[k])
      return;
    pieces_[k] = Piece();
    if (!(is_cap(k) ? mesh_cap(k, pieces_[k]) : mesh_patch(k, pieces_[k])))
      pieces_[k] = Piece();
  });
}

CGAL_TUBULAR_MESHING_INLINE std::size_t Piece_mesher::number_of_refined_pieces() const {
  return size_type(std::count_if(fineness_.begin(), fineness_.end(), [](double f) { return f < 1; }));
}

CGAL_TUBULAR_MESHING_INLINE std::string Piece_mesher::name_of(size_type piece) const {
  return is_cap(piece) ? "the cap of opening " + std::to_string(opening(piece)) : "patch " + std::to_string(piece);
}

CGAL_TUBULAR_MESHING_INLINE std::size_t Piece_mesher::piece_on_the_right(size_type curve) const {
  if (!cut_.curves[curve].is_rim())
    return cut_.curves[curve].right_patch;
  return maps_.size() + size_type(std::lower_bound(rims_.begin(), rims_.end(), curve) - rims_.begin());
}

CGAL_TUBULAR_MESHING_INLINE double Piece_mesher::fineness_of_curve(size_type curve) const {
  return (std::min)(fineness_[cut_.curves[curve].left_patch], fineness_[piece_on_the_right(curve)]);
}

CGAL_TUBULAR_MESHING_INLINE Plane_polygons Piece_mesher::patch_polygons(size_type patch, Piece& piece) const {
  const Map& map = maps_[patch];
  Plane_polygons polygons;
  const auto add_loop = [&](size_type l) {
    const Patch_loop& loop = cut_.patches[patch].loops[l];
    const size_type edges = polylines_[loop.curve].size();
    piece.sides.push_back({loop.curve, loop.forward});
    polygons.emplace_back();
    for (const Curve_position& p : curve_points_[loop.curve])
      polygons.back().push_back(
          map.uv(loop.forward ? map.on_loop_edge(l, p.edge, p.t) : map.on_loop_edge(l, edges - 1 - p.edge, 1 - p.t)));
    if (!loop.forward)
      std::reverse(polygons.back().begin(), polygons.back().end());
  };
  add_loop(map.outer_loop());
  for (size_type l = 0; l < map.number_of_loops(); ++l)
    if (l != map.outer_loop())
      add_loop(l);
  return polygons;
}

CGAL_TUBULAR_MESHING_INLINE Plane_polygons Piece_mesher::cap_polygons(size_type cap, const Cap_chart& chart,
                                                                      Piece& piece) const {
  const size_type rim = rim_of_cap(cap);
  Plane_polygons polygons(1);
  piece.sides.push_back({rim, false});
  for (const Curve_position& p : curve_points_[rim])
    polygons[0].push_back(chart.uv(p.point));
  std::reverse(polygons[0].begin(), polygons[0].end());
  return polygons;
}

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_PATCHES_PIECES_PIECE_MESHER_IMPL_H
