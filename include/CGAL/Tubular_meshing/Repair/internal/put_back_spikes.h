// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_PUT_BACK_SPIKES_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_PUT_BACK_SPIKES_H

#include <CGAL/Tubular_meshing/Repair/internal/fill_wall.h>
#include <CGAL/Tubular_meshing/Repair/internal/tube_ends.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/Rims/Rim_shape.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

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
 * the excess of the angles around is at least 0.4 of what it lacks, and if it lies in a disk: a sharp ring around a
 * vessel is none.
 *
 * Vertices of spikes are freed, and take the place that continues the wall around them. Of several thrown beside each
 * other the sharp ones are only some: a vertex on the ridge between two tips looks like one of a flat wall. So the ring
 * around a spike is freed with it, on trial: what comes to lie more than half an edge off its place was thrown as well.
 *
 * What is sharp, more so than a voxel, but not enough, or among others that were thrown, is judged when these are back:
 * it is a spike if it is more than about half as high as wide, and turned back around.
 *
 * Around a vertex thrown from the rim of a flat cap the wall is convex, and turns back less. It is a spike if without it
 * there is the flat end of a vessel, and the cap goes on beyond the triangles of the vertex; those of a pointed end are
 * all that there is of it. O(n). */
class Spike_mover {
  typedef Surface::Vertex_index Vertex;
  typedef Surface::Halfedge_index Halfedge;

public:
  typedef std::vector<Vertex> Set;

  explicit Spike_mover(Surface& mesh)
      : mesh_(mesh) {}

  Moved_spikes put_back() {
    std::map<Vertex, Point_3> before;
    for (int round = 0; round < 8; ++round) { // spikes beside each other may hide one more
      const std::vector<Set> sharp = sharp_sets();
      std::vector<Set> spikes = find(sharp);
      if (spikes.empty())
        spikes = find_clusters(sharp);
      if (spikes.empty())
        break;
      free(spikes, before);
    }
    lay_into_the_wall(noted(find_at_caps(sharp_sets()), before));
    bend_all(before);
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

  bool has_spikes() {
    const std::vector<Set> sharp = sharp_sets();
    return !find(sharp).empty() || !find_clusters(sharp).empty() || !find_at_caps(sharp).empty();
  }

private:
  static constexpr double degree = CGAL_PI / 180;

  // Each kind is looked for among the sharp sets of the surface as it is.

  /* The spikes that stand by themselves. Sets are in the order of their indices. */
  std::vector<Set> find(const std::vector<Set>& sharp) const {
    std::vector<Set> spikes;
    for (const Set& set : sharp)
      if (is_pointed(set) && is_turned_back(set))
        spikes.push_back(set);
    return spikes;
  }

  /* Those that are several vertices, of which some are not sharp. */
  std::vector<Set> find_clusters(const std::vector<Set>& sharp) {
    std::vector<Set> spikes;
    for (const Set& set : sharp) {
      if (largest_lack(set) < 95 * degree || sum_of_lacks(set) < 135 * degree)
        continue;
      Set thrown = thrown_around(set);
      if (!thrown.empty() && is_turned_back(thrown))
        spikes.push_back(std::move(thrown));
    }
    return spikes;
  }

  /* Those that are thrown from the rims of flat caps. */
  std::vector<Set> find_at_caps(const std::vector<Set>& sharp) {
    std::vector<Set> sets;
    for (const Set& set : sharp)
      if (is_pointed(set) && is_in_disk(set))
        sets.push_back(set);
    if (sets.empty())
      return sets;
    std::map<Vertex, Point_3> before;
    lay_into_the_wall(noted(sets, before));
    const std::vector<Opening_site> ends = flat_ends(mesh_);
    sets.erase(std::remove_if(sets.begin(), sets.end(),
                              [&](const Set& set) {
                                return std::none_of(ends.begin(), ends.end(),
                                                    [&](const Opening_site& end) { return is_at_rim_of(end, set); });
                              }),
               sets.end());
    for (const auto& v : before)
      mesh_.point(v.first) = v.second;
    return sets;
  }

  // Whether faces of the set are a part of the cap, which goes on beyond them along a quarter of its rim.
  bool is_at_rim_of(const Opening_site& end, const Set& set) const {
    const auto is_in = [&](Vertex v, const Set& sorted) { return std::binary_search(sorted.begin(), sorted.end(), v); };
    if (std::none_of(end.cap.begin(), end.cap.end(), [&](Surface::Face_index f) {
          const auto corners = CGAL::vertices_around_face(mesh_.halfedge(f), mesh_);
          return std::any_of(corners.begin(), corners.end(), [&](Vertex v) { return is_in(v, set); });
        }))
      return false;
    const Set around = with_ring(set);
    double length = 0, beyond = 0;
    for (Halfedge h : end.rim) {
      const double side = point_distance(mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h)));
      length += side;
      beyond += is_in(mesh_.source(h), around) && is_in(mesh_.target(h), around) ? 0 : side;
    }
    return beyond > 0.25 * length;
  }

  // All vertices of the sets, in order; where they are goes into `before`.
  Set noted(const std::vector<Set>& sets, std::map<Vertex, Point_3>& before) const {
    Set all;
    for (const Set& set : sets)
      all.insert(all.end(), set.begin(), set.end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    for (Vertex v : all)
      before.emplace(v, mesh_.point(v));
    return all;
  }

  // The connected sets of vertices whose angles lack more than an eighth of a turn.
  std::vector<Set> sharp_sets() {
    lack_.assign(mesh_.num_vertices(), 0);
    is_sharp_.assign(mesh_.num_vertices(), false);
    for_each_range(mesh_.num_vertices(), 0, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        if (const Vertex v(static_cast<Surface::size_type>(i)); !mesh_.is_removed(v) && !mesh_.is_isolated(v))
          lack_[i] = (mesh_.is_border(v) ? 180 : 360) * degree - sum_of_angles(v);
    });
    std::vector<Vertex> sharp;
    for (Vertex v : mesh_.vertices())
      if (lack_[std::size_t(v)] > 45 * degree && !mesh_.is_border(v)) {
        is_sharp_[std::size_t(v)] = true;
        sharp.push_back(v);
      }
    std::vector<Set> sets;
    std::vector<bool> visited(sharp.empty() ? 0 : mesh_.num_vertices(), false);
    for (Vertex v : sharp)
      if (!visited[std::size_t(v)])
        sets.push_back(connected(v, visited));
    return sets;
  }

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

  Set connected(Vertex first, std::vector<bool>& visited) const {
    Set set = {first};
    visited[std::size_t(first)] = true;
    for (std::size_t i = 0; i < set.size(); ++i)
      for (Vertex w : CGAL::vertices_around_target(mesh_.halfedge(set[i]), mesh_))
        if (is_sharp_[std::size_t(w)] && !visited[std::size_t(w)]) {
          visited[std::size_t(w)] = true;
          set.push_back(w);
        }
    std::sort(set.begin(), set.end());
    return set;
  }

  double sum_of_lacks(const Set& set) const {
    double sum = 0;
    for (Vertex v : set)
      sum += lack_[std::size_t(v)];
    return sum;
  }

  double largest_lack(const Set& set) const {
    double most = 0;
    for (Vertex v : set)
      most = (std::max)(most, lack_[std::size_t(v)]);
    return most;
  }

  // Whether it is as sharp as a spike.
  bool is_pointed(const Set& set) const {
    const double lack = sum_of_lacks(set), mean = lack / double(set.size());
    const double most = largest_lack(set);
    return most > 135 * degree ? mean > 80 * degree : lack > 135 * degree && mean > 100 * degree;
  }

  // Whether the wall around turns back what the set turns, and the set and its ring make a disk.
  bool is_turned_back(const Set& set) const {
    double excess = 0;
    for (Vertex w : with_ring(set))
      if (!std::binary_search(set.begin(), set.end(), w))
        excess -= lack_[std::size_t(w)];
    return excess > 0.4 * sum_of_lacks(set) && is_in_disk(set);
  }

  // Whether the set and its ring make a disk.
  bool is_in_disk(const Set& set) const {
    std::vector<Surface::Face_index> faces;
    std::vector<Surface::Edge_index> edges;
    for (Vertex v : set)
      for (Halfedge h : CGAL::halfedges_around_target(mesh_.halfedge(v), mesh_)) {
        faces.push_back(mesh_.face(h)); // a set has no vertex on the border
        edges.push_back(mesh_.edge(h));
        edges.push_back(mesh_.edge(mesh_.next(mesh_.next(h))));
      }
    const long vertices = long(with_ring(set).size());
    return vertices - long(number_of_different(edges)) + long(number_of_different(faces)) == 1;
  }

  template <class Index> static std::size_t number_of_different(std::vector<Index>& all) {
    std::sort(all.begin(), all.end());
    return std::size_t(std::unique(all.begin(), all.end()) - all.begin());
  }

  // The set and its neighbours, in order.
  Set with_ring(const Set& set) const {
    Set all = set;
    for (Vertex v : set)
      for (Vertex w : CGAL::vertices_around_target(mesh_.halfedge(v), mesh_))
        all.push_back(w);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  Set inner_with_ring(const Set& set) const {
    Set all = with_ring(set);
    all.erase(std::remove_if(all.begin(), all.end(), [&](Vertex v) { return mesh_.is_border(v); }), all.end());
    return all;
  }

  // Puts the spikes back, and what proves to be thrown beside them; where all of it was goes into `before`.
  void free(std::vector<Set>& spikes, std::map<Vertex, Point_3>& before) {
    lay_into_the_wall(noted(spikes, before));
    for (Set& set : spikes) {
      const std::size_t most = 4 * set.size() + 8; // what goes on growing is no spike any more
      while (set.size() < most) {
        Set grown = set;
        for (const Off_the_wall& v : off_the_wall(inner_with_ring(set)))
          if (!std::binary_search(set.begin(), set.end(), v.vertex)) {
            grown.push_back(v.vertex);
            before.emplace(v.vertex, mesh_.point(v.vertex));
          }
        if (grown.size() == set.size())
          break;
        std::sort(grown.begin(), grown.end());
        set.swap(grown);
        lay_into_the_wall(set);
      }
    }
  }

  // Once all of them lie near their places.
  void bend_all(const std::map<Vertex, Point_3>& moved) {
    Set all;
    for (const auto& v : moved)
      all.push_back(v.first);
    bend(mesh_, all, 100);
  }

  // Those of a set and around it that lie off the wall that is around them all; none if they are less than half as high as wide.
  Set thrown_around(Set set) {
    const std::size_t most = 12;
    double height = 0;
    for (int round = 0; round < 6; ++round) {
      Set thrown;
      height = 0;
      for (const Off_the_wall& v : off_the_wall(inner_with_ring(set))) {
        thrown.push_back(v.vertex);
        height = (std::max)(height, v.edges);
      }
      if (thrown.size() > most)
        return Set();
      if (thrown == set)
        break;
      set.swap(thrown);
    }
    return height > 0.6 * (1 + std::sqrt(double(set.size()))) ? set : Set(); // edges
  }

  struct Off_the_wall {
    Vertex vertex;
    double edges; // how far, in edges there
  };

  // Those that come to lie elsewhere, across the wall, if all are freed.
  std::vector<Off_the_wall> off_the_wall(const Set& vertices) {
    std::vector<Point_3> before;
    for (Vertex v : vertices)
      before.push_back(mesh_.point(v));
    lay_into_the_wall(vertices);
    std::vector<Off_the_wall> result;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Vertex v = vertices[i];
      Vector_3 normal(0, 0, 0);
      double length = 0;
      for (Halfedge h : CGAL::halfedges_around_target(mesh_.halfedge(v), mesh_)) {
        normal = normal + area_vector(h, mesh_);
        length += point_distance(mesh_.point(mesh_.source(h)), mesh_.point(v)) / double(mesh_.degree(v));
      }
      const double way = std::abs((before[i] - mesh_.point(v)) * normal);
      const double unit = length * std::sqrt(normal.squared_length());
      if (way > 0.5 * unit)
        result.push_back(Off_the_wall{v, way / unit});
    }
    for (std::size_t i = 0; i < vertices.size(); ++i)
      mesh_.point(vertices[i]) = before[i];
    return result;
  }

  void lay_into_the_wall(const Set& vertices) {
    relax(mesh_, vertices, 20);
    bend(mesh_, vertices, 40);
  }

  Surface& mesh_;
  std::vector<double> lack_; ///< by vertex: of the sum of the angles to that in a plane
  std::vector<bool> is_sharp_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_PUT_BACK_SPIKES_H
