// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_NAME_FIELDS_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_NAME_FIELDS_H

#include <CGAL/Tubular_meshing/base/labels.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

// Each name is a field array of pairs (label, dimension), as Gmsh's names are: dimension 3 for regions, 2 for patches.
// A region and a patch of the same name share the array, one pair after the other.
inline std::map<std::string, std::vector<std::int32_t>> name_fields(const Label_names& patches,
                                                                    const Label_names& regions) {
  std::map<std::string, std::vector<std::int32_t>> pairs;
  for (const auto& n : patches)
    pairs[n.second].insert(pairs[n.second].end(), {n.first, 2});
  for (const auto& n : regions)
    pairs[n.second].insert(pairs[n.second].end(), {n.first, 3});
  return pairs;
}

// What the patches were called by number; 0 for those that were not.
inline std::int32_t id_of(int patch, const Patch_ids& ids) {
  const auto id = ids.id.find(patch);
  return id == ids.id.end() ? 0 : id->second;
}
inline std::vector<std::int32_t> ids_of(const std::vector<std::int32_t>& patches, const Patch_ids& ids) {
  std::vector<std::int32_t> result;
  result.reserve(patches.size());
  for (std::int32_t p : patches)
    result.push_back(id_of(p, ids));
  return result;
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_NAME_FIELDS_H
