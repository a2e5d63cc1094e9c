// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_EXODUS_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_EXODUS_IMPL_H

#include <CGAL/Tubular_meshing/IO/Mesh_format.h>
#include <CGAL/Tubular_meshing/IO/internal/Facet_sides.h>
#include <CGAL/Tubular_meshing/IO/internal/Mesh_nodes.h>
#include <CGAL/Tubular_meshing/IO/internal/Used_points.h>
#include <CGAL/Tubular_meshing/IO/internal/Cells_by_region.h>
#include <CGAL/Tubular_meshing/IO/internal/check_mesh.h>
#include <CGAL/Tubular_meshing/IO/internal/names_in_files.h>
#include <CGAL/Tubular_meshing/IO/internal/refuse.h>
#include <CGAL/Tubular_meshing/IO/internal/write_nodes.h>
#include <CGAL/Tubular_meshing/IO/write_exodus.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#ifdef CGAL_TUBULAR_MESHING_WITH_EXODUS
#include <exodusII.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO {

namespace internal {

#ifdef CGAL_TUBULAR_MESHING_WITH_EXODUS

class Exodus_writer {
public:
  Exodus_writer(Output_file& file, const Mesh_nodes& nodes, std::uint64_t largest_variable)
      : file_(file)
      , nodes_(nodes)
      , mesh_(nodes.mesh())
      , cells_(mesh_)
      , facets_(cells_, file.name())
      , points_(nodes, &any_region)
      , order_(cells_)
      , blocks_(order_.blocks())
      , largest_variable_(largest_variable) {}
  Exodus_writer(const Exodus_writer&) = delete;
  ~Exodus_writer() {
    if (exodus_ >= 0)
      ex_close(exodus_);
  }

  void write() {
    if (blocks_.empty())
      refuse(file_.name(), "its format is for meshes with cells, and this one has none", write_vtu_instead);
    if ((std::max)(points_.size(), cells_.size()) > std::size_t((std::numeric_limits<int>::max)()))
      refuse(file_.name(), "it has more points or cells than numbers of 32 bits, which it is written with, can count",
             write_vtu_instead);
    name_blocks();
    name_variables();
    patch_names_ = patch_names_in_file(mesh_, Mesh_format::exodus);
    ex_opts(0); // errors become exceptions, not text
    int of_program = sizeof(double), of_file = sizeof(double);
    // Classic files have no larger variables; but all programs read them, so those of netCDF-4 are for what needs them.
    const int model = size_of_largest_variable() > largest_variable_ ? EX_NETCDF4 : EX_LARGE_MODEL;
    exodus_ = ex_create(file_.name_for_library().c_str(), EX_CLOBBER | model, &of_program, &of_file);
    check(exodus_);
    allow_long_names();
    check(ex_put_init(exodus_, "Tubular_meshing", 3, std::int64_t(points_.size()), std::int64_t(cells_.size()),
                      std::int64_t(blocks_.size()), 0, std::int64_t(patch_names_.size())));
    write_points();
    write_blocks();
    write_side_sets();
    write_variables();
    const int exodus = exodus_;
    exodus_ = -1;
    check(ex_close(exodus));
  }

private:
  void check(int status) const {
    if (status < 0)
      refuse(file_.name(), "the Exodus II library failed to write it",
             "check its directory, its permissions and the free space");
  }

  // In bytes: a coordinate, the corners of a block, or values of its cells. Side sets are smaller than blocks.
  std::uint64_t size_of_largest_variable() const {
    std::uint64_t largest = sizeof(double) * std::uint64_t(points_.size());
    for (const Cells_of_region& b : blocks_)
      largest =
          (std::max)(largest, std::uint64_t(b.size) * (std::max)(sizeof(int) * nodes_.number(b.kind), sizeof(double)));
    return largest;
  }

  // The numbers of labels that are there twice, or that the format has not, are the next ones above all of them.
  void name_blocks() {
    const Label_names regions = region_names_in_file(mesh_, Mesh_format::exodus);
    std::set<std::string> used;
    for (const auto& n : regions)
      used.insert(n.second);
    int next = regions.rbegin()->first;
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const int region = blocks_[b].region;
      const bool is_first = order_.is_first_of_region(b);
      block_names_.push_back(is_first ? regions.at(region)
                                      : unused_name(regions.at(region) + '_' + type_of(blocks_[b].kind), used));
      used.insert(block_names_.back());
      block_ids_.push_back(is_first&& region > 0 ? region : next = (std::max)(0, next) + 1);
    }
  }

  // One a number: programs put those of a vector together by their ends.
  void name_variables() {
    for (const Cell_array& a : nodes_.cell_arrays())
      for (int k = 0; k < a.components; ++k)
        variable_names_.push_back(a.components == 1   ? a.name
                                  : a.components == 3 ? a.name + '_' + "xyz"[k]
                                                      : a.name + '_' + std::to_string(k + 1));
  }

  void allow_long_names() const {
    std::size_t longest = 32;
    for (const std::string& n : block_names_)
      longest = (std::max)(longest, n.size());
    for (const auto& n : patch_names_)
      longest = (std::max)(longest, n.second.size());
    for (const std::string& n : variable_names_)
      longest = (std::max)(longest, n.size());
    check(ex_set_max_name_length(exodus_, int(longest)));
  }

  const char* type_of(std::size_t kind) const {
    const char* const types[3][4] = {{"TETRA4", "PYRAMID5", "WEDGE6", "HEX8"},
                                     {"TETRA10", "PYRAMID13", "WEDGE15", "HEX20"},
                                     {"TETRA10", "PYRAMID14", "WEDGE18", "HEX27"}};
    return types[nodes_.is_complete() ? 2 : nodes_.is_quadratic() ? 1 : 0][kind];
  }

  // Which side, from 1, the format says that a face of Cell_faces is.
  static int side_of(std::size_t kind, std::size_t face) {
    constexpr int tetrahedron[4] = {4, 1, 2, 3}, pyramid[5] = {5, 1, 2, 3, 4}, prism[5] = {4, 5, 1, 2, 3},
                  hexahedron[6] = {5, 6, 1, 2, 3, 4};
    return kind == 0 ? tetrahedron[face] : kind == 1 ? pyramid[face] : kind == 2 ? prism[face] : hexahedron[face];
  }

  void write_points() {
    std::vector<double> values(points_.size());
    for (int k = 0; k < 3; ++k) { // one after the other: the library leaves alone what it is not given
      for (std::size_t i = 0; i < nodes_.size(); ++i)
        if (points_.contain(i))
          values[points_.number(i)] = nodes_.point(i)[k];
      const double* xyz[3] = {nullptr, nullptr, nullptr};
      xyz[k] = values.data();
      check(ex_put_coord(exodus_, xyz[0], xyz[1], xyz[2]));
    }
  }

  void write_blocks() {
    const Cells_by_region::Listed listed = order_.listed();
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      check(ex_put_block(exodus_, EX_ELEM_BLOCK, block_ids_[b], type_of(blocks_[b].kind), std::int64_t(blocks_[b].size),
                         std::int64_t(nodes_.number(blocks_[b].kind)), 0, 0, 0));
      write_nodes(b, listed);
      check(ex_put_name(exodus_, EX_ELEM_BLOCK, block_ids_[b], block_names_[b].c_str()));
    }
  }

  // A part at a time, where the library is one of those that can.
  void write_nodes(std::size_t block, const Cells_by_region::Listed& listed) const {
    const std::size_t size = blocks_[block].size, first = order_.first_place(block);
#if EX_API_VERS_NODOT <= 602
    const std::size_t most = std::size_t(1) << 15;
#else
    const std::size_t most = size;
#endif
    std::vector<int> nodes;
    for (std::size_t begin = 0; begin < size; begin += most) {
      const std::size_t end = (std::min)(size, begin + most);
      nodes.clear();
      nodes.reserve((end - begin) * nodes_.number(blocks_[block].kind));
      for (std::size_t i = begin; i < end; ++i)
        for (std::uint32_t v : nodes_.of_cell(cells_, listed[first + i], exodus_order))
          nodes.push_back(int(points_.number(v)) + 1);
#if EX_API_VERS_NODOT <= 602
      check(ex_put_partial_elem_conn(exodus_, block_ids_[block], std::int64_t(begin) + 1, std::int64_t(end - begin),
                                     nodes.data()));
#else
      check(ex_put_conn(exodus_, EX_ELEM_BLOCK, block_ids_[block], nodes.data(), nullptr, nullptr));
#endif
    }
  }

  // All sets in one call: each call that declares some makes the library move all that comes before.
  void write_side_sets() {
    const Cells_by_region::Numbers number = order_.numbers();
    const std::map<int, std::vector<std::uint32_t>> patches = facets_by_patch(facets_);
    std::vector<std::vector<int>> elements, sides;
    std::vector<ex_set> sets;
    int next = patches.empty() ? 0 : patches.rbegin()->first;
    for (const auto& patch : patches) {
      elements.emplace_back();
      elements.back().reserve(patch.second.size());
      sides.emplace_back();
      sides.back().reserve(patch.second.size());
      for (std::uint32_t f : patch.second) {
        const Facet_sides::Sides s = facets_.sides(f);
        const Facet_sides::Side& side = s[1].is_there() ? s[1] : s[0];
        elements.back().push_back(int(number[side.cell]) + 1);
        sides.back().push_back(side_of(cells_.kind(side.cell), side.face));
      }
      const int id = patch.first > 0 ? patch.first : next = (std::max)(0, next) + 1;
      sets.push_back({id, EX_SIDE_SET, std::int64_t(patch.second.size()), 0, elements.back().data(),
                      sides.back().data(), nullptr});
    }
    check(ex_put_sets(exodus_, sets.size(), sets.data()));
    auto set = sets.begin();
    for (const auto& patch : patches)
      check(ex_put_name(exodus_, EX_SIDE_SET, (set++)->id, patch_names_.at(patch.first).c_str()));
  }

  // Values of cells are element variables, of one time.
  void write_variables() {
    if (variable_names_.empty())
      return;
    std::vector<char*> names;
    for (std::string& n : variable_names_)
      names.push_back(&n[0]);
    const int time_step = 1;
    const double time = 0;
    check(ex_put_variable_param(exodus_, EX_ELEM_BLOCK, int(names.size())));
    check(ex_put_variable_names(exodus_, EX_ELEM_BLOCK, int(names.size()), names.data()));
    check(ex_put_time(exodus_, time_step, &time));
    int variable = 0;
    const Cells_by_region::Listed listed = order_.listed();
    for (const Cell_array& a : nodes_.cell_arrays())
      for (std::size_t k = 0; k < std::size_t(a.components); ++k) {
        ++variable;
        for (std::size_t b = 0; b < blocks_.size(); ++b) {
          std::vector<double> values;
          values.reserve(blocks_[b].size);
          for (std::size_t p = order_.first_place(b); p < order_.first_place(b + 1); ++p)
            values.push_back(a.values[std::size_t(a.components) * listed[p] + k]);
          check(ex_put_var(exodus_, time_step, EX_ELEM_BLOCK, variable, block_ids_[b], std::int64_t(values.size()),
                           values.data()));
        }
      }
  }

  Output_file& file_;
  const Mesh_nodes nodes_;
  const Mixed_mesh& mesh_;
  const Numbered_cells cells_;
  const Facet_sides facets_;
  const Used_points points_;
  const Cells_by_region order_;
  const std::vector<Cells_of_region>& blocks_;
  const std::uint64_t largest_variable_;
  std::vector<std::string> block_names_;
  std::vector<int> block_ids_;
  std::vector<std::string> variable_names_;
  Label_names patch_names_;
  int exodus_ = -1;
};

#endif // CGAL_TUBULAR_MESHING_WITH_EXODUS

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE bool has_exodus() {
#ifdef CGAL_TUBULAR_MESHING_WITH_EXODUS
  return true;
#else
  return false;
#endif
}

namespace internal {

CGAL_TUBULAR_MESHING_INLINE void write_exodus(Output_file& file, const Mesh_nodes& nodes,
                                              std::uint64_t largest_variable) {
  check_mesh(nodes.mesh(), file.name());
#ifdef CGAL_TUBULAR_MESHING_WITH_EXODUS
  Exodus_writer(file, nodes, largest_variable).write();
#else
  (void)largest_variable;
  throw Output_error(why_not_built_in(Mesh_format::exodus));
#endif
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE void write_exodus(Output_file& file, const Mixed_mesh& mesh) {
  internal::write_exodus(file, mesh);
}

CGAL_TUBULAR_MESHING_INLINE void write_exodus(const std::string& file, const Mixed_mesh& mesh) {
  Output_file out(file);
  write_exodus(out, mesh);
  out.commit();
}

} // namespace CGAL::Tubular_meshing::IO

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_EXODUS_IMPL_H
