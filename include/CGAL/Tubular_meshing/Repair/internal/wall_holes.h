// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_WALL_HOLES_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_WALL_HOLES_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/Rims/wall_alignment.h>
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

enum class Loop_kind {
  opening,
  possible_opening, ///< taken for one, as nothing says that it is damage
  pinhole,
  torn_wall ///< neither: no flat cap goes over it
};

/* Tells openings, pinholes and torn walls apart. A loop is an opening unless it is damage, that is, small against the
 * lumen behind it; where one cannot tell, it is a possible opening.
 *
 * A rim is an opening's
 * - if it lies across the tube: if the wall stands upright behind it, out to twice its radius (Wall_behind), and at it
 *   (the alignment);
 * - if the wall stands upright at it alone, as at a stub, or at a branch that is cut off flush with the vessel;
 * - if it is plane and the wall leans towards it, as cutting leaves it and missing triangles do not.
 *
 * A loop that lies in the wall is a pinhole if its radius is less than half the local one, which is half the way to the
 * opposite wall; if it has at most six edges, so that it is small against the triangles of the wall; or if it is a
 * crack. One that is plane, round, and of many edges, as if somebody had cut it, is a pinhole only below a tenth of the
 * local radius. What is larger is a possible opening, but for a wide slit, and a loop that reaches along the vessel.
 *
 * The bounds are far from what is found at the openings of real surfaces, coarse and fine: depth 0.77 to 0.91 radii,
 * flatness below 0.31, alignment from -0.13 to 0.24; with as much as 3 % of the triangles damaged depth above 0.5,
 * flatness below 0.4. Branches cut off flush have alignments from -0.01 to 0.67 and no sag, holes left by missing
 * triangles alignments above 0.75 and sags above 0.05 radii. Holes of a wall have depths up to 0.45 or flatness above
 * 0.5, where they are not as large as the vessel; those of one triangle in a coarse vessel have an alignment above 0.7.
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
    const bool lies_across = wall.depth > 0.5 && wall.flatness < 0.42;
    if (lies_across && !is_thin(loop) && (alignment < (has_fewest_edges ? 0.25 : 0.5) || looks_cut(loop)))
      return Loop_kind::opening;
    if (is_raised(loop, alignment))
      return Loop_kind::opening;
    const bool lies_in_wall = wall.flatness > 0.5 || alignment > 0.6 || (wall.depth < 0.45 && wall.flatness > 0.25);
    if (lies_in_wall && is_small(loop, alignment))
      return Loop_kind::pinhole;
    return is_thin(loop) ? Loop_kind::torn_wall : Loop_kind::possible_opening;
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
    return looks_cut(loop) ? ratio < 0.1 : ratio < (alignment > 0.5 ? 0.5 : 0.25);
  }

  // Whether the wall rises, or at least leans, towards the rim.
  static bool is_raised(const Opening_site& loop, double alignment) {
    const double roundness = 4 * CGAL_PI * loop.shape.area / (loop.shape.perimeter * loop.shape.perimeter);
    const bool is_plane = loop.shape.sag < 0.03 * loop.shape.radius;
    return loop.rim.size() > 8 && roundness > 0.6 && alignment < (is_plane ? 0.7 : 0.35);
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
