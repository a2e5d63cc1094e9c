// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PRESERVING_INPUT_SURFACE_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PRESERVING_INPUT_SURFACE_H

#include <CGAL/Tubular_meshing/base/Corner_tree.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The volume inside of a closed surface of triangles and quads; a quad counts as the bilinear surface through its
 * corners does, which is four triangles around the mean of them. */
inline double enclosed_volume(const Surface& surface) {
  if (surface.number_of_vertices() == 0)
    return 0;
  const Vector_3d origin(surface.point(*surface.vertices_begin())); // near by, against cancellation
  double six_volumes = 0;
  for (auto f : surface.faces()) {
    std::vector<Vector_3d> p;
    Vector_3d middle;
    for (auto v : surface.vertices_around_face(surface.halfedge(f))) {
      p.push_back(Vector_3d(surface.point(v)) - origin);
      middle += p.back();
    }
    middle = (1. / double(p.size())) * middle;
    for (std::size_t i = 0; i < p.size(); ++i)
      six_volumes += dot(middle, cross(p[i], p[(i + 1) % p.size()]));
  }
  return six_volumes / 6;
}

/* The surface that a mesh was made from: how far it is from the mesh's facets and rims. */
class Input_surface {
public:
  struct Opening {
    Vector_3d normal; // outward, of unit length
    double area;
    Nearest_tree<Double_kernel::Segment_3> rim;
  };

  Input_surface(const Surface& surface, Face_patch_map patch, int threads) {
    for_each_task(2, threads, [&](std::size_t which) {
      if (which == 0) {
        collect_wall(surface, patch, threads);
      } else {
        volume_ = enclosed_volume(surface);
        collect_openings(surface, patch);
      }
    });
  }

  double volume() const { return volume_; }
  // The opening of a label, or none.
  const Opening* opening(int label) const {
    const auto found = openings_.find(label);
    return found == openings_.end() ? nullptr : &found->second;
  }

  // Where questions are about: points in a ball, and the wall up to a bound from them.
  struct Surroundings {
    Vector_3d center;
    double radius, bound;

    bool hold(const Surroundings& s) const { return norm(s.center - center) + s.radius <= radius && s.bound <= bound; }
    Surroundings larger_by(double part) const { return {center, (1 + part) * radius, (1 + part) * bound}; }
  };

  /* The triangles of the wall that may be nearest to points in some surroundings: found once, they serve for many questions,
   * also where the points have moved a little. */
  class Wall_nearby {
  public:
    // Looks for them unless what is known holds here.
    void move_to(const Surroundings& here, const Input_surface& input) {
      const double slack = 0.2; // more than facets move by
      if (!of_.hold(here))
        find(here.larger_by(slack), input);
    }

    /* How far the wall is from x in the ball along the unit vector n, positive in its direction, up to the bound; 0 where
     * it is not found there: what is nearest is another part of the wall then. */
    double distance(const Vector_3d& x, const Vector_3d& n, double bound, const Input_surface& input) const {
      const Double_kernel::Point_3 q = to_double_point(x);
      const double away = norm(x - of_.center);
      double nearest = bound;
      Nearest result{q, bound * bound};
      for (const auto& [d, i] : triangles_) {
        if (d - away > nearest)
          break;
        const Double_kernel::Point_3 p = projection(input.wall_.shape(i), q);
        const double d2 = CGAL::squared_distance(p, q);
        if (d2 < result.squared_distance) {
          result = {p, d2};
          nearest = std::sqrt(d2);
        }
      }
      return nearest < bound ? along(x, n, result) : 0;
    }

  private:
    struct Nearest {
      Double_kernel::Point_3 point;
      double squared_distance;
    };

    static float rounded_down(double d) { return float((1 - 1e-7) * d); }

    void find(const Surroundings& s, const Input_surface& input) {
      of_ = s;
      triangles_.clear();
      double reach = s.bound + s.radius, reach2 = reach * reach;
      input.wall_.for_each_near(to_double_point(s.center), reach2,
                                [&](std::size_t i, const Double_kernel::Triangle_3&, double d2) {
                                  const double d = std::sqrt(d2);
                                  triangles_.emplace_back(rounded_down(d), std::uint32_t(i));
                                  // no further than this from any of its points
                                  reach = (std::min)(reach, d + 2 * s.radius);
                                  reach2 = reach * reach;
                                });
      std::sort(triangles_.begin(), triangles_.end());
      while (!triangles_.empty() && triangles_.back().first > reach)
        triangles_.pop_back();
      triangles_.shrink_to_fit();
    }

    Surroundings of_ = {Vector_3d(), -1, -1};
    std::vector<std::pair<float, std::uint32_t>> triangles_; // distance from the center and number, nearest first
  };

  // The same as Wall_nearby::distance() for the rim of an opening, n in its plane.
  static double distance_to_rim(const Opening& opening, const Vector_3d& x, const Vector_3d& n, double bound) {
    const auto found = opening.rim.nearest(Double_kernel::Point_3(x.x, x.y, x.z), bound * bound);
    return found.index >= opening.rim.size() ? 0 : along(x, n, found);
  }

  /* The point of the wall nearest to x, up to a bound, and where the wall faces to the same side as n; none where what
   * is nearest is another part of the wall. */
  std::optional<Vector_3d> nearest_on_wall(const Vector_3d& x, const Vector_3d& n, double bound) const {
    const auto found = wall_.nearest(to_double_point(x), bound * bound);
    if (found.index >= wall_.size())
      return std::nullopt;
    const Double_kernel::Triangle_3 t = wall_.shape(found.index);
    const Vector_3d normal = normalized(cross(Vector_3d(t[1]) - Vector_3d(t[0]), Vector_3d(t[2]) - Vector_3d(t[0])));
    if (!(dot(normal, n) > 0)) // so large an angle for the sake of creases, where n is between two sides
      return std::nullopt;
    return Vector_3d(found.point);
  }
  // The same for the rim of an opening.
  static std::optional<Vector_3d> nearest_on_rim(const Opening& opening, const Vector_3d& x, double bound) {
    const auto found = opening.rim.nearest(to_double_point(x), bound * bound);
    if (found.index >= opening.rim.size())
      return std::nullopt;
    return Vector_3d(found.point);
  }

private:
  typedef Corner_tree<Double_kernel::Triangle_3> Wall;

  void collect_wall(const Surface& surface, Face_patch_map patch, int threads) {
    std::vector<Double_kernel::Point_3> points(surface.num_vertices());
    for (auto v : surface.vertices())
      points[std::size_t(v)] = to_double_point(surface.point(v));
    std::vector<Wall::Numbers> triangles;
    triangles.reserve(surface.number_of_faces());
    for (auto f : surface.faces())
      if (patch[f] == labels::wall) {
        const auto h = surface.halfedge(f);
        const auto number = [&](Surface::Halfedge_index g) { return Wall::Index(surface.target(g)); };
        const Wall::Numbers t = {number(h), number(surface.next(h)), number(surface.prev(h))};
        if (CGAL::cross_product(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]).squared_length() > 0)
          triangles.push_back(t);
      }
    wall_ = Wall(points, std::move(triangles), threads);
  }

  void collect_openings(const Surface& surface, Face_patch_map patch) {
    std::map<int, Vector_3d> areas;
    std::map<int, std::vector<Double_kernel::Segment_3>> rims;
    for (auto f : surface.faces()) {
      if (patch[f] == labels::wall)
        continue;
      const auto h = surface.halfedge(f);
      const auto point = [&](Surface::Halfedge_index g) -> const Point_3& { return surface.point(surface.target(g)); };
      const Vector_3d a(point(h)), b(point(surface.next(h))), c(point(surface.prev(h)));
      areas[patch[f]] += 0.5 * cross(b - a, c - a);
      for (auto g : surface.halfedges_around_face(h)) {
        const auto beyond = surface.face(surface.opposite(g));
        if (beyond != Surface::null_face() && patch[beyond] == labels::wall)
          rims[patch[f]].emplace_back(to_double_point(point(surface.opposite(g))), to_double_point(point(g)));
      }
    }
    for (auto& r : rims) {
      const Vector_3d& a = areas[r.first];
      openings_[r.first] = Opening{normalized(a), norm(a), Nearest_tree<Double_kernel::Segment_3>(std::move(r.second))};
    }
  }

  /* The nearest point y is seen from x along the surface's own normal there, so the plane through y across y − x is
   * tangent to the surface: where it is met along n. */
  template <class Result> static double along(const Vector_3d& x, const Vector_3d& n, const Result& found) {
    if (!(found.squared_distance > 0))
      return 0;
    const double step = dot(Vector_3d(found.point) - x, n), distance = std::sqrt(found.squared_distance);
    const double steepest = 0.7; // the cosine of the angle between the normals; beyond, it is not this facet's part
    return std::abs(step) < steepest * distance ? 0 : found.squared_distance / step;
  }

  double volume_;
  Wall wall_;
  std::map<int, Opening> openings_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PRESERVING_INPUT_SURFACE_H
