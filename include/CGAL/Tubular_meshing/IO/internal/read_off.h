// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_OFF_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_OFF_H

#include <CGAL/Tubular_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Tubular_meshing/IO/internal/Text_cursor.h>

#include <string>

namespace CGAL::Tubular_meshing::IO::internal {

inline void skip_off_comments(Text_cursor& in) {
  while (!in.at_end() && in.peek().front() == '#')
    in.line();
}

// "OFF", or with letters before it for what else the vertices carry (colours, normals, texture).
inline void read_off_keyword(Text_cursor& in) {
  skip_off_comments(in);
  const std::string_view word = in.token();
  const bool is_off = word.size() >= 3 && word.size() <= 6 && word.substr(word.size() - 3) == "OFF" &&
                      word.find_first_not_of("STCNOF") == word.npos;
  if (!is_off)
    in.fail(printable(word) + " stands where an OFF file has its keyword OFF");
  if (in.peek() == "BINARY")
    in.fail("this is a binary OFF file; convert it to ASCII");
}

// A vertex or a face takes a line: what follows its coordinates or indices there (colours, …) is passed over.
inline Polygon_soup read_off(const Input_file& file) {
  Polygon_soup soup;
  Text_cursor in(file);
  read_off_keyword(in);
  skip_off_comments(in);
  const std::size_t vertices = in.count("number of vertices", 6);
  const std::size_t faces = in.count("number of faces", 4);
  in.line(); // the number of edges, which nobody needs
  soup.points.reserve(vertices);
  for (std::size_t i = 0; i < vertices; ++i) {
    skip_off_comments(in);
    Coordinates p;
    for (double& x : p)
      x = in.number("coordinate of a vertex");
    soup.points.push_back(p);
    in.line();
  }
  soup.ends.reserve(faces);
  soup.corners.reserve(3 * faces);
  for (std::size_t f = 0; f < faces; ++f) {
    skip_off_comments(in);
    const std::size_t k = in.count("number of corners of a face", 2);
    for (std::size_t i = 0; i < k; ++i)
      soup.corners.push_back(in.integer("corner of a face"));
    soup.end_polygon();
    in.line();
  }
  return soup;
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_OFF_H
