// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_NUMBER_WRITER_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_NUMBER_WRITER_H

#include <CGAL/Tubular_meshing/IO/internal/Byte_cursor.h>
#include <CGAL/Tubular_meshing/IO/Output_file.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

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
      : file_(file)
      , buffer_(capacity) {}

  Number_writer& operator<<(std::string_view text) {
    if (text.size() > capacity - size_)
      return write_long(text);
    std::memcpy(buffer_.data() + size_, text.data(), text.size());
    size_ += text.size();
    return *this;
  }
  Number_writer& operator<<(const char* text) { return *this << std::string_view(text); }
  Number_writer& operator<<(char c) {
    make_room(1);
    buffer_[size_++] = c;
    return *this;
  }

  template <class T> std::enable_if_t<std::is_arithmetic<T>::value, Number_writer&> operator<<(T value) {
    constexpr std::size_t most = 32;
    make_room(most);
    char* const begin = buffer_.data() + size_;
    size_ += static_cast<std::size_t>(std::to_chars(begin, begin + most, value).ptr - begin);
    return *this;
  }

  Number_writer& hexadecimal(std::size_t value) {
    constexpr std::size_t most = 32;
    make_room(most);
    char* const begin = buffer_.data() + size_;
    size_ += static_cast<std::size_t>(std::to_chars(begin, begin + most, value, 16).ptr - begin);
    return *this;
  }

  template <class T> Number_writer& bytes(T value, bool swapped = false) {
    make_room(sizeof(T));
    char* const begin = buffer_.data() + size_;
    std::memcpy(begin, &value, sizeof(T));
    if (swapped)
      std::reverse(begin, begin + sizeof(T));
    size_ += sizeof(T);
    return *this;
  }

  // To be called at the end.
  void flush() {
    file_.write(std::string_view(buffer_.data(), size_));
    size_ = 0;
  }

private:
  static constexpr std::size_t capacity = std::size_t(1) << 16;

  void make_room(std::size_t bytes) {
    if (bytes > capacity - size_)
      flush();
  }
  Number_writer& write_long(std::string_view text) {
    flush();
    file_.write(text);
    return *this;
  }

  Output_file& file_;
  std::vector<char> buffer_;
  std::size_t size_ = 0;
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_NUMBER_WRITER_H
