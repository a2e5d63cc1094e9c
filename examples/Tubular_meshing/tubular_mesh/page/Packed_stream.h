// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_PAGE_PACKED_STREAM_H
#define TUBULAR_MESH_PAGE_PACKED_STREAM_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/* Arrays of numbers as bytes that compress well: numbers that change little from one to the next as their differences,
 * 7 bits a byte; those with noise in their last bits as planes of bytes, the noise apart from the rest. viewer/src/unpack.js
 * reads them. */
class Packed_stream {
public:
  // What follows belongs to a section of this name.
  void begin(const std::string& section) { sections_.emplace_back(section, bytes_.size()); }

  void number(std::uint64_t n) {
    for (; n >= 128; n >>= 7)
      bytes_ += char((n & 127) | 128);
    bytes_ += char(n);
  }
  void signed_number(std::int64_t n) { number(folded(n)); }
  // Their differences.
  template <class Number> void differences(const std::vector<Number>& values) {
    std::int64_t last = 0;
    for (Number v : values) {
      signed_number(std::int64_t(v) - last);
      last = std::int64_t(v);
    }
  }
  // The lowest bytes of all, then the next, …
  void planes(const std::vector<std::uint32_t>& values, int bytes) {
    for (int shift = 0; shift < 8 * bytes; shift += 8)
      for (std::uint32_t v : values)
        bytes_ += char(v >> shift & 255);
  }
  void byte(int b) { bytes_ += char(b); }
  void raw(const void* first, std::size_t size) { bytes_.append(static_cast<const char*>(first), size); }

  // Small numbers of either sign as small ones without.
  static std::uint64_t folded(std::int64_t n) {
    return n < 0 ? (std::uint64_t(-(n + 1)) << 1 | 1) : std::uint64_t(n) << 1;
  }

  const std::string& bytes() const { return bytes_; }
  // The name of each section, and where it begins.
  const std::vector<std::pair<std::string, std::size_t>>& sections() const { return sections_; }

private:
  std::string bytes_;
  std::vector<std::pair<std::string, std::size_t>> sections_;
};

#endif // TUBULAR_MESH_PAGE_PACKED_STREAM_H
