// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_SVMULTIPHYSICS_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_SVMULTIPHYSICS_IMPL_H

#include <CGAL/Tubular_meshing/IO/internal/Facet_sides.h>
#include <CGAL/Tubular_meshing/IO/internal/Mesh_nodes.h>
#include <CGAL/Tubular_meshing/IO/internal/Used_points.h>
#include <CGAL/Tubular_meshing/IO/internal/Vtk_xml_writer.h>
#include <CGAL/Tubular_meshing/IO/internal/Wall_patches.h>
#include <CGAL/Tubular_meshing/IO/internal/check_mesh.h>
#include <CGAL/Tubular_meshing/IO/internal/names_in_files.h>
#include <CGAL/Tubular_meshing/IO/internal/name_fields.h>
#include <CGAL/Tubular_meshing/IO/internal/One_kind.h>
#include <CGAL/Tubular_meshing/IO/internal/refuse.h>
#include <CGAL/Tubular_meshing/IO/internal/region_folders.h>
#include <CGAL/Tubular_meshing/IO/internal/write_nodes.h>
#include <CGAL/Tubular_meshing/IO/internal/write_vtu.h>
#include <CGAL/Tubular_meshing/IO/write_svmultiphysics.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO {

namespace internal {

class Svmultiphysics_writer {
public:
  Svmultiphysics_writer(Output_folder& folder, const Mesh_nodes& nodes)
      : folder_(folder)
      , nodes_(nodes)
      , mesh_(nodes.mesh())
      , cells_(mesh_)
      , facets_(cells_, folder.name())
      , walls_(cells_, facets_)
      , file_names_(patch_names_in_file(mesh_, Mesh_format::svmultiphysics))
      , model_face_(model_faces())
      , local_(nodes.size(), no_vertex) {}

  void write() {
    const std::set<int> regions = labels_of(mesh_, 3);
    if (regions.empty())
      refuse(folder_.name(), "its format is for meshes with cells, and this one has none", write_vtu_instead);
    check_cells(regions);
    for (const auto& folder : region_folders(mesh_))
      write_region(folder.first, regions.size() == 1 ? "" : folder.second + '/');
  }

private:
  typedef Facet_sides::Side Side;
  typedef std::vector<const Side*> Sides;
  typedef std::map<int, Sides> Patches;

  // The numbers that the input had, each once; another patch's is its label, where that is not taken.
  std::map<int, std::int32_t> model_faces() const {
    std::map<int, std::int32_t> result;
    std::set<std::int32_t> used;
    const std::set<int> labels = labels_of(mesh_, 2);
    if (mesh_.patch_ids.array == "ModelFaceID")
      for (int l : labels) {
        const auto id = mesh_.patch_ids.id.find(l);
        if (id != mesh_.patch_ids.id.end() && used.insert(id->second).second)
          result[l] = id->second;
      }
    for (int l : labels) {
      if (result.count(l) != 0)
        continue;
      std::int32_t id = l;
      while (!used.insert(id).second)
        ++id;
      result[l] = id;
    }
    return result;
  }

  void check_cells(const std::set<int>& regions) const {
    const One_kind one_kind(cells_, folder_.name(), "svMultiPhysics");
    for (int r : regions)
      one_kind.check_region(r, region_names_in_file(mesh_, Mesh_format::vtu).at(r), {true, false, true, true});
    if (nodes_.is_quadratic() && !mesh_.prisms.empty())
      refuse(folder_.name(), "svMultiPhysics has no quadratic prisms",
             "choose --wall-elements tetrahedra or --type hexahedral, or leave --order 2 away");
    std::map<int, std::size_t> corners;
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      const Facet_sides::Sides& s = facets_.sides(f);
      if (s[1].is_there() && cells_.region(s[0].cell) == cells_.region(s[1].cell))
        refuse(folder_.name(),
               "its patch \"" + file_names_.at(facets_.label(f)) +
                   "\" lies inside of a region, and its format has patches around regions only",
               write_vtu_instead);
      const std::size_t n = number_of_corners(facets_.face(s[0]));
      if (corners.emplace(facets_.label(f), n).first->second != n)
        refuse(folder_.name(),
               "its patch \"" + file_names_.at(facets_.label(f)) +
                   "\" has triangles and quads, and svMultiPhysics takes one kind a face",
               "make the mesh with --type isotropic, anisotropic or hexahedral");
    }
  }

  void write_region(int region, const std::string& path) {
    const Used_points points(nodes_, [&](int r) { return r == region; });
    const std::vector<std::uint32_t> number = write_cells(region, points, path);
    Patches patches;
    for (std::size_t f = 0; f < facets_.size(); ++f)
      for (const Side& s : facets_.sides(f))
        if (s.is_there() && cells_.region(s.cell) == region)
          patches[facets_.label(f)].push_back(&s);
    Patches walls;
    for (const auto& p : patches) {
      write_facets(path + "mesh-surfaces/" + file_names_.at(p.first) + ".vtp", {p}, points, number);
      if (walls_.contain(p.first))
        walls.insert(p);
    }
    write_facets(path + "mesh-complete.exterior.vtp", patches, points, number);
    if (!walls.empty())
      write_facets(path + "walls_combined.vtp", walls, points, number);
  }

  // Returns the number of each cell in the region.
  std::vector<std::uint32_t> write_cells(int region, const Used_points& points, const std::string& path) {
    const std::vector<std::uint32_t> number = write_cells(region, points, path + "mesh-complete.mesh.vtu", nullptr);
    for (const Cell_array& a : nodes_.cell_arrays())
      if (a.components == 3 && has_values(a, region))
        write_cells(region, points, path + "fibers-" + as_file_name(a.name) + ".vtu", &a);
    return number;
  }

  bool has_values(const Cell_array& array, int region) const {
    for (std::size_t c = 0; c < cells_.size(); ++c)
      if (cells_.region(c) == region)
        for (std::size_t k = 0; k < 3; ++k)
          if (array.values[3 * c + k] != 0)
            return true;
    return false;
  }

  // The mesh itself, or directions of fibres in its cells, which svMultiPhysics reads from a file for each family.
  std::vector<std::uint32_t> write_cells(int region, const Used_points& points, const std::string& file,
                                         const Cell_array* fibres) {
    std::vector<std::uint32_t> number(cells_.size());
    std::uint32_t size = 0;
    std::size_t first = no_cell;
    for (std::size_t c = 0; c < cells_.size(); ++c)
      if (cells_.region(c) == region) {
        first = (std::min)(first, c);
        number[c] = size++;
      }
    const std::size_t nodes = nodes_.number(cells_.kind(first));
    const auto vtk_type = static_cast<std::uint8_t>(vtk_type_of(nodes_, cells_.kind(first)));

    Vtk_xml_writer out("UnstructuredGrid");
    write_names(out, {}, mesh_.region_names, {region});
    out.begin("Piece NumberOfPoints=\"" + std::to_string(points.size()) + "\" NumberOfCells=\"" + std::to_string(size) +
              "\"");
    out.begin("PointData");
    std::int32_t id = 0;
    out.array_of<std::int32_t>("GlobalNodeID", 1, points.size(), [&] { return ++id; });
    out.end("PointData");
    out.begin("CellData");
    id = 0;
    out.array_of<std::int32_t>("GlobalElementID", 1, size, [&] { return ++id; });
    out.array_of<std::int32_t>("ModelRegionID", 1, size, [&] { return region; });
    if (fibres != nullptr)
      out.array("FIB_DIR", 3, values_in(region, *fibres));
    out.end("CellData");
    write_points(out, points);
    out.begin("Cells");
    std::size_t cell = first, node = 0;
    Element_nodes of_cell = nodes_.of_cell(cells_, first, vtk_order);
    out.array_of<std::int32_t>("connectivity", 1, size * nodes, [&] {
      if (node == nodes) {
        node = 0;
        do
          ++cell;
        while (cells_.region(cell) != region);
        of_cell = nodes_.of_cell(cells_, cell, vtk_order);
      }
      return std::int32_t(points.number(of_cell[node++]));
    });
    std::int64_t end = 0;
    out.array_of<std::int64_t>("offsets", 1, size, [&] { return end += std::int64_t(nodes); });
    out.array_of<std::uint8_t>("types", 1, size, [&] { return vtk_type; });
    out.end("Cells");
    out.end("Piece");
    out.write(folder_.file(file));
    return number;
  }

  std::vector<double> values_in(int region, const Cell_array& array) const {
    std::vector<double> values;
    for (std::size_t c = 0; c < cells_.size(); ++c)
      if (cells_.region(c) == region)
        values.insert(values.end(), array.values.begin() + std::ptrdiff_t(3 * c),
                      array.values.begin() + std::ptrdiff_t(3 * c + 3));
    return values;
  }

  void write_points(Vtk_xml_writer& out, const Used_points& points) const {
    out.begin("Points");
    std::size_t point = 0;
    int k = 0;
    out.array_of<double>("Points", 3, 3 * points.size(), [&] {
      while (!points.contain(point))
        ++point;
      const double x = nodes_.point(point)[k];
      if (++k == 3) {
        k = 0;
        ++point;
      }
      return x;
    });
    out.end("Points");
  }

  static void write_names(Vtk_xml_writer& out, const Label_names& patches, const Label_names& regions,
                          const std::set<int>& labels) {
    const auto those = [&](const Label_names& names) {
      Label_names result;
      for (const auto& n : names)
        if (labels.count(n.first) != 0)
          result.insert(n);
      return result;
    };
    const auto fields = name_fields(those(patches), those(regions));
    if (fields.empty())
      return;
    out.begin("FieldData");
    for (const auto& f : fields)
      out.array(f.first, 0, f.second);
    out.end("FieldData");
  }

  void write_facets(const std::string& file, const Patches& patches, const Used_points& points,
                    const std::vector<std::uint32_t>& number) {
    std::vector<std::uint32_t> used; // points of the mesh, as they come
    std::vector<std::int32_t> elements, model_faces;
    std::vector<std::int64_t> corners, ends;
    std::set<int> labels;
    for (const auto& p : patches) {
      labels.insert(p.first);
      for (const Side* s : p.second) {
        const Face face = facets_.face(*s);
        for (std::uint32_t v : nodes_.of_face(face, vtk_order))
          corners.push_back(v);
        ends.push_back(std::int64_t(corners.size()));
        elements.push_back(std::int32_t(number[s->cell] + 1));
        model_faces.push_back(model_face_.at(p.first));
      }
    }
    for (std::int64_t& c : corners) {
      const auto v = std::uint32_t(c);
      if (local_[v] == no_vertex) {
        local_[v] = std::uint32_t(used.size());
        used.push_back(v);
      }
      c = local_[v];
    }
    std::vector<std::int32_t> nodes;
    std::vector<double> xyz;
    for (std::uint32_t v : used) {
      local_[v] = no_vertex;
      nodes.push_back(std::int32_t(points.number(v) + 1));
      for (int k = 0; k < 3; ++k)
        xyz.push_back(nodes_.point(v)[k]);
    }

    Vtk_xml_writer out("PolyData");
    write_names(out, mesh_.patch_names, {}, labels);
    out.begin("Piece NumberOfPoints=\"" + std::to_string(used.size()) +
              "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
              std::to_string(ends.size()) + "\"");
    out.begin("PointData");
    out.array("GlobalNodeID", 1, nodes);
    out.end("PointData");
    out.begin("CellData");
    out.array("GlobalElementID", 1, elements);
    out.array("ModelFaceID", 1, model_faces);
    out.end("CellData");
    out.begin("Points");
    out.array("Points", 3, xyz);
    out.end("Points");
    out.begin("Polys");
    out.array("connectivity", 1, corners);
    out.array("offsets", 1, ends);
    out.end("Polys");
    out.end("Piece");
    out.write(folder_.file(file));
  }

  Output_folder& folder_;
  const Mesh_nodes nodes_;
  const Mixed_mesh& mesh_;
  const Numbered_cells cells_;
  const Facet_sides facets_;
  const Wall_patches walls_;
  const Label_names file_names_;
  const std::map<int, std::int32_t> model_face_;
  std::vector<std::uint32_t> local_; // of points on the file that is written, where they are there
};

inline bool belongs_to_svmultiphysics(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  return name == "mesh-complete.mesh.vtu" || name == "mesh-complete.exterior.vtp" || name == "walls_combined.vtp" ||
         (name.rfind("fibers-", 0) == 0 && file.extension() == ".vtu") ||
         (file.parent_path().filename() == "mesh-surfaces" && file.extension() == ".vtp");
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Output_folder svmultiphysics_folder(const std::string& folder) {
  return Output_folder(folder, &internal::belongs_to_svmultiphysics);
}

namespace internal {

CGAL_TUBULAR_MESHING_INLINE void write_svmultiphysics(Output_folder& folder, const Mesh_nodes& nodes) {
  check_mesh(nodes.mesh(), folder.name());
  Svmultiphysics_writer(folder, nodes).write();
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE void write_svmultiphysics(Output_folder& folder, const Mixed_mesh& mesh) {
  internal::write_svmultiphysics(folder, mesh);
}

CGAL_TUBULAR_MESHING_INLINE void write_svmultiphysics(const std::string& folder, const Mixed_mesh& mesh) {
  Output_folder out = svmultiphysics_folder(folder);
  write_svmultiphysics(out, mesh);
  out.commit();
}

} // namespace CGAL::Tubular_meshing::IO

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_SVMULTIPHYSICS_IMPL_H
