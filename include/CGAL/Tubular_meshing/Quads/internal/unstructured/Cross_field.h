// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_CROSS_FIELD_H
#define CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_CROSS_FIELD_H

#include <CGAL/Tubular_meshing/Plane/Metric_tensor_2.h>
#include <CGAL/Tubular_meshing/Plane/Plane_triangle_tree.h>
#include <CGAL/Tubular_meshing/Plane/Triangle_adjacency.h>
#include <CGAL/Tubular_meshing/Plane/Plane_triangulation.h>
#include <CGAL/Tubular_meshing/base/constants.h>

#include <Eigen/Core>

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The square root of a metric, and its inverse: between vectors of the plane, and those of unit lengths and right
 * angles. */
struct Metric_root {
  double xx, xy, yy;
  explicit Metric_root(const Metric_tensor_2& m) {
    const double root = std::sqrt(m.determinant()), s = 1 / std::sqrt(m.xx + m.yy + 2 * root);
    xx = s * (m.xx + root);
    xy = s * m.xy;
    yy = s * (m.yy + root);
  }
  Eigen::Vector2d to_metric(const Eigen::Vector2d& v) const {
    return Eigen::Vector2d(xx * v.x() + xy * v.y(), xy * v.x() + yy * v.y());
  }
  Eigen::Vector2d from_metric(const Eigen::Vector2d& w) const {
    const double d = xx * yy - xy * xy;
    return Eigen::Vector2d(yy * w.x() - xy * w.y(), xx * w.y() - xy * w.x()) / d;
  }
};

/* A field of crosses, of four directions at right angles, on a patch: along its loops at these, and as smooth as can be
 * between them; with the sizes that suit it. At the vertices of a triangulation, as the fourth powers of their
 * directions in the metric: relaxed first without, then with unit length. O(n) for a fixed number of sweeps. */
class Cross_field {
public:
  Cross_field(const Plane_triangulation<Plane_point>& plane, const Plane_polygons& polygons, Plane_field metric)
      : uv_(places(plane))
      , triangles_(corners(plane))
      , tree_(uv_, triangles_)
      , powers_(uv_.size(), std::complex<double>(0, 0)) {
    std::vector<std::size_t> ends;
    std::size_t first = 0;
    for (const auto& polygon : polygons) {
      const std::size_t n = polygon.size();
      for (std::size_t i = 0; i < n; ++i) {
        const Eigen::Vector2d along = uv_[first + (i + 1) % n] - uv_[first + (i + n - 1) % n];
        const Eigen::Vector2d w = Metric_root(metric(polygon[i])).to_metric(along);
        powers_[first + i] = std::polar(1., 4 * std::atan2(w.y(), w.x()));
      }
      first += n;
      ends.push_back(first);
    }
    relax(first);
    set_sizes(ends);
  }

  struct Cross {
    double angle; // of one of its directions, in the metric
    double size;  // of sides, in the plane
  };
  Cross operator()(const Eigen::Vector2d& uv) const {
    Nearest_in_triangle nearest;
    const Patch_triangle& t = triangles_[std::size_t(tree_.nearest(uv_, triangles_, uv, nearest))];
    std::complex<double> power(0, 0);
    double size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      power += nearest.barycentric[i] * powers_[std::size_t(t[i])];
      size += nearest.barycentric[i] * sizes_[std::size_t(t[i])];
    }
    return {std::arg(power) / 4, std::exp(size)};
  }

private:
  static std::vector<Eigen::Vector2d> places(const Plane_triangulation<Plane_point>& plane) {
    std::vector<Eigen::Vector2d> result;
    for (const auto& p : plane.points)
      result.emplace_back(p.x(), p.y());
    return result;
  }
  static std::vector<Patch_triangle> corners(const Plane_triangulation<Plane_point>& plane) {
    std::vector<Patch_triangle> result;
    for (const auto& t : plane.triangles)
      result.push_back({{int(t[0]), int(t[1]), int(t[2])}});
    return result;
  }

  void relax(std::size_t on_loops) {
    const int free_sweeps = 60, unit_sweeps = 60;
    const Outgoing_halfedges outgoing(triangles_, uv_.size());
    for (int sweep = 0; sweep < free_sweeps + unit_sweeps; ++sweep)
      for (std::size_t i = on_loops; i < uv_.size(); ++i) {
        const std::size_t v = in_turn(i, sweep, on_loops);
        const std::complex<double> mean = mean_around(powers_, outgoing, v);
        if (sweep < free_sweeps)
          powers_[v] += overrelaxation * (mean - powers_[v]);
        else if (std::abs(mean) > 0)
          powers_[v] = mean / std::abs(mean);
      }
  }

  /* log of the plane's length of sides: that of the loops' edges, and between them the one whose metric is flat but for
   * the turns of the field, where quads of other than four at a vertex are to be: there, edges can be of the wanted
   * length in both directions of the crosses (G. Bunin, *A continuum theory for unstructured mesh generation in two
   * dimensions*, Comput. Aided Geom. Des. 25, 2008). */
  void set_sizes(const std::vector<std::size_t>& loop_ends) {
    const int sweeps = 150;
    const double cotangent = root_of_3 / 3; // of the angles of T0's triangles
    sizes_.assign(uv_.size(), 0);
    std::size_t first = 0;
    double sum = 0;
    for (std::size_t end : loop_ends) {
      for (std::size_t v = first; v < end; ++v) {
        const std::size_t next = v + 1 < end ? v + 1 : first, last = v > first ? v - 1 : end - 1;
        sizes_[v] = std::log(((uv_[next] - uv_[v]).norm() + (uv_[v] - uv_[last]).norm()) / 2);
        sum += sizes_[v];
      }
      first = end;
    }
    for (std::size_t v = first; v < uv_.size(); ++v)
      sizes_[v] = sum / double(first);
    std::vector<double> source(uv_.size(), 0);
    for (const Patch_triangle& t : triangles_) {
      double turn = 0;
      for (std::size_t i = 0; i < 3; ++i)
        turn += std::arg(powers_[std::size_t(t[(i + 1) % 3])] * std::conj(powers_[std::size_t(t[i])]));
      const double curvature = turn / 4; // a quarter of a turn a quad that is too many
      for (int v : t)
        source[std::size_t(v)] -= curvature / 3;
    }
    const Outgoing_halfedges outgoing(triangles_, uv_.size());
    for (int sweep = 0; sweep < sweeps; ++sweep)
      for (std::size_t i = first; i < uv_.size(); ++i) {
        const std::size_t v = in_turn(i, sweep, first);
        const double n = double(outgoing.end(int(v)) - outgoing.begin(int(v)));
        const double wanted = mean_around(sizes_, outgoing, v) + source[v] / (n * cotangent);
        sizes_[v] += overrelaxation * (wanted - sizes_[v]);
      }
  }

  std::size_t in_turn(std::size_t i, int sweep, std::size_t first) const {
    return sweep % 2 == 0 ? i : uv_.size() - 1 - (i - first);
  }
  template <class Value>
  Value mean_around(const std::vector<Value>& values, const Outgoing_halfedges& outgoing, std::size_t v) const {
    Value sum(0);
    for (const int* h = outgoing.begin(int(v)); h != outgoing.end(int(v)); ++h)
      sum += values[std::size_t(target_of(triangles_, *h))];
    return sum / double(outgoing.end(int(v)) - outgoing.begin(int(v)));
  }

  static constexpr double overrelaxation = 1.7;

  std::vector<Eigen::Vector2d> uv_;
  std::vector<Patch_triangle> triangles_;
  Plane_triangle_tree tree_;
  std::vector<std::complex<double>> powers_;
  std::vector<double> sizes_; // logarithms
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_CROSS_FIELD_H
