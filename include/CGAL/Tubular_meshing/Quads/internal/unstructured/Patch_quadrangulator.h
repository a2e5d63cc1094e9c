// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_PATCH_QUADRANGULATOR_H
#define CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_PATCH_QUADRANGULATOR_H

#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Quad_patch.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Quad_smoother.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Sheet.h>
#include <CGAL/Tubular_meshing/Quads/recombine_triangles.h>
#include <CGAL/Tubular_meshing/Surface/Metric_tensor_2.h>
#include <CGAL/Tubular_meshing/Surface/triangulate_in_metric.h>
#include <CGAL/Tubular_meshing/internal/Vector_3d.h>
#include <CGAL/Tubular_meshing/parameters.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* Fills a patch, or a cap, with quads between the points of its loops, an even number in all.
 *
 * `Chart` gives the metric of the wanted size over the plane, `Sheet` the surface over it. */
template <class Point_3, class Sheet, class Chart, class Point_2> class Patch_quadrangulator {
public:
  typedef std::vector<std::vector<Point_2>> Polygons;

  Patch_quadrangulator(const Sheet& sheet, const Chart& chart, const Polygons& polygons)
      : sheet_(sheet)
      , chart_(chart)
      , polygons_(polygons) {
    for (const auto& polygon : polygons)
      for (const Point_2& p : polygon) {
        loop_places_.emplace_back();
        sheet_.place(Eigen::Vector2d(p.x(), p.y()), -1, loop_places_.back());
      }
  }

  /* False if there are no quads alone. */
  bool run() {
    const double factors[] = {1, 0.9, 1.12, 0.8};
    for (double factor : factors) {
      Quad_patch mesh;
      if (!make_from(isotropic_triangles(factor), mesh))
        continue;
      improve(mesh);
      keep_if_better(std::move(mesh));
      if (best_eta_ > good_enough)
        break;
    }
    return !best_.quads.empty();
  }

  const Quad_patch& mesh() const { return best_; }

private:
  static constexpr double good_enough = 0.3; // η
  // An equilateral triangle with sides as long as this has half the area of a square of side one.
  static constexpr double triangle_side = 1.0746;

  Plane_triangulation<Point_2> isotropic_triangles(double factor) const {
    const double s = 1 / (triangle_side * triangle_side * factor * factor);
    const auto metric = [&](const Point_2& uv) {
      const Metric_tensor_2 m = chart_.metric(uv);
      return Metric_tensor_2(s * m.xx, s * m.xy, s * m.yy);
    };
    const auto image = [&](const Point_2& uv) { return chart_.point(uv); };
    return triangulate_in_metric(polygons_, metric,
                                 parameters::embedding(image).interior_points(chart_.hidden_places()));
  }

  bool make_from(const Plane_triangulation<Point_2>& plane, Quad_patch& mesh) const {
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
      points.emplace_back(at.point.x, at.point.y, at.point.z);
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
    Quad_smoother<Sheet> smoother(mesh, sheet_);
    const std::vector<int> inside = smoother.inner_vertices();
    smoother.relax(inside, 30);
    smoother.raise_worst(inside, 0.65, 10);
  }

  void keep_if_better(Quad_patch&& mesh) {
    const double eta = mesh.least_eta();
    if (best_.quads.empty() || eta > best_eta_) {
      best_eta_ = eta;
      best_ = std::move(mesh);
    }
  }

  const Sheet& sheet_;
  const Chart& chart_;
  const Polygons& polygons_;
  std::vector<Sheet_place> loop_places_;
  Quad_patch best_;
  double best_eta_ = 0;
};

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_PATCH_QUADRANGULATOR_H
