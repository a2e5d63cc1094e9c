// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_ENCODED_STREAM_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_ENCODED_STREAM_H

#include <CGAL/Tubular_meshing/IO/internal/Text_cursor.h>

#include <array>
#include <string>
#include <string_view>

namespace CGAL::Tubular_meshing::IO::internal {

inline int base64_digit(char c) {
  static const std::array<signed char, 256> digits = [] {
    std::array<signed char, 256> d;
    d.fill(-1);
    const char* alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (int i = 0; i < 64; ++i)
      d[static_cast<unsigned char>(alphabet[i])] = static_cast<signed char>(i);
    return d;
  }();
  return digits[static_cast<unsigned char>(c)];
}

// The bytes of a VTK XML data array, raw or in base64, from its first byte on. In base64 the header and the data may be
// encoded one by one: padding in the middle is passed over.
class Encoded_stream {
public:
  Encoded_stream(std::string_view text, bool base64, const Input_file& file)
      : text_(text)
      , base64_(base64)
      , file_(&file) {}

  // No more bytes than this can follow.
  std::size_t most_bytes() const { return ready_.size() + (base64_ ? text_.size() / 4 * 3 : text_.size()); }

  std::string read(std::size_t n) {
    if (n > most_bytes())
      fail();
    if (!base64_) {
      const std::string bytes(text_.substr(0, n));
      text_.remove_prefix(n);
      return bytes;
    }
    std::string bytes = std::move(ready_);
    ready_.clear();
    bytes.reserve(n + 3);
    while (bytes.size() < n)
      decode_quad(bytes);
    ready_ = bytes.substr(n);
    bytes.resize(n);
    return bytes;
  }

  [[noreturn]] void fail() const {
    file_->fail("cannot be used: a data array in it is cut off or damaged; export or copy it again");
  }

private:
  void decode_quad(std::string& out) {
    int digits = 0, padding = 0;
    unsigned value = 0;
    while (digits + padding < 4) {
      if (text_.empty())
        fail();
      const char c = text_.front();
      text_.remove_prefix(1);
      const int d = base64_digit(c);
      if (d >= 0 && padding == 0) {
        value = value << 6 | static_cast<unsigned>(d);
        ++digits;
      } else if (c == '=' && digits >= 2)
        ++padding;
      else if (!is_space(c))
        fail();
    }
    value <<= 6 * padding;
    for (int i = 0; i < 3 - padding; ++i)
      out += static_cast<char>(value >> (16 - 8 * i) & 0xff);
  }

  std::string_view text_;
  std::string ready_;
  bool base64_;
  const Input_file* file_;
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_ENCODED_STREAM_H
