// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_INTERNAL_SURFACE_QUAD_PIECE_MESHER_H
#define CGAL_TUBULAR_MESHING_QUADS_INTERNAL_SURFACE_QUAD_PIECE_MESHER_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/Quads/elliptic_grid.h>
#include <CGAL/Tubular_meshing/Quads/internal/annular/Curve_chains.h>
#include <CGAL/Tubular_meshing/Quads/internal/surface/Quad_surface_improver.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Patch_quadrangulator.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Sheet.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/Plane/Metric_tensor_2.h>
#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Chart.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Remeshed_piece.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* How a piece got its faces. */
enum class Quad_piece_kind { grid, unstructured, unstructured_for_grid, cap };

/* Meshes the pieces of a cut surface with quads, each on its own: the patches and, after them, the caps, these with
 * triangles unless quads are wanted. Each can be meshed again with smaller sizes. */
template <class Size> class Quad_piece_mesher {
public:
  typedef CGAL::Surface_mesh<Point_3> Surface;
  typedef Patch_parameterization Map;
  typedef typename Map::Point_2 Point_2;
  typedef Remeshed_piece Piece;
  typedef std::vector<Curve_position> Curve_points;
  typedef std::size_t size_type;
  static constexpr bool makes_quads = true;

  Quad_piece_mesher(const Surface& surface, const Surface_cut& cut, const std::vector<Map>& maps, const Size& size,
                    bool quad_caps, int threads)
      : surface_(surface)
      , cut_(cut)
      , maps_(maps)
      , size_(size)
      , quad_caps_(quad_caps)
      , threads_(threads)
      , chains_(surface, cut, maps, size) {
    for (size_type c = 0; c < cut.curves.size(); ++c)
      if (cut.curves[c].is_rim())
        rims_.push_back(c);
    pieces_.resize(cut.patches.size() + rims_.size());
    kinds_.resize(pieces_.size());
    fineness_.assign(pieces_.size(), 1);
  }

  void mesh_all() { mesh(std::vector<char>(pieces_.size(), 1)); }

  /* Meshes some pieces finer, and with them their curves, all along the branches, and the pieces beside these. */
  void mesh_finer(const std::vector<size_type>& pieces) {
    const double finer = 0.7;
    std::vector<char> concerned(pieces_.size(), 0);
    for (size_type k : pieces) {
      fineness_[k] *= finer;
      concerned[k] = 1;
    }
    mesh(std::move(concerned));
  }

  /* Raises the worst quads of a surface made of the pieces. Returns the pieces where quads turn over even so. */
  std::vector<size_type> improve(Remeshed_surface& result) const {
    Quad_surface_improver improver(result, surface_, cut_);
    improver.run();
    return improver.folded_patches();
  }

  const std::vector<Piece>& pieces() const { return pieces_; }
  const std::vector<Quad_piece_kind>& kinds() const { return kinds_; }
  const std::vector<Curve_points>& curve_points() const { return curve_points_; }

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
  static constexpr double good_enough = 0.3; // η of a grid

  size_type rim_of_cap(size_type piece) const { return rims_[piece - maps_.size()]; }
  size_type piece_on_the_right(size_type c) const {
    if (!cut_.curves[c].is_rim())
      return cut_.curves[c].right_patch;
    return maps_.size() + size_type(std::lower_bound(rims_.begin(), rims_.end(), c) - rims_.begin());
  }

  void mesh(std::vector<char> concerned) {
    std::vector<double> fineness;
    for (size_type c = 0; c < cut_.curves.size(); ++c)
      fineness.push_back((std::min)(fineness_[cut_.curves[c].left_patch], fineness_[piece_on_the_right(c)]));
    std::vector<Curve_points> points = chains_.divide(fineness);
    curve_points_.resize(points.size());
    for (size_type c = 0; c < points.size(); ++c)
      if (points[c].size() != curve_points_[c].size()) {
        curve_points_[c] = std::move(points[c]);
        concerned[cut_.curves[c].left_patch] = concerned[piece_on_the_right(c)] = 1;
      }
    for_each_task(pieces_.size(), threads_, [&](size_type k) {
      if (concerned[k])
        mesh(k);
    });
  }

  void mesh(size_type k) {
    Piece& piece = pieces_[k];
    const double f = fineness_[k];
    const auto size = [&](const Point_3& p) { return f * size_(p); };
    try {
      piece = Piece();
      if (is_cap(k))
        mesh_cap(rim_of_cap(k), size, piece);
      else
        mesh_patch(k, size, piece);
    } catch (const Input_error&) { // loops that touch in the plane
      piece = Piece();
    }
    if (is_cap(k))
      kinds_[k] = Quad_piece_kind::cap;
  }

  template <class Piece_size> void mesh_patch(size_type k, const Piece_size& size, Piece& piece) {
    kinds_[k] = Quad_piece_kind::unstructured;
    if (!chains_.is_tube(k))
      return make_unstructured(k, size, piece);
    kinds_[k] = Quad_piece_kind::grid;
    try {
      make_grid(k, size, piece);
      if (least_eta(piece) >= good_enough)
        return;
    } catch (const Error&) { // folded, or too wound
      piece = Piece();
    }
    Piece other;
    make_unstructured(k, size, other);
    if (other.empty() || least_eta(other) <= least_eta(piece))
      return;
    piece = std::move(other);
    kinds_[k] = Quad_piece_kind::unstructured_for_grid;
  }

  // (14); 0 without quads.
  double least_eta(const Piece& piece) const {
    std::vector<Vector_3d> points;
    for (const auto& side : piece.sides) {
      const size_type n = curve_points_[side.curve].size();
      for (size_type i = 0; i < n; ++i)
        points.emplace_back(curve_points_[side.curve][side.forward ? i : n - 1 - i].point);
    }
    for (const Point_3& p : piece.inner_points)
      points.emplace_back(p);
    double least = piece.quads.empty() ? 0 : 1;
    for (const auto& q : piece.quads)
      least = (std::min)(least, quad_eta({points[q[0]], points[q[1]], points[q[2]], points[q[3]]}));
    return least;
  }

  template <class Piece_size> void make_unstructured(size_type k, const Piece_size& size, Piece& piece) const {
    const auto polygons = patch_polygons(maps_[k], cut_, k, curve_points_, piece);
    const Patch_sheet sheet(maps_[k]);
    const auto metric = [&](const Patch_location& at) { return maps_[k].induced_metric(at, size(maps_[k].point(at))); };
    const Patch_chart<decltype(metric)> chart(maps_[k], metric);
    fill(sheet, chart, polygons, false, piece);
  }

  template <class Piece_size> void make_grid(size_type k, const Piece_size& size, Piece& piece) const {
    std::array<std::vector<Patch_location>, 2> ends;
    for (size_type l = 0; l < 2; ++l) {
      const Patch_loop& loop = cut_.patches[k].loops[l];
      ends[l] = on_loop(maps_[k], l, loop, cut_.curves[loop.curve].vertices.size(), curve_points_[loop.curve]);
      piece.sides.push_back({loop.curve, loop.forward});
    }
    const Elliptic_grid grid = elliptic_grid(maps_[k], ends, size);
    const size_type n = grid.columns, last = grid.rows * n;
    piece.inner_points.assign(grid.points.begin() + std::ptrdiff_t(n), grid.points.begin() + std::ptrdiff_t(last));
    for (auto q : grid.quads()) {
      for (size_type& v : q)
        v = v < n ? v : v < last ? v + n : n + grid.ends[v - last];
      piece.quads.push_back(q);
    }
  }

  template <class Piece_size> void mesh_cap(size_type rim, const Piece_size& size, Piece& piece) const {
    std::vector<Point_3> points;
    for (auto v : cut_.curves[rim].vertices)
      points.push_back(surface_.point(v));
    const auto metric = [&](const Point_3& p, const Vector_3d&, const Vector_3d&) {
      return Metric_tensor_2::isotropic(size(p));
    };
    typedef Cap_chart<Point_2, decltype(metric)> Chart;
    const Chart chart(points, metric);
    const auto polygons = cap_polygons(chart, rim, curve_points_[rim], piece);
    if (!quad_caps_ || !fill(Cap_sheet<Chart, Point_2>(chart), chart, polygons, true, piece))
      triangulate_piece(chart, embedding_of(chart), polygons, true, piece);
  }

  // False if there are no quads alone.
  template <class Sheet, class Chart, class Polygons>
  static bool fill(const Sheet& sheet, const Chart& chart, const Polygons& polygons, bool turn, Piece& piece) {
    Patch_quadrangulator<Sheet, Chart, Point_2> quadrangulator(sheet, chart, polygons);
    if (!quadrangulator.run())
      return false;
    const Quad_patch& mesh = quadrangulator.mesh();
    std::vector<size_type> number(mesh.places.size());
    for (size_type v = 0; v < number.size(); ++v)
      if (mesh.is_fixed(int(v))) {
        number[v] = v;
      } else if (mesh.valence(int(v)) > 0) {
        const Vector_3d& p = mesh.places[v].point;
        number[v] = mesh.on_loops + piece.inner_points.size();
        piece.inner_points.emplace_back(p.x, p.y, p.z);
      }
    for (int q = 0; q < int(mesh.quads.size()); ++q)
      if (mesh.is_alive(q)) {
        std::array<size_type, 4> quad;
        for (size_type i = 0; i < 4; ++i)
          quad[i] = number[size_type(mesh.quad(q)[turn ? 3 - i : i])];
        piece.quads.push_back(quad);
      }
    return true;
  }

  const Surface& surface_;
  const Surface_cut& cut_;
  const std::vector<Map>& maps_;
  const Size& size_;
  const bool quad_caps_;
  const int threads_;
  const Curve_chains<Size> chains_;
  std::vector<size_type> rims_; // the curves with caps
  std::vector<Curve_points> curve_points_;
  std::vector<Piece> pieces_;
  std::vector<Quad_piece_kind> kinds_;
  std::vector<double> fineness_; // of pieces: what their size is multiplied by
};

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_QUADS_INTERNAL_SURFACE_QUAD_PIECE_MESHER_H
