// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_REGION_FOLDERS_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_REGION_FOLDERS_H

#include <CGAL/Tubular_meshing/IO/internal/distinct_names.h>
#include <CGAL/Tubular_meshing/IO/internal/names_in_files.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <set>
#include <string>

namespace CGAL::Tubular_meshing::IO::internal {

/* The folders of the regions that a mesh has cells of, for solvers that have one a region: `fluid` is the lumen, `solid`
 * the wall, others have their names. None is there twice or among those that are taken. */
inline Label_names region_folders(const Mixed_mesh& mesh, std::set<std::string> taken = {}) {
  taken.insert({"fluid", "solid"});
  Label_names folders;
  for (int region : labels_of(mesh, 3)) {
    if (region == labels::lumen || region == labels::wall_region) {
      folders[region] = region == labels::lumen ? "fluid" : "solid";
      continue;
    }
    const auto name = mesh.region_names.find(region);
    folders[region] = unused_name(
        as_file_name(name == mesh.region_names.end() ? "region_" + std::to_string(region) : name->second), taken);
    taken.insert(folders[region]);
  }
  return folders;
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_REGION_FOLDERS_H
