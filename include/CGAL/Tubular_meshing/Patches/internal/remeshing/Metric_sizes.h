// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_METRIC_SIZES_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_METRIC_SIZES_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/Patches/internal/remeshing/Surface_sizes.h>
#include <CGAL/Tubular_meshing/Patches/internal/remeshing/Tangent_planes.h>
#include <CGAL/Tubular_meshing/Patches/metric_on_surface.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Sizes that depend on the direction, those of a metric.
 *
 * On patches it is the shadow of the metric on the tangent plane that counts, see metric_shadow(). The metric is asked
 * for at each place again, only the tangent planes are those of the old triangles: it may vary within them. */
class Metric_sizes final : public Surface_sizes {
public:
  // O(n) in the old triangles.
  Metric_sizes(const Surface& surface, const Surface_cut& cut, const std::vector<Patch_parameterization>& maps,
               Metric_function metric)
      : maps_(maps)
      , metric_(metric)
      , shape_(metric)
      , axes_(maps.begin(), maps.end()) {
    for (const auto& curve : cut.curves)
      set_directions(surface, cut, curve);
  }

  double along_curve(size_type curve, const Curve_position& at) const override {
    const Ribbon& ribbon = ribbons_[curve];
    const size_type next = (at.edge + 1) % ribbon.normals.size();
    const Vector_3d& direction = at.t > 0 ? ribbon.edges[at.edge] : ribbon.directions[at.edge];
    const Vector_3d normal = (1 - at.t) * ribbon.normals[at.edge] + at.t * ribbon.normals[next];
    const Vector_3d side = normalized(cross(normal, direction));
    const Metric_tensor_3 m = checked_metric(at.point);
    if (!(squared_norm(side) > 0.5)) // a spike, or a hairpin bend: any size there is as good as another
      return m.sizes()[0];
    return 1 / std::sqrt(metric_shadow(m, direction, side).xx);
  }

  /* (11) with the derivative R U, of which Tangent_planes has the rotation, and the metric of space in that plane. */
  Metric_tensor_2 on_patch(size_type patch, const Patch_location& at, double fineness) const override {
    const Patch_parameterization& map = maps_[patch];
    const Plane_axes axes = axes_[patch].at(at);
    const Metric_tensor_2 m = metric_shadow(checked_metric(map.point(at)), axes.first, axes.second);
    const Metric_tensor_2 u = map.induced_metric(at, fineness).with_eigenvalues([](double& larger, double& smaller) {
      larger = std::sqrt(larger);
      smaller = std::sqrt(smaller);
    });
    return {m.squared_length(u.xx, u.xy), m.dot(u.xx, u.xy, u.xy, u.yy), m.squared_length(u.xy, u.yy)};
  }

  Metric_tensor_2 in_plane(const Point_3& p, const Vector_3d& first, const Vector_3d& second,
                           double fineness) const override {
    return 1 / (fineness * fineness) * metric_section(checked_metric(p), first, second);
  }

  bool are_isotropic() const override { return false; }
  const Triangle_shape& shape() const override { return shape_; }

private:
  // A curve with the surface beside it: of its vertices directions and normals, of its edges directions, unit vectors.
  struct Ribbon {
    std::vector<Vector_3d> directions, normals, edges;
  };

  void set_directions(const Surface& surface, const Surface_cut& cut, const Cut_curve& curve) {
    ribbons_.emplace_back();
    Ribbon& ribbon = ribbons_.back();
    for (auto h : curve.halfedges)
      ribbon.edges.push_back(
          normalized(Vector_3d(surface.point(surface.target(h))) - Vector_3d(surface.point(surface.source(h)))));
    const size_type n = ribbon.edges.size();
    for (size_type i = 0; i < n; ++i) {
      ribbon.directions.push_back(normalized(ribbon.edges[(i + n - 1) % n] + ribbon.edges[i]));
      ribbon.normals.push_back(wall_normal(surface, cut, curve.halfedges[i]));
    }
  }

  // At the source of a halfedge: the mean of the faces around, by area, but for those of caps.
  static Vector_3d wall_normal(const Surface& surface, const Surface_cut& cut, Halfedge out) {
    Vector_3d sum;
    for (auto h : surface.halfedges_around_target(surface.opposite(out)))
      if (!surface.is_border(h) && cut.patch_of_face[surface.face(h)] >= 0) {
        const Vector_3d at(surface.point(surface.target(h)));
        sum += cross(Vector_3d(surface.point(surface.target(surface.next(h)))) - at,
                     Vector_3d(surface.point(surface.source(h))) - at);
      }
    return normalized(sum);
  }

  Metric_tensor_3 checked_metric(const Point_3& p) const {
    const Metric_tensor_3 m = metric_(p);
    if (!m.is_valid())
      throw Parameter_error("The metric at " + place_of(p) +
                            " is not finite and positive definite; give positive, finite sizes in all directions, "
                            "everywhere on the surface.");
    return m;
  }

  const std::vector<Patch_parameterization>& maps_;
  const Metric_function metric_;
  const Shape_in_metric shape_;
  const std::vector<Tangent_planes> axes_; // of the patches
  std::vector<Ribbon> ribbons_;            // of the curves
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_METRIC_SIZES_H
