// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_SVMULTIPHYSICS_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_SVMULTIPHYSICS_IMPL_H

#include <CGAL/Tubular_meshing/IO/internal/Cells_by_region.h>
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
#include <memory>
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
      , order_(cells_)
      , number_(order_.numbers())
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
  typedef Vtk_xml_writer::Shared Shared;

  // The facets of a patch among those of a region.
  struct Patch {
    int label;
    std::size_t first, end;           // facets
    std::size_t first_node, end_node; // of all facets
  };
  typedef std::vector<Patch> Patches; // by their labels

  // By patch: the nodes of each, and the number of the cell that it bounds, from 1.
  struct Region_facets {
    std::vector<std::uint32_t> nodes, cells;
    Patches patches;
  };

  // A file of facets before it is written: what begins with the same patches begins with the same values.
  struct Facets_file {
    Facets_file(const Patches& facets, const std::shared_ptr<Window_packer>& packer)
        : patches(facets)
        , out("PolyData", packer) {}
    const Patches& patches;
    std::vector<std::size_t> points; // of the first patch, of the first two, and so on
    Vtk_xml_writer out;
  };

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
      const Facet_sides::Sides s = facets_.sides(f);
      if (s[1].is_there() && cells_.region(s[0].cell) == cells_.region(s[1].cell))
        refuse(folder_.name(),
               "its patch \"" + file_names_.at(facets_.label(f)) +
                   "\" lies inside of a region, and its format has patches around regions only",
               write_vtu_instead);
      const std::size_t n = facets_.corners_of_facet(f);
      if (f > 0 && facets_.label(f) == facets_.label(f - 1) && n == facets_.corners_of_facet(f - 1))
        continue;
      if (corners.emplace(facets_.label(f), n).first->second != n)
        refuse(folder_.name(),
               "its patch \"" + file_names_.at(facets_.label(f)) +
                   "\" has triangles and quads, and svMultiPhysics takes one kind a face",
               "make the mesh with --type isotropic, anisotropic or hexahedral");
    }
  }

  /* Most facets are in three files, one patch alone, walls_combined and the whole boundary, and compressing them is most
   * of the work: so that of the boundary is made first, and the others copy what they share with it. */
  void write_region(int region, const std::string& path) {
    const Used_points points(nodes_, [&](int r) { return r == region; });
    write_cells(region, points, path);
    const Region_facets facets = facets_of(region);
    Patches walls;
    for (const Patch& p : facets.patches)
      if (walls_.contain(p.label))
        walls.push_back(p);
    Facets_file boundary(facets.patches, packer_);
    make_facets(boundary, facets, points, nullptr);
    const auto write_part = [&](const Patches& part, const std::vector<std::string>& names) {
      Facets_file file(part, packer_);
      make_facets(file, facets, points, &boundary);
      for (const std::string& name : names)
        file.out.write(folder_.file(path + name));
    };
    const std::string walls_combined = "walls_combined.vtp";
    for (const Patch& p : facets.patches) {
      std::vector<std::string> names = {"mesh-surfaces/" + file_names_.at(p.label) + ".vtp"};
      if (walls.size() == 1 && walls.front().label == p.label)
        names.push_back(walls_combined);
      write_part({p}, names);
    }
    if (walls.size() > 1)
      write_part(walls, {walls_combined});
    boundary.out.write(folder_.file(path + "mesh-complete.exterior.vtp"));
  }

  Region_facets facets_of(int region) const {
    Region_facets result;
    const std::size_t first_place = order_.first_place(block_of(region));
    result.cells.reserve(facets_.size());
    result.nodes.reserve(facets_.size() * (facets_.size() == 0 ? 0 : nodes_of_facet(0)));
    for (const auto& p : facets_by_patch(facets_)) {
      Patch patch{p.first, result.cells.size(), 0, result.nodes.size(), 0};
      for (std::uint32_t f : p.second)
        for (const Side& s : facets_.sides(f)) {
          if (!s.is_there() || cells_.region(s.cell) != region)
            continue;
          result.cells.push_back(std::uint32_t(number_[s.cell] - first_place + 1));
          const Face face = facets_.face(s);
          nodes_.for_each_of(facets_.corners_of_facet(f) == 3 ? 4 : 5, face.data(), 0, vtk_order,
                             [&](std::uint32_t v) { result.nodes.push_back(v); });
        }
      patch.end = result.cells.size();
      patch.end_node = result.nodes.size();
      if (patch.end > patch.first)
        result.patches.push_back(patch);
    }
    return result;
  }

  void write_cells(int region, const Used_points& points, const std::string& path) {
    write_cells(region, points, path + "mesh-complete.mesh.vtu", nullptr);
    for (const Cell_array& a : nodes_.cell_arrays())
      if (a.components == 3 && has_values(a, region))
        write_cells(region, points, path + "fibers-" + as_file_name(a.name) + ".vtu", &a);
  }

  bool has_values(const Cell_array& array, int region) const {
    for (std::size_t c = 0; c < cells_.size(); ++c)
      if (cells_.region(c) == region)
        for (std::size_t k = 0; k < 3; ++k)
          if (array.values[3 * c + k] != 0)
            return true;
    return false;
  }

  // The cells of a region, of which all are of one kind.
  std::size_t block_of(int region) const {
    std::size_t b = 0;
    while (order_.blocks()[b].region != region)
      ++b;
    return b;
  }

  // Calls f(cell) for those of a region, in order.
  template <class F> void for_each_cell_of(int region, F f) const {
    const std::size_t kind = order_.blocks()[block_of(region)].kind;
    for (std::size_t c = cells_.first_cell(kind); c < cells_.first_cell(kind + 1); ++c)
      if (cells_.region(c) == region)
        f(c);
  }

  // The mesh itself, or directions of fibres in its cells, which svMultiPhysics reads from a file for each family.
  void write_cells(int region, const Used_points& points, const std::string& file, const Cell_array* fibres) {
    const Cells_of_region& block = order_.blocks()[block_of(region)];
    const std::size_t size = block.size, nodes = nodes_.number(block.kind);
    const auto vtk_type = static_cast<std::uint8_t>(vtk_type_of(nodes_, block.kind));

    Vtk_xml_writer out("UnstructuredGrid", packer_);
    write_names(out, {}, mesh_.region_names, {region});
    out.begin("Piece NumberOfPoints=\"" + std::to_string(points.size()) + "\" NumberOfCells=\"" + std::to_string(size) +
              "\"");
    out.begin("PointData");
    std::int32_t id = 0;
    out.array_of<std::int32_t>("GlobalNodeID", 1, points.size(), [&] { return ++id; });
    out.end("PointData");
    out.begin("CellData");
    id = 0;
    out.array_of<std::int32_t>("GlobalElementID", 1, size, [&] { return ++id; }, {&out, "GlobalNodeID", points.size()});
    out.array_of<std::int32_t>("ModelRegionID", 1, size, [&] { return region; });
    if (fibres != nullptr)
      out.array_made<double>("FIB_DIR", 3, 3 * size, [&](const auto& put) {
        for_each_cell_of(region, [&](std::size_t c) {
          for (std::size_t k = 0; k < 3; ++k)
            put(fibres->values[3 * c + k]);
        });
      });
    out.end("CellData");
    write_points(out, points);
    out.begin("Cells");
    out.array_made<std::int32_t>("connectivity", 1, size * nodes, [&](const auto& put) {
      for_each_block(mesh_, [&](const auto& cells, const Element_kind& kind) {
        if (&kind == &element_kinds[block.kind])
          for (std::size_t i = 0; i < cells.size(); ++i)
            if (cells.label[i] == region)
              nodes_.for_each_of(block.kind, cells.vertices[i].data(), i, vtk_order,
                                 [&](std::uint32_t v) { put(std::int32_t(points.number(v))); });
      });
    });
    std::int64_t end = 0;
    out.array_of<std::int64_t>("offsets", 1, size, [&] { return end += std::int64_t(nodes); });
    out.array_of<std::uint8_t>("types", 1, size, [&] { return vtk_type; });
    out.end("Cells");
    out.end("Piece");
    out.write(folder_.file(file));
  }

  void write_points(Vtk_xml_writer& out, const Used_points& points) const {
    out.begin("Points");
    out.array_made<double>("Points", 3, 3 * points.size(), [&](const auto& put) {
      for (std::size_t i = 0; i < nodes_.size(); ++i)
        if (points.contain(i))
          put_point(i, put);
    });
    out.end("Points");
  }

  template <class Put> void put_point(std::size_t i, const Put& put) const {
    const Point_3& p = nodes_.point(i);
    put(p.x());
    put(p.y());
    put(p.z());
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

  std::size_t nodes_of_facet(std::size_t facet) const {
    return nodes_.number(facets_.corners_of_facet(facet) == 3 ? 4 : 5);
  }

  // The points of facets, each where it comes first; `local_` is where.
  std::vector<std::uint32_t> list_points(Facets_file& file, const Region_facets& facets) {
    std::vector<std::uint32_t> used;
    for (const Patch& p : file.patches) {
      for (std::size_t i = p.first_node; i < p.end_node; ++i) {
        const std::uint32_t v = facets.nodes[i];
        if (local_[v] == no_vertex) {
          local_[v] = std::uint32_t(used.size());
          used.push_back(v);
        }
      }
      file.points.push_back(used.size());
    }
    return used;
  }

  // How much a file has, or begins with that another one does, too.
  struct Size {
    std::size_t points = 0, facets = 0, nodes = 0;
  };
  static Size size_of(const Facets_file& file, std::size_t patches) {
    Size size;
    for (std::size_t i = 0; i < patches; ++i) {
      const Patch& p = file.patches[i];
      size = {file.points[i], size.facets + p.end - p.first, size.nodes + p.end_node - p.first_node};
    }
    return size;
  }
  static Size common_to(const Facets_file& file, const Facets_file& other) {
    std::size_t n = 0;
    while (n < file.patches.size() && n < other.patches.size() && file.patches[n].label == other.patches[n].label)
      ++n;
    return size_of(file, n);
  }

  // other: what is made already, and may have values of this one
  void make_facets(Facets_file& file, const Region_facets& facets, const Used_points& points,
                   const Facets_file* other) {
    const std::vector<std::uint32_t> used = list_points(file, facets);
    const Size size = size_of(file, file.patches.size());
    const Size common = other == nullptr ? Size() : common_to(file, *other);
    const auto shared = [&](const char* array, std::size_t values) {
      return Shared{other == nullptr ? nullptr : &other->out, array, values};
    };
    std::set<int> labels;
    for (const Patch& p : file.patches)
      labels.insert(p.label);

    Vtk_xml_writer& out = file.out;
    write_names(out, mesh_.patch_names, {}, labels);
    out.begin("Piece NumberOfPoints=\"" + std::to_string(size.points) +
              "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
              std::to_string(size.facets) + "\"");
    out.begin("PointData");
    out.array_made<std::int32_t>(
        "GlobalNodeID", 1, size.points,
        [&](const auto& put) {
          for (std::uint32_t v : used)
            put(std::int32_t(points.number(v) + 1));
        },
        shared("GlobalNodeID", common.points));
    out.end("PointData");
    out.begin("CellData");
    out.array_made<std::int32_t>(
        "GlobalElementID", 1, size.facets,
        [&](const auto& put) {
          for (const Patch& p : file.patches)
            for (std::size_t i = p.first; i < p.end; ++i)
              put(std::int32_t(facets.cells[i]));
        },
        shared("GlobalElementID", common.facets));
    out.array_made<std::int32_t>(
        "ModelFaceID", 1, size.facets,
        [&](const auto& put) {
          for (const Patch& p : file.patches) {
            const std::int32_t id = model_face_.at(p.label);
            for (std::size_t i = p.first; i < p.end; ++i)
              put(id);
          }
        },
        shared("ModelFaceID", common.facets));
    out.end("CellData");
    out.begin("Points");
    out.array_made<double>(
        "Points", 3, 3 * size.points,
        [&](const auto& put) {
          for (std::uint32_t v : used)
            put_point(v, put);
        },
        shared("Points", 3 * common.points));
    out.end("Points");
    out.begin("Polys");
    out.array_made<std::int64_t>(
        "connectivity", 1, size.nodes,
        [&](const auto& put) {
          for (const Patch& p : file.patches)
            for (std::size_t i = p.first_node; i < p.end_node; ++i)
              put(std::int64_t(local_[facets.nodes[i]]));
        },
        shared("connectivity", common.nodes));
    out.array_made<std::int64_t>(
        "offsets", 1, size.facets,
        [&](const auto& put) {
          std::int64_t end = 0;
          for (const Patch& p : file.patches) {
            const auto n =
                std::int64_t((p.end_node - p.first_node) / (p.end - p.first)); // of each, as they are of one kind
            for (std::size_t i = p.first; i < p.end; ++i)
              put(end += n);
          }
        },
        shared("offsets", common.facets));
    out.end("Polys");
    out.end("Piece");
    for (std::uint32_t v : used)
      local_[v] = no_vertex;
  }

  Output_folder& folder_;
  const Mesh_nodes nodes_;
  const Mixed_mesh& mesh_;
  const Numbered_cells cells_;
  const Facet_sides facets_;
  const Cells_by_region order_;
  const Cells_by_region::Numbers number_;
  const Wall_patches walls_;
  const Label_names file_names_;
  const std::map<int, std::int32_t> model_face_;
  const std::shared_ptr<Window_packer> packer_ = std::make_shared<Window_packer>();
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
