// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_FLUENT_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_FLUENT_IMPL_H

#include <CGAL/Tubular_meshing/IO/internal/Face_mesh.h>
#include <CGAL/Tubular_meshing/IO/internal/Number_writer.h>
#include <CGAL/Tubular_meshing/IO/internal/Used_points.h>
#include <CGAL/Tubular_meshing/IO/internal/Wall_patches.h>
#include <CGAL/Tubular_meshing/IO/internal/Cells_by_region.h>
#include <CGAL/Tubular_meshing/IO/internal/check_mesh.h>
#include <CGAL/Tubular_meshing/IO/internal/names_in_files.h>
#include <CGAL/Tubular_meshing/IO/write_fluent.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO {

namespace internal {

class Fluent_writer {
public:
  Fluent_writer(Output_file& file, const Mixed_mesh& mesh)
      : out_(file)
      , mesh_(mesh)
      , faces_(mesh, file.name())
      , points_(mesh, &any_region)
      , order_(faces_.cells())
      , number_(order_.numbers())
      , walls_(faces_.cells(), faces_.facets())
      , patch_names_(patch_names_in_file(mesh, Mesh_format::fluent))
      , region_names_(region_names_in_file(mesh, Mesh_format::fluent)) {
    for (const Label_names* names : {&patch_names_, &region_names_})
      for (const auto& n : *names)
        used_.insert(n.second);
  }

  void write() {
    out_ << "(0 \"Tubular_meshing\")\n(2 3)\n";
    declare(10, points_.size());
    declare(12, order_.number_of_cells());
    declare(13, faces_.number_of_faces());
    write_points();
    write_cell_zones();
    write_inner_zones();
    write_patches();
    for (const Zone& z : zones_)
      out_ << "(45 (" << z.id << ' ' << z.type << ' ' << z.name << ")())\n"; // in decimals
    out_.flush();
  }

private:
  typedef Face_mesh::Side Side;
  struct Zone {
    std::size_t id;
    std::string type, name;
  };

  struct Hexadecimal {
    std::size_t value;
  };
  friend Number_writer& operator<<(Number_writer& out, Hexadecimal h) { return out.hexadecimal(h.value); }
  static Hexadecimal hex(std::size_t value) { return {value}; }

  void declare(int section, std::size_t number) {
    out_ << '(' << section << " (0 1 " << hex(number) << (section == 10 ? " 0 3))\n" : " 0 0))\n");
  }

  std::size_t add_further_zone(const std::string& type, const std::string& wanted) {
    const std::string name = unused_name(wanted, used_);
    used_.insert(name);
    return add_zone(type, name);
  }
  std::size_t add_zone(const std::string& type, const std::string& name) {
    zones_.push_back({zones_.size() + 2, type, name}); // the points are zone 1
    return zones_.back().id;
  }

  void write_points() {
    out_ << "(10 (1 1 " << hex(points_.size()) << " 1 3)(\n";
    for (std::size_t i = 0; i < mesh_.points.size(); ++i)
      if (points_.contain(i)) {
        const Point_3& p = mesh_.points[i];
        out_ << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
      }
    out_ << "))\n";
  }

  // Of each region one, with the kind of each cell where there are several.
  void write_cell_zones() {
    const int type_of_kind[4] = {2, 5, 6, 4};
    const std::vector<Cells_of_region>& blocks = order_.blocks();
    std::size_t first = 1;
    for (std::size_t b = 0, e = 0; b < blocks.size(); b = e) {
      std::size_t size = 0;
      for (; e < blocks.size() && blocks[e].region == blocks[b].region; ++e)
        size += blocks[e].size;
      const bool is_fluid = blocks[b].region == labels::lumen;
      const std::size_t id = add_zone(is_fluid ? "fluid" : "solid", region_names_.at(blocks[b].region));
      out_ << "(12 (" << hex(id) << ' ' << hex(first) << ' ' << hex(first + size - 1) << (is_fluid ? " 1 " : " 11 ");
      if (e - b == 1) {
        out_ << type_of_kind[blocks[b].kind] << "))\n";
      } else {
        out_ << "0)(\n";
        std::size_t n = 0;
        for (std::size_t i = b; i < e; ++i)
          for (std::size_t k = 0; k < blocks[i].size; ++k)
            out_ << type_of_kind[blocks[i].kind] << (++n % 32 == 0 ? '\n' : ' ');
        out_ << "\n))\n";
      }
      first += size;
    }
  }

  // The zone of a face between cells that is on no patch: of its region, or 0 for all that lie between regions.
  struct Inner_zone {
    bool is_within;
    int region;
    bool operator<(const Inner_zone& z) const {
      return is_within != z.is_within ? z.is_within : is_within && region < z.region;
    }
  };
  Inner_zone zone_of(const Face_mesh::Inner_face& f) const {
    if (region_names_.size() == 1)
      return {true, region_names_.begin()->first};
    const int a = faces_.cells().region(f.owner.cell), b = faces_.cells().region(f.neighbour);
    return {a == b, a};
  }

  void write_inner_zones() {
    std::map<Inner_zone, std::size_t> sizes;
    auto last = sizes.end(); // most faces are in the zone of the one before
    faces_.for_each_inner_face_and_facet([&](const Face_mesh::Inner_face& f, std::uint32_t facet) {
      if (facet != no_cell)
        return;
      const Inner_zone zone = zone_of(f);
      if (last == sizes.end() || zone < last->first || last->first < zone)
        last = sizes.emplace(zone, 0).first;
      ++last->second;
    });
    for (const auto& z : sizes) {
      const std::string of = z.first.is_within ? region_names_.at(z.first.region) : "between-regions";
      begin_zone(add_further_zone("interior", "interior-" + of), z.second, 2);
      faces_.for_each_inner_face_and_facet([&](const Face_mesh::Inner_face& f, std::uint32_t facet) {
        if (facet != no_cell)
          return;
        const Inner_zone zone = zone_of(f);
        if (!(zone < z.first) && !(z.first < zone))
          write_face(faces_.corners(f), f.owner.cell, f.neighbour);
      });
      out_ << "))\n";
    }
  }

  void begin_zone(std::size_t id, std::size_t faces, int condition) {
    out_ << "(13 (" << hex(id) << ' ' << hex(next_face_) << ' ' << hex(next_face_ + faces - 1) << ' '
         << hex(std::size_t(condition)) << " 0)(\n";
    next_face_ += faces;
  }

  // From inside of the first cell its corners turn counterclockwise.
  void write_face(const Side& side, std::uint32_t across) { write_face(faces_.corners(side), side.cell, across); }
  void write_face(const Face& corners, std::uint32_t cell, std::uint32_t across) {
    const std::size_t n = number_of_corners(corners);
    out_ << (n == 3 ? "3 " : "4 ");
    for (std::size_t k = n; k-- > 0;)
      out_ << hex(points_.number(corners[k]) + std::size_t(1)) << ' ';
    out_ << hex(number_[cell] + std::size_t(1)) << ' ' << hex(across == no_cell ? 0 : number_[across] + std::size_t(1))
         << '\n';
  }

  // Inlet and outlets are known by their labels; a patch that bounds no lumen is a wall.
  void write_patches() {
    for (const auto& p : facets_by_patch(faces_.facets())) {
      const Facet_sides& facets = faces_.facets();
      const Facet_sides::Sides first = facets.sides(p.second.front());
      const bool is_wall = walls_.contain(p.first) || faces_.cells().region(first[0].cell) != labels::lumen;
      const bool is_inlet = p.first == labels::inlet;
      const bool is_inside =
          first[1].is_there() && faces_.cells().region(first[0].cell) == faces_.cells().region(first[1].cell);
      const char* const type = is_inside  ? "interior"
                               : is_wall  ? "wall"
                               : is_inlet ? "velocity-inlet"
                                          : "pressure-outlet";
      begin_zone(add_zone(type, patch_names_.at(p.first)), p.second.size(),
                 is_inside  ? 2
                 : is_wall  ? 3
                 : is_inlet ? 10
                            : 5);
      for (std::uint32_t f : p.second)
        write_face(facets.sides(f)[0], facets.sides(f)[1].cell);
      out_ << "))\n";
    }
    const auto& rest = faces_.faces_without_patch();
    if (rest.empty())
      return;
    begin_zone(add_further_zone("wall", "default-faces"), rest.size(), 3);
    for (const Side& side : rest)
      write_face(side, no_cell);
    out_ << "))\n";
  }

  Number_writer out_;
  const Mixed_mesh& mesh_;
  const Face_mesh faces_;
  const Used_points points_;
  const Cells_by_region order_;
  const Cells_by_region::Numbers number_;
  const Wall_patches walls_;
  const Label_names patch_names_, region_names_;
  std::vector<Zone> zones_;
  std::set<std::string> used_;
  std::size_t next_face_ = 1;
};

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE void write_fluent(Output_file& file, const Mixed_mesh& mesh) {
  internal::check_mesh(mesh, file.name());
  internal::Fluent_writer(file, mesh).write();
}

CGAL_TUBULAR_MESHING_INLINE void write_fluent(const std::string& file, const Mixed_mesh& mesh) {
  Output_file out(file);
  write_fluent(out, mesh);
  out.commit();
}

} // namespace CGAL::Tubular_meshing::IO

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_FLUENT_IMPL_H
