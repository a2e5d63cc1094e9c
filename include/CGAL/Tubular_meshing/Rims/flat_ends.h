// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_RIMS_FLAT_ENDS_H
#define CGAL_TUBULAR_MESHING_RIMS_FLAT_ENDS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/Rims/cap_facet.h>
#include <CGAL/Tubular_meshing/Rims/disk_rim.h>
#include <CGAL/Tubular_meshing/Rims/wall_at_cap.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* What makes a flat region of a closed surface the end of a tube. All of it is relative to the region's own size. */
struct Flat_end_criteria {
  double sharp_angle;     ///< degrees: the region is bounded by edges at which the surface turns by more
  double min_roundness;   ///< 4 pi area / perimeter^2, 1 for a disk, 0.66 for an ellipse of 3:1
  std::size_t corners;    ///< at least so many, deviations of 8 % of the radius ignored
  double max_wall_cosine; ///< of the mean angle between the region's normal and the faces around it
  bool allows_facets;     ///< whether it may be a facet of a surface of few triangles
};

/* Enough to tell an end from all else by geometry alone: the rectangular sides of coarse tubes have four corners, flat
 * patches of a wall are surrounded by faces of nearly their own direction; and facets of decimated domes are hardly flat. */
inline Flat_end_criteria certain_flat_end() {
  return {25, 0.55, 5, 0.5, false};
}

/* Enough where a centerline ends there; at several angles, for caps that are noisy, or whose rim is blunt. */
inline std::vector<Flat_end_criteria> possible_flat_ends() {
  return {{25, 0.35, 3, 0.75, true}, {40, 0.35, 3, 0.75, true}, {15, 0.35, 3, 0.75, true}};
}

constexpr double max_flat_end_sag = 0.05; // of the radius

class Flat_end_finder {
public:
  /* `inside_out`: whether the faces' normals point into the lumen. */
  Flat_end_finder(const Surface& mesh, bool inside_out)
      : mesh_(mesh)
      , inwards_(inside_out ? 1 : -1)
      , normals_(unit_normals(mesh)) {}

  /* The regions that meet the criteria, in the order of their first faces. Linear in the size of the mesh. */
  std::vector<Opening_site> find(const Flat_end_criteria& criteria) {
    criteria_ = criteria;
    min_cosine_ = std::cos(criteria.sharp_angle * CGAL_PI / 180);
    visited_.assign(normals_.size(), false);
    std::vector<Opening_site> ends;
    for (Face f : mesh_.faces()) {
      if (visited_[std::size_t(f)])
        continue;
      Opening_site region;
      if (collect(f, region.cap) && (find_rim(region) || (absorb_islands(region) && find_rim(region))) &&
          is_flat_end(region))
        ends.push_back(std::move(region));
    }
    return ends;
  }

private:
  bool is_sharp(Face f, Face g) const { return normals_[std::size_t(f)] * normals_[std::size_t(g)] < min_cosine_; }

  // The faces reached from f without passing a sharp edge; false if they cannot be flat, or are next to a border.
  bool collect(Face first, std::vector<Face>& region) {
    bool flat = true;
    visited_[std::size_t(first)] = true;
    std::vector<Face> queue = {first};
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (Halfedge h : CGAL::halfedges_around_face(mesh_.halfedge(queue[i]), mesh_)) {
        const Face g = mesh_.face(mesh_.opposite(h));
        if (g == Surface::null_face()) {
          flat = false;
          continue;
        }
        if (visited_[std::size_t(g)] || is_sharp(queue[i], g))
          continue;
        visited_[std::size_t(g)] = true;
        flat = flat && normals_[std::size_t(first)] * normals_[std::size_t(g)] > 0.5;
        queue.push_back(g);
      }
    if (flat)
      region.swap(queue);
    return flat;
  }

  // Adds what the region encloses and is as flat: facets that noise has tilted. What is reached across the region's
  // boundary is an island if all of it is near the plane, and the outside if a vertex of it is not.
  bool absorb_islands(Opening_site& region) {
    const Rim_plane plane = mean_plane(region.cap);
    const double tolerance = max_flat_end_sag * std::sqrt(area(region.cap) / CGAL_PI);
    std::unordered_set<Face> inside(region.cap.begin(), region.cap.end()), outside;
    outside.insert(Surface::null_face());
    const std::size_t size = region.cap.size();
    for (std::size_t i = 0; i < size; ++i)
      for (Halfedge h : CGAL::halfedges_around_face(mesh_.halfedge(region.cap[i]), mesh_)) {
        const Face first = mesh_.face(mesh_.opposite(h));
        if (inside.count(first) || outside.count(first))
          continue;
        std::unordered_set<Face> visited = {first};
        std::vector<Face> island = {first};
        bool enclosed = true;
        for (std::size_t k = 0; enclosed && k < island.size(); ++k)
          for (Halfedge g : CGAL::halfedges_around_face(mesh_.halfedge(island[k]), mesh_)) {
            const Face next = mesh_.face(mesh_.opposite(g));
            enclosed =
                enclosed && !outside.count(next) && std::abs(plane.height(mesh_.point(mesh_.target(g)))) <= tolerance;
            if (enclosed && !inside.count(next) && visited.insert(next).second)
              island.push_back(next);
          }
        (enclosed ? inside : outside).insert(island.begin(), island.end());
        if (!enclosed)
          continue;
        region.cap.insert(region.cap.end(), island.begin(), island.end());
        for (Face f : island)
          visited_[std::size_t(f)] = true;
      }
    return region.cap.size() > size;
  }

  double area(const std::vector<Face>& faces) const {
    double sum = 0;
    for (Face f : faces)
      sum += std::sqrt(area_vector(mesh_.halfedge(f), mesh_).squared_length());
    return sum;
  }

  // Weighted by area: not all of the rim may be known yet.
  Rim_plane mean_plane(const std::vector<Face>& faces) const {
    const Point_3 o = mesh_.point(mesh_.target(mesh_.halfedge(faces[0])));
    Vector_3 normal(0, 0, 0), offset(0, 0, 0);
    for (Face f : faces) {
      const Vector_3 a = area_vector(mesh_.halfedge(f), mesh_);
      normal = normal + a;
      for (Vertex v : CGAL::vertices_around_face(mesh_.halfedge(f), mesh_))
        offset = offset + (std::sqrt(a.squared_length()) / 3) * (mesh_.point(v) - o);
    }
    normal = normal / std::sqrt(normal.squared_length());
    const Halfedge h = mesh_.halfedge(faces[0]);
    return Rim_plane(o + offset / area(faces), normal, mesh_.point(mesh_.target(h)) - mesh_.point(mesh_.source(h)));
  }

  // Whether the region is a disk bounded by one simple loop.
  bool find_rim(Opening_site& region) const {
    region.rim = rim_of_disk(region.cap, mesh_);
    return !region.rim.empty();
  }

  bool is_flat_end(Opening_site& region) const {
    const std::vector<Point_3> rim = rim_points(region.rim, mesh_);
    region.shape = measure_rim(rim);
    const Rim_shape& s = region.shape;
    if (!(s.radius > 0 && 4 * CGAL_PI * s.area >= criteria_.min_roundness * s.perimeter * s.perimeter &&
          is_flat(region) && number_of_corners(rim, s.center, 0.08 * s.radius) >= criteria_.corners))
      return false;
    const Wall_at_cap wall = wall_at_cap(region, normals_, inwards_, mesh_);
    return wall.stands(max_wall_cosine(region)) && (criteria_.allows_facets || !is_facet(region, wall));
  }

  bool is_flat(const Opening_site& region) const {
    const double tolerance = max_flat_end_sag * region.shape.radius;
    for (Face f : region.cap)
      for (Vertex v : CGAL::vertices_around_face(mesh_.halfedge(f), mesh_))
        if (std::abs(region.shape.plane.height(mesh_.point(v))) > tolerance)
          return false;
    return true;
  }

  double max_wall_cosine(const Opening_site& region) const {
    return is_disk(region) ? (std::max)(criteria_.max_wall_cosine, 0.85) : criteria_.max_wall_cosine;
  }

  // Round all over: then the wall may lean far, as that of a bulb that is cut off wide open does.
  bool is_disk(const Opening_site& region) const {
    const Rim_shape& s = region.shape;
    return 4 * CGAL_PI * s.area >= 0.85 * s.perimeter * s.perimeter &&
           number_of_corners(rim_points(region.rim, mesh_), s.center, 0.08 * s.radius) >= 7;
  }

  const Surface& mesh_;
  const double inwards_;          // the direction into the lumen along a face's normal
  std::vector<Vector_3> normals_; // by face, unit; zero for a degenerate face, which belongs to no region
  std::vector<bool> visited_;
  Flat_end_criteria criteria_;
  double min_cosine_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_RIMS_FLAT_ENDS_H
