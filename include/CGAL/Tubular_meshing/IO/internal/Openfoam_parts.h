// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_OPENFOAM_PARTS_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_OPENFOAM_PARTS_H

#include <CGAL/Tubular_meshing/IO/internal/Cells_by_part.h>
#include <CGAL/Tubular_meshing/IO/internal/Face_mesh.h>
#include <CGAL/Tubular_meshing/IO/internal/Openfoam_files.h>
#include <CGAL/Tubular_meshing/IO/internal/Used_points.h>
#include <CGAL/Tubular_meshing/IO/internal/names_in_files.h>
#include <CGAL/Tubular_meshing/IO/internal/openfoam_patches.h>
#include <CGAL/Tubular_meshing/Partition/Cell_partition.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

/* What parts of a mesh are, for whom they are made. */
class Openfoam_part_rules {
public:
  virtual ~Openfoam_part_rules() = default;

  // Of a folder, as its files say it.
  virtual std::string location(std::size_t part) const = 0;
  // Of a part, towards another, without the number of faces. The labels are those of the facets between the two.
  virtual Openfoam_patch patch_between(std::size_t part, std::size_t other, const std::set<int>& labels) const = 0;
  // Whether a part is one of a whole: with all of its patches and zones, and where each thing is in it.
  virtual bool are_of_a_whole() const = 0;
};

/* Writes the polyMesh of each part of a mesh that Openfoam_writer writes as a whole.
 *
 * Cells, points and faces keep their order within a part, so that faces between cells are in upper triangular order
 * again. Behind the patches of the mesh comes one for each part beside it, of the faces between: in the order of the
 * mesh on both sides, and with the same first corner. */
class Openfoam_parts {
public:
  Openfoam_parts(const Face_mesh& faces, const Cell_partition& partition, const Openfoam_part_rules& rules, bool binary)
      : rules_(rules)
      , faces_(faces)
      , mesh_(faces.cells().mesh())
      , partition_(partition)
      , cells_(partition)
      , points_(mesh_, &any_region)
      , patches_(openfoam_patches(faces))
      , outer_faces_(partition.number_of_parts)
      , local_point_(mesh_.points.size())
      , seen_in_(mesh_.points.size(), no_cell)
      , binary_(binary) {
    std::uint32_t number = 0;
    first_face_.reserve(faces_.cells().size());
    for (std::size_t c = 0; c < faces_.cells().size(); ++c) {
      first_face_.push_back(number);
      faces_.for_each_face_owned_by(c, [&](const Face_mesh::Inner_face&) { ++number; });
    }
    list_outer_faces();
    for_each_face_in_zone(faces_, [&](std::size_t n, int label, bool flipped) {
      in_zones_.push_back({n, label, flipped});
    });
  }

  void write(Output_folder& folder, std::size_t part) const {
    const Part p = faces_of(part);
    Openfoam_files files(folder, binary_,
                         "nPoints:" + std::to_string(p.points.size()) +
                             "  nCells:" + std::to_string(cells_.of_part(part).size()) +
                             "  nFaces:" + std::to_string(p.number_of_faces()) +
                             "  nInternalFaces:" + std::to_string(p.number_of_inner_faces),
                         rules_.location(part));
    for (std::size_t i = 0; i < p.points.size(); ++i)
      local_point_[p.points[i]] = std::uint32_t(i);
    files.write_points(p.points.size(), [&](const auto& put) {
      for (std::uint32_t v : p.points)
        put(mesh_.points[v]);
    });
    files.write_faces(p.number_of_faces(),
                      [&](const auto& put) { for_each_face(part, p, [&](const Part_face& f) { put(corners(f)); }); });
    files.write_labels(
        "owner", p.number_of_faces(),
        [&](const auto& put) { for_each_face(part, p, [&](const Part_face& f) { put(cells_.place(f.cell)); }); }, true);
    files.write_labels(
        "neighbour", p.number_of_inner_faces,
        [&](const auto& put) {
          for_each_inner_face(part, [&](const Part_face& f) { put(cells_.place(f.neighbour)); });
        },
        true);
    files.write_boundary(p.patches, p.number_of_inner_faces);
    write_zones(files, part, p);
    if (rules_.are_of_a_whole())
      write_addressing(files, part, p);
  }

private:
  typedef Face_mesh::Side Side;

  struct Part_face {
    std::uint32_t number; // in the whole mesh
    Side side;            // of its owner there
    std::uint32_t cell;   // of the part
    std::uint32_t neighbour;
    bool is_flipped() const { return side.cell != cell; }
  };

  // Faces between cells come first; they are found as often as they are wanted, as those of the mesh are.
  struct Part {
    std::size_t number_of_inner_faces = 0;
    std::vector<Part_face> outer_faces; // by patch
    std::vector<Openfoam_patch> patches;
    std::vector<std::uint32_t> points;

    std::size_t number_of_faces() const { return number_of_inner_faces + outer_faces.size(); }
  };

  // Calls f(face) for those of a part between two of its cells.
  template <class F> void for_each_inner_face(std::size_t part, F f) const {
    for (std::uint32_t c : cells_.of_part(part)) {
      std::uint32_t number = first_face_[c];
      faces_.for_each_face_owned_by(c, [&](const Face_mesh::Inner_face& face) {
        if (partition_.part[face.neighbour] == part)
          f(Part_face{number, face.owner, c, face.neighbour});
        ++number;
      });
    }
  }

  // The same for all of a part, in the order in which they are written.
  template <class F> void for_each_face(std::size_t part, const Part& p, F f) const {
    for_each_inner_face(part, f);
    for (const Part_face& face : p.outer_faces)
      f(face);
  }

  struct Face_in_zone {
    std::size_t number;
    int label;
    bool flipped;
  };

  struct Outer_face {
    std::uint32_t number;
    std::size_t patch;
    Side side;
  };

  void list_outer_faces() {
    std::uint32_t number = std::uint32_t(faces_.number_of_inner_faces());
    std::size_t patch = 0, left = patches_.empty() ? 0 : patches_[0].number_of_faces;
    faces_.for_each_outer_face([&](const Side& side) {
      while (left == 0)
        left = patches_[++patch].number_of_faces;
      --left;
      outer_faces_[partition_.part[side.cell]].push_back({number++, patch, side});
    });
  }

  Part faces_of(std::size_t part) const {
    Part result;
    std::map<std::uint32_t, std::vector<Part_face>> between; // by the other part
    for (std::uint32_t c : cells_.of_part(part)) {
      for (std::uint32_t v : faces_.cells().corners(c))
        if (seen_in_[v] != part) {
          seen_in_[v] = std::uint32_t(part);
          result.points.push_back(v);
        }
      std::uint32_t number = first_face_[c];
      faces_.for_each_face_owned_by(c, [&](const Face_mesh::Inner_face& f) {
        const std::uint32_t other = partition_.part[f.neighbour];
        if (other == part)
          ++result.number_of_inner_faces;
        else
          between[other].push_back({number, f.owner, c, f.neighbour});
        ++number;
      });
      add_faces_below(c, part, between);
    }
    std::sort(result.points.begin(), result.points.end());
    add_patches(part, result);
    add_patches_between(part, between, result);
    return result;
  }

  // Those of a cell that a lower cell of another part owns.
  void add_faces_below(std::uint32_t cell, std::size_t part,
                       std::map<std::uint32_t, std::vector<Part_face>>& between) const {
    std::vector<std::uint32_t> owners;
    for (std::size_t k = 0; k < faces_.cells().number_of_faces(cell); ++k) {
      const std::uint32_t other = faces_.across(cell, k);
      if (other != no_cell && other < cell && partition_.part[other] != part &&
          std::find(owners.begin(), owners.end(), other) == owners.end())
        owners.push_back(other);
    }
    for (std::uint32_t owner : owners) {
      std::uint32_t number = first_face_[owner];
      faces_.for_each_face_owned_by(owner, [&](const Face_mesh::Inner_face& f) {
        if (f.neighbour == cell)
          between[partition_.part[owner]].push_back({number, f.owner, cell, owner});
        ++number;
      });
    }
  }

  void add_patches(std::size_t part, Part& result) const {
    std::vector<std::size_t> sizes(patches_.size(), 0);
    for (const Outer_face& f : outer_faces_[part]) { // by patch
      result.outer_faces.push_back({f.number, f.side, f.side.cell, no_cell});
      ++sizes[f.patch];
    }
    for (std::size_t i = 0; i < patches_.size(); ++i)
      if (sizes[i] > 0 || rules_.are_of_a_whole())
        result.patches.push_back({patches_[i].name, patches_[i].entries, sizes[i]});
  }

  void add_patches_between(std::size_t part, std::map<std::uint32_t, std::vector<Part_face>>& between,
                           Part& result) const {
    for (auto& b : between) {
      std::sort(b.second.begin(), b.second.end(),
                [](const Part_face& f, const Part_face& g) { return f.number < g.number; });
      result.outer_faces.insert(result.outer_faces.end(), b.second.begin(), b.second.end());
      std::set<int> labels;
      for (const Part_face& f : b.second)
        if (const Face_in_zone* zone = zone_of(f.number))
          labels.insert(zone->label);
      result.patches.push_back(rules_.patch_between(part, b.first, labels));
      result.patches.back().number_of_faces = b.second.size();
    }
  }

  // Of a face of the whole mesh between cells, what facet lies there, if one does.
  const Face_in_zone* zone_of(std::uint32_t number) const {
    const auto found = std::lower_bound(in_zones_.begin(), in_zones_.end(), number,
                                        [](const Face_in_zone& z, std::uint32_t n) { return z.number < n; });
    return found == in_zones_.end() || found->number != number ? nullptr : &*found;
  }

  // Outward from the cell of the part; a face that another part's cell owns keeps its first corner.
  Face corners(const Part_face& f) const {
    Face face = faces_.corners(f.side);
    const std::size_t n = number_of_corners(face);
    for (std::size_t k = 0; k < n; ++k)
      face[k] = local_point_[face[k]];
    if (f.is_flipped())
      std::reverse(face.begin() + 1, face.begin() + std::ptrdiff_t(n));
    return face;
  }

  // In parts of a whole there are all of its zones, some of them empty.
  void write_zones(Openfoam_files& files, std::size_t part, const Part& p) const {
    if (rules_.are_of_a_whole() && has_openfoam_cell_zones(mesh_)) {
      const Cells_by_part::Range cells = cells_.of_part(part);
      files.write_cell_zones(region_names_in_file(mesh_, Mesh_format::openfoam), cells.size(),
                             [&](std::size_t c) { return faces_.cells().region(cells[c]); });
    }
    std::map<int, Openfoam_face_zone> zones;
    if (rules_.are_of_a_whole())
      for (const Face_in_zone& z : in_zones_)
        zones[z.label];
    std::size_t i = 0;
    for_each_face(part, p, [&](const Part_face& f) {
      const Face_in_zone* const zone =
          rules_.are_of_a_whole() || i < p.number_of_inner_faces ? zone_of(f.number) : nullptr;
      if (zone != nullptr) {
        zones[zone->label].faces.push_back(i);
        zones[zone->label].flipped.push_back(zone->flipped != f.is_flipped());
      }
      ++i;
    });
    if (!zones.empty())
      files.write_face_zones(patch_names_in_file(mesh_, Mesh_format::openfoam), zones);
  }

  // Where each thing of the part is in the whole mesh. Faces are counted from 1, with a minus where they are reversed.
  void write_addressing(Openfoam_files& files, std::size_t part, const Part& p) const {
    const Cells_by_part::Range cells = cells_.of_part(part);
    files.write_labels("pointProcAddressing", p.points.size(), [&](const auto& put) {
      for (std::uint32_t v : p.points)
        put(points_.number(v));
    });
    files.write_labels("faceProcAddressing", p.number_of_faces(), [&](const auto& put) {
      for_each_face(part, p,
                    [&](const Part_face& f) { put((f.is_flipped() ? -1 : 1) * (std::int64_t(f.number) + 1)); });
    });
    files.write_labels("cellProcAddressing", cells.size(), [&](const auto& put) {
      for (std::uint32_t c : cells)
        put(c);
    });
    files.write_labels("boundaryProcAddressing", p.patches.size(), [&](const auto& put) {
      for (std::size_t i = 0; i < p.patches.size(); ++i)
        put(i < patches_.size() ? std::int64_t(i) : -1);
    });
  }

  const Openfoam_part_rules& rules_;
  const Face_mesh& faces_;
  const Mixed_mesh& mesh_;
  const Cell_partition& partition_;
  const Cells_by_part cells_;
  const Used_points points_;
  const std::vector<Openfoam_patch> patches_;
  std::vector<std::uint32_t> first_face_;            // between cells, of those that a cell owns
  std::vector<std::vector<Outer_face>> outer_faces_; // of each part, in the order of the mesh
  std::vector<Face_in_zone> in_zones_;               // by number
  mutable std::vector<std::uint32_t> local_point_;   // of the part that is being written
  mutable std::vector<std::uint32_t> seen_in_;       // the part that a point was last seen in
  const bool binary_;
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_OPENFOAM_PARTS_H
