// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes in the formats CGNS and Exodus II: read back by the libraries, and by cgnscheck where that is installed.

#include "installed_programs.h"
#include "resource_limits.h"
#include "solver_meshes.h"

#include <CGAL/Tubular_meshing/IO/hdf5_at_exit.h>
#include <CGAL/Tubular_meshing/IO/internal/Mesh_nodes.h>
#include <CGAL/Tubular_meshing/IO/internal/write_nodes.h>
#include <CGAL/Tubular_meshing/IO/write_cgns.h>
#include <CGAL/Tubular_meshing/IO/write_exodus.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#ifdef CGAL_TUBULAR_MESHING_WITH_CGNS
#include <cgnslib.h>
#endif
#ifdef CGAL_TUBULAR_MESHING_WITH_EXODUS
#include <exodusII.h>
#endif

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

// Before any test: files that cannot be written are among them.
[[maybe_unused]] const bool hdf5_is_left_alone = (CGAL::Tubular_meshing::IO::leave_hdf5_alone_at_exit(), true);

std::string name_of(const TM::Label_names& names, int label, const std::string& prefix) {
  const auto found = names.find(label);
  return found == names.end() ? prefix + std::to_string(label) : found->second;
}

} // namespace

#ifndef CGAL_TUBULAR_MESHING_WITH_CGNS

TEST_F(IO, CGNS_needs_its_library) {
  EXPECT_FALSE(TM::IO::has_cgns());
  EXPECT_THROW(TM::IO::write_cgns(path("m.cgns"), Layered_box::make(1, "T", "1")), TM::Output_error);
  EXPECT_EQ(number_of_files(), 0u);
}

#else

namespace {

struct Cgns {
  struct Condition {
    BCType_t type;
    std::set<Corners> facets;
    std::string whole_name;
  };
  std::vector<Point> points;
  std::map<std::string, std::vector<std::vector<std::size_t>>> cells; // by section
  std::map<std::size_t, std::vector<std::size_t>> facets;             // by number
  std::map<std::string, Condition> conditions;

  explicit Cgns(const std::string& name) {
    int file;
    check(cg_open(name.c_str(), CG_MODE_READ, &file));
    char text[33];
    cgsize_t size[3];
    check(cg_zone_read(file, 1, 1, text, size));
    std::vector<double> xyz[3];
    const char* const names[3] = {"CoordinateX", "CoordinateY", "CoordinateZ"};
    for (int k = 0; k < 3; ++k) {
      xyz[k].resize(std::size_t(size[0]));
      cgsize_t first = 1;
      check(cg_coord_read(file, 1, 1, names[k], RealDouble, &first, &size[0], xyz[k].data()));
    }
    for (std::size_t i = 0; i < std::size_t(size[0]); ++i)
      points.push_back(Point(xyz[0][i], xyz[1][i], xyz[2][i]));
    read_sections(file);
    EXPECT_EQ(number_of_cells_, std::size_t(size[1]));
    read_conditions(file);
    check(cg_close(file));
  }

private:
  std::size_t number_of_cells_ = 0;

  static void check(int status) { ASSERT_EQ(status, CG_OK) << cg_get_error(); }

  void read_sections(int file) {
    int sections;
    check(cg_nsections(file, 1, 1, &sections));
    for (int s = 1; s <= sections; ++s) {
      char name[33];
      ElementType_t type;
      cgsize_t first, last, size;
      int boundary, parent;
      check(cg_section_read(file, 1, 1, s, name, &type, &first, &last, &boundary, &parent));
      check(cg_ElementDataSize(file, 1, 1, s, &size));
      std::vector<cgsize_t> data(static_cast<std::size_t>(size)), ends(static_cast<std::size_t>(last - first + 2));
      if (type == MIXED)
        check(cg_poly_elements_read(file, 1, 1, s, data.data(), ends.data(), nullptr));
      else
        check(cg_elements_read(file, 1, 1, s, data.data(), nullptr));
      auto next = data.begin();
      for (cgsize_t e = first; e <= last; ++e) {
        int corners;
        const ElementType_t kind = type == MIXED ? ElementType_t(*next++) : type;
        check(cg_npe(kind, &corners));
        std::vector<std::size_t> element;
        for (int k = 0; k < corners; ++k)
          element.push_back(std::size_t(*next++ - 1));
        if (kind == TRI_3 || kind == QUAD_4) {
          EXPECT_TRUE(facets.emplace(e, element).second);
        } else {
          EXPECT_EQ(++number_of_cells_, std::size_t(e));
          cells[name].push_back(element);
        }
      }
      EXPECT_TRUE(next == data.end());
    }
  }

  void read_conditions(int file) {
    int number;
    check(cg_nbocos(file, 1, 1, &number));
    for (int b = 1; b <= number; ++b) {
      char name[33];
      Condition c;
      PointSetType_t set;
      cgsize_t n, normals, range[2];
      int index, data_sets;
      DataType_t data;
      GridLocation_t location;
      check(cg_boco_info(file, 1, 1, b, name, &c.type, &set, &n, &index, &normals, &data, &data_sets));
      check(cg_boco_gridlocation_read(file, 1, 1, b, &location));
      EXPECT_EQ(location, FaceCenter);
      EXPECT_EQ(set, PointRange);
      check(cg_boco_read(file, 1, 1, b, range, nullptr));
      for (cgsize_t e = range[0]; e <= range[1]; ++e)
        EXPECT_TRUE(
            c.facets.insert(Corners(facets.at(std::size_t(e)).begin(), facets.at(std::size_t(e)).end())).second);
      c.whole_name = name;
      check(cg_goto(file, 1, "Zone_t", 1, "ZoneBC_t", 1, "BC_t", b, "end"));
      int descriptors = 0;
      check(cg_ndescriptors(&descriptors));
      if (descriptors > 0) {
        char* text;
        check(cg_descriptor_read(1, name, &text));
        c.whole_name = text;
        cg_free(text);
        check(cg_boco_info(file, 1, 1, b, name, &c.type, &set, &n, &index, &normals, &data, &data_sets));
      }
      EXPECT_TRUE(conditions.emplace(name, c).second);
    }
  }
};

} // namespace

TEST_F(IO, CGNS_meshes_are_read_back_equal) {
  EXPECT_TRUE(TM::IO::has_cgns());
  for (const Named_mesh& m : solver_meshes()) {
    SCOPED_TRACE(m.name);
    TM::IO::write_cgns(path("m.cgns"), m.mesh);
    const Cgns cgns(path("m.cgns"));
    EXPECT_TRUE(cgns.points == m.mesh.points);
    // a region's sections begin with its name
    std::map<std::string, std::multiset<std::vector<std::size_t>>> cells, expected;
    for (const auto& s : cgns.cells) {
      std::string region = s.first.substr(0, s.first.compare(0, 7, "region_") == 0 ? 8 : s.first.find('_'));
      cells[region].insert(s.second.begin(), s.second.end());
    }
    for (const auto& r : cells_of(m.mesh))
      expected[name_of(m.mesh.region_names, r.first, "region_")].insert(r.second.begin(), r.second.end());
    EXPECT_EQ(cells, expected);
    const Faces_of_cells faces(m.mesh);
    for (const auto& p : facets_of(m.mesh)) {
      const auto& c = cgns.conditions.at(m.mesh.patch_names.at(p.first));
      EXPECT_EQ(c.facets, p.second);
      bool bounds_lumen = false;
      for (std::size_t i = 0; i < faces.faces.size(); ++i)
        bounds_lumen = bounds_lumen || (faces.region[i] == 1 && faces.corners(i).count(*p.second.begin()) != 0);
      EXPECT_EQ(c.type, !bounds_lumen || p.first == 1 ? BCWall : p.first == 2 ? BCInflow : BCOutflow) << p.first;
    }
    for (const auto& f : cgns.facets) {
      int lowest = 9;
      for (std::size_t c = 0; c < faces.faces.size(); ++c)
        if (faces.corners(c).count(Corners(f.second.begin(), f.second.end())) != 0)
          lowest = std::min(lowest, faces.region[c]);
      expect_outward(faces, lowest, f.second);
    }
    EXPECT_EQ(number_of_files(), 1u);
    if (has_program("cgnscheck")) {
      std::system(("cgnscheck '" + path("m.cgns") + "' > '" + path("log") + "' 2>&1").c_str());
      const std::string said = bytes_of(path("log"));
      EXPECT_EQ(said.find("ERROR"), std::string::npos) << said;
      EXPECT_NE(said.find("checking"), std::string::npos) << said;
      fs::remove(path("log"));
    }
  }
}

TEST_F(IO, CGNS_gets_names_of_32_bytes_and_the_whole_besides) {
  Mesh m = Layered_box::make(1, "HXW", "112");
  const std::string longer = "a name of many more than thirty-two bytes, ";
  m.patch_names = {{1, longer + "1"}, {2, longer + "2"}, {3, "a/b"}, {100, "Äußere Wand"}};
  m.region_names = {{1, "Äußere Wand"}, {2, "region"}};
  TM::IO::write_cgns(path("m.cgns"), m);
  const Cgns cgns(path("m.cgns"));
  std::map<std::string, std::string> names;
  for (const auto& c : cgns.conditions)
    names[c.first] = c.second.whole_name;
  EXPECT_EQ(names, (std::map<std::string, std::string>{{"a name of many more than thi", longer + "1"},
                                                       {"a name of many more than thi_2", longer + "2"},
                                                       {"a_b", "a/b"},
                                                       {"Äußere Wand", "Äußere Wand"}}));
  EXPECT_EQ(cgns.cells.count("Äußere Wand_cells"), 1u);
  EXPECT_EQ(cgns.cells.size(), 4u);
  m.hexahedra = {};
  m.pyramids = {};
  m.prisms = {};
  m.tetrahedra = {};
  EXPECT_THROW(TM::IO::write_cgns(path("n.cgns"), m), TM::Output_error);
  EXPECT_THROW(TM::IO::write_cgns("/dev/null", Layered_box::make(1, "T", "1")), TM::Output_error);
  EXPECT_EQ(number_of_files(), 1u);
}

#ifdef __unix__
TEST_F(IO, A_limit_on_file_size_leaves_no_CGNS) {
  const Mesh large = Layered_box::make(12, "TTT", "112");
  expect_no_file_within_limits<TM::Output_error>([&] { TM::IO::write_cgns(path("m.cgns"), large); },
                                                 [&] { EXPECT_EQ(number_of_files(), 0u); });
  TM::IO::write_cgns(path("m.cgns"), large);
  EXPECT_EQ(Cgns(path("m.cgns")).points.size(), large.points.size());
}
#endif

#endif // CGAL_TUBULAR_MESHING_WITH_CGNS

#ifndef CGAL_TUBULAR_MESHING_WITH_EXODUS

TEST_F(IO, Exodus_needs_its_library) {
  EXPECT_FALSE(TM::IO::has_exodus());
  EXPECT_THROW(TM::IO::write_exodus(path("m.exo"), Layered_box::make(1, "T", "1")), TM::Output_error);
  EXPECT_EQ(number_of_files(), 0u);
}

#else

namespace {

struct Exodus {
  struct Block {
    int id;
    std::string type;
    std::vector<std::vector<std::size_t>> cells;
  };
  struct Side_set {
    int id;
    std::vector<int> elements, sides;
  };
  std::vector<Point> points;
  std::map<std::string, Block> blocks;
  std::vector<std::pair<std::string, std::vector<std::size_t>>> elements; // type, corners; in order
  std::map<std::string, Side_set> sets;
  std::map<std::string, std::vector<double>> variables; // of all elements

  explicit Exodus(const std::string& file) {
    int of_program = 8, of_file = 0;
    float version;
    const int exodus = ex_open(file.c_str(), EX_READ, &of_program, &of_file, &version);
    EXPECT_GE(exodus, 0);
    EXPECT_EQ(of_file, 8);
    ex_set_max_name_length(exodus, 255);
    char title[MAX_LINE_LENGTH + 1];
    int dimension, nodes, cells, number_of_blocks, node_sets, side_sets;
    ex_get_init(exodus, title, &dimension, &nodes, &cells, &number_of_blocks, &node_sets, &side_sets);
    EXPECT_EQ(dimension, 3);
    std::vector<double> x(static_cast<std::size_t>(nodes)), y(x), z(x);
    ex_get_coord(exodus, x.data(), y.data(), z.data());
    for (std::size_t i = 0; i < x.size(); ++i)
      points.push_back(Point(x[i], y[i], z[i]));
    std::vector<int> ids(static_cast<std::size_t>(number_of_blocks));
    ex_get_ids(exodus, EX_ELEM_BLOCK, ids.data());
    for (int id : ids) {
      char name[256], type[MAX_STR_LENGTH + 1];
      int size, corners, edges, faces, attributes;
      ex_get_name(exodus, EX_ELEM_BLOCK, id, name);
      ex_get_block(exodus, EX_ELEM_BLOCK, id, type, &size, &corners, &edges, &faces, &attributes);
      std::vector<int> connectivity(static_cast<std::size_t>(size * corners));
      ex_get_conn(exodus, EX_ELEM_BLOCK, id, connectivity.data(), nullptr, nullptr);
      Block block{id, type, {}};
      for (std::size_t i = 0; i < connectivity.size(); i += std::size_t(corners)) {
        block.cells.emplace_back();
        for (std::size_t k = 0; k < std::size_t(corners); ++k)
          block.cells.back().push_back(std::size_t(connectivity[i + k] - 1));
        elements.emplace_back(type, block.cells.back());
      }
      EXPECT_TRUE(blocks.emplace(name, block).second);
    }
    EXPECT_EQ(elements.size(), std::size_t(cells));
    ids.resize(std::size_t(side_sets));
    ex_get_ids(exodus, EX_SIDE_SET, ids.data());
    for (int id : ids) {
      char name[256];
      int size, factors;
      ex_get_name(exodus, EX_SIDE_SET, id, name);
      ex_get_set_param(exodus, EX_SIDE_SET, id, &size, &factors);
      Side_set set{id, std::vector<int>(std::size_t(size)), std::vector<int>(std::size_t(size))};
      ex_get_set(exodus, EX_SIDE_SET, id, set.elements.data(), set.sides.data());
      EXPECT_TRUE(sets.emplace(name, set).second);
    }
    read_variables(exodus);
    ex_close(exodus);
  }

  void read_variables(int exodus) {
    int number = 0;
    ex_get_variable_param(exodus, EX_ELEM_BLOCK, &number);
    std::vector<int> ids(blocks.size());
    ex_get_ids(exodus, EX_ELEM_BLOCK, ids.data());
    for (int v = 1; v <= number; ++v) {
      char name[256];
      EXPECT_EQ(ex_get_variable_name(exodus, EX_ELEM_BLOCK, v, name), 0);
      std::vector<double>& values = variables[name];
      for (int id : ids)
        for (const auto& block : blocks)
          if (block.second.id == id) {
            std::vector<double> part(block.second.cells.size());
            EXPECT_EQ(ex_get_var(exodus, 1, EX_ELEM_BLOCK, v, id, std::int64_t(part.size()), part.data()), 0);
            values.insert(values.end(), part.begin(), part.end());
          }
    }
  }

  // The corners of a side, by the tables of the format's manual.
  Corners side(int element, int number) const {
    static const std::map<std::string, std::vector<std::string>> sides = {
        {"TETRA4", {"124", "234", "143", "132"}},
        {"PYRAMID5", {"125", "235", "345", "154", "1432"}},
        {"WEDGE6", {"1254", "2365", "1463", "132", "456"}},
        {"HEX8", {"1265", "2376", "3487", "1584", "1432", "5678"}}};
    const auto& e = elements.at(std::size_t(element - 1));
    Corners result;
    for (char c : sides.at(e.first).at(std::size_t(number - 1)))
      result.insert(e.second.at(std::size_t(c - '1')));
    return result;
  }
};

void expect_read_back_equal(const Named_mesh& m, const Exodus& exodus) {
  EXPECT_TRUE(exodus.points == m.mesh.points);
  const std::map<std::size_t, std::string> types = {{4, "TETRA4"}, {5, "PYRAMID5"}, {6, "WEDGE6"}, {8, "HEX8"}};
  std::vector<std::pair<std::string, std::vector<std::size_t>>> elements;
  for (const auto& r : cells_of(m.mesh)) {
    for (const auto& c : r.second)
      elements.emplace_back(types.at(c.size()), c);
    EXPECT_EQ(exodus.blocks.at(name_of(m.mesh.region_names, r.first, "region_")).id, r.first);
  }
  EXPECT_EQ(exodus.elements, elements);
  const Faces_of_cells faces(m.mesh);
  std::vector<int> region; // of each element of the file
  for (const auto& r : cells_of(m.mesh))
    region.insert(region.end(), r.second.size(), r.first);
  for (const auto& p : facets_of(m.mesh)) {
    const auto& set = exodus.sets.at(m.mesh.patch_names.at(p.first));
    EXPECT_EQ(set.id, p.first);
    std::set<Corners> facets;
    for (std::size_t i = 0; i < set.elements.size(); ++i) {
      const Corners facet = exodus.side(set.elements[i], set.sides[i]);
      EXPECT_TRUE(facets.insert(facet).second);
      int highest = 0;
      for (std::size_t c = 0; c < faces.faces.size(); ++c)
        if (faces.corners(c).count(facet) != 0)
          highest = std::max(highest, faces.region[c]);
      EXPECT_EQ(region.at(std::size_t(set.elements[i] - 1)), highest);
    }
    EXPECT_EQ(facets, p.second);
  }
  EXPECT_EQ(exodus.sets.size(), facets_of(m.mesh).size());
}

} // namespace

TEST_F(IO, Exodus_meshes_are_read_back_equal) {
  EXPECT_TRUE(TM::IO::has_exodus());
  for (const Named_mesh& m : solver_meshes()) {
    SCOPED_TRACE(m.name);
    TM::IO::write_exodus(path("m.exo"), m.mesh);
    expect_read_back_equal(m, Exodus(path("m.exo")));
    EXPECT_EQ(bytes_of(path("m.exo")).substr(0, 4), "CDF\2"); // classic, of 64-bit offsets
    EXPECT_EQ(number_of_files(), 1u);
  }
}

// As those are whose blocks take more than 4 GiB: here, more than three bytes.
TEST_F(IO, Exodus_meshes_too_large_for_classic_files_are_read_back_equal) {
  for (const Named_mesh& m : solver_meshes()) {
    SCOPED_TRACE(m.name);
    TM::IO::Output_file out(path("m.exo"));
    TM::IO::internal::write_exodus(out, m.mesh, 3);
    out.commit();
    expect_read_back_equal(m, Exodus(path("m.exo")));
    EXPECT_EQ(bytes_of(path("m.exo")).substr(0, 4), "\x89HDF");
    EXPECT_EQ(number_of_files(), 1u);
    TM::IO::Output_file again(path("n.exo"));
    TM::IO::internal::write_exodus(again, m.mesh, 3);
    again.commit();
    EXPECT_EQ(bytes_of(path("m.exo")), bytes_of(path("n.exo")));
    fs::remove(path("n.exo"));
  }
}

TEST_F(IO, Exodus_gets_values_of_cells_as_variables) {
  for (const Named_mesh& m : solver_meshes()) {
    SCOPED_TRACE(m.name);
    std::vector<TM::Cell_array> arrays = fibres_of(m.mesh);
    arrays.push_back({"a name of many more than thirty-two bytes", 1, {}});
    arrays.push_back({"strain", 6, {}});
    for (std::size_t a = 2; a < 4; ++a)
      for (std::size_t i = 0; i < std::size_t(arrays[a].components) * m.mesh.number_of_cells(); ++i)
        arrays[a].values.push_back(std::sin(double(i + a)));
    TM::IO::write_mesh(path("m.exo"), m.mesh, arrays);
    const Exodus exodus(path("m.exo"));
    EXPECT_EQ(exodus.variables.size(), 3u + 3u + 1u + 6u);
    std::size_t element = 0;
    for (const auto& region : cell_numbers(m.mesh))
      for (std::size_t cell : region.second) {
        for (std::size_t k = 0; k < 3; ++k)
          for (std::size_t a = 0; a < 2; ++a)
            EXPECT_EQ(exodus.variables.at(arrays[a].name + '_' + "xyz"[k]).at(element), arrays[a].values[3 * cell + k]);
        EXPECT_EQ(exodus.variables.at(arrays[2].name).at(element), arrays[2].values[cell]);
        EXPECT_EQ(exodus.variables.at("strain_6").at(element), arrays[3].values[6 * cell + 5]);
        ++element;
      }
    EXPECT_EQ(element, exodus.elements.size());
  }
}

TEST_F(IO, Exodus_gets_long_names_none_twice_and_numbers_above_zero) {
  Mesh m = Layered_box::make(1, "HXW", "112");
  const std::string longer = "ein langer Name, länger als die zweiunddreißig von früher";
  m.patch_names = {{1, longer}, {2, "same"}, {3, "same"}, {100, "outer"}};
  m.region_names = {{1, longer}, {2, longer}};
  for (int& l : m.quads.label)
    l = l == 100 ? -1 : l;
  TM::IO::write_exodus(path("m.exo"), m);
  const Exodus exodus(path("m.exo"));
  EXPECT_EQ(exodus.sets.count(longer) + exodus.sets.count("same") + exodus.sets.count("same_2"), 3u);
  EXPECT_EQ(exodus.sets.at("patch_minus_1").id, 4);
  std::set<int> ids;
  for (const auto& b : exodus.blocks)
    EXPECT_TRUE(b.second.id > 0 && ids.insert(b.second.id).second);
  EXPECT_EQ(exodus.blocks.at(longer).id, 1);
  EXPECT_EQ(exodus.blocks.at(longer + "_2").id, 2);
  EXPECT_EQ(exodus.blocks.count(longer + "_HEX8"), 1u);
  Mesh none;
  EXPECT_THROW(TM::IO::write_exodus(path("n.exo"), none), TM::Output_error);
  EXPECT_EQ(number_of_files(), 1u);
}

#ifdef __unix__
TEST_F(IO, A_limit_on_file_size_leaves_no_Exodus) {
  const Mesh large = Layered_box::make(12, "TTT", "112");
  expect_no_file_within_limits<TM::Output_error>([&] { TM::IO::write_exodus(path("m.exo"), large); },
                                                 [&] { EXPECT_EQ(number_of_files(), 0u); });
  TM::IO::write_exodus(path("m.exo"), large);
  EXPECT_EQ(Exodus(path("m.exo")).points.size(), large.points.size());
}
#endif

#endif // CGAL_TUBULAR_MESHING_WITH_EXODUS
