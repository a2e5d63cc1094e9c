// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line tool on surfaces whose faces have labels: the openings that these mark, and the names that go out.

#include "labelled_surfaces.h"
#include "test_tool_helpers.h"
#include "test_tool_report.h"

#include <CGAL/Tubular_meshing/IO/read_surface.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#ifdef TUBULAR_MESH_TOOL

namespace {

using namespace tool_test;
using test_surfaces::Labelled_mesh;

std::string numbers(const std::vector<int>& values) {
  std::ostringstream out;
  for (int v : values)
    out << v << ' ';
  return out.str();
}

// As SimVascular and VMTK write them, but in ASCII.
std::string vtp_of(const Labelled_mesh& m, const std::string& array) {
  std::ostringstream points, corners, offsets;
  points.precision(17);
  for (auto v : m.mesh.vertices())
    points << m.mesh.point(v) << '\n';
  int n = 0;
  for (auto f : m.mesh.faces()) {
    for (auto v : m.mesh.vertices_around_face(m.mesh.halfedge(f)))
      corners << std::size_t(v) << ' ';
    offsets << (n += 3) << ' ';
  }
  const auto data = [](const std::string& type, const std::string& name, int components, const std::string& values) {
    return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" + std::to_string(components) +
           "\" format=\"ascii\">" + values + "</DataArray>";
  };
  return "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\"><PolyData><Piece NumberOfPoints=\"" +
         std::to_string(m.mesh.number_of_vertices()) + "\" NumberOfPolys=\"" +
         std::to_string(m.mesh.number_of_faces()) + "\"><CellData>" + data("Int32", array, 1, numbers(m.label)) +
         "</CellData><Points>" + data("Float64", "Points", 3, points.str()) + "</Points><Polys>" +
         data("Int64", "connectivity", 1, corners.str()) + data("Int64", "offsets", 1, offsets.str()) +
         "</Polys></Piece></PolyData></VTKFile>";
}

std::string solids_of(const Labelled_mesh& m, const std::map<int, std::string>& names) {
  std::ostringstream out;
  out.precision(9);
  for (const auto& n : names) {
    out << "solid " << n.second << '\n';
    std::size_t i = 0;
    for (auto f : m.mesh.faces()) {
      if (m.label[i++] != n.first)
        continue;
      out << "facet normal 0 0 0\nouter loop\n";
      for (auto v : m.mesh.vertices_around_face(m.mesh.halfedge(f)))
        out << "vertex " << m.mesh.point(v) << '\n';
      out << "endloop\nendfacet\n";
    }
    out << "endsolid " << n.second << '\n';
  }
  return out.str();
}

Labelled_mesh domed() {
  return test_surfaces::with_domes(test_surfaces::open_bifurcation(14), {0.9, 0.5, 0.2}, 1, 2);
}

const std::map<int, std::string>& names() {
  static const std::map<int, std::string> list = {
      {1, "vessel_wall"}, {2, "outlet_trunk"}, {3, "inlet_left"}, {4, "right one"}};
  return list;
}

std::set<std::string> names_of(const Mesh& mesh) {
  std::set<std::string> result;
  for (const auto& n : mesh.patch_names)
    result.insert(n.second);
  return result;
}

std::set<std::string> opening_names(const Json& report) {
  std::set<std::string> result;
  for (const Json& o : report["openings"])
    result.insert(o["name"].get<std::string>());
  return result;
}

struct Kind {
  const char* name;
  Arguments arguments;
};

std::ostream& operator<<(std::ostream& out, const Kind& k) {
  return out << k.name;
}

class Labelled : public Tool, public ::testing::WithParamInterface<Kind> {};

TEST_P(Labelled, Domes_become_openings_and_keep_their_numbers) {
  if (std::string(GetParam().name) != "Isotropic" && std::string(GetParam().name) != "Anisotropic")
    NEEDS_FILLING();
  const Outcome outcome = succeed(Arguments{make("y.vtp", vtp_of(domed(), "ModelFaceID")), "-n", "10", "-o",
                                            out("mesh.vtu"), "--report", out("r.json")} +
                                  GetParam().arguments);
  const Json report = json_in(out("r.json"));
  EXPECT_EQ(report["valid"], true);
  EXPECT_EQ(opening_names(report), (std::set<std::string>{"face_2", "face_3", "face_4"}));
  for (const Json& o : report["openings"])
    EXPECT_EQ("face_" + std::to_string(o["label"].get<int>()), o["name"]);
  EXPECT_EQ(report["labels"]["source"], "cell array ModelFaceID");
  EXPECT_NE(outcome.out.find("labels: cell array ModelFaceID; wall: 1; ends: 2, 3, 4"), std::string::npos)
      << outcome.out;

  const Mesh mesh = mesh_in(out("mesh.vtu"));
  std::map<int, std::set<int>> ids; // the array's, by patch
  const auto data = tubular::IO::read_surface_data(out("mesh.vtu"), "ModelFaceID");
  const auto patches = tubular::IO::read_surface_data(out("mesh.vtu"), "patch");
  for (std::size_t i = 0; i < data.labels.label.size(); ++i)
    ids[patches.labels.label[i]].insert(data.labels.label[i]);
  EXPECT_EQ(ids.at(1), std::set<int>{1});
  for (const Json& o : report["openings"])
    EXPECT_EQ(ids.at(o["patch"]), std::set<int>{o["label"]});
}

TEST_P(Labelled, Names_go_out_and_say_which_is_the_inlet) {
  if (std::string(GetParam().name) != "Isotropic" && std::string(GetParam().name) != "Anisotropic")
    NEEDS_FILLING();
  succeed(Arguments{make("y.stl", solids_of(domed(), names())), "-n", "10", "-o", out("mesh.msh"), "--report",
                    out("r.json")} +
          GetParam().arguments);
  const Json report = json_in(out("r.json"));
  EXPECT_EQ(opening_names(report), (std::set<std::string>{"outlet_trunk", "inlet_left", "right one"}));
  EXPECT_EQ(report["openings"][0]["name"], "inlet_left");
  const Mesh mesh = mesh_in(out("mesh.msh"));
  EXPECT_EQ(mesh.patch_names.at(1), "vessel_wall");
  EXPECT_EQ(mesh.patch_names.at(2), "inlet_left");
  for (const char* name : {"vessel_wall", "outlet_trunk", "inlet_left", "right one"})
    EXPECT_EQ(names_of(mesh).count(name), 1u) << name;
  if (std::string(GetParam().name) == "Mixed_with_wall") {
    EXPECT_EQ(mesh.patch_names.at(102), "inlet_left_ring");
  }
}

INSTANTIATE_TEST_SUITE_P(Types, Labelled,
                         ::testing::Values(Kind{"Isotropic", {}}, Kind{"Anisotropic", {"-t", "anisotropic"}},
                                           Kind{"Mixed_with_wall", {"-t", "mixed", "--wall", "0.2"}},
                                           Kind{"Prisms", {"--boundary-layer-prisms", "2"}}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_F(Tool, Names_are_in_every_format) {
  const std::string surface = make("y.stl", solids_of(domed(), names()));
  const std::set<std::string> wanted = {"vessel_wall", "outlet_trunk", "inlet_left", "right one"};
  for (const char* ext : {"vtu", "msh", "mesh"}) {
    succeed({surface, "-n", "8", "-o", out(std::string("m.") + ext)});
    EXPECT_EQ(names_of(mesh_in(out(std::string("m.") + ext))), wanted) << ext;
  }
  succeed({surface, "-n", "8", "-o", out("m.inp")});
  const std::string deck = bytes_of(out("m.inp"));
  for (const char* set : {"NSET=vessel_wall", "NSET=outlet_trunk", "NSET=inlet_left", "NSET=right_one"})
    EXPECT_NE(deck.find(set), std::string::npos) << set;
  for (const char* ext : {"stl", "vtp", "msh", "ply", "obj", "vtk"}) {
    const std::string file = out(std::string("s.") + ext);
    succeed({surface, "-n", "8", "-t", "surface", "-o", file});
    const auto labels = tubular::IO::read_surface_data(file).labels;
    std::set<std::string> found;
    for (int l : labels.label)
      found.insert(labels.names.at(l));
    std::set<std::string> expected = wanted;
    if (ext == std::string("obj") || ext == std::string("vtk")) {
      expected.erase("right one");
      expected.insert("right_one");
    }
    EXPECT_EQ(found, expected) << ext;
  }
}

TEST_F(Tool, A_labelled_surface_goes_round) {
  succeed({make("y.stl", solids_of(domed(), names())), "-n", "12", "-t", "surface", "-o", out("s.vtp"), "--report",
           out("a.json")});
  succeed({out("s.vtp"), "-n", "8", "-o", out("m.vtu"), "--report", out("b.json")});
  EXPECT_EQ(opening_names(json_in(out("a.json"))), opening_names(json_in(out("b.json"))));
  EXPECT_EQ(json_in(out("b.json"))["openings"][0]["name"], "inlet_left");
}

TEST_F(Tool, The_inlet_by_name_or_number) {
  const std::string solids = make("y.stl", solids_of(domed(), names())), ids = make("y.vtp", vtp_of(domed(), "CapID"));
  const auto inlet = [&](const std::string& surface, const Arguments& arguments) {
    succeed(Arguments{surface, "-n", "8", "-t", "surface", "-o", out("s.vtp"), "--report", out("r.json")} + arguments);
    return json_in(out("r.json"))["openings"][0]["name"].get<std::string>();
  };
  EXPECT_EQ(inlet(solids, {"--inlet", "right one"}), "right one");
  EXPECT_EQ(inlet(solids, {"--inlet", "outlet_trunk"}), "outlet_trunk");
  EXPECT_EQ(inlet(solids, {"--inlet", "0,0,0"}), "outlet_trunk"); // where the trunk begins
  EXPECT_EQ(inlet(ids, {"--inlet", "3"}), "face_3");
  EXPECT_EQ(inlet(ids, {"--inlet", "face_4"}), "face_4");
  EXPECT_EQ(inlet(ids, {"--inlet", "3", "--flow-extensions", "2"}), "face_3");

  expect_one_sentence(run({solids, "-o", out("m.vtu"), "--inlet", "aorta"}), {"aorta", "inlet_left", "outlet_trunk"});
  EXPECT_EQ(run({solids, "-o", out("m.vtu"), "--inlet", "aorta"}).status, usage);
  const std::string plain = make("y.off", test_surfaces::open_bifurcation(14));
  expect_one_sentence(run({plain, "-o", out("m.vtu"), "--inlet", "aorta"}), {"aorta", "X,Y,Z"});
}

TEST_F(Tool, Patches_are_renamed) {
  const std::string plain = make("y.off", test_surfaces::open_bifurcation(14));
  succeed({plain, "-n", "8", "-t", "mixed", "--wall", "0.2", "-o", out("m.vtu"), "--rename", "inlet=aorta", "--rename",
           "outlet_2=left=right", "--rename", "outer_wall=adventitia", "--report", out("r.json")});
  const Mesh mesh = mesh_in(out("m.vtu"));
  EXPECT_EQ(mesh.patch_names.at(2), "aorta");
  EXPECT_EQ(mesh.patch_names.at(3), "outlet_1");
  EXPECT_EQ(mesh.patch_names.at(4), "left=right");
  EXPECT_EQ(mesh.patch_names.at(100), "adventitia");
  EXPECT_EQ(mesh.patch_names.at(102), "aorta_ring");
  EXPECT_EQ(json_in(out("r.json"))["openings"][0]["name"], "aorta");

  const auto refused = [&](const Arguments& arguments, const Arguments& mentioned) {
    const Outcome outcome = run(Arguments{plain, "-n", "8", "-o", out("n.vtu")} + arguments);
    EXPECT_EQ(outcome.status, usage);
    expect_one_sentence(outcome, mentioned);
  };
  refused({"--rename", "vein=aorta"}, {"vein", "outlet_2"});
  refused({"--rename", "inlet=wall"}, {"wall"});
  refused({"--rename", "inlet"}, {"NAME=NEW"});
  refused({"--rename", "=x"}, {"NAME=NEW"});
}

TEST_F(Tool, Any_cell_array_may_be_the_labels) {
  const std::string file = make("y.vtp", vtp_of(domed(), "MyFaces"));
  expect_one_sentence(run({file, "-o", out("m.vtu"), "--faces", "Faces"}), {"Faces", "MyFaces"});
  EXPECT_EQ(run({file, "-o", out("m.vtu"), "--faces", "Faces"}).status, input);
  succeed({file, "--faces", "MyFaces", "-n", "8", "-t", "surface", "-o", out("s.vtp"), "--report", out("r.json")});
  EXPECT_EQ(json_in(out("r.json"))["openings"].size(), 3u);
}

TEST_F(Tool, What_labels_are_not_understood_is_told) {
  Labelled_mesh m = domed();
  std::size_t i = 0;
  for (auto f : m.mesh.faces()) { // a ring of the trunk
    const double z = m.mesh.point(m.mesh.target(m.mesh.halfedge(f))).z();
    if (m.label[i] == 1 && z > 2 && z < 4)
      m.label[i] = 8;
    ++i;
  }
  const Outcome outcome = succeed({make("y.vtp", vtp_of(m, "ModelFaceID")), "-n", "8", "-t", "surface", "-o",
                                   out("s.vtp"), "--report", out("r.json")});
  EXPECT_NE(outcome.out.find("note: label 8"), std::string::npos) << outcome.out;
  const Json report = json_in(out("r.json"));
  EXPECT_EQ(report["openings"].size(), 3u);
  for (const Json& l : report["labels"]["labels"]) {
    EXPECT_EQ(l["understood"], l["label"] != 8);
    EXPECT_EQ(l["reason"].is_null(), l["label"] != 8);
  }
}

TEST_F(Tool, Loose_edges_of_obj_files_are_skipped_and_told) {
  tubular::IO::write_surface(in("y.obj"), test_surfaces::open_bifurcation(14));
  std::string text = bytes_of(in("y.obj"));
  const std::size_t face = text.find("\nf ", text.size() / 2) + 1;
  text.insert(face, "f 102 30\n");
  const Outcome outcome = succeed({make("z.obj", text), "-n", "8", "-o", out("m.vtu"), "--report", out("r.json")});
  EXPECT_NE(outcome.out.find("fewer than three corners"), std::string::npos) << outcome.out;
  const Json report = json_in(out("r.json"));
  ASSERT_EQ(report["notes"].size(), 1u);
  EXPECT_EQ(report["openings"].size(), 3u);
  EXPECT_TRUE(report["repairs"].empty());
}

} // namespace

#endif // TUBULAR_MESH_TOOL
