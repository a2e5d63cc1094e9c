// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "write_png.h"

#include "../view/deflate.h"

#include <zlib.h>

#include <cstdlib>

namespace {

void append_number(std::string& bytes, std::uint32_t n) {
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes += char(n >> shift & 255);
}

void append_chunk(std::string& png, const std::string& type, const std::string& content) {
  append_number(png, std::uint32_t(content.size()));
  const std::string checked = type + content;
  png += checked;
  append_number(png, std::uint32_t(crc32(0, reinterpret_cast<const Bytef*>(checked.data()), uInt(checked.size()))));
}

// A row less what the pixel to the left (filter 1) or above (filter 2) has, or as it is (0).
std::string filtered(const std::uint8_t* row, const std::uint8_t* above, std::size_t n, int filter) {
  std::string out(1, char(filter));
  for (std::size_t i = 0; i < n; ++i) {
    const int before = filter == 1 ? (i >= 3 ? row[i - 3] : 0) : filter == 2 && above ? above[i] : 0;
    out += char(row[i] - before);
  }
  return out;
}

// The rule of thumb of the PNG specification.
long sum_of_sizes(const std::string& row) {
  long sum = 0;
  for (std::size_t i = 1; i < row.size(); ++i)
    sum += std::abs(static_cast<signed char>(row[i]));
  return sum;
}

} // namespace

std::string png_of(const Image& image) {
  std::string rows;
  const std::size_t n = 3 * std::size_t(image.width);
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* row = image.bytes.data() + std::size_t(y) * n;
    std::string best;
    for (int filter = 0; filter < 3; ++filter) {
      const std::string candidate = filtered(row, y > 0 ? row - n : nullptr, n, filter);
      if (best.empty() || sum_of_sizes(candidate) < sum_of_sizes(best))
        best = candidate;
    }
    rows += best;
  }
  std::string png = "\x89PNG\r\n\x1a\n", header;
  append_number(header, std::uint32_t(image.width));
  append_number(header, std::uint32_t(image.height));
  header += std::string("\x08\x02\x00\x00\x00", 5); // 8 bits a channel, three channels
  append_chunk(png, "IHDR", header);
  append_chunk(png, "IDAT", deflated(rows));
  append_chunk(png, "IEND", "");
  return png;
}
