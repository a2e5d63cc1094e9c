// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_TRIANGLE_PIECE_MESHER_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_TRIANGLE_PIECE_MESHER_H

#include <CGAL/Tubular_meshing/Patches/internal/remeshing/Surface_sizes.h>
#include <CGAL/Tubular_meshing/Patches/internal/remeshing/Triangle_improver.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Chart.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Curve_divider.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Curve_gaps.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Piece_mesher.h>
#include <CGAL/Tubular_meshing/base/Box_tree.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Meshes the pieces of a cut surface with triangles. */
class Triangle_piece_mesher final : public Piece_mesher {
public:
  Triangle_piece_mesher(const Surface& surface, const Surface_cut& cut, const std::vector<Map>& maps,
                        const Surface_sizes& sizes, bool even, int threads)
      : Piece_mesher(surface, cut, maps, threads)
      , sizes_(sizes)
      , even_(even)
      , gaps_(cut, polylines_) {}

  std::vector<size_type> improve(Remeshed_surface& result, const std::vector<size_type>& piece_of_face) const override {
    improve_shapes(result, piece_of_face);
    return patches_turned_over(result);
  }

  bool may_smooth() const override { return true; }

protected:
  void divide_curves(std::vector<char>& concerned) override {
    std::vector<size_type> curves;
    for (size_type c = 0; c < cut_.curves.size(); ++c)
      if (concerned[cut_.curves[c].left_patch] || concerned[piece_on_the_right(c)])
        curves.push_back(c);
    for (size_type c : curves)
      concerned[cut_.curves[c].left_patch] = concerned[piece_on_the_right(c)] = 1;
    for_each_task(curves.size(), threads_, [&](size_type i) { divide(curves[i]); });
  }

  bool mesh_patch(size_type k, Piece& piece) override {
    const auto metric = [&](const Patch_location& at) { return sizes_.on_patch(k, at, fineness_[k]); };
    const Patch_chart chart(maps_[k], metric);
    return triangulate(chart, sizes_.are_isotropic(), patch_polygons(k, piece), false, piece);
  }

  bool mesh_cap(size_type k, Piece& piece) override {
    const auto metric = [&](const Point_3& p, const Vector_3d& first, const Vector_3d& second) {
      return sizes_.in_plane(p, first, second, fineness_[k]);
    };
    const Cap_chart chart(polylines_[rim_of_cap(k)], metric);
    return triangulate(chart, sizes_.are_isotropic(), cap_polygons(k, chart, piece), true, piece);
  }

private:
  void improve_shapes(Remeshed_surface& result, const std::vector<size_type>& piece_of_face) const {
    Surface& surface = result.surface;
    Triangle_improver improver(surface, sizes_.shape());
    const std::vector<Face> bad = improver.bad_triangles();
    if (bad.empty())
      return;
    std::vector<char> is_fixed(surface.number_of_vertices(), 0);
    for (size_type c : rims_)
      for (Vertex v : result.curves[c])
        is_fixed[size_type(v)] = 1;
    const auto may_move = [&](Vertex v) {
      return !is_fixed[size_type(v)] && result.patch_of_face[surface.face(surface.halfedge(v))] >= 0;
    };
    const auto may_flip = [&](Halfedge h) {
      if (!sizes_.are_isotropic() && result.patch_of_face[surface.face(h)] < 0)
        return false;
      return piece_of_face[size_type(surface.face(h))] == piece_of_face[size_type(surface.face(surface.opposite(h)))];
    };
    std::vector<char> has_bad(cut_.patches.size(), 0);
    for (Face f : bad)
      if (result.patch_of_face[f] >= 0)
        has_bad[size_type(result.patch_of_face[f])] = 1;
    improver.improve(bad, old_triangles(surface_, cut_, has_bad), may_move, may_flip);
  }

  /* Patches of triangles that face away from where the surface next to their middle does, and are off it: long ones that
   * pass from one side of a vessel to the other, where a bend or a coarse surface makes the map's scale jump. They are
   * looked for at sharp edges alone, which each of them has. What lies on the surface is turned as that is. */
  std::vector<size_type> patches_turned_over(const Remeshed_surface& result) const {
    const double near = 0.1; // of the longest edge
    const std::vector<Face> suspects = faces_at_sharp_edges(result);
    if (suspects.empty())
      return {};
    std::vector<char> marked(pieces_.size(), 0);
    for (Face f : suspects)
      marked[size_type(result.patch_of_face[f])] = 1;
    const Box_tree<3> around = boxes_with_nearest(result.surface, suspects);
    const Nearest_tree<Double_kernel::Triangle_3> old =
        old_triangles(surface_, cut_, marked, [&](const Double_kernel::Triangle_3& t) {
          bool is_near = false;
          around.for_each_overlapping(box_of(t), [&](std::uint32_t) { is_near = true; });
          return is_near;
        });
    std::fill(marked.begin(), marked.end(), 0);
    for (Face f : suspects) {
      const auto c = corners(result.surface, f);
      const auto nearest = old.nearest(as<Double_kernel::Point_3>(middle(c)));
      if (nearest.index >= old.size())
        continue; // of corners that have been moved off the surface
      const auto& t = old.shape(nearest.index);
      const Vector_3d p(t.vertex(0)), q(t.vertex(1)), r(t.vertex(2));
      const bool is_on_surface = nearest.squared_distance < near * near * squared_length_of_longest(c);
      if (!is_on_surface && dot(cross(c[1] - c[0], c[2] - c[0]), cross(q - p, r - p)) < 0)
        marked[size_type(result.patch_of_face[f])] = 1;
    }
    std::vector<size_type> patches;
    for (size_type k = 0; k < marked.size(); ++k)
      if (marked[k])
        patches.push_back(k);
    return patches;
  }

  /* Round the middles of faces: what is nearest of the old surface is in there, as their corners are on it. */
  static Box_tree<3> boxes_with_nearest(const Surface& surface, const std::vector<Face>& faces) {
    std::vector<Box_tree<3>::Box> boxes;
    std::vector<Box_tree<3>::Place> centers;
    for (Face f : faces) {
      const auto c = corners(surface, f);
      const Vector_3d m = middle(c);
      const double reach = std::sqrt(squared_length_of_longest(c));
      boxes.emplace_back();
      boxes.back().add({m.x - reach, m.y - reach, m.z - reach});
      boxes.back().add({m.x + reach, m.y + reach, m.z + reach});
      centers.push_back({m.x, m.y, m.z});
    }
    return Box_tree<3>(std::move(boxes), centers);
  }
  static Box_tree<3>::Box box_of(const Double_kernel::Triangle_3& t) {
    Box_tree<3>::Box box;
    for (int k = 0; k < 3; ++k)
      box.add({t[k].x(), t[k].y(), t[k].z()});
    return box;
  }

  // Of patches, on both sides; in order, each once.
  static std::vector<Face> faces_at_sharp_edges(const Remeshed_surface& result) {
    const double sharp = 0.5; // the cosine between the normals
    const Surface& surface = result.surface;
    std::vector<Face> faces;
    for (auto e : surface.edges()) {
      if (surface.is_border(e))
        continue;
      const Halfedge h = surface.halfedge(e);
      const Face f = surface.face(h), g = surface.face(surface.opposite(h));
      if (result.patch_of_face[f] >= 0 && result.patch_of_face[g] >= 0 &&
          dot(normal(surface, f), normal(surface, g)) < sharp)
        faces.insert(faces.end(), {f, g});
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
  }

  static std::array<Vector_3d, 3> corners(const Surface& surface, Face f) {
    const Halfedge h = surface.halfedge(f);
    return {Vector_3d(surface.point(surface.source(h))), Vector_3d(surface.point(surface.target(h))),
            Vector_3d(surface.point(surface.target(surface.next(h))))};
  }
  static Vector_3d middle(const std::array<Vector_3d, 3>& c) { return (1. / 3) * (c[0] + c[1] + c[2]); }
  static double squared_length_of_longest(const std::array<Vector_3d, 3>& c) {
    return (std::max)({squared_norm(c[1] - c[0]), squared_norm(c[2] - c[1]), squared_norm(c[0] - c[2])});
  }
  static Vector_3d normal(const Surface& surface, Face f) {
    const auto c = corners(surface, f);
    return normalized(cross(c[1] - c[0], c[2] - c[0]));
  }

  // The longest edge in a gap, relative to its width: with 2, the worst triangle that fits has a gamma_T of 0.68.
  static constexpr double size_in_gap = 1.5;

  void divide(size_type c) {
    const size_type fewest = 6; // a tube, not a prism
    const double f = fineness_of_curve(c);
    const auto size = [&](const Curve_position& at) {
      const double h = f * sizes_.along_curve(c, at), least = 0.1 * h;
      return (std::max)(least, size_in_gap * gaps_.gap(c, at.point, h / size_in_gap));
    };
    const Curve_divider divider(polylines_[c], size, cut_.curves[c].is_rim());
    curve_points_[c] = divider.divide(polylines_[c], fewest, even_);
  }

  const Surface_sizes& sizes_;
  const bool even_;
  const Curve_gaps gaps_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_TRIANGLE_PIECE_MESHER_H
