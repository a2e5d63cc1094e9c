// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_INTERNAL_SURFACE_QUAD_PIECE_MESHER_H
#define CGAL_TUBULAR_MESHING_QUADS_INTERNAL_SURFACE_QUAD_PIECE_MESHER_H

#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/Quads/elliptic_grid.h>
#include <CGAL/Tubular_meshing/Quads/internal/annular/Curve_chains.h>
#include <CGAL/Tubular_meshing/Quads/internal/surface/Quad_surface_improver.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Patch_quadrangulator.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Sheet.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/Plane/Metric_tensor_2.h>
#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Chart.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Piece_mesher.h>
#include <CGAL/Tubular_meshing/Plane/triangulate_polygons.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* How a piece got its faces. */
enum class Quad_piece_kind { grid, unstructured, unstructured_for_grid, cap };

/* Meshes the pieces of a cut surface with quads; the caps with triangles unless quads are wanted. The points of some
 * curves may be given. */
class Quad_piece_mesher final : public Piece_mesher {
public:
  Quad_piece_mesher(const Surface& surface, const Surface_cut& cut, const std::vector<Map>& maps, Length_function size,
                    bool quad_caps, int threads, std::vector<Curve_points> given = {})
      : Piece_mesher(surface, cut, maps, threads)
      , size_(size)
      , quad_caps_(quad_caps)
      , given_(std::move(given))
      , chains_(surface, cut, maps, size)
      , kinds_(pieces_.size(), Quad_piece_kind::cap) {}

  std::vector<size_type> improve(Remeshed_surface& result, const std::vector<size_type>&) const override {
    Quad_surface_improver improver(result, surface_, cut_);
    improver.run();
    return improver.folded_patches();
  }

  const std::vector<Quad_piece_kind>& kinds() const { return kinds_; }

protected:
  // A curve changes with all those along its branches.
  void divide_curves(std::vector<char>& concerned) override {
    std::vector<double> fineness;
    for (size_type c = 0; c < cut_.curves.size(); ++c)
      fineness.push_back(fineness_of_curve(c));
    std::vector<Curve_points> points = chains_.divide(fineness);
    for (size_type c = 0; c < given_.size(); ++c)
      if (!given_[c].empty())
        points[c] = given_[c];
    for (size_type c = 0; c < points.size(); ++c)
      if (points[c].size() != curve_points_[c].size()) {
        curve_points_[c] = std::move(points[c]);
        concerned[cut_.curves[c].left_patch] = concerned[piece_on_the_right(c)] = 1;
      }
  }

  bool mesh_patch(size_type k, Piece& piece) override {
    kinds_[k] = Quad_piece_kind::unstructured;
    if (fineness_[k] < least_fineness_of_quads)
      return make_triangles(k, piece);
    if (!chains_.is_tube(k))
      return make_unstructured(k, piece) && (piece.empty() || covers(k, piece) || make_triangles(k, piece));
    kinds_[k] = Quad_piece_kind::grid;
    if (make_grid(k, piece) && !covers(k, piece))
      piece = Piece();
    if (least_eta(piece) >= good_grid)
      return true;
    Piece other;
    if (!make_unstructured(k, other))
      return false;
    if (!other.empty() && least_eta(other) > least_eta(piece)) {
      piece = std::move(other);
      kinds_[k] = Quad_piece_kind::unstructured_for_grid;
    }
    return piece.empty() || covers(k, piece) || make_triangles(k, piece);
  }

  bool mesh_cap(size_type k, Piece& piece) override {
    const auto metric = [&](const Point_3& p, const Vector_3d&, const Vector_3d&) {
      return Metric_tensor_2::isotropic(size_of(k, p));
    };
    const Cap_chart chart(polylines_[rim_of_cap(k)], metric);
    const Plane_polygons polygons = cap_polygons(k, chart, piece);
    if (quad_caps_) {
      if (!bound_a_domain(polygons))
        return false;
      if (fill(Cap_sheet(chart), chart, polygons, true, piece))
        return true;
    }
    return triangulate(chart, true, polygons, true, piece);
  }

private:
  static constexpr double good_grid = 0.3; // η
  // Where quads still meet each other when they have been made finer so often, triangles come next: quads take long.
  static constexpr double least_fineness_of_quads = 0.4;

  double size_of(size_type k, const Point_3& p) const { return fineness_[k] * size_(p); }

  static bool bound_a_domain(const Plane_polygons& polygons) {
    std::string problem;
    return bool(triangulate_polygons(polygons, problem));
  }

  std::vector<Vector_3d> points_of(const Piece& piece) const {
    std::vector<Vector_3d> points;
    for (const auto& side : piece.sides) {
      const size_type n = curve_points_[side.curve].size();
      for (size_type i = 0; i < n; ++i)
        points.emplace_back(curve_points_[side.curve][side.forward ? i : n - 1 - i].point);
    }
    for (const Point_3& p : piece.inner_points)
      points.emplace_back(p);
    return points;
  }

  // Whether no point of the patch is further than a mesh size from the quads. The map makes a sac so small that the lines
  // of a grid, which follow the loops, or of an unstructured mesh may pass it by.
  bool covers(size_type k, const Piece& piece) const {
    const std::vector<Vector_3d> points = points_of(piece);
    const auto at = [&](size_type v) { return to_double_point(points[v]); };
    std::vector<Double_kernel::Triangle_3> triangles;
    for (const auto& q : piece.quads) {
      triangles.emplace_back(at(q[0]), at(q[1]), at(q[2]));
      triangles.emplace_back(at(q[0]), at(q[2]), at(q[3]));
    }
    const Nearest_tree<Double_kernel::Triangle_3> tree(std::move(triangles));
    const auto& patch = maps_[k].patch().points;
    return std::all_of(patch.begin(), patch.end(), [&](const auto& p) {
      const double h = size_of(k, p);
      return tree.nearest(to_double_point(p), h * h).index < tree.size();
    });
  }

  // (14); 0 without quads.
  double least_eta(const Piece& piece) const {
    const std::vector<Vector_3d> points = points_of(piece);
    double least = piece.quads.empty() ? 0 : 1;
    for (const auto& q : piece.quads)
      least = (std::min)(least, quad_eta({points[q[0]], points[q[1]], points[q[2]], points[q[3]]}));
    return least;
  }

  // False if the loops touch each other in the plane.
  bool make_unstructured(size_type k, Piece& piece) const {
    const Plane_polygons polygons = patch_polygons(k, piece);
    if (!bound_a_domain(polygons))
      return false;
    const Map& map = maps_[k];
    const Patch_sheet sheet(map);
    const auto metric = [&](const Patch_location& at) { return map.induced_metric(at, size_of(k, map.point(at))); };
    const Patch_chart chart(map, metric);
    fill(sheet, chart, polygons, false, piece);
    return true;
  }

  // Triangles reach into what the map makes small: they are placed where its peaks are.
  bool make_triangles(size_type k, Piece& piece) const {
    piece = Piece();
    const Map& map = maps_[k];
    const auto metric = [&](const Patch_location& at) { return map.induced_metric(at, size_of(k, map.point(at))); };
    const Plane_polygons polygons = patch_polygons(k, piece);
    return triangulate(Patch_chart(map, metric), true, polygons, false, piece);
  }

  // False if there is none, as the patch is too wound, say.
  bool make_grid(size_type k, Piece& piece) const {
    Elliptic_grid grid;
    try {
      grid =
          elliptic_grid(maps_[k], chains_.on_loops(k, curve_points_), [&](const Point_3& p) { return size_of(k, p); });
    } catch (const Meshing_error&) { // its cells are folded, or it cannot be unrolled
      return false;
    } catch (const Input_error&) { // points are not in the order of their loop
      return false;
    }
    for (const Patch_loop& loop : cut_.patches[k].loops)
      piece.sides.push_back({loop.curve, loop.forward});
    const size_type n = grid.columns, last = grid.rows * n;
    piece.inner_points.assign(grid.points.begin() + std::ptrdiff_t(n), grid.points.begin() + std::ptrdiff_t(last));
    for (auto q : grid.quads()) {
      for (size_type& v : q)
        v = v < n ? v : v < last ? v + n : n + grid.ends[v - last];
      piece.quads.push_back(q);
    }
    return true;
  }

  // False if there are no quads alone.
  static bool fill(const Sheet_over_plane& sheet, const Chart& chart, const Plane_polygons& polygons, bool turn,
                   Piece& piece) {
    Patch_quadrangulator quadrangulator(sheet, chart, polygons);
    if (!quadrangulator.run())
      return false;
    const Quad_patch& mesh = quadrangulator.mesh();
    std::vector<size_type> number(mesh.places.size());
    for (size_type v = 0; v < number.size(); ++v)
      if (mesh.is_fixed(int(v))) {
        number[v] = v;
      } else if (mesh.valence(int(v)) > 0) {
        number[v] = mesh.on_loops + piece.inner_points.size();
        piece.inner_points.push_back(as<Point_3>(mesh.places[v].point));
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

  const Length_function size_;
  const bool quad_caps_;
  const std::vector<Curve_points> given_; // of each curve; empty where it is to be divided
  const Curve_chains chains_;
  std::vector<Quad_piece_kind> kinds_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADS_INTERNAL_SURFACE_QUAD_PIECE_MESHER_H
