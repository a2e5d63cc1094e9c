// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_SURFACE_IMPL_H
#define CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_SURFACE_IMPL_H

#include <CGAL/Tubular_meshing/Generators/internal/Tubular_surface_generator.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <string>
#include <utility>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

inline void check_range(double value, double from, double to, const std::string& what) {
  if (!(value >= from && value <= to))
    throw Parameter_error(what + " must be between " + std::to_string(from) + " and " + std::to_string(to) + ", not " +
                          std::to_string(value) + ".");
}

CGAL_TUBULAR_MESHING_INLINE Surface generate_tubular_surface(const Tubular_skeleton& skeleton,
                                                             const Generate_tubular_surface_options& options) {
  check_range(options.points_per_circumference, 8, 1000, "the number of points round the circumference");
  check_range(options.noise, 0, 1, "the noise, a fraction of the radius,");
  check_range(options.sag, 0, 0.5, "the sag, a fraction of the radius,");

  Tubular_surface_generator generator(skeleton);
  generator.make_open_surface(options.points_per_circumference);
  if (options.noise > 0)
    generator.add_noise(options.noise, options.noise_seed);
  if (options.capped_ends)
    generator.cap_ends();
  if (options.sag > 0)
    generator.sag_ends(options.sag, options.sag_shape);
  return std::move(generator.mesh());
}

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_SURFACE_IMPL_H
