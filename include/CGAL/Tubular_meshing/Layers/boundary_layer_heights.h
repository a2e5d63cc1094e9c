// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_BOUNDARY_LAYER_HEIGHTS_H
#define CGAL_TUBULAR_MESHING_LAYERS_BOUNDARY_LAYER_HEIGHTS_H

#include <CGAL/Tubular_meshing/Layers/extrude_boundary_layer.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The layers' heights, in local radii. */
struct Boundary_layer_heights {
  double first_height, growth;
  int threads, layers;

  explicit Boundary_layer_heights(const Extrude_boundary_layer_options& options)
      : first_height(options.first_height.value_or(options.boundary_layer_thickness / 20))
      , growth(options.growth)
      , threads(options.number_of_threads) {
    const double thickness = options.boundary_layer_thickness;
    if (!(thickness > 0 && thickness < 1))
      throw Parameter_error("The thickness of the boundary layer is " + std::to_string(thickness) +
                            ": give a part of the local radius, above 0 and below 1; 0.3 is usual.");
    if (!(first_height > 0 && first_height < 1))
      throw Parameter_error("The height of the first layer is " + std::to_string(first_height) +
                            ": give a part of the local radius, above 0 and below 1; 0.015 is usual.");
    if (!(growth >= 1 && growth <= 100))
      throw Parameter_error("The growth of the boundary layer is " + std::to_string(growth) +
                            ": give the ratio of two successive heights, at least 1; 1.3 is usual.");
    layers = options.boundary_layer_prisms ? *options.boundary_layer_prisms : layers_for(thickness);
    if (layers < 1 || layers > 1000)
      throw Parameter_error("The number of the boundary layer's prisms is " + std::to_string(layers) +
                            ": give at least 1 and at most 1000.");
    if (!(total() < 1))
      throw Parameter_error("Boundary layers of " + std::to_string(layers) + " prisms that grow from " +
                            std::to_string(first_height) + " by " + std::to_string(growth) + " are " +
                            std::to_string(total()) +
                            " local radii thick, and leave nothing of the lumen: ask for "
                            "fewer, thinner, or less growth.");
  }

  double total() const { return height(layers); }

  // Of the far side of layer k, counted from 1.
  double height(int k) const {
    double sum = 0, h = first_height;
    for (int i = 0; i < k; ++i, h *= growth)
      sum += h;
    return sum;
  }

  std::vector<double> levels() const {
    std::vector<double> result = {0};
    for (int k = 1; k < layers; ++k)
      result.push_back(height(k) / total());
    result.push_back(1);
    return result;
  }

private:
  // As many as come closest to a thickness.
  int layers_for(double thickness) const {
    int k = 1;
    while (k < 1000 && height(k + 1) - thickness < thickness - height(k))
      ++k;
    return k;
  }
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_LAYERS_BOUNDARY_LAYER_HEIGHTS_H
