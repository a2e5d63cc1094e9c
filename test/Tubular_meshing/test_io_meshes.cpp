// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes: what is written is read back equal, and input decks say what the mesh is.

#include "solver_meshes.h"

#include <CGAL/Tubular_meshing/IO/internal/Input_file.h>
#include <CGAL/Tubular_meshing/IO/internal/Vtk_xml_file.h>
#include <CGAL/Tubular_meshing/IO/read_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

template <class Block> void expect_equal(const Block& a, const Block& b) {
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.label, b.label);
}

bool same_bits(double a, double b) {
  return a == b && std::signbit(a) == std::signbit(b);
}

void expect_equal(const Mesh& a, const Mesh& b) {
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i)
    for (int k = 0; k < 3; ++k)
      EXPECT_TRUE(same_bits(a.points[i][k], b.points[i][k])) << "point " << i;
  expect_equal(a.tetrahedra, b.tetrahedra);
  expect_equal(a.pyramids, b.pyramids);
  expect_equal(a.prisms, b.prisms);
  expect_equal(a.hexahedra, b.hexahedra);
  expect_equal(a.triangles, b.triangles);
  expect_equal(a.quads, b.quads);
  EXPECT_EQ(a.region_names, b.region_names);
  EXPECT_EQ(a.patch_names, b.patch_names);
  ASSERT_EQ(a.point_arrays.size(), b.point_arrays.size());
  for (std::size_t i = 0; i < a.point_arrays.size(); ++i) {
    EXPECT_EQ(a.point_arrays[i].name, b.point_arrays[i].name);
    EXPECT_EQ(a.point_arrays[i].components, b.point_arrays[i].components);
    EXPECT_EQ(a.point_arrays[i].values, b.point_arrays[i].values);
  }
}

// An input deck, by a parser of its own.
struct Deck {
  struct Element {
    std::string type, set;
    std::vector<std::size_t> nodes;
  };
  std::map<std::size_t, std::array<double, 3>> nodes;
  std::map<std::size_t, Element> elements;
  std::map<std::string, std::set<std::size_t>> node_sets;
  std::map<std::string, std::vector<std::pair<std::size_t, int>>> surfaces;

  explicit Deck(const std::string& text) {
    std::istringstream in(text);
    std::string line, keyword, type, set;
    while (std::getline(in, line)) {
      EXPECT_LE(line.size(), 132u);
      if (line.compare(0, 2, "**") == 0)
        continue;
      std::vector<std::string> fields;
      std::istringstream parts(line);
      for (std::string f; std::getline(parts, f, ',');)
        fields.push_back(f.substr(f.find_first_not_of(' ')));
      EXPECT_LE(fields.size(), 16u);
      if (line[0] == '*') {
        keyword = fields[0];
        for (const std::string& f : fields)
          (f.compare(0, 5, "TYPE=") == 0 ? type : set) = f.substr(f.find('=') + 1);
        continue;
      }
      for (const std::string& f : fields)
        EXPECT_LE(f.size(), 20u);
      if (keyword == "*NODE") {
        nodes[std::stoul(fields[0])] = {std::strtod(fields[1].c_str(), nullptr),
                                        std::strtod(fields[2].c_str(), nullptr),
                                        std::strtod(fields[3].c_str(), nullptr)};
      } else if (keyword == "*ELEMENT") {
        Element e{type, set, {}};
        for (std::size_t i = 1; i < fields.size(); ++i)
          e.nodes.push_back(std::stoul(fields[i]));
        EXPECT_TRUE(elements.emplace(std::stoul(fields[0]), e).second);
      } else if (keyword == "*NSET") {
        for (const std::string& f : fields)
          node_sets[set].insert(std::stoul(f));
      } else if (keyword == "*SURFACE") {
        surfaces[set].emplace_back(std::stoul(fields[0]), fields[1].at(1) - '0');
      } else {
        ADD_FAILURE() << line;
      }
    }
  }

  // The nodes of a face, by the tables in the manuals of Abaqus and CalculiX.
  std::set<std::size_t> face(std::size_t element, int number) const {
    static const std::map<std::string, std::vector<std::string>> faces = {
        {"C3D4", {"123", "142", "243", "341"}},
        {"C3D6", {"123", "456", "1254", "2365", "3146"}},
        {"C3D8", {"1234", "5876", "1562", "2673", "3784", "4851"}}};
    const Element& e = elements.at(element);
    std::set<std::size_t> result;
    for (char c : faces.at(e.type).at(std::size_t(number - 1)))
      result.insert(e.nodes.at(std::size_t(c - '1')));
    return result;
  }
};

// A cube, a hexahedron below and two prisms above, and a tetrahedron beside it; there is room for a pyramid on top.
Mesh mesh_for_a_deck() {
  Mesh m;
  for (int k = 0; k < 3; ++k)
    for (const auto& p : {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)})
      m.points.push_back(Point(p.x(), p.y(), k / 2. + 1e-7 / 3));
  m.points.push_back(Point(0.5, 0.5, 2));
  m.points.push_back(Point(0.5, -1, 1.5));
  m.hexahedra.push_back({0, 1, 2, 3, 4, 5, 6, 7}, 2);
  m.prisms.push_back({4, 5, 6, 8, 9, 10}, 1);
  m.prisms.push_back({4, 6, 7, 8, 10, 11}, 1);
  m.tetrahedra.push_back({8, 13, 9, 12}, 1);
  m.triangles.push_back({8, 13, 9}, 3);
  m.quads.push_back({0, 3, 2, 1}, 100);
  m.quads.push_back({5, 6, 10, 9}, 3);
  m.quads.push_back({4, 5, 1, 0}, 4);
  m.region_names = {{1, "lumen"}, {2, "wall"}};
  m.patch_names = {{3, "outlet 1"}, {100, "wall"}};
  return m;
}

} // namespace

TEST_F(IO, Meshes_are_read_back_equal) {
  for (const std::string name : {"m.vtu", "m.msh", "m.mesh"}) {
    SCOPED_TRACE(name);
    Mesh m = sample_mesh(), back;
    m.point_arrays.push_back(sample_array("metric", 6, m.points.size()));
    TM::IO::write_mesh(path(name), m);
    TM::IO::read_mesh(path(name), back);
    expect_equal(m, back);
    const std::string bytes = bytes_of(path(name));
    TM::IO::write_mesh(path(name), m);
    EXPECT_EQ(bytes, bytes_of(path(name)));
  }
  EXPECT_EQ(number_of_files(), 4u); // and m.sol
}

TEST_F(IO, Msh_2_2_is_read_back_equal) {
  Mesh m = sample_mesh(), back;
  for (int components : {1, 3, 6, 9})
    m.point_arrays.push_back(sample_array("a" + std::to_string(components), components, m.points.size()));
  TM::IO::write_mesh(path("m.msh"), m, TM::parameters::format(2.2));
  EXPECT_EQ(bytes_of(path("m.msh")).substr(0, 20), "$MeshFormat\n2.2 0 8\n");
  TM::IO::read_mesh(path("m.msh"), back);
  expect_equal(m, back);
  EXPECT_THROW(TM::IO::write_mesh(path("n.msh"), m, TM::parameters::format(3.0)), TM::Parameter_error);
}

TEST_F(IO, Large_arrays_span_several_blocks) {
  Mesh m, back;
  for (std::uint32_t i = 0; i < 40000; ++i) {
    m.points.push_back(Point(i, std::sin(i), std::cos(i)));
    if (i >= 3)
      m.tetrahedra.push_back({i, i - 1, i - 2, i - 3}, 1 + static_cast<int>(i % 3));
  }
  for (const std::string name : {"m.vtu", "m.msh", "m.mesh"}) {
    TM::IO::write_mesh(path(name), m);
    TM::IO::read_mesh(path(name), back);
    EXPECT_TRUE(m.points == back.points && m.tetrahedra.vertices == back.tetrahedra.vertices &&
                m.tetrahedra.label == back.tetrahedra.label)
        << name;
  }
}

TEST_F(IO, Prisms_turn_the_other_way_in_VTK) {
  Mesh m;
  for (int i = 0; i < 6; ++i)
    m.points.push_back(Point(i, 0, 0));
  m.prisms.push_back({0, 1, 2, 3, 4, 5}, 1);
  TM::IO::write_mesh(path("m.vtu"), m);
  const TM::IO::internal::Input_file file(path("m.vtu"));
  const TM::IO::internal::Vtk_xml_file vtu(file, "UnstructuredGrid");
  const auto cells = vtu.dataset().child("Piece").child("Cells");
  EXPECT_EQ(vtu.values<int>(vtu.find(cells, "connectivity")), (std::vector<int>{0, 2, 1, 3, 5, 4}));
}

TEST_F(IO, What_a_format_cannot_hold_is_refused_and_nothing_is_written) {
  Mesh m = sample_mesh();
  m.triangles.label[0] = -1;
  EXPECT_THROW(TM::IO::write_mesh(path("m.msh"), m), TM::Output_error);
  m = sample_mesh();
  m.point_arrays.push_back(sample_array("pairs", 2, m.points.size()));
  EXPECT_THROW(TM::IO::write_mesh(path("m.msh"), m), TM::Output_error);
  m.point_arrays[0].values.pop_back();
  EXPECT_THROW(TM::IO::write_mesh(path("m.vtu"), m), TM::Output_error);
  EXPECT_THROW(TM::IO::write_mesh(path("m.xyz"), sample_mesh()), TM::Output_error);
  EXPECT_EQ(number_of_files(), 0u);
  EXPECT_FALSE(TM::IO::is_supported_mesh_format("m.xyz"));
  EXPECT_TRUE(TM::IO::is_supported_mesh_format("m.VTU"));
  EXPECT_TRUE(TM::IO::is_supported_mesh_format("m.inp"));
}

TEST_F(IO, What_a_format_changes_is_told) {
  using TM::IO::Mesh_format;
  Mesh m = sample_mesh();
  m.patch_names = {{1, "wall"}, {2, "In Let"}, {3, "In_Let"}, {102, "ring"}};
  m.point_arrays.push_back(sample_array("metric", 6, m.points.size()));
  typedef std::vector<std::string> Sentences;
  EXPECT_EQ(TM::IO::changes_in(m, Mesh_format::vtu), Sentences());
  EXPECT_EQ(TM::IO::changes_in(m, Mesh_format::medit), Sentences());
  EXPECT_EQ(TM::IO::patch_names_in(m, Mesh_format::gmsh), m.patch_names);
  EXPECT_EQ(TM::IO::patch_names_in(m, Mesh_format::openfoam),
            (TM::Label_names{{1, "wall"}, {2, "In_Let"}, {3, "In_Let_2"}, {102, "ring"}}));
  const std::string array =
      "The file has no place for the point array \"metric\", which is not written; a .vtu file has.";
  EXPECT_EQ(TM::IO::changes_in(m, Mesh_format::openfoam),
            (Sentences{"The file has other names of patches: \"In Let\" is In_Let, \"In_Let\" is In_Let_2.", array}));
  EXPECT_EQ(TM::IO::changes_in(m, Mesh_format::fluent),
            (Sentences{"The file has other names of patches: \"In Let\" is in-let, \"In_Let\" is in_let.",
                       "The file has other names of regions: \"wall\" is wall-cells.", array}));
  m.point_arrays.clear();
  EXPECT_EQ(TM::IO::changes_in(m, Mesh_format::febio), Sentences());
  m.patch_names[102] = "wall";
  EXPECT_EQ(TM::IO::changes_in(m, Mesh_format::febio),
            Sentences{"The file has other names of patches: \"wall\" is wall_2."});
}

TEST_F(IO, Names_tell_formats) {
  using TM::IO::Mesh_format;
  for (const std::string& name : TM::IO::mesh_format_names())
    EXPECT_NE(TM::IO::mesh_format_named(name), Mesh_format::by_name);
  EXPECT_EQ(TM::IO::mesh_format_named("openfoam-binary"), Mesh_format::openfoam_binary);
  EXPECT_THROW(TM::IO::mesh_format_named("nastran"), TM::Parameter_error);
  EXPECT_EQ(TM::IO::mesh_format_of("a/b.MSH"), Mesh_format::gmsh);
  EXPECT_EQ(TM::IO::mesh_format_of("a.cas"), Mesh_format::fluent);
  EXPECT_EQ(TM::IO::mesh_format_of("case/constant/polyMesh/"), Mesh_format::openfoam);
  EXPECT_EQ(TM::IO::mesh_format_of("x/aorta-mesh-complete"), Mesh_format::svmultiphysics);
  EXPECT_EQ(TM::IO::mesh_format_of("mesh"), Mesh_format::by_name);
  EXPECT_EQ(TM::IO::mesh_format_of("a.foam"), Mesh_format::by_name);
  EXPECT_TRUE(TM::IO::is_folder(Mesh_format::svmultiphysics));
  EXPECT_FALSE(TM::IO::is_folder(Mesh_format::xdmf));
  Mesh m = mesh_for_a_deck();
  TM::IO::write_mesh(path("m.msh"), m, TM::parameters::format(Mesh_format::su2));
  EXPECT_EQ(bytes_of(path("m.msh")).compare(0, 6, "NZONE="), 0);
  TM::IO::write_mesh(path("m"), m, TM::parameters::format(Mesh_format::openfoam));
  EXPECT_TRUE(fs::exists(path("m/constant/polyMesh/owner")));
  TM::IO::Output_file file(path("n"));
  EXPECT_THROW(TM::IO::write_mesh(file, m, TM::parameters::format(Mesh_format::openfoam)), TM::Output_error);
}

TEST_F(IO, Input_decks_say_what_the_mesh_is) {
  Mesh m = mesh_for_a_deck();
  m.pyramids.push_back({8, 9, 10, 11, 12}, 1);
  m.triangles.push_back({9, 10, 12}, 3);
  TM::IO::write_mesh(path("m.inp"), m);
  const Deck deck(bytes_of(path("m.inp")));
  ASSERT_EQ(deck.nodes.size(), m.points.size());
  for (std::size_t i = 0; i < m.points.size(); ++i)
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(deck.nodes.at(i + 1)[k], m.points[i][k], 1e-13);
  ASSERT_EQ(deck.elements.size(), 5u);
  typedef std::vector<std::size_t> Nodes;
  EXPECT_EQ(deck.elements.at(1).type, "C3D4");
  EXPECT_EQ(deck.elements.at(1).nodes, (Nodes{9, 14, 10, 13}));
  EXPECT_EQ(deck.elements.at(2).type, "C3D8");
  EXPECT_EQ(deck.elements.at(2).nodes, (Nodes{9, 10, 11, 12, 13, 13, 13, 13}));
  EXPECT_EQ(deck.elements.at(3).type, "C3D6");
  EXPECT_EQ(deck.elements.at(3).nodes, (Nodes{5, 6, 7, 9, 10, 11}));
  EXPECT_EQ(deck.elements.at(5).nodes, (Nodes{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(deck.elements.at(5).set, "region_wall");
  for (std::size_t e = 1; e < 5; ++e)
    EXPECT_EQ(deck.elements.at(e).set, "region_lumen");

  // names that a deck can hold, and that are not those of element sets
  ASSERT_EQ(deck.surfaces.size(), 3u);
  std::map<std::string, std::set<std::set<std::size_t>>> faces;
  for (const auto& s : deck.surfaces)
    for (const auto& f : s.second)
      faces[s.first].insert(deck.face(f.first, f.second));
  typedef std::set<std::set<std::size_t>> Faces;
  EXPECT_EQ(faces.at("outlet_1"), (Faces{{10, 11, 13}, {9, 14, 10}, {6, 7, 11, 10}}));
  EXPECT_EQ(faces.at("wall"), (Faces{{1, 2, 3, 4}}));
  EXPECT_EQ(faces.at("patch_4"), (Faces{{1, 2, 5, 6}}));
  EXPECT_EQ(deck.node_sets.at("outlet_1"), (std::set<std::size_t>{6, 7, 9, 10, 11, 13, 14}));
  EXPECT_EQ(deck.node_sets.at("wall"), (std::set<std::size_t>{1, 2, 3, 4}));
}

TEST_F(IO, Input_decks_give_a_patch_between_regions_the_side_of_the_higher_one) {
  for (int upper : {1, 3}) {
    Mesh m;
    for (int k = 0; k < 3; ++k)
      for (const auto& p : {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)})
        m.points.push_back(Point(p.x(), p.y(), k));
    m.hexahedra.push_back({0, 1, 2, 3, 4, 5, 6, 7}, 2);
    m.hexahedra.push_back({4, 5, 6, 7, 8, 9, 10, 11}, upper);
    m.quads.push_back({4, 5, 6, 7}, 1);
    TM::IO::write_mesh(path("m.inp"), m);
    const Deck deck(bytes_of(path("m.inp")));
    ASSERT_EQ(deck.surfaces.at("patch_1").size(), 1u);
    const auto side = deck.surfaces.at("patch_1").front();
    EXPECT_EQ(deck.elements.at(side.first).set, upper == 3 ? "region_3" : "region_2");
    EXPECT_EQ(deck.face(side.first, side.second), (std::set<std::size_t>{5, 6, 7, 8}));
  }
}

TEST_F(IO, Input_decks_get_fibres_as_an_orientation_by_elements) {
  for (const Named_mesh& m : solver_meshes()) {
    SCOPED_TRACE(m.name);
    const std::vector<TM::Cell_array> arrays = fibres_of(m.mesh);
    TM::IO::write_mesh(path("m.inp"), m.mesh, arrays);
    std::vector<std::size_t> cells; // by kind, then by region, as the deck has them
    std::size_t first = 0;
    for (const auto* labels :
         {&m.mesh.tetrahedra.label, &m.mesh.pyramids.label, &m.mesh.prisms.label, &m.mesh.hexahedra.label}) {
      std::map<int, std::vector<std::size_t>> by_region;
      for (int region : *labels)
        by_region[region].push_back(first++);
      for (const auto& r : by_region)
        cells.insert(cells.end(), r.second.begin(), r.second.end());
    }
    std::map<std::size_t, std::vector<double>> axes, expected;
    std::istringstream in(bytes_of(path("m.inp")));
    std::string line, keyword, orientation;
    bool has_default = false;
    while (std::getline(in, line)) {
      if (line[0] == '*') {
        keyword = line.substr(0, line.find(','));
      } else if (keyword == "*DISTRIBUTION" && line[0] == ',') {
        has_default = axes.empty();
      } else if (keyword == "*DISTRIBUTION") {
        std::istringstream fields(line);
        std::string field;
        std::getline(fields, field, ',');
        std::vector<double>& a = axes[std::stoul(field)];
        EXPECT_TRUE(a.empty());
        while (std::getline(fields, field, ',')) {
          EXPECT_LE(field.size(), 21u); // with the blank
          a.push_back(std::stod(field));
        }
      } else if (keyword == "*ORIENTATION") {
        orientation = line;
      }
    }
    EXPECT_TRUE(has_default);
    EXPECT_EQ(orientation, "fibre_axes");
    for (std::size_t e = 0; e < cells.size(); ++e)
      for (const TM::Cell_array& a : arrays)
        for (std::size_t k = 0; k < 3; ++k)
          if (arrays[0].values[3 * cells[e]] != 0)
            expected[e + 1].push_back(a.values[3 * cells[e] + k]);
    ASSERT_EQ(axes.size(), expected.size());
    for (const auto& e : expected)
      for (std::size_t k = 0; k < 6; ++k)
        EXPECT_NEAR(axes.at(e.first).at(k), e.second[k], 1e-12);
  }
  const Mesh m = Layered_box::make(1, "HH", "12");
  EXPECT_THROW(TM::IO::write_mesh(path("n.inp"), m, std::vector<TM::Cell_array>{{"age", 1, {1, 2}}}), TM::Output_error);
  TM::IO::write_mesh(path("m.inp"), m);
  EXPECT_EQ(bytes_of(path("m.inp")).find("*ORIENTATION"), std::string::npos);
  EXPECT_EQ(number_of_files(), 1u);
}

TEST_F(IO, Input_decks_refuse_what_they_cannot_hold) {
  Mesh m = mesh_for_a_deck();
  m.triangles.push_back({0, 1, 2}, 3); // bounds no cell
  EXPECT_THROW(TM::IO::write_mesh(path("m.inp"), m), TM::Output_error);
  m = mesh_for_a_deck();
  m.patch_names[4] = "OUTLET-1"; // the same as "outlet 1", there
  EXPECT_THROW(TM::IO::write_mesh(path("m.inp"), m), TM::Output_error);
  Mesh surface;
  surface.points = m.points;
  surface.triangles = m.triangles;
  EXPECT_THROW(TM::IO::write_mesh(path("m.inp"), surface), TM::Output_error);
  EXPECT_EQ(number_of_files(), 0u);
}
