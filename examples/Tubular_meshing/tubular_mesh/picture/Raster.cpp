// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

Raster::Raster(int width, int height, Color background)
    : width_(width * samples)
    , height_(height * samples)
    , depth_(std::size_t(width_) * std::size_t(height_), -(std::numeric_limits<float>::infinity)())
    , color_(depth_.size(), background) {}

namespace {

Color darkened(Color c, double by) {
  const auto times = [&](std::uint8_t x) { return std::uint8_t(std::lround(std::clamp(by, 0., 1.) * x)); };
  return {times(c.r), times(c.g), times(c.b)};
}

} // namespace

void Raster::draw(const std::array<Vector, 3>& corners, Color color, double shade, int sides, double lift) {
  std::array<Vector, 3> p = corners;
  for (Vector& v : p)
    v = double(samples) * v;
  const double twice_area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
  if (!(std::abs(twice_area) > 0)) // nor one that is not finite
    return;
  // Of each side, in samples: how far the opposite corner is. Where these are small, sides would fill the triangle.
  double height[3], least = (std::numeric_limits<double>::infinity)();
  for (int i = 0; i < 3; ++i) {
    const Vector &a = p[std::size_t((i + 1) % 3)], &b = p[std::size_t((i + 2) % 3)];
    height[i] = std::abs(twice_area) / std::hypot(b.x - a.x, b.y - a.y);
    least = (std::min)(least, height[i]);
  }
  const double line = 0.6 * samples;
  const double strength = 0.6 * std::clamp(least / line / 8, 0., 1.);
  const Color inside = darkened(color, shade), side = darkened(color, shade * (1 - strength));

  const auto bound = [](double x, int most) { return std::clamp(x, 0., double(most)); };
  const int left = int(bound(std::floor((std::min)({p[0].x, p[1].x, p[2].x})), width_)),
            right = int(bound(std::ceil((std::max)({p[0].x, p[1].x, p[2].x})) + 1, width_)),
            top = int(bound(std::floor((std::min)({p[0].y, p[1].y, p[2].y})), height_)),
            bottom = int(bound(std::ceil((std::max)({p[0].y, p[1].y, p[2].y})) + 1, height_));
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x) {
      double weight[3];
      bool is_inside = true, is_on_side = false;
      for (int i = 0; i < 3; ++i) {
        const Vector &a = p[std::size_t((i + 1) % 3)], &b = p[std::size_t((i + 2) % 3)];
        weight[i] = ((b.x - a.x) * (y + 0.5 - a.y) - (b.y - a.y) * (x + 0.5 - a.x)) / twice_area;
        is_inside = is_inside && weight[i] >= 0;
        is_on_side = is_on_side || ((sides >> i & 1) != 0 && weight[i] * height[i] < line);
      }
      if (!is_inside)
        continue;
      const std::size_t at = std::size_t(y) * std::size_t(width_) + std::size_t(x);
      const auto z = float(weight[0] * p[0].z + weight[1] * p[1].z + weight[2] * p[2].z + lift);
      if (z <= depth_[at])
        continue;
      depth_[at] = z;
      color_[at] = is_on_side ? side : inside;
    }
}

Image Raster::image() const {
  Image image = {width_ / samples, height_ / samples, {}};
  image.bytes.reserve(3 * color_.size() / (samples * samples));
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      int sum[3] = {0, 0, 0};
      for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i) {
          const Color& c = color_[std::size_t(y * samples + j) * std::size_t(width_) + std::size_t(x * samples + i)];
          sum[0] += c.r;
          sum[1] += c.g;
          sum[2] += c.b;
        }
      for (int s : sum)
        image.bytes.push_back(std::uint8_t(s / (samples * samples)));
    }
  return image;
}
