// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_PICTURE_RASTER_H
#define TUBULAR_MESH_PICTURE_RASTER_H

#include "../view/Color.h"
#include "../view/Shown_mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/* A picture of so many pixels, each of 3 bytes. */
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bytes;
};

/* Draws triangles in front of each other, by their depth. Each pixel is the mean of some smaller ones, so that edges
 * are smooth. */
class Raster {
public:
  typedef Shown_mesh::Vector Vector;
  static constexpr int samples = 2; // along a side of a pixel

  Raster(int width, int height, Color background);

  /* Corners are in pixels, the third coordinate toward the reader; `lift` brings it nearer. Of its sides those are drawn
   * dark of which the bit is set: bit i is that opposite to corner i. `shade`, 0 to 1, is its light. */
  void draw(const std::array<Vector, 3>& corners, Color color, double shade, int sides, double lift);

  Image image() const;

private:
  int width_, height_; // in samples
  std::vector<float> depth_;
  std::vector<Color> color_;
};

#endif // TUBULAR_MESH_PICTURE_RASTER_H
