// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_OPENFOAM_PROCESSOR_FOLDERS_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_OPENFOAM_PROCESSOR_FOLDERS_H

#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

// The folder of the case that a mesh belongs to, which has to be the case's constant/polyMesh.
inline std::filesystem::path openfoam_case_of(const std::filesystem::path& poly_mesh) {
  const std::filesystem::path constant = poly_mesh.parent_path();
  if (constant.filename() != "constant")
    throw Output_error("The folder \"" + poly_mesh.string() +
                       "\" cannot be written in parts: these go beside the folder constant of a case; name the case, "
                       "or its constant/polyMesh.");
  return constant.parent_path();
}

inline bool is_openfoam_processor_folder(const std::string& name, std::size_t& number) {
  const std::string begin = "processor";
  if (name.compare(0, begin.size(), begin) != 0 || name.size() == begin.size() || name.size() > begin.size() + 9 ||
      name.find_first_not_of("0123456789", begin.size()) != std::string::npos)
    return false;
  number = std::size_t(std::stoul(name.substr(begin.size())));
  return true;
}

// OpenFOAM takes all folders of processors for parts of one mesh.
inline void check_openfoam_processor_folders(const std::filesystem::path& openfoam_case, std::size_t parts) {
  namespace fs = std::filesystem;
  std::error_code error;
  std::vector<std::string> others;
  const fs::path folder = openfoam_case.empty() ? fs::path(".") : openfoam_case;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    std::size_t number = 0;
    const std::string name = it->path().filename().string();
    const bool is_of_all = name.compare(0, 10, "processors") == 0; // OpenFOAM's other way
    if (is_of_all || (is_openfoam_processor_folder(name, number) && number >= parts))
      others.push_back(name);
  }
  if (others.empty())
    return;
  throw Output_error("The mesh cannot be written in " + std::to_string(parts) + " part" + (parts > 1 ? "s" : "") +
                     ": the case has the folder \"" + (*std::min_element(others.begin(), others.end())) +
                     "\" of another division, which OpenFOAM would take for a part; remove it, and the others.");
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_OPENFOAM_PROCESSOR_FOLDERS_H
