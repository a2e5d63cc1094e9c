// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_NAMES_IN_FILES_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_NAMES_IN_FILES_H

#include <CGAL/Tubular_meshing/IO/Mesh_format.h>
#include <CGAL/Tubular_meshing/IO/internal/distinct_names.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>

namespace CGAL::Tubular_meshing::IO::internal {

/* Letters, digits, and _ - . : + are what programs take in a word; so are the letters of other alphabets, in UTF-8. A
 * blank or another sign becomes an underscore; a letter or an underscore comes first. */
inline std::string as_word(const std::string& name) {
  std::string word;
  for (char c : name) {
    const bool stays = std::isalnum(static_cast<unsigned char>(c)) || (static_cast<unsigned char>(c) & 0x80) != 0 ||
                       std::string("_-.:+").find(c) != std::string::npos;
    word += stays ? c : '_';
  }
  const bool begins_well = !word.empty() && (std::isalpha(static_cast<unsigned char>(word[0])) || word[0] == '_' ||
                                             (static_cast<unsigned char>(word[0]) & 0x80) != 0);
  return begins_well ? word : "_" + word;
}

// The name of a file, of no more bytes than file systems take, with room for a number and an extension.
inline std::string as_file_name(const std::string& name) {
  std::string result = shortened(as_word(name), 200);
  std::replace(result.begin(), result.end(), ':', '_');
  return result;
}

inline std::string as_fluent_name(const std::string& name) {
  std::string result;
  for (char c : name) {
    const auto u = static_cast<unsigned char>(c);
    result += u < 128 && std::isalnum(u)                          ? static_cast<char>(std::tolower(u))
              : std::string("-_.:+").find(c) != std::string::npos ? c
                                                                  : '-';
  }
  return !result.empty() && std::isalpha(static_cast<unsigned char>(result[0])) ? result : "z-" + result;
}

// Up to 32 bytes, with room for a number.
inline std::string as_cgns_name(const std::string& name) {
  std::string result = shortened(name, 28);
  std::replace(result.begin(), result.end(), '/', '_');
  return result.empty() || result == "." || result == ".." ? "_" : result;
}

// Letters, digits and underscores, a letter first, are what all programs take that read input decks.
inline std::string as_abaqus_name(std::string name) {
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)))
      c = '_';
  if (name.empty() || !std::isalpha(static_cast<unsigned char>(name[0])))
    name.insert(0, "n");
  return name.substr(0, 80);
}

inline std::string spelled(const std::string& name, Mesh_format format) {
  if (is_openfoam(format))
    return as_word(name);
  switch (format) {
  case Mesh_format::su2:
    return as_word(name);
  case Mesh_format::svmultiphysics:
    return as_file_name(name);
  case Mesh_format::fluent:
    return as_fluent_name(name);
  case Mesh_format::cgns:
    return as_cgns_name(name);
  case Mesh_format::exodus:
    return shortened(name, 200);
  case Mesh_format::abaqus:
    return as_abaqus_name(name);
  default:
    return name;
  }
}

inline Label_names patch_names_in_file(const Mixed_mesh& mesh, Mesh_format format) {
  std::set<std::string> used;
  if (is_openfoam(format))
    used.insert("defaultFaces"); // where all goes that has no patch
  return distinct_patch_names(
      mesh, [&](const std::string& name) { return spelled(name, format); }, used);
}

// Where zones or sections of both have names of their own, a region gives way to a patch of its name.
inline Label_names region_names_in_file(const Mixed_mesh& mesh, Mesh_format format) {
  Label_names names = distinct_region_names(mesh, [&](const std::string& name) { return spelled(name, format); });
  if (format != Mesh_format::fluent && format != Mesh_format::cgns)
    return names;
  std::set<std::string> used;
  for (const auto& n : patch_names_in_file(mesh, format))
    used.insert(n.second);
  for (auto& n : names) {
    if (used.count(n.second) != 0)
      n.second =
          unused_name(format == Mesh_format::fluent ? n.second + "-cells" : shortened(n.second, 22) + "_cells", used);
    used.insert(n.second);
  }
  return names;
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_NAMES_IN_FILES_H
