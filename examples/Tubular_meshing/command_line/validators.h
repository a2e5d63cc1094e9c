// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMMAND_LINE_VALIDATORS_H
#define COMMAND_LINE_VALIDATORS_H

#include "Points.h"

#include <CLI/CLI.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>

namespace command_line {

// A number between bounds; unlike CLI::Range it refuses NaN, and says it in a few words.
inline CLI::Validator in_range(double least, double most) {
  const auto check = [=](std::string& text) {
    double x = 0;
    if (CLI::detail::lexical_cast(text, x) && x >= least && x <= most)
      return std::string();
    std::ostringstream error;
    error << text << " is not ";
    if (most >= (std::numeric_limits<double>::max)())
      error << "a number " << (least > 0 ? "above 0" : "of 0 or more");
    else
      error << "a number from " << least << " to " << most;
    return error.str();
  };
  return CLI::Validator(check, "");
}

inline CLI::Validator is_point() {
  const auto check = [](std::string& text) {
    CGAL::Tubular_meshing::Point_3 ignored;
    return parse_point(text, ignored) ? std::string() : "\"" + text + "\" is not a point X,Y,Z of finite numbers";
  };
  return CLI::Validator(check, "");
}

// A comma makes it a point.
inline CLI::Validator is_point_or_name() {
  const auto check = [](std::string& text) {
    CGAL::Tubular_meshing::Point_3 ignored;
    return parse_point(text, ignored) || (!text.empty() && text.find(',') == text.npos)
               ? std::string()
               : "\"" + text + "\" is not a point X,Y,Z of finite numbers, nor a name";
  };
  return CLI::Validator(check, "");
}

// So many numbers, the last of which is a factor that sizes are divided by, and the one before it above 0 or an index.
template <std::size_t N> CLI::Validator is_refinement(const char* form) {
  const auto check = [=](std::string& text) {
    std::array<double, N> x;
    const bool good = parse_numbers(text, x) && x[N - 1] > 0 && x[N - 1] <= 100 &&
                      (N > 2 ? x[N - 2] > 0 : x[N - 2] >= 0 && x[N - 2] < 1e9 && x[N - 2] == std::floor(x[N - 2]));
    return good ? std::string() : "\"" + text + "\" is not " + form + ", with a factor above 0 and at most 100";
  };
  return CLI::Validator(check, "");
}

inline CLI::Validator is_number_or_named_number() {
  const auto check = [](std::string& text) {
    const std::size_t sign = text.rfind('=');
    double x = 0;
    return parse_number(sign == text.npos ? text : text.substr(sign + 1), x) && std::isfinite(x) && sign != 0
               ? std::string()
               : "\"" + text + "\" is not a number, nor NAME=NUMBER";
  };
  return CLI::Validator(check, "");
}

// NAME=NEW; both have a letter at least.
inline CLI::Validator is_renaming() {
  const auto check = [](std::string& text) {
    const std::size_t sign = text.find('=');
    return sign != text.npos && sign > 0 && sign + 1 < text.size() && text.find('"') == text.npos
               ? std::string()
               : "\"" + text + "\" is not NAME=NEW";
  };
  return CLI::Validator(check, "");
}

// A name of an axis, or so many numbers of which the last three are no zero vector.
template <std::size_t N> CLI::Validator is_axis_or(const char* form) {
  const auto check = [=](std::string& text) {
    Point_3 direction;
    std::array<double, N> x;
    const bool good =
        parse_axis(text, direction) || (parse_numbers(text, x) && (x[N - 1] != 0 || x[N - 2] != 0 || x[N - 3] != 0));
    return good ? std::string() : "\"" + text + "\" is not x, y, z, -x, -y, -z or " + form;
  };
  return CLI::Validator(check, "");
}
inline CLI::Validator is_direction() {
  return is_axis_or<3>("a direction X,Y,Z");
}
inline CLI::Validator is_plane() {
  return is_axis_or<6>("a plane X,Y,Z,NX,NY,NZ");
}

inline CLI::Validator is_picture_size() {
  const auto check = [](std::string& text) {
    std::array<int, 2> size;
    return parse_picture_size(text, size) ? std::string() : "\"" + text + "\" is not WIDTHxHEIGHT, each of 16 to 4096";
  };
  return CLI::Validator(check, "");
}

} // namespace command_line

#endif // COMMAND_LINE_VALIDATORS_H
