// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_OPENFOAM_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_OPENFOAM_IMPL_H

#include <CGAL/Tubular_meshing/IO/internal/Face_mesh.h>
#include <CGAL/Tubular_meshing/IO/internal/Openfoam_writer.h>
#include <CGAL/Tubular_meshing/IO/internal/check_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_openfoam.h>

#include <filesystem>
#include <string>

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

} // namespace CGAL::Tubular_meshing::IO

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_OPENFOAM_IMPL_H
