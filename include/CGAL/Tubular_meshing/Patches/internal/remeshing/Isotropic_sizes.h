// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_ISOTROPIC_SIZES_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_ISOTROPIC_SIZES_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/Plane/Metric_tensor_2.h>
#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/Plane/Plane_metric.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Curve_divider.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Remeshed_piece.h>
#include <CGAL/Tubular_meshing/Patches/internal/remeshing/triangle_shapes.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* What Piece_mesher asks of the sizes that are wanted, where these are the same in all directions: `size(point)`.
 *
 * Lengths are asked for along the curves between pieces, metrics over the plane of a patch and in that of a cap; a
 * `fineness` below 1 makes the sizes smaller. Metric_sizes answers the same questions for a metric. */
template <class Size> class Isotropic_sizes {
public:
  typedef Patch_parameterization Map;

  Isotropic_sizes(const CGAL::Surface_mesh<Point_3>&, const Surface_cut&, const std::vector<Map>& maps,
                  const Size& size)
      : maps_(maps)
      , size_(size) {}

  double along_curve(std::size_t, const Curve_position& at) const { return size_(at.point); }

  Plane_metric on_patch(std::size_t patch, const Patch_location& at, double fineness) const {
    const Map& map = maps_[patch];
    return map.induced_metric(at, fineness * size_(map.point(at)));
  }

  Metric_tensor_2 in_plane(const Point_3& p, const Vector_3d&, const Vector_3d&, double fineness) const {
    return Metric_tensor_2::isotropic(fineness * size_(p));
  }

  // Triangles are as good as they look, in the plane and afterwards.
  template <class Chart> static auto embedding(const Chart& chart) { return embedding_of(chart); }
  static Shape_in_space shape() { return {}; }

private:
  const std::vector<Map>& maps_;
  const Size& size_;
};

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_ISOTROPIC_SIZES_H
