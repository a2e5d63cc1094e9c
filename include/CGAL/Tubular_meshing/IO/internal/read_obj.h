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

// Whether a line that ends here is the last one, and has no end of line.
inline bool is_cut_off(const Input_file& file, std::size_t end_of_line) {
  return end_of_line == file.bytes.size() && file.bytes.back() != '\n';
}

// What stands behind g or o: the first name of several.
inline std::string obj_name(std::string_view rest) {
  return std::string(next_word(rest));
}

// Vertices, faces, and the names of groups (g) and objects (o) that they are in; all else (normals, texture, materials,
// lines) is passed over. Exporters write loose edges and points as faces of fewer than three corners: no triangles come
// of these.
inline Polygon_soup read_obj(const Input_file& file) {
  Polygon_soup soup;
  soup.group_kind = "groups";
  Group_names names(soup.names);
  int group = 0; // in none
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
      if (soup.corners.size() < begin + 3 && is_cut_off(file, next_line))
        in.fail("the last face has fewer than three corners; the file was truncated, export or copy it again");
      soup.end_polygon();
      soup.groups.push_back(group);
    } else if (keyword == "g" || keyword == "o") {
      const std::string name = obj_name(rest);
      group = names.number_of(name.empty() ? "default" : name);
    }
    in.move_to(next_line);
  }
  return soup;
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_OBJ_H
