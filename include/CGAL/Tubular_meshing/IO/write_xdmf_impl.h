// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_XDMF_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_XDMF_IMPL_H

#include <CGAL/Tubular_meshing/IO/Mesh_format.h>
#include <CGAL/Tubular_meshing/IO/internal/Facet_sides.h>
#include <CGAL/Tubular_meshing/IO/internal/Mesh_nodes.h>
#include <CGAL/Tubular_meshing/IO/internal/Hdf5_writer.h>
#include <CGAL/Tubular_meshing/IO/internal/Number_writer.h>
#include <CGAL/Tubular_meshing/IO/internal/One_kind.h>
#include <CGAL/Tubular_meshing/IO/internal/Used_points.h>
#include <CGAL/Tubular_meshing/IO/internal/Vtk_xml_writer.h>
#include <CGAL/Tubular_meshing/IO/internal/check_mesh.h>
#include <CGAL/Tubular_meshing/IO/internal/refuse.h>
#include <CGAL/Tubular_meshing/IO/internal/write_nodes.h>
#include <CGAL/Tubular_meshing/IO/write_xdmf.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace CGAL::Tubular_meshing::IO {

namespace internal {

#ifdef CGAL_TUBULAR_MESHING_WITH_HDF5

class Xdmf_writer {
public:
  Xdmf_writer(Output_file& file, const Mesh_nodes& nodes)
      : file_(file)
      , out_(file)
      , nodes_(nodes)
      , mesh_(nodes.mesh())
      , cells_(mesh_)
      , facets_(cells_, file.name())
      , points_(nodes, &any_region)
      , numbers_name_(std::filesystem::path(file.name()).replace_extension(".h5").string())
      , nodes_of_cell_(nodes.number(mesh_.hexahedra.empty() ? 0 : 3))
      , nodes_of_facet_(nodes.number(mesh_.hexahedra.empty() ? 4 : 5)) {}

  void write() {
    if (cells_.size() == 0)
      refuse(file_.name(), "its format is for meshes with cells, and this one has none", write_vtu_instead);
    if (file_.is_direct())
      refuse(file_.name(), "its numbers go into a second file beside it", "give the name of a regular file");
    One_kind(cells_, file_.name(), "FEniCSx").check_mesh({true, false, false, true});
    if (nodes_.is_quadratic() && !nodes_.is_complete() && !mesh_.hexahedra.empty())
      refuse(file_.name(), "FEniCSx has no hexahedra of 20 nodes, but of 27", "add --order-2-complete");
    const std::string base = std::filesystem::path(numbers_name_).filename().string();
    if (base.find(':') != std::string::npos)
      refuse(file_.name(), "a colon in its name is taken for the end of it", "give a name without one");
    write_numbers();
    write_grids(escaped_for_xml(base));
  }

private:
  void write_numbers() {
    Hdf5_writer out(file_.companion(numbers_name_));
    std::size_t i = 0, k = 0;
    out.table<double>("/geometry", points_.size(), 3, [&] {
      while (!points_.contain(i))
        ++i;
      const double x = nodes_.point(i)[int(k)];
      if (++k == 3) {
        k = 0;
        ++i;
      }
      return x;
    });
    write_elements(out, "/cells", cells_.size(), nodes_of_cell_,
                   [&](std::size_t c) { return nodes_.of_cell(cells_, c, vtk_order); });
    i = 0;
    out.table<std::int32_t>("/regions", cells_.size(), 1, [&] { return cells_.region(i++); });
    for (std::size_t a = 0; a < nodes_.cell_arrays().size(); ++a) {
      const Cell_array& array = nodes_.cell_arrays()[a];
      i = 0;
      out.table<double>(path_of_array(a).c_str(), cells_.size(), std::size_t(array.components),
                        [&] { return array.values[i++]; });
    }
    if (facets_.size() > 0) {
      write_elements(out, "/facets", facets_.size(), nodes_of_facet_,
                     [&](std::size_t f) { return nodes_.of_face(facets_.face(facets_.sides(f)[0]), vtk_order); });
      i = 0;
      out.table<std::int32_t>("/patches", facets_.size(), 1, [&] { return facets_.label(i++); });
    }
    out.close();
  }

  template <class Nodes>
  void write_elements(Hdf5_writer& out, const char* path, std::size_t rows, std::size_t columns,
                      const Nodes& nodes_of) {
    std::size_t i = 0, k = columns;
    Element_nodes nodes;
    out.table<std::int32_t>(path, rows, columns, [&] {
      if (k == columns) {
        k = 0;
        nodes = nodes_of(i++);
      }
      return std::int32_t(points_.number(nodes[k++]));
    });
  }

  static std::string path_of_array(std::size_t array) { return "/cell_array_" + std::to_string(array); }

  static const char* name_of(std::size_t nodes_of_cell, bool is_facet) {
    switch (nodes_of_cell) {
    case 4:
      return is_facet ? "Quadrilateral" : "Tetrahedron";
    case 3:
      return "Triangle";
    case 6:
      return "Triangle_6";
    case 8:
      return "Hexahedron";
    case 9:
      return "Quadrilateral_9";
    case 10:
      return "Tetrahedron_10";
    default:
      return "Hexahedron_27";
    }
  }

  void write_grids(const std::string& numbers) {
    const char* const cell = name_of(nodes_of_cell_, false);
    out_ << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n";
    begin_grid(numbers, "mesh", cell, "/cells", cells_.size(), nodes_of_cell_);
    for (std::size_t a = 0; a < nodes_.cell_arrays().size(); ++a) {
      const Cell_array& array = nodes_.cell_arrays()[a];
      out_ << "<Attribute Name=\"" << escaped_for_xml(array.name) << "\" AttributeType=\""
           << (array.components == 3   ? "Vector"
               : array.components == 1 ? "Scalar"
                                       : "Matrix")
           << "\" Center=\"Cell\">\n";
      write_item(numbers, cells_.size(), std::size_t(array.components), true, path_of_array(a).c_str());
      out_ << "</Attribute>\n";
    }
    end_grid();
    begin_grid(numbers, "cell_tags", cell, "/cells", cells_.size(), nodes_of_cell_);
    write_tags(numbers, "cell_tags", "/regions", cells_.size(), mesh_.region_names);
    end_grid();
    if (facets_.size() > 0) {
      begin_grid(numbers, "facet_tags", name_of(nodes_of_facet_, true), "/facets", facets_.size(), nodes_of_facet_);
      write_tags(numbers, "facet_tags", "/patches", facets_.size(), mesh_.patch_names);
      end_grid();
    }
    out_ << "</Domain>\n</Xdmf>\n";
    out_.flush();
  }

  void write_item(const std::string& numbers, std::size_t rows, std::size_t columns, bool is_float, const char* path) {
    out_ << "<DataItem Dimensions=\"" << rows;
    if (columns > 1)
      out_ << ' ' << columns;
    out_ << "\" NumberType=\"" << (is_float ? "Float\" Precision=\"8" : "Int\" Precision=\"4") << "\" Format=\"HDF\">"
         << numbers << ':' << path << "</DataItem>\n";
  }

  void begin_grid(const std::string& numbers, const char* name, const char* kind, const char* path, std::size_t rows,
                  std::size_t columns) {
    out_ << "<Grid Name=\"" << name << "\" GridType=\"Uniform\">\n<Topology TopologyType=\"" << kind
         << "\" NumberOfElements=\"" << rows << "\" NodesPerElement=\"" << columns << "\">\n";
    write_item(numbers, rows, columns, false, path);
    out_ << "</Topology>\n<Geometry GeometryType=\"XYZ\">\n";
    write_item(numbers, points_.size(), 3, true, "/geometry");
    out_ << "</Geometry>\n";
  }

  void write_tags(const std::string& numbers, const char* name, const char* path, std::size_t rows,
                  const Label_names& names) {
    out_ << "<Attribute Name=\"" << name << "\" AttributeType=\"Scalar\" Center=\"Cell\">\n";
    write_item(numbers, rows, 1, false, path);
    out_ << "</Attribute>\n";
    for (const auto& n : names)
      out_ << "<Information Name=\"" << escaped_for_xml(n.second) << "\" Value=\"" << n.first << "\"/>\n";
  }

  void end_grid() { out_ << "</Grid>\n"; }

  Output_file& file_;
  Number_writer out_;
  const Mesh_nodes nodes_;
  const Mixed_mesh& mesh_;
  const Numbered_cells cells_;
  const Facet_sides facets_;
  const Used_points points_;
  const std::string numbers_name_;
  const std::size_t nodes_of_cell_, nodes_of_facet_;
};

#endif // CGAL_TUBULAR_MESHING_WITH_HDF5

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE bool has_hdf5() {
#ifdef CGAL_TUBULAR_MESHING_WITH_HDF5
  return true;
#else
  return false;
#endif
}

namespace internal {

CGAL_TUBULAR_MESHING_INLINE void write_xdmf(Output_file& file, const Mesh_nodes& nodes) {
  check_mesh(nodes.mesh(), file.name());
#ifdef CGAL_TUBULAR_MESHING_WITH_HDF5
  Xdmf_writer(file, nodes).write();
#else
  throw Output_error(why_not_built_in(Mesh_format::xdmf));
#endif
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE void write_xdmf(Output_file& file, const Mixed_mesh& mesh) {
  internal::write_xdmf(file, mesh);
}

CGAL_TUBULAR_MESHING_INLINE void write_xdmf(const std::string& file, const Mixed_mesh& mesh) {
  Output_file out(file);
  write_xdmf(out, mesh);
  out.commit();
}

} // namespace CGAL::Tubular_meshing::IO

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_XDMF_IMPL_H
