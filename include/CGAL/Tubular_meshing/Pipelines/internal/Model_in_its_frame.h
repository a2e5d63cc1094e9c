// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_MODEL_IN_ITS_FRAME_H
#define CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_MODEL_IN_ITS_FRAME_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/base/Canonical_frame.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_metric_field.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Fields/Size_requests.h>
#include <CGAL/Tubular_meshing/Layers/extrude_wall.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Volume/move_boundary_to_surface.h>
#include <CGAL/Tubular_meshing/Volume/preserve_volume.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A model's surface and centerlines in the model's own frame: around the origin, along its principal axes, of unit
 * extent. Meshed there, it gives the same mesh in any unit, place and orientation, but for what rounding makes of it.
 */
class Model_in_its_frame {
public:
  explicit Model_in_its_frame(const Tubular_model& model)
      : frame_(points_of(model.surface))
      , surface_(model.surface) {
    Surface& surface = surface_.surface;
    for (auto v : surface.vertices())
      surface.point(v) = to_frame(surface.point(v));
    std::vector<Point_3> points;
    for (const Point_3& p : model.centerlines.points())
      points.push_back(to_frame(p));
    std::vector<double> radii;
    for (double r : model.centerlines.radii())
      radii.push_back(r / frame_.scale());
    std::vector<std::vector<std::size_t>> branches;
    for (const auto& b : model.centerlines.branches())
      branches.push_back(b.points);
    centerlines_ = Centerline_graph(std::move(points), std::move(radii), std::move(branches));
  }

  const Labelled_surface& surface() const { return surface_; }
  Labelled_surface copy_of_surface() const { return Labelled_surface(surface_.surface); } // to be cut
  const Centerline_graph& centerlines() const { return centerlines_; }

  // Brings the lengths among the options of a field to the frame's unit.
  template <class Options> void scale_lengths(Options& options) const {
    options.min_size /= frame_.scale();
    options.max_size /= frame_.scale();
  }

  Size_requests in_frame(Size_requests requests) const {
    for (Size_requests::Ball& b : requests.balls) {
      b.center = to_frame(b.center);
      b.radius /= frame_.scale();
    }
    for (Size_requests::Sized_triangle& t : requests.surface) {
      for (Point_3& p : t.corners)
        p = to_frame(p);
      for (double& h : t.sizes)
        h /= frame_.scale();
    }
    return requests;
  }

  // Functions of places and lengths stay those of the model.
  Wall_thickness in_frame(const Wall_thickness& thickness) const {
    if (thickness.is_relative())
      return thickness;
    return Wall_thickness(
        [this, length = thickness.length()](const Point_3& p) { return length(from_frame(p)) / frame_.scale(); });
  }
  Extrude_wall_options in_frame(Extrude_wall_options options) const {
    options.wall_thickness = in_frame(options.wall_thickness);
    options.second_wall_thickness = in_frame(options.second_wall_thickness);
    if (!options.materials.empty())
      options.materials.region = [this, region = options.materials.region](const Point_3& p) {
        return region(from_frame(p));
      };
    return options;
  }

  // Brings volumes, areas and lengths back.
  void bring_back(Preserve_volume_report& report) const {
    const double scale = frame_.scale();
    for (double* volume : {&report.input_volume, &report.volume_before, &report.volume})
      *volume *= scale * scale * scale;
    report.largest_shift *= scale;
    for (auto& area : report.area)
      area.second *= scale * scale;
  }

  void bring_back(Move_boundary_to_surface_report& report) const { report.largest_shift *= frame_.scale(); }

  Point_3 to_frame(const Point_3& p) const {
    const auto q = frame_.to_frame(to_double_point(p));
    return Point_3(q.x(), q.y(), q.z());
  }

  double length_from_frame(double length) const { return length * frame_.scale(); }
  Point_3 from_frame(const Point_3& p) const {
    const auto q = frame_.from_canonical(to_double_point(p));
    return Point_3(q.x(), q.y(), q.z());
  }
  Place from_frame(const Place& p) const {
    const auto q = frame_.from_canonical(Double_kernel::Point_3(p[0], p[1], p[2]));
    return {{q.x(), q.y(), q.z()}};
  }

  void bring_back(Mixed_mesh& mesh) const {
    for (Point_3& p : mesh.points)
      p = from_frame(p);
    for (Point_array& a : mesh.point_arrays)
      if (a.is_metric())
        for (std::size_t i = 0; i + 5 < a.values.size(); i += 6)
          bring_metric_back(&a.values[i]);
  }
  // Where it has points of a mesh they stay the same points, bit for bit.
  void bring_back(Remeshed_surface& remeshed) const {
    for (auto v : remeshed.surface.vertices())
      remeshed.surface.point(v) = from_frame(remeshed.surface.point(v));
    for (Metric_tensor_3& metric : remeshed.metrics) {
      std::array<double, 6> m = metric.components();
      bring_metric_back(m.data());
      metric = Metric_tensor_3(m);
    }
  }

private:
  static std::vector<Double_kernel::Point_3> points_of(const Surface& surface) {
    std::vector<Double_kernel::Point_3> points;
    for (auto v : surface.vertices())
      points.push_back(to_double_point(surface.point(v)));
    return points;
  }

  // Of a vector v in space, the metric m measures the same vector in the frame: xx, xy, xz, yy, yz, zz.
  void bring_metric_back(double* m) const {
    Eigen::Matrix3d matrix;
    matrix << m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5];
    const Eigen::Matrix3d back = frame_.metric_from_frame(matrix);
    const double entries[6] = {back(0, 0), back(0, 1), back(0, 2), back(1, 1), back(1, 2), back(2, 2)};
    std::copy(entries, entries + 6, m);
  }

  Canonical_frame frame_;
  Labelled_surface surface_;
  Centerline_graph centerlines_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_MODEL_IN_ITS_FRAME_H
