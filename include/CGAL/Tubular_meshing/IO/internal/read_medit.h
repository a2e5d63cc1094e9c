// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_MEDIT_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_MEDIT_H

#include <CGAL/Tubular_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Tubular_meshing/IO/internal/Text_cursor.h>
#include <CGAL/Tubular_meshing/IO/internal/element_kinds.h>
#include <CGAL/Tubular_meshing/IO/internal/write_medit.h>

#include <array>
#include <filesystem>
#include <string>

namespace CGAL::Tubular_meshing::IO::internal {

// "# region 1 lumen" or "# patch 2 inlet", as write_medit() writes them; any other comment says nothing here.
inline void read_medit_comment(std::string_view line, Mixed_mesh& mesh) {
  line.remove_prefix(line.empty() ? 0 : 1);
  line = trimmed(line);
  for (const char* what : {"region ", "patch "}) {
    const std::string_view word(what);
    if (line.substr(0, word.size()) != word)
      continue;
    line.remove_prefix(word.size());
    const std::size_t blank = line.find(' ');
    std::int64_t label;
    if (blank == line.npos || !parse_number(line.substr(0, blank), label))
      return;
    Label_names& names = word == "patch " ? mesh.patch_names : mesh.region_names;
    names[static_cast<int>(label)] = std::string(line.substr(blank + 1));
  }
}

inline void read_medit_vertices(Text_cursor& in, Mixed_mesh& mesh) {
  const std::size_t n = in.count("number of vertices", 7);
  if (!mesh.points.empty())
    in.fail("a second section Vertices begins; the elements before it refer to the first");
  mesh.points.resize(n);
  for (Point_3& p : mesh.points) {
    Coordinates c;
    for (double& x : c)
      x = in.number("coordinate of a vertex");
    p = to_point(c);
    in.integer("reference of a vertex");
  }
}

inline void read_medit_elements(Text_cursor& in, const Element_kind& kind, Mixed_mesh& mesh) {
  const std::size_t n = in.count("number of elements", 2 * kind.corners);
  std::array<std::int64_t, 8> corners;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < kind.corners; ++k) {
      const std::int64_t vertex = in.integer("corner of an element"); // counted from 1
      corners[k] = vertex > 0 ? vertex - 1 : -1;
      check_index(corners[k], mesh.points.size(), kind.medit_keyword, i, in.file());
    }
    add_element(mesh, kind, corners.begin(), false, static_cast<int>(in.integer("reference of an element")));
  }
}

// The numbers of a section that does not matter here.
inline void skip_medit_section(Text_cursor& in) {
  double ignored;
  while (!in.at_end() && parse_number(in.peek(), ignored))
    in.token();
}

// The tensors beside the mesh, if there are as many as points: else they belong to another mesh of that name.
inline void read_medit_solution(const std::string& name, Mixed_mesh& mesh) {
  if (!std::filesystem::exists(name))
    return;
  const Input_file file(name);
  Text_cursor in(file);
  while (!in.at_end() && in.peek() != "SolAtVertices")
    in.token();
  in.token();
  if (in.at_end() || in.count("number of solutions") != mesh.points.size())
    return;
  if (in.integer("solutions at a vertex") != 1 || in.integer("kind of solution") != 3)
    return;
  Point_array metric{metric_array_name, 6, std::vector<double>(6 * mesh.points.size())};
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    for (std::size_t k = 0; k < 6; ++k)
      metric.values[6 * i + medit_component[k]] = in.number("metric");
  mesh.point_arrays.push_back(std::move(metric));
}

// Sections of other entities are passed over.
inline void read_medit(const Input_file& file, Mixed_mesh& mesh) {
  Text_cursor in(file);
  bool known = false, ended = false;
  while (!ended && !in.at_end()) {
    if (in.peek().front() == '#') {
      read_medit_comment(in.line(), mesh);
      continue;
    }
    const std::string_view word = in.token();
    const Element_kind* kind = find_kind(&Element_kind::medit_keyword, word);
    if (word == "MeshVersionFormatted")
      known = true;
    if (!known)
      in.fail("a .mesh file starts with MeshVersionFormatted, not with " + printable(word));
    if (word == "Dimension" && in.integer("dimension") != 3)
      in.fail("the dimension is not 3");
    if (word == "Vertices")
      read_medit_vertices(in, mesh);
    else if (kind)
      read_medit_elements(in, *kind, mesh);
    else if (word[0] < 'A' || word[0] > 'Z')
      in.fail(printable(word) + " stands where a keyword should be");
    else
      skip_medit_section(in);
    ended = word == "End";
  }
  if (!ended)
    in.fail_at_end("keyword End");
  read_medit_solution(medit_solution_name(file.name), mesh);
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_MEDIT_H
