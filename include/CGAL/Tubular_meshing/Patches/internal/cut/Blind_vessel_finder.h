// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_BLIND_VESSEL_FINDER_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_BLIND_VESSEL_FINDER_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Cut_surface.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Finds vessels that have no centerline, as they end blind: parts of a patch that are far from the centerlines for the
 * radius there, that no curve bounds, and that are longer than wide. An aneurysm's sac is round, and is none.
 * O(n log n) in the surface and the graph, and O(graph) for each such part. */
class Blind_vessel_finder {
public:
  struct Blind_vessel {
    Vertex tip;
    Face face;
    std::size_t branch; // that it leaves
  };

  Blind_vessel_finder(const Cut_surface& surface, const Centerline_graph& graph)
      : surface_(surface)
      , mesh_(surface.mesh())
      , graph_(graph)
      , field_(graph) {}

  // In the order of their first faces.
  std::vector<Blind_vessel> find() {
    measure();
    std::vector<bool> done(mesh_.number_of_faces(), false);
    std::vector<Blind_vessel> vessels;
    for (Face f : mesh_.faces())
      if (!done[f] && is_far(f)) {
        const std::vector<Face> part = far_part(f, done);
        const Vertex end = tip(part);
        if (!is_bounded_by_curve(part) && is_vessel(part, end) && is_far_from_all(end))
          vessels.push_back(Blind_vessel{end, f, field_.descriptors(mesh_.point(end)).branch});
      }
    return vessels;
  }

private:
  static constexpr double far_radii = 3;     // from the centerline
  static constexpr double slenderness = 1.5; // length over diameter; 1 for a ball

  void measure() {
    distance_.assign(mesh_.number_of_vertices(), 0);
    is_far_.assign(mesh_.number_of_vertices(), 0);
    for_each_range(distance_.size(), 0, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const Vertex v{Surface::size_type(i)};
        const auto d = field_.descriptors(mesh_.point(v));
        distance_[i] = d.distance;
        is_far_[i] = d.distance > far_radii * d.radius;
      }
    });
  }

  bool is_far(Face f) const {
    if (!surface_.is_wall(f))
      return false;
    for (Vertex v : mesh_.vertices_around_face(mesh_.halfedge(f)))
      if (!is_far_[v])
        return false;
    return true;
  }

  std::vector<Face> far_part(Face seed, std::vector<bool>& done) const {
    std::vector<Face> part(1, seed);
    done[seed] = true;
    for (std::size_t head = 0; head < part.size(); ++head)
      for (Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(part[head]))) {
        const Face g = mesh_.face(mesh_.opposite(h));
        if (!surface_.is_on_curve(h) && !done[g] && is_far(g)) {
          done[g] = true;
          part.push_back(g);
        }
      }
    return part;
  }

  bool is_bounded_by_curve(const std::vector<Face>& part) const {
    for (Face f : part)
      for (Vertex v : mesh_.vertices_around_face(mesh_.halfedge(f)))
        if (surface_.is_taken(v))
          return true;
    return false;
  }

  Vertex tip(const std::vector<Face>& part) const {
    Vertex best = mesh_.target(mesh_.halfedge(part.front()));
    for (Face f : part)
      for (Vertex v : mesh_.vertices_around_face(mesh_.halfedge(f)))
        if (distance_[v] > distance_[best])
          best = v;
    return best;
  }

  // Where a small branch leaves a large one, the wall of the large one is near the small one's centerline, and yet far
  // for its radius.
  bool is_far_from_all(Vertex v) const {
    const Vector_3d p = surface_.point(v);
    for (std::size_t i = 0; i < graph_.points().size(); ++i) {
      const double ball = far_radii * graph_.radii()[i];
      if (squared_norm(p - Vector_3d(graph_.points()[i])) <= ball * ball)
        return false;
    }
    return true;
  }

  // The wall of a tube of length l and diameter d is π d l; that of a ball, for l = d, the same.
  bool is_vessel(const std::vector<Face>& part, Vertex end) const {
    const Vector_3d top = surface_.point(end);
    double area = 0, length = 0;
    for (Face f : part) {
      const auto [a, b, c] = surface_.corners(f);
      area += norm(cross(b - a, c - a)) / 2;
      length = (std::max)({length, norm(a - top), norm(b - top), norm(c - top)});
    }
    return CGAL_PI * length * length > slenderness * area;
  }

  const Cut_surface& surface_;
  const Surface& mesh_;
  const Centerline_graph& graph_;
  Centerline_field field_;
  std::vector<double> distance_; // of each vertex from the centerlines
  std::vector<char> is_far_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_BLIND_VESSEL_FINDER_H
