// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PIECES_PIECE_MESHER_H
#define CGAL_TUBULAR_MESHING_PATCHES_PIECES_PIECE_MESHER_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/Patches/Patch_report.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Chart.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Curve_divider.h>
#include <CGAL/Tubular_meshing/Plane/Plane_triangulation.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A piece of the surface in its new faces. Its points are those of its curves, one curve after another, then those
 * inside. */
struct Remeshed_piece {
  struct Side {
    std::size_t curve;
    bool forward;
  };
  std::vector<Side> sides; // in the order of their points
  std::vector<Point_3> inner_points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::array<std::size_t, 4>> quads;

  bool empty() const { return triangles.empty() && quads.empty(); }
};

/* Meshes the pieces of a cut surface, each on its own: the patches and, after them, the caps. Each can be meshed again
 * with smaller sizes. What faces they get is up to the class derived. */
class Piece_mesher {
public:
  typedef Patch_parameterization Map;
  typedef Remeshed_piece Piece;
  typedef std::vector<Curve_position> Curve_points;

  /* Throws Input_error if there is not one parameterization a patch. */
  Piece_mesher(const Surface& surface, const Surface_cut& cut, const std::vector<Map>& maps, int threads)
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
  virtual ~Piece_mesher() = default;
  Piece_mesher(const Piece_mesher&) = delete;
  Piece_mesher& operator=(const Piece_mesher&) = delete;

  void mesh_all() { mesh(std::vector<char>(pieces_.size(), 1)); }

  /* Meshes some pieces finer, and with them their curves and the pieces beyond these. */
  void mesh_finer(const std::vector<size_type>& pieces) {
    const double finer = 0.7;
    std::vector<char> concerned(pieces_.size(), 0);
    for (size_type k : pieces) {
      fineness_[k] *= finer;
      concerned[k] = 1;
    }
    mesh(std::move(concerned));
  }

  /* Raises the worst faces of a surface made of the pieces, of which `piece_of_face` tells where each face is from.
   * Returns the pieces where faces are turned over even so. */
  virtual std::vector<size_type> improve(Remeshed_surface& result,
                                         const std::vector<size_type>& piece_of_face) const = 0;

  /* Whether points may be moved where faces cross each other at any size. */
  virtual bool may_smooth() const { return false; }

  /* A piece whose loops touch each other in the plane, since they are divided too coarsely, has no faces. */
  const std::vector<Piece>& pieces() const { return pieces_; }
  const std::vector<Curve_points>& curve_points() const { return curve_points_; }

  bool is_cap(size_type piece) const { return piece >= maps_.size(); }
  // The label of the opening that a piece is the cap of; 0 for a patch.
  int opening(size_type piece) const { return is_cap(piece) ? cut_.curves[rim_of_cap(piece)].opening : 0; }
  Patch_report report() const {
    Patch_report report = patch_report(cut_, maps_);
    report.refined_patches =
        size_type(std::count_if(fineness_.begin(), fineness_.end(), [](double f) { return f < 1; }));
    return report;
  }
  std::string name_of(size_type piece) const {
    return is_cap(piece) ? "the cap of opening " + std::to_string(opening(piece)) : "patch " + std::to_string(piece);
  }

protected:
  /* Sets curve_points_ again: of the curves beside concerned pieces at least, and marks the pieces beside all others
   * that it changes. */
  virtual void divide_curves(std::vector<char>& concerned) = 0;
  /* Fills an empty piece. False if its loops touch each other in the plane. Several threads call it at once. */
  virtual bool mesh_patch(size_type patch, Piece& piece) = 0;
  virtual bool mesh_cap(size_type cap, Piece& piece) = 0;

  size_type rim_of_cap(size_type piece) const { return rims_[piece - maps_.size()]; }
  size_type piece_on_the_right(size_type curve) const {
    if (!cut_.curves[curve].is_rim())
      return cut_.curves[curve].right_patch;
    return maps_.size() + size_type(std::lower_bound(rims_.begin(), rims_.end(), curve) - rims_.begin());
  }
  // What the size on a curve is multiplied by.
  double fineness_of_curve(size_type curve) const {
    return (std::min)(fineness_[cut_.curves[curve].left_patch], fineness_[piece_on_the_right(curve)]);
  }

  /* The loops of a patch in the plane, the outer one first; the piece gets its sides. */
  Plane_polygons patch_polygons(size_type patch, Piece& piece) const {
    const Map& map = maps_[patch];
    Plane_polygons polygons;
    const auto add_loop = [&](size_type l) {
      const Patch_loop& loop = cut_.patches[patch].loops[l];
      piece.sides.push_back({loop.curve, loop.forward});
      polygons.emplace_back();
      for (const Patch_location& at : on_loop(map, l, loop, polylines_[loop.curve].size(), curve_points_[loop.curve]))
        polygons.back().push_back(map.uv(at));
    };
    add_loop(map.outer_loop());
    for (size_type l = 0; l < map.number_of_loops(); ++l)
      if (l != map.outer_loop())
        add_loop(l);
    return polygons;
  }
  /* The points of a rim in the plane of its cap, counterclockwise; the piece gets its side. */
  Plane_polygons cap_polygons(size_type cap, const Cap_chart& chart, Piece& piece) const {
    const size_type rim = rim_of_cap(cap);
    Plane_polygons polygons(1);
    piece.sides.push_back({rim, false});
    for (const Curve_position& p : curve_points_[rim])
      polygons[0].push_back(chart.uv(p.point));
    std::reverse(polygons[0].begin(), polygons[0].end());
    return polygons;
  }

  /* Fills polygons of the plane with triangles, which are judged in space, or in the metric. A rim runs with the wall
   * on its left: seen along its normal, as the cap's chart is, the cap is turned inwards, which `turn` sets right.
   * False if the polygons do not bound a domain, as they touch each other. */
  static bool triangulate(const Chart& chart, bool judged_in_space, const Plane_polygons& polygons, bool turn,
                          Piece& piece) {
    auto plane = chart.mesh(polygons, judged_in_space);
    if (!plane)
      return false;
    std::size_t on_boundary = 0;
    for (const auto& polygon : polygons)
      on_boundary += polygon.size();
    for (std::size_t i = on_boundary; i < plane->points.size(); ++i)
      piece.inner_points.push_back(chart.point(plane->points[i]));
    if (turn)
      for (auto& t : plane->triangles)
        std::swap(t[1], t[2]);
    piece.triangles = std::move(plane->triangles);
    return true;
  }

  const Surface& surface_;
  const Surface_cut& cut_;
  const std::vector<Map>& maps_;
  const int threads_;
  std::vector<std::vector<Point_3>> polylines_; // the curves
  std::vector<size_type> rims_;                 // those with caps
  std::vector<Curve_points> curve_points_;
  std::vector<Piece> pieces_;
  std::vector<double> fineness_; // of pieces: what their sizes are multiplied by

private:
  void mesh(std::vector<char> concerned) {
    divide_curves(concerned);
    for_each_task(pieces_.size(), threads_, [&](size_type k) {
      if (!concerned[k])
        return;
      pieces_[k] = Piece();
      if (!(is_cap(k) ? mesh_cap(k, pieces_[k]) : mesh_patch(k, pieces_[k])))
        pieces_[k] = Piece();
    });
  }
};

/* The steps of remesh_patches(), and those of quadrangulate_patches(): meshes the pieces of a cut surface and joins
 * them. Where the outcome is no surface, as pieces touch themselves or each other in meshes that are too coarse for
 * them, the pieces concerned are meshed again, finer.
 *
 * What still crosses where it is twice as fine is smoothed, if the mesher allows it. Throws Meshing_error if they meet
 * each other even where they are eight times finer. */
Remeshed_surface mesh_by_pieces(Piece_mesher& mesher);

// Their numbers.
inline std::vector<std::size_t> marked(const std::vector<char>& marks) {
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < marks.size(); ++k)
    if (marks[k])
      result.push_back(k);
  return result;
}

/* The triangles of the marked patches of a cut surface, and of their neighbours, for which counts(triangle) holds. */
template <class Counts>
Nearest_tree<Double_kernel::Triangle_3> old_triangles(const Surface& surface, const Surface_cut& cut,
                                                      const std::vector<char>& is_marked, const Counts& counts) {
  std::vector<char> is_near = is_marked;
  for (std::size_t k = 0; k < cut.patches.size(); ++k)
    if (is_marked[k])
      for (const Patch_loop& loop : cut.patches[k].loops)
        if (loop.neighbour != Cut_curve::none)
          is_near[loop.neighbour] = 1;
  std::vector<Double_kernel::Triangle_3> triangles;
  for (std::size_t k = 0; k < cut.patches.size(); ++k)
    if (is_near[k])
      for (auto f : cut.patches[k].faces) {
        const auto h = surface.halfedge(f);
        const Double_kernel::Triangle_3 t(to_double_point(surface.point(surface.source(h))),
                                          to_double_point(surface.point(surface.target(h))),
                                          to_double_point(surface.point(surface.target(surface.next(h)))));
        if (counts(t))
          triangles.push_back(t);
      }
  return Nearest_tree<Double_kernel::Triangle_3>(std::move(triangles));
}

/* All of them, to move vertices on. */
inline Nearest_tree<Double_kernel::Triangle_3> old_triangles(const Surface& surface, const Surface_cut& cut,
                                                             const std::vector<char>& is_marked) {
  return old_triangles(surface, cut, is_marked, [](const auto&) { return true; });
}

} // namespace CGAL::Tubular_meshing::internal

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Patches/pieces/Piece_mesher_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_PATCHES_PIECES_PIECE_MESHER_H
