// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_SLIDING_SURFACE_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_SLIDING_SURFACE_H

#include <CGAL/Tubular_meshing/Rims/rim_corners.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Where a vertex of a mesh may go: anywhere (3), on a patch (2), on the rim between two patches (1), nowhere (0). */
struct Slide {
  std::uint8_t dimension = 3;
  std::int32_t index = 0; // of the patch, or of the rim
};

/* The patches of a labelled surface and the rims between them, for vertices that slide on them. A planar patch, as an
 * opening's cap, is taken as its plane: what is within its rim stays there. Safe to query from several threads. */
class Sliding_surface {
public:
  struct Place {
    Vector_3d point;
    Vector_3d direction; // of unit length: the patch's normal, or along the rim; none where nothing was found
  };

  Sliding_surface(const Surface& surface, Face_patch_map patch) {
    std::map<int, std::vector<Triangle>> triangles;
    std::map<Labels, std::vector<Segment>> segments;
    const auto end_of = [&](Halfedge h) { return to_double_point(surface.point(surface.target(h))); };
    for (Face f : surface.faces()) {
      const Halfedge h = surface.halfedge(f);
      triangles[patch[f]].emplace_back(end_of(surface.prev(h)), end_of(h), end_of(surface.next(h)));
    }
    for (Edge e : surface.edges()) {
      const Halfedge h = surface.halfedge(e), o = surface.opposite(h);
      if (surface.is_border(e) || patch[surface.face(h)] == patch[surface.face(o)])
        continue;
      segments[std::minmax({patch[surface.face(h)], patch[surface.face(o)]})].emplace_back(end_of(o), end_of(h));
    }
    for (auto& t : triangles) {
      patch_index_[t.first] = std::int32_t(patches_.size());
      patches_.emplace_back(std::move(t.second));
    }
    for (auto& s : segments) {
      corners_.merge(rim_corners(s.second));
      rim_index_[s.first] = std::int32_t(rims_.size());
      rims_.emplace_back(std::move(s.second));
    }
  }

  Slide on_patch(int label) const { return slide(2, patch_index_, label); }
  Slide on_rim(int a, int b) const { return slide(1, rim_index_, Labels(std::minmax({a, b}))); }

  // Whether a rim has a corner there, at which a mesh should keep its vertex.
  bool is_rim_corner_at(const Vector_3d& p) const { return corners_.count({p.x, p.y, p.z}) != 0; }

  // The nearest place closer than a bound to p.
  Place nearest(const Slide& slide, const Vector_3d& p,
                double squared_bound = (std::numeric_limits<double>::infinity)()) const {
    if (slide.dimension == 1)
      return nearest_on_rim(rims_[std::size_t(slide.index)], p, squared_bound);
    const Patch& patch = patches_[std::size_t(slide.index)];
    if (patch.is_planar)
      return {p - dot(p - patch.origin, patch.normal) * patch.normal, patch.normal};
    const auto found = patch.tree.nearest(to_double_point(p), squared_bound);
    if (found.index == patch.tree.size())
      return {p, Vector_3d()};
    const Triangle& t = patch.tree.shape(found.index);
    return {Vector_3d(found.point),
            normalized(cross(Vector_3d(t[1]) - Vector_3d(t[0]), Vector_3d(t[2]) - Vector_3d(t[0])))};
  }

private:
  typedef Double_kernel::Triangle_3 Triangle;
  typedef Double_kernel::Segment_3 Segment;
  typedef Nearest_tree<Segment> Rim;
  typedef std::pair<int, int> Labels; // the lower first

  struct Patch {
    bool is_planar = false;
    Vector_3d origin, normal; // of the plane
    Nearest_tree<Triangle> tree;

    explicit Patch(std::vector<Triangle> triangles) {
      find_plane(triangles);
      if (!is_planar)
        tree = Nearest_tree<Triangle>(std::move(triangles));
    }

    void find_plane(const std::vector<Triangle>& triangles) {
      double extent = 0;
      origin = Vector_3d(triangles.front()[0]);
      for (const Triangle& t : triangles) {
        const Vector_3d a(t[0]), b(t[1]), c(t[2]);
        normal += cross(b - a, c - a);
        extent = (std::max)(extent, norm(a - origin));
      }
      normal = normalized(normal);
      const double tolerance = 1e-7 * extent;
      is_planar = std::all_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
        return std::abs(dot(Vector_3d(t[0]) - origin, normal)) <= tolerance &&
               std::abs(dot(Vector_3d(t[1]) - origin, normal)) <= tolerance &&
               std::abs(dot(Vector_3d(t[2]) - origin, normal)) <= tolerance;
      });
    }
  };

  template <class Map> static Slide slide(std::uint8_t dimension, const Map& map, const typename Map::key_type& key) {
    const auto found = map.find(key);
    Slide result;
    result.dimension = found == map.end() ? 0 : dimension;
    result.index = found == map.end() ? 0 : found->second;
    return result;
  }

  static Place nearest_on_rim(const Rim& rim, const Vector_3d& p, double squared_bound) {
    const auto found = rim.nearest(to_double_point(p), squared_bound);
    if (found.index == rim.size())
      return {p, Vector_3d()};
    const Segment& s = rim.shape(found.index);
    return {Vector_3d(found.point), normalized(Vector_3d(s.target()) - Vector_3d(s.source()))};
  }

  std::map<int, std::int32_t> patch_index_;
  std::map<Labels, std::int32_t> rim_index_;
  std::vector<Patch> patches_;
  std::vector<Rim> rims_;
  std::set<Double_kernel::Point_3> corners_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_SLIDING_SURFACE_H
