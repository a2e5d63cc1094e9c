// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_COLUMN_OPTIMIZER_H
#define CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_COLUMN_OPTIMIZER_H

#include <CGAL/Tubular_meshing/Layers/internal/Layer_directions.h>
#include <CGAL/Tubular_meshing/base/Plane_frame.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Turns the directions of single columns of cells, thicknesses kept, until the angles of the cells around are as close
 * to right angles as they get: of hexahedra all, of prisms those of their sides. What is lowered is the sum of the
 * sixth powers of the angles' cosines, near and far; the worst angles decide. A turn that would fold the far side costs
 * more than any angle. Only columns with bad angles are turned, and after them their neighbours. */
class Column_optimizer {
public:
  typedef Layer_surface::Index Index;
  typedef Layer_surface::Corner Corner;

  Column_optimizer(const Layer_surface& surface, const Layer_directions& visibility,
                   const std::vector<double>& thickness, std::vector<Vector_3d>& directions)
      : surface_(surface)
      , visibility_(visibility)
      , thickness_(thickness)
      , directions_(directions) {}

  void run() {
    std::vector<char> active(directions_.size(), 0);
    for (Index v = 0; v < directions_.size(); ++v)
      active[v] = cost(v, directions_[v]) > cost_of_bad_angle;
    for (double step : {0.2, 0.1, 0.05, 0.1, 0.05, 0.025})
      active = sweep(active, step);
  }

private:
  static constexpr double cost_of_bad_angle = 5e-5; // one angle of 79 or 101 degrees, or several a little better
  static constexpr double folding = 0.25;           // of a corner's area, far and near, below which it costs
  static constexpr double fold_cost = 10;

  // Returns which columns are to be looked at next.
  std::vector<char> sweep(const std::vector<char>& active, double step) {
    std::vector<char> next(active.size(), 0);
    for (Index v = 0; v < directions_.size(); ++v) {
      if (!active[v])
        continue;
      double best = cost(v, directions_[v]);
      if (!(best > cost_of_bad_angle) || !turn(v, step, best))
        continue;
      next[v] = 1;
      for (const Index* w = surface_.neighbors_begin(v); w != surface_.neighbors_end(v); ++w)
        next[*w] = 1;
    }
    for (Index v = 0; v < directions_.size(); ++v) // those that stay may take a smaller step
      next[v] = next[v] || active[v];
    return next;
  }

  bool turn(Index v, double step, double& best) {
    const Vector_3d d = directions_[v];
    const Plane_frame across(Vector_3d(), d);
    // down the slope of the cost, found by differences
    const double h = 0.2 * step;
    const auto at = [&](double a, double b) {
      return normalized(surface_.along_rims(v, d + a * across.u + b * across.v));
    };
    const double du = cost(v, at(h, 0)) - cost(v, at(-h, 0)), dw = cost(v, at(0, h)) - cost(v, at(0, -h));
    const double slope = std::sqrt(du * du + dw * dw);
    if (!(slope > 0))
      return false;
    for (double length : {step, 0.4 * step}) {
      const Vector_3d turned = at(-length * du / slope, -length * dw / slope);
      const double c = cost(v, turned);
      if (c < 0.999 * best && visibility_.visibility(v, turned) >= visibility_.least_visibility(v)) {
        best = c;
        directions_[v] = turned;
        return true;
      }
    }
    return false;
  }

  // Of the angles that the direction of v has a part in.
  double cost(Index v, const Vector_3d& direction) const {
    const Vector_3d& p = surface_.points[v];
    const Vector_3d to_far = thickness_[v] * direction;
    double sum = 0;
    for (const Index* w = surface_.neighbors_begin(v); w != surface_.neighbors_end(v); ++w) {
      const Vector_3d near = surface_.points[*w] - p;
      const Vector_3d far = near + (thickness_[*w] * directions_[*w] - to_far);
      const double n2 = squared_norm(near), f2 = squared_norm(far);
      sum += power(dot(near, direction), n2) + power(dot(far, direction), f2) + power(dot(far, directions_[*w]), f2);
    }
    for (const Corner* c = surface_.corners_begin(v); c != surface_.corners_end(v); ++c) {
      const Layer_surface::Face& f = surface_.faces[c->face];
      const Vector_3d far_v = p + to_far, next = far(c->next), previous = far(c->previous);
      const bool is_quad = Layer_surface::degree(f) == 4;
      sum += corner_cost(far_v, next, previous, surface_.corner_normal(v, *c), direction, is_quad);
      if (!is_quad)
        continue;
      const Index opposite = f[0] + f[1] + f[2] + f[3] - v - c->next - c->previous;
      const Vector_3d across = far(opposite);
      sum +=
          corner_cost(next, across, far_v, corner_normal(c->next, opposite, v), directions_[c->next], true) +
          corner_cost(previous, far_v, across, corner_normal(c->previous, v, opposite), directions_[c->previous], true);
    }
    return sum;
  }

  Vector_3d far(Index v) const { return surface_.points[v] + thickness_[v] * directions_[v]; }
  Vector_3d corner_normal(Index v, Index next, Index previous) const {
    return cross(surface_.points[next] - surface_.points[v], surface_.points[previous] - surface_.points[v]);
  }

  static double corner_cost(const Vector_3d& p, const Vector_3d& next, const Vector_3d& previous,
                            const Vector_3d& near_normal, const Vector_3d& direction, bool is_quad) {
    const Vector_3d a = next - p, b = previous - p;
    const double near = dot(near_normal, direction), far = dot(cross(a, b), direction);
    double sum = is_quad ? power(dot(a, b), squared_norm(a) * squared_norm(b)) : 0;
    if (!(far > folding * near))
      sum += near > 0 ? fold_cost * (1 + (std::min)(folding - far / near, 100.)) : 1000 * fold_cost;
    return sum;
  }

  static double power(double product, double squared_length) {
    const double c2 = squared_length > 0 ? product * product / squared_length : 1;
    return c2 * c2 * c2;
  }

  const Layer_surface& surface_;
  const Layer_directions& visibility_;
  const std::vector<double>& thickness_;
  std::vector<Vector_3d>& directions_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_COLUMN_OPTIMIZER_H
