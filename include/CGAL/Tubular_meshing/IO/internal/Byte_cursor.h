// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_BYTE_CURSOR_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_BYTE_CURSOR_H

#include <CGAL/Tubular_meshing/IO/internal/Input_file.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

inline bool host_is_little_endian() {
  const std::uint16_t one = 1;
  char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

// The number whose bytes begin at p; `swapped` if the file's byte order is not the machine's.
template <class T> T number_at(const char* p, bool swapped) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, p, sizeof(T));
  if (swapped)
    std::reverse(bytes, bytes + sizeof(T));
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

// How a number is stored: signed integer, unsigned integer or floating point, and its bytes. No bytes: no such type.
struct Number_type {
  char kind = 'i'; // i, u or f
  unsigned size = 0;

  bool is_known() const { return size != 0; }
};

// Calls f(p) with a pointer-typed tag of the C++ type that the number has in the file.
template <class F> auto with_type(Number_type t, F f) {
  if (t.kind == 'f')
    return t.size == 4 ? f(static_cast<float*>(nullptr)) : f(static_cast<double*>(nullptr));
  const bool sign = t.kind == 'i';
  switch (t.size) {
  case 1:
    return sign ? f(static_cast<std::int8_t*>(nullptr)) : f(static_cast<std::uint8_t*>(nullptr));
  case 2:
    return sign ? f(static_cast<std::int16_t*>(nullptr)) : f(static_cast<std::uint16_t*>(nullptr));
  case 4:
    return sign ? f(static_cast<std::int32_t*>(nullptr)) : f(static_cast<std::uint32_t*>(nullptr));
  default:
    return sign ? f(static_cast<std::int64_t*>(nullptr)) : f(static_cast<std::uint64_t*>(nullptr));
  }
}

// One number of the type t, as a T. An integer is asked for only where the file has one.
template <class T> T decode(const char* p, Number_type t, bool swapped) {
  return with_type(t, [=](auto* tag) {
    typedef std::remove_pointer_t<decltype(tag)> In_file;
    return static_cast<T>(number_at<In_file>(p, swapped));
  });
}

template <class T> std::vector<T> decode_all(std::string_view bytes, Number_type t, bool swapped) {
  std::vector<T> values(bytes.size() / t.size);
  with_type(t, [&](auto* tag) {
    typedef std::remove_pointer_t<decltype(tag)> In_file;
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = static_cast<T>(number_at<In_file>(bytes.data() + i * sizeof(In_file), swapped));
  });
  return values;
}

// A reading position in the bytes of a file.
class Byte_cursor {
public:
  Byte_cursor(const Input_file& file, std::size_t position, bool little_endian)
      : file_(&file)
      , position_(position)
      , swapped_(little_endian != host_is_little_endian()) {}

  const Input_file& file() const { return *file_; }
  std::size_t position() const { return position_; }
  std::size_t remaining() const { return file_->bytes.size() - position_; }
  bool swapped() const { return swapped_; }
  void set_swapped(bool swapped) { swapped_ = swapped; }

  template <class T> T number(const char* what) { return number_at<T>(take(sizeof(T), what).data(), swapped_); }

  template <class T> T number(Number_type t, const char* what) {
    return decode<T>(take(t.size, what).data(), t, swapped_);
  }

  template <class T> std::vector<T> numbers(std::size_t n, Number_type t, const char* what) {
    return decode_all<T>(take(n, t.size, what), t, swapped_);
  }

  // The next n items of `size` bytes each.
  std::string_view take(std::size_t n, std::size_t size, const char* what) {
    if (size != 0 && n > remaining() / size)
      fail("the " + std::string(what) + " should take " + std::to_string(n) + " x " + std::to_string(size) +
           " bytes, but only " + std::to_string(remaining()) +
           " are left; the file is truncated or damaged, export or copy it again");
    const std::string_view bytes(file_->bytes.data() + position_, n * size);
    position_ += n * size;
    return bytes;
  }
  std::string_view take(std::size_t n, const char* what) { return take(n, 1, what); }

  [[noreturn]] void fail(const std::string& what) const {
    file_->fail("cannot be used: byte " + std::to_string(position_) + ": " + what);
  }

private:
  const Input_file* file_;
  std::size_t position_;
  bool swapped_;
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_BYTE_CURSOR_H
