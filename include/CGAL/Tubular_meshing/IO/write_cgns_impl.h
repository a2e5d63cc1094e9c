// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_CGNS_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_CGNS_IMPL_H

#include <CGAL/Tubular_meshing/IO/Mesh_format.h>
#include <CGAL/Tubular_meshing/IO/internal/Facet_sides.h>
#include <CGAL/Tubular_meshing/IO/internal/Used_points.h>
#include <CGAL/Tubular_meshing/IO/internal/Wall_patches.h>
#include <CGAL/Tubular_meshing/IO/internal/Cells_by_region.h>
#include <CGAL/Tubular_meshing/IO/internal/check_mesh.h>
#include <CGAL/Tubular_meshing/IO/internal/names_in_files.h>
#include <CGAL/Tubular_meshing/IO/internal/refuse.h>
#include <CGAL/Tubular_meshing/IO/write_cgns.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#ifdef CGAL_TUBULAR_MESHING_WITH_CGNS
#include <cgnslib.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO {

namespace internal {

#ifdef CGAL_TUBULAR_MESHING_WITH_CGNS

class Cgns_writer {
public:
  Cgns_writer(Output_file& file, const Mixed_mesh& mesh)
      : file_(file)
      , mesh_(mesh)
      , cells_(mesh)
      , facets_(cells_, file.name())
      , points_(mesh, &any_region)
      , order_(cells_)
      , blocks_(order_.blocks())
      , walls_(cells_, facets_)
      , patch_names_(patch_names_in_file(mesh, Mesh_format::cgns)) {}
  Cgns_writer(const Cgns_writer&) = delete;
  ~Cgns_writer() {
    if (is_open_)
      cg_close(cgns_);
  }

  void write() {
    if (blocks_.empty())
      refuse(file_.name(), "its format is for meshes with cells, and this one has none", write_vtu_instead);
    if (mesh_.number_of_cells() + mesh_.number_of_facets() > std::size_t((std::numeric_limits<cgsize_t>::max)()))
      refuse(file_.name(), "the CGNS library that this program was built with counts to 2147483647 only",
             write_vtu_instead);
    cg_configure(CG_CONFIG_ERROR, nullptr);
    check(cg_open(file_.name_for_library().c_str(), CG_MODE_WRITE, &cgns_));
    is_open_ = true;
    cgsize_t sizes[3] = {cgsize_t(points_.size()), cgsize_t(cells_.size()), 0};
    check(cg_base_write(cgns_, "Base", 3, 3, &base_));
    check(cg_zone_write(cgns_, base_, "Zone", sizes, CGNS_ENUMV(Unstructured), &zone_));
    write_points();
    write_cells();
    write_patches();
    is_open_ = false;
    check(cg_close(cgns_));
  }

private:
  void check(int status) const {
    if (status != CG_OK)
      refuse(file_.name(), "the CGNS library failed to write it (" + std::string(cg_get_error()) + ")",
             "check its directory, its permissions and the free space");
  }

  void write_points() {
    const char* const names[3] = {"CoordinateX", "CoordinateY", "CoordinateZ"};
    std::vector<double> values(points_.size());
    for (int k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < mesh_.points.size(); ++i)
        if (points_.contain(i))
          values[points_.number(i)] = mesh_.points[i][k];
      int coordinate;
      check(cg_coord_write(cgns_, base_, zone_, CGNS_ENUMV(RealDouble), names[k], values.data(), &coordinate));
    }
  }

  // A section of so many elements; f(corners) appends the next one's, from 1. Returns the number of the first.
  template <class F>
  cgsize_t write_section(const std::string& name, CGNS_ENUMT(ElementType_t) type, std::size_t size, std::size_t corners,
                         F f) {
    const cgsize_t first = next_, last = next_ + cgsize_t(size) - 1;
    next_ = last + 1;
    int section;
    check(cg_section_partial_write(cgns_, base_, zone_, name.c_str(), type, first, last, 0, &section));
    std::vector<cgsize_t> part;
    for (cgsize_t begin = first; begin <= last;) {
      const cgsize_t end = (std::min)(last + 1, begin + cgsize_t((std::size_t(1) << 18) / corners));
      part.clear();
      for (cgsize_t e = begin; e < end; ++e)
        f(part);
      check(cg_elements_partial_write(cgns_, base_, zone_, section, begin, end - 1, part.data()));
      begin = end;
    }
    return first;
  }

  void write_cells() {
    const CGNS_ENUMT(ElementType_t)
        types[4] = {CGNS_ENUMV(TETRA_4), CGNS_ENUMV(PYRA_5), CGNS_ENUMV(PENTA_6), CGNS_ENUMV(HEXA_8)};
    const char* const kinds[4] = {"tetrahedra", "pyramids", "prisms", "hexahedra"};
    const Label_names names = region_names_in_file(mesh_, Mesh_format::cgns);
    for (const auto& n : patch_names_)
      used_.insert(n.second);
    for (const auto& n : names)
      used_.insert(n.second);
    const Cells_by_region::Listed listed = order_.listed();
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const Cells_of_region& block = blocks_[b];
      const std::string& region = names.at(block.region);
      const bool is_first = order_.is_first_of_region(b);
      const std::string name = is_first ? region : unused_name(shortened(region, 17) + '_' + kinds[block.kind], used_);
      used_.insert(name);
      std::size_t place = order_.first_place(b);
      write_section(name, types[block.kind], block.size, 8, [&](std::vector<cgsize_t>& part) {
        for (std::uint32_t v : cells_.corners(listed[place]))
          part.push_back(cgsize_t(points_.number(v)) + 1);
        ++place;
      });
    }
  }

  void write_patches() {
    for (const auto& patch : facets_by_patch(facets_)) {
      const std::string& name = patch_names_.at(patch.first);
      const cgsize_t first = write_facets(name, patch.second);
      cgsize_t range[2] = {first, next_ - 1};
      const bool bounds_lumen = cells_.region(facets_.sides(patch.second.front())[0].cell) == labels::lumen;
      const CGNS_ENUMT(BCType_t) type = walls_.contain(patch.first) || !bounds_lumen ? CGNS_ENUMV(BCWall)
                                        : patch.first == labels::inlet               ? CGNS_ENUMV(BCInflow)
                                                                                     : CGNS_ENUMV(BCOutflow);
      int condition;
      check(cg_boco_write(cgns_, base_, zone_, name.c_str(), type, CGNS_ENUMV(PointRange), 2, range, &condition));
      check(cg_boco_gridlocation_write(cgns_, base_, zone_, condition, CGNS_ENUMV(FaceCenter)));
      const auto whole = mesh_.patch_names.find(patch.first);
      if (whole != mesh_.patch_names.end() && !whole->second.empty() && whole->second != name) {
        check(cg_goto(cgns_, base_, "Zone_t", zone_, "ZoneBC_t", 1, "BC_t", condition, "end"));
        check(cg_descriptor_write("Name", whole->second.c_str()));
      }
    }
  }

  // Returns the number of the first.
  cgsize_t write_facets(const std::string& name, const std::vector<std::uint32_t>& facets) {
    std::size_t triangles = 0;
    for (std::uint32_t f : facets)
      triangles += f < mesh_.triangles.size() ? 1 : 0;
    const bool is_mixed = triangles != 0 && triangles != facets.size();
    const CGNS_ENUMT(ElementType_t) type = is_mixed         ? CGNS_ENUMV(MIXED)
                                           : triangles != 0 ? CGNS_ENUMV(TRI_3)
                                                            : CGNS_ENUMV(QUAD_4);
    auto facet = facets.begin();
    const auto append = [&](std::vector<cgsize_t>& part) {
      const Face corners = facets_.face(facets_.sides(*facet++)[0]);
      const std::size_t n = number_of_corners(corners);
      if (is_mixed)
        part.push_back(cgsize_t(n == 3 ? CGNS_ENUMV(TRI_3) : CGNS_ENUMV(QUAD_4)));
      for (std::size_t k = 0; k < n; ++k)
        part.push_back(cgsize_t(points_.number(corners[k])) + 1);
    };
    if (!is_mixed)
      return write_section(name, type, facets.size(), 4, append);
    return write_mixed_section(name, facets.size(), append);
  }

  // The library writes these whole: they have to say where each element begins.
  template <class F> cgsize_t write_mixed_section(const std::string& name, std::size_t size, F f) {
    const cgsize_t first = next_, last = next_ + cgsize_t(size) - 1;
    next_ = last + 1;
    std::vector<cgsize_t> elements, offsets = {0};
    for (std::size_t i = 0; i < size; ++i) {
      f(elements);
      offsets.push_back(cgsize_t(elements.size()));
    }
    int section;
#if CGNS_VERSION >= 3400
    check(cg_poly_section_write(cgns_, base_, zone_, name.c_str(), CGNS_ENUMV(MIXED), first, last, 0, elements.data(),
                                offsets.data(), &section));
#else
    check(cg_section_write(cgns_, base_, zone_, name.c_str(), CGNS_ENUMV(MIXED), first, last, 0, elements.data(),
                           &section));
#endif
    return first;
  }

  Output_file& file_;
  const Mixed_mesh& mesh_;
  const Numbered_cells cells_;
  const Facet_sides facets_;
  const Used_points points_;
  const Cells_by_region order_;
  const std::vector<Cells_of_region>& blocks_;
  const Wall_patches walls_;
  const Label_names patch_names_;
  std::set<std::string> used_;
  int cgns_ = 0, base_ = 0, zone_ = 0;
  bool is_open_ = false;
  cgsize_t next_ = 1; // number of the next element
};

#endif // CGAL_TUBULAR_MESHING_WITH_CGNS

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE bool has_cgns() {
#ifdef CGAL_TUBULAR_MESHING_WITH_CGNS
  return true;
#else
  return false;
#endif
}

CGAL_TUBULAR_MESHING_INLINE void write_cgns(Output_file& file, const Mixed_mesh& mesh) {
  internal::check_mesh(mesh, file.name());
#ifdef CGAL_TUBULAR_MESHING_WITH_CGNS
  internal::Cgns_writer(file, mesh).write();
#else
  throw Output_error(why_not_built_in(Mesh_format::cgns));
#endif
}

CGAL_TUBULAR_MESHING_INLINE void write_cgns(const std::string& file, const Mixed_mesh& mesh) {
  Output_file out(file);
  write_cgns(out, mesh);
  out.commit();
}

} // namespace CGAL::Tubular_meshing::IO

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_CGNS_IMPL_H
