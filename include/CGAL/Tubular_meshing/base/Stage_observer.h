// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_STAGE_OBSERVER_H
#define CGAL_TUBULAR_MESHING_BASE_STAGE_OBSERVER_H

#include <CGAL/Tubular_meshing/base/parameters.h>

namespace CGAL::Tubular_meshing::internal {

struct Ignore_stages {
  void operator()(const char*) const {}
};

// The function object that wants to know of each stage as it begins; by default nobody does.
template <class NamedParameters> auto stage_observer(const NamedParameters& np) {
  return CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::observer),
                                            Ignore_stages());
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_STAGE_OBSERVER_H
