// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_TEXT_CURSOR_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_TEXT_CURSOR_H

#include <CGAL/Tubular_meshing/IO/internal/Input_file.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace CGAL::Tubular_meshing::IO::internal {

inline bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

inline std::string_view trimmed(std::string_view s) {
  while (!s.empty() && is_space(s.front()))
    s.remove_prefix(1);
  while (!s.empty() && is_space(s.back()))
    s.remove_suffix(1);
  return s;
}

inline char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

inline bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](char x, char y) { return lower(x) == lower(y); });
}

// What stands in a message for a piece of the file: short, and printable whatever the file holds.
inline std::string printable(std::string_view s) {
  std::string out;
  for (char c : s.substr(0, 32))
    out += c >= ' ' && c <= '~' ? c : '?';
  return '\'' + out + (s.size() > 32 ? "...'" : "'");
}

// The number a whole token spells. \c false if it spells none. nan, inf and overflow are numbers here: whoever uses
// the value says which vertex it would have been.
inline bool parse_number(std::string_view token, double& value) {
  if (!token.empty() && token.front() == '+')
    token.remove_prefix(1);
  const char* end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  if (error == std::errc::result_out_of_range) {
    const bool tiny = token.find("e-") != token.npos || token.find("E-") != token.npos;
    value = tiny ? 0. : std::numeric_limits<double>::infinity();
    return stop == end;
  }
  return error == std::errc() && stop == end;
}

inline bool parse_number(std::string_view token, std::int64_t& value) {
  if (!token.empty() && token.front() == '+')
    token.remove_prefix(1);
  const char* end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  return error == std::errc() && stop == end;
}

// A reading position in the text of a file, by tokens (what white space separates) or by lines. Line numbers are
// counted only when an error names one. Binary stretches are left to Byte_cursor, by position().
class Text_cursor {
public:
  explicit Text_cursor(const Input_file& file)
      : Text_cursor(file, file.bytes) {}
  // Reads a part of a file, or a text that was made of one.
  Text_cursor(const Input_file& file, std::string_view text)
      : file_(&file)
      , text_(text) {}

  const Input_file& file() const { return *file_; }
  std::size_t position() const { return position_; }
  void move_to(std::size_t position) { position_ = (std::min)(position, text_.size()); }
  std::size_t remaining() const { return text_.size() - position_; }
  std::string_view rest() const { return text_.substr(position_); }

  bool at_end() {
    skip_space();
    return position_ == text_.size();
  }

  // The next token; empty at the end.
  std::string_view token() {
    skip_space();
    const std::size_t begin = position_;
    while (position_ < text_.size() && !is_space(text_[position_]))
      ++position_;
    return text_.substr(begin, position_ - begin);
  }

  std::string_view peek() {
    const std::size_t before = position_;
    const std::string_view t = token();
    position_ = before;
    return t;
  }

  // What is left of the line, without its end; the cursor moves behind the line's end.
  std::string_view line() {
    const std::size_t begin = position_;
    std::size_t end = text_.find('\n', begin);
    position_ = end == text_.npos ? text_.size() : end + 1;
    end = end == text_.npos ? text_.size() : end;
    if (end > begin && text_[end - 1] == '\r')
      --end;
    return text_.substr(begin, end - begin);
  }

  double number(const char* what) { return parsed<double>(what, "a number"); }
  std::int64_t integer(const char* what) { return parsed<std::int64_t>(what, "an integer"); }

  // A number of things that are still to come, of which each takes at least `bytes` bytes: a header that promises
  // more than the file can hold is caught before anything is allocated.
  std::size_t count(const char* what, std::size_t bytes = 1) {
    const std::int64_t n = integer(what);
    if (n < 0)
      fail(std::string("the ") + what + " is " + std::to_string(n) + "; the file is damaged");
    if (static_cast<std::uint64_t>(n) > remaining() / bytes + 1)
      fail(std::string("the ") + what + " is said to be " + std::to_string(n) +
           ", which is more than the rest of the file can hold; the file is truncated or damaged");
    return static_cast<std::size_t>(n);
  }

  [[noreturn]] void fail(const std::string& what) const {
    const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(position_), '\n');
    file_->fail("cannot be used: line " + std::to_string(line) + ": " + what);
  }

  [[noreturn]] void fail_at_end(const char* what) const {
    fail(std::string("the file ends where the ") + what + " should be; it is truncated, export or copy it again");
  }

private:
  void skip_space() {
    while (position_ < text_.size() && is_space(text_[position_]))
      ++position_;
  }

  template <class T> T parsed(const char* what, const char* kind) {
    const std::string_view t = token();
    if (t.empty())
      fail_at_end(what);
    T value;
    if (!parse_number(t, value))
      fail(printable(t) + " stands where " + kind + " should be (" + what + ")");
    return value;
  }

  const Input_file* file_;
  std::string_view text_;
  std::size_t position_ = 0;
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_TEXT_CURSOR_H
