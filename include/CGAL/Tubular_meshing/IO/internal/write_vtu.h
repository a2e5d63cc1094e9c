// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_VTU_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_VTU_H

#include <CGAL/Tubular_meshing/IO/internal/Mesh_nodes.h>
#include <CGAL/Tubular_meshing/IO/internal/Vtk_xml_writer.h>
#include <CGAL/Tubular_meshing/IO/internal/element_kinds.h>
#include <CGAL/Tubular_meshing/IO/internal/name_fields.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

// What a file says of a part of a mesh, of its points and its cells (facets are VTK's cells, too): where each is in the
// whole mesh, and whether it belongs to another part.
struct Vtu_part {
  std::vector<std::int64_t> point_ids, cell_ids;
  std::vector<std::uint8_t> point_ghosts, cell_ghosts; // 1: of another part, as VTK counts
};

constexpr const char* vtk_ghost_array_name = "vtkGhostType";
constexpr const char* global_point_ids_name = "GlobalPointIds";
constexpr const char* global_cell_ids_name = "GlobalCellIds";

inline void write_names(const Mixed_mesh& mesh, Vtk_xml_writer& out) {
  const auto pairs = name_fields(mesh.patch_names, mesh.region_names);
  if (pairs.empty())
    return;
  out.begin("FieldData");
  for (const auto& p : pairs)
    out.array(p.first, 0, p.second);
  out.end("FieldData");
}

inline std::string global_ids(const char* array) {
  return " GlobalIds=\"" + std::string(array) + "\"";
}

inline int vtk_type_of(const Mesh_nodes& nodes, std::size_t kind) {
  const Quadratic_kind& q = quadratic_kinds[kind];
  return nodes.is_complete() ? q.complete_vtk_type : nodes.is_quadratic() ? q.vtk_type : element_kinds[kind].vtk_type;
}

inline void write_cells(const Mesh_nodes& nodes, const Vtu_part* part, Vtk_xml_writer& out) {
  const Mixed_mesh& mesh = nodes.mesh();
  std::vector<std::int32_t> regions, patches;
  std::vector<std::int64_t> connectivity, offsets;
  std::vector<std::uint8_t> types;
  for_each_block(mesh, [&](const auto& block, const Element_kind& kind) {
    const std::size_t number = std::size_t(&kind - element_kinds);
    const int type = vtk_type_of(nodes, number);
    for (std::size_t i = 0; i < block.size(); ++i) {
      const Element_nodes n = nodes.of(number, block.vertices[i].data(), i, vtk_order);
      for (std::size_t k = 0; k < n.size; ++k)
        connectivity.push_back(n[nodes.is_quadratic() ? k : vtk_corner(kind, k)]);
      offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
      types.push_back(static_cast<std::uint8_t>(type));
      regions.push_back(kind.dimension == 3 ? block.label[i] : 0);
      patches.push_back(kind.dimension == 2 ? block.label[i] : 0);
    }
  });
  out.begin("CellData" + (part ? global_ids(global_cell_ids_name) : std::string()));
  out.array("region", 1, regions);
  out.array("patch", 1, patches);
  if (!mesh.patch_ids.empty())
    out.array(mesh.patch_ids.array, 1, ids_of(patches, mesh.patch_ids));
  for (const Cell_array& a : nodes.cell_arrays()) {
    std::vector<double> values = a.values;
    values.resize(std::size_t(a.components) * offsets.size(), 0); // of facets
    out.array(a.name, std::size_t(a.components), values);
  }
  if (part) {
    out.array(global_cell_ids_name, 1, part->cell_ids);
    out.array(vtk_ghost_array_name, 1, part->cell_ghosts);
  }
  out.end("CellData");
  out.begin("Cells");
  out.array("connectivity", 1, connectivity);
  out.array("offsets", 1, offsets);
  out.array("types", 1, types);
  out.end("Cells");
}

inline void write_vtu(Output_file& file, const Mesh_nodes& nodes, const Vtu_part* part = nullptr) {
  const Mixed_mesh& mesh = nodes.mesh();
  Vtk_xml_writer out("UnstructuredGrid");
  write_names(mesh, out);
  out.begin("Piece NumberOfPoints=\"" + std::to_string(nodes.size()) + "\" NumberOfCells=\"" +
            std::to_string(mesh.number_of_cells() + mesh.number_of_facets()) + "\"");
  out.begin("PointData" + (part ? global_ids(global_point_ids_name) : std::string()));
  for (const Point_array& a : mesh.point_arrays)
    out.array(a.name, static_cast<std::size_t>(a.components), nodes.values(a));
  if (part) {
    out.array(global_point_ids_name, 1, part->point_ids);
    out.array(vtk_ghost_array_name, 1, part->point_ghosts);
  }
  out.end("PointData");
  out.begin("Points");
  std::size_t point = 0;
  int k = 0;
  out.array_of<double>("Points", 3, 3 * nodes.size(), [&] {
    const double x = nodes.point(point)[k];
    if (++k == 3) {
      k = 0;
      ++point;
    }
    return x;
  });
  out.end("Points");
  write_cells(nodes, part, out);
  out.end("Piece");
  out.write(file);
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_VTU_H
