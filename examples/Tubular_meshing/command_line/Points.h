// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMMAND_LINE_POINTS_H
#define COMMAND_LINE_POINTS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

/* Points on the command line, as X,Y,Z, and in files. */
namespace command_line {

using CGAL::Tubular_meshing::Point_3;

inline bool parse_number(const std::string& word, double& number) {
  char* end = nullptr;
  number = double(std::strtold(word.c_str(), &end));
  return end == word.c_str() + word.size() && !word.empty();
}

// So many finite numbers, apart by commas or blanks.
template <std::size_t N> bool parse_numbers(std::string text, std::array<double, N>& numbers) {
  for (char& c : text)
    c = c == ',' ? ' ' : c;
  std::istringstream words(text);
  std::string word;
  for (double& x : numbers)
    if (!(words >> word) || !parse_number(word, x) || !std::isfinite(x))
      return false;
  return !(words >> word);
}

inline bool parse_point(const std::string& text, Point_3& point) {
  std::array<double, 3> x;
  if (!parse_numbers(text, x))
    return false;
  point = Point_3(x[0], x[1], x[2]);
  return true;
}

// x, y, z, -x, -y or -z.
inline bool parse_axis(const std::string& text, Point_3& direction) {
  const std::size_t sign = !text.empty() && text[0] == '-' ? 1 : 0;
  if (text.size() != sign + 1 || text[sign] < 'x' || text[sign] > 'z')
    return false;
  const double x = sign == 1 ? -1 : 1;
  direction = Point_3(text[sign] == 'x' ? x : 0, text[sign] == 'y' ? x : 0, text[sign] == 'z' ? x : 0);
  return true;
}

// WIDTHxHEIGHT or WIDTH,HEIGHT, of a picture.
inline bool parse_picture_size(const std::string& text, std::array<int, 2>& size) {
  const std::size_t cross = text.find_first_of("x,");
  double width = 0, height = 0;
  if (cross == std::string::npos || text.find_first_of("x,", cross + 1) != std::string::npos ||
      text.find_first_not_of("0123456789x,") != std::string::npos || !parse_number(text.substr(0, cross), width) ||
      !parse_number(text.substr(cross + 1), height))
    return false;
  if (!(width >= 16 && width <= 4096 && height >= 16 && height <= 4096))
    return false;
  size = {int(width), int(height)};
  return true;
}

// Of text that was found to be them.
template <std::size_t N> std::array<double, N> numbers_of(const std::string& text) {
  std::array<double, N> numbers = {};
  parse_numbers(text, numbers);
  return numbers;
}

// Of text that was found to be one.
inline Point_3 point_of(const std::string& text) {
  Point_3 point;
  parse_point(text, point);
  return point;
}

// A point a line; lines that are empty or begin with # do not count.
inline std::vector<Point_3> read_points(const std::string& file) {
  std::ifstream in(file);
  if (!in)
    throw CGAL::Tubular_meshing::Input_error("The file \"" + file + "\" cannot be read.");
  std::vector<Point_3> points;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#')
      continue;
    points.emplace_back();
    if (!parse_point(line, points.back()))
      throw CGAL::Tubular_meshing::Input_error("Line " + std::to_string(number) + " of \"" + file +
                                               "\" is not a point; three finite numbers make one.");
  }
  if (points.size() < 2)
    throw CGAL::Tubular_meshing::Input_error("The file \"" + file + "\" holds " + std::to_string(points.size()) +
                                             " points; centerlines need a source and at least one target.");
  return points;
}

} // namespace command_line

#endif // COMMAND_LINE_POINTS_H
