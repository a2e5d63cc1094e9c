// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_PAGE_QUANTIZATION_H
#define TUBULAR_MESH_PAGE_QUANTIZATION_H

#include "../view/Shown_mesh.h"

#include <array>
#include <cstdint>

/* Positions as whole numbers of 16 bits, or of up to 24 where cells are so thin that they would be flat by these. */
class Quantization {
public:
  explicit Quantization(const Shown_mesh& mesh);

  std::array<std::uint32_t, 3> operator()(const Shown_mesh::Vector& p) const;
  const Shown_mesh::Vector& origin() const { return origin_; }
  double step() const { return step_; }

private:
  Shown_mesh::Vector origin_;
  double step_ = 1;
};

#endif // TUBULAR_MESH_PAGE_QUANTIZATION_H
