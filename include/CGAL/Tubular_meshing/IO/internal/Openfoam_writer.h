// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_OPENFOAM_WRITER_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_OPENFOAM_WRITER_H

#include <CGAL/Tubular_meshing/IO/Output_folder.h>
#include <CGAL/Tubular_meshing/IO/internal/Face_mesh.h>
#include <CGAL/Tubular_meshing/IO/internal/Openfoam_files.h>
#include <CGAL/Tubular_meshing/IO/internal/Used_points.h>
#include <CGAL/Tubular_meshing/IO/internal/names_in_files.h>
#include <CGAL/Tubular_meshing/IO/internal/openfoam_patches.h>
#include <CGAL/Tubular_meshing/IO/internal/refuse.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <string>

namespace CGAL::Tubular_meshing::IO::internal {

/* Writes the files of a polyMesh. Faces are numbered as they are written: those between cells first, in upper triangular
 * order, then those of each patch. */
class Openfoam_writer {
public:
  Openfoam_writer(Output_folder& folder, const Face_mesh& faces, bool binary,
                  const std::string& location = openfoam_location)
      : faces_(faces)
      , mesh_(faces.cells().mesh())
      , points_(mesh_, &any_region)
      , files_(folder, binary, note(), location) {
    if (binary && faces_.number_of_faces() > std::size_t((std::numeric_limits<std::int32_t>::max)()) / 4)
      refuse(folder.name(), "its faces have more corners than labels of 32 bits count",
             "write it as text, in the format openfoam");
  }

  void write() {
    files_.write_points(points_.size(), [&](const auto& put) {
      for (std::size_t i = 0; i < mesh_.points.size(); ++i)
        if (points_.contain(i))
          put(mesh_.points[i]);
    });
    files_.write_faces(faces_.number_of_faces(), [&](const auto& put) {
      const auto put_numbered = [&](Face f) {
        for (std::size_t k = 0; k < number_of_corners(f); ++k)
          f[k] = points_.number(f[k]);
        put(f);
      };
      faces_.for_each_inner_face([&](const Face_mesh::Inner_face& f) { put_numbered(faces_.corners(f)); });
      faces_.for_each_outer_face([&](const Side& side) { put_numbered(faces_.corners(side)); });
    });
    files_.write_labels(
        "owner", faces_.number_of_faces(),
        [&](const auto& put) {
          faces_.for_each_inner_face([&](const Face_mesh::Inner_face& f) { put(f.owner.cell); });
          faces_.for_each_outer_face([&](const Side& side) { put(side.cell); });
        },
        true);
    files_.write_labels(
        "neighbour", faces_.number_of_inner_faces(),
        [&](const auto& put) { faces_.for_each_inner_face([&](const Face_mesh::Inner_face& f) { put(f.neighbour); }); },
        true);
    files_.write_boundary(openfoam_patches(faces_), faces_.number_of_inner_faces());
    if (has_openfoam_cell_zones(mesh_))
      files_.write_cell_zones(region_names_in_file(mesh_, Mesh_format::openfoam), faces_.cells().size(),
                              [&](std::size_t c) { return faces_.cells().region(c); });
    write_face_zones();
  }

private:
  typedef Face_mesh::Side Side;

  std::string note() const {
    return "nPoints:" + std::to_string(points_.size()) + "  nCells:" + std::to_string(faces_.cells().size()) +
           "  nFaces:" + std::to_string(faces_.number_of_faces()) +
           "  nInternalFaces:" + std::to_string(faces_.number_of_inner_faces());
  }

  void write_face_zones() {
    if (faces_.number_of_inner_facets() == 0)
      return;
    std::map<int, Openfoam_face_zone> zones;
    for_each_face_in_zone(faces_, [&](std::size_t number, int label, bool flipped) {
      zones[label].faces.push_back(number);
      zones[label].flipped.push_back(flipped);
    });
    files_.write_face_zones(patch_names_in_file(mesh_, Mesh_format::openfoam), zones);
  }

  const Face_mesh& faces_;
  const Mixed_mesh& mesh_;
  const Used_points points_;
  Openfoam_files files_;
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_OPENFOAM_WRITER_H
