// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_RIMS_CREASE_ENDS_H
#define CGAL_TUBULAR_MESHING_RIMS_CREASE_ENDS_H

#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/Rims/cap_facet.h>
#include <CGAL/Tubular_meshing/Rims/disk_rim.h>
#include <CGAL/Tubular_meshing/Rims/wall_at_cap.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The ends of a closed surface that are domed or dished, and meet the wall in a crease: disks that a closed crease
 * bounds, across the vessel. What the disk is like inside does not matter, but for its area.
 *
 * A crease is where the surface turns outward by more than an angle. It closes in a loop that is round, nearly plane,
 * and has five corners at least; the wall goes back from it all around, and rather upright than level; and the disk has
 * at most four times the area that the loop bounds, as has a dome of nearly its own diameter's height. The base of a
 * sac is no such crease, as the surface turns inward there; nor is the outline of a facet, see is_facet(). A crease that is blunt, or a disk that is faceted, may show
 * at one angle and not at another: several are tried.
 */
class Crease_end_finder {
  typedef Surface::Vertex_index Vertex;
  typedef Surface::Halfedge_index Halfedge;
  typedef Surface::Face_index Face;

public:
  /* `inside_out`: whether the faces' normals point into the lumen. */
  Crease_end_finder(const Surface& mesh, bool inside_out)
      : mesh_(mesh)
      , inwards_(inside_out ? 1 : -1)
      , normals_(unit_normals(mesh))
      , areas_(mesh.num_faces(), 0)
      , sharpness_(mesh.num_halfedges(), 0)
      , taken_(mesh.num_faces(), false) {
    for (std::size_t k = 0; k < angles.size(); ++k)
      cosines_[k] = std::cos(angles[k] * CGAL_PI / 180);
    for_each_range(mesh.num_faces(), 0, [&](std::size_t first, std::size_t last) {
      for (std::size_t f = first; f < last; ++f)
        if (!mesh_.is_removed(Face(Surface::size_type(f))))
          measure(Face(Surface::size_type(f)));
    });
    area_ = std::accumulate(areas_.begin(), areas_.end(), 0.);
  }

  /* Ends that have been found already: their caps are not looked at. */
  void take(const std::vector<Opening_site>& sites) {
    for (const Opening_site& site : sites)
      for (Face f : site.cap)
        taken_[std::size_t(f)] = true;
  }

  /* Linear in the size of the mesh (expected, as it hashes). */
  std::vector<Opening_site> find() {
    std::vector<Opening_site> ends;
    for (least_sharpness_ = angles.size(); least_sharpness_ > 0; --least_sharpness_) {
      visited_.assign(mesh_.num_faces(), no_seed);
      std::vector<Opening_site> found;
      for (Face f : mesh_.faces())
        if (visited_[std::size_t(f)] == no_seed && !taken_[std::size_t(f)] && is_at_crease(f)) {
          Opening_site region;
          if (collect(f, region.cap) && is_end(region))
            found.push_back(std::move(region));
        }
      take(found);
      std::move(found.begin(), found.end(), std::back_inserter(ends));
    }
    return ends;
  }

private:
  void measure(Face f) {
    areas_[std::size_t(f)] = std::sqrt(area_vector(mesh_.halfedge(f), mesh_).squared_length());
    for (Halfedge h : CGAL::halfedges_around_face(mesh_.halfedge(f), mesh_))
      sharpness_[std::size_t(h)] = sharpness(f, h);
  }

  // At the edge of h, between its face and the one behind: at how many of the angles there is a crease.
  std::uint8_t sharpness(Face f, Halfedge h) const {
    const Face g = mesh_.face(mesh_.opposite(h));
    if (g == Surface::null_face())
      return 0;
    const double cosine = normals_[std::size_t(f)] * normals_[std::size_t(g)];
    const auto n = std::count_if(cosines_.begin(), cosines_.end(), [cosine](double least) { return cosine < least; });
    if (n == 0)
      return 0;
    const Point_3& beyond = mesh_.point(mesh_.target(mesh_.next(mesh_.opposite(h))));
    const bool is_outward = inwards_ * ((beyond - mesh_.point(mesh_.target(h))) * normals_[std::size_t(f)]) > 0;
    return is_outward ? std::uint8_t(n) : 0;
  }
  bool is_crease(Halfedge h) const { return sharpness_[std::size_t(h)] >= least_sharpness_; }
  bool is_at_crease(Face f) const {
    const Halfedge h = mesh_.halfedge(f);
    return is_crease(h) || is_crease(mesh_.next(h)) || is_crease(mesh_.prev(h));
  }

  // The faces reached from the first without passing a crease. False, as soon as this is known, if they reach a border
  // or an end that is taken, are half of the surface, or are part of what has been left for such a reason.
  bool collect(Face first, std::vector<Face>& region) {
    double area = 0;
    const std::size_t seed = std::size_t(first);
    visited_[seed] = seed;
    region = {first};
    for (std::size_t i = 0; i < region.size(); ++i) {
      area += areas_[std::size_t(region[i])];
      if (area >= 0.5 * area_)
        return false;
      for (Halfedge h : CGAL::halfedges_around_face(mesh_.halfedge(region[i]), mesh_)) {
        const Face g = mesh_.face(mesh_.opposite(h));
        if (g == Surface::null_face() || taken_[std::size_t(g)])
          return false;
        if (is_crease(h) || visited_[std::size_t(g)] == seed)
          continue;
        if (visited_[std::size_t(g)] != no_seed)
          return false;
        visited_[std::size_t(g)] = seed;
        region.push_back(g);
      }
    }
    return true;
  }

  bool is_end(Opening_site& region) const {
    region.rim = rim_of_disk(region.cap, mesh_);
    if (region.rim.size() < 5)
      return false;
    const std::vector<Point_3> rim = rim_points(region.rim, mesh_);
    region.shape = measure_rim(rim);
    const Rim_shape& s = region.shape;
    const Bulge bulge = measure_bulge(region.cap, s, mesh_, region.rim);
    if (!(s.radius > 0 && !bulge.is_wide() && !bulge.is_long() && s.sag <= max_sag * s.radius &&
          4 * CGAL_PI * s.area >= min_roundness * s.perimeter * s.perimeter &&
          number_of_corners(rim, s.center, 0.08 * s.radius) >= 5))
      return false;
    const Wall_at_cap wall = wall_at_cap(region, normals_, inwards_, mesh_);
    return wall.stands(max_wall_cosine) && !is_facet(region, wall);
  }

  static constexpr double max_sag = 0.2, min_roundness = 0.55, max_wall_cosine = 0.5;

  // Of a crease, in degrees.
  static constexpr std::array<double, 3> angles = {40, 25, 15};
  static constexpr std::size_t no_seed = std::size_t(-1);

  const Surface& mesh_;
  const double inwards_; // the direction into the lumen along a face's normal
  std::array<double, angles.size()> cosines_;
  std::vector<Vector_3> normals_;       // by face, unit; zero for a degenerate face
  std::vector<double> areas_;           // likewise
  std::vector<std::uint8_t> sharpness_; // by halfedge
  std::vector<bool> taken_;
  std::vector<std::size_t> visited_; // from which face
  double area_ = 0;
  std::size_t least_sharpness_ = 0;
};

/* Those that are not among the sites already. */
inline std::vector<Opening_site> find_crease_ends(const Surface& mesh, bool inside_out,
                                                  const std::vector<Opening_site>& sites) {
  Crease_end_finder finder(mesh, inside_out);
  finder.take(sites);
  return finder.find();
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_RIMS_CREASE_ENDS_H
