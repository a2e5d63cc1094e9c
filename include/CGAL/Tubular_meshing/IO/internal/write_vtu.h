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

// Arrays of all cells and facets, made as they are written: together they would be larger than the mesh.
class Vtu_cells_writer {
public:
  Vtu_cells_writer(const Mesh_nodes& nodes, Vtk_xml_writer& out)
      : nodes_(nodes)
      , mesh_(nodes.mesh())
      , out_(out)
      , number_(mesh_.number_of_cells() + mesh_.number_of_facets()) {}

  void write(const Vtu_part* part) {
    out_.begin("CellData" + (part ? global_ids(global_cell_ids_name) : std::string()));
    write_labels("region", 3, [](int label) { return label; });
    write_labels("patch", 2, [](int label) { return label; });
    if (!mesh_.patch_ids.empty())
      write_labels(mesh_.patch_ids.array, 2, [&](int label) { return id_of(label, mesh_.patch_ids); });
    for (const Cell_array& a : nodes_.cell_arrays())
      write_array(a);
    if (part) {
      out_.array(global_cell_ids_name, 1, part->cell_ids);
      out_.array(vtk_ghost_array_name, 1, part->cell_ghosts);
    }
    out_.end("CellData");
    out_.begin("Cells");
    write_connectivity();
    write_offsets();
    write_types();
    out_.end("Cells");
  }

private:
  // value(label) of elements of this dimension, value(0) of others
  template <class Value> void write_labels(const std::string& name, int dimension, const Value& value) {
    out_.array_made<std::int32_t>(name, 1, number_, [&](const auto& put) {
      for_each_block(mesh_, [&](const auto& block, const Element_kind& kind) {
        for (int label : block.label)
          put(value(kind.dimension == dimension ? label : 0));
      });
    });
  }

  // 0 of facets
  void write_array(const Cell_array& a) {
    out_.array_made<double>(a.name, std::size_t(a.components), std::size_t(a.components) * number_,
                            [&](const auto& put) {
                              for (double x : a.values)
                                put(x);
                              for (std::size_t i = std::size_t(a.components) * mesh_.number_of_facets(); i > 0; --i)
                                put(0);
                            });
  }

  std::size_t nodes_of(const Element_kind& kind) const { return nodes_.number(std::size_t(&kind - element_kinds)); }

  void write_connectivity() {
    std::size_t all = 0;
    for_each_block(mesh_, [&](const auto& block, const Element_kind& kind) { all += block.size() * nodes_of(kind); });
    out_.array_made<std::int64_t>("connectivity", 1, all, [&](const auto& put) {
      for_each_block(mesh_, [&](const auto& block, const Element_kind& kind) {
        for (std::size_t i = 0; i < block.size(); ++i) {
          const Element_nodes n = nodes_.of(std::size_t(&kind - element_kinds), block.vertices[i].data(), i, vtk_order);
          for (std::size_t k = 0; k < n.size; ++k)
            put(std::int64_t(n[nodes_.is_quadratic() ? k : vtk_corner(kind, k)]));
        }
      });
    });
  }

  void write_offsets() {
    out_.array_made<std::int64_t>("offsets", 1, number_, [&](const auto& put) {
      std::int64_t end = 0;
      for_each_block(mesh_, [&](const auto& block, const Element_kind& kind) {
        for (std::size_t i = 0; i < block.size(); ++i)
          put(end += std::int64_t(nodes_of(kind)));
      });
    });
  }

  void write_types() {
    out_.array_made<std::uint8_t>("types", 1, number_, [&](const auto& put) {
      for_each_block(mesh_, [&](const auto& block, const Element_kind& kind) {
        const auto type = std::uint8_t(vtk_type_of(nodes_, std::size_t(&kind - element_kinds)));
        for (std::size_t i = 0; i < block.size(); ++i)
          put(type);
      });
    });
  }

  const Mesh_nodes& nodes_;
  const Mixed_mesh& mesh_;
  Vtk_xml_writer& out_;
  const std::size_t number_;
};

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
  out.array_made<double>("Points", 3, 3 * nodes.size(), [&](const auto& put) {
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (int k = 0; k < 3; ++k)
        put(nodes.point(i)[k]);
  });
  out.end("Points");
  Vtu_cells_writer(nodes, out).write(part);
  out.end("Piece");
  out.write(file);
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_VTU_H
