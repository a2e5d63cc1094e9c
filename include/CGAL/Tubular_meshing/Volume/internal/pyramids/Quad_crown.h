// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_QUAD_CROWN_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_QUAD_CROWN_H

#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The ray on which the apex of a quad's pyramid lies: from the quad's middle inward. The pyramid is positive at all
 * corners of its base where the apex lies beyond the planes of all of them, that is, higher than `lowest`; that is 0
 * for a flat quad, and infinite for one with a corner of about 180 degrees or more, on which no pyramid can stand. */
struct Quad_crown {
  Vector_3d foot, direction;
  double lowest = (std::numeric_limits<double>::infinity)();
  double mean_edge = 0;

  Quad_crown() = default;
  // The quad is given counterclockwise from outside.
  explicit Quad_crown(const std::array<Vector_3d, 4>& quad) {
    std::array<Vector_3d, 4> inward; // of the planes of the corners
    Vector_3d area;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector_3d next = quad[(i + 1) % 4] - quad[i], previous = quad[(i + 3) % 4] - quad[i];
      const Vector_3d normal = cross(previous, next);
      if (norm(normal) > least_sine * norm(previous) * norm(next))
        inward[i] = normalized(normal); // otherwise it stays 0, and cannot be risen above
      area += normal;
      foot += 0.25 * quad[i];
      mean_edge += 0.25 * norm(next);
    }
    direction = normalized(area);
    turn_towards(inward);
    lowest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const double rise = dot(direction, inward[i]);
      if (!(rise > least_rise)) {
        lowest = (std::numeric_limits<double>::infinity)();
        return;
      }
      lowest = (std::max)(lowest, dot(quad[i] - foot, inward[i]) / rise);
    }
  }

  Vector_3d apex(double height) const { return foot + height * direction; }

private:
  static constexpr double least_rise = 0.05;
  static constexpr double least_sine = 0.02; // of a corner's angle
  static constexpr double good_rise = 0.5;

  // Where the quad is so warped that its normal is not well inside of all corners, another direction may be.
  void turn_towards(const std::array<Vector_3d, 4>& inward) {
    for (int step = 0; step < 32; ++step) {
      const auto worst = std::min_element(inward.begin(), inward.end(), [this](const Vector_3d& a, const Vector_3d& b) {
        return dot(direction, a) < dot(direction, b);
      });
      const double rise = dot(direction, *worst);
      if (rise >= good_rise)
        return;
      direction = normalized(direction + 0.5 * (good_rise - rise) * *worst);
    }
  }
};

/* Faces of a closed surface that meet at an edge, as they turn outward: of the halves of all edges, that of an edge's
 * first face and that of its second follow each other. */
struct Half_edge {
  std::uint32_t low, high; // its vertices
  bool reversed;           // from high to low
  std::uint32_t face;      // triangles first, then quads

  bool operator<(const Half_edge& e) const {
    return std::make_pair(low, high) < std::make_pair(e.low, e.high) ||
           (low == e.low && high == e.high && face < e.face);
  }
};

inline std::vector<Half_edge> paired_half_edges(const Mixed_mesh& surface) {
  std::vector<Half_edge> edges;
  edges.reserve(3 * surface.triangles.size() + 4 * surface.quads.size());
  std::uint32_t face = 0;
  const auto add = [&](const auto& block) {
    for (const auto& v : block.vertices) {
      for (std::size_t i = 0; i < v.size(); ++i) {
        const std::uint32_t a = v[i], b = v[(i + 1) % v.size()];
        edges.push_back({(std::min)(a, b), (std::max)(a, b), b < a, face});
      }
      ++face;
    }
  };
  add(surface.triangles);
  add(surface.quads);
  std::sort(edges.begin(), edges.end());
  return edges;
}

/* Heights at which pyramids are good and leave room for tetrahedra between them: near-equilateral sides where the wall
 * is flat; where it folds inward, a third of the angle between two quads is for the pyramid on either of them, and half
 * of that between a quad and a triangle. O(n log n). */
inline std::vector<double> crown_heights(const Mixed_mesh& surface, const std::vector<Quad_crown>& crowns) {
  constexpr double wanted = 0.6; // of the mean edge; √½ makes equilateral sides, but crowds narrow vessels
  const std::size_t triangles = surface.triangles.size();
  std::vector<Vector_3d> normal; // outward
  for (const auto& t : surface.triangles.vertices) {
    const Vector_3d p(surface.points[t[0]]);
    normal.push_back(normalized(cross(Vector_3d(surface.points[t[1]]) - p, Vector_3d(surface.points[t[2]]) - p)));
  }
  for (const auto& q : surface.quads.vertices)
    normal.push_back(normalized(cross(Vector_3d(surface.points[q[2]]) - Vector_3d(surface.points[q[0]]),
                                      Vector_3d(surface.points[q[3]]) - Vector_3d(surface.points[q[1]]))));
  std::vector<double> height;
  for (const Quad_crown& c : crowns)
    height.push_back(wanted * c.mean_edge);

  const std::vector<Half_edge> edges = paired_half_edges(surface);
  for (std::size_t k = 0; k + 1 < edges.size(); k += 2) {
    const std::size_t f = edges[k].face, g = edges[k + 1].face;
    if (f < triangles && g < triangles)
      continue;
    const Vector_3d low(surface.points[edges[k].low]), high(surface.points[edges[k].high]);
    const Vector_3d along = normalized(edges[k].reversed ? low - high : high - low);
    const double bend = std::atan2(dot(cross(normal[f], normal[g]), along), dot(normal[f], normal[g]));
    const double share = (pi - bend) / (f < triangles || g < triangles ? 2 : 3);
    if (share > 1.4) // radians: more than any pyramid takes
      continue;
    for (std::size_t face : {f, g})
      if (face >= triangles) {
        const Quad_crown& crown = crowns[face - triangles];
        const double away = norm(cross(crown.foot - low, along));
        height[face - triangles] = (std::min)(height[face - triangles], away * std::tan(share));
      }
  }
  return height;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_QUAD_CROWN_H
