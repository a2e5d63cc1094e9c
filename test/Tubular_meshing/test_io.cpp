// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Files: what is written is read back equal, what other programs wrote is understood, and damage is an Input_error.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/read_mesh.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/IO/write_centerlines.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_surface.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#ifdef __unix__
#include <csignal>
#include <sys/resource.h>
#endif

namespace {

namespace fs = std::filesystem;
namespace TM = CGAL::Tubular_meshing;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Surface;
typedef TM::Mixed_mesh Mesh;
typedef TM::Centerline_polylines Centerlines;
typedef std::vector<std::array<std::size_t, 3>> Triangles;

// A directory of its own for each test, which goes with it.
class IO : public ::testing::Test {
protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    directory = fs::temp_directory_path() / (std::string("tubular_meshing_test_io_") + info->name());
    fs::remove_all(directory);
    fs::create_directories(directory);
  }
  void TearDown() override { fs::remove_all(directory); }

  std::string path(const std::string& name) const { return (directory / name).string(); }

  std::string make(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }

  static std::string bytes_of(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
  }

  std::size_t number_of_files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory), fs::directory_iterator()));
  }

  fs::path directory;
};

// One element of each kind at least, labels in no order, coordinates that need all their digits.
Mesh sample_mesh() {
  Mesh m;
  for (int i = 0; i < 12; ++i)
    m.points.push_back(Point(i / 3. - 1, std::sqrt(i + 0.1) * 1e-7, -0.0 + i * 12345.678901234567));
  m.points[3] = Point(-0.0, 5e-324, 1.7976931348623157e308);
  m.tetrahedra.push_back({0, 1, 2, 3}, 2);
  m.tetrahedra.push_back({1, 2, 3, 4}, 1);
  m.tetrahedra.push_back({4, 5, 6, 7}, 2);
  m.pyramids.push_back({0, 1, 2, 3, 4}, 1);
  m.prisms.push_back({5, 6, 7, 8, 9, 10}, 2);
  m.prisms.push_back({0, 1, 2, 8, 9, 11}, 1);
  m.hexahedra.push_back({0, 1, 2, 3, 4, 5, 6, 7}, 1);
  m.triangles.push_back({0, 1, 2}, 3);
  m.triangles.push_back({2, 1, 4}, 1);
  m.triangles.push_back({9, 10, 11}, 102);
  m.quads.push_back({0, 1, 2, 3}, 2);
  m.region_names = {{1, "lumen"}, {2, "wall"}};
  m.patch_names = {{1, "wall"}, {2, "inlet"}, {3, "outlet_1"}, {102, "ring <&> 'x'"}};
  return m;
}

TM::Point_array sample_array(const std::string& name, int components, std::size_t points) {
  TM::Point_array a{name, components, {}};
  for (std::size_t i = 0; i < points * static_cast<std::size_t>(components); ++i)
    a.values.push_back(std::sin(1. + static_cast<double>(i)));
  return a;
}

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

Surface tetrahedron() {
  Surface s;
  const auto a = s.add_vertex(Point(0, 0, 0)), b = s.add_vertex(Point(1. / 3, 0, 0)),
             c = s.add_vertex(Point(0, 0.1, 0)), d = s.add_vertex(Point(0, 0, 1e-9));
  s.add_face(a, c, b);
  s.add_face(a, b, d);
  s.add_face(b, c, d);
  s.add_face(c, a, d);
  return s;
}

const char* const off_square =
    "OFF\n# a square of two triangles\n4 2 0\n0 0 0\n1 0 0 255 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";

void expect_input_error(const std::string& file, const std::string& part_of_sentence) {
  Surface s;
  try {
    TM::IO::read_surface(file, s);
    ADD_FAILURE() << file << " was read";
  } catch (const TM::Input_error& e) {
    EXPECT_NE(std::string(e.what()).find(part_of_sentence), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find(fs::path(file).filename().string()), std::string::npos) << e.what();
  }
}

template <class T> void append(std::string& s, T x) {
  s.append(reinterpret_cast<const char*>(&x), sizeof x);
}

std::string binary_stl(const std::string& header, std::uint32_t announced, std::uint32_t real) {
  std::string s = header;
  s.resize(80, '\0');
  append(s, announced);
  for (std::uint32_t i = 0; i < real; ++i) {
    for (float x : {0.f, 0.f, 1.f, float(i), 0.f, 0.f, float(i + 1), 0.f, 0.f, float(i), 1.f, 0.f})
      append(s, x);
    append(s, std::uint16_t(0));
  }
  return s;
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

// --- input decks, by a parser of their own ---

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

TEST_F(IO, Surfaces_are_read_back_equal) {
  const Surface s = tetrahedron();
  for (const std::string name : {"s.off", "s.obj", "s.ply", "s.vtp", "s.vtk", "s.msh", "s.stl"}) {
    SCOPED_TRACE(name);
    TM::IO::write_surface(path(name), s);
    Surface back;
    TM::IO::read_surface(path(name), back);
    ASSERT_EQ(back.number_of_vertices(), 4u);
    ASSERT_EQ(back.number_of_faces(), 4u);
    EXPECT_TRUE(CGAL::is_closed(back));
    std::vector<Point> points;
    Triangles triangles;
    TM::IO::read_triangle_soup(path(name), points, triangles);
    for (auto v : s.vertices()) {
      if (name != "s.stl") { // which is in single precision, and in the order of the triangles
        EXPECT_EQ(points[v], s.point(v));
      }
    }
  }
}

TEST_F(IO, Patches_of_a_surface_are_written) {
  Surface s = tetrahedron();
  auto patch = s.add_property_map<Surface::Face_index, int>("f:patch", 1).first;
  patch[Surface::Face_index(2)] = 2;
  const auto np = TM::parameters::face_patch_map(patch);
  TM::IO::write_surface(path("s.msh"), s, np);
  Mesh m;
  TM::IO::read_mesh(path("s.msh"), m);
  EXPECT_EQ(m.triangles.label, (std::vector<int>{1, 1, 2, 1}));
  EXPECT_EQ(m.patch_names, (TM::Label_names{{1, "wall"}, {2, "inlet"}}));
  TM::IO::write_surface(path("s.vtp"), s, np);
  EXPECT_NE(bytes_of(path("s.vtp")).find("Name=\"patch\""), std::string::npos);
  TM::IO::write_surface(path("s.ply"), s, np);
  Surface back;
  TM::IO::read_surface(path("s.ply"), back);
  EXPECT_EQ(back.number_of_faces(), 4u);
}

TEST_F(IO, Centerlines_are_read_back_equal) {
  Centerlines c, back;
  c.points = {Point(0, 0, 0), Point(1. / 3, 0, 0), Point(1, 1e-9, 0), Point(1, -1, 0)};
  c.radius = {0.1, 1. / 7, 0.3, 1e-20};
  c.lines = {{0, 1, 2}, {0, 1, 3}};
  for (const std::string name : {"c.vtp", "c.vtk"}) {
    TM::IO::write_centerlines(path(name), c);
    TM::IO::read_centerlines(path(name), back);
    EXPECT_EQ(c.points, back.points);
    EXPECT_EQ(c.radius, back.radius);
    EXPECT_EQ(c.lines, back.lines);
  }
  TM::IO::write_centerlines(path("g.vtp"), TM::Centerline_graph());
  EXPECT_THROW(TM::IO::read_centerlines(path("g.vtp"), back), TM::Input_error);
}

TEST_F(IO, Binary_stl_may_start_with_solid) {
  Surface s;
  std::vector<Point> points;
  Triangles triangles;
  const std::string file = make("a.stl", binary_stl("solid facet vertex", 3, 3));
  TM::IO::read_triangle_soup(file, points, triangles);
  EXPECT_EQ(points.size(), 7u);
  EXPECT_EQ(triangles.size(), 3u);
  TM::IO::read_surface(file, s);
  EXPECT_EQ(s.number_of_faces(), 3u);
  EXPECT_EQ(s.number_of_vertices(), 9u); // the triangles touch at single points, which no manifold does
}

TEST_F(IO, Ascii_stl_in_odd_dress) {
  Surface s;
  TM::IO::read_surface(make("a.stl", "  SOLID facet vertex\r\n FACET normal nan 0 0 outer loop\r\n"
                                     "vertex +0 0 0 vertex 1e0 0 0 VERTEX 0 1 0 endloop endfacet endsolid\r\n"),
                       s);
  EXPECT_EQ(s.number_of_faces(), 1u);
}

TEST_F(IO, Polygons_are_triangulated_without_folds) {
  // a dart, whose only diagonal that lies inside starts at its reflex corner 2, and an L of six corners
  const std::string dart = "OFF\n4 1 0\n0 0 0\n4 0 0\n1 1 0\n0 4 0\n4 1 2 3 0\n";
  const std::string ell = "OFF\n6 1 0\n0 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n6 0 1 2 3 4 5\n";
  const std::pair<std::string, double> cases[] = {{dart, 4.}, {ell, 3.}};
  for (const auto& c : cases) {
    std::vector<Point> p;
    Triangles triangles;
    TM::IO::read_triangle_soup(make("a.off", c.first), p, triangles);
    double area = 0;
    for (const auto& t : triangles) {
      const double a = CGAL::cross_product(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]).z() / 2;
      EXPECT_GT(a, 0);
      area += a;
    }
    EXPECT_DOUBLE_EQ(area, c.second);
  }
}

TEST_F(IO, Obj_indices_of_all_sorts) {
  std::vector<Point> p;
  Triangles t;
  TM::IO::read_triangle_soup(
      make("a.obj", "# c\nv 0 0 0\nv 1 0 0 1.0\nvn 0 0 1\nv 1 1 0\nv 0 1 0\ng x\nf 1/1 2/2/2 3//1\nf -4 -2 -1\n"), p,
      t);
  EXPECT_EQ(t, (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

TEST_F(IO, Ply_in_both_byte_orders_and_with_other_elements) {
  for (const bool big : {false, true}) {
    std::string s = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                    "_endian 1.0\ncomment c\nelement vertex 3\nproperty float x\nproperty uchar red\nproperty float y\n"
                    "property float z\nelement edge 1\nproperty list uchar short e\nelement face 1\n"
                    "property list uchar uint vertex_index\nend_header\n";
    const auto put = [&](auto x) {
      std::string b;
      append(b, x);
      if (big != !TM::IO::internal::host_is_little_endian())
        std::reverse(b.begin(), b.end());
      s += b;
    };
    for (float x : {0.f, 1.f, 2.f}) {
      put(x);
      put(std::uint8_t(7));
      put(x * x);
      put(0.f);
    }
    put(std::uint8_t(2));
    put(std::int16_t(0));
    put(std::int16_t(1));
    put(std::uint8_t(3));
    for (std::uint32_t v : {2u, 0u, 1u})
      put(v);
    std::vector<Point> p;
    Triangles t;
    TM::IO::read_triangle_soup(make("a.ply", s), p, t);
    EXPECT_EQ(p[2], Point(2, 4, 0));
    EXPECT_EQ(t, (Triangles{{2, 0, 1}}));
  }
}

TEST_F(IO, Vtp_ascii_with_strips_and_pieces) {
  const std::string piece =
      "<Piece NumberOfPoints=\"4\" NumberOfStrips=\"1\" NumberOfPolys=\"0\"><Points><DataArray type=\"Float32\" "
      "NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0 1 1 0</DataArray></Points><Strips><DataArray "
      "type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2 3</DataArray><DataArray type=\"Int32\" "
      "Name=\"offsets\" format=\"ascii\">4</DataArray></Strips></Piece>";
  const std::string file = make("a.vtp", "<?xml version=\"1.0\"?><VTKFile type=\"PolyData\"><PolyData>" + piece +
                                             piece + "</PolyData></VTKFile>");
  std::vector<Point> p;
  Triangles t;
  TM::IO::read_triangle_soup(file, p, t);
  EXPECT_EQ(t, (Triangles{{0, 1, 2}, {1, 3, 2}, {4, 5, 6}, {5, 7, 6}}));
  Surface s;
  TM::IO::read_surface(file, s); // the second piece is the first again
  EXPECT_EQ(s.number_of_faces(), 2u);
}

TEST_F(IO, Vtp_inline_base64) {
  // three points and one triangle, UInt32 header, written by hand: 36, 12 and 4 bytes
  const std::string file = make(
      "a.vtp", "<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\" header_type=\"UInt32\"><PolyData><Piece "
               "NumberOfPoints=\"3\" NumberOfPolys=\"1\"><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" "
               "format=\"binary\">\n JAAAAAAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAA==\n</DataArray></Points>"
               "<Polys><DataArray type=\"Int32\" Name=\"connectivity\" format=\"binary\">DAAAAAAAAAABAAAAAgAAAA=="
               "</DataArray><DataArray type=\"Int32\" Name=\"offsets\" format=\"binary\">BAAAAAMAAAA=</DataArray>"
               "</Polys></Piece></PolyData></VTKFile>");
  std::vector<Point> p;
  Triangles t;
  TM::IO::read_triangle_soup(file, p, t);
  EXPECT_EQ(t, (Triangles{{0, 1, 2}}));
  EXPECT_EQ(p[2], Point(0, 1, 0));
}

TEST_F(IO, Soup_becomes_an_oriented_mesh) {
  Surface s;
  // the second triangle is turned over, the third is the first again, the fourth has two equal corners, vertex 5 is
  // unused
  TM::IO::read_surface(make("a.off", "OFF\n6 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n-0 0 0\n9 9 9\n"
                                     "3 0 1 2\n3 4 3 2\n3 2 0 1\n3 0 4 3\n"),
                       s);
  EXPECT_EQ(s.number_of_vertices(), 4u);
  EXPECT_EQ(s.number_of_faces(), 2u);
  EXPECT_EQ(s.number_of_edges(), 5u);
  // three triangles at an edge
  TM::IO::read_surface(make("b.off", "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n3 0 1 2\n3 1 0 3\n3 0 1 4\n"), s);
  EXPECT_EQ(s.number_of_faces(), 3u);
  EXPECT_TRUE(s.is_valid());
}

TEST_F(IO, Bad_surfaces_are_named) {
  expect_input_error(path("missing.stl"), "cannot be opened");
  expect_input_error(make("empty.stl", ""), "is empty");
  expect_input_error(make("text.stl", "Dear all,\nthis is a letter.\n"), "neither ASCII STL");
  expect_input_error(make("text2.stl", "solid ground\nunder our feet\n"), "line 2");
  expect_input_error(make("letter.off", "Dear all"), "keyword OFF");
  expect_input_error(make("letter.obj", "Dear all"), "no triangles");
  expect_input_error(make("letter.ply", "Dear all"), "'ply'");
  expect_input_error(make("letter.vtp", "Dear all"), "VTK XML");
  expect_input_error(make("letter.vtk", "Dear all"), "legacy VTK");
  expect_input_error(make("letter.msh", "Dear all"), "section");
  expect_input_error(make("letter.xyz", "Dear all"), "known format");
  expect_input_error(directory.string(), "cannot be");
  expect_input_error(make("none.stl", "solid\nendsolid\n"), "no triangles");
  expect_input_error(make("zero.stl", binary_stl("", 0, 0)), "no triangles");
  expect_input_error(make("short.stl", binary_stl("", 3, 2)), "truncated");
  expect_input_error(make("huge.stl", binary_stl("", 0xffffffffu, 2)), "truncated");
  expect_input_error(make("nan.off", "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"), "y coordinate of vertex 1");
  expect_input_error(make("inf.obj", "v 0 0 0\nv 1 0 0\nv 0 1 1e999\nf 1 2 3\n"), "z coordinate of vertex 2");
  std::string nan = binary_stl("", 1, 1);
  const float value = std::numeric_limits<float>::quiet_NaN();
  nan.replace(84 + 12, 4, reinterpret_cast<const char*>(&value), 4);
  expect_input_error(make("nan.stl", nan), "x coordinate of vertex 0");
  expect_input_error(make("word.off", "OFF\n3 1 0\n0 0 0\n1 O 0\n0 1 0\n3 0 1 2\n"), "line 4: 'O'");
  expect_input_error(make("index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), "vertex 3");
  expect_input_error(make("minus.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"), "vertex -1");
  expect_input_error(make("lie.off", "OFF\n4000000000 1 0\n0 0 0\n"), "4000000000");
  expect_input_error(
      make("lie.ply", "ply\nformat ascii 1.0\nelement vertex 99999999999\nproperty float x\nend_header\n"),
      "99999999999");
  expect_input_error(make("point.off", "OFF\n3 1 0\n0 0 0\n0 0 0\n0 0 0\n3 0 1 2\n"), "three different corners");
}

// Cuts and flipped bytes in every format: an Input_error, or a mesh that is still one.
TEST_F(IO, Damage_is_an_input_error_or_harmless) {
  const char* thorough = std::getenv("TUBULAR_MESHING_THOROUGH_TESTS"); // every byte
  const std::size_t positions = thorough ? std::numeric_limits<std::size_t>::max() : 50;
  const Surface s = tetrahedron();
  Mesh m = sample_mesh();
  m.point_arrays.push_back(sample_array("metric", 6, m.points.size()));
  Centerlines c;
  c.points = {Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0)};
  c.radius = {1, 1, 1};
  c.lines = {{0, 1, 2}};
  for (const char* name : {"s.stl", "s.off", "s.obj", "s.ply", "s.vtp", "s.vtk", "s.msh"})
    TM::IO::write_surface(path(name), s);
  for (const char* name : {"m.vtu", "m.msh", "m.mesh"})
    TM::IO::write_mesh(path(name), m);
  fs::remove(path("m.sol"));
  for (const char* name : {"c.vtp", "c.vtk"})
    TM::IO::write_centerlines(path(name), c);

  const auto survives = [&](const std::string& name, const std::string& bytes) {
    const std::string file = make("x" + name, bytes);
    try {
      if (name[0] == 's') {
        Surface back;
        TM::IO::read_surface(file, back);
        EXPECT_GT(back.number_of_faces(), 0u);
      } else if (name[0] == 'm') {
        Mesh back;
        TM::IO::read_mesh(file, back);
        EXPECT_GT(back.number_of_cells() + back.number_of_facets(), 0u);
      } else {
        Centerlines back;
        TM::IO::read_centerlines(file, back);
        EXPECT_FALSE(back.lines.empty());
      }
      return true;
    } catch (const TM::Input_error&) {
      return false;
    }
  };
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory))
    names.push_back(entry.path().filename().string());
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    const std::string bytes = bytes_of(path(name));
    ASSERT_TRUE(survives(name, bytes));
    EXPECT_FALSE(survives(name, bytes.substr(0, bytes.size() / 2)));
    const std::size_t step = 1 + bytes.size() / positions;
    for (std::size_t i = 0; i < bytes.size(); i += step) {
      survives(name, bytes.substr(0, i));
      for (const int bits : {0x01, 0x88, 0xff}) {
        std::string flipped = bytes;
        flipped[i] = static_cast<char>(flipped[i] ^ bits);
        survives(name, flipped);
      }
    }
  }
}

TEST_F(IO, Centerlines_of_legacy_vtk_in_old_and_new_layouts) {
  Centerlines c;
  TM::IO::read_centerlines(
      make("old.vtk",
           "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0\n2 0 0 3 0 0\n"
           "VERTICES 1 2\n1 0\nLINES 2 6\n2 0 1\n2 2 3\nPOINT_DATA 4\nFIELD FieldData 2\n"
           "Topology 2 4 int\n1 2 3 4 5 6 7 8\nMaximumInscribedSphereRadius 1 4 double\n1 2 3 4\n"),
      c);
  EXPECT_EQ(c.lines, (std::vector<std::vector<std::size_t>>{{0, 1}, {2, 3}}));
  EXPECT_EQ(c.radius, (std::vector<double>{1, 2, 3, 4}));

  TM::IO::read_centerlines(
      make("new.vtk",
           "# vtk DataFile Version 5.1\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 double\n0 0 0 1 0 0 2 0 0\n"
           "METADATA\nINFORMATION 0\n\nLINES 2 3\nOFFSETS vtktypeint64\n0 3\nCONNECTIVITY vtktypeint64\n"
           "2 1 0\nPOINT_DATA 3\nSCALARS MaximumInscribedSphereRadius float\nLOOKUP_TABLE default\n.5 .25 1\n"),
      c);
  EXPECT_EQ(c.lines, (std::vector<std::vector<std::size_t>>{{2, 1, 0}}));
  EXPECT_EQ(c.radius, (std::vector<double>{.5, .25, 1}));

  TM::IO::read_centerlines(
      make("grid.vtk",
           "# vtk DataFile Version 2.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n0 0 0 1 0 0 2 0 0\n"
           "CELLS 3 10\n2 0 1\n3 0 1 2\n2 1 2\nCELL_TYPES 3\n3\n5\n3\n"),
      c);
  EXPECT_EQ(c.lines, (std::vector<std::vector<std::size_t>>{{0, 1}, {1, 2}}));
  EXPECT_TRUE(c.radius.empty());

  EXPECT_THROW(TM::IO::read_centerlines(make("surface.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"), c),
               TM::Input_error);
}

TEST_F(IO, Centerlines_of_gmsh_with_sparse_node_numbers) {
  Centerlines c;
  TM::IO::read_centerlines(
      make("c.msh",
           "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Comments\nx\n$EndComments\n$Nodes\n1 3 7 90\n1 1 0 3\n90\n7\n8\n"
           "9 0 0\n7 0 0\n8 0 0\n$EndNodes\n$Elements\n1 2 1 2\n1 1 1 2\n2 8 90\n1 7 8\n$EndElements\n"),
      c);
  EXPECT_EQ(c.points, (std::vector<Point>{Point(7, 0, 0), Point(8, 0, 0), Point(9, 0, 0)}));
  EXPECT_EQ(c.lines, (std::vector<std::vector<std::size_t>>{{0, 1}, {1, 2}}));
}

TEST_F(IO, An_output_file_is_written_whole_or_not_at_all) {
  make("a.txt", "old");
  {
    TM::IO::Output_file out(path("a.txt"));
    out.write("new");
    out.finish();
    EXPECT_EQ(bytes_of(path("a.txt")), "old");
  }
  EXPECT_EQ(bytes_of(path("a.txt")), "old");
  EXPECT_EQ(number_of_files(), 1u);
  TM::IO::Output_file out(path("a.txt")), second(path("b.txt"));
  out.write("new");
  second.write("too");
  out.finish();
  second.finish();
  out.commit();
  second.commit();
  EXPECT_EQ(bytes_of(path("a.txt")), "new");
  EXPECT_EQ(bytes_of(path("b.txt")), "too");
  EXPECT_EQ(number_of_files(), 2u);

  TM::IO::check_writable(path("c.txt"));
  TM::IO::check_writable(path("a.txt"));
  EXPECT_EQ(number_of_files(), 2u);
  EXPECT_EQ(bytes_of(path("a.txt")), "new");
  EXPECT_THROW(TM::IO::check_writable(path("no/such/directory.vtu")), TM::Output_error);
  EXPECT_THROW(TM::IO::check_writable(directory.string()), TM::Output_error);
  EXPECT_THROW(TM::IO::check_writable(""), TM::Output_error);
}

#ifdef __unix__
TEST_F(IO, Links_stay_links_and_devices_are_written_directly) {
  make("target.mesh", "old");
  fs::create_symlink("target.mesh", path("link.mesh"));
  fs::create_symlink("nowhere.mesh", path("dangling.mesh"));
  TM::IO::write_mesh(path("link.mesh"), sample_mesh());
  TM::IO::write_mesh(path("dangling.mesh"), sample_mesh());
  EXPECT_TRUE(fs::is_symlink(path("link.mesh")) && fs::is_symlink(path("dangling.mesh")));
  EXPECT_EQ(bytes_of(path("target.mesh")), bytes_of(path("nowhere.mesh")));
  TM::IO::Output_file null("/dev/null");
  null.write("x");
  null.commit();
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(IO, A_full_disk_is_an_output_error) {
  if (!fs::exists("/dev/full"))
    GTEST_SKIP() << "needs /dev/full";
  fs::create_symlink("/dev/full", path("full.vtu"));
  try {
    TM::IO::write_mesh(path("full.vtu"), sample_mesh());
    ADD_FAILURE() << "no error";
  } catch (const TM::Output_error& e) {
    EXPECT_NE(std::string(e.what()).find(std::strerror(ENOSPC)), std::string::npos) << e.what();
  }
}

TEST_F(IO, A_limit_on_file_size_is_an_output_error) {
  make("m.mesh", "old");
  rlimit before;
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit tight = before;
  tight.rlim_cur = 100;
  setrlimit(RLIMIT_FSIZE, &tight);
  EXPECT_THROW(TM::IO::write_mesh(path("m.mesh"), sample_mesh()), TM::Output_error);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(bytes_of(path("m.mesh")), "old");
  EXPECT_EQ(number_of_files(), 1u);
}
#endif

TEST_F(IO, Real_files) {
#ifndef TUBULAR_MESHING_SHARED_DATA
  GTEST_SKIP() << "needs shared/data";
#else
  const fs::path data = TUBULAR_MESHING_SHARED_DATA;
  struct Row {
    const char* file;
    std::size_t points, triangles;
  };
  const Row surfaces[] = {{"paper/aorta.stl", 2211, 4323},
                          {"paper/bypass.stl", 23317, 46522},
                          {"paper/carotid.stl", 5829, 11594},
                          {"paper/cerebral.stl", 40571, 80979},
                          {"paper/cylemi.stl", 523, 990},
                          {"trees/airway_lf_open.vtp", 202093, 400481},
                          {"trees/sofa_LCA.stl", 731, 1406},
                          {"trees/sofa_carotids.stl", 1164, 2289},
                          {"trees/sofa_phantom_network.obj", 3220, 6392}};
  const Row centerlines[] = {{"paper/centerlinesAORTA.vtk", 862, 858},
                             {"paper/centerlinesBYPASS.msh", 715, 711},
                             {"paper/centerlinesCAROTID.vtk", 368, 2},
                             {"paper/centerlinesCEREBRAL.vtk", 12545, 8}};
  if (!fs::exists(data / surfaces[0].file))
    GTEST_SKIP() << "needs shared/data/" << surfaces[0].file;
  for (const Row& r : surfaces) {
    Surface s;
    TM::IO::read_surface((data / r.file).string(), s);
    EXPECT_EQ(s.number_of_vertices(), r.points) << r.file;
    EXPECT_EQ(s.number_of_faces(), r.triangles) << r.file;
  }
  for (const Row& r : centerlines) {
    Centerlines c;
    TM::IO::read_centerlines((data / r.file).string(), c);
    EXPECT_EQ(c.points.size(), r.points) << r.file;
    EXPECT_EQ(c.lines.size(), r.triangles) << r.file;
  }
#endif
}
