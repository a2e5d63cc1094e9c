// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_PARTITIONED_MESH_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_PARTITIONED_MESH_IMPL_H

#include <CGAL/Tubular_meshing/IO/Output_folder.h>
#include <CGAL/Tubular_meshing/IO/internal/Face_mesh.h>
#include <CGAL/Tubular_meshing/IO/internal/Openfoam_processors.h>
#include <CGAL/Tubular_meshing/IO/internal/Openfoam_writer.h>
#include <CGAL/Tubular_meshing/IO/internal/Output_set.h>
#include <CGAL/Tubular_meshing/IO/internal/Partitioned_msh_writer.h>
#include <CGAL/Tubular_meshing/IO/internal/check_mesh.h>
#include <CGAL/Tubular_meshing/IO/internal/openfoam_processor_folders.h>
#include <CGAL/Tubular_meshing/IO/internal/refuse.h>
#include <CGAL/Tubular_meshing/IO/internal/write_nodes.h>
#include <CGAL/Tubular_meshing/IO/internal/write_pvtu.h>
#include <CGAL/Tubular_meshing/IO/write_openfoam.h>
#include <CGAL/Tubular_meshing/IO/write_partitioned_mesh.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::IO {

namespace internal {

inline Mesh_format format_with_parts(const std::string& file, Mesh_format format) {
  if (format == Mesh_format::by_name)
    format = mesh_format_of(file);
  if (!has_parts(format))
    throw Output_error("The file " + quoted(file) +
                       " cannot be written in parts: give it the extension .pvtu or .msh, or the format openfoam.");
  return format;
}

// The .pvtu file, then the folder of the parts.
inline std::unique_ptr<Output> open_pvtu(const std::string& file) {
  auto set = std::make_unique<Output_set>(file);
  if (set->add(std::make_unique<Output_file>(file)).is_direct())
    refuse(file, "it is not a regular file, beside which a folder can be", write_vtu_instead);
  set->add(std::make_unique<Output_folder>(folder_of_parts(file).string(), &belongs_to_pvtu));
  return set;
}

// The mesh as a whole, then those of the processors.
inline std::unique_ptr<Output> open_openfoam_parts(const std::string& file, std::size_t parts) {
  std::unique_ptr<Output_folder> whole(new Output_folder(openfoam_folder(file)));
  const std::filesystem::path openfoam_case = openfoam_case_of(whole->name());
  check_openfoam_processor_folders(openfoam_case, parts);
  auto set = std::make_unique<Output_set>(whole->name());
  set->add(std::move(whole));
  for (std::size_t p = 0; p < parts; ++p) {
    const std::filesystem::path processor = openfoam_case / ("processor" + std::to_string(p));
    set->add(std::unique_ptr<Output_folder>(new Output_folder(openfoam_folder(processor.string()))));
  }
  return set;
}

inline void check_partition(const Mixed_mesh& mesh, const Cell_partition& partition, const std::string& file) {
  if (mesh.number_of_cells() == 0)
    refuse(file, "a mesh without cells has no parts", write_vtu_instead);
  bool is_one = partition.part.size() == mesh.number_of_cells();
  for (std::uint32_t p : partition.part)
    is_one = is_one && p < partition.number_of_parts;
  if (!is_one)
    throw Parameter_error("The partition is not one of the mesh: it does not have a part below " +
                          std::to_string(partition.number_of_parts) + " for each of the " +
                          std::to_string(mesh.number_of_cells()) + " cells.");
}

inline void write_openfoam_parts(Output_set& set, const Mixed_mesh& mesh, const Cell_partition& partition,
                                 bool binary) {
  const Face_mesh faces(mesh, set.name());
  Openfoam_writer(dynamic_cast<Output_folder&>(set[0]), faces, binary).write();
  const Openfoam_processors rules;
  const Openfoam_parts processors(faces, partition, rules, binary);
  for (std::size_t p = 0; p < partition.number_of_parts; ++p) {
    auto& folder = dynamic_cast<Output_folder&>(set[p + 1]);
    processors.write(folder, p);
    folder.finish(); // no file stays open: there may be more parts than those that a process may have
  }
}

// As many outputs as open_partitioned_mesh() opens for a format.
inline std::size_t size_of_set(Mesh_format format, std::size_t parts) {
  return format == Mesh_format::gmsh ? 0 : format == Mesh_format::pvtu ? 2 : parts + 1;
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE bool has_parts(Mesh_format format) {
  return format == Mesh_format::pvtu || format == Mesh_format::gmsh || format == Mesh_format::openfoam ||
         format == Mesh_format::openfoam_binary;
}

CGAL_TUBULAR_MESHING_INLINE std::unique_ptr<Output>
open_partitioned_mesh(const std::string& file, std::size_t number_of_parts, Mesh_format format) {
  switch (internal::format_with_parts(file, format)) {
  case Mesh_format::gmsh:
    return std::make_unique<Output_file>(file);
  case Mesh_format::pvtu:
    return internal::open_pvtu(file);
  default:
    return internal::open_openfoam_parts(file, number_of_parts);
  }
}

namespace internal {

CGAL_TUBULAR_MESHING_INLINE void write_parts(Output& output, const Mesh_nodes& nodes, const Cell_partition& partition,
                                             Mesh_format format) {
  check_mesh(nodes.mesh(), output.name());
  check_partition(nodes.mesh(), partition, output.name());
  format = format_with_parts(output.name(), format);
  auto* const set = dynamic_cast<Output_set*>(&output);
  auto* const file = dynamic_cast<Output_file*>(&output);
  if ((set == nullptr ? 0 : set->size()) != size_of_set(format, partition.number_of_parts) ||
      (set == nullptr && file == nullptr))
    throw Output_error(quoted(output.name()) + " was not opened for the format that is to be written.");
  if (format == Mesh_format::gmsh)
    return partition.number_of_parts == 1 ? Msh_writer(*file, nodes).write_4_1()
                                          : Partitioned_msh_writer(*file, nodes, partition).write();
  if (format == Mesh_format::pvtu)
    return write_pvtu(dynamic_cast<Output_file&>((*set)[0]), dynamic_cast<Output_folder&>((*set)[1]), nodes, partition);
  write_openfoam_parts(*set, nodes.mesh(), partition, format == Mesh_format::openfoam_binary);
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE void write_partitioned_mesh(Output& output, const Mixed_mesh& mesh,
                                                        const Cell_partition& partition, Mesh_format format) {
  internal::write_parts(output, mesh, partition, format);
}

CGAL_TUBULAR_MESHING_INLINE void write_partitioned_mesh(Output& output, const Mixed_mesh& mesh,
                                                        const Cell_partition& partition,
                                                        const std::vector<Cell_array>& cell_arrays,
                                                        Mesh_format format) {
  internal::check_arrays(cell_arrays, mesh, internal::format_with_parts(output.name(), format), output.name());
  internal::write_parts(output, internal::Mesh_nodes(mesh, &cell_arrays), partition, format);
}

CGAL_TUBULAR_MESHING_INLINE void write_partitioned_mesh(const std::string& file, const Mixed_mesh& mesh,
                                                        const Cell_partition& partition, Mesh_format format) {
  const std::unique_ptr<Output> out = open_partitioned_mesh(file, partition.number_of_parts, format);
  write_partitioned_mesh(*out, mesh, partition, format);
  out->commit();
}

} // namespace CGAL::Tubular_meshing::IO

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_PARTITIONED_MESH_IMPL_H
