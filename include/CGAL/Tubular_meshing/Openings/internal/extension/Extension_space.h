// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_EXTENSION_EXTENSION_SPACE_H
#define CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_EXTENSION_EXTENSION_SPACE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Openings/internal/extension/Extension_profile.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/cgal_compatibility.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

typedef CGAL::AABB_tree<Aabb_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Surface>>> Wall_tree;

/* How far an extension may reach, as a height of its profile, and what stands there. */
struct Extension_limit {
  static constexpr std::size_t none = std::size_t(-1), wall = std::size_t(-2);
  double height = 0;
  std::size_t obstacle = none; ///< none, the wall, or the number of another extension
};

constexpr double extension_clearance = 1.05; // of the radius: what keeps clear of so wide a tube is clear of it
constexpr double extension_step = 0.5;       // in radii

/* A piece of the tube that has to be free for an extension: a prism around it, from one height to another. */
class Extension_prism {
  typedef Kernel::Triangle_3 Triangle;

public:
  Extension_prism(const Extension_profile& profile, double from, double to)
      : profile_(profile)
      , from_(from)
      , to_(to) {}

  /* Whether a mesh has a vertex in it, or crosses its sides or its top. `tree` holds the faces of the mesh. */
  bool meets(const Surface& mesh, const Wall_tree& tree) const {
    CGAL::Bbox_3 box;
    for (int i = 0; i < sides; ++i)
      box += corner(i, from_).bbox() + corner(i, to_).bbox();
    std::vector<Surface::Face_index> near;
    tree.all_intersected_primitives(box, std::back_inserter(near));
    if (near.empty())
      return false;
    for (auto f : near)
      for (auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
        if (contains(mesh.point(v)))
          return true;
    for (int i = 0; i < sides; ++i) {
      const Point_3 a = corner(i, from_), b = corner(i + 1, from_), c = corner(i + 1, to_), d = corner(i, to_);
      if (tree.do_intersect(Triangle(a, b, c)) || tree.do_intersect(Triangle(a, c, d)) ||
          tree.do_intersect(Triangle(d, c, profile_.axis_point(to_))))
        return true;
    }
    return false;
  }

private:
  static constexpr int sides = 12;

  Point_3 corner(int i, double height) const {
    const double angle = 2 * CGAL_PI * i / sides;
    const double wide = extension_clearance / std::cos(CGAL_PI / sides) * profile_.radius();
    return profile_.axis().in_space({wide * std::cos(angle), wide * std::sin(angle)}) +
           profile_.radius() * height * profile_.axis().normal();
  }

  bool contains(const Point_3& p) const {
    const auto q = profile_.axis().in_plane(p);
    const double height = profile_.axis().height(p);
    return height > from_ * profile_.radius() && height < to_ * profile_.radius() &&
           std::hypot(q[0], q[1]) < extension_clearance * profile_.radius();
  }

  const Extension_profile& profile_;
  const double from_, to_;
};

/* The height up to which a tube slightly wider than the extension does not meet the wall, in steps. */
inline Extension_limit free_of_wall(const Extension_profile& profile, const Surface& mesh, const Wall_tree& wall) {
  double from = profile.highest() + 0.1;
  while (from < profile.end()) {
    const double to = (std::min)(from + extension_step, profile.end());
    if (Extension_prism(profile, from, to).meets(mesh, wall))
      return {from, Extension_limit::wall};
    from = to;
  }
  return {profile.end(), Extension_limit::none};
}

/* The squared distance of two segments. */
inline double squared_segment_distance(const Vector_3d& p, const Vector_3d& u, const Vector_3d& q, const Vector_3d& v) {
  const Vector_3d w = p - q;
  const double a = dot(u, u), b = dot(u, v), c = dot(v, v), d = dot(u, w), e = dot(v, w);
  auto clamped = [](double x) { return (std::min)(1., (std::max)(0., x)); };
  const double det = a * c - b * b;
  double s = det > 1e-12 * a * c ? clamped((b * e - c * d) / det) : 0;
  const double t = c > 0 ? clamped((b * s + e) / c) : 0;
  s = a > 0 ? clamped((b * t - d) / a) : 0;
  return squared_norm(w + s * u + (-t) * v);
}

/* Lets extensions that come near each other grow together, a step of their radius each in turn, until the next step
 * would bring two too close: what is left of the limits. Expected O(m log m) in their number. */
class Extension_growth {
public:
  Extension_growth(const std::vector<Extension_profile>& profiles, const std::vector<bool>& wanted,
                   std::vector<Extension_limit>& limits)
      : profiles_(profiles)
      , limits_(limits)
      , near_(profiles.size()) {
    find_neighbors(wanted);
    std::vector<double> height(profiles.size());
    std::vector<std::size_t> growing;
    for (std::size_t i = 0; i < profiles.size(); ++i)
      if (wanted[i]) {
        height[i] = near_[i].empty() ? limits[i].height : (std::min)(profiles[i].highest(), limits[i].height);
        if (!near_[i].empty())
          growing.push_back(i);
      }
    while (!growing.empty()) {
      std::vector<std::size_t> still_growing;
      for (std::size_t i : growing) {
        const double next = (std::min)(height[i] + extension_step, limits_[i].height);
        const std::size_t other = first_too_near(i, next, height);
        if (other != Extension_limit::none) {
          limits_[i] = {height[i], other};
          continue;
        }
        height[i] = next;
        if (next < limits_[i].height)
          still_growing.push_back(i);
      }
      growing.swap(still_growing);
    }
  }

private:
  typedef CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t> Box;

  void find_neighbors(const std::vector<bool>& wanted) {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < profiles_.size(); ++i)
      if (wanted[i]) {
        const double r = extension_clearance * profiles_[i].radius();
        const CGAL::Bbox_3 b = profiles_[i].axis_point(0).bbox() + profiles_[i].axis_point(limits_[i].height).bbox();
        boxes.emplace_back(
            CGAL::Bbox_3(b.xmin() - r, b.ymin() - r, b.zmin() - r, b.xmax() + r, b.ymax() + r, b.zmax() + r), i);
      }
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
      near_[a.info()].push_back(b.info());
      near_[b.info()].push_back(a.info());
    });
    for (auto& n : near_)
      std::sort(n.begin(), n.end());
  }

  std::size_t first_too_near(std::size_t i, double next, const std::vector<double>& height) const {
    for (std::size_t j : near_[i]) {
      const double allowed = extension_clearance * (profiles_[i].radius() + profiles_[j].radius());
      const Vector_3d p(profiles_[i].axis_point(height[i])), q(profiles_[j].axis_point(0));
      const Vector_3d u = Vector_3d(profiles_[i].axis_point(next)) - p;
      const Vector_3d v = Vector_3d(profiles_[j].axis_point(height[j])) - q;
      // those whose openings are close may begin closer than that, as long as they part
      const double distance = std::sqrt(squared_segment_distance(p, u, q, v));
      const double before = std::sqrt(squared_segment_distance(p, Vector_3d(), q, v));
      if (distance < allowed && distance < before - 1e-6 * allowed)
        return j;
    }
    return Extension_limit::none;
  }

  const std::vector<Extension_profile>& profiles_;
  std::vector<Extension_limit>& limits_;
  std::vector<std::vector<std::size_t>> near_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_EXTENSION_EXTENSION_SPACE_H
