// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_SMOOTH_NOISE_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_SMOOTH_NOISE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Rims/flat_ends.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Takes staircase noise off a surface and keeps its volume: Taubin's alternation of a smoothing and an inflating step
 * (A signal processing approach to fair surface design, 1995), pass band 0.1, ten rounds; what volume that gains or
 * loses is then made up for by moving the wall along its normals, all over by the same length. A vertex on a rim moves
 * along the rim only, as a vertex of that curve; flat caps stay as they are. O(n) a round. */
class Noise_smoother {
  typedef Surface::Vertex_index Vertex;
  typedef Surface::Halfedge_index Halfedge;

public:
  /* The mesh has no garbage, and is turned outward. */
  explicit Noise_smoother(Surface& mesh)
      : mesh_(mesh)
      , fixed_(mesh.num_vertices(), false) {
    for (const auto& end : Flat_end_finder(mesh, false).find(certain_flat_end()))
      for (auto f : end.cap)
        for (Vertex v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
          fixed_[std::size_t(v)] = true;
  }

  void smooth(int rounds = 10) {
    const double lambda = 0.5, pass_band = 0.1, mu = 1 / (pass_band - 1 / lambda);
    const double volume = closed_volume(mesh_, border_cycles(mesh_));
    for (int i = 0; i < rounds; ++i) {
      step(lambda);
      step(mu);
    }
    offset(volume);
  }

private:
  void step(double factor) {
    moves_.assign(mesh_.num_vertices(), Vector_3(0, 0, 0));
    for (Vertex v : mesh_.vertices())
      if (!fixed_[std::size_t(v)])
        moves_[std::size_t(v)] = factor * mean_of_neighbours(v);
    for (Vertex v : mesh_.vertices())
      mesh_.point(v) = mesh_.point(v) + moves_[std::size_t(v)];
  }

  void offset(double volume) {
    std::vector<Vector_3> normals(mesh_.num_vertices(), Vector_3(0, 0, 0));
    double area = 0;
    for (auto f : mesh_.faces()) {
      const Vector_3 n = area_vector(mesh_.halfedge(f), mesh_);
      area += std::sqrt(n.squared_length());
      for (Vertex v : CGAL::vertices_around_face(mesh_.halfedge(f), mesh_))
        normals[std::size_t(v)] = normals[std::size_t(v)] + n;
    }
    const double distance = (volume - closed_volume(mesh_, border_cycles(mesh_))) / area;
    for (Vertex v : mesh_.vertices()) {
      const double length = std::sqrt(normals[std::size_t(v)].squared_length());
      if (!fixed_[std::size_t(v)] && length > 0)
        mesh_.point(v) = mesh_.point(v) + (distance / length) * normals[std::size_t(v)];
    }
  }

  Vector_3 mean_of_neighbours(Vertex v) const {
    Vector_3 sum(0, 0, 0);
    double n = 0;
    const bool on_rim = mesh_.is_border(v);
    for (Halfedge h : CGAL::halfedges_around_target(mesh_.halfedge(v), mesh_)) {
      if (on_rim && !mesh_.is_border(mesh_.edge(h)))
        continue;
      sum = sum + (mesh_.point(mesh_.source(h)) - mesh_.point(v));
      ++n;
    }
    return n > 0 ? sum / n : sum;
  }

  Surface& mesh_;
  std::vector<bool> fixed_;
  std::vector<Vector_3> moves_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_SMOOTH_NOISE_H
