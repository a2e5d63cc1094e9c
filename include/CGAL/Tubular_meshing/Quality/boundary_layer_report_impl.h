// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_BOUNDARY_LAYER_REPORT_IMPL_H
#define CGAL_TUBULAR_MESHING_QUALITY_BOUNDARY_LAYER_REPORT_IMPL_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Quality/boundary_layer_report.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/edges_of.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

namespace internal {

class Boundary_layer_reporter {
public:
  Boundary_layer_reporter(const Mixed_mesh& mesh, const Centerline_graph& graph, int threads)
      : mesh_(mesh)
      , graph_(graph)
      , field_(graph)
      , threads_(threads) {
    for (const Point_array& a : mesh.point_arrays)
      if (a.is_metric() && a.values.size() == 6 * mesh.points.size())
        metric_ = a.values.data();
    if (metric_ == nullptr)
      throw Input_error("The mesh has no point array `metric` of six components, which tells the sizes asked for; "
                        "anisotropic_tetrahedral_remeshing() makes one.");
  }

  Boundary_layer_report report() const {
    Boundary_layer_report r;
    r.first_height = first_heights();
    r.alignment = alignment();
    return r;
  }

private:
  typedef std::uint32_t Index;
  typedef std::array<Index, 3> Facet;

  Vector_3d point(Index v) const { return Vector_3d(mesh_.points[v]); }
  Metric_tensor_3 metric(Index v) const {
    const double* m = metric_ + 6 * std::size_t(v);
    return {m[0], m[1], m[2], m[3], m[4], m[5]};
  }

  static Facet sorted(Facet f) {
    std::sort(f.begin(), f.end());
    return f;
  }

  Measure_statistics first_heights() const {
    std::vector<Facet> wall;
    std::vector<char> is_on_wall(mesh_.points.size(), 0); // tells of most facets that they are not there
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i)
      if (mesh_.triangles.label[i] == labels::wall) {
        wall.push_back(sorted(mesh_.triangles.vertices[i]));
        for (Index v : wall.back())
          is_on_wall[v] = 1;
      }
    std::sort(wall.begin(), wall.end());
    std::vector<double> volume(mesh_.points.size(), 0), area(mesh_.points.size(), 0);
    for (std::size_t k = 0; k < mesh_.tetrahedra.size(); ++k) {
      if (mesh_.tetrahedra.label[k] != labels::lumen)
        continue;
      const auto& t = mesh_.tetrahedra.vertices[k];
      if (is_on_wall[t[0]] + is_on_wall[t[1]] + is_on_wall[t[2]] + is_on_wall[t[3]] < 3)
        continue;
      const double six_volumes =
          std::abs(dot(point(t[1]) - point(t[0]), cross(point(t[2]) - point(t[0]), point(t[3]) - point(t[0]))));
      for (int i = 0; i < 4; ++i) {
        const Facet f = {t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4]};
        if (!std::binary_search(wall.begin(), wall.end(), sorted(f)))
          continue;
        const double two_areas = norm(cross(point(f[1]) - point(f[0]), point(f[2]) - point(f[0])));
        for (Index v : f) {
          volume[v] += six_volumes;
          area[v] += two_areas;
        }
      }
    }
    std::vector<double> values;
    for (Index v = 0; v < area.size(); ++v)
      if (area[v] > 0)
        values.push_back(volume[v] / area[v] / metric(v).sizes()[0]);
    return Measure_statistics(std::move(values));
  }

  Measure_statistics alignment() const {
    const auto edges = edges_of(
        mesh_.tetrahedra, mesh_.points.size(), [](int region) { return region == labels::lumen; }, threads_);
    std::vector<double> angles(edges.size());
    for_each_range(edges.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k)
        angles[k] = angle(edges[k].first, edges[k].second);
    });
    angles.erase(std::remove(angles.begin(), angles.end(), does_not_count), angles.end());
    return Measure_statistics(std::move(angles));
  }

  static constexpr double does_not_count = -1;

  // Between a long edge and e_t.
  double angle(Index v, Index w) const {
    const Vector_3d along = point(w) - point(v);
    const Metric_tensor_3 m = 0.5 * (metric(v) + metric(w));
    const auto place = field_.descriptors_and_frame(midpoint(mesh_.points[v], mesh_.points[w]));
    const auto axes = m.eigen_system();
    const Vector_3d e_n(axes.directions[0]), line(place.second.e_t);
    const Vector_3d e_t = normalized(line - dot(line, e_n) * e_n), e_bn = cross(e_n, e_t);
    const double h_t = 1 / m.length(e_t), h_bn = 1 / m.length(e_bn), length = norm(along);
    if (!(h_t >= 2 * h_bn && length >= h_t) || is_near_bifurcation(place.first))
      return does_not_count;
    return std::acos((std::min)(std::abs(dot(along, e_t)) / length, 1.)) * 180 / CGAL_PI;
  }

  bool is_near_bifurcation(const Centerline_field::Descriptors& d) const {
    const auto& branch = graph_.branches()[d.branch];
    const auto near = [&](std::size_t node, double distance) {
      const auto& n = graph_.nodes()[node];
      return !n.is_end() && distance < 2 * graph_.radii()[n.point];
    };
    return near(branch.source, d.abscissa) || near(branch.target, branch.length - d.abscissa);
  }

  const Mixed_mesh& mesh_;
  const Centerline_graph& graph_;
  const Centerline_field field_;
  const int threads_;
  const double* metric_ = nullptr;
};

CGAL_TUBULAR_MESHING_INLINE Boundary_layer_report boundary_layer_report_on(int threads, const Mixed_mesh& mesh,
                                                                           const Centerline_graph& centerlines) {
  return Boundary_layer_reporter(mesh, centerlines, threads).report();
}

} // namespace internal

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_QUALITY_BOUNDARY_LAYER_REPORT_IMPL_H
