// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_OPENFOAM_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_OPENFOAM_IMPL_H

#include <CGAL/Tubular_meshing/IO/internal/Byte_cursor.h>
#include <CGAL/Tubular_meshing/IO/internal/Face_mesh.h>
#include <CGAL/Tubular_meshing/IO/internal/Number_writer.h>
#include <CGAL/Tubular_meshing/IO/internal/Used_points.h>
#include <CGAL/Tubular_meshing/IO/internal/Wall_patches.h>
#include <CGAL/Tubular_meshing/IO/internal/check_mesh.h>
#include <CGAL/Tubular_meshing/IO/internal/names_in_files.h>
#include <CGAL/Tubular_meshing/IO/internal/refuse.h>
#include <CGAL/Tubular_meshing/IO/write_openfoam.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO {

namespace internal {

/* Writes the files of a polyMesh, one after the other. Faces are numbered as they are written: those between cells
 * first, in upper triangular order, then those of each patch. */
class Openfoam_writer {
public:
  Openfoam_writer(Output_folder& folder, const Mixed_mesh& mesh, bool binary)
      : folder_(folder)
      , mesh_(mesh)
      , faces_(mesh, folder.name())
      , points_(mesh, &any_region)
      , binary_(binary) {}

  void write() {
    if (binary_ && faces_.number_of_faces() > std::size_t((std::numeric_limits<std::int32_t>::max)()) / 4)
      refuse(folder_.name(), "its faces have more corners than labels of 32 bits count",
             "write it as text, in the format openfoam");
    write_points();
    write_faces();
    write_labels(
        "owner", faces_.number_of_faces(), [&](const Face_mesh::Inner_face& f) { return f.owner.cell; }, true);
    write_labels(
        "neighbour", faces_.number_of_inner_faces(), [&](const Face_mesh::Inner_face& f) { return f.neighbour; },
        false);
    write_boundary();
    write_cell_zones();
    write_face_zones();
  }

private:
  typedef Face_mesh::Side Side;

  Number_writer begin(const std::string& object, const std::string& kind, bool binary, bool with_note = false) {
    Number_writer out(folder_.file(object));
    out << "FoamFile\n{\n    version     2.0;\n    format      " << (binary ? "binary" : "ascii") << ";\n";
    if (binary)
      out << "    arch        \"" << (host_is_little_endian() ? "LSB" : "MSB") << ";label=32;scalar=64\";\n";
    out << "    class       " << kind << ";\n";
    if (with_note)
      out << "    note        \"nPoints:" << points_.size() << "  nCells:" << faces_.cells().size()
          << "  nFaces:" << faces_.number_of_faces() << "  nInternalFaces:" << faces_.number_of_inner_faces()
          << "\";\n";
    out << "    location    \"constant/polyMesh\";\n    object      " << object << ";\n}\n\n";
    return out;
  }

  void write_label(Number_writer& out, std::uint32_t label) const {
    if (binary_)
      out.bytes(std::int32_t(label));
    else
      out << label << '\n';
  }

  void write_points() {
    Number_writer out = begin("points", "vectorField", binary_);
    out << points_.size() << (binary_ ? "\n(" : "\n(\n");
    for (std::size_t i = 0; i < mesh_.points.size(); ++i) {
      if (!points_.contain(i))
        continue;
      const Point_3& p = mesh_.points[i];
      if (binary_)
        out.bytes(double(p.x())).bytes(double(p.y())).bytes(double(p.z()));
      else
        out << '(' << p.x() << ' ' << p.y() << ' ' << p.z() << ")\n";
    }
    out << ")\n";
    out.flush();
  }

  // Calls f(corners) for all faces, in the order of the file.
  template <class F> void for_each_face(F f) const {
    faces_.for_each_inner_face([&](const Face_mesh::Inner_face& face) { f(faces_.corners(face)); });
    for_each_outer_face([&](const Side& side) { f(faces_.corners(side)); });
  }
  template <class F> void for_each_outer_face(F f) const {
    for (const auto& p : faces_.patches())
      for (const Side& side : p.second)
        f(side);
    for (const Side& side : faces_.faces_without_patch())
      f(side);
  }

  void write_faces() {
    Number_writer out = begin("faces", binary_ ? "faceCompactList" : "faceList", binary_);
    if (binary_) {
      write_compact_faces(out);
    } else {
      out << faces_.number_of_faces() << "\n(\n";
      for_each_face([&](const Face& f) {
        const std::size_t n = number_of_corners(f);
        out << (n == 3 ? "3(" : "4(");
        for (std::size_t k = 0; k < n; ++k)
          out << points_.number(f[k]) << (k + 1 == n ? ")\n" : " ");
      });
      out << ")\n";
    }
    out.flush();
  }

  // As one list of where each face begins, and one of all corners.
  void write_compact_faces(Number_writer& out) const {
    std::int32_t corners = 0;
    out << faces_.number_of_faces() + 1 << "\n(";
    out.bytes(corners);
    for_each_face([&](const Face& f) { out.bytes(corners += std::int32_t(number_of_corners(f))); });
    out << ")\n\n" << corners << "\n(";
    for_each_face([&](const Face& f) {
      for (std::size_t k = 0; k < number_of_corners(f); ++k)
        out.bytes(std::int32_t(points_.number(f[k])));
    });
    out << ")\n";
  }

  template <class Of_inner_face>
  void write_labels(const std::string& object, std::size_t number, const Of_inner_face& of_inner, bool outer_too) {
    Number_writer out = begin(object, "labelList", binary_, true);
    out << number << (binary_ ? "\n(" : "\n(\n");
    faces_.for_each_inner_face([&](const Face_mesh::Inner_face& f) { write_label(out, of_inner(f)); });
    if (outer_too)
      for_each_outer_face([&](const Side& side) { write_label(out, side.cell); });
    out << ")\n";
    out.flush();
  }

  void write_boundary() {
    const Label_names names = patch_names_in_file(mesh_, Mesh_format::openfoam);
    const Wall_patches walls(faces_.cells(), faces_.facets());
    Number_writer out = begin("boundary", "polyBoundaryMesh", false);
    const std::size_t rest = faces_.faces_without_patch().size();
    out << faces_.patches().size() + (rest > 0 ? 1 : 0) << "\n(\n";
    std::size_t first = faces_.number_of_inner_faces();
    const auto write_patch = [&](const std::string& name, bool is_wall, std::size_t faces) {
      out << "    " << name << "\n    {\n        type            " << (is_wall ? "wall" : "patch") << ";\n";
      if (is_wall)
        out << "        inGroups        1(wall);\n";
      out << "        nFaces          " << faces << ";\n        startFace       " << first << ";\n    }\n";
      first += faces;
    };
    for (const auto& p : faces_.patches())
      write_patch(names.at(p.first), walls.contain(p.first), p.second.size());
    if (rest > 0)
      write_patch("defaultFaces", false, rest);
    out << ")\n";
    out.flush();
  }

  // One region that is the lumen needs no name.
  void write_cell_zones() {
    if (labels_of(mesh_, 3) == std::set<int>{labels::lumen})
      return;
    std::map<int, std::size_t> sizes;
    for (std::size_t c = 0; c < faces_.cells().size(); ++c)
      ++sizes[faces_.cells().region(c)];
    const Label_names names = region_names_in_file(mesh_, Mesh_format::openfoam);
    Number_writer out = begin("cellZones", "regIOobject", false);
    out << sizes.size() << "\n(\n";
    for (const auto& s : sizes) {
      out << names.at(s.first) << "\n{\n    type cellZone;\n    cellLabels List<label>\n" << s.second << "\n(\n";
      for (std::size_t c = 0; c < faces_.cells().size(); ++c)
        if (faces_.cells().region(c) == s.first)
          out << c << '\n';
      out << ")\n;\n}\n";
    }
    out << ")\n";
    out.flush();
  }

  // A face is flipped where its owner lies on the other side than the lower region.
  void write_face_zones() {
    if (faces_.number_of_inner_facets() == 0)
      return;
    struct Zone {
      std::vector<std::size_t> faces;
      std::vector<bool> flipped;
    };
    std::map<int, Zone> zones;
    std::size_t number = 0;
    faces_.for_each_inner_face_and_facet([&](const Face_mesh::Inner_face& f, std::uint32_t facet) {
      if (facet != no_cell) {
        Zone& zone = zones[faces_.facets().label(facet)];
        zone.faces.push_back(number);
        zone.flipped.push_back(f.owner.cell != faces_.facets().sides(facet)[0].cell);
      }
      ++number;
    });
    const Label_names names = patch_names_in_file(mesh_, Mesh_format::openfoam);
    Number_writer out = begin("faceZones", "regIOobject", false);
    out << zones.size() << "\n(\n";
    for (const auto& z : zones) {
      const std::size_t n = z.second.faces.size();
      out << names.at(z.first) << "\n{\n    type faceZone;\n    faceLabels List<label>\n" << n << "\n(\n";
      for (std::size_t f : z.second.faces)
        out << f << '\n';
      out << ")\n;\n    flipMap List<bool>\n" << n << "\n(\n";
      for (bool flipped : z.second.flipped)
        out << (flipped ? "1\n" : "0\n");
      out << ")\n;\n}\n";
    }
    out << ")\n";
    out.flush();
  }

  Output_folder& folder_;
  const Mixed_mesh& mesh_;
  const Face_mesh faces_;
  const Used_points points_;
  const bool binary_;
};

// What programs that come with OpenFOAM leave in a polyMesh.
inline bool belongs_to_openfoam(const std::filesystem::path& file) {
  const std::string first = file.begin()->string(), stem = std::filesystem::path(first).stem().string();
  for (const char* name :
       {"points", "faces", "owner", "neighbour", "boundary", "cellZones", "faceZones", "pointZones", "sets",
        "meshModifiers", "cellLevel", "pointLevel", "level0Edge", "refinementHistory", "surfaceIndex"})
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
  internal::Openfoam_writer(folder, mesh, binary).write();
}

CGAL_TUBULAR_MESHING_INLINE void write_openfoam(const std::string& folder, const Mixed_mesh& mesh, bool binary) {
  Output_folder out = openfoam_folder(folder);
  write_openfoam(out, mesh, binary);
  out.commit();
}

} // namespace CGAL::Tubular_meshing::IO

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_OPENFOAM_IMPL_H
