// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Labels and names of faces in files: what is read of them, and that what is written comes back.

#include "io_fixture.h"

#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_surface.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

using TM::IO::read_surface_data;
typedef TM::IO::Surface_data Data;

// Four triangles round a point, in a plane; the first two and the last two have a label each.
const char* const points_text = "0 0 0  1 0 0  0 1 0  -1 0 0  0 -1 0";
const char* const corners_text = "0 1 2  0 2 3  0 3 4  0 4 1";

std::string vtp(const std::string& arrays, const std::string& fields = "") {
  return std::string("<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\"><PolyData><FieldData>") +
         fields +
         "</FieldData><Piece NumberOfPoints=\"5\" NumberOfVerts=\"1\" NumberOfLines=\"1\" NumberOfStrips=\"0\" "
         "NumberOfPolys=\"4\"><PointData><DataArray type=\"Float64\" Name=\"size\" format=\"ascii\">1 2 3 4 5"
         "</DataArray></PointData><CellData>" +
         arrays + "</CellData><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">" +
         points_text +
         "</DataArray></Points><Verts><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0</DataArray>"
         "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">1</DataArray></Verts><Lines><DataArray "
         "type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1</DataArray><DataArray type=\"Int64\" "
         "Name=\"offsets\" format=\"ascii\">2</DataArray></Lines><Polys><DataArray type=\"Int64\" "
         "Name=\"connectivity\" format=\"ascii\">" +
         corners_text +
         "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3 6 9 12</DataArray></Polys>"
         "</Piece></PolyData></VTKFile>";
}

// The first two values are those of the vertex and of the line.
std::string array(const std::string& name, const std::string& values) {
  return "<DataArray type=\"Int32\" Name=\"" + name + "\" format=\"ascii\">" + values + "</DataArray>";
}

TEST_F(IO, Cell_arrays_of_known_names_are_labels) {
  for (const char* name : {"ModelFaceID", "CapID", "CellEntityIds", "patch", "gmsh:physical", "medit:ref"}) {
    const Data data = read_surface_data(make("a.vtp", vtp(array("other", "0 0 9 8 7 6") + array(name, "5 6 1 1 2 2"))));
    EXPECT_EQ(data.labels.label, (std::vector<int>{1, 1, 2, 2})) << name;
    EXPECT_EQ(data.labels.array, name);
    EXPECT_EQ(data.labels.source, std::string("cell array ") + name);
    EXPECT_EQ(data.labels.names.empty(), std::string(name) != "patch");
    EXPECT_EQ(data.points.size(), 5u);
    EXPECT_EQ(data.point_arrays.at("size"), (std::vector<double>{1, 2, 3, 4, 5}));
    EXPECT_TRUE(data.notes.empty());
  }
}

TEST_F(IO, Conventions_say_which_label_is_the_wall) {
  const auto wall = [&](const char* name, const char* values) {
    return read_surface_data(make("a.vtp", vtp(array(name, values)))).labels.wall;
  };
  EXPECT_EQ(wall("CellEntityIds", "0 0 1 1 2 3"), 1);
  EXPECT_EQ(wall("CellEntityIds", "0 0 0 0 2 3"), 0);
  EXPECT_EQ(wall("CapID", "0 0 3 2 1 1"), 1);
  EXPECT_EQ(wall("CellEntityIds", "0 0 7 8 9 9"), std::nullopt);
  EXPECT_EQ(wall("ModelFaceID", "0 0 1 2 3 3"), std::nullopt);
  EXPECT_EQ(wall("patch", "0 0 1 2 3 3"), 1);
}

TEST_F(IO, Arrays_that_are_no_labels) {
  EXPECT_TRUE(read_surface_data(make("a.vtp", vtp(array("ModelFaceID", "1 2 7 7 7 7")))).labels.empty());
  EXPECT_TRUE(read_surface_data(make("a.vtp", vtp(array("ModelFaceID", "1 2 0.5 1 2 3")))).labels.empty());
  EXPECT_TRUE(read_surface_data(make("a.vtp", vtp(array("ModelFaceID", "1 2 3")))).labels.empty());
  EXPECT_TRUE(read_surface_data(make("a.vtp", vtp(array("other", "1 2 3 4 5 6")))).labels.empty());
  EXPECT_TRUE(read_surface_data(make("a.vtp", vtp(""))).labels.empty());
}

TEST_F(IO, A_cell_array_by_name) {
  const std::string file = make("a.vtp", vtp(array("ModelFaceID", "5 6 1 1 2 2") + array("mine", "0 0 4 5 4 4") +
                                             array("one", "1 1 1 1 1 1") + array("half", "0 0 0.5 1 2 3")));
  EXPECT_EQ(read_surface_data(file, "mine").labels.label, (std::vector<int>{4, 5, 4, 4}));
  for (const char* bad : {"none", "one", "half"})
    try {
      read_surface_data(file, bad);
      ADD_FAILURE() << bad;
    } catch (const TM::Input_error& e) {
      EXPECT_NE(std::string(e.what()).find(bad), std::string::npos) << e.what();
    }
}

TEST_F(IO, Names_of_labels_are_fields) {
  const Data data = read_surface_data(
      make("a.vtp", vtp(array("patch", "0 0 1 1 2 2"), array("skin", "1 2") + array("aorta", "2 2 1 3"))));
  EXPECT_EQ(data.labels.names, (TM::Label_names{{1, "skin"}, {2, "aorta"}}));
}

std::string facet(int i) {
  const char* const vertices[] = {"1 0 0", "0 1 0", "-1 0 0", "0 -1 0"};
  return std::string("facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex ") + vertices[i] + "\nvertex " +
         vertices[(i + 1) % 4] + "\nendloop\nendfacet\n";
}

TEST_F(IO, Solids_are_labels) {
  const Data data = read_surface_data(
      make("a.stl", "solid vessel wall\n" + facet(0) + "endsolid vessel wall\nsolid in\n" + facet(1) +
                        "endsolid\nsolid vessel wall\n" + facet(2) + "endsolid\nsolid \n" + facet(3) + "endsolid\n"));
  ASSERT_EQ(data.labels.label.size(), 4u);
  EXPECT_EQ(data.labels.source, "solids");
  EXPECT_EQ(data.labels.label[0], data.labels.label[2]);
  EXPECT_EQ(std::set<int>(data.labels.label.begin(), data.labels.label.end()).size(), 3u);
  EXPECT_EQ(data.labels.names.at(data.labels.label[0]), "vessel wall");
  EXPECT_EQ(data.labels.names.at(data.labels.label[1]), "in");
  EXPECT_EQ(data.labels.names.count(data.labels.label[3]), 0u);
  EXPECT_EQ(data.points.size(), 5u);
  EXPECT_TRUE(read_surface_data(make("b.stl", "solid a\n" + facet(0) + facet(1) + "endsolid a\n")).labels.empty());
}

TEST_F(IO, Groups_and_objects_are_labels) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\n";
  const Data data = read_surface_data(
      make("a.obj", vertices + "o body\nf 1 2 3\ng cap extra\nf 1 3 4\nf 2 3\no body\nf 1 4 5\nf 1\nf 1 5 2\n"));
  ASSERT_EQ(data.labels.label.size(), 4u);
  EXPECT_EQ(data.labels.source, "groups");
  EXPECT_EQ(data.labels.label[0], data.labels.label[3]);
  EXPECT_EQ(data.labels.names.at(data.labels.label[1]), "cap");
  ASSERT_EQ(data.notes.size(), 1u);
  EXPECT_NE(data.notes[0].find("2 faces"), std::string::npos) << data.notes[0];
  EXPECT_TRUE(read_surface_data(make("b.obj", vertices + "o body\nf 1 2 3\nf 1 3 4\n")).labels.empty());
}

TEST_F(IO, A_cut_off_obj_file_is_refused) {
  const std::string head = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  EXPECT_EQ(read_surface_data(make("a.obj", head + "f 1 2\n")).triangles.size(), 1u);
  EXPECT_THROW(read_surface_data(make("b.obj", head + "f 1 2")), TM::Input_error);
  EXPECT_EQ(read_surface_data(make("c.obj", head + "f 3 2 1")).triangles.size(), 2u);
}

TEST_F(IO, Physical_groups_are_labels) {
  const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n2 7 \"skin\"\n2 9 \"aorta\"\n3 1 "
                           "\"blood\"\n$EndPhysicalNames\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 -1 0 0\n5 0 -1 0\n"
                           "$EndNodes\n$Elements\n5\n1 1 2 3 1 1 2\n2 2 2 7 1 1 2 3\n3 2 2 9 1 1 3 4\n";
  const Data data = read_surface_data(make("a.msh", head + "4 2 2 7 1 1 4 5\n5 2 2 7 1 1 5 2\n$EndElements\n"));
  EXPECT_EQ(data.labels.label, (std::vector<int>{7, 9, 7, 7}));
  EXPECT_EQ(data.labels.names, (TM::Label_names{{7, "skin"}, {9, "aorta"}}));
  EXPECT_EQ(data.labels.source, "physical groups");
}

// --- names that are written come back ---

struct Named {
  Surface surface;
  TM::Face_patch_map patch;
  TM::Label_names names = {{1, "vessel_wall"}, {2, "inlet_aorta"}, {5, "left"}};
};

Named named_surface() {
  Named n;
  n.surface = tetrahedron();
  n.patch = n.surface.add_property_map<Surface::Face_index, int>("f:patch", 1).first;
  n.patch[Surface::Face_index(1)] = 2;
  n.patch[Surface::Face_index(2)] = 5;
  return n;
}

TEST_F(IO, Names_of_a_surface_go_round) {
  const Named n = named_surface();
  for (const char* ext : {"vtp", "vtk", "ply", "obj", "stl", "msh"}) {
    const std::string file = path(std::string("s.") + ext);
    TM::IO::write_surface(file, n.surface, TM::parameters::face_patch_map(n.patch).patch_names(n.names));
    const Data data = read_surface_data(file);
    ASSERT_EQ(data.triangles.size(), 4u) << ext;
    std::multiset<std::string> found;
    for (int l : data.labels.label)
      found.insert(data.labels.names.at(l));
    EXPECT_EQ(found, (std::multiset<std::string>{"vessel_wall", "vessel_wall", "inlet_aorta", "left"})) << ext;
    std::set<Point> points(data.points.begin(), data.points.end()), expected;
    for (auto v : n.surface.vertices())
      expected.insert(n.surface.point(v));
    EXPECT_EQ(points, expected) << ext; // to the last bit, also in STL
  }
}

TEST_F(IO, Names_with_blanks_are_kept_where_they_can_be) {
  Named n = named_surface();
  n.names[2] = "inlet of the aorta";
  for (const char* ext : {"vtp", "ply", "stl", "msh"}) {
    const std::string file = path(std::string("s.") + ext);
    TM::IO::write_surface(file, n.surface, TM::parameters::face_patch_map(n.patch).patch_names(n.names));
    const Data data = read_surface_data(file);
    EXPECT_EQ(data.labels.names.at(data.labels.label[ext == std::string("stl") ? 2 : 1]), "inlet of the aorta") << ext;
  }
  n.names[2] = "a \"b\"";
  EXPECT_THROW(
      TM::IO::write_surface(path("s.stl"), n.surface, TM::parameters::face_patch_map(n.patch).patch_names(n.names)),
      TM::Output_error);
}

TEST_F(IO, Without_names_nothing_changes) {
  const Named n = named_surface();
  for (const char* ext : {"vtp", "vtk", "ply", "obj", "stl", "msh", "off"}) {
    TM::IO::write_surface(path(std::string("a.") + ext), n.surface, TM::parameters::face_patch_map(n.patch));
    TM::IO::write_surface(
        path(std::string("b.") + ext), n.surface,
        TM::parameters::face_patch_map(n.patch).patch_names(TM::Label_names()).patch_ids(TM::Patch_ids()));
    EXPECT_EQ(bytes_of(path(std::string("a.") + ext)), bytes_of(path(std::string("b.") + ext))) << ext;
  }
}

TEST_F(IO, Numbers_of_patches_are_an_array) {
  const Named n = named_surface();
  const TM::Patch_ids ids{"ModelFaceID", {{1, 30}, {2, 10}, {5, 20}}};
  for (const char* ext : {"vtp", "vtk"}) {
    const std::string file = path(std::string("s.") + ext);
    TM::IO::write_surface(file, n.surface, TM::parameters::face_patch_map(n.patch).patch_ids(ids));
    EXPECT_EQ(read_surface_data(file).labels.label, (std::vector<int>{30, 10, 20, 30})) << ext;
  }
  Mesh mesh;
  for (auto v : n.surface.vertices())
    mesh.points.push_back(n.surface.point(v));
  mesh.tetrahedra.push_back({0, 1, 2, 3}, 1);
  mesh.triangles.push_back({0, 1, 2}, 1);
  mesh.triangles.push_back({1, 2, 3}, 2);
  mesh.triangles.push_back({0, 2, 3}, 7); // which had none
  mesh.patch_ids = ids;
  TM::IO::write_mesh(path("m.vtu"), mesh);
  EXPECT_EQ(read_surface_data(path("m.vtu"), "ModelFaceID").labels.label, (std::vector<int>{30, 10, 0}));
  EXPECT_EQ(read_surface_data(path("m.vtu"), "patch").labels.label, (std::vector<int>{1, 2, 7}));
}

} // namespace
