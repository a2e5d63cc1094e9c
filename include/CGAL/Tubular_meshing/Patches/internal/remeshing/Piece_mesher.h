// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_PIECE_MESHER_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_PIECE_MESHER_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Chart.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Curve_divider.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Curve_gaps.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Remeshed_piece.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* Meshes the pieces of a cut surface, each on its own: the patches and, after them, the caps. Each can be meshed again
 * with smaller sizes. `Sizes` tells what is wanted: Isotropic_sizes or Metric_sizes. */
template <class Sizes> class Piece_mesher {
public:
  typedef CGAL::Surface_mesh<Point_3> Surface;
  typedef Patch_parameterization Map;
  typedef typename Map::Point_2 Point_2;
  typedef Remeshed_piece Piece;
  typedef std::vector<Curve_position> Curve_points;
  typedef std::size_t size_type;
  static constexpr bool makes_quads = false;

  Piece_mesher(const Surface& surface, const Surface_cut& cut, const std::vector<Map>& maps, const Sizes& sizes,
               bool even, int threads)
      : cut_(cut)
      , maps_(maps)
      , sizes_(sizes)
      , even_(even)
      , threads_(threads)
      , polylines_(polylines_of(surface, cut))
      , gaps_(cut, polylines_)
      , curve_points_(cut.curves.size()) {
    for (size_type c = 0; c < cut.curves.size(); ++c)
      if (cut.curves[c].is_rim())
        rims_.push_back(c);
    pieces_.resize(cut.patches.size() + rims_.size());
    fineness_.assign(pieces_.size(), 1);
  }

  void mesh_all() {
    std::vector<size_type> curves(curve_points_.size()), pieces(pieces_.size());
    std::iota(curves.begin(), curves.end(), size_type(0));
    std::iota(pieces.begin(), pieces.end(), size_type(0));
    mesh(curves, pieces);
  }

  /* Meshes some pieces finer, and with them their curves and the pieces beyond these. */
  void mesh_finer(const std::vector<size_type>& pieces) {
    const double finer = 0.7;
    std::vector<size_type> curves, concerned = pieces;
    for (size_type k : pieces) {
      fineness_[k] *= finer;
      for (size_type c : curves_of(k))
        curves.push_back(c);
    }
    sort_and_unite(curves);
    for (size_type c : curves)
      for (size_type k : {cut_.curves[c].left_patch, piece_on_the_right(c)})
        concerned.push_back(k);
    sort_and_unite(concerned);
    mesh(curves, concerned);
  }

  /* A piece whose loops touch each other in the plane, since they are divided too coarsely, has no triangles. */
  const std::vector<Piece>& pieces() const { return pieces_; }
  const std::vector<Curve_points>& curve_points() const { return curve_points_; }

  // What triangles are judged by.
  auto shape() const { return sizes_.shape(); }

  bool is_cap(size_type piece) const { return piece >= maps_.size(); }
  // The label of the opening that a piece is the cap of; 0 for a patch.
  int opening(size_type piece) const { return is_cap(piece) ? cut_.curves[rim_of_cap(piece)].opening : 0; }
  size_type number_of_refined_pieces() const {
    return size_type(std::count_if(fineness_.begin(), fineness_.end(), [](double f) { return f < 1; }));
  }
  std::string name_of(size_type piece) const {
    return is_cap(piece) ? "the cap of opening " + std::to_string(opening(piece)) : "patch " + std::to_string(piece);
  }

private:
  // The longest edge in a gap, relative to its width: with 2, the worst triangle that fits has a gamma_T of 0.68.
  static constexpr double size_in_gap = 1.5;

  static std::vector<std::vector<Point_3>> polylines_of(const Surface& surface, const Surface_cut& cut) {
    std::vector<std::vector<Point_3>> polylines;
    for (const auto& curve : cut.curves) {
      polylines.emplace_back();
      for (auto v : curve.vertices)
        polylines.back().push_back(surface.point(v));
    }
    return polylines;
  }

  static void sort_and_unite(std::vector<size_type>& v) {
    std::sort(v.begin(), v.end());
    v.erase(std::unique(v.begin(), v.end()), v.end());
  }

  size_type rim_of_cap(size_type piece) const { return rims_[piece - maps_.size()]; }
  size_type piece_on_the_right(size_type c) const {
    if (!cut_.curves[c].is_rim())
      return cut_.curves[c].right_patch;
    return maps_.size() + size_type(std::lower_bound(rims_.begin(), rims_.end(), c) - rims_.begin());
  }
  std::vector<size_type> curves_of(size_type piece) const {
    std::vector<size_type> curves;
    if (is_cap(piece))
      curves.push_back(rim_of_cap(piece));
    else
      for (const Patch_loop& loop : cut_.patches[piece].loops)
        curves.push_back(loop.curve);
    return curves;
  }

  void mesh(const std::vector<size_type>& curves, const std::vector<size_type>& pieces) {
    for_each_task(curves.size(), threads_, [&](size_type i) { divide(curves[i]); });
    for_each_task(pieces.size(), threads_, [&](size_type i) { mesh(pieces[i]); });
  }

  void divide(size_type c) {
    const size_type fewest = 6; // a tube, not a prism
    const double f = (std::min)(fineness_[cut_.curves[c].left_patch], fineness_[piece_on_the_right(c)]);
    const auto size = [&](const Curve_position& at) {
      const double h = f * sizes_.along_curve(c, at), least = 0.1 * h;
      return (std::max)(least, size_in_gap * gaps_.gap(c, at.point, h / size_in_gap));
    };
    const Curve_divider divider(polylines_[c], size, cut_.curves[c].is_rim());
    curve_points_[c] = divider.divide(polylines_[c], fewest, even_);
  }

  void mesh(size_type k) {
    Piece& piece = pieces_[k];
    piece = Piece();
    try {
      if (is_cap(k))
        mesh_cap(rim_of_cap(k), fineness_[k], piece);
      else
        mesh_patch(k, fineness_[k], piece);
    } catch (const Input_error&) { // loops that touch in the plane
      piece.triangles.clear();
    }
  }

  void mesh_patch(size_type k, double fineness, Piece& piece) const {
    const auto metric = [&](const Patch_location& at) { return sizes_.on_patch(k, at, fineness); };
    const Patch_chart<decltype(metric)> chart(maps_[k], metric);
    const auto polygons = patch_polygons(maps_[k], cut_, k, curve_points_, piece);
    triangulate_piece(chart, sizes_.embedding(chart), polygons, false, piece);
  }

  void mesh_cap(size_type rim, double fineness, Piece& piece) const {
    const auto metric = [&](const Point_3& p, const Vector_3d& first, const Vector_3d& second) {
      return sizes_.in_plane(p, first, second, fineness);
    };
    const Cap_chart<Point_2, decltype(metric)> chart(polylines_[rim], metric);
    const auto polygons = cap_polygons(chart, rim, curve_points_[rim], piece);
    triangulate_piece(chart, sizes_.embedding(chart), polygons, true, piece);
  }

  const Surface_cut& cut_;
  const std::vector<Map>& maps_;
  const Sizes& sizes_;
  const bool even_;
  const int threads_;
  const std::vector<std::vector<Point_3>> polylines_; // the curves
  const Curve_gaps gaps_;
  std::vector<size_type> rims_; // the curves with caps
  std::vector<Curve_points> curve_points_;
  std::vector<Piece> pieces_;
  std::vector<double> fineness_; // of pieces: what their sizes are multiplied by
};

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_PIECE_MESHER_H
