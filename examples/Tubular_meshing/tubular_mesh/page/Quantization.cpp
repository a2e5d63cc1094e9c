// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Quantization.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

const double infinity = (std::numeric_limits<double>::infinity)();

template <class Corners> double least_distance(const Shown_mesh& mesh, const Corners& corners, std::size_t n) {
  double least = infinity;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j)
      least = (std::min)(least, squared_norm(mesh.point(corners[i]) - mesh.point(corners[j])));
  return least;
}

// Of any two corners of a cell or a facet.
double least_distance(const Shown_mesh& mesh) {
  double least = infinity;
  for (std::size_t c = 0; c < mesh.cells().size(); ++c)
    least = (std::min)(least, least_distance(mesh, mesh.cells().corners(c), mesh.cells().corners(c).number));
  for (std::size_t f = 0; f < mesh.number_of_facets(); ++f) {
    const auto corners = mesh.facet(f);
    least = (std::min)(
        least, least_distance(mesh, corners, CGAL::Tubular_meshing::internal::cells::number_of_corners(corners)));
  }
  return std::sqrt(least);
}

} // namespace

Quantization::Quantization(const Shown_mesh& mesh) {
  const auto box = mesh.extent();
  const Shown_mesh::Vector sides = box[1] - box[0];
  const double extent = (std::max)({sides.x, sides.y, sides.z});
  if (!(extent > 0)) // nor where there are no points
    return;
  origin_ = box[0];
  const double wanted = least_distance(mesh) / 8;
  int bits = 16;
  while (bits < 24 && extent / double((1 << bits) - 1) > wanted)
    ++bits;
  step_ = extent / double((1 << bits) - 1);
}

std::array<std::uint32_t, 3> Quantization::operator()(const Shown_mesh::Vector& p) const {
  const auto whole = [&](double x) { return std::uint32_t(std::lround(x / step_)); };
  return {whole(p.x - origin_.x), whole(p.y - origin_.y), whole(p.z - origin_.z)};
}
