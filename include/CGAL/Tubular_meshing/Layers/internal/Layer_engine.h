// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LAYER_ENGINE_H
#define CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LAYER_ENGINE_H

#include <CGAL/Tubular_meshing/Layers/Layer_report.h>
#include <CGAL/Tubular_meshing/Layers/internal/Column_optimizer.h>
#include <CGAL/Tubular_meshing/Layers/internal/Layer_levels.h>
#include <CGAL/Tubular_meshing/Layers/internal/Layer_thickness.h>
#include <CGAL/Tubular_meshing/Rims/planar_cap.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

struct Layer_options {
  Layer_levels levels;       // 0 at the surface, …, 1 on the far side of the last layer
  double part_of_gap = 0.75; // that a thickness may take of the way to the middle of a gap
  bool tetrahedral = false;  // cells will be cut
  bool inward = false;       // the far side is closed by new caps in its own rims, not by the rings and those there are
  int threads = 0;
};

/* Finds for each vertex of a surface the vector from it to the far side of the layers, such that all cells are positive
 * and none overlaps another.
 *
 * Cells are positive if their Jacobians are, at all corners on all levels. If so, and if the boundary of all does not
 * cross itself, they cannot overlap: how often they cover a point is how often the boundary winds around it. Where one
 * or the other is not so, columns that were turned for better angles are turned back, and, if that is not it, the
 * thickness around is reduced, until all is well. */
class Layer_engine {
public:
  typedef Layer_surface::Index Index;
  typedef Layer_surface::Corner Corner;
  typedef Layer_surface::Face Face;

  /* \param points those of the surface, and then others
   * \param obstacles triangles that the layers must stay clear of, by points
   * \param closure triangles that close the far side with its rims */
  Layer_engine(const Layer_surface& surface, std::vector<Vector_3d> points,
               std::vector<Layer_surface::Triangle> obstacles, std::vector<Layer_surface::Triangle> closure,
               std::vector<double> wanted, const Layer_options& options)
      : surface_(surface)
      , points_(std::move(points))
      , obstacles_(std::move(obstacles))
      , closure_(std::move(closure))
      , options_(options)
      , directions_(surface)
      , direction_(directions_.directions())
      , asked_(std::move(wanted))
      , wanted_(asked_) {
    limit_slope(surface_, largest_slope, wanted_);
    thickness_ = wanted_;
    share_gaps(surface_, points_, obstacles_, direction_, options_.part_of_gap, options_.threads, thickness_);
    limit_slope(surface_, largest_slope, thickness_);
    Column_optimizer(surface_, directions_, thickness_, direction_).run();
    make_valid();
  }

  Vector_3d vector(Index v) const { return thickness_[v] * direction_[v]; }
  double thickness(Index v) const { return thickness_[v]; }
  // What was asked for, and as much of it as may be: it changes along no edge by more than a part of the length.
  double asked(Index v) const { return asked_[v]; }
  double wanted(Index v) const { return wanted_[v]; }
  int rounds() const { return rounds_; }

private:
  static constexpr double largest_slope = 0.4; // of the far side against the near one
  static constexpr double least_area = 0.1;    // of the far side, against the near one, along the direction
  static constexpr double reduction = 0.7;
  static constexpr int most_rounds = 40;

  void make_valid() {
    for (rounds_ = 0; rounds_ < most_rounds; ++rounds_) {
      std::vector<Index> bad = folded_vertices();
      if (bad.empty())
        bad = crossing_vertices();
      if (bad.empty())
        return check_rounded_cells();
      place_ = surface_.points[bad.front()];
      std::sort(bad.begin(), bad.end());
      bad.erase(std::unique(bad.begin(), bad.end()), bad.end());
      give_way(bad);
    }
    throw Meshing_error("No layers without folded or overlapping cells were found at " + place_of(place_) +
                        ", however thin: the surface may intersect itself there, or have folds; repair it, or mesh it "
                        "again.");
  }

  // From a vertex to a side of a layer.
  Vector_3d at_level(Index v, std::size_t k) const { return options_.levels(v, k) * vector(v); }

  // By the direction that was there before the column was turned, for which gaps were measured; then by the thickness.
  void give_way(const std::vector<Index>& bad) {
    std::vector<Index> unturned;
    const auto turn_back = [&](Index v) {
      const Vector_3d& d = directions_.directions()[v];
      const bool was_turned = squared_norm(d - direction_[v]) > 0;
      direction_[v] = d;
      return was_turned;
    };
    for (Index v : bad) {
      bool turned = turn_back(v);
      for (const Index* w = surface_.neighbors_begin(v); w != surface_.neighbors_end(v); ++w)
        turned = turn_back(*w) || turned;
      if (!turned)
        unturned.push_back(v);
    }
    for (Index v : unturned)
      thickness_[v] *= reduction;
    limit_slope(surface_, largest_slope, thickness_);
  }

  std::vector<Index> folded_vertices() const {
    std::vector<Index> bad;
    for (Index v = 0; v < surface_.number_of_vertices(); ++v) {
      const Vector_3d d = vector(v);
      for (const Corner* c = surface_.corners_begin(v); c != surface_.corners_end(v); ++c) {
        const Vector_3d a = surface_.points[c->next] - surface_.points[v],
                        b = surface_.points[c->previous] - surface_.points[v];
        const double area = dot(cross(a, b), d);
        for (std::size_t k = 1; k < options_.levels.size(); ++k) {
          const Vector_3d from = at_level(v, k), da = at_level(c->next, k) - from, db = at_level(c->previous, k) - from;
          if (!(dot(cross(a + da, b + db), d) > least_area * area)) {
            bad.insert(bad.end(), {v, c->next, c->previous});
            break;
          }
        }
      }
    }
    if (options_.tetrahedral)
      for (const Face& f : surface_.faces)
        if (Layer_surface::degree(f) == 3 && !has_positive_tetrahedra(f))
          bad.insert(bad.end(), {f[0], f[1], f[2]});
    return bad;
  }

  // What is far from the origin, and thin, may be folded by the rounding of its points.
  void check_rounded_cells() const {
    const std::size_t levels = options_.levels.size();
    const auto at = [&](Index v, std::size_t k) { return surface_.points[v] + at_level(v, k); };
    for (Index v = 0; v < surface_.number_of_vertices(); ++v)
      for (const Corner* c = surface_.corners_begin(v); c != surface_.corners_end(v); ++c)
        for (std::size_t k = 0; k < levels; ++k) {
          const Vector_3d p = at(v, k), n = cross(at(c->next, k) - p, at(c->previous, k) - p);
          if ((k > 0 && !(dot(n, p - at(v, k - 1)) > 0)) || (k + 1 < levels && !(dot(n, at(v, k + 1) - p) > 0)))
            throw Meshing_error("The layers at " + place_of(surface_.points[v]) +
                                " are thinner than coordinates can tell apart: ask for fewer or thicker ones, or move "
                                "the model closer to the origin.");
        }
  }

  // Of the three that a prism is cut into, two have their volumes from its corners.
  bool has_positive_tetrahedra(const Face& f) const {
    std::array<Index, 3> t = {f[0], f[1], f[2]};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    const bool turned = t[2] < t[1];
    for (std::size_t k = 0; k + 1 < options_.levels.size(); ++k) {
      const std::size_t low = k, high = k + 1;
      const auto at = [&](Index v, std::size_t level) { return surface_.points[v] + at_level(v, level); };
      // the middle one has an edge below, from the smallest vertex to the middle one, and one above
      const Index m = turned ? t[2] : t[1], l = turned ? t[1] : t[2];
      const Vector_3d a = at(t[0], low), b = at(m, low), upper_b = at(m, high), upper_c = at(l, high);
      const double volume = dot(cross(b - a, upper_c - a), upper_b - a) * (turned ? -1 : 1);
      if (!(volume > 0))
        return false;
    }
    return true;
  }

  // The vertices of crossing parts of the far side and what closes it.
  std::vector<Index> crossing_vertices() const {
    const Index n = Index(surface_.number_of_vertices()), far = Index(points_.size());
    std::vector<Vector_3d> points = points_;
    for (Index v = 0; v < n; ++v)
      points.push_back(surface_.points[v] + vector(v));
    std::vector<Layer_surface::Triangle> triangles = surface_.triangles(false, far);
    std::vector<Index> bad;
    if (options_.inward)
      close_far_rims(points, far, triangles, bad);
    else
      close_by_rings(far, triangles);
    if (!bad.empty())
      return bad;
    const auto crossings = triangle_crossings(points, triangles);
    for (const auto& pair : crossings)
      for (std::size_t t : pair)
        for (Index v : triangles[t])
          if (v >= far)
            bad.push_back(v - far);
    if (bad.empty() && !crossings.empty())
      throw Input_error("The surface crosses itself at " + place_of(points[triangles[crossings.front()[0]][0]]) +
                        "; repair it first.");
    return bad;
  }

  void close_by_rings(Index far, std::vector<Layer_surface::Triangle>& triangles) const {
    for (const Layer_surface::Rim_edge& e : surface_.rim_edges) {
      triangles.push_back({e.source, e.target, far + e.target});
      triangles.push_back({e.source, far + e.target, far + e.source});
    }
    triangles.insert(triangles.end(), closure_.begin(), closure_.end());
  }

  // Rims that are no simple polygons in their planes are bad.
  void close_far_rims(const std::vector<Vector_3d>& points, Index far, std::vector<Layer_surface::Triangle>& triangles,
                      std::vector<Index>& bad) const {
    for (const Layer_surface::Rim& rim : surface_.rims) {
      std::vector<Index> vertices;
      for (Index e : rim.edges)
        vertices.push_back(surface_.rim_edges[e].source);
      std::vector<Kernel::Point_2> polygon;
      const Plane_frame frame(points[vertices[0]], rim.normal);
      for (Index v : vertices) {
        const auto p = frame.in_plane(points[far + v]);
        polygon.emplace_back(p[0], p[1]);
      }
      const std::vector<Index_triangle> inside = triangulate_polygon(polygon);
      if (inside.empty())
        bad.insert(bad.end(), vertices.begin(), vertices.end());
      for (const Index_triangle& t : inside)
        triangles.push_back({far + vertices[t[0]], far + vertices[t[1]], far + vertices[t[2]]});
    }
  }

  const Layer_surface& surface_;
  const std::vector<Vector_3d> points_;
  const std::vector<Layer_surface::Triangle> obstacles_, closure_;
  const Layer_options options_;
  Layer_directions directions_;
  std::vector<Vector_3d> direction_;
  const std::vector<double> asked_;
  std::vector<double> wanted_, thickness_;
  Vector_3d place_;
  int rounds_ = 0;
};

/* The thickness wanted at each vertex: a multiple of the local radius. */
inline std::vector<double> multiples_of_radius(const Layer_surface& surface, Length_function radius, double factor) {
  std::vector<double> wanted;
  wanted.reserve(surface.number_of_vertices());
  for (const Vector_3d& p : surface.points) {
    const double r = radius(Point_3(p.x, p.y, p.z));
    if (!(r > 0 && r <= (std::numeric_limits<double>::max)()))
      throw Input_error("The local radius at " + place_of(p) + " is " + std::to_string(r) +
                        ", but layers need one above 0.");
    wanted.push_back(factor * r);
  }
  return wanted;
}

inline Layer_report report_of(const Layer_surface& surface, const Layer_engine& engine) {
  Layer_report report;
  report.vertices = surface.number_of_vertices();
  report.rounds = engine.rounds();
  double sum = 0;
  for (Layer_surface::Index v = 0; v < report.vertices; ++v) {
    const double ratio = engine.thickness(v) / engine.wanted(v);
    sum += ratio;
    report.reduced_vertices += ratio < 0.99;
    if (ratio < report.min_ratio) {
      report.min_ratio = ratio;
      report.worst_place = Point_3(surface.points[v].x, surface.points[v].y, surface.points[v].z);
    }
  }
  report.mean_ratio = sum / double(report.vertices);
  return report;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_LAYER_ENGINE_H
