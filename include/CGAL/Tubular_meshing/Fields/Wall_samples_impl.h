// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_WALL_SAMPLES_IMPL_H
#define CGAL_TUBULAR_MESHING_FIELDS_WALL_SAMPLES_IMPL_H

#include <CGAL/Tubular_meshing/Fields/Wall_samples.h>
#include <CGAL/Tubular_meshing/Fields/internal/Wall_sampler.h>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing {

CGAL_TUBULAR_MESHING_INLINE std::vector<Wall_sample> wall_samples(const Surface& surface, const Face_patch_map& patch,
                                                                  std::size_t most, int number_of_threads) {
  return internal::Wall_sampler(surface, patch, number_of_threads).samples(most);
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_FIELDS_WALL_SAMPLES_IMPL_H
