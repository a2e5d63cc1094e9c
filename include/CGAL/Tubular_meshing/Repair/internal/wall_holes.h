// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_WALL_HOLES_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_WALL_HOLES_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/Repair/internal/wall_behind_loop.h>
#include <CGAL/Tubular_meshing/base/cgal_compatibility.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* How much a border loop lies in the wall: the mean over its edges, by length, of the cosine between the normals of the
 * loop and of the faces behind it. Near 0 at the end of a tube, however oblique, since the wall stands upright on its
 * rim and what leans out on one side leans in on the other; near 1 round a hole of the wall, since the loop continues
 * the faces. Does not depend on the orientation of the mesh. On real vessels and airways the rims of openings stay
 * below 0.22, holes of the wall above 0.8. */
inline double alignment_with_wall(const Opening_site& loop, const Surface& mesh) {
  double sum = 0, perimeter = 0;
  for (auto h : loop.rim) {
    const Vector_3 n = area_vector(mesh.opposite(h), mesh);
    const double area = std::sqrt(n.squared_length());
    if (!(area > 0))
      continue;
    const double length = point_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
    sum += length * (n * loop.shape.plane.normal()) / area;
    perimeter += length;
  }
  return perimeter > 0 ? sum / perimeter : 1;
}

enum class Loop_kind { opening, pinhole, torn_wall };

/* Tells openings, pinholes and torn walls apart.
 *
 * A rim is an opening's if it lies across the tube: if the wall stands upright behind it, out to twice its radius
 * (Wall_behind), and at it (the alignment). A loop that lies in the wall is a pinhole if it is small against the lumen
 * behind it: its radius is less than half the local one, which is half the way to the opposite wall; or if it has at
 * most six edges, so that it is small against the triangles of the wall. A larger one is a torn wall: what is missing
 * there, only the user knows; so is a round and plane hole of many edges, which somebody may have cut; a wide slit; a
 * loop that reaches along the vessel; and one of which the wall around tells neither.
 *
 * The bounds are far from what is found at the openings of real surfaces, coarse and fine: depth 0.77 to 0.91 radii,
 * flatness below 0.31, alignment from -0.13 to 0.24; with as much as 3 % of the triangles damaged depth above 0.5,
 * flatness below 0.4. Holes of a wall have depths up to 0.45 or flatness above 0.5, where they are not as large as the
 * vessel; those of one triangle in a coarse vessel have an alignment above 0.7.
 *
 * The mesh has to be turned outward, and loops that touch to be split. The tree of the faces is built at the first loop
 * that lies in the wall: a clean surface does not pay for it. */
class Loop_classifier {
  typedef CGAL::AABB_face_graph_triangle_primitive<Surface> Primitive;
  typedef CGAL::AABB_tree<Aabb_traits<Kernel, Primitive>> Tree;

public:
  explicit Loop_classifier(const Surface& mesh)
      : mesh_(mesh)
      , surveyor_(mesh) {}

  Loop_kind classify(const Opening_site& loop) {
    if (!(loop.shape.radius > 0))
      return Loop_kind::pinhole; // it encloses nothing
    const bool has_few_edges = loop.rim.size() <= 6;
    const double alignment = alignment_with_wall(loop, mesh_);
    if (is_thin(loop) && !has_few_edges && !is_tiny(loop))
      return Loop_kind::torn_wall; // a wide gap, or a rim with a tear
    if (has_few_edges && alignment > 0.7)
      return Loop_kind::pinhole; // so coarse that the wall behind says nothing
    const Wall_behind wall = surveyor_.survey(loop);
    const bool has_fewest_edges = loop.rim.size() <= 4;
    if (is_thin(loop) && ((is_tiny(loop) && wall.flatness > 0.42) || (has_fewest_edges && wall.depth < 0.3)))
      return Loop_kind::pinhole; // a crack
    if (loop.shape.sag > 3 * loop.shape.radius)
      return Loop_kind::torn_wall;
    if (wall.depth > 0.5 && wall.flatness < 0.42)
      return alignment < (has_fewest_edges ? 0.25 : 0.5) && !is_thin(loop) ? Loop_kind::opening : Loop_kind::torn_wall;
    const bool lies_in_wall = wall.flatness > 0.5 || alignment > 0.6 || (wall.depth < 0.45 && wall.flatness > 0.25);
    return lies_in_wall && is_small(loop, alignment) ? Loop_kind::pinhole : Loop_kind::torn_wall;
  }

  /* The radius of a loop, as a fraction of the lumen's behind it: of half the median way to the opposite wall, along
   * rays that spread by 20 degrees. */
  double size_ratio(const Opening_site& loop) {
    if (!tree_)
      tree_.reset(new Tree(faces(mesh_).begin(), faces(mesh_).end(), mesh_));
    const double perimeter_radius = loop.shape.perimeter / (2 * CGAL_PI);
    std::vector<double> ways;
    for (int i = 0; i < 7; ++i)
      add_way(loop, -loop.shape.plane.normal(), i, perimeter_radius, ways);
    if (ways.size() < 4)
      return (std::numeric_limits<double>::infinity)();
    std::nth_element(ways.begin(), ways.begin() + std::ptrdiff_t(ways.size() / 2), ways.end());
    return 2 * loop.shape.radius / ways[ways.size() / 2];
  }

private:
  bool is_small(const Opening_site& loop, double alignment) {
    if (loop.rim.size() <= 6)
      return true;
    const double ratio = size_ratio(loop);
    return ratio < 0.25 || (ratio < 0.5 && alignment > 0.5 && !looks_cut(loop));
  }

  // Round, plane, and finer than what a few missing triangles leave.
  static bool looks_cut(const Opening_site& loop) {
    return loop.rim.size() > 12 && loop.shape.sag < 0.03 * loop.shape.radius &&
           4 * CGAL_PI * loop.shape.area > 0.94 * loop.shape.perimeter * loop.shape.perimeter;
  }

  // So thin that its own normal means nothing: an ellipse of 10:1 is not.
  static bool is_thin(const Opening_site& loop) {
    return 4 * CGAL_PI * loop.shape.area < 0.2 * loop.shape.perimeter * loop.shape.perimeter;
  }

  // Small against the faces around it.
  bool is_tiny(const Opening_site& loop) const { return loop.shape.radius < 0.35 * edge_length_behind(loop); }

  // The mean length of the edges that lead from the loop into the wall.
  double edge_length_behind(const Opening_site& loop) const {
    double sum = 0, n = 0;
    for (auto rim : loop.rim)
      for (auto h : CGAL::halfedges_around_target(rim, mesh_))
        if (!mesh_.is_border(mesh_.edge(h))) {
          sum += point_distance(mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h)));
          ++n;
        }
    return n > 0 ? sum / n : 0;
  }

  void add_way(const Opening_site& loop, const Vector_3& axis, int i, double radius, std::vector<double>& ways) const {
    Vector_3 direction = axis;
    if (i > 0) {
      const auto p = loop.shape.plane.in_space({std::cos(i * CGAL_PI / 3), std::sin(i * CGAL_PI / 3)});
      direction = direction + 0.36 * (p - loop.shape.plane.origin());
    }
    direction = direction / std::sqrt(direction.squared_length());
    // from a bit behind the loop, past its own ragged edge
    const Point_3 from = loop.shape.center + 0.1 * radius * direction;
    const auto hit = tree_->first_intersected_primitive(Kernel::Ray_3(from, direction));
    if (!hit)
      return;
    const auto h = mesh_.halfedge(*hit);
    const Vector_3 n = area_vector(h, mesh_);
    const double across = n * direction;
    if (across != 0)
      ways.push_back((n * (mesh_.point(mesh_.target(h)) - loop.shape.center)) / across);
  }

  const Surface& mesh_;
  Wall_surveyor surveyor_;
  std::unique_ptr<Tree> tree_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_WALL_HOLES_H
