// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_WALL_FACETS_H
#define CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_WALL_FACETS_H

#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Layers/internal/Layer_surface.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The facets of a mesh, parted into those of its wall and those of its openings. The vertices of the wall are numbered
 * in the order of the mesh's points. */
class Wall_facets {
public:
  typedef std::uint32_t Index;
  typedef Layer_surface::Face Face;

  /* Facets of the wall in the plane of an opening become the opening's, in the mesh: nothing can grow on them that
   * stays in that plane. */
  explicit Wall_facets(Mixed_mesh& mesh)
      : mesh_(mesh) {
    check_indices(mesh.triangles);
    check_indices(mesh.quads);
    collect_cap_edges();
    while (give_ears_to_caps())
      collect_cap_edges();
    number_vertices();
  }

  std::size_t number_of_relabelled_facets() const { return relabelled_; }

  // The point of each vertex of the wall.
  const std::vector<Index>& mesh_vertices() const { return mesh_vertices_; }

  // `inward`: turned the other way.
  Layer_surface surface(bool inward) const {
    std::vector<Vector_3d> points;
    for (Index v : mesh_vertices_)
      points.emplace_back(mesh_.points[v]);
    std::vector<Face> faces;
    add_faces(mesh_.triangles, inward, faces);
    add_faces(mesh_.quads, inward, faces);
    Layer_surface surface(std::move(points), std::move(faces), [&](Index v, Index w) {
      const Index a = mesh_vertices_[v], b = mesh_vertices_[w];
      return label_beyond(inward ? a : b, inward ? b : a);
    });
    label_open_rims(surface);
    return surface;
  }

  // Whether there is a facet beyond each edge of a rim.
  bool has_all_caps(const Layer_surface& surface) const {
    return std::all_of(surface.rim_edges.begin(), surface.rim_edges.end(), [&](const Layer_surface::Rim_edge& e) {
      const Index a = mesh_vertices_[e.source], b = mesh_vertices_[e.target];
      return label_beyond(a, b) + label_beyond(b, a) > 0;
    });
  }

  /* The facets of openings as triangles of the points that the engine knows: the wall's vertices, then the others'. */
  void caps(std::vector<Vector_3d>& points, std::vector<Layer_surface::Triangle>& triangles) const {
    std::map<Index, Index> others;
    const auto vertex = [&](Index v) {
      if (number_[v] != Layer_surface::none)
        return number_[v];
      const auto added = others.insert({v, Index(points.size())});
      if (added.second)
        points.emplace_back(mesh_.points[v]);
      return added.first->second;
    };
    for_each_cap_facet([&](const Index* f, int n, int) {
      for (int k = 2; k < n; ++k)
        triangles.push_back({vertex(f[0]), vertex(f[k - 1]), vertex(f[k])});
    });
  }

private:
  struct Cap_edge {
    std::array<Index, 2> ends; // as the facet turns
    int label;
    bool operator<(const Cap_edge& e) const { return ends < e.ends; }
  };

  template <std::size_t N> void check_indices(const Element_block<N>& facets) const {
    for (const auto& f : facets.vertices)
      for (Index v : f)
        if (v >= mesh_.points.size())
          throw Input_error("A facet of the mesh refers to point " + std::to_string(v) + ", but there are " +
                            std::to_string(mesh_.points.size()) + " points.");
  }

  template <class Visitor> void for_each_cap_facet(const Visitor& visit) const {
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i)
      if (mesh_.triangles.label[i] != labels::wall)
        visit(mesh_.triangles.vertices[i].data(), 3, mesh_.triangles.label[i]);
    for (std::size_t i = 0; i < mesh_.quads.size(); ++i)
      if (mesh_.quads.label[i] != labels::wall)
        visit(mesh_.quads.vertices[i].data(), 4, mesh_.quads.label[i]);
  }

  void collect_cap_edges() {
    cap_edges_.clear();
    for_each_cap_facet([&](const Index* f, int n, int label) {
      for (int k = 0; k < n; ++k)
        cap_edges_.push_back({{{f[k], f[(k + 1) % n]}}, label});
    });
    std::sort(cap_edges_.begin(), cap_edges_.end());
  }

  // The label of the opening whose facet has the edge from a to b; 0 if none has.
  int label_beyond(Index a, Index b) const {
    const Cap_edge key{{{a, b}}, 0};
    const auto e = std::lower_bound(cap_edges_.begin(), cap_edges_.end(), key);
    return e != cap_edges_.end() && e->ends == key.ends ? e->label : 0;
  }

  /* A facet of the wall with two edges on one rim lies in the plane of the opening, or nearly so, if it makes no angle
   * with it. Returns whether there was one. */
  bool give_ears_to_caps() {
    const std::size_t before = relabelled_;
    std::map<int, Vector_3d> areas;
    for_each_cap_facet([&](const Index* f, int n, int label) { areas[label] += area(f, n); });
    const auto give = [&](auto& facets) {
      for (std::size_t i = 0; i < facets.size(); ++i) {
        if (facets.label[i] != labels::wall)
          continue;
        const auto& f = facets.vertices[i];
        const int n = int(f.size());
        std::map<int, int> edges;
        for (int k = 0; k < n; ++k)
          if (const int label = label_beyond(f[std::size_t((k + 1) % n)], f[std::size_t(k)]))
            ++edges[label];
        for (const auto& e : edges)
          if (e.second >= 2 && dot(normalized(area(f.data(), n)), normalized(areas[e.first])) > in_plane) {
            facets.label[i] = e.first;
            ++relabelled_;
            break;
          }
      }
    };
    give(mesh_.triangles);
    give(mesh_.quads);
    return relabelled_ > before;
  }

  Vector_3d area(const Index* f, int n) const {
    Vector_3d sum;
    const Vector_3d o(mesh_.points[f[0]]);
    for (int k = 2; k < n; ++k)
      sum += cross(Vector_3d(mesh_.points[f[k - 1]]) - o, Vector_3d(mesh_.points[f[k]]) - o);
    return sum;
  }

  void number_vertices() {
    number_.assign(mesh_.points.size(), Layer_surface::none);
    const auto mark = [&](const auto& facets) {
      for (std::size_t i = 0; i < facets.size(); ++i)
        if (facets.label[i] == labels::wall)
          for (Index v : facets.vertices[i])
            number_[v] = 0;
    };
    mark(mesh_.triangles);
    mark(mesh_.quads);
    for (Index v = 0; v < number_.size(); ++v)
      if (number_[v] == 0) {
        number_[v] = Index(mesh_vertices_.size());
        mesh_vertices_.push_back(v);
      }
    if (mesh_vertices_.empty())
      throw Input_error("The mesh has no facets of patch " + std::to_string(labels::wall) +
                        ", the wall, that layers could grow on.");
  }

  template <std::size_t N> void add_faces(const Element_block<N>& facets, bool inward, std::vector<Face>& faces) const {
    for (std::size_t i = 0; i < facets.size(); ++i)
      if (facets.label[i] == labels::wall) {
        Face face = {Layer_surface::none, Layer_surface::none, Layer_surface::none, Layer_surface::none};
        for (std::size_t k = 0; k < N; ++k)
          face[k] = number_[facets.vertices[i][inward ? N - 1 - k : k]];
        faces.push_back(face);
      }
  }

  // Rims without a cap are numbered like openings, from the one with the first vertex on.
  static void label_open_rims(Layer_surface& surface) {
    std::vector<Index> edge_from(surface.number_of_vertices(), Layer_surface::none);
    for (Index e = 0; e < surface.rim_edges.size(); ++e)
      edge_from[surface.rim_edges[e].source] = e;
    int label = labels::inlet;
    for (const Layer_surface::Rim_edge& e : surface.rim_edges)
      label = (std::max)(label, e.label + 1);
    for (Index first = 0; first < surface.rim_edges.size(); ++first) {
      if (surface.rim_edges[first].label != 0)
        continue;
      for (Index e = first; e != Layer_surface::none && surface.rim_edges[e].label == 0;
           e = edge_from[surface.rim_edges[e].target])
        surface.rim_edges[e].label = label;
      ++label;
    }
  }

  static constexpr double in_plane = 0.99;

  Mixed_mesh& mesh_;
  std::vector<Cap_edge> cap_edges_;
  std::vector<Index> mesh_vertices_, number_;
  std::size_t relabelled_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_WALL_FACETS_H
