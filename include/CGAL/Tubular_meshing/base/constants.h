// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_CONSTANTS_H
#define CGAL_TUBULAR_MESHING_BASE_CONSTANTS_H

namespace CGAL::Tubular_meshing::internal {

constexpr double root_of_3 = 1.7320508075688772935;

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_CONSTANTS_H
