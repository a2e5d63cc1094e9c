// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_SURFACE_SIZES_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_SURFACE_SIZES_H

#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/Patches/internal/remeshing/triangle_shapes.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Curve_divider.h>
#include <CGAL/Tubular_meshing/Plane/Metric_tensor_2.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* What Triangle_piece_mesher asks of the sizes that are wanted: lengths along the curves between pieces, metrics over
 * the plane of a patch and in that of a cap. A `fineness` below 1 makes the sizes smaller. */
class Surface_sizes {
public:
  virtual ~Surface_sizes() = default;
  virtual double along_curve(std::size_t curve, const Curve_position& at) const = 0;
  virtual Metric_tensor_2 on_patch(std::size_t patch, const Patch_location& at, double fineness) const = 0;
  virtual Metric_tensor_2 in_plane(const Point_3& p, const Vector_3d& first, const Vector_3d& second,
                                   double fineness) const = 0;
  // Then triangles are as good as they look, in the plane and afterwards; else they are good in the metric, of which
  // caps want the section: their triangles are to be left as they are.
  virtual bool are_isotropic() const = 0;
  virtual const Triangle_shape& shape() const = 0;
};

/* Sizes that are the same in all directions. */
class Isotropic_sizes final : public Surface_sizes {
public:
  Isotropic_sizes(const std::vector<Patch_parameterization>& maps, Length_function size)
      : maps_(maps)
      , size_(size) {}

  double along_curve(std::size_t, const Curve_position& at) const override { return size_(at.point); }

  Metric_tensor_2 on_patch(std::size_t patch, const Patch_location& at, double fineness) const override {
    const Patch_parameterization& map = maps_[patch];
    return map.induced_metric(at, fineness * size_(map.point(at)));
  }

  Metric_tensor_2 in_plane(const Point_3& p, const Vector_3d&, const Vector_3d&, double fineness) const override {
    return Metric_tensor_2::isotropic(fineness * size_(p));
  }

  bool are_isotropic() const override { return true; }
  const Triangle_shape& shape() const override { return shape_; }

private:
  const std::vector<Patch_parameterization>& maps_;
  const Length_function size_;
  const Shape_in_space shape_{};
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_SURFACE_SIZES_H
