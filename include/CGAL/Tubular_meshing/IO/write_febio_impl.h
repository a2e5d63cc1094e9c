// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_FEBIO_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_FEBIO_IMPL_H

#include <CGAL/Tubular_meshing/IO/internal/Facet_sides.h>
#include <CGAL/Tubular_meshing/IO/internal/Fibre_directions.h>
#include <CGAL/Tubular_meshing/IO/internal/Mesh_nodes.h>
#include <CGAL/Tubular_meshing/IO/internal/Number_writer.h>
#include <CGAL/Tubular_meshing/IO/internal/Vtk_xml_writer.h>
#include <CGAL/Tubular_meshing/IO/internal/Cells_by_region.h>
#include <CGAL/Tubular_meshing/IO/internal/check_mesh.h>
#include <CGAL/Tubular_meshing/IO/internal/names_in_files.h>
#include <CGAL/Tubular_meshing/IO/internal/refuse.h>
#include <CGAL/Tubular_meshing/IO/internal/write_nodes.h>
#include <CGAL/Tubular_meshing/IO/write_febio.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO {

namespace internal {

class Febio_writer {
public:
  Febio_writer(Output_file& file, const Mesh_nodes& nodes)
      : file_(file)
      , out_(file)
      , nodes_(nodes)
      , mesh_(nodes.mesh())
      , cells_(mesh_)
      , facets_(cells_, file.name())
      , order_(cells_)
      , listed_(order_.listed())
      , blocks_(order_.blocks())
      , fibres_(nodes.cell_arrays()) {}

  void write() {
    if (blocks_.empty())
      refuse(file_.name(), "its format is for meshes with cells, and this one has none", write_vtu_instead);
    check_cells();
    name_blocks();
    out_ << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<febio_spec version=\"4.0\">\n<Module "
            "type=\"solid\"/>\n<Mesh>\n";
    write_nodes();
    write_elements();
    write_patches();
    out_ << "</Mesh>\n";
    write_domains();
    write_cell_arrays();
    out_ << "</febio_spec>\n";
    out_.flush();
  }

private:
  typedef Facet_sides::Side Side;

  const char* type_of(std::size_t kind) const {
    const char* const types[3][6] = {{"tet4", "pyra5", "penta6", "hex8", "tri3", "quad4"},
                                     {"tet10", "pyra13", "penta15", "hex20", "tri6", "quad8"},
                                     {"tet10", "", "", "hex27", "tri6", "quad9"}};
    return types[nodes_.is_complete() ? 2 : nodes_.is_quadratic() ? 1 : 0][kind];
  }

  // It has no complete prisms and pyramids.
  void check_cells() const {
    if (nodes_.is_complete() && !(mesh_.prisms.empty() && mesh_.pyramids.empty()))
      refuse(file_.name(), "FEBio has no prisms of 18 and pyramids of 14 nodes",
             "leave --order-2-complete away, or choose --type hexahedral");
  }

  void name_blocks() {
    region_names_ = region_names_in_file(mesh_, Mesh_format::febio);
    std::set<std::string> used;
    for (const auto& n : region_names_)
      used.insert(n.second);
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const std::string& region = region_names_.at(blocks_[b].region);
      const bool is_first = order_.is_first_of_region(b);
      block_names_.push_back(is_first ? region : unused_name(region + '_' + type_of(blocks_[b].kind), used));
      used.insert(block_names_.back());
    }
  }

  // "1,2,3</tag>"
  void write_nodes(const Element_nodes& nodes, const char* end) {
    for (std::size_t k = 0; k < nodes.size; ++k)
      out_ << nodes[k] + std::size_t(1) << (k + 1 == nodes.size ? end : ",");
  }

  void write_nodes() {
    out_ << "<Nodes name=\"nodes\">\n";
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const Point_3& p = nodes_.point(i);
      out_ << "<node id=\"" << i + 1 << "\">" << p.x() << ',' << p.y() << ',' << p.z() << "</node>\n";
    }
    out_ << "</Nodes>\n";
  }

  void write_elements() {
    std::size_t id = 0;
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      out_ << "<Elements type=\"" << type_of(blocks_[b].kind) << "\" name=\"" << escaped_for_xml(block_names_[b])
           << "\">\n";
      for (std::size_t p = order_.first_place(b); p < order_.first_place(b + 1); ++p) {
        out_ << "<elem id=\"" << ++id << "\">";
        write_nodes(nodes_.of_cell(cells_, listed_[p], febio_order), "</elem>\n");
      }
      out_ << "</Elements>\n";
    }
  }

  void write_patches() {
    const Label_names names = patch_names_in_file(mesh_, Mesh_format::febio);
    for (const auto& patch : facets_by_patch(facets_)) {
      const std::string name = escaped_for_xml(names.at(patch.first));
      std::vector<std::uint32_t> nodes;
      out_ << "<Surface name=\"" << name << "\">\n";
      std::size_t id = 0;
      for (std::uint32_t f : patch.second) {
        const Facet_sides::Sides sides = facets_.sides(f);
        const Face corners = facets_.face(sides[1].is_there() ? sides[1] : sides[0]);
        const Element_nodes of_facet = nodes_.of_face(corners, febio_order);
        nodes.insert(nodes.end(), of_facet.begin(), of_facet.end());
        const std::string type = type_of(number_of_corners(corners) == 3 ? 4 : 5);
        out_ << "<" << type << " id=\"" << ++id << "\">";
        write_nodes(of_facet, "</");
        out_ << type << ">\n";
      }
      out_ << "</Surface>\n<NodeSet name=\"" << name << "\">\n";
      std::sort(nodes.begin(), nodes.end());
      nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
      for (std::size_t i = 0; i < nodes.size(); ++i)
        out_ << nodes[i] + std::size_t(1) << (i + 1 == nodes.size() ? "\n" : i % 16 == 15 ? ",\n" : ",");
      out_ << "</NodeSet>\n";
    }
  }

  void write_domains() {
    out_ << "<MeshDomains>\n";
    for (std::size_t b = 0; b < blocks_.size(); ++b)
      out_ << "<SolidDomain name=\"" << escaped_for_xml(block_names_[b]) << "\" mat=\""
           << escaped_for_xml(region_names_.at(blocks_[b].region)) << "\"/>\n";
    out_ << "</MeshDomains>\n";
  }

  void write_cell_arrays() {
    const std::vector<Cell_array>& arrays = nodes_.cell_arrays();
    if (arrays.empty())
      return;
    out_ << "<MeshData>\n";
    for (std::size_t b = 0; b < blocks_.size() && fibres_.are_there(); ++b)
      write_axes(b);
    for (const Cell_array& a : arrays)
      for (std::size_t b = 0; b < blocks_.size() && !fibres_.contain(a); ++b)
        write_values(a, b);
    out_ << "</MeshData>\n";
  }

  // Axes of the material, element by element; of the wall: elsewhere there are none.
  void write_axes(std::size_t block) {
    const std::size_t first = order_.first_place(block), end = order_.first_place(block + 1);
    std::size_t p = first;
    while (p < end && !fibres_.has(listed_[p]))
      ++p;
    if (p == end)
      return;
    out_ << "<ElementData type=\"mat_axis\" elem_set=\"" << escaped_for_xml(block_names_[block]) << "\">\n";
    for (; p < end; ++p) {
      const std::uint32_t c = listed_[p];
      if (!fibres_.has(c))
        continue;
      out_ << "<elem lid=\"" << p - first + 1 << "\"><a>";
      write_numbers(fibres_.circumferential(c), 3, "</a><d>");
      write_numbers(fibres_.longitudinal(c), 3, "</d></elem>\n");
    }
    out_ << "</ElementData>\n";
  }

  // FEBio joins maps of one name.
  void write_values(const Cell_array& a, std::size_t block) {
    out_ << "<ElementData name=\"" << escaped_for_xml(a.name) << "\" data_type=\""
         << (a.components == 3 ? "vec3" : "scalar") << "\" elem_set=\"" << escaped_for_xml(block_names_[block])
         << "\">\n";
    const std::size_t n = std::size_t(a.components), first = order_.first_place(block);
    for (std::size_t p = first; p < order_.first_place(block + 1); ++p) {
      out_ << "<elem lid=\"" << p - first + 1 << "\">";
      write_numbers(&a.values[n * listed_[p]], n, "</elem>\n");
    }
    out_ << "</ElementData>\n";
  }

  void write_numbers(const double* numbers, std::size_t n, const char* end) {
    for (std::size_t k = 0; k < n; ++k)
      out_ << numbers[k] << (k + 1 == n ? end : ",");
  }

  Output_file& file_;
  Number_writer out_;
  const Mesh_nodes nodes_;
  const Mixed_mesh& mesh_;
  const Numbered_cells cells_;
  const Facet_sides facets_;
  const Cells_by_region order_;
  const Cells_by_region::Listed listed_;
  const std::vector<Cells_of_region>& blocks_;
  const Fibre_directions fibres_;
  Label_names region_names_;
  std::vector<std::string> block_names_;
};

} // namespace internal

namespace internal {

CGAL_TUBULAR_MESHING_INLINE void write_febio(Output_file& file, const Mesh_nodes& nodes) {
  check_mesh(nodes.mesh(), file.name());
  Febio_writer(file, nodes).write();
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE void write_febio(Output_file& file, const Mixed_mesh& mesh) {
  internal::write_febio(file, mesh);
}

CGAL_TUBULAR_MESHING_INLINE void write_febio(const std::string& file, const Mixed_mesh& mesh) {
  Output_file out(file);
  write_febio(out, mesh);
  out.commit();
}

} // namespace CGAL::Tubular_meshing::IO

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_FEBIO_IMPL_H
