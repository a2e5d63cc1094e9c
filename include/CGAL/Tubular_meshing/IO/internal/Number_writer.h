// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_NUMBER_WRITER_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_NUMBER_WRITER_H

#include <CGAL/Tubular_meshing/IO/internal/Byte_cursor.h>
#include <CGAL/Tubular_meshing/IO/Output_file.h>

#include <charconv>
#include <string>
#include <string_view>
#include <type_traits>

namespace CGAL::Tubular_meshing::IO::internal {

// The bytes of a number, in the machine's order or the other.
template <class T> void append_bytes(std::string& out, T value, bool swapped = false) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  if (swapped)
    std::reverse(bytes, bytes + sizeof(T));
  out.append(bytes, sizeof(T));
}

// Numbers and words on their way into a file, as text or as bytes. As text, a floating point number has the fewest
// digits from which exactly the same number is read back.
class Number_writer {
public:
  explicit Number_writer(Output_file& file)
      : file_(file) {}
  ~Number_writer() = default;

  Number_writer& operator<<(std::string_view text) {
    buffer_ += text;
    return flush_if_full();
  }
  Number_writer& operator<<(const char* text) { return *this << std::string_view(text); }
  Number_writer& operator<<(char c) { return *this << std::string_view(&c, 1); }

  template <class T> std::enable_if_t<std::is_arithmetic<T>::value, Number_writer&> operator<<(T value) {
    char digits[32];
    const auto result = std::to_chars(digits, digits + sizeof digits, value);
    return *this << std::string_view(digits, static_cast<std::size_t>(result.ptr - digits));
  }

  template <class T> Number_writer& bytes(T value, bool swapped = false) {
    append_bytes(buffer_, value, swapped);
    return flush_if_full();
  }

  // To be called at the end.
  void flush() {
    file_.write(buffer_);
    buffer_.clear();
  }

private:
  Number_writer& flush_if_full() {
    if (buffer_.size() >= (1u << 16))
      flush();
    return *this;
  }

  Output_file& file_;
  std::string buffer_;
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_NUMBER_WRITER_H
