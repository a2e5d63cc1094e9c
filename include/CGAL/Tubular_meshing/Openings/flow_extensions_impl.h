// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_FLOW_EXTENSIONS_IMPL_H
#define CGAL_TUBULAR_MESHING_OPENINGS_FLOW_EXTENSIONS_IMPL_H

#include <CGAL/Tubular_meshing/Openings/flow_extensions.h>
#include <CGAL/Tubular_meshing/Openings/internal/Flow_extender.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

inline void check_extension_lengths(double length, double min_length) {
  if (!(length > 0) || !(length <= 1000))
    throw Parameter_error("The length of flow extensions (extension_length) has to be more than 0 and at most 1000 "
                          "radii, not " +
                          std::to_string(length) + ".");
  if (!(min_length >= 0) || !(min_length <= length))
    throw Parameter_error(
        "The least length of flow extensions (min_extension_length) has to be from 0 to their length, "
        "not " +
        std::to_string(min_length) + ".");
}

/* By opening, whether it is to be extended. */
inline std::vector<bool> wanted_extensions(std::size_t openings, const Add_flow_extensions_options& options) {
  std::vector<bool> wanted(openings, !options.extended_openings);
  if (options.extended_openings)
    for (std::size_t i : *options.extended_openings) {
      if (i >= openings)
        throw Parameter_error("There is no opening " + std::to_string(i) +
                              " to extend (extended_openings): there are " + std::to_string(openings) +
                              ", counted from 0.");
      wanted[i] = true;
    }
  return wanted;
}

CGAL_TUBULAR_MESHING_INLINE std::vector<double> add_flow_extensions(Surface& surface, std::vector<Opening>& openings,
                                                                    const Add_flow_extensions_options& options) {
  const double length = options.extension_length;
  const double min_length = options.min_extension_length.value_or((std::min)(1., length));
  check_extension_lengths(length, min_length);
  const std::vector<bool> wanted = wanted_extensions(openings.size(), options);
  check_tubular_surface(surface);
  Surface surface_before = surface;
  std::vector<Opening> openings_before = openings;
  try {
    return Flow_extender(surface, openings, wanted).extend(length, min_length);
  } catch (...) {
    surface = std::move(surface_before);
    openings.swap(openings_before);
    throw;
  }
}

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_OPENINGS_FLOW_EXTENSIONS_IMPL_H
