// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_MEDIT_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_MEDIT_H

#include <CGAL/Tubular_meshing/IO/internal/Number_writer.h>
#include <CGAL/Tubular_meshing/IO/internal/element_kinds.h>

#include <CGAL/double.h>
#include <CGAL/number_utils.h>

#include <filesystem>
#include <string>

namespace CGAL::Tubular_meshing::IO::internal {

inline std::string medit_solution_name(const std::string& file) {
  return std::filesystem::path(file).replace_extension(".sol").string();
}

// The metric goes into a file of its own beside the mesh, where remeshers look for it.
inline void write_medit_solution(Output_file& file, const Point_array& metric) {
  Number_writer out(file);
  const std::size_t n = metric.values.size() / 6;
  out << "MeshVersionFormatted 2\n\nDimension 3\n\nSolAtVertices\n" << n << "\n1 3\n";
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < 6; ++k)
      out << metric.values[6 * i + medit_component[k]] << (k == 5 ? '\n' : ' ');
  out << "\nEnd\n";
  out.flush();
}

// The format has no names: they stand in comments, which other programs pass over.
inline void write_medit(Output_file& file, const Mixed_mesh& mesh) {
  Number_writer out(file);
  out << "MeshVersionFormatted 2\nDimension 3\n";
  for (const auto& n : mesh.region_names)
    out << "# region " << n.first << ' ' << n.second << '\n';
  for (const auto& n : mesh.patch_names)
    out << "# patch " << n.first << ' ' << n.second << '\n';
  out << "Vertices\n" << mesh.points.size() << '\n';
  for (const Point_3& p : mesh.points) {
    for (int k = 0; k < 3; ++k)
      out << p[k] << ' ';
    out << "0\n";
  }
  for_each_block(mesh, [&](const auto& block, const Element_kind& kind) {
    if (block.empty())
      return;
    out << kind.medit_keyword << '\n' << block.size() << '\n';
    for (std::size_t i = 0; i < block.size(); ++i) {
      for (std::uint32_t v : block.vertices[i])
        out << v + std::size_t(1) << ' ';
      out << block.label[i] << '\n';
    }
  });
  out << "End\n";
  out.flush();
  for (const Point_array& a : mesh.point_arrays)
    if (a.is_metric())
      write_medit_solution(file.companion(medit_solution_name(file.name())), a);
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_MEDIT_H
