// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LAYER_DIRECTIONS_H
#define CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LAYER_DIRECTIONS_H

#include <CGAL/Tubular_meshing/Layers/internal/Layer_surface.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

// A direction, and the smallest product that it has with the normals of the corners around a vertex.
struct Seen_direction {
  Vector_3d direction;
  double visibility = -1;
};

/* The direction that the faces around a vertex see best; one that leads along the rims that the vertex is on. */
class Best_layer_direction {
public:
  typedef Layer_surface::Index Index;
  typedef Layer_surface::Corner Corner;

  static constexpr double no_visibility = 1e-3; // no cell is valid there

  explicit Best_layer_direction(const Layer_surface& surface)
      : surface_(surface) {}

  bool is_flat(Index v) const { // a face has an angle of 0 or 180 degrees
    return std::any_of(surface_.corners_begin(v), surface_.corners_end(v), [&](const Corner& c) {
      const double product =
          norm(surface_.points[c.next] - surface_.points[v]) * norm(surface_.points[c.previous] - surface_.points[v]);
      return !(norm(surface_.corner_normal(v, c)) > least_sine * product);
    });
  }

  // Where no face is flat.
  Seen_direction operator()(Index v) const {
    Vector_3d normal;
    for (const Corner* c = surface_.corners_begin(v); c != surface_.corners_end(v); ++c) {
      const Vector_3d n = surface_.corner_normal(v, *c);
      const double area = norm(n), angle = std::atan2(area, dot(surface_.points[c->next] - surface_.points[v],
                                                                surface_.points[c->previous] - surface_.points[v]));
      normal += (angle / area) * n;
    }
    Seen_direction result;
    result.direction = normalized(surface_.along_rims(v, normal));
    result.visibility = visibility(v, result.direction);
    if (!(result.visibility > good_visibility))
      turn_to_faces(v, result);
    return result;
  }

  double visibility(Index v, const Vector_3d& d) const {
    double least = 1;
    for (const Corner* c = surface_.corners_begin(v); c != surface_.corners_end(v); ++c)
      least = (std::min)(least, dot(normalized(surface_.corner_normal(v, *c)), d));
    return least;
  }

private:
  static constexpr double good_visibility = 0.8; // with less, a better direction is looked for
  static constexpr double least_sine = 1e-7;     // of a face's angles

  // Towards whichever normal is seen worst, by ever smaller steps: the centre of the smallest cone around all.
  void turn_to_faces(Index v, Seen_direction& best) const {
    Vector_3d d = best.direction;
    for (int step = 1; step <= 60; ++step) {
      Vector_3d worst;
      double least = (std::numeric_limits<double>::infinity)();
      for (const Corner* c = surface_.corners_begin(v); c != surface_.corners_end(v); ++c) {
        const Vector_3d n = normalized(surface_.corner_normal(v, *c));
        if (dot(n, d) < least) {
          least = dot(n, d);
          worst = n;
        }
      }
      if (!(least <= best.visibility))
        best = {d, least};
      d = normalized(d + (1. / (step + 1)) * (surface_.along_rims(v, worst) - d));
    }
  }

  const Layer_surface& surface_;
};

/* The unit vectors along which layers grow, one a vertex: the Gouraud normal, turned where a face around the vertex
 * would not see it, smoothed, and kept in the plane of the rim at rims. Each keeps at least a part of the largest
 * visibility that there is: the smallest product with the normals of the corners around. Linear. */
class Layer_directions {
public:
  typedef Layer_surface::Index Index;
  typedef Layer_surface::Corner Corner;

  explicit Layer_directions(const Layer_surface& surface)
      : surface_(surface)
      , best_(surface)
      , directions_(surface.number_of_vertices())
      , least_visibility_(surface.number_of_vertices()) {
    for (Index v = 0; v < directions_.size(); ++v)
      start(v);
    for (int sweep = 0; sweep < 3; ++sweep)
      smooth();
  }

  const std::vector<Vector_3d>& directions() const { return directions_; }

  // What must be left of visibility when a direction is changed.
  double least_visibility(Index v) const { return least_visibility_[v]; }

  double visibility(Index v, const Vector_3d& d) const { return best_.visibility(v, d); }

private:
  static constexpr double good_visibility = 0.8;
  static constexpr double kept_visibility = 0.7; // part of the largest, by smoothing

  void start(Index v) {
    if (best_.is_flat(v))
      throw Input_error("A face of the wall has an angle of 0 or 180 degrees at " + place_of(surface_.points[v]) +
                        ": no cell on it is valid; repair the surface, or mesh it again.");
    const Seen_direction best = best_(v);
    if (!(best.visibility > Best_layer_direction::no_visibility))
      throw Meshing_error("No direction at " + place_of(surface_.points[v]) +
                          " leads away from all faces of the wall around it: the surface is folded there; repair it, "
                          "or mesh it again.");
    directions_[v] = best.direction;
    least_visibility_[v] = kept_visibility * best.visibility;
  }

  // Towards the mean of the neighbours, as far as all faces still see it.
  void smooth() {
    const std::vector<Vector_3d> before = directions_;
    for (Index v = 0; v < directions_.size(); ++v) {
      Vector_3d mean;
      for (const Index* w = surface_.neighbors_begin(v); w != surface_.neighbors_end(v); ++w)
        mean += before[*w];
      mean = normalized(mean);
      for (double part : {0.5, 0.25, 0.1}) {
        const Vector_3d d = normalized(surface_.along_rims(v, (1 - part) * before[v] + part * mean));
        if (visibility(v, d) >= (std::min)(least_visibility_[v], good_visibility)) {
          directions_[v] = d;
          break;
        }
      }
    }
  }

  const Layer_surface& surface_;
  const Best_layer_direction best_;
  std::vector<Vector_3d> directions_;
  std::vector<double> least_visibility_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LAYER_DIRECTIONS_H
