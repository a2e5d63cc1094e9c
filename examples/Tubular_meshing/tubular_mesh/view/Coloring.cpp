// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Coloring.h"

#include <algorithm>
#include <cmath>

const std::vector<std::string>& Coloring::names() {
  static const std::vector<std::string> all = {"patch", "region", "type", "quality", "size", "branch"};
  return all;
}

Coloring::By Coloring::named(const std::string& name) {
  return By(std::find(names().begin(), names().end(), name) - names().begin());
}

Coloring::Coloring(const Shown_mesh& mesh, By by)
    : mesh_(mesh)
    , by_(by) {
  std::vector<double> sizes;
  for (std::size_t f = 0; f < mesh.number_of_facets(); ++f)
    sizes.push_back(mesh.size_of_face(mesh.facet(f)));
  if (sizes.empty())
    return;
  std::sort(sizes.begin(), sizes.end());
  least_size_ = sizes[sizes.size() / 100];
  largest_size_ = sizes[sizes.size() - 1 - sizes.size() / 100];
}

Color Coloring::of_size(double size) const {
  const double range = std::log(largest_size_ / least_size_);
  return color_on_scale(range > 0 ? std::log(size / least_size_) / range : 0.5);
}

Color Coloring::of_facet(std::size_t facet) const {
  const std::uint32_t cell = mesh_.sides(facet)[0];
  switch (by_) {
  case By::region:
    return color_of_region(cell == Shown_mesh::none ? 1 : mesh_.cells().region(cell));
  case By::type:
    return color_of_number(cell == Shown_mesh::none ? (mesh_.is_triangle(facet) ? 4 : 5) : mesh_.cells().kind(cell));
  case By::quality:
    return color_on_scale(cell == Shown_mesh::none ? mesh_.quality_of_facet(facet) : mesh_.quality_of_cell(cell));
  case By::size:
    return of_size(mesh_.size_of_face(mesh_.facet(facet)));
  case By::branch:
    return color_of_number(mesh_.place_of_facet(facet).branch);
  default:
    return color_of_patch(mesh_.patch(facet));
  }
}

Color Coloring::of_cut_face(std::size_t cell, const Shown_mesh::Face& face) const {
  switch (by_) {
  case By::type:
    return color_of_number(mesh_.cells().kind(cell));
  case By::quality:
    return color_on_scale(mesh_.quality_of_cell(cell));
  case By::size:
    return of_size(mesh_.size_of_face(face));
  case By::branch:
    return color_of_number(mesh_.place_of_cell(cell).branch);
  default:
    return color_of_region(mesh_.cells().region(cell));
  }
}
