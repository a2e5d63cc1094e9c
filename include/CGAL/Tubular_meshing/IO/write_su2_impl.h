// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_SU2_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_SU2_IMPL_H

#include <CGAL/Tubular_meshing/IO/internal/Facet_sides.h>
#include <CGAL/Tubular_meshing/IO/internal/Number_writer.h>
#include <CGAL/Tubular_meshing/IO/internal/Used_points.h>
#include <CGAL/Tubular_meshing/IO/internal/check_mesh.h>
#include <CGAL/Tubular_meshing/IO/internal/names_in_files.h>
#include <CGAL/Tubular_meshing/IO/internal/refuse.h>
#include <CGAL/Tubular_meshing/IO/write_su2.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::IO {

namespace internal {

class Su2_writer {
public:
  Su2_writer(Output_file& file, const Mixed_mesh& mesh)
      : file_(file)
      , out_(file)
      , mesh_(mesh)
      , cells_(mesh)
      , facets_(cells_, file.name()) {}

  void write() {
    const std::set<int> regions = labels_of(mesh_, 3);
    if (regions.empty())
      refuse(file_.name(), "its format is for meshes with cells, and this one has none", write_vtu_instead);
    name_markers();
    if (regions.size() > 1)
      out_ << "NZONE= " << regions.size() << '\n';
    int zone = 0;
    for (int r : regions) {
      if (regions.size() > 1)
        out_ << "IZONE= " << ++zone << '\n';
      write_zone(r);
    }
    out_.flush();
  }

private:
  typedef Facet_sides::Side Side;

  // The markers of the side of the lower region, or the only one, and those of the other side.
  void name_markers() {
    std::set<std::string> used;
    names_ = patch_names_in_file(mesh_, Mesh_format::su2);
    for (const auto& n : names_)
      used.insert(n.second);
    const Label_names regions = region_names_in_file(mesh_, Mesh_format::su2);
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      if (!facets_.is_inside(f))
        continue;
      const Facet_sides::Sides s = facets_.sides(f);
      const int low = cells_.region(s[0].cell), high = cells_.region(s[1].cell), label = facets_.label(f);
      if (low == high)
        refuse(file_.name(),
               "its patch \"" + names_.at(label) +
                   "\" lies inside of a region, and its format has patches around regions only",
               write_vtu_instead);
      if (other_names_.count({label, high}) == 0)
        used.insert(other_names_[{label, high}] = unused_name(names_.at(label) + '_' + regions.at(high), used));
    }
  }

  void write_zone(int region) {
    const Used_points points(mesh_, [&](int r) { return r == region; });
    out_ << "NDIME= 3\n";
    write_cells(region, points);
    out_ << "NPOIN= " << points.size() << '\n';
    for (std::size_t i = 0; i < mesh_.points.size(); ++i)
      if (points.contain(i)) {
        const Point_3& p = mesh_.points[i];
        out_ << p.x() << ' ' << p.y() << ' ' << p.z() << ' ' << points.number(i) << '\n';
      }
    write_markers(region, points);
  }

  void write_cells(int region, const Used_points& points) {
    std::size_t number = 0;
    for_each_block(mesh_, [&](const auto& block, const Element_kind& kind) {
      if (kind.dimension == 3)
        for (int label : block.label)
          number += label == region ? 1 : 0;
    });
    out_ << "NELEM= " << number << '\n';
    number = 0;
    for_each_block(mesh_, [&](const auto& block, const Element_kind& kind) {
      if (kind.dimension == 3)
        for (std::size_t i = 0; i < block.size(); ++i)
          if (block.label[i] == region) {
            out_ << kind.vtk_type;
            for (std::size_t k = 0; k < kind.corners; ++k)
              out_ << ' ' << points.number(block.vertices[i][vtk_corner(kind, k)]);
            out_ << ' ' << number++ << '\n';
          }
    });
  }

  void write_markers(int region, const Used_points& points) {
    std::map<std::string, std::vector<Side>> markers;
    for (std::size_t f = 0; f < facets_.size(); ++f)
      for (std::size_t s = 0; s < 2; ++s) {
        const Side side = facets_.sides(f)[s];
        if (side.is_there() && cells_.region(side.cell) == region)
          markers[s == 0 ? names_.at(facets_.label(f)) : other_names_.at({facets_.label(f), region})].push_back(side);
      }
    out_ << "NMARK= " << markers.size() << '\n';
    for (const auto& m : markers) {
      out_ << "MARKER_TAG= " << m.first << "\nMARKER_ELEMS= " << m.second.size() << '\n';
      for (const Side& side : m.second) {
        const Face corners = facets_.face(side);
        const std::size_t n = number_of_corners(corners);
        out_ << (n == 3 ? 5 : 9);
        for (std::size_t k = 0; k < n; ++k)
          out_ << ' ' << points.number(corners[k]);
        out_ << '\n';
      }
    }
  }

  Output_file& file_;
  Number_writer out_;
  const Mixed_mesh& mesh_;
  const Numbered_cells cells_;
  const Facet_sides facets_;
  Label_names names_;
  std::map<std::pair<int, int>, std::string> other_names_; // of a patch, on the side of a region
};

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE void write_su2(Output_file& file, const Mixed_mesh& mesh) {
  internal::check_mesh(mesh, file.name());
  internal::Su2_writer(file, mesh).write();
}

CGAL_TUBULAR_MESHING_INLINE void write_su2(const std::string& file, const Mixed_mesh& mesh) {
  Output_file out(file);
  write_su2(out, mesh);
  out.commit();
}

} // namespace CGAL::Tubular_meshing::IO

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_SU2_IMPL_H
