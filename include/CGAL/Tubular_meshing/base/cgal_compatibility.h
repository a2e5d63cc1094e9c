// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What differs between CGAL 5.5 and 6.x, in one place.

#ifndef CGAL_TUBULAR_MESHING_BASE_CGAL_COMPATIBILITY_H
#define CGAL_TUBULAR_MESHING_BASE_CGAL_COMPATIBILITY_H

#include <CGAL/version.h>

#include <optional>
#include <string>

#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

namespace CGAL::Tubular_meshing::internal {

#if CGAL_VERSION_NR >= 1060000000
template <class GeomTraits, class Primitive> using Aabb_traits = CGAL::AABB_traits_3<GeomTraits, Primitive>;
#else
template <class GeomTraits, class Primitive> using Aabb_traits = CGAL::AABB_traits<GeomTraits, Primitive>;
#endif

/* A property map of a surface that may have none of this name: a pair of it and a `bool` before CGAL 6, optional since. */
template <class Key, class Value, class SurfaceMesh>
std::optional<typename SurfaceMesh::template Property_map<Key, Value>> property_map_of(const SurfaceMesh& mesh,
                                                                                       const std::string& name) {
  const auto found = mesh.template property_map<Key, Value>(name);
#if CGAL_VERSION_NR >= 1060000000
  return found;
#else
  return found.second ? std::make_optional(found.first) : std::nullopt;
#endif
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_CGAL_COMPATIBILITY_H
