// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_PUT_BACK_SPIKES_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_PUT_BACK_SPIKES_H

#include <CGAL/Tubular_meshing/Repair/internal/fill_wall.h>
#include <CGAL/Tubular_meshing/Rims/Rim_shape.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

struct Moved_spikes {
  std::size_t count = 0;
  double farthest = 0; ///< how far a vertex was moved at most
  Point_3 place;       ///< where that vertex was
};

/* Puts vertices that were thrown out of the wall back into it: spikes into the lumen or outward, and vertices thrown
 * along the wall past their neighbours.
 *
 * What tells such a vertex is the sum of the angles of its triangles, which depends neither on how fine nor on how
 * stretched these are: a full turn wherever the wall is plane, curved in one direction or creased, more at a saddle (a
 * carina, a stenosis), 5/8 of it on a cone 1.25 times as high as wide. On real and generated vessels it stays above
 * 3/4. Vertices thrown beside each other share what they lack: those of less than 7/8 that are connected are judged
 * together. They are a spike if one of them is below 5/8, or if they lack 100 degrees on average; the corners of a voxel
 * lack 90.
 *
 * A pointed end of a vessel, or the corner of a coarse one, may be as sharp; but the wall around a spike turns back what
 * the spike turns, by the theorem of Gauss and Bonnet, while what is convex goes on as it is. So it is a spike only if
 * the excess of the angles around is at least 0.4 of what it lacks.
 *
 * All vertices of spikes are then freed at once, and take the place that continues the wall around them. O(n). */
class Spike_mover {
  typedef Surface::Vertex_index Vertex;
  typedef Surface::Halfedge_index Halfedge;

public:
  explicit Spike_mover(Surface& mesh)
      : mesh_(mesh) {}

  Moved_spikes put_back() {
    std::map<Vertex, Point_3> before;
    for (int round = 0; round < 3; ++round) { // spikes beside each other may hide one more
      const std::vector<Vertex> spikes = find();
      if (spikes.empty())
        break;
      for (Vertex v : spikes)
        before.emplace(v, mesh_.point(v));
      relax(mesh_, spikes, 20);
      bend(mesh_, spikes, 40);
    }
    Moved_spikes moved;
    moved.count = before.size();
    for (const auto& v : before) {
      const double way = point_distance(v.second, mesh_.point(v.first));
      if (way > moved.farthest) {
        moved.farthest = way;
        moved.place = v.second;
      }
    }
    return moved;
  }

  /* In the order of their indices. */
  std::vector<Vertex> find() {
    lack_.assign(mesh_.num_vertices(), 0);
    is_sharp_.assign(mesh_.num_vertices(), false);
    std::vector<Vertex> sharp;
    for (Vertex v : mesh_.vertices()) {
      if (mesh_.is_isolated(v))
        continue;
      const bool on_rim = mesh_.is_border(v);
      lack_[std::size_t(v)] = (on_rim ? CGAL_PI : 2 * CGAL_PI) - sum_of_angles(v);
      if (!on_rim && lack_[std::size_t(v)] > CGAL_PI / 4) {
        is_sharp_[std::size_t(v)] = true;
        sharp.push_back(v);
      }
    }
    std::vector<Vertex> spikes;
    std::vector<bool> visited(sharp.empty() ? 0 : mesh_.num_vertices(), false);
    for (Vertex v : sharp)
      if (!visited[std::size_t(v)]) {
        const std::vector<Vertex> set = connected(v, visited);
        if (is_spike(set))
          spikes.insert(spikes.end(), set.begin(), set.end());
      }
    std::sort(spikes.begin(), spikes.end());
    return spikes;
  }

private:
  double sum_of_angles(Vertex v) const {
    double sum = 0;
    for (Halfedge h : CGAL::halfedges_around_target(mesh_.halfedge(v), mesh_)) {
      if (mesh_.is_border(h))
        continue;
      const Vector_3 a = mesh_.point(mesh_.source(h)) - mesh_.point(v);
      const Vector_3 b = mesh_.point(mesh_.target(mesh_.next(h))) - mesh_.point(v);
      sum += std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), a * b);
    }
    return sum;
  }

  std::vector<Vertex> connected(Vertex first, std::vector<bool>& visited) const {
    std::vector<Vertex> set = {first};
    visited[std::size_t(first)] = true;
    for (std::size_t i = 0; i < set.size(); ++i)
      for (Vertex w : CGAL::vertices_around_target(mesh_.halfedge(set[i]), mesh_))
        if (is_sharp_[std::size_t(w)] && !visited[std::size_t(w)]) {
          visited[std::size_t(w)] = true;
          set.push_back(w);
        }
    return set;
  }

  bool is_spike(const std::vector<Vertex>& set) const {
    double lack = 0, most = 0, excess = 0;
    std::vector<Vertex> around;
    for (Vertex v : set) {
      lack += lack_[std::size_t(v)];
      most = (std::max)(most, lack_[std::size_t(v)]);
      for (Vertex w : CGAL::vertices_around_target(mesh_.halfedge(v), mesh_))
        if (!is_sharp_[std::size_t(w)])
          around.push_back(w);
    }
    const double degree = CGAL_PI / 180, mean = lack / double(set.size());
    if (!(most > 135 * degree ? mean > 80 * degree : lack > 135 * degree && mean > 100 * degree))
      return false;
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    for (Vertex w : around)
      excess -= lack_[std::size_t(w)];
    return excess > 0.4 * lack;
  }

  Surface& mesh_;
  std::vector<double> lack_; ///< by vertex: of the sum of the angles to that in a plane
  std::vector<bool> is_sharp_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_PUT_BACK_SPIKES_H
