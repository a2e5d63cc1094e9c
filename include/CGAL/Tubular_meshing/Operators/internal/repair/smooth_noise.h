// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPERATORS_INTERNAL_REPAIR_SMOOTH_NOISE_H
#define CGAL_TUBULAR_MESHING_OPERATORS_INTERNAL_REPAIR_SMOOTH_NOISE_H

#include <CGAL/Tubular_meshing/Operators/internal/Opening_site.h>
#include <CGAL/Tubular_meshing/Operators/internal/flat_ends.h>

#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* Takes staircase noise off a surface and keeps its volume: Taubin's alternation of a smoothing and an inflating step
 * (A signal processing approach to fair surface design, 1995), pass band 0.1, ten rounds. A vertex on a rim moves along
 * the rim only, as a vertex of that curve; flat caps stay as they are. O(n) a round. */
template <class Point> class Noise_smoother {
  typedef CGAL::Surface_mesh<Point> Mesh;
  typedef typename Mesh::Vertex_index Vertex;
  typedef typename Mesh::Halfedge_index Halfedge;
  typedef Vector_of<Point> Vector;

public:
  /* The mesh has no garbage, and is turned outward. */
  explicit Noise_smoother(Mesh& mesh)
      : mesh_(mesh)
      , fixed_(mesh.num_vertices(), false) {
    for (const auto& end : Flat_end_finder<Point>(mesh, false).find(certain_flat_end()))
      for (auto f : end.cap)
        for (Vertex v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
          fixed_[std::size_t(v)] = true;
  }

  void smooth(int rounds = 10) {
    const double lambda = 0.5, pass_band = 0.1, mu = 1 / (pass_band - 1 / lambda);
    for (int i = 0; i < rounds; ++i) {
      step(lambda);
      step(mu);
    }
  }

private:
  void step(double factor) {
    moves_.assign(mesh_.num_vertices(), Vector(0, 0, 0));
    for (Vertex v : mesh_.vertices())
      if (!fixed_[std::size_t(v)])
        moves_[std::size_t(v)] = factor * mean_of_neighbours(v);
    for (Vertex v : mesh_.vertices())
      mesh_.point(v) = mesh_.point(v) + moves_[std::size_t(v)];
  }

  Vector mean_of_neighbours(Vertex v) const {
    Vector sum(0, 0, 0);
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

  Mesh& mesh_;
  std::vector<bool> fixed_;
  std::vector<Vector> moves_;
};

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_OPERATORS_INTERNAL_REPAIR_SMOOTH_NOISE_H
