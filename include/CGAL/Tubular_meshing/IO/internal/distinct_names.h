// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_DISTINCT_NAMES_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_DISTINCT_NAMES_H

#include <CGAL/Tubular_meshing/IO/internal/element_kinds.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <cstddef>
#include <set>
#include <string>
#include <utility>

namespace CGAL::Tubular_meshing::IO::internal {

// The labels that occur on cells (dimension 3) or facets (2).
inline std::set<int> labels_of(const Mixed_mesh& mesh, int dimension) {
  std::set<int> labels;
  for_each_block(mesh, [&](const auto& block, const Element_kind& kind) {
    const int* last = nullptr; // most elements have the label of the one before
    if (kind.dimension == dimension)
      for (const int& l : block.label)
        if (last == nullptr || l != *last)
          labels.insert(*(last = &l));
  });
  return labels;
}

/* A name for each label, none twice: that of the mesh, else "patch_7" or "region_7", as the format can hold it. The
 * name of a later label gets a number where it is another's already. */
template <class Spelling>
Label_names distinct_names(const std::set<int>& labels, const Label_names& names, const std::string& prefix,
                           const Spelling& spelling, std::set<std::string> used = {}) {
  Label_names result;
  for (int l : labels) {
    const auto found = names.find(l);
    const std::string wanted =
        found == names.end() || found->second.empty()
            ? prefix + (l < 0 ? "minus_" + std::to_string(-static_cast<long>(l)) : std::to_string(l))
            : found->second;
    used.insert(result[l] = unused_name(spelling(wanted), used));
  }
  return result;
}

template <class Spelling>
Label_names distinct_patch_names(const Mixed_mesh& mesh, const Spelling& spelling, std::set<std::string> used = {}) {
  return distinct_names(labels_of(mesh, 2), mesh.patch_names, "patch_", spelling, std::move(used));
}
template <class Spelling>
Label_names distinct_region_names(const Mixed_mesh& mesh, const Spelling& spelling, std::set<std::string> used = {}) {
  return distinct_names(labels_of(mesh, 3), mesh.region_names, "region_", spelling, std::move(used));
}

// No more than so many bytes of a name, whole letters in UTF-8.
inline std::string shortened(std::string name, std::size_t bytes) {
  if (name.size() <= bytes)
    return name;
  while (bytes > 0 && (static_cast<unsigned char>(name[bytes]) & 0xc0) == 0x80)
    --bytes;
  name.resize(bytes);
  return name;
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_DISTINCT_NAMES_H
