// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_SHAPES_IMPL_H
#define CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_SHAPES_IMPL_H

#include <CGAL/Tubular_meshing/Generators/internal/skeleton_curves.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>

#include <cmath>
#include <cstddef>

namespace CGAL::Tubular_meshing {

CGAL_TUBULAR_MESHING_INLINE Tubular_skeleton straight_tube(double length, double radius) {
  Tubular_skeleton s;
  s.nodes = {Point_3(0, 0, 0), Point_3(0, 0, length)};
  s.add_branch(
      0, 1, [&](double t) { return Point_3(0, 0, t * length); }, [&](double) { return radius; });
  return s;
}

CGAL_TUBULAR_MESHING_INLINE Tubular_skeleton curved_tube(double bend_radius, double angle, double radius) {
  auto arc = [&](double t) { return Point_3(bend_radius * std::cos(t * angle), 0, bend_radius * std::sin(t * angle)); };
  Tubular_skeleton s;
  s.nodes = {arc(0), arc(1)};
  s.add_branch(0, 1, arc, [&](double) { return radius; });
  return s;
}

CGAL_TUBULAR_MESHING_INLINE Tubular_skeleton y_bifurcation() {
  Tubular_skeleton s;
  s.nodes = {Point_3(0, 0, 0), Point_3(0, 0, 6), Point_3(3.2, 0, 12), Point_3(-3, 0.5, 11)};
  const Vector_3 up(0, 0, 1);
  auto constant = [](double r) { return internal::Smooth_taper{r, r}; };
  s.add_branch(0, 1, internal::Hermite_curve(s.nodes[0], up, s.nodes[1], up), constant(1));
  s.add_branch(1, 2, internal::Hermite_curve(s.nodes[1], Vector_3(0.7, 0, 1), s.nodes[2], Vector_3(.3, 0, 1)),
               constant(0.8));
  s.add_branch(1, 3, internal::Hermite_curve(s.nodes[1], Vector_3(-0.8, 0, 1), s.nodes[3], Vector_3(-.4, 0.1, 1)),
               constant(0.7));
  return s;
}

CGAL_TUBULAR_MESHING_INLINE Tubular_skeleton aortic_arch() {
  const double bend = 38, rise = 45, fall = 110;
  const double at[3] = {1.15, 1.62, 2.1}; // the branches, as angles from the ascending end of the arch
  auto arch = [&](double a) {
    return Point_3(-bend * std::cos(a), 10 * std::sin(a / 2) * std::sin(a / 2), bend * std::sin(a));
  };
  auto along = [&](double a) { return Vector_3(bend * std::sin(a), 5 * std::sin(a), bend * std::cos(a)); };
  const Point_3 inlet(-bend + 4, -6, -rise), outlet(bend - 6, 12, -fall);

  Tubular_skeleton s;
  s.nodes = {inlet,  arch(at[0]),          arch(at[1]),        arch(at[2]),
             outlet, Point_3(-30, -8, 90), Point_3(6, 2, 100), Point_3(34, 12, 95)};
  // The trunk is one smooth curve: up, over, and down, as a function of the arch's angle.
  const double first = -1, last = CGAL_PI + 2; // below 0 the ascending, beyond pi the descending part
  const internal::Hermite_curve up(inlet, Vector_3(-0.05, 0.1, 1), arch(0), Vector_3(0, 0, 1));
  const internal::Hermite_curve down(arch(CGAL_PI), Vector_3(0, 0, -1), outlet, Vector_3(-0.1, 0, -1));
  auto trunk = [&](double a) { return a < 0 ? up(a + 1) : a < CGAL_PI ? arch(a) : down((a - CGAL_PI) / 2); };
  auto trunk_radius = [&](double a) { return internal::Smooth_taper{14, 10}((a - first) / (last - first)); };
  const double stations[5] = {first, at[0], at[1], at[2], last};
  for (std::size_t i = 0; i < 4; ++i) {
    auto angle = [&](double t) { return stations[i] + t * (stations[i + 1] - stations[i]); };
    s.add_branch(
        i, i + 1, [&](double t) { return trunk(angle(t)); }, [&](double t) { return trunk_radius(angle(t)); });
  }
  const double radius[3] = {6, 3.5, 5};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector_3 t = along(at[i]), outwards(-t.z(), 0, t.x()); // perpendicular to the arch
    const internal::Hermite_curve curve(s.nodes[i + 1], outwards, s.nodes[5 + i], Vector_3(0, 0, 1));
    s.add_branch(i + 1, 5 + i, curve, internal::Smooth_taper{radius[i], 0.9 * radius[i]});
  }
  return s;
}

CGAL_TUBULAR_MESHING_INLINE Tubular_skeleton willis_loop() {
  const double to_radians = CGAL_PI / 180;
  const double at[7] = {-90, -35, 20, 65, 115, 160, 215}; // junctions on the ring, counterclockwise from the inlet
  const double end_radius[7] = {1.6, 1.1, 1.3, 1.1, 1.1, 1.3, 1.1};
  auto ring = [&](double degrees) {
    const double a = to_radians * degrees;
    return Point_3(9 * std::cos(a), 11 * std::sin(a), 1.2 * std::cos(2 * a));
  };
  auto outwards = [&](double degrees) {
    const double a = to_radians * degrees;
    return Vector_3(11 * std::cos(a), 9 * std::sin(a), 0) / 11;
  };
  Tubular_skeleton s;
  for (double a : at)
    s.nodes.push_back(ring(a));
  for (std::size_t i = 0; i < 7; ++i) {
    const Vector_3 bend(0, 0, i == 0 ? -7 : i % 3 == 2 ? 3 : 5);
    s.nodes.push_back(s.nodes[i] + 12 * outwards(at[i]) + bend);
  }
  s.inlet = 7;
  auto add_spoke = [&](std::size_t i) {
    const internal::Hermite_curve curve(s.nodes[i], outwards(at[i]), s.nodes[7 + i],
                                        s.nodes[7 + i] - s.nodes[i] - 6 * outwards(at[i]));
    const double r = end_radius[i];
    if (i == 0) // the inlet: it runs to the ring
      s.add_branch(
          7, 0, [&](double t) { return curve(1 - t); }, internal::Smooth_taper{r, 1});
    else
      s.add_branch(i, 7 + i, curve, internal::Smooth_taper{1, r});
  };
  auto add_arc = [&](std::size_t i) {
    const double from = at[i], to = i == 6 ? 270 : at[i + 1];
    s.add_branch(
        i, (i + 1) % 7, [&](double t) { return ring(from + t * (to - from)); }, internal::Smooth_taper{1, 1});
  };
  add_spoke(0);
  for (std::size_t i = 0; i < 7; ++i)
    add_arc(i);
  for (std::size_t i = 1; i < 7; ++i)
    add_spoke(i);
  return s;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_SHAPES_IMPL_H
