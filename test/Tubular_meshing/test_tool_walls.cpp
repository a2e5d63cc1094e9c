// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// tubular_mesh and walls whose thickness and materials are said by arrays of the surface's file, or by a table; fibres;
// cross-sections and zero-dimensional models.

#include "wall_vertices.h"
#include "test_tool_helpers.h"

#include <CGAL/Tubular_meshing/IO/Mesh_format.h>
#include <CGAL/Tubular_meshing/IO/write_exodus.h>
#include <CGAL/Tubular_meshing/Quads/blossom_recombination.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/Volume/Volume_mesher.h>

#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#ifdef TUBULAR_MESH_TOOL

namespace {

using namespace tool_test;
namespace labels = tubular::labels;

typedef std::function<double(const Point&)> Value;

/* A surface with a value at each point and in each triangle, as text in several formats. */
class Painted {
public:
  Painted(const Surface& surface, const Value& at_points, const Value& in_cells)
      : surface_(surface) {
    for (auto v : surface.vertices())
      point_values_.push_back(at_points(surface.point(v)));
    for (auto f : surface.faces()) {
      std::vector<Point> c;
      for (auto v : CGAL::vertices_around_face(surface.halfedge(f), surface)) {
        corners_.push_back(std::size_t(v));
        c.push_back(surface.point(v));
      }
      cell_values_.push_back(in_cells(CGAL::centroid(c[0], c[1], c[2])));
    }
  }

  std::map<int, std::string> names; // of values of cells

  std::string text(const std::string& extension) const {
    return extension == "ply" ? ply() : extension == "vtk" ? vtk() : extension == "vtp" ? vtp() : vtu();
  }

private:
  std::size_t faces() const { return cell_values_.size(); }

  std::string points() const {
    std::ostringstream s;
    s.precision(17);
    for (auto v : surface_.vertices())
      s << surface_.point(v) << "\n";
    return s.str();
  }
  static std::string list(const std::vector<double>& values) {
    std::ostringstream s;
    s.precision(17);
    for (double x : values)
      s << x << "\n";
    return s.str();
  }
  std::string list_of_corners(const std::string& before) const {
    std::ostringstream s;
    for (std::size_t i = 0; i < faces(); ++i)
      s << before << corners_[3 * i] << " " << corners_[3 * i + 1] << " " << corners_[3 * i + 2] << "\n";
    return s.str();
  }

  std::string ply() const {
    std::ostringstream s;
    s.precision(17);
    s << "ply\nformat ascii 1.0\n";
    for (const auto& n : names)
      s << "comment region " << n.first << " " << n.second << "\n";
    s << "element vertex " << surface_.number_of_vertices()
      << "\nproperty double x\nproperty double y\nproperty double z\nproperty double p\nelement face " << faces()
      << "\nproperty list uchar int vertex_indices\nproperty double c\nend_header\n";
    std::size_t i = 0;
    for (auto v : surface_.vertices())
      s << surface_.point(v) << " " << point_values_[i++] << "\n";
    for (i = 0; i < faces(); ++i)
      s << "3 " << corners_[3 * i] << " " << corners_[3 * i + 1] << " " << corners_[3 * i + 2] << " " << cell_values_[i]
        << "\n";
    return s.str();
  }

  std::string vtk() const {
    std::ostringstream s;
    s << "# vtk DataFile Version 3.0\npainted\nASCII\nDATASET POLYDATA\n";
    if (!names.empty())
      s << "FIELD FieldData " << names.size() << "\n";
    for (const auto& n : names)
      s << n.second << " 2 1 int\n" << n.first << " 3\n";
    s << "POINTS " << surface_.number_of_vertices() << " double\n"
      << points() << "POLYGONS " << faces() << " " << 4 * faces() << "\n"
      << list_of_corners("3 ") << "POINT_DATA " << surface_.number_of_vertices()
      << "\nSCALARS p double\nLOOKUP_TABLE default\n"
      << list(point_values_) << "CELL_DATA " << faces() << "\nSCALARS c double\nLOOKUP_TABLE default\n"
      << list(cell_values_);
    return s.str();
  }

  std::string xml(const std::string& dataset, const std::string& piece, const std::string& cells) const {
    std::ostringstream s;
    s << "<VTKFile type=\"" << dataset << "\" version=\"1.0\"><" << dataset << ">\n";
    if (!names.empty())
      s << "<FieldData>\n";
    for (const auto& n : names)
      s << "<DataArray type=\"Int32\" Name=\"" << n.second << "\" NumberOfTuples=\"2\" format=\"ascii\">" << n.first
        << " 3</DataArray>\n";
    if (!names.empty())
      s << "</FieldData>\n";
    s << "<Piece NumberOfPoints=\"" << surface_.number_of_vertices() << "\" " << piece << ">\n"
      << "<PointData><DataArray type=\"Float64\" Name=\"p\" format=\"ascii\">" << list(point_values_)
      << "</DataArray></PointData>\n<CellData><DataArray type=\"Float64\" Name=\"c\" format=\"ascii\">"
      << list(cell_values_) << "</DataArray></CellData>\n<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
      << "format=\"ascii\">" << points() << "</DataArray></Points>\n"
      << cells << "</Piece></" << dataset << "></VTKFile>\n";
    return s.str();
  }
  std::string connectivity() const {
    std::ostringstream s;
    s << "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">" << list_of_corners("")
      << "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">";
    for (std::size_t i = 1; i <= faces(); ++i)
      s << 3 * i << " ";
    s << "</DataArray>\n";
    return s.str();
  }
  std::string vtp() const {
    return xml("PolyData", "NumberOfPolys=\"" + std::to_string(faces()) + "\"",
               "<Polys>" + connectivity() + "</Polys>");
  }
  std::string vtu() const {
    std::string types;
    for (std::size_t i = 0; i < faces(); ++i)
      types += "5 ";
    return xml("UnstructuredGrid", "NumberOfCells=\"" + std::to_string(faces()) + "\"",
               "<Cells>" + connectivity() + "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">" + types +
                   "</DataArray></Cells>");
  }

  const Surface& surface_;
  std::vector<std::size_t> corners_;
  std::vector<double> point_values_, cell_values_;
};

double linear(const Point& p) {
  return 0.1 + 0.05 * p.z();
}
// A ring, and an area on one side.
double painted(const Point& p) {
  return p.z() > 1.5 && p.z() < 3 ? 2 : p.z() > 3.5 && p.z() < 5 && p.x() > 0.2 ? 7 : 0;
}

// The largest difference between the thickness of a wall, whose outer points come last, and that which is wanted.
double largest_difference(const Mesh& mesh, const Value& wanted) {
  const std::set<std::uint32_t> vertices = wall_vertices(mesh);
  double largest = 0;
  std::size_t far = mesh.points.size() - vertices.size();
  EXPECT_GT(vertices.size(), 0u);
  for (std::uint32_t v : vertices) {
    const double t = std::sqrt(CGAL::squared_distance(mesh.points[v], mesh.points[far++]));
    largest =
        (std::max)(largest, std::abs(t - wanted(Point(mesh.points[v].x(), mesh.points[v].y(), mesh.points[v].z()))));
  }
  return largest;
}

std::map<int, std::size_t> cells_by_region(const Mesh& mesh) {
  std::map<int, std::size_t> number;
  for (const auto* block : {&mesh.tetrahedra.label, &mesh.pyramids.label, &mesh.prisms.label, &mesh.hexahedra.label})
    for (int region : *block)
      ++number[region];
  return number;
}

TEST_F(Tool, Walls_are_as_thick_as_an_array_says) {
  const Sample s = tube();
  const Painted painting(s.surface, linear, linear);
  for (const char* extension : {"vtp", "vtu", "vtk", "ply"})
    for (const char* array : {"p", "c"}) {
      const std::string input = make(std::string("painted.") + extension, painting.text(extension));
      succeed({input, "-n", "14", "--wall-thickness-array", array, "--wall-layers", "2", "-o", out("m.vtu"),
               "--no-preserve-volume"});
      EXPECT_LT(largest_difference(mesh_in(out("m.vtu")), linear), 0.02) << extension << " " << array;
    }
  const std::string input = make("painted.vtp", painting.text("vtp"));
  // The triangles of an anisotropic wall are long and thin, whatever N: none of them is to stand across the wall, where
  // layers would have no room.
  std::vector<Arguments> types = {{"-n", "16", "--wall-elements", "tetrahedra"}, {"-n", "16", "-t", "hexahedral"}};
  for (const char* n : {"12", "14", "16", "18", "20", "22", "24"})
    types.push_back({"-n", n, "-t", "anisotropic"});
  if (tubular::has_lemon() && tubular::default_volume_mesher() != tubular::Volume_mesher::mesh_3)
    types.push_back({"-n", "16", "-t", "mixed"});
  for (const Arguments& type : types) {
    succeed(Arguments{input, "--wall-thickness-array", "p", "--wall-layers", "2", "-o", out("m.vtu"), "--report",
                      out("r.json")} +
            type);
    const Mesh mesh = mesh_in(out("m.vtu"));
    EXPECT_TRUE(tubular::validity_report(mesh).is_valid());
    const Json report = json_in(out("r.json"));
    EXPECT_EQ(report["valid"], true);
    // what is missing for want of room is said
    const double missing = 0.4 * (1 - report["wall"]["min_ratio"].get<double>());
    EXPECT_LT(largest_difference(mesh, linear), 0.03 + missing) << type.back();
    EXPECT_GT(report["wall"]["mean_ratio"], 0.98) << type[1] << " " << type.back();
  }
}

TEST_F(Tool, Walls_have_a_thickness_in_the_unit_of_the_surface) {
  const std::string input = make("y.off", bifurcation().surface);
  succeed({input, "-n", "10", "--wall-thickness", "0.15", "--wall-layers", "2", "-o", out("m.vtu")});
  const Mesh mesh = mesh_in(out("m.vtu"));
  EXPECT_LT(largest_difference(mesh, [](const Point&) { return 0.15; }), 0.15);
  succeed({make("tube.off", tube().surface), "-n", "10", "--wall-thickness", "0.15", "--second-wall-thickness", "0.1",
           "-o", out("m.vtu")});
  EXPECT_LT(largest_difference(mesh_in(out("m.vtu")), [](const Point&) { return 0.25; }), 0.01);
}

TEST_F(Tool, Walls_have_a_thickness_by_branch) {
  const Sample y = bifurcation();
  const std::string input = make("y.off", y.surface), lines = make("lines.vtk", y.lines);
  const std::string table = make("table.csv", "branch,thickness\n# the trunk\n0,0.3\n\n1, 0.1\n2,0.2\n");
  const Arguments run = {input, "-c", lines, "-n", "10", "-o", out("m.vtu"), "--wall-layers", "2"};
  succeed(run + Arguments{"--wall-thickness-table", table, "--report", out("r.json")});
  const Mesh mesh = mesh_in(out("m.vtu"));
  const Json report = json_in(out("r.json"));
  EXPECT_EQ(report["branches"].size(), 3u);
  // at the ends of the branches
  for (const auto& o : report["openings"]) {
    const double wanted = std::map<int, double>{{0, 0.3}, {1, 0.1}, {2, 0.2}}.at(o["branch"].get<int>());
    const Point center(o["center"][0], o["center"][1], o["center"][2]);
    const double radius = o["radius"];
    EXPECT_LT(largest_difference(mesh,
                                 [&](const Point& p) { // elsewhere anything from the least to the greatest
                                   return CGAL::squared_distance(p, center) < 1.3 * radius * radius ? wanted : 0.2;
                                 }),
              0.105);
  }
  make("short.csv", "1,0.1\n*,0.25\n");
  succeed(run + Arguments{"--wall-thickness-table", in("short.csv")});
  const std::string by_lines = bytes_of(out("m.vtu"));
  make("of_a_spreadsheet.csv", "\xef\xbb\xbf"
                               "1,0.1\r\n *, 0.25\r\n");
  succeed(run + Arguments{"--wall-thickness-table", in("of_a_spreadsheet.csv")});
  EXPECT_EQ(bytes_of(out("m.vtu")), by_lines);

  const std::map<std::string, std::string> bad = {{"0,0.3\n1,0.1\n", "Branch 2 has no thickness"},
                                                  {"0,0.3\n1,0.1\n2,0.1\n3,0.1\n", "no branch 3"},
                                                  {"0,0.3\n1,-0.1\n2,0.1\n", "Line 2"},
                                                  {"0,0.3\n1;0.1\n", "Line 2"},
                                                  {"0,0.3\n0,0.1\n", "branch 0"},
                                                  {"0,nan\n", "Line 1"},
                                                  {"", "no branch"},
                                                  {"*,0\n", "Line 1"},
                                                  {"*,0.1\n*,0.2\n", "Line 2"},
                                                  {"*3,0.1\n", "Line 1"}};
  for (const auto& b : bad) {
    const Outcome outcome = this->run(run + Arguments{"--wall-thickness-table", make("bad.csv", b.first)});
    EXPECT_EQ(outcome.status, tool_test::input) << b.first;
    EXPECT_NE(outcome.err.find(b.second), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(this->run(run + Arguments{"--wall-thickness-table", in("absent.csv")}).status, tool_test::input);
}

TEST_F(Tool, Arrays_that_give_no_thickness_are_refused) {
  const Sample s = tube();
  const auto outcome_of = [&](const Value& value, const char* array) {
    const Painted painting(s.surface, value, value);
    const std::string file = make("painted.ply", painting.text("ply"));
    return run({file, "-n", "8", "--wall-thickness-array", array, "-o", out("m.vtu")});
  };
  const Outcome absent = outcome_of(linear, "width");
  EXPECT_EQ(absent.status, input);
  EXPECT_NE(absent.err.find("\"width\""), std::string::npos) << absent.err;
  EXPECT_NE(absent.err.find("it has c, p"), std::string::npos) << absent.err;
  for (double bad : {0., -1., std::nan("")})
    for (const char* array : {"p", "c"}) {
      const Outcome outcome = outcome_of([&](const Point& p) { return p.z() > 3 && p.x() > 0.9 ? bad : 0.2; }, array);
      EXPECT_EQ(outcome.status, input) << bad << " " << array;
      EXPECT_NE(outcome.err.find("cannot be a thickness"), std::string::npos) << outcome.err;
    }
  const Outcome unit = outcome_of([](const Point&) { return 200.; }, "p");
  EXPECT_EQ(unit.status, input);
  EXPECT_NE(unit.err.find("unit of the surface"), std::string::npos) << unit.err;
  EXPECT_FALSE(fs::exists(out("m.vtu")));
}

TEST_F(Tool, Walls_that_have_no_room_give_way_and_it_is_said) {
  const Sample s = bifurcation();
  const Painted painting(
      s.surface, [](const Point&) { return 2.5; }, linear);
  const Outcome outcome = succeed({make("y.vtp", painting.text("vtp")), "-n", "10", "--wall-thickness-array", "p", "-o",
                                   out("m.vtu"), "--report", out("r.json")});
  EXPECT_TRUE(tubular::validity_report(mesh_in(out("m.vtu"))).is_valid());
  EXPECT_GT(json_in(out("r.json"))["wall"]["reduced_vertices"].get<int>(), 0);
  EXPECT_NE(outcome.out.find("thinner than wanted"), std::string::npos);
}

TEST_F(Tool, Areas_of_the_surface_are_regions_of_the_wall) {
  const Sample s = tube();
  Painted painting(s.surface, painted, painted);
  const std::string unnamed = make("unnamed.vtp", painting.text("vtp"));
  painting.names = {{2, "stent"}, {7, "plaque"}};
  std::vector<Arguments> types = {{}, {"--wall-elements", "tetrahedra"}, {"-t", "hexahedral"}};
  if (tubular::has_lemon() && tubular::default_volume_mesher() != tubular::Volume_mesher::mesh_3)
    types.push_back({"-t", "mixed"});
  for (const char* extension : {"vtp", "vtu", "vtk", "ply"}) {
    const std::string input = make(std::string("painted.") + extension, painting.text(extension));
    for (const Arguments& type : types) {
      const Outcome outcome =
          succeed(Arguments{input, "-n", "24", "--wall", "0.2", "--wall-layers", "2", "--material-array",
                            type.empty() ? "p" : "c", "-o", out("m.vtu"), "--report", out("r.json")} +
                  type);
      const Mesh mesh = mesh_in(out("m.vtu"));
      EXPECT_EQ(mesh.region_names.at(4), "stent");
      EXPECT_EQ(mesh.region_names.at(5), "plaque");
      EXPECT_EQ(mesh.patch_names.at(200), "material_interface");
      EXPECT_EQ(tubular::validity_report(mesh).unlabelled_interfaces, 0u);
      const std::map<int, std::size_t> cells = cells_by_region(mesh);
      const double wall = double(cells.at(2) + cells.at(4) + cells.at(5));
      EXPECT_NEAR(double(cells.at(4)) / wall, 1.5 / 6, 0.06);
      EXPECT_NEAR(double(cells.at(5)) / wall, 1.5 / 6 * 0.436, 0.05);
      const Json report = json_in(out("r.json"));
      EXPECT_EQ(report["valid"], true);
      EXPECT_EQ(report["materials"][1]["name"], "stent");
      EXPECT_EQ(report["materials"][1]["cells"], cells.at(4));
      EXPECT_NE(outcome.out.find("plaque"), std::string::npos);
      if (extension != std::string("vtp"))
        break;
    }
  }
  succeed({unnamed, "-n", "16", "--wall", "0.2", "--material-array", "c", "-o", out("m.vtu")});
  EXPECT_EQ(mesh_in(out("m.vtu")).region_names.at(5), "c_7");
  const Outcome absent = run({unnamed, "--wall", "0.2", "--material-array", "paint", "-o", out("n.vtu")});
  EXPECT_EQ(absent.status, input);
  EXPECT_NE(absent.err.find("\"paint\""), std::string::npos);
}

TEST_F(Tool, Materials_without_cells_are_an_error) {
  const Sample s = tube();
  bool is_first = true;
  const Painted painting(s.surface, linear, [&](const Point& p) {
    const bool is_painted = is_first && p.z() > 2 && p.z() < 4;
    is_first = is_first && !is_painted;
    return is_painted ? 1 : 0;
  });
  const std::string input = make("painted.vtp", painting.text("vtp"));
  const Outcome outcome = run({input, "-n", "4", "--wall", "0.2", "--material-array", "c", "-o", out("m.vtu")});
  EXPECT_EQ(outcome.status, meshing);
  EXPECT_NE(outcome.err.find("\"c_1\" has no cells"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(out("m.vtu")));
}

// Each format has the names of the regions, and what makes it up is whole.
TEST_F(Tool, Every_format_has_the_materials) {
  const Sample s = tube();
  Painted painting(s.surface, painted, painted);
  painting.names = {{2, "stent"}, {7, "plaque"}};
  const std::string input = make("painted.vtp", painting.text("vtp"));
  const Arguments common = {input, "-n", "16", "--wall", "0.2", "--wall-layers", "2", "--material-array", "c"};
  typedef tubular::IO::Mesh_format Format;
  const std::map<std::string, Format> files = {
      {"m.msh", Format::gmsh},  {"m.mesh", Format::medit}, {"m.inp", Format::abaqus},
      {"m.feb", Format::febio}, {"m.cas", Format::fluent}, {"m.exo", Format::exodus},
      {"m.cgns", Format::cgns}, {"m.xdmf", Format::xdmf},  {"polyMesh", Format::openfoam}};
  for (const auto& file : files) {
    if (!tubular::IO::why_not_built_in(file.second).empty())
      continue;
    Arguments run = common + Arguments{"-o", out(file.first)};
    if (file.second == Format::xdmf)
      run = run + Arguments{"--wall-elements", "tetrahedra"};
    succeed(run);
    const bool is_folder = file.second == Format::openfoam;
    const std::string bytes = bytes_of(is_folder ? out("polyMesh/cellZones") : out(file.first));
    for (const char* name : {"stent", "plaque", "lumen"})
      EXPECT_NE(bytes.find(name), std::string::npos) << name << " is not in " << file.first;
  }
  const Mesh gmsh = mesh_in(out("m.msh")), medit = mesh_in(out("m.mesh"));
  EXPECT_EQ(cells_by_region(gmsh), cells_by_region(medit));
  EXPECT_EQ(gmsh.region_names.at(4), "stent");

  succeed(common + Arguments{"-o", out("m.su2")}); // a zone a region, with markers on both sides of interfaces
  const std::string su2 = bytes_of(out("m.su2"));
  for (const char* words : {"NZONE= 4", "MARKER_TAG= material_interface\n", "MARKER_TAG= material_interface_stent",
                            "MARKER_TAG= material_interface_plaque", "MARKER_TAG= wall_wall", "MARKER_TAG= wall_stent"})
    EXPECT_NE(su2.find(words), std::string::npos) << words;

  succeed(common + Arguments{"-o", out("t-mesh-complete")});
  for (const char* region : {"fluid", "solid", "stent", "plaque"})
    EXPECT_TRUE(fs::exists(out("t-mesh-complete") + "/" + region + "/mesh-complete.mesh.vtu")) << region;
  EXPECT_TRUE(fs::exists(out("t-mesh-complete/stent/mesh-surfaces/material_interface.vtp")));
}

TEST_F(Tool, Fibres_are_written_where_a_format_has_a_place_for_them) {
  const std::string input = make("tube.off", tube().surface);
  const Arguments common = {input, "-n", "10", "--wall", "0.2", "--wall-layers", "2", "--fibres"};
  succeed(common + Arguments{"-o", out("m.vtu"), "--report", out("r.json")});
  const Json report = json_in(out("r.json"));
  EXPECT_EQ(report["fibres"]["cells"], report["cells"]["prisms"]);
  EXPECT_EQ(report["fibres"]["undirected"], 0);
  for (const char* name : {"circumferential", "longitudinal"})
    EXPECT_NE(bytes_of(out("m.vtu")).find("Name=\"" + std::string(name) + "\" NumberOfComponents=\"3\""),
              std::string::npos);
  succeed(common + Arguments{"-o", out("m.msh")});
  EXPECT_NE(bytes_of(out("m.msh")).find("$ElementData\n1\n\"longitudinal\""), std::string::npos);
  EXPECT_EQ(cells_by_region(mesh_in(out("m.msh"))), cells_by_region(mesh_in(out("m.vtu"))));
  for (int times = 0; times < 2; ++times) // the second time in place of the first
    succeed(common + Arguments{"-o", out("t-mesh-complete")});
  for (const char* name : {"solid/fibers-circumferential.vtu", "solid/fibers-longitudinal.vtu"})
    EXPECT_NE(bytes_of(out("t-mesh-complete") + "/" + name).find("FIB_DIR"), std::string::npos) << name;
  EXPECT_FALSE(fs::exists(out("t-mesh-complete/fluid/fibers-longitudinal.vtu")));
  succeed(common + Arguments{"-o", out("q.vtu"), "--order", "2"});
  EXPECT_NE(bytes_of(out("q.vtu")).find("circumferential"), std::string::npos);
  for (const auto& [file, words] : {std::pair<const char*, const char*>{"m.feb", "type=\"mat_axis\" elem_set=\"wall\""},
                                    {"m.inp", "*ORIENTATION, NAME=fibres"},
                                    {"m.exo", "longitudinal_z"}}) {
    if (file == std::string("m.exo") && !tubular::IO::has_exodus())
      continue;
    for (const char* order : {"1", "2"}) {
      succeed(common + Arguments{"-o", out(file), "--order", order});
      EXPECT_NE(bytes_of(out(file)).find(words), std::string::npos) << file << ' ' << order;
    }
  }
}

TEST_F(Tool, Sections_and_a_model_come_beside_the_mesh) {
  const std::string input = make("y.off", bifurcation().surface);
  const Arguments common = {input, "-n", "10", "-o", out("m.vtu")};
  const Outcome outcome =
      succeed(common + Arguments{"--write-sections", out("s.csv"), "--write-0d", out("z.json"), "--length-unit", "mm",
                                 "--murray", "--flow-rate", "2", "--report", out("r.json")});
  EXPECT_NE(outcome.out.find("0D model: 3 vessels, 1 junctions, 3 ends"), std::string::npos) << outcome.out;
  const Json model = json_in(out("z.json")), report = json_in(out("r.json"));
  EXPECT_EQ(report["zero_d_model"]["vessels"], 3);
  EXPECT_EQ(lines_of(bytes_of(out("s.csv"))).size(), 1 + report["sections"]["count"].get<std::size_t>());
  std::map<std::string, Json> conditions;
  for (const auto& c : model["boundary_conditions"])
    conditions[c["bc_name"]] = c["bc_values"];
  EXPECT_EQ(conditions["inlet"]["Q"][0], 2.0);
  // 13332 Pa and 2 ml/s over the outlets, by the cube of their radii
  const double a = conditions["outlet_1"]["R"], b = conditions["outlet_2"]["R"];
  EXPECT_NEAR(1 / (1 / a + 1 / b), 133320 / 2., 1);
  EXPECT_NEAR(
      b / a, std::pow(report["openings"][1]["radius"].get<double>() / report["openings"][2]["radius"].get<double>(), 3),
      1e-6);
  for (const auto& v : model["vessels"]) { // between those of tubes of the largest and of the smallest radius, in cm
    const Json branch = report["branches"][v["vessel_id"].get<std::size_t>()];
    const auto of_tube = [&](const char* radius) {
      return 8 * 0.04 * 0.1 * branch["length"].get<double>() /
             (std::acos(-1.) * std::pow(0.1 * branch[radius].get<double>(), 4));
    };
    const double resistance = v["zero_d_element_values"]["R_poiseuille"];
    EXPECT_GT(resistance, 0.95 * of_tube("max_radius")); // radii are those of inscribed balls, smaller than of areas
    EXPECT_LT(resistance, of_tube("min_radius"));
  }
  EXPECT_EQ(report.dump().find("another unit"), std::string::npos);
  // a vessel of micrometres, or of metres, is none
  for (const char* unit : {"um", "m"}) {
    succeed(common + Arguments{"--write-0d", out("z.json"), "--length-unit", unit, "--report", out("r.json")});
    EXPECT_NE(json_in(out("r.json")).dump().find("another unit"), std::string::npos) << unit;
  }
  succeed(common + Arguments{"--write-sections", out("s.vtp"), "--section-spacing", "1", "-q"});
  EXPECT_NE(bytes_of(out("s.vtp")).find("hydraulic_diameter"), std::string::npos);
}

} // namespace

#endif // TUBULAR_MESH_TOOL
