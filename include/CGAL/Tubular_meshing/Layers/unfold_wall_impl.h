// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_UNFOLD_WALL_IMPL_H
#define CGAL_TUBULAR_MESHING_LAYERS_UNFOLD_WALL_IMPL_H

#include <CGAL/Tubular_meshing/Layers/internal/Layer_directions.h>
#include <CGAL/Tubular_meshing/Layers/internal/Layer_surface.h>
#include <CGAL/Tubular_meshing/Layers/internal/Wall_facets.h>
#include <CGAL/Tubular_meshing/Layers/internal/labelled_facets.h>
#include <CGAL/Tubular_meshing/Layers/unfold_wall.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Moves the vertices of folds, see unfold_wall(). */
class Wall_unfolder {
public:
  typedef Layer_surface::Index Index;

  explicit Wall_unfolder(Layer_surface& surface)
      : surface_(surface)
      , best_(surface)
      , is_on_rim_(surface.number_of_vertices(), 0) {
    for (const auto& e : surface.rim_edges)
      is_on_rim_[e.source] = is_on_rim_[e.target] = 1;
  }

  void run() {
    constexpr int most_rounds = 30, alone = 4; // rounds in which vertices of folds move, and their neighbours do not
    std::vector<Index> folded;
    for (Index v = 0; v < surface_.number_of_vertices(); ++v)
      if (is_folded(v, least_visibility))
        folded.push_back(v);
    for (int round = 0; round < most_rounds && !folded.empty(); ++round) {
      const std::vector<Index> moving = round < alone ? folded : with_neighbors(folded);
      move(moving);
      folded.clear();
      for (Index v : with_neighbors(moving))
        if (is_folded(v, enough_visibility))
          folded.push_back(v);
    }
  }

private:
  // A crotch between vessels that are four degrees apart has a visibility of .035, and can be meshed.
  static constexpr double least_visibility = 0.03, enough_visibility = 0.1;

  bool is_folded(Index v, double least) const {
    if (surface_.corners_begin(v) == surface_.corners_end(v))
      return false;
    return best_.is_flat(v) || !(best_(v).visibility > least);
  }

  std::vector<Index> with_neighbors(std::vector<Index> vertices) const {
    const std::size_t n = vertices.size();
    for (std::size_t i = 0; i < n; ++i)
      vertices.insert(vertices.end(), surface_.neighbors_begin(vertices[i]), surface_.neighbors_end(vertices[i]));
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
  }

  // Half of the way.
  void move(const std::vector<Index>& vertices) {
    std::vector<Vector_3d> places;
    for (Index v : vertices) {
      Vector_3d mean;
      for (const Index* w = surface_.neighbors_begin(v); w != surface_.neighbors_end(v); ++w)
        mean += surface_.points[*w];
      const double n = double(surface_.neighbors_end(v) - surface_.neighbors_begin(v));
      places.push_back(is_on_rim_[v] ? surface_.points[v] : 0.5 * (surface_.points[v] + (1 / n) * mean));
    }
    for (std::size_t i = 0; i < vertices.size(); ++i)
      surface_.points[vertices[i]] = places[i];
  }

  Layer_surface& surface_;
  const Best_layer_direction best_;
  std::vector<char> is_on_rim_;
};

CGAL_TUBULAR_MESHING_INLINE Unfolded_wall unfold_wall(Surface& surface, Face_patch_map patch) {
  Mixed_mesh facets = labelled_facets(surface, patch);
  const Wall_facets wall(facets);
  Layer_surface layers = wall.surface(true);
  const std::vector<Vector_3d> before = layers.points;
  Wall_unfolder(layers).run();
  Unfolded_wall result;
  for (std::size_t v = 0; v < before.size(); ++v) {
    const double distance = norm(layers.points[v] - before[v]);
    if (!(distance > 0))
      continue;
    ++result.vertices;
    if (distance > result.distance) {
      result.distance = distance;
      result.place = as<Point_3>(before[v]);
    }
    surface.point(Surface::Vertex_index(wall.mesh_vertices()[v])) = as<Point_3>(layers.points[v]);
  }
  return result;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_LAYERS_UNFOLD_WALL_IMPL_H
