// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes for SU2 and FEBio, read back by readers of their own.

#include "solver_meshes.h"

#include <CGAL/Tubular_meshing/IO/write_febio.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_su2.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <pugixml.hpp>

#include <cstddef>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

struct Su2_zone {
  std::vector<Point> points;
  std::vector<std::pair<int, std::vector<std::size_t>>> cells; // type of VTK, corners in its order
  std::map<std::string, std::vector<std::vector<std::size_t>>> markers;
};

Point point_of(std::istream& in) {
  std::string x, y, z;
  in >> x >> y >> z;
  return Point(std::strtod(x.c_str(), nullptr), std::strtod(y.c_str(), nullptr), std::strtod(z.c_str(), nullptr));
}

std::vector<Su2_zone> read_su2(const std::string& text) {
  const std::map<int, std::size_t> corners = {{5, 3}, {9, 4}, {10, 4}, {12, 8}, {13, 6}, {14, 5}};
  std::istringstream in(text);
  std::vector<Su2_zone> zones;
  std::string word, tag;
  std::size_t n, announced = 1;
  while (in >> word) {
    if (word == "NZONE=") {
      in >> announced;
    } else if (word == "IZONE=") {
      in >> n;
      EXPECT_EQ(n, zones.size() + 1);
    } else if (word == "NDIME=") {
      in >> n;
      EXPECT_EQ(n, 3u);
      zones.emplace_back();
    } else if (word == "NELEM=") {
      in >> n;
      for (std::size_t i = 0, index; i < n; ++i) {
        int type;
        in >> type;
        std::vector<std::size_t> c(corners.at(type));
        for (std::size_t& v : c)
          in >> v;
        in >> index;
        EXPECT_EQ(index, i);
        zones.back().cells.emplace_back(type, c);
      }
    } else if (word == "NPOIN=") {
      in >> n;
      for (std::size_t i = 0, index; i < n; ++i) {
        zones.back().points.push_back(point_of(in));
        in >> index;
        EXPECT_EQ(index, i);
      }
    } else if (word == "NMARK=") {
      std::size_t markers;
      in >> markers;
      for (std::size_t m = 0; m < markers; ++m) {
        in >> word >> tag;
        EXPECT_EQ(word, "MARKER_TAG=");
        in >> word >> n;
        EXPECT_EQ(word, "MARKER_ELEMS=");
        auto& facets = zones.back().markers[tag];
        EXPECT_TRUE(facets.empty()) << tag;
        for (std::size_t i = 0; i < n; ++i) {
          int type;
          in >> type;
          facets.emplace_back(corners.at(type));
          for (std::size_t& v : facets.back())
            in >> v;
        }
      }
    } else {
      ADD_FAILURE() << word;
    }
  }
  EXPECT_EQ(zones.size(), announced);
  return zones;
}

// In the order of Mixed_mesh.
std::vector<std::size_t> corners_of(const std::pair<int, std::vector<std::size_t>>& cell) {
  const auto& c = cell.second;
  return cell.first == 13 ? std::vector<std::size_t>{c[0], c[2], c[1], c[3], c[5], c[4]} : c;
}

void expect_same(const Mesh& m, const std::vector<Su2_zone>& zones) {
  const Cells_of_regions expected = cells_of(m);
  const Faces_of_cells faces(m);
  const Point_finder find(m);
  ASSERT_EQ(zones.size(), expected.size());
  std::map<std::string, std::set<Corners>> markers;
  auto zone = zones.begin();
  for (const auto& region : expected) {
    std::vector<std::size_t> index; // in the mesh, of each point of the zone
    for (const Point& p : zone->points)
      index.push_back(find(p));
    std::vector<std::vector<std::size_t>> cells;
    for (const auto& c : zone->cells) {
      cells.emplace_back();
      for (std::size_t v : corners_of(c))
        cells.back().push_back(index.at(v));
    }
    EXPECT_EQ(cells, region.second);
    for (const auto& marker : zone->markers)
      for (auto loop : marker.second) {
        for (std::size_t& v : loop)
          v = index.at(v);
        expect_outward(faces, region.first, loop);
        EXPECT_TRUE(markers[marker.first].insert(Corners(loop.begin(), loop.end())).second);
      }
    ++zone;
  }
  // each patch is a marker; one between regions is two, which have the same facets
  std::map<int, std::set<Corners>> patches = facets_of(m);
  std::set<Corners> inside;
  for (const auto& marker : markers)
    if (marker.first.compare(0, 5, "wall_") == 0)
      inside.insert(marker.second.begin(), marker.second.end());
  EXPECT_EQ(inside.empty(), zones.size() == 1);
  for (const auto& patch : patches)
    EXPECT_EQ(markers.at(m.patch_names.at(patch.first)), patch.second);
  for (const Corners& f : inside)
    EXPECT_EQ(patches.at(1).count(f), 1u);
}

} // namespace

TEST_F(IO, SU2_meshes_are_read_back_equal) {
  for (const Named_mesh& m : solver_meshes()) {
    SCOPED_TRACE(m.name);
    TM::IO::write_su2(path("m.su2"), m.mesh);
    expect_same(m.mesh, read_su2(bytes_of(path("m.su2"))));
    EXPECT_EQ(number_of_files(), 1u);
  }
}

TEST_F(IO, SU2_takes_names_as_words_and_no_patch_inside_of_a_region) {
  Mesh m = Layered_box::make(1, "HH", "12");
  m.patch_names = {{1, "arterial wall"}, {2, "Einströmung"}, {3, "arterial_wall"}, {100, "arterial wall"}};
  TM::IO::write_su2(path("m.su2"), m);
  std::set<std::string> names;
  for (const Su2_zone& z : read_su2(bytes_of(path("m.su2"))))
    for (const auto& marker : z.markers)
      EXPECT_TRUE(names.insert(marker.first).second);
  EXPECT_EQ(names, (std::set<std::string>{"arterial_wall", "arterial_wall_wall", "Einströmung", "arterial_wall_2",
                                          "arterial_wall_3"}));
  m.hexahedra.label = {1, 1};
  EXPECT_THROW(TM::IO::write_su2(path("n.su2"), m), TM::Output_error);
  m.hexahedra = {};
  EXPECT_THROW(TM::IO::write_su2(path("n.su2"), m), TM::Output_error);
  EXPECT_EQ(number_of_files(), 1u);
}

namespace {

std::vector<std::size_t> numbers(const std::string& text) {
  std::vector<std::size_t> result;
  std::string number;
  std::istringstream in(text);
  while (std::getline(in, number, ','))
    result.push_back(std::stoul(number) - 1);
  return result;
}

void expect_same(const Mesh& m, const pugi::xml_node& spec) {
  EXPECT_EQ(spec.attribute("version").as_string(), std::string("4.0"));
  const pugi::xml_node mesh = spec.child("Mesh");
  std::size_t i = 0;
  for (const auto& node : mesh.child("Nodes").children("node")) {
    EXPECT_EQ(node.attribute("id").as_ullong(), i + 1);
    std::string text = node.text().as_string();
    for (char& c : text)
      c = c == ',' ? ' ' : c;
    std::istringstream in(text);
    EXPECT_EQ(point_of(in), m.points.at(i));
    ++i;
  }
  EXPECT_EQ(i, m.points.size());

  std::map<std::string, std::string> material; // of each block
  for (const auto& domain : spec.child("MeshDomains").children("SolidDomain"))
    EXPECT_TRUE(material.emplace(domain.attribute("name").as_string(), domain.attribute("mat").as_string()).second);
  const std::map<std::string, std::size_t> corners = {{"tet4", 4}, {"pyra5", 5}, {"penta6", 6}, {"hex8", 8}};
  std::map<std::string, std::vector<std::vector<std::size_t>>> cells;
  std::size_t id = 0;
  for (const auto& block : mesh.children("Elements"))
    for (const auto& e : block.children("elem")) {
      EXPECT_EQ(e.attribute("id").as_ullong(), ++id);
      const auto c = numbers(e.text().as_string());
      EXPECT_EQ(c.size(), corners.at(block.attribute("type").as_string()));
      cells[material.at(block.attribute("name").as_string())].push_back(c);
    }
  std::map<std::string, std::vector<std::vector<std::size_t>>> expected;
  const Cells_of_regions regions = cells_of(m);
  for (const auto& r : regions)
    expected[m.region_names.count(r.first) != 0 ? m.region_names.at(r.first) : "region_" + std::to_string(r.first)] =
        r.second;
  EXPECT_EQ(cells, expected);

  const Faces_of_cells faces(m);
  std::map<std::string, std::set<Corners>> surfaces, patches;
  std::map<std::string, Corners> nodes, nodes_of_patches;
  for (const auto& surface : mesh.children("Surface"))
    for (const auto& f : surface.children()) {
      const auto loop = numbers(f.text().as_string());
      EXPECT_EQ(f.name(), std::string(loop.size() == 3 ? "tri3" : "quad4"));
      EXPECT_TRUE(surfaces[surface.attribute("name").as_string()].insert(Corners(loop.begin(), loop.end())).second);
      int highest = 0; // the region whose side it is
      for (std::size_t c = 0; c < faces.faces.size(); ++c)
        if (faces.corners(c).count(Corners(loop.begin(), loop.end())) != 0)
          highest = std::max(highest, faces.region[c]);
      expect_outward(faces, highest, loop);
    }
  for (const auto& set : mesh.children("NodeSet")) {
    const auto n = numbers(set.text().as_string());
    nodes[set.attribute("name").as_string()] = Corners(n.begin(), n.end());
  }
  for (const auto& p : facets_of(m)) {
    patches[m.patch_names.at(p.first)] = p.second;
    for (const Corners& f : p.second)
      nodes_of_patches[m.patch_names.at(p.first)].insert(f.begin(), f.end());
  }
  EXPECT_EQ(surfaces, patches);
  EXPECT_EQ(nodes, nodes_of_patches);
}

} // namespace

TEST_F(IO, FEBio_meshes_are_read_back_equal) {
  for (Named_mesh m : solver_meshes()) {
    SCOPED_TRACE(m.name);
    m.mesh.patch_names[2] = "Zufluß <&> 'x'";
    m.mesh.region_names[1] = "the lumen";
    TM::IO::write_febio(path("m.feb"), m.mesh);
    pugi::xml_document document;
    ASSERT_TRUE(document.load_file(path("m.feb").c_str()));
    expect_same(m.mesh, document.child("febio_spec"));
    EXPECT_EQ(number_of_files(), 1u);
  }
}

TEST_F(IO, FEBio_gets_no_name_twice) {
  Mesh m = Layered_box::make(1, "HXW", "112");
  m.patch_names = {{1, "same"}, {2, "same"}, {3, "same"}, {100, ""}};
  m.region_names = {{1, "same"}, {2, "same"}};
  TM::IO::write_febio(path("m.feb"), m);
  pugi::xml_document document;
  ASSERT_TRUE(document.load_file(path("m.feb").c_str()));
  const pugi::xml_node mesh = document.child("febio_spec").child("Mesh");
  std::set<std::string> surfaces, blocks;
  for (const auto& s : mesh.children("Surface"))
    EXPECT_TRUE(surfaces.insert(s.attribute("name").as_string()).second);
  for (const auto& s : mesh.children("Elements"))
    EXPECT_TRUE(blocks.insert(s.attribute("name").as_string()).second);
  EXPECT_EQ(surfaces, (std::set<std::string>{"same", "same_2", "same_3", "patch_100"}));
  EXPECT_EQ(blocks, (std::set<std::string>{"same", "same_pyra5", "same_hex8", "same_2"}));
  m.triangles.push_back({0, 1, 6}, 1); // bounds no cell
  EXPECT_THROW(TM::IO::write_febio(path("n.feb"), m), TM::Output_error);
  EXPECT_EQ(number_of_files(), 1u);
}

namespace {

std::vector<double> reals(const std::string& text) {
  std::vector<double> result;
  std::string number;
  std::istringstream in(text);
  while (std::getline(in, number, ','))
    result.push_back(std::strtod(number.c_str(), nullptr));
  return result;
}

std::vector<double> values_of(const TM::Cell_array& a, std::size_t cell) {
  const auto first = a.values.begin() + std::ptrdiff_t(cell) * a.components;
  return std::vector<double>(first, first + a.components);
}

} // namespace

TEST_F(IO, FEBio_gets_fibres_as_axes_of_the_material_and_other_values_as_maps) {
  for (const Named_mesh& m : solver_meshes()) {
    SCOPED_TRACE(m.name);
    std::vector<TM::Cell_array> arrays = fibres_of(m.mesh);
    arrays.push_back({"age", 1, {}});
    for (std::size_t i = 0; i < m.mesh.number_of_cells(); ++i)
      arrays.back().values.push_back(1 / (1. + double(i)));
    TM::IO::write_mesh(path("m.feb"), m.mesh, arrays);
    pugi::xml_document document;
    ASSERT_TRUE(document.load_file(path("m.feb").c_str()));
    const pugi::xml_node spec = document.child("febio_spec");
    std::vector<std::size_t> cells; // of the mesh, of each element
    for (const auto& region : cell_numbers(m.mesh))
      cells.insert(cells.end(), region.second.begin(), region.second.end());
    std::map<std::string, std::size_t> first; // element of each set, from 0
    std::size_t number = 0;
    for (const auto& block : spec.child("Mesh").children("Elements")) {
      first[block.attribute("name").as_string()] = number;
      for (const auto& e : block.children("elem"))
        number += !e.empty();
    }
    std::set<std::size_t> with_axes, with_age;
    for (const auto& data : spec.child("MeshData").children("ElementData")) {
      const bool is_axes = data.attribute("type").as_string() == std::string("mat_axis");
      for (const auto& e : data.children("elem")) {
        const std::size_t cell =
            cells.at(first.at(data.attribute("elem_set").as_string()) + e.attribute("lid").as_ullong() - 1);
        EXPECT_TRUE((is_axes ? with_axes : with_age).insert(cell).second);
        if (is_axes) {
          EXPECT_EQ(reals(e.child("a").text().as_string()), values_of(arrays[0], cell));
          EXPECT_EQ(reals(e.child("d").text().as_string()), values_of(arrays[1], cell));
        } else {
          EXPECT_EQ(data.attribute("name").as_string(), std::string("age"));
          EXPECT_EQ(data.attribute("data_type").as_string(), std::string("scalar"));
          EXPECT_EQ(reals(e.text().as_string()), values_of(arrays[2], cell));
        }
      }
    }
    std::set<std::size_t> of_wall;
    for (const auto& region : cell_numbers(m.mesh))
      if (region.first != TM::labels::lumen)
        of_wall.insert(region.second.begin(), region.second.end());
    EXPECT_EQ(with_axes, of_wall);
    EXPECT_EQ(with_age.size(), cells.size());
  }
  const Mesh m = Layered_box::make(1, "HH", "12");
  EXPECT_THROW(
      TM::IO::write_mesh(path("n.feb"), m, std::vector<TM::Cell_array>{{"strain", 6, std::vector<double>(12)}}),
      TM::Output_error);
  EXPECT_EQ(number_of_files(), 1u);
}
