// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_MESH_PARTS_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_MESH_PARTS_H

#include <CGAL/Tubular_meshing/IO/internal/Cell_faces.h>
#include <CGAL/Tubular_meshing/IO/internal/Cells_by_part.h>
#include <CGAL/Tubular_meshing/IO/internal/Facet_sides.h>
#include <CGAL/Tubular_meshing/IO/internal/element_kinds.h>
#include <CGAL/Tubular_meshing/IO/internal/write_vtu.h>
#include <CGAL/Tubular_meshing/Partition/Cell_partition.h>
#include <CGAL/Tubular_meshing/Partition/Ghost_cells.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

/* The parts of a mesh as meshes of their own, each with a layer of ghost cells, made one at a time.
 *
 * Points, cells and facets keep their order. A facet belongs to the part of the cell behind it, of the lower region
 * where it has two; facets of ghost cells are there as ghosts. Points that no cell has are in the first part. */
class Mesh_parts {
public:
  struct Part {
    Mixed_mesh mesh;
    Vtu_part ids;
    std::vector<Cell_array> cell_arrays;
  };

  Mesh_parts(const Mesh_nodes& nodes, const Cell_partition& partition, const std::string& file)
      : mesh_(nodes.mesh())
      , cell_arrays_(nodes.cell_arrays())
      , partition_(partition)
      , numbered_(mesh_)
      , facets_(numbered_, file)
      , cells_(partition)
      , ghosts_(mesh_, partition)
      , has_facet_(numbered_.size(), false)
      , local_point_(mesh_.points.size()) {
    for (std::size_t f = 0; f < facets_.size(); ++f)
      for (const Facet_sides::Side& side : facets_.sides(f))
        if (side.is_there()) {
          has_facet_[side.cell] = true;
          facet_of_cell_.emplace_back(side.cell, std::uint32_t(f));
        }
    std::sort(facet_of_cell_.begin(), facet_of_cell_.end());
  }

  std::size_t size() const { return partition_.number_of_parts; }

  Part operator[](std::size_t p) {
    const std::vector<std::uint32_t>& ghosts = ghosts_.of_part(p);
    const Cells_by_part::Range own = cells_.of_part(p);
    std::vector<std::uint32_t> cells;
    cells.reserve(own.size() + ghosts.size());
    std::merge(own.begin(), own.end(), ghosts.begin(), ghosts.end(), std::back_inserter(cells));
    Part part;
    part.mesh.region_names = mesh_.region_names;
    part.mesh.patch_names = mesh_.patch_names;
    part.mesh.patch_ids = mesh_.patch_ids;
    for (const Cell_array& a : cell_arrays_) {
      part.cell_arrays.push_back({a.name, a.components, {}});
      for (std::uint32_t c : cells) {
        const auto first = a.values.begin() + std::ptrdiff_t(c) * a.components;
        part.cell_arrays.back().values.insert(part.cell_arrays.back().values.end(), first, first + a.components);
      }
    }
    add_points(p, cells, part);
    for (std::uint32_t c : cells) {
      const Numbered_cells::Corners corners = numbered_.corners(c);
      add(part, element_kinds[numbered_.kind(c)], corners.begin(), numbered_.region(c));
      part.ids.cell_ids.push_back(c);
      part.ids.cell_ghosts.push_back(partition_.part[c] != p);
    }
    add_facets(p, cells, part);
    return part;
  }

private:
  void add_points(std::size_t p, const std::vector<std::uint32_t>& cells, Part& part) {
    std::vector<std::uint32_t> points;
    for (std::uint32_t c : cells)
      for (std::uint32_t v : numbered_.corners(c))
        points.push_back(v);
    for (std::size_t v = 0; p == 0 && v < mesh_.points.size(); ++v)
      if (ghosts_.owner(v) == Ghost_cells::no_part)
        points.push_back(std::uint32_t(v));
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    for (const Point_array& a : mesh_.point_arrays)
      part.mesh.point_arrays.push_back({a.name, a.components, {}});
    for (std::uint32_t v : points) {
      local_point_[v] = std::uint32_t(part.mesh.points.size());
      part.mesh.points.push_back(mesh_.points[v]);
      part.ids.point_ids.push_back(v);
      part.ids.point_ghosts.push_back(ghosts_.owner(v) != p && ghosts_.owner(v) != Ghost_cells::no_part);
      for (std::size_t a = 0; a < mesh_.point_arrays.size(); ++a) {
        const Point_array& array = mesh_.point_arrays[a];
        const auto first = array.values.begin() + std::ptrdiff_t(v) * array.components;
        std::vector<double>& values = part.mesh.point_arrays[a].values;
        values.insert(values.end(), first, first + array.components);
      }
    }
  }

  void add_facets(std::size_t p, const std::vector<std::uint32_t>& cells, Part& part) const {
    std::vector<std::uint32_t> facets;
    for (std::uint32_t c : cells)
      if (has_facet_[c])
        for (auto f =
                 std::lower_bound(facet_of_cell_.begin(), facet_of_cell_.end(), std::make_pair(c, std::uint32_t(0)));
             f != facet_of_cell_.end() && f->first == c; ++f)
          facets.push_back(f->second);
    std::sort(facets.begin(), facets.end());
    facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
    const std::size_t triangles = mesh_.triangles.size();
    for (std::uint32_t f : facets) {
      if (f < triangles)
        add(part, element_kinds[4], mesh_.triangles.vertices[f].data(), facets_.label(f));
      else
        add(part, element_kinds[5], mesh_.quads.vertices[f - triangles].data(), facets_.label(f));
      part.ids.cell_ids.push_back(std::int64_t(numbered_.size() + f));
      part.ids.cell_ghosts.push_back(partition_.part[facets_.sides(f)[0].cell] != p);
    }
  }

  void add(Part& part, const Element_kind& kind, const std::uint32_t* corners, int label) const {
    std::array<std::uint32_t, 8> local = {};
    for (std::size_t k = 0; k < kind.corners; ++k)
      local[k] = local_point_[corners[k]];
    add_element(part.mesh, kind, local.begin(), false, label);
  }

  const Mixed_mesh& mesh_;
  const std::vector<Cell_array>& cell_arrays_;
  const Cell_partition& partition_;
  const Numbered_cells numbered_;
  const Facet_sides facets_;
  const Cells_by_part cells_;
  const Ghost_cells ghosts_;
  std::vector<bool> has_facet_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> facet_of_cell_;
  std::vector<std::uint32_t> local_point_; // of the part that is being made
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_MESH_PARTS_H
