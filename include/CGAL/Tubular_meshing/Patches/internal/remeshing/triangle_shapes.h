// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_TRIANGLE_SHAPES_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_TRIANGLE_SHAPES_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/Plane/Metric_tensor_2.h>
#include <CGAL/Tubular_meshing/Patches/metric_on_surface.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/constants.h>

#include <array>

namespace CGAL::Tubular_meshing::internal {

/* By what Triangle_improver judges: the quality of a triangle, and where the apex of the best one on an edge is, to the
 * left of it as seen along the normal. */
class Triangle_shape {
public:
  virtual ~Triangle_shape() = default;
  virtual double quality(const Vector_3d& p, const Vector_3d& q, const Vector_3d& r) const = 0;
  virtual Vector_3d apex(const Vector_3d& a, const Vector_3d& b, const Vector_3d& normal) const = 0;
};

/* As it looks in space. */
class Shape_in_space final : public Triangle_shape {
public:
  double quality(const Vector_3d& p, const Vector_3d& q, const Vector_3d& r) const override {
    return triangle_gamma(p, q, r);
  }

  Vector_3d apex(const Vector_3d& a, const Vector_3d& b, const Vector_3d& normal) const override {
    const Vector_3d middle = 0.5 * (a + b);
    const Vector_3d inward = cross(normal, b - a);
    return middle + root_of_3 / 2 * inward;
  }
};

/* In the shadow of a metric: (12) in the mean of the corners' shapes. Caps want the metric's section. */
class Shape_in_metric final : public Triangle_shape {
public:
  explicit Shape_in_metric(Metric_function metric)
      : metric_(metric) {}

  double quality(const Vector_3d& p, const Vector_3d& q, const Vector_3d& r) const override {
    const Vector_3d normal = cross(q - p, r - p), first = normalized(q - p);
    if (!(squared_norm(normal) > 0))
      return 0;
    const Vector_3d second = cross(normalized(normal), first);
    Metric_tensor_2 m(0, 0, 0);
    for (const Vector_3d* v : {&p, &q, &r})
      m = m + shadow(*v, first, second).normalized();
    const auto length = [&](const Vector_3d& e) { return m.length(dot(e, first), dot(e, second)); };
    const double a = length(q - p), b = length(r - q), c = length(p - r), product = a * b * c;
    return product > 0 ? 4 * m.determinant() * squared_norm(normal) / (product * (a + b + c)) : 0;
  }

  Vector_3d apex(const Vector_3d& a, const Vector_3d& b, const Vector_3d& normal) const override {
    const Vector_3d middle = 0.5 * (a + b), first = normalized(b - a), second = cross(normal, first);
    const std::array<double, 2> inward = shadow(middle, first, second).quarter_turn(norm(b - a), 0);
    return middle + root_of_3 / 2 * (inward[0] * first + inward[1] * second);
  }

private:
  Metric_tensor_2 shadow(const Vector_3d& p, const Vector_3d& first, const Vector_3d& second) const {
    return metric_shadow(metric_(as<Point_3>(p)), first, second);
  }

  const Metric_function metric_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_REMESHING_TRIANGLE_SHAPES_H
