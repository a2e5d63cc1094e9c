// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_PATCH_QUADRANGULATOR_H
#define CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_PATCH_QUADRANGULATOR_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Cross_field.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/One_defect_remesher.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Quad_cleaner.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Quad_patch.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Quad_smoother.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Sheet.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Square_packer.h>
#include <CGAL/Tubular_meshing/Quads/recombine_triangles.h>
#include <CGAL/Tubular_meshing/Plane/Metric_tensor_2.h>
#include <CGAL/Tubular_meshing/Plane/Metric_plane.h>
#include <CGAL/Tubular_meshing/Plane/Plane_flips.h>
#include <CGAL/Tubular_meshing/Plane/triangulate_in_metric.h>
#include <CGAL/Tubular_meshing/Plane/triangulate_polygons.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Fills a patch, or a cap, with quads between the points of its loops, an even number in all.
 *
 * The chart gives the metric of the wanted size over the plane, the sheet the surface over it. */
class Patch_quadrangulator {
public:
  Patch_quadrangulator(const Sheet_over_plane& sheet, const Chart& chart, const Plane_polygons& polygons)
      : sheet_(sheet)
      , chart_(chart)
      , polygons_(polygons) {
    for (const auto& polygon : polygons)
      for (const Plane_point& p : polygon) {
        loop_places_.emplace_back();
        sheet_.place(Eigen::Vector2d(p.x(), p.y()), -1, loop_places_.back());
      }
  }

  /* False if there are no quads alone, or the polygons do not bound a domain. Right triangles come first; where their
   * quads are bad, isotropic ones of several sizes are tried. */
  bool run() {
    const auto isotropic = isotropic_triangles(1);
    if (!isotropic)
      return false;
    if (const auto right = right_triangles(*isotropic))
      try_triangles(*right);
    for (double factor : {1., 0.9, 1.12, 0.8})
      if (best_quality_ < tolerable_quality)
        try_triangles(factor == 1 ? *isotropic : *isotropic_triangles(factor));
    return !best_.quads.empty();
  }

  const Quad_patch& mesh() const { return best_; }

private:
  typedef Plane_triangulation<Plane_point> Triangles;

  static constexpr double tolerable_quality = 0.1; // where all that is left to do is to move curves
  static constexpr double wanted_quality = 0.65;   // three quads at a vertex have 2/3 at most
  // An equilateral triangle with sides as long as this has half the area of a square of side one.
  static constexpr double triangle_side = 1.0746;

  std::optional<Triangles> isotropic_triangles(double factor) const {
    return chart_.mesh(polygons_, true, 1 / (triangle_side * triangle_side * factor * factor));
  }

  // None where the chart has no metric at a point that is asked for: isotropic ones ask for others.
  std::optional<Triangles> right_triangles(const Triangles& isotropic) const {
    const auto metric = [this](const Plane_point& uv) { return chart_.metric(uv); };
    std::string problem;
    std::optional<Plane_store> store = triangulate_polygons(polygons_, problem);
    if (!store)
      return std::nullopt;
    try {
      Metric_plane plane(*std::move(store), polygons_, metric);
      Plane_flips(plane).make_delaunay();
      const Cross_field field(isotropic, polygons_, metric);
      Square_packer(plane, field).run();
      return plane.triangulation();
    } catch (const Parameter_error&) {
      return std::nullopt;
    }
  }

  void try_triangles(const Triangles& triangles) {
    Quad_patch mesh;
    if (make_from(triangles, mesh)) {
      improve(mesh);
      keep_if_better(std::move(mesh));
    }
  }

  bool make_from(const Triangles& plane, Quad_patch& mesh) const {
    std::vector<Point_3> points;
    mesh.on_loops = loop_places_.size();
    int hint = -1;
    for (std::size_t i = 0; i < plane.points.size(); ++i) {
      Sheet_place at;
      if (i < mesh.on_loops)
        at = loop_places_[i];
      else if (!sheet_.place(Eigen::Vector2d(plane.points[i].x(), plane.points[i].y()), hint, at))
        return false;
      hint = at.triangle;
      points.push_back(as<Point_3>(at.point));
      mesh.add_vertex(at);
    }
    const auto recombined = recombine_triangles(points, plane.triangles);
    if (!recombined.triangles.empty())
      return false;
    for (std::size_t i = points.size(); i < recombined.points.size(); ++i)
      mesh.add_vertex(Sheet_place());
    for (const auto& q : recombined.quads)
      mesh.add_quad({{int(q[0]), int(q[1]), int(q[2]), int(q[3])}});
    for (int v = int(points.size()); v < int(mesh.places.size()); ++v)
      if (!place_between_neighbours(v, mesh))
        return false;
    return true;
  }

  bool place_between_neighbours(int v, Quad_patch& mesh) const {
    Eigen::Vector2d sum(0, 0);
    int n = 0, hint = -1;
    for (int q : mesh.quads_at(v)) {
      const Sheet_place& w = mesh.places[std::size_t(mesh.after(q, v))];
      if (w.triangle < 0)
        continue;
      sum += w.uv;
      hint = w.triangle;
      ++n;
    }
    return n > 0 && sheet_.place(sum / n, hint, mesh.places[std::size_t(v)]);
  }

  void improve(Quad_patch& mesh) const {
    const int most_rounds = 3;
    Quad_smoother smoother(mesh, sheet_);
    set_loop_valences(mesh);
    smoother.relax(smoother.inner_vertices(), 8);
    for (int round = 0; round < most_rounds; ++round) {
      const bool local = Quad_cleaner(mesh, sheet_).run();
      const bool global = One_defect_remesher(mesh, sheet_).run();
      if (!local && !global)
        break;
    }
    const std::vector<int> inside = smoother.inner_vertices();
    smoother.relax(inside, 30);
    smoother.raise_worst(inside, wanted_quality, 10);
  }

  // By the angles between the edges of the loops, on the surface.
  void set_loop_valences(Quad_patch& mesh) const {
    std::size_t first = 0;
    for (const auto& polygon : polygons_) {
      const std::size_t n = polygon.size();
      for (std::size_t i = 0; i < n; ++i) {
        const Sheet_place& at = loop_places_[first + i];
        const Vector_3d to_next = loop_places_[first + (i + 1) % n].point - at.point;
        const Vector_3d to_last = loop_places_[first + (i + n - 1) % n].point - at.point;
        double angle = std::atan2(dot(at.normal, cross(to_next, to_last)), dot(to_next, to_last));
        if (angle < 0)
          angle += 2 * pi;
        mesh.loop_valences.push_back((std::max)(1, int(std::lround(angle / (pi / 2)))));
      }
      first += n;
    }
  }

  void keep_if_better(Quad_patch&& mesh) {
    const double quality = mesh.least_quality();
    if (best_.quads.empty() || quality > best_quality_) {
      best_quality_ = quality;
      best_ = std::move(mesh);
    }
  }

  const Sheet_over_plane& sheet_;
  const Chart& chart_;
  const Plane_polygons& polygons_;
  std::vector<Sheet_place> loop_places_;
  Quad_patch best_;
  double best_quality_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_PATCH_QUADRANGULATOR_H
