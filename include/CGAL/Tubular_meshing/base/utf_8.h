// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_UTF_8_H
#define CGAL_TUBULAR_MESHING_BASE_UTF_8_H

#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL::Tubular_meshing::internal {

/* How many bytes the letter has that a text in UTF-8 begins with; 0 if it does not begin with one: not with a byte that
 * continues a letter, a longer spelling than need be, half of a pair of UTF-16, or what is beyond Unicode. */
inline std::size_t bytes_of_first_letter(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned first = byte(0), second = byte(1);
  const std::size_t bytes = first < 0x80   ? 1
                            : first < 0xc2 ? 0
                            : first < 0xe0 ? 2
                            : first < 0xf0 ? 3
                            : first < 0xf5 ? 4
                                           : 0;
  for (std::size_t i = 1; i < bytes; ++i)
    if ((byte(i) & 0xc0) != 0x80)
      return 0;
  const bool is_none = (first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
                       (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f);
  return is_none ? 0 : bytes;
}

/* A text, with U+FFFD for each byte of it that is no part of a letter in UTF-8: names come from files, and may hold any
 * bytes. */
inline std::string as_utf_8(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t bytes = bytes_of_first_letter(text);
    out += bytes == 0 ? std::string_view("\xef\xbf\xbd") : text.substr(0, bytes);
    text.remove_prefix(bytes == 0 ? 1 : bytes);
  }
  return out;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_UTF_8_H
