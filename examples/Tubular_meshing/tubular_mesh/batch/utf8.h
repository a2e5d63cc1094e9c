// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_BATCH_UTF8_H
#define TUBULAR_MESH_BATCH_UTF8_H

#include <cstddef>
#include <string>

/* The length of the character at a place of a text; 0 where there is none in UTF-8. */
inline std::size_t utf8_character(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  const std::size_t n = first < 0x80                     ? 1
                        : first >= 0xC2 && first <= 0xDF ? 2
                        : first >= 0xE0 && first <= 0xEF ? 3
                        : first >= 0xF0 && first <= 0xF4 ? 4
                                                         : 0;
  if (n == 0 || at + n > text.size())
    return 0;
  for (std::size_t k = 1; k < n; ++k)
    if ((byte(at + k) & 0xC0) != 0x80)
      return 0;
  const bool is_overlong = (first == 0xE0 && byte(at + 1) < 0xA0) || (first == 0xF0 && byte(at + 1) < 0x90);
  const bool is_no_character = (first == 0xED && byte(at + 1) >= 0xA0) || (first == 0xF4 && byte(at + 1) >= 0x90);
  return is_overlong || is_no_character ? 0 : n;
}

inline bool is_utf8(const std::string& text) {
  for (std::size_t i = 0, n; i < text.size(); i += n)
    if ((n = utf8_character(text, i)) == 0)
      return false;
  return true;
}

/* A text for a page, whatever bytes it has: file names need not be in UTF-8. */
inline std::string as_utf8(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t n = utf8_character(text, i);
    out += n > 0 ? text.substr(i, n) : "\xEF\xBF\xBD";
    i += n > 0 ? n : 1;
  }
  return out;
}

#endif // TUBULAR_MESH_BATCH_UTF8_H
