// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_LUMEN_INTEGRATOR_H
#define CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_LUMEN_INTEGRATOR_H

#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesh_estimate.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/lumen_columns.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Labelled_surface.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Integrates over a lumen, its wall and its caps what the number of cells goes with.
 *
 * Over the lumen: along rays from the wall inward, up to the local radius r, where at the distance d from the wall an
 * area dA has become (1 - d / r) dA, as in a tube. In a sac it becomes less, at a junction more: all is scaled by what
 * the volume is known to be. As many rays are shot as tell it within a hundredth, whatever the number of triangles, from
 * where there are most cells. */
class Lumen_integrator {
public:
  typedef Function_view<double(const Point_3&)> Length;

  /* `layers`: how much of the local radius layers along the wall take up. */
  Lumen_integrator(const Labelled_surface& surface, Length size, Length radius, double layers, int threads)
      : surface_(surface)
      , radius_(radius)
      , layers_(layers)
      , threads_(threads) {
    add_faces(size);
    add_rims(size);
    choose_rays();
    rays_scale_ = volume() / (std::max)(sum_over_rays([](const Point_3&) { return 1.; }, 0), 1e-300);
    result_.cubes = over_lumen([&](const Point_3& p) { return std::pow(size(p), -3); }, 0);
    result_.inner_cubes =
        layers_ > 0 ? over_lumen([&](const Point_3& p) { return std::pow(size(p), -3); }, layers_) : result_.cubes;
    result_.layer_thickness = layers_;
  }

  const Lumen_integrals& integrals() const { return result_; }
  double smallest_size() const { return smallest_size_; }
  double largest_size() const { return largest_size_; }

  /* Those of a metric. */
  template <class Metric> void add_metric(const Metric& metric) {
    result_.metric_cubes = over_lumen([&](const Point_3& p) { return metric(p).density(); }, 0);
    std::vector<double> part(rays_.size());
    for_each_range(rays_.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        part[i] = rays_[i].area * realized(metric(rays_[i].source), rays_[i].inward);
    });
    result_.metric_wall = std::accumulate(part.begin(), part.end(), 0.);
    std::vector<Face> caps;
    for (Face f : surface_.surface.faces())
      if (surface_.patch[f] != labels::wall)
        caps.push_back(f);
    part.assign(caps.size(), 0);
    for_each_range(caps.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        part[i] = over_face(caps[i], [&, n = normal(caps[i])](const Point_3& p) { return in_plane(metric(p), n); });
    });
    result_.metric_caps = std::accumulate(part.begin(), part.end(), 0.);
  }

private:
  typedef Surface::Face_index Face;

  struct Ray {
    Point_3 source;
    Vector_3 inward; // of unit length
    double area;     // that it stands for
    double radius;
  };

  static constexpr std::size_t most_rays = 8192;

  std::array<Point_3, 3> corners(Face f) const {
    const Surface& s = surface_.surface;
    const auto h = s.halfedge(f);
    return {s.point(s.source(h)), s.point(s.target(h)), s.point(s.target(s.next(h)))};
  }
  // Twice the area, outward.
  Vector_3 double_area(Face f) const {
    const auto c = corners(f);
    return CGAL::cross_product(c[1] - c[0], c[2] - c[0]);
  }
  Vector_3 normal(Face f) const {
    const Vector_3 n = double_area(f);
    const double length = std::sqrt(n.squared_length());
    return length > 0 ? n / length : Vector_3(0, 0, 1);
  }

  // A function's integral over a face: exact where it is quadratic.
  template <class Function> double over_face(Face f, const Function& function) const {
    const auto c = corners(f);
    double sum = 0;
    for (int i = 0; i < 3; ++i)
      sum += function(CGAL::midpoint(c[i], c[(i + 1) % 3]));
    return std::sqrt(double_area(f).squared_length()) / 2 * sum / 3;
  }

  void add_faces(Length size) {
    const Surface& s = surface_.surface;
    squares_.assign(s.number_of_faces(), 0);
    std::vector<std::array<double, 2>> range(squares_.size(), {1e300, 0});
    for_each_range(squares_.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        squares_[i] = over_face(Face(Surface::size_type(i)), [&, &r = range[i]](const Point_3& p) {
          const double h = size(p);
          r = {(std::min)(r[0], h), (std::max)(r[1], h)};
          return 1 / (h * h);
        });
    });
    smallest_size_ = 1e300;
    for (Face f : s.faces()) {
      const std::size_t i = std::size_t(f);
      const bool is_wall = surface_.patch[f] == labels::wall;
      (is_wall ? result_.wall_squares : result_.cap_squares) += squares_[i];
      if (!is_wall) {
        squares_[i] = 0; // no rays from there
        continue;
      }
      smallest_size_ = (std::min)(smallest_size_, range[i][0]);
      largest_size_ = (std::max)(largest_size_, range[i][1]);
    }
  }

  void add_rims(Length size) {
    const Surface& s = surface_.surface;
    for (auto e : s.edges()) {
      const auto h = s.halfedge(e);
      if (s.is_border(e) ||
          (surface_.patch[s.face(h)] == labels::wall) == (surface_.patch[s.face(s.opposite(h))] == labels::wall))
        continue;
      const Point_3 &p = s.point(s.source(h)), &q = s.point(s.target(h));
      result_.rims += std::sqrt(CGAL::squared_distance(p, q)) / size(CGAL::midpoint(p, q));
    }
  }

  /* Each stands for as many squares of the mesh size; they are evenly spread over the faces in their order. */
  void choose_rays() {
    const double total = result_.wall_squares;
    const std::size_t n = (std::min)(most_rays, squares_.size());
    double sum = 0;
    std::size_t k = 0;
    for (std::size_t i = 0; i < squares_.size() && total > 0; ++i) {
      sum += squares_[i];
      for (; k < n && (double(k) + 0.5) / double(n) * total < sum; ++k) {
        const Face f(Surface::size_type{Surface::size_type(i)});
        const auto c = corners(f);
        const double area = std::sqrt(double_area(f).squared_length()) / 2;
        rays_.push_back({CGAL::centroid(c[0], c[1], c[2]), -normal(f), area / squares_[i] * total / double(n), 0});
      }
    }
    for_each_range(rays_.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        rays_[i].radius = radius_(rays_[i].source);
    });
  }

  double volume() const { return std::abs(CGAL::to_double(CGAL::Polygon_mesh_processing::volume(surface_.surface))); }

  template <class Function> double over_lumen(const Function& function, double from) const {
    return rays_scale_ * sum_over_rays(function, from);
  }

  // `from`: in radii.
  template <class Function> double sum_over_rays(const Function& function, double from) const {
    const std::vector<double> ends = pieces_of_radius(from);
    std::vector<double> part(rays_.size());
    for_each_range(rays_.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const Ray& ray = rays_[i];
        part[i] =
            ray.area * over_column(ends, ray.radius, [&](double d) { return function(ray.source + d * ray.inward); });
      }
    });
    return std::accumulate(part.begin(), part.end(), 0.);
  }

  // Elements of unit size on a unit of area.
  static double in_plane(const Metric_tensor_3& m, const Vector_3& normal) {
    return m.density() * m.inverse().length(normal);
  }

  // The same on a wall.
  static double realized(const Metric_tensor_3& m, const Vector_3& normal) {
    const std::array<double, 3> sizes = m.sizes(); // the first is that across the wall
    return in_plane(m, normal) * realized_share(sizes[2] / sizes[1]);
  }

  const Labelled_surface& surface_;
  Length radius_;
  double layers_;
  int threads_;
  Lumen_integrals result_;
  std::vector<double> squares_; // of each face of the wall
  std::vector<Ray> rays_;
  double rays_scale_ = 1;
  double smallest_size_ = 0, largest_size_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_LUMEN_INTEGRATOR_H
