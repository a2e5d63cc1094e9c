// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What differs between CGAL 5.5 and 6.x, in one place.

#ifndef CGAL_TUBULAR_MESHING_BASE_CGAL_COMPATIBILITY_H
#define CGAL_TUBULAR_MESHING_BASE_CGAL_COMPATIBILITY_H

#include <CGAL/version.h>

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

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_CGAL_COMPATIBILITY_H
