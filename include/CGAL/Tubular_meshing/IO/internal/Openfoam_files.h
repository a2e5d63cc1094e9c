// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_OPENFOAM_FILES_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_OPENFOAM_FILES_H

#include <CGAL/Tubular_meshing/IO/Output_folder.h>
#include <CGAL/Tubular_meshing/IO/internal/Byte_cursor.h>
#include <CGAL/Tubular_meshing/IO/internal/Cell_faces.h>
#include <CGAL/Tubular_meshing/IO/internal/Number_writer.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

struct Openfoam_patch {
  std::string name;
  std::string entries; // whole lines: its type, and what belongs to that
  std::size_t number_of_faces;
};

struct Openfoam_face_zone {
  std::vector<std::size_t> faces;
  std::vector<bool> flipped;
};

inline std::string openfoam_entry(const std::string& key, const std::string& value) {
  return "        " + key + std::string(key.size() < 15 ? 16 - key.size() : 1, ' ') + value + ";\n";
}

// Of the mesh of a case, as its files say it.
constexpr const char* openfoam_location = "constant/polyMesh";

/* Writes the files of a polyMesh, one after the other. What they list is given by functions that call another one for
 * each thing in the list, in its order, as often as they are called. */
class Openfoam_files {
public:
  // The note is what the files of faces' cells say of the mesh.
  Openfoam_files(Output_folder& folder, bool binary, const std::string& note,
                 const std::string& location = openfoam_location)
      : folder_(folder)
      , binary_(binary)
      , note_(note)
      , location_(location) {}

  template <class For_each_point> void write_points(std::size_t number, const For_each_point& for_each_point) {
    Number_writer out = begin("points", "vectorField", binary_);
    out << number << (binary_ ? "\n(" : "\n(\n");
    for_each_point([&](const Point_3& p) {
      if (binary_)
        out.bytes(double(p.x())).bytes(double(p.y())).bytes(double(p.z()));
      else
        out << '(' << p.x() << ' ' << p.y() << ' ' << p.z() << ")\n";
    });
    out << ")\n";
    out.flush();
  }

  template <class For_each_face> void write_faces(std::size_t number, const For_each_face& for_each_face) {
    Number_writer out = begin("faces", binary_ ? "faceCompactList" : "faceList", binary_);
    if (binary_) {
      write_compact_faces(out, number, for_each_face);
    } else {
      out << number << "\n(\n";
      for_each_face([&](const Face& f) {
        const std::size_t n = number_of_corners(f);
        out << (n == 3 ? "3(" : "4(");
        for (std::size_t k = 0; k < n; ++k)
          out << f[k] << (k + 1 == n ? ")\n" : " ");
      });
      out << ")\n";
    }
    out.flush();
  }

  // with_note: of owners and neighbours
  template <class For_each_label>
  void write_labels(const std::string& object, std::size_t number, const For_each_label& for_each_label,
                    bool with_note = false) {
    Number_writer out = begin(object, "labelList", binary_, with_note);
    out << number << (binary_ ? "\n(" : "\n(\n");
    for_each_label([&](std::int64_t label) {
      if (binary_)
        out.bytes(std::int32_t(label));
      else
        out << label << '\n';
    });
    out << ")\n";
    out.flush();
  }

  void write_boundary(const std::vector<Openfoam_patch>& patches, std::size_t first_face) {
    Number_writer out = begin("boundary", "polyBoundaryMesh", false);
    out << patches.size() << "\n(\n";
    for (const Openfoam_patch& p : patches) {
      out << "    " << p.name << "\n    {\n" << p.entries;
      out << "        nFaces          " << p.number_of_faces << ";\n        startFace       " << first_face
          << ";\n    }\n";
      first_face += p.number_of_faces;
    }
    out << ")\n";
    out.flush();
  }

  // A zone for each region that has a name; region(c) tells it of one of the cells.
  template <class Region> void write_cell_zones(const Label_names& names, std::size_t cells, const Region& region) {
    std::map<int, std::size_t> sizes;
    for (std::size_t c = 0; c < cells; ++c)
      ++sizes[region(c)];
    Number_writer out = begin("cellZones", "regIOobject", false);
    out << names.size() << "\n(\n";
    for (const auto& n : names) {
      out << n.second << "\n{\n    type cellZone;\n    cellLabels List<label>\n" << sizes[n.first] << "\n(\n";
      for (std::size_t c = 0; c < cells; ++c)
        if (region(c) == n.first)
          out << c << '\n';
      out << ")\n;\n}\n";
    }
    out << ")\n";
    out.flush();
  }

  void write_face_zones(const Label_names& names, const std::map<int, Openfoam_face_zone>& zones) {
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

private:
  Number_writer begin(const std::string& object, const std::string& kind, bool binary, bool with_note = false) {
    Number_writer out(folder_.file(object));
    out << "FoamFile\n{\n    version     2.0;\n    format      " << (binary ? "binary" : "ascii") << ";\n";
    if (binary)
      out << "    arch        \"" << (host_is_little_endian() ? "LSB" : "MSB") << ";label=32;scalar=64\";\n";
    out << "    class       " << kind << ";\n";
    if (with_note)
      out << "    note        \"" << note_ << "\";\n";
    out << "    location    \"" << location_ << "\";\n    object      " << object << ";\n}\n\n";
    return out;
  }

  // As one list of where each face begins, and one of all corners.
  template <class For_each_face>
  static void write_compact_faces(Number_writer& out, std::size_t number, const For_each_face& for_each_face) {
    std::int32_t corners = 0;
    out << number + 1 << "\n(";
    out.bytes(corners);
    for_each_face([&](const Face& f) { out.bytes(corners += std::int32_t(number_of_corners(f))); });
    out << ")\n\n" << corners << "\n(";
    for_each_face([&](const Face& f) {
      for (std::size_t k = 0; k < number_of_corners(f); ++k)
        out.bytes(std::int32_t(f[k]));
    });
    out << ")\n";
  }

  Output_folder& folder_;
  const bool binary_;
  const std::string note_, location_;
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_OPENFOAM_FILES_H
