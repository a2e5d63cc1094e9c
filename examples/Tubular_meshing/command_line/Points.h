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
