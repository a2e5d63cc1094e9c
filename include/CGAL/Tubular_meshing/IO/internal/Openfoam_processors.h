// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_OPENFOAM_PROCESSORS_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_OPENFOAM_PROCESSORS_H

#include <CGAL/Tubular_meshing/IO/internal/Openfoam_files.h>
#include <CGAL/Tubular_meshing/IO/internal/Openfoam_parts.h>

#include <cstddef>
#include <set>
#include <string>

namespace CGAL::Tubular_meshing::IO::internal {

/* Parts for processors, as OpenFOAM's decomposePar makes them: all patches of the mesh are in each. */
class Openfoam_processors : public Openfoam_part_rules {
public:
  std::string location(std::size_t) const override { return openfoam_location; }

  Openfoam_patch patch_between(std::size_t part, std::size_t other, const std::set<int>&) const override {
    const std::string mine = std::to_string(part), theirs = std::to_string(other);
    return {"procBoundary" + mine + "to" + theirs,
            openfoam_entry("type", "processor") + openfoam_entry("inGroups", "1(processor)") +
                openfoam_entry("matchTolerance", "0.0001") + openfoam_entry("transform", "unknown") +
                openfoam_entry("myProcNo", mine) + openfoam_entry("neighbProcNo", theirs),
            0};
  }

  bool are_of_a_whole() const override { return true; }
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_OPENFOAM_PROCESSORS_H
