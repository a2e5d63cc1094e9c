// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LAYER_SURFACE_H
#define CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LAYER_SURFACE_H

#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The part of a surface that layers of cells grow on: its triangles and quads, turned so that their normals point where
 * the layers go, what is around each vertex, and its rims. Compact arrays; built in O(n log n). */
class Layer_surface {
public:
  typedef std::uint32_t Index;
  static constexpr Index none = Index(-1);
  typedef std::array<Index, 3> Triangle;
  typedef std::array<Index, 4> Face; // a triangle ends in `none`

  // A corner of a face: the vertices after and before it.
  struct Corner {
    Index face, next, previous;
  };
  struct Rim_edge {
    Index source, target; // as its face turns
    int label;            // of the opening
  };
  // A rim, in the order in which its edges turn, and the normal of its plane: the direction of its area.
  struct Rim {
    std::vector<Index> edges; // in rim_edges
    Vector_3d normal;
  };

  std::vector<Vector_3d> points;
  std::vector<Face> faces;
  std::vector<Rim_edge> rim_edges;
  std::vector<Rim> rims;

  /* \param label_of_edge called with the source and target of a border edge: the label of the opening there */
  Layer_surface(std::vector<Vector_3d> vertices, std::vector<Face> all_faces,
                Function_view<int(Index, Index)> label_of_edge)
      : points(std::move(vertices))
      , faces(std::move(all_faces)) {
    collect_corners();
    collect_edges(label_of_edge);
    check_fans();
    find_rims();
    note_rim_planes();
  }

  static int degree(const Face& f) { return f[3] == none ? 3 : 4; }
  std::size_t number_of_vertices() const { return points.size(); }

  // The faces as triangles: as they turn, or the other way; vertices are numbered from `first` on.
  std::vector<Triangle> triangles(bool turned = false, Index first = 0) const {
    std::vector<Triangle> result;
    const auto add = [&](Index a, Index b, Index c) {
      result.push_back({first + a, first + (turned ? c : b), first + (turned ? b : c)});
    };
    for (const Face& f : faces) {
      add(f[0], f[1], f[2]);
      if (degree(f) == 4)
        add(f[0], f[2], f[3]);
    }
    return result;
  }

  // The corners at a vertex, in no particular order.
  const Corner* corners_begin(Index v) const { return corners_.data() + first_corner_[v]; }
  const Corner* corners_end(Index v) const { return corners_.data() + first_corner_[v + 1]; }

  // The vertices that a vertex shares an edge with.
  const Index* neighbors_begin(Index v) const { return neighbors_.data() + first_neighbor_[v]; }
  const Index* neighbors_end(Index v) const { return neighbors_.data() + first_neighbor_[v + 1]; }

  // The part of a vector that leads out of no rim that the vertex is on.
  Vector_3d along_rims(Index v, Vector_3d d) const {
    if (rim_plane_[v] == none)
      return d;
    for (int round = 0; round < 4; ++round) // one does where there is one plane
      for (std::size_t k = rim_plane_[v]; k < planes_.size() && planes_[k].vertex == v; ++k)
        d = d - dot(d, planes_[k].normal) * planes_[k].normal;
    return d;
  }

  // Twice the area vector of a corner.
  Vector_3d corner_normal(Index v, const Corner& c) const {
    return cross(points[c.next] - points[v], points[c.previous] - points[v]);
  }

private:
  template <class Visitor> void for_each_corner(const Visitor& visit) const {
    for (Index f = 0; f < faces.size(); ++f)
      for (int k = 0, n = degree(faces[f]); k < n; ++k)
        visit(faces[f][k], Corner{f, faces[f][(k + 1) % n], faces[f][(k + n - 1) % n]});
  }

  void collect_corners() {
    first_corner_.assign(points.size() + 1, 0);
    for_each_corner([&](Index v, const Corner&) { ++first_corner_[v + 1]; });
    for (std::size_t v = 0; v < points.size(); ++v)
      first_corner_[v + 1] += first_corner_[v];
    corners_.resize(first_corner_.back());
    std::vector<std::size_t> at(first_corner_.begin(), first_corner_.end() - 1);
    for_each_corner([&](Index v, const Corner& c) { corners_[at[v]++] = c; });
  }

  void collect_edges(Function_view<int(Index, Index)> label_of_edge) {
    first_neighbor_.assign(1, 0);
    for (Index v = 0; v < points.size(); ++v) {
      const std::size_t begin = neighbors_.size();
      for (const Corner* c = corners_begin(v); c != corners_end(v); ++c) {
        // an edge has the face after it here, and the one before it there
        int same = 0, opposite = 0;
        for (const Corner* o = corners_begin(v); o != corners_end(v); ++o) {
          same += o->next == c->next;
          opposite += o->previous == c->next;
        }
        if (same > 1 || opposite > 1)
          throw Input_error("The edge from " + place_of(points[v]) + " to " + place_of(points[c->next]) +
                            " has more than two faces of the wall, or two that are turned differently; repair the "
                            "surface first.");
        neighbors_.push_back(c->next);
        if (opposite == 0)
          rim_edges.push_back({v, c->next, label_of_edge(v, c->next)});
      }
      for (const Corner* c = corners_begin(v); c != corners_end(v); ++c)
        if (std::find(neighbors_.begin() + std::ptrdiff_t(begin), neighbors_.end(), c->previous) == neighbors_.end())
          neighbors_.push_back(c->previous);
      first_neighbor_.push_back(neighbors_.size());
    }
  }

  // The faces around a vertex are one fan.
  void check_fans() const {
    std::vector<char> outgoing(points.size(), 0);
    for (const Rim_edge& e : rim_edges)
      if (++outgoing[e.source] > 1)
        refuse_vertex(e.source);
    for (Index v = 0; v < points.size(); ++v) {
      const std::ptrdiff_t n = corners_end(v) - corners_begin(v);
      if (n == 0)
        continue;
      const Corner* start = corners_begin(v);
      const auto before = [&](const Corner& c) {
        return std::find_if(corners_begin(v), corners_end(v), [&](const Corner& o) { return o.previous == c.next; });
      };
      const auto after = [&](const Corner& c) {
        return std::find_if(corners_begin(v), corners_end(v), [&](const Corner& o) { return o.next == c.previous; });
      };
      for (std::ptrdiff_t k = 0; k < n && before(*start) != corners_end(v); ++k)
        start = before(*start);
      std::ptrdiff_t met = 1;
      for (const Corner* c = after(*start); c != corners_end(v) && c != start && met <= n; c = after(*c))
        ++met;
      if (met != n)
        refuse_vertex(v);
    }
  }

  [[noreturn]] void refuse_vertex(Index v) const {
    throw Input_error("Parts of the wall touch each other in the single point " + place_of(points[v]) +
                      "; repair the surface first.");
  }

  void find_rims() {
    std::vector<Index> edge_from(points.size(), none);
    for (Index e = 0; e < rim_edges.size(); ++e)
      edge_from[rim_edges[e].source] = e;
    std::vector<char> done(rim_edges.size(), 0);
    for (Index first = 0; first < rim_edges.size(); ++first) {
      if (done[first])
        continue;
      Rim rim;
      const Vector_3d& origin = points[rim_edges[first].source];
      for (Index e = first; e != none && !done[e]; e = edge_from[rim_edges[e].target]) {
        done[e] = 1;
        rim.edges.push_back(e);
        rim.normal += cross(points[rim_edges[e].source] - origin, points[rim_edges[e].target] - origin);
      }
      if (!(squared_norm(rim.normal) > 0))
        throw Input_error("The rim of the wall at " + place_of(origin) +
                          " encloses no area; repair the surface first.");
      rim.normal = normalized(rim.normal);
      rims.push_back(std::move(rim));
    }
  }

  void note_rim_planes() {
    for (const Rim& rim : rims)
      for (Index e : rim.edges)
        planes_.push_back({rim_edges[e].source, rim.normal});
    std::stable_sort(planes_.begin(), planes_.end(),
                     [](const Rim_plane& a, const Rim_plane& b) { return a.vertex < b.vertex; });
    rim_plane_.assign(points.size(), none);
    for (std::size_t k = planes_.size(); k-- > 0;)
      rim_plane_[planes_[k].vertex] = Index(k);
  }

  // What a vertex may move along.
  struct Rim_plane {
    Index vertex;
    Vector_3d normal;
  };

  std::vector<std::size_t> first_corner_, first_neighbor_;
  std::vector<Corner> corners_;
  std::vector<Index> neighbors_;
  std::vector<Rim_plane> planes_;
  std::vector<Index> rim_plane_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LAYER_SURFACE_H
