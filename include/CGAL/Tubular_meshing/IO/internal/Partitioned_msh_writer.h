// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_PARTITIONED_MSH_WRITER_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_PARTITIONED_MSH_WRITER_H

#include <CGAL/Tubular_meshing/IO/internal/Cell_faces.h>
#include <CGAL/Tubular_meshing/IO/internal/Facet_sides.h>
#include <CGAL/Tubular_meshing/IO/internal/write_msh.h>
#include <CGAL/Tubular_meshing/Partition/Cell_partition.h>
#include <CGAL/Tubular_meshing/Partition/Ghost_cells.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

/* Writes a mesh in parts for Gmsh, format 4.1, as Gmsh does without the elements between parts that it can make. What
 * each label has in a part is an entity of its own, whose parent is the entity of the label, and in the same physical
 * group. Ghost cells are told by their numbers. */
class Partitioned_msh_writer : private Msh_writer {
public:
  Partitioned_msh_writer(Output_file& file, const Mesh_nodes& nodes, const Cell_partition& partition)
      : Msh_writer(file, nodes)
      , partition_(partition)
      , cells_(nodes.mesh())
      , facets_(cells_, file.name()) {
    std::size_t element = 0;
    for_each_block(mesh_, [&](const auto& block, const Element_kind& kind) {
      for (int label : block.label)
        entities_[std::size_t(kind.dimension)][{label, part_of_element(element++)}] = 0;
    });
    for (std::size_t d = 2; d < 4; ++d) {
      next_entity_[d] = highest_label_[d] + 2; // one more is that of label 0
      for (auto& e : entities_[d])
        e.second = next_entity_[d]++;
    }
  }

  void write() {
    write_header_4();
    write_names();
    write_entities();
    write_partitioned_entities();
    write_nodes_4(3, entities_[3].begin()->second);
    write_elements_4([&](std::size_t element, int label) { return std::make_pair(label, part_of_element(element)); },
                     [&](int dimension, const Label_and_part& l) { return entities_[std::size_t(dimension)].at(l); });
    write_ghost_elements();
    write_arrays(true);
    out_.flush();
  }

private:
  typedef std::pair<int, std::uint32_t> Label_and_part;

  // Cells, then facets, each of which goes with the cell behind it.
  std::uint32_t part_of_element(std::size_t element) const {
    return partition_.part[element < cells_.size() ? element : facets_.sides(element - cells_.size())[0].cell];
  }

  static std::int32_t gmsh_part(std::size_t part) { return std::int32_t(part) + 1; }

  void write_partitioned_entities() {
    out_ << "$PartitionedEntities\n";
    const std::size_t parts = partition_.number_of_parts;
    out_.bytes(std::uint64_t(parts)).bytes(std::uint64_t(parts));
    for (std::size_t p = 0; p < parts; ++p) // entities of ghost cells
      out_.bytes(next_entity_[3] + std::int32_t(p)).bytes(gmsh_part(p));
    for (const auto& e : entities_)
      out_.bytes(std::uint64_t(e.size()));
    const std::array<double, 6> box = bounding_box();
    for (int d = 2; d < 4; ++d)
      for (const auto& e : entities_[std::size_t(d)]) {
        const int label = e.first.first;
        out_.bytes(e.second).bytes(std::int32_t(d)).bytes(entity(d, label));
        out_.bytes(std::uint64_t(1)).bytes(gmsh_part(e.first.second));
        write_box_and_group(box, label);
      }
    out_ << "\n$EndPartitionedEntities\n";
  }

  void write_ghost_elements() {
    const Ghost_cells ghosts(mesh_, partition_);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> cell_and_part;
    for (std::size_t p = 0; p < partition_.number_of_parts; ++p)
      for (std::uint32_t c : ghosts.of_part(p))
        cell_and_part.emplace_back(c, std::uint32_t(p));
    std::sort(cell_and_part.begin(), cell_and_part.end());
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < cell_and_part.size(); ++i)
      number += i == 0 || cell_and_part[i].first != cell_and_part[i - 1].first;
    out_ << "$GhostElements\n";
    out_.bytes(number);
    for (std::size_t i = 0, end = 0; i < cell_and_part.size(); i = end) {
      const std::uint32_t cell = cell_and_part[i].first;
      while (end < cell_and_part.size() && cell_and_part[end].first == cell)
        ++end;
      out_.bytes(std::uint64_t(cell) + 1).bytes(gmsh_part(partition_.part[cell])).bytes(std::uint64_t(end - i));
      for (std::size_t k = i; k < end; ++k)
        out_.bytes(gmsh_part(cell_and_part[k].second));
    }
    out_ << "\n$EndGhostElements\n";
  }

  const Cell_partition& partition_;
  const Numbered_cells cells_;
  const Facet_sides facets_;
  std::array<std::map<Label_and_part, std::int32_t>, 4> entities_; // by dimension
  std::array<std::int32_t, 4> next_entity_ = {1, 1, 1, 1};
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_PARTITIONED_MSH_WRITER_H
