// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_PVTU_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_PVTU_H

#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/IO/Output_folder.h>
#include <CGAL/Tubular_meshing/IO/internal/Mesh_parts.h>
#include <CGAL/Tubular_meshing/IO/internal/Vtk_xml_writer.h>
#include <CGAL/Tubular_meshing/IO/internal/write_vtu.h>

#include <cstddef>
#include <filesystem>
#include <string>

namespace CGAL::Tubular_meshing::IO::internal {

// The folder of the parts' files, beside the .pvtu file: mesh_parts/mesh_0.vtu, …
inline std::filesystem::path folder_of_parts(const std::string& pvtu) {
  const std::filesystem::path file(pvtu);
  return file.parent_path() / (file.stem().string() + "_parts");
}

inline std::string file_of_part(const std::string& pvtu, std::size_t part) {
  return std::filesystem::path(pvtu).stem().string() + "_" + std::to_string(part) + ".vtu";
}

// Files named as those of parts.
inline bool belongs_to_pvtu(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  const std::size_t digits = stem.find_last_not_of("0123456789");
  return file.extension() == ".vtu" && !file.has_parent_path() && digits != std::string::npos &&
         digits + 1 < stem.size() && stem[digits] == '_';
}

// What the arrays of the parts are: a reader learns it before it opens any of them.
inline std::string pvtu_text(const std::string& file, const Mesh_nodes& nodes, std::size_t parts) {
  const Mixed_mesh& mesh = nodes.mesh();
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" byte_order=\"" +
                     std::string(host_is_little_endian() ? "LittleEndian" : "BigEndian") +
                     "\" header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n"
                     "<PUnstructuredGrid GhostLevel=\"1\">\n";
  const auto array = [&](const char* type, const std::string& name, int components) {
    text += "<PDataArray type=\"" + std::string(type) + "\" Name=\"" + escaped_for_xml(name) + "\"" +
            (components > 1 ? " NumberOfComponents=\"" + std::to_string(components) + "\"" : std::string()) + "/>\n";
  };
  const auto names = name_fields(mesh.patch_names, mesh.region_names);
  if (!names.empty()) {
    text += "<FieldData>\n";
    for (const auto& n : names) {
      text += "<DataArray type=\"Int32\" Name=\"" + escaped_for_xml(n.first) + "\" NumberOfTuples=\"" +
              std::to_string(n.second.size()) + "\" format=\"ascii\">";
      for (std::int32_t i : n.second)
        text += std::to_string(i) + " ";
      text += "</DataArray>\n";
    }
    text += "</FieldData>\n";
  }
  text += "<PPointData" + global_ids(global_point_ids_name) + ">\n";
  for (const Point_array& a : mesh.point_arrays)
    array("Float64", a.name, a.components);
  array("Int64", global_point_ids_name, 1);
  array("UInt8", vtk_ghost_array_name, 1);
  text += "</PPointData>\n<PCellData" + global_ids(global_cell_ids_name) + ">\n";
  array("Int32", "region", 1);
  array("Int32", "patch", 1);
  if (!mesh.patch_ids.empty())
    array("Int32", mesh.patch_ids.array, 1);
  for (const Cell_array& a : nodes.cell_arrays())
    array("Float64", a.name, a.components);
  array("Int64", global_cell_ids_name, 1);
  array("UInt8", vtk_ghost_array_name, 1);
  text += "</PCellData>\n<PPoints>\n";
  array("Float64", "Points", 3);
  text += "</PPoints>\n";
  const std::string folder = folder_of_parts(file).filename().string();
  for (std::size_t p = 0; p < parts; ++p)
    text += "<Piece Source=\"" + escaped_for_xml(folder + "/" + file_of_part(file, p)) + "\"/>\n";
  return text + "</PUnstructuredGrid>\n</VTKFile>\n";
}

inline void write_pvtu(Output_file& file, Output_folder& folder, const Mesh_nodes& nodes,
                       const Cell_partition& partition) {
  Mesh_parts parts(nodes, partition, file.name());
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const Mesh_parts::Part part = parts[p];
    write_vtu(folder.file(file_of_part(file.name(), p)), Mesh_nodes(part.mesh, &part.cell_arrays), &part.ids);
  }
  file.write(pvtu_text(file.name(), nodes, parts.size()));
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_PVTU_H
