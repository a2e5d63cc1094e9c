// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_OPENFOAM_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_OPENFOAM_IMPL_H

#include <CGAL/Tubular_meshing/IO/internal/Face_mesh.h>
#include <CGAL/Tubular_meshing/IO/internal/Openfoam_parts.h>
#include <CGAL/Tubular_meshing/IO/internal/Openfoam_regions.h>
#include <CGAL/Tubular_meshing/IO/internal/Openfoam_writer.h>
#include <CGAL/Tubular_meshing/IO/internal/Output_set.h>
#include <CGAL/Tubular_meshing/IO/internal/check_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_openfoam.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

namespace CGAL::Tubular_meshing::IO {

namespace internal {

// What programs that come with OpenFOAM leave in a polyMesh.
inline bool belongs_to_openfoam(const std::filesystem::path& file) {
  const std::string first = file.begin()->string(), stem = std::filesystem::path(first).stem().string();
  for (const char* name :
       {"points", "faces", "owner", "neighbour", "boundary", "cellZones", "faceZones", "pointZones", "sets",
        "pointProcAddressing", "faceProcAddressing", "cellProcAddressing", "boundaryProcAddressing", "meshModifiers",
        "cellLevel", "pointLevel", "level0Edge", "refinementHistory", "surfaceIndex"})
    if (first == name || (stem == name && first == stem + ".gz"))
      return true;
  return false;
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Output_folder openfoam_folder(const std::string& folder) {
  std::filesystem::path path = std::filesystem::path(folder).lexically_normal();
  if (path.filename().empty())
    path = path.parent_path();
  if (path.filename() != "polyMesh")
    path = path / "constant" / "polyMesh";
  return Output_folder(path.string(), &internal::belongs_to_openfoam);
}

CGAL_TUBULAR_MESHING_INLINE void write_openfoam(Output_folder& folder, const Mixed_mesh& mesh, bool binary) {
  internal::check_mesh(mesh, folder.name());
  const internal::Face_mesh faces(mesh, folder.name());
  internal::Openfoam_writer(folder, faces, binary).write();
}

CGAL_TUBULAR_MESHING_INLINE void write_openfoam(const std::string& folder, const Mixed_mesh& mesh, bool binary) {
  Output_folder out = openfoam_folder(folder);
  write_openfoam(out, mesh, binary);
  out.commit();
}

namespace internal {

inline std::string region_properties(const Openfoam_regions& regions) {
  std::string fluids, solids;
  for (std::size_t r = 0; r < regions.size(); ++r)
    (regions.label(r) == labels::lumen ? fluids : solids) += ' ' + regions.name(r);
  return "FoamFile\n{\n    version     2.0;\n    format      ascii;\n    class       dictionary;\n"
         "    location    \"constant\";\n    object      regionProperties;\n}\n\nregions\n(\n    fluid (" +
         fluids + " )\n    solid (" + solids + " )\n);\n";
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE std::unique_ptr<Output> open_openfoam_regions(const std::string& folder) {
  // which regions there are is not known yet; that of the lumen tells whether they can be written, and goes again
  openfoam_folder((std::filesystem::path(folder) / "constant" / "fluid" / "polyMesh").string());
  return std::make_unique<internal::Output_set>(folder);
}

CGAL_TUBULAR_MESHING_INLINE void write_openfoam_regions(Output& output, const Mixed_mesh& mesh, bool binary) {
  auto* const set = dynamic_cast<internal::Output_set*>(&output);
  if (set == nullptr || set->size() > 0)
    throw Output_error(internal::quoted(output.name()) + " was not opened for the format that is to be written.");
  internal::check_mesh(mesh, output.name());
  const internal::Face_mesh faces(mesh, output.name());
  const internal::Openfoam_regions regions(mesh);
  const std::filesystem::path openfoam_case(output.name());
  const auto folder_of = [&](std::size_t region) -> Output_folder& {
    const std::string folder = (openfoam_case / regions.location(region)).string();
    return set->add(std::unique_ptr<Output_folder>(new Output_folder(openfoam_folder(folder))));
  };
  if (regions.size() == 1) { // it is the whole
    internal::Openfoam_writer(folder_of(0), faces, binary, regions.location(0)).write();
  } else {
    const Cell_partition partition = regions.partition(faces.cells());
    const internal::Openfoam_parts parts(faces, partition, regions, binary);
    for (std::size_t r = 0; r < regions.size(); ++r) {
      Output_folder& folder = folder_of(r);
      parts.write(folder, r);
      folder.finish();
    }
  }
  const std::filesystem::path properties = openfoam_case / "constant" / "regionProperties";
  std::error_code error;
  if (!std::filesystem::exists(properties, error))
    set->add(std::make_unique<Output_file>(properties.string())).write(internal::region_properties(regions));
}

CGAL_TUBULAR_MESHING_INLINE void write_openfoam_regions(const std::string& folder, const Mixed_mesh& mesh,
                                                        bool binary) {
  const std::unique_ptr<Output> out = open_openfoam_regions(folder);
  write_openfoam_regions(*out, mesh, binary);
  out->commit();
}

} // namespace CGAL::Tubular_meshing::IO

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_OPENFOAM_IMPL_H
