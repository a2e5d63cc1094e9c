// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_ONE_KIND_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_ONE_KIND_H

#include <CGAL/Tubular_meshing/IO/internal/Cell_faces.h>
#include <CGAL/Tubular_meshing/IO/internal/refuse.h>

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>

namespace CGAL::Tubular_meshing::IO::internal {

/* The kinds of cells in each region, for solvers that do not take all, or more than one at a time. */
class One_kind {
public:
  One_kind(const Numbered_cells& cells, const std::string& file, const std::string& solver)
      : file_(file)
      , solver_(solver) {
    for (std::size_t c = 0; c < cells.size(); ++c)
      if (c == 0 || cells.region(c) != cells.region(c - 1) || cells.kind(c) != cells.kind(c - 1))
        kinds_[cells.region(c)].insert(cells.kind(c));
  }

  // Throws an Output_error if the region has cells of a kind that is not allowed, or of more than one.
  void check_region(int region, const std::string& name, const std::array<bool, 4>& allowed) const {
    check(kinds_.at(region), "its region \"" + name + "\"", allowed);
  }
  void check_mesh(const std::array<bool, 4>& allowed) const {
    std::set<std::size_t> kinds;
    for (const auto& k : kinds_)
      kinds.insert(k.second.begin(), k.second.end());
    check(kinds, "it", allowed);
  }

private:
  static const char* name_of(std::size_t kind) {
    const char* const names[4] = {"tetrahedra", "pyramids", "prisms", "hexahedra"};
    return names[kind];
  }

  // What makes a mesh of one kind, where it has these.
  static std::string help(const std::set<std::size_t>& kinds) {
    if (kinds.count(1) != 0)
      return "make the mesh with --type isotropic, anisotropic or hexahedral, not mixed";
    if (kinds.count(0) != 0)
      return "make the mesh with --type anisotropic in place of --boundary-layer-prisms, and with --wall-elements "
             "tetrahedra where it has a wall";
    return "make the mesh with --type isotropic and --wall-elements tetrahedra, or with --type hexahedral";
  }

  void check(const std::set<std::size_t>& kinds, const std::string& what, const std::array<bool, 4>& allowed) const {
    for (std::size_t k : kinds)
      if (!allowed[k])
        refuse(file_, what + " has " + name_of(k) + ", which " + solver_ + " does not take", help(kinds));
    if (kinds.size() > 1)
      refuse(file_,
             what + " has " + name_of(*kinds.begin()) + " and " + name_of(*kinds.rbegin()) + ", and " + solver_ +
                 " takes one kind of cells",
             help(kinds));
  }

  const std::string file_, solver_;
  std::map<int, std::set<std::size_t>> kinds_;
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_ONE_KIND_H
