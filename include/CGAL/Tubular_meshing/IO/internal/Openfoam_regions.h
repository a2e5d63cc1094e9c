// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_OPENFOAM_REGIONS_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_OPENFOAM_REGIONS_H

#include <CGAL/Tubular_meshing/IO/internal/Cell_faces.h>
#include <CGAL/Tubular_meshing/IO/internal/Openfoam_files.h>
#include <CGAL/Tubular_meshing/IO/internal/Openfoam_parts.h>
#include <CGAL/Tubular_meshing/IO/internal/distinct_names.h>
#include <CGAL/Tubular_meshing/IO/internal/names_in_files.h>
#include <CGAL/Tubular_meshing/IO/internal/region_folders.h>
#include <CGAL/Tubular_meshing/Partition/Cell_partition.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

/* A part a region, coupled by patches of the type mappedWall, as solvers of several regions want them: `fluid_to_solid`
 * in `fluid`, `solid_to_fluid` in `solid`. These are in groups of the names of the mesh's patches there. */
class Openfoam_regions : public Openfoam_part_rules {
public:
  explicit Openfoam_regions(const Mixed_mesh& mesh)
      : folders_(region_folders(mesh, {"polyMesh", "regionProperties"}))
      , patch_names_(patch_names_in_file(mesh, Mesh_format::openfoam)) {
    for (const auto& f : folders_)
      labels_.push_back(f.first);
    for (const auto& p : patch_names_)
      used_.insert(p.second);
  }

  std::size_t size() const { return labels_.size(); }
  int label(std::size_t part) const { return labels_[part]; }
  const std::string& name(std::size_t part) const { return folders_.at(labels_[part]); }

  Cell_partition partition(const Numbered_cells& cells) const {
    std::map<int, std::uint32_t> part_of;
    for (std::size_t p = 0; p < size(); ++p)
      part_of[labels_[p]] = std::uint32_t(p);
    Cell_partition result;
    result.number_of_parts = size();
    result.part.reserve(cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c)
      result.part.push_back(part_of.at(cells.region(c)));
    return result;
  }

  std::string location(std::size_t part) const override { return "constant/" + name(part) + "/polyMesh"; }

  Openfoam_patch patch_between(std::size_t part, std::size_t other, const std::set<int>& labels) const override {
    std::set<std::string> groups = {"wall"};
    for (int l : labels)
      groups.insert(patch_names_.at(l));
    std::string all;
    for (const std::string& g : groups)
      all += (all.empty() ? "" : " ") + g;
    return {interface_name(part, other),
            openfoam_entry("type", "mappedWall") +
                openfoam_entry("inGroups", std::to_string(groups.size()) + "(" + all + ")") +
                openfoam_entry("sampleMode", "nearestPatchFace") + openfoam_entry("sampleRegion", name(other)) +
                openfoam_entry("samplePatch", interface_name(other, part)),
            0};
  }

  bool are_of_a_whole() const override { return false; }

private:
  std::string interface_name(std::size_t part, std::size_t other) const {
    return unused_name(name(part) + "_to_" + name(other), used_);
  }

  const Label_names folders_, patch_names_;
  std::vector<int> labels_; // of the regions
  std::set<std::string> used_;
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_OPENFOAM_REGIONS_H
