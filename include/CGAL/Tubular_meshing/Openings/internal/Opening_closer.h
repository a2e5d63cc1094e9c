// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_OPENING_CLOSER_H
#define CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_OPENING_CLOSER_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/Openings/internal/Rim_flattener.h>
#include <CGAL/Tubular_meshing/Rims/planar_cap.h>
#include <CGAL/Tubular_meshing/Rims/trim_by_plane.h>
#include <CGAL/Tubular_meshing/Rims/wall_alignment.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Gives one opening a planar cap. There are two ways to a planar rim: to flatten the one there is, and to trim the tube
 * by a plane a bit further in. The first is tried where the rim sags little; a result counts only if no triangle has
 * folded and the neighbourhood does not intersect itself more than before. */
class Opening_closer {
  typedef Surface::Halfedge_index Halfedge;
  typedef Surface::Face_index Face;

public:
  explicit Opening_closer(Surface& mesh)
      : mesh_(mesh) {}

  /* Updates the site: its cap, its rim, and their shape. */
  void close(Opening_site& site) {
    const Point_3 where = site.shape.center;
    if (!site.is_open()) {
      if (is_nearly_flat(site) && flatten(site))
        return;
      remove_faces(site.cap, mesh_);
      site.cap.clear();
    }
    site.rim = peel_ears(std::move(site.rim), mesh_);
    site.shape = measure_rim(rim_points(site.rim, mesh_));
    // a plane parallel to a rim that lies in the wall would cut the vessel along
    const bool lies_in_wall = alignment_with_wall(site, mesh_) > 0.5;
    const bool sags = !lies_in_wall && site.shape.sag > max_sag * site.shape.radius;
    if ((!sags && flatten(site)) || trim(site) || (sags && flatten(site)))
      return;
    throw Meshing_error("The opening at " + coordinates(where) +
                        " cannot be given a planar rim without folding the wall: cut the surface straight there.");
  }

  /* Fills a hole as it is. */
  void fill(Opening_site& site) {
    site.cap = fill_loop(site.rim, site.shape.plane, mesh_);
    if (site.cap.empty())
      throw Meshing_error("The hole of the wall at " + coordinates(site.shape.center) +
                          " cannot be filled: remove the triangles around it.");
  }

private:
  static constexpr double max_sag = 0.2; // of the radius

  // What bulges more is not pressed into the plane, but replaced.
  bool is_nearly_flat(const Opening_site& site) const {
    for (Face f : site.cap)
      for (auto v : CGAL::vertices_around_face(mesh_.halfedge(f), mesh_))
        if (std::abs(site.shape.plane.height(mesh_.point(v))) > 0.1 * site.shape.radius)
          return false;
    return true;
  }

  // False if this would fold the wall or make the surface intersect itself; then nothing is changed.
  bool flatten(Opening_site& site) {
    const bool was_open = site.is_open();
    if (!was_open && has_ear_behind(site))
      return false;
    Rim_flattener flattener(mesh_, site.shape.plane, site);
    if (!flattener.flatten())
      return false;
    if (was_open)
      site.cap = fill_loop(site.rim, site.shape.plane, mesh_);
    if (!site.cap.empty() && is_sound(site, &flattener)) {
      measure(site);
      return true;
    }
    if (was_open) {
      remove_faces(site.cap, mesh_);
      site.cap.clear();
    }
    flattener.swap_positions();
    return false;
  }

  // First by planes parallel to the rim's; a rim too ragged to have a direction leaves that of the wall behind it.
  bool trim(Opening_site& site) {
    const Rim_shape ragged = site.shape;
    return trim(site, ragged, ragged.plane) || trim(site, ragged, cross_section(site, ragged));
  }

  // Goes further in as long as the result is not sound.
  bool trim(Opening_site& site, const Rim_shape& ragged, const Rim_plane& across) {
    const double reach = 2 * (ragged.reach + 2 * ragged.radius + ragged.sag);
    for (double margin : {0.05, 0.15, 0.4, 0.8, 1.6}) {
      const double depth = deepest(site.rim, across) + margin * ragged.radius;
      const Halfedge border = trim_by_plane(mesh_, Point_3(across.origin() - depth * across.normal()), across.normal(),
                                            site.rim.front(), reach + depth);
      if (border == Surface::null_halfedge())
        continue;
      site.rim.assign(1, border);
      for (Halfedge h = mesh_.next(border); h != border; h = mesh_.next(h))
        site.rim.push_back(h);
      site.rim = peel_ears(std::move(site.rim), mesh_);
      site.shape = measure_rim(rim_points(site.rim, mesh_));
      site.cap = fill_loop(site.rim, site.shape.plane, mesh_);
      if (!site.cap.empty() && is_sound(site, nullptr)) {
        measure(site);
        return true;
      }
      remove_faces(site.cap, mesh_);
      site.cap.clear();
    }
    return false;
  }

  // Perpendicular to the direction in which the faces behind the rim look least.
  Rim_plane cross_section(const Opening_site& site, const Rim_shape& ragged) const {
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    Vector_3 inwards(0, 0, 0); // from the rim to the faces behind it
    for (Face f : wall_around(site)) {
      const Vector_3 n = area_vector(mesh_.halfedge(f), mesh_);
      const double area = std::sqrt(n.squared_length());
      const Eigen::Vector3d e = Eigen::Vector3d(n.x(), n.y(), n.z()) / (ragged.radius * ragged.radius);
      if (area > 0)
        spread += e * e.transpose() * (ragged.radius * ragged.radius / area);
      inwards = inwards + area * (mesh_.point(mesh_.target(mesh_.halfedge(f))) - ragged.plane.origin());
    }
    const Eigen::Vector3d axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
    Vector_3 normal(axis[0], axis[1], axis[2]);
    if (normal * inwards > 0)
      normal = -normal;
    const Vector_3 along = std::abs(axis[0]) < 0.7 ? Vector_3(1, 0, 0) : Vector_3(0, 1, 0);
    return Rim_plane(ragged.plane.origin(), normal, along);
  }

  double deepest(const std::vector<Halfedge>& rim, const Rim_plane& plane) const {
    double depth = 0;
    for (Halfedge h : rim)
      depth = (std::max)(depth, -plane.height(mesh_.point(mesh_.target(h))));
    return depth;
  }

  // A wall face with two edges on the rim would come to lie in the plane.
  bool has_ear_behind(const Opening_site& site) const {
    for (std::size_t i = 0; i < site.rim.size(); ++i)
      if (mesh_.face(mesh_.opposite(site.rim[i])) == mesh_.face(mesh_.opposite(site.rim[(i + 1) % site.rim.size()])))
        return true;
    return false;
  }

  void measure(Opening_site& site) const {
    const Rim_plane plane = site.shape.plane;
    site.shape = Rim_shape();
    site.shape.plane = plane;
    const std::vector<Point_3> rim = rim_points(site.rim, mesh_);
    rim_weights(rim, site.shape.perimeter);
    measure_in_plane(rim, site.shape);
  }

  // --- soundness ---

  bool is_sound(const Opening_site& site, Rim_flattener* flattener) {
    const std::vector<Face> wall = wall_around(site);
    std::vector<Face> all = wall;
    all.insert(all.end(), site.cap.begin(), site.cap.end());
    const std::unordered_set<Face> cap(site.cap.begin(), site.cap.end());
    std::size_t of_cap = 0, of_wall = 0;
    for (const auto& pair : intersections(all))
      ++(cap.count(pair.first) || cap.count(pair.second) ? of_cap : of_wall);
    if (of_cap > 0)
      return false;
    if (of_wall == 0 || flattener == nullptr)
      return true; // trimming does not move the wall
    flattener->swap_positions();
    const std::size_t before = intersections(wall).size();
    flattener->swap_positions();
    return of_wall <= before;
  }

  std::vector<std::pair<Face, Face>> intersections(const std::vector<Face>& faces) const {
    std::vector<std::pair<Face, Face>> pairs;
    Polygon_mesh_processing::self_intersections(faces, mesh_, std::back_inserter(pairs));
    return pairs;
  }

  // The faces connected to the rim within a ball that holds the cap.
  std::vector<Face> wall_around(const Opening_site& site) const {
    Rim_shape shape = site.shape;
    for (const Point_3& p : rim_points(site.rim, mesh_))
      shape.reach = (std::max)(shape.reach, point_distance(p, shape.center));
    const double radius = 1.3 * shape.reach;
    std::unordered_set<Face> visited(site.cap.begin(), site.cap.end());
    visited.insert(Surface::null_face());
    std::vector<Face> faces;
    for (Halfedge rim : site.rim)
      for (Halfedge h : CGAL::halfedges_around_target(rim, mesh_))
        if (visited.insert(mesh_.face(h)).second)
          faces.push_back(mesh_.face(h));
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (Halfedge h : CGAL::halfedges_around_face(mesh_.halfedge(faces[i]), mesh_))
        if (point_distance(mesh_.point(mesh_.target(h)), shape.center) < radius) {
          const Face next = mesh_.face(mesh_.opposite(h));
          if (visited.insert(next).second)
            faces.push_back(next);
        }
    return faces;
  }

  Surface& mesh_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_OPENING_CLOSER_H
