// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_FIBRE_DIRECTIONS_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_FIBRE_DIRECTIONS_H

#include <CGAL/Tubular_meshing/Layers/wall_fibres.h>
#include <CGAL/Tubular_meshing/base/Cell_array.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

/* The two directions of wall_fibres() among the arrays of a mesh's cells, for formats that know axes of a material in each
 * cell: the first axis is circumferential, the second longitudinal, the third radial. */
class Fibre_directions {
public:
  explicit Fibre_directions(const std::vector<Cell_array>& arrays) {
    for (const Cell_array& a : arrays)
      if (a.components == 3 && a.name == circumferential_array_name)
        circumferential_ = &a;
      else if (a.components == 3 && a.name == longitudinal_array_name)
        longitudinal_ = &a;
  }

  bool are_there() const { return circumferential_ != nullptr && longitudinal_ != nullptr; }
  bool contain(const Cell_array& a) const { return are_there() && (&a == circumferential_ || &a == longitudinal_); }

  // Of a cell, by its number in the mesh; only the wall's have them.
  bool has(std::size_t cell) const {
    const double* const c = circumferential(cell);
    return std::any_of(c, c + 3, [](double x) { return x != 0; });
  }
  const double* circumferential(std::size_t cell) const { return &circumferential_->values[3 * cell]; }
  const double* longitudinal(std::size_t cell) const { return &longitudinal_->values[3 * cell]; }

private:
  const Cell_array *circumferential_ = nullptr, *longitudinal_ = nullptr;
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_FIBRE_DIRECTIONS_H
