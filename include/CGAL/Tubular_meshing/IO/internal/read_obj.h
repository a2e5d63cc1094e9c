// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_OBJ_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_OBJ_H

#include <CGAL/Tubular_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Tubular_meshing/IO/internal/Text_cursor.h>

#include <string>

namespace CGAL::Tubular_meshing::IO::internal {

inline std::string_view next_word(std::string_view& line) {
  while (!line.empty() && is_space(line.front()))
    line.remove_prefix(1);
  std::size_t n = 0;
  while (n < line.size() && !is_space(line[n]))
    ++n;
  const std::string_view word = line.substr(0, n);
  line.remove_prefix(n);
  return word;
}

// The vertex of a corner "v", "v/t", "v//n" or "v/t/n"; negative numbers count back from the latest vertex.
inline std::int64_t obj_corner(std::string_view word, std::size_t vertices, const Text_cursor& in) {
  std::int64_t v;
  if (!parse_number(word.substr(0, word.find('/')), v) || v == 0)
    in.fail(printable(word) + " stands where the corner of a face should be");
  return v > 0 ? v - 1 : static_cast<std::int64_t>(vertices) + v;
}

// Vertices and faces; all else (normals, texture, groups, materials, lines) is passed over.
inline Polygon_soup read_obj(const Input_file& file) {
  Polygon_soup soup;
  Text_cursor in(file);
  while (!in.at_end()) {
    const std::size_t start_of_line = in.position();
    std::string_view rest = in.line();
    const std::size_t next_line = in.position();
    in.move_to(start_of_line); // errors name this line
    const std::string_view keyword = next_word(rest);
    if (keyword == "v") {
      Coordinates p;
      for (double& x : p) {
        const std::string_view word = next_word(rest);
        if (!parse_number(word, x))
          in.fail(printable(word) + " stands where the coordinate of a vertex should be");
      }
      soup.points.push_back(p);
    } else if (keyword == "f") {
      for (std::string_view word = next_word(rest); !word.empty() && word.front() != '#'; word = next_word(rest))
        soup.corners.push_back(obj_corner(word, soup.points.size(), in));
      const std::size_t begin = soup.ends.empty() ? 0 : soup.ends.back();
      if (soup.corners.size() < begin + 3)
        in.fail("a face has fewer than three corners; if the file was truncated, export or copy it again");
      soup.end_polygon();
    }
    in.move_to(next_line);
  }
  return soup;
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_OBJ_H
