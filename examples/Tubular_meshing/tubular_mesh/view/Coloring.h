// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_VIEW_COLORING_H
#define TUBULAR_MESH_VIEW_COLORING_H

#include "Color.h"
#include "Shown_mesh.h"

#include <cstddef>
#include <string>
#include <vector>

/* What the faces of a mesh are coloured by. */
class Coloring {
public:
  enum class By { patch, region, type, quality, size, branch };
  static const std::vector<std::string>& names(); ///< in the order of By
  static By named(const std::string& name);       ///< one of them

  Coloring(const Shown_mesh& mesh, By by);

  Color of_facet(std::size_t facet) const;
  // A face inside the mesh that a cut lays bare.
  Color of_cut_face(std::size_t cell, const Shown_mesh::Face& face) const;

  // The ends of the scale of sizes: the hundredth part of the facets is smaller, or larger.
  double least_size() const { return least_size_; }
  double largest_size() const { return largest_size_; }

private:
  Color of_size(double size) const;

  const Shown_mesh& mesh_;
  By by_;
  double least_size_ = 0, largest_size_ = 1;
};

#endif // TUBULAR_MESH_VIEW_COLORING_H
