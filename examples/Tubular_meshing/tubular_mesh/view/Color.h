// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_VIEW_COLOR_H
#define TUBULAR_MESH_VIEW_COLOR_H

#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>

/* The colours of pictures and pages, one table for both: of a palette that readers who see few colours can tell apart,
 * and of a scale whose lightness grows. */
struct Color {
  std::uint8_t r = 0, g = 0, b = 0;

  std::string text() const {
    char hex[8];
    std::snprintf(hex, sizeof hex, "#%02x%02x%02x", r, g, b);
    return hex;
  }
};

inline const std::array<Color, 9>& color_scale() {
  static const std::array<Color, 9> scale = {{{68, 1, 84},
                                              {71, 45, 123},
                                              {59, 82, 139},
                                              {44, 114, 142},
                                              {33, 145, 140},
                                              {40, 174, 128},
                                              {94, 201, 98},
                                              {173, 220, 48},
                                              {253, 231, 37}}};
  return scale;
}

// 0 is dark, 1 is light; what is outside has the colour of the nearer end.
inline Color color_on_scale(double t) {
  const auto& scale = color_scale();
  const double at = (std::isfinite(t) ? std::clamp(t, 0., 1.) : 0) * double(scale.size() - 1);
  const std::size_t i = (std::min)(std::size_t(at), scale.size() - 2);
  const double w = at - double(i);
  const auto mix = [&](std::uint8_t a, std::uint8_t b) { return std::uint8_t(std::lround((1 - w) * a + w * b)); };
  return {mix(scale[i].r, scale[i + 1].r), mix(scale[i].g, scale[i + 1].g), mix(scale[i].b, scale[i + 1].b)};
}

inline const std::array<Color, 8>& palette() {
  static const std::array<Color, 8> colors = {{{86, 180, 233},
                                               {230, 159, 0},
                                               {0, 158, 115},
                                               {204, 121, 167},
                                               {240, 228, 66},
                                               {0, 114, 178},
                                               {213, 94, 0},
                                               {150, 150, 150}}};
  return colors;
}

inline Color color_of_number(std::size_t i) {
  return palette()[i % palette().size()];
}

// The wall is pale, openings and a vessel's wall stand out.
inline Color color_of_patch(int patch) {
  using namespace CGAL::Tubular_meshing;
  return patch == labels::wall ? Color{226, 205, 189}
                               : color_of_number(std::size_t(patch) + 3); // the inlet is dark blue
}

inline Color color_of_region(int region) {
  return region == CGAL::Tubular_meshing::labels::lumen ? Color{201, 218, 232}
                                                        : color_of_number(std::size_t(region) + 1);
}

#endif // TUBULAR_MESH_VIEW_COLOR_H
