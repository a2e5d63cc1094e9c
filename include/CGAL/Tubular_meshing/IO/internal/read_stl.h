// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_STL_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_STL_H

#include <CGAL/Tubular_meshing/IO/internal/Byte_cursor.h>
#include <CGAL/Tubular_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Tubular_meshing/IO/internal/Text_cursor.h>

#include <string>

namespace CGAL::Tubular_meshing::IO::internal {

constexpr std::size_t stl_header_bytes = 84;
constexpr std::size_t stl_facet_bytes = 50;

inline std::uint64_t announced_stl_bytes(const Input_file& file) {
  Byte_cursor in(file, 80, true);
  return stl_header_bytes + stl_facet_bytes * std::uint64_t(in.number<std::uint32_t>("number of triangles"));
}

// The size settles it: the header of a binary file may start with "solid" as well. A few bytes more are padding.
inline bool is_binary_stl(const Input_file& file) {
  if (file.bytes.size() < stl_header_bytes)
    return false;
  const std::uint64_t announced = announced_stl_bytes(file);
  return file.bytes.size() >= announced && file.bytes.size() - announced < stl_facet_bytes;
}

inline bool is_ascii_stl(const Input_file& file) {
  const std::string_view start = trimmed(std::string_view(file.bytes).substr(0, 256));
  return start.size() >= 5 && equal_ignoring_case(start.substr(0, 5), "solid") &&
         file.bytes.find('\0') == std::string::npos;
}

inline Polygon_soup read_binary_stl(const Input_file& file) {
  Polygon_soup soup;
  const std::size_t n = static_cast<std::size_t>((announced_stl_bytes(file) - stl_header_bytes) / stl_facet_bytes);
  soup.points.reserve(3 * n);
  soup.corners.reserve(3 * n);
  soup.ends.reserve(n);
  Byte_cursor in(file, stl_header_bytes, true);
  for (std::size_t f = 0; f < n; ++f) {
    in.take(3 * sizeof(float), "normal of a triangle");
    for (int i = 0; i < 3; ++i) {
      const char* p = in.take(3 * sizeof(float), "vertex of a triangle").data();
      Coordinates q;
      for (int k = 0; k < 3; ++k)
        q[k] = number_at<float>(p + k * sizeof(float), in.swapped());
      soup.corners.push_back(static_cast<std::int64_t>(soup.points.size()));
      soup.points.push_back(q);
    }
    in.take(2, "attribute of a triangle");
    soup.end_polygon();
  }
  return soup;
}

inline Polygon_soup read_ascii_stl(const Input_file& file) {
  Polygon_soup soup;
  soup.group_kind = "solids";
  Group_names names(soup.names);
  int solid = 0; // before the first
  Text_cursor in(file);
  bool in_solid = false, in_facet = false;
  while (!in.at_end()) {
    const std::string_view word = in.token();
    if (equal_ignoring_case(word, "vertex")) {
      Coordinates p;
      for (double& x : p)
        x = in.number("coordinate of a vertex");
      soup.corners.push_back(static_cast<std::int64_t>(soup.points.size()));
      soup.points.push_back(p);
    } else if (equal_ignoring_case(word, "facet")) {
      in_facet = true;
      in.line(); // the normal follows from the vertices
    } else if (equal_ignoring_case(word, "endfacet")) {
      const std::size_t begin = soup.ends.empty() ? 0 : soup.ends.back();
      if (!in_facet || soup.corners.size() < begin + 3)
        in.fail("a facet ends here that has fewer than three vertices");
      in_facet = false;
      soup.end_polygon();
      soup.groups.push_back(solid);
    } else if (equal_ignoring_case(word, "solid")) {
      in_solid = true;
      solid = names.number_of(std::string(trimmed(in.line()))); // a name, which may hold any word
    } else if (equal_ignoring_case(word, "endsolid")) {
      in_solid = false;
      in.line();
    } else if (!equal_ignoring_case(word, "outer") && !equal_ignoring_case(word, "loop") &&
               !equal_ignoring_case(word, "endloop"))
      in.fail(printable(word) + " is no word of an ASCII STL file");
  }
  if (in_solid || in_facet)
    in.fail_at_end("endsolid");
  return soup;
}

// The content decides between ASCII and binary. Every facet has points of its own.
inline Polygon_soup read_stl(const Input_file& file) {
  if (is_binary_stl(file))
    return read_binary_stl(file);
  if (is_ascii_stl(file))
    return read_ascii_stl(file);
  if (file.bytes.size() < stl_header_bytes)
    file.fail("is neither ASCII STL (it does not start with 'solid') nor binary STL (it has " +
              std::to_string(file.bytes.size()) + " bytes, fewer than the header takes); export it again");
  file.fail("is neither ASCII STL (it does not start with 'solid') nor whole binary STL (as such it would have to be " +
            std::to_string(announced_stl_bytes(file)) + " bytes long, but it has " + std::to_string(file.bytes.size()) +
            "); if it was truncated, export or copy it again");
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_STL_H
