// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PATCH_PROJECTION_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PATCH_PROJECTION_H

#include <CGAL/Tubular_meshing/Rims/rim_corners.h>
#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Nearest points on the patches of a labelled surface and on the rims between them. A planar patch (a cap) is taken as
 * its plane: what is inside its rim stays inside, and planar to rounding. Safe to query from several threads. */
class Patch_projection {
public:
  typedef std::vector<std::int32_t> Patches; // sorted

  Patch_projection(const Surface& surface, Face_patch_map patch) {
    Triangles triangles;
    Segments segments;
    const auto end_of = [&](Surface::Halfedge_index h) { return to_double_point(surface.point(surface.target(h))); };
    for (auto f : surface.faces()) {
      const auto h = surface.halfedge(f);
      triangles[patch[f]].emplace_back(end_of(surface.prev(h)), end_of(h), end_of(surface.next(h)));
    }
    for (auto e : surface.edges()) {
      const auto h = surface.halfedge(e), o = surface.opposite(h);
      if (surface.is_border(e) || patch[surface.face(h)] == patch[surface.face(o)])
        continue;
      const auto patches = std::minmax(patch[surface.face(h)], patch[surface.face(o)]);
      segments[{patches.first, patches.second}].emplace_back(end_of(o), end_of(h));
    }
    build(triangles, segments);
  }

  // The labelled facets of a mesh, interfaces included, and the edges at which facets of different labels meet.
  explicit Patch_projection(const Tetrahedron_store& mesh) {
    const auto point = [&](Tetrahedron_store::Index v) { return to_double_point(mesh.point(v)); };
    Triangles triangles;
    Segments segments;
    for (Tetrahedron_store::Index t = 0; t < mesh.number_of_slots(); ++t)
      for (int i = 0; i < 4; ++i) {
        const auto facet = Tetrahedron_store::facet(t, i);
        if (!mesh.is_alive(t) || mesh.label(facet) == 0 || mesh.other_side(facet) < facet)
          continue; // an interface is seen from both sides
        const auto v = mesh.vertices(facet);
        triangles[mesh.label(facet)].emplace_back(point(v[0]), point(v[1]), point(v[2]));
      }
    mesh.for_each_labelled_edge([&](const auto& ends, const Patches& patches) {
      if (patches.size() > 1)
        segments[patches].emplace_back(point(ends.first), point(ends.second));
    });
    build(triangles, segments);
  }

  Vector_3d to_patch(const Vector_3d& p, std::int32_t patch) const {
    const auto plane = planes_.find(patch);
    if (plane != planes_.end())
      return p - dot(p - plane->second.origin, plane->second.normal) * plane->second.normal;
    const auto tree = patches_.find(patch);
    return tree == patches_.end() ? p : Vector_3d(tree->second.nearest({p.x, p.y, p.z}).point);
  }

  Vector_3d to_rim(const Vector_3d& p, std::int32_t a, std::int32_t b) const {
    return to_rim(p, {(std::min)(a, b), (std::max)(a, b)});
  }
  // The rim at which all of these patches meet, and no others.
  Vector_3d to_rim(const Vector_3d& p, const Patches& patches) const {
    const auto tree = rims_.find(patches);
    return tree == rims_.end() ? p : Vector_3d(tree->second.nearest({p.x, p.y, p.z}).point);
  }

  /* The distance from p to the nearest curved patch, and the point there; `bound`, if none is closer. */
  double distance(const Vector_3d& p, double bound, Vector_3d& nearest) const {
    double bound2 = bound * bound;
    for (const auto& tree : patches_) {
      const auto found = tree.second.nearest({p.x, p.y, p.z}, bound2);
      if (found.index < tree.second.size()) {
        bound2 = found.squared_distance;
        nearest = Vector_3d(found.point);
      }
    }
    return std::sqrt(bound2);
  }

  // Whether p is a vertex that must stay: one at which a rim has a corner.
  bool is_fixed(const Vector_3d& p, int dimension) const {
    return dimension == 1 && corners_.count({p.x, p.y, p.z}) != 0;
  }

private:
  typedef Double_kernel::Triangle_3 Triangle;
  typedef Double_kernel::Segment_3 Segment;
  typedef std::map<std::int32_t, std::vector<Triangle>> Triangles;
  typedef std::map<Patches, std::vector<Segment>> Segments;
  struct Plane {
    Vector_3d origin, normal;
  };

  void build(Triangles& triangles, Segments& segments) {
    for (auto& t : triangles) {
      Plane plane;
      if (is_planar(t.second, plane))
        planes_[t.first] = plane;
      else
        patches_[t.first] = Nearest_tree<Triangle>(std::move(t.second));
    }
    for (auto& s : segments) {
      corners_.merge(rim_corners(s.second));
      rims_[s.first] = Nearest_tree<Segment>(std::move(s.second));
    }
  }

  static bool is_planar(const std::vector<Triangle>& triangles, Plane& plane) {
    Vector_3d normal;
    double extent = 0;
    plane.origin = Vector_3d(triangles.front()[0]);
    for (const Triangle& t : triangles) {
      const Vector_3d a(t[0]), b(t[1]), c(t[2]);
      normal += cross(b - a, c - a);
      extent = (std::max)(extent, norm(a - plane.origin));
    }
    plane.normal = normalized(normal);
    const auto is_off = [&](const Double_kernel::Point_3& p) {
      return std::abs(dot(Vector_3d(p) - plane.origin, plane.normal)) > 1e-7 * extent;
    };
    return std::none_of(triangles.begin(), triangles.end(),
                        [&](const Triangle& t) { return is_off(t[0]) || is_off(t[1]) || is_off(t[2]); });
  }

  std::map<std::int32_t, Plane> planes_;
  std::map<std::int32_t, Nearest_tree<Triangle>> patches_;
  std::map<Patches, Nearest_tree<Segment>> rims_;
  std::set<Double_kernel::Point_3> corners_;
};

/* Says whether a flip on the surface keeps the surface's shape: it may neither fold it nor take it away from the
 * surface it approximates. */
class Surface_flip_guard {
public:
  typedef Tetrahedron_store::Index Index;

  // `keep`: the surface stays as it is.
  Surface_flip_guard(const Tetrahedron_store& store, const Patch_projection& projection, bool keep = false)
      : store_(store)
      , projection_(projection)
      , keep_(keep) {}

  // May the edge ab between the facets abc and abd of a patch become the edge cd?
  bool operator()(Index a, Index b, Index c, Index d, std::int32_t patch) const {
    if (keep_)
      return false;
    const Vector_3d p = store_.point(a), q = store_.point(b), r = store_.point(c), s = store_.point(d);
    const double before = cosine(cross(q - p, r - p), cross(p - q, s - q));
    const double after = cosine(cross(s - r, p - r), cross(r - s, q - s));
    if (after < 0.8 && after < before)
      return false;
    const double deviation = off_surface(0.5 * (r + s), patch);
    return deviation <= (std::max)(0.1 * norm(s - r), off_surface(0.5 * (p + q), patch));
  }

private:
  static double cosine(const Vector_3d& m, const Vector_3d& n) {
    const double product = norm(m) * norm(n);
    return product > 0 ? dot(m, n) / product : -1;
  }
  double off_surface(const Vector_3d& p, std::int32_t patch) const { return norm(projection_.to_patch(p, patch) - p); }

  const Tetrahedron_store& store_;
  const Patch_projection& projection_;
  bool keep_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PATCH_PROJECTION_H
