// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_ROUND_END_CUTTER_H
#define CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_ROUND_END_CUTTER_H

#include <CGAL/Tubular_meshing/Openings/Round_end_report.h>
#include <CGAL/Tubular_meshing/Openings/internal/Round_end.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/Rims/trim_by_plane.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Cuts the domes off vessels, by planes. What is removed is only marked so, that indices stay. */
class Round_end_cutter {
  typedef Surface::Vertex_index Vertex;

public:
  explicit Round_end_cutter(Surface& mesh)
      : mesh_(mesh)
      , area_(area_of(mesh)) {}

  /* False, with the mesh as it was, if no plane near the dome's base cuts the vessel in one loop, and takes no more than
   * a share of the surface away. Of what a point names, less goes: it may be no vessel. */
  bool cut(const Round_end& end, Vertex tip, bool is_named, Round_end_report& report) {
    most_of_one_end_ = is_named ? 0.3 : 0.4; // half balls on a vessel as long as wide are a third each
    if (tip == Surface::null_vertex() || mesh_.is_removed(tip))
      return false; // by the cut of another end
    const double r = end.radius();
    const Vector_3 normal = end.direction();
    const double out = room_in_dome(end, tip, normal);
    std::vector<Point_3> origins;
    for (double fraction : {1., 0.5})
      if (out > 0)
        origins.push_back(end.base() + fraction * out * normal);
    origins.push_back(end.base());
    for (double fraction : {0.25, 0.5, 0.75, 1.}) // of a stub that widens like a funnel
      if (point_distance(end.center(), end.base()) > 0.25 * r)
        origins.push_back(end.before_base(fraction));
    for (double further : {0.25, 0.5}) // of a stub so short that what is behind is the other vessel
      origins.push_back(end.center() + further * r * normal);
    for (double back : {0.2, 0.4, 0.7, 1., 1.5, 2.})
      origins.push_back(end.behind_base(back * r));
    for (double room : {1.2, 3.}) // radii beyond the tip; the second for a needle that stands out of the dome
      for (const Point_3& origin : origins)
        if (cut_by(origin, normal, room, end, tip, report))
          return true;
    return false;
  }

private:
  bool cut_by(const Point_3& origin, const Vector_3& normal, double room, const Round_end& end, Vertex tip,
              Round_end_report& report) {
    const double r = end.radius();
    if (!((mesh_.point(tip) - origin) * normal > 0.1 * r))
      return false;
    const double reach = point_distance(mesh_.point(tip), origin) + room * r;
    const double area = area_above(origin, normal, reach, tip);
    if (area > most_of_one_end_ * area_ || cut_area_ + area > most_of_all_ends * area_)
      return false;
    const auto border = trim_by_plane(mesh_, origin, normal, std::vector<Vertex>{tip}, reach);
    if (border == Surface::null_halfedge())
      return false;
    std::vector<Surface::Halfedge_index> rim(1, border);
    for (auto h = mesh_.next(border); h != border; h = mesh_.next(h))
      rim.push_back(h);
    const Rim_shape shape = measure_rim(rim_points(rim, mesh_));
    cut_area_ += area;
    report = Round_end_report{true, shape.center, shape.radius, ""};
    return true;
  }

  static constexpr double most_of_all_ends = 0.75; // of the surface

  static double area_of(const Surface& mesh) {
    double area = 0;
    for (auto f : mesh.faces())
      area += face_area(f, mesh);
    return area;
  }

  static double face_area(Surface::Face_index f, const Surface& mesh) {
    return std::sqrt(area_vector(mesh.halfedge(f), mesh).squared_length());
  }

  // What a cut would take away; of faces that it would split, a share.
  double area_above(const Point_3& origin, const Vector_3& normal, double reach, Vertex tip) const {
    std::unordered_set<Surface::Face_index> faces;
    for (Vertex v : connected_above(origin, normal, reach, tip))
      for (auto f : CGAL::faces_around_target(mesh_.halfedge(v), mesh_))
        if (f != Surface::null_face())
          faces.insert(f);
    std::vector<Surface::Face_index> in_order(faces.begin(), faces.end());
    std::sort(in_order.begin(), in_order.end());
    double area = 0;
    for (auto f : in_order) {
      int above = 0;
      for (Vertex v : CGAL::vertices_around_face(mesh_.halfedge(f), mesh_))
        above += (mesh_.point(v) - origin) * normal > 0 ? 1 : 0;
      area += above / 3. * face_area(f, mesh_);
    }
    return area;
  }

  // How far beyond the base the wall keeps its distance from the axis: not at all in a half ball, but in a blunt end.
  double room_in_dome(const Round_end& end, Vertex tip, const Vector_3& normal) const {
    const double r = end.radius();
    std::vector<std::pair<double, double>> wall; // heights over the base, and distances from the axis
    for (Vertex v : dome(end, tip, normal)) {
      const Vector_3 d = mesh_.point(v) - end.base();
      const double height = d * normal;
      wall.emplace_back(height, std::sqrt((d - height * normal).squared_length()));
    }
    std::sort(wall.begin(), wall.end());
    std::vector<double> near_base;
    for (const auto& w : wall)
      if (w.first < 0.25 * r)
        near_base.push_back(w.second);
    if (near_base.size() < 5)
      return 0;
    std::nth_element(near_base.begin(), near_base.begin() + std::ptrdiff_t(near_base.size() / 2), near_base.end());
    const double wide = near_base[near_base.size() / 2];
    double height = 0; // of the last vertex before the wall turns to the axis
    for (const auto& w : wall) {
      if (w.second < 0.985 * wide)
        break;
      height = w.first;
    }
    return height > 0.3 * r ? height : 0;
  }

  // The vertices above the base that are connected with the tip.
  std::vector<Vertex> dome(const Round_end& end, Vertex tip, const Vector_3& normal) const {
    return connected_above(end.base(), normal, point_distance(mesh_.point(tip), end.base()) + 1.2 * end.radius(), tip);
  }

  // The vertices above a plane, within reach of its origin, that are connected with the tip.
  std::vector<Vertex> connected_above(const Point_3& origin, const Vector_3& normal, double reach, Vertex tip) const {
    std::vector<Vertex> found = {tip};
    std::unordered_set<Vertex> seen = {tip};
    for (std::size_t i = 0; i < found.size(); ++i)
      for (Vertex v : CGAL::vertices_around_target(mesh_.halfedge(found[i]), mesh_)) {
        const Vector_3 d = mesh_.point(v) - origin;
        if (d * normal > 0 && d.squared_length() < reach * reach && seen.insert(v).second)
          found.push_back(v);
      }
    return found;
  }

  Surface& mesh_;
  const double area_;   // of the surface before
  double cut_area_ = 0; // of what has been cut off
  double most_of_one_end_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_ROUND_END_CUTTER_H
