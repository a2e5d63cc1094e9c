// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_GENERATORS_BRONCHIAL_TREE_IMPL_H
#define CGAL_TUBULAR_MESHING_GENERATORS_BRONCHIAL_TREE_IMPL_H

#include <CGAL/Tubular_meshing/Generators/bronchial_tree.h>
#include <CGAL/Tubular_meshing/Generators/internal/Bronchial_tree_builder.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Tubular_meshing {

CGAL_TUBULAR_MESHING_INLINE Tubular_skeleton bronchial_tree(std::size_t number_of_branches) {
  if (number_of_branches % 2 == 0)
    throw Parameter_error("a bronchial tree has an odd number of branches, since each bifurcation adds two; " +
                          std::to_string(number_of_branches) + " is even: ask for one more or one less.");
  return internal::Bronchial_tree_builder(number_of_branches).skeleton();
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_GENERATORS_BRONCHIAL_TREE_IMPL_H
