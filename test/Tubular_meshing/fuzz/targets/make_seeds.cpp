// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes the seed corpora:  make_seeds DIRECTORY  ->  DIRECTORY/<reader>_<format>/*
// Small files as this package writes them, and by hand the variants that it reads but does not write.

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/IO/write_centerlines.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_surface.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/Surface_mesh.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

namespace {

typedef CGAL::Tubular_meshing::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Surface;
namespace Tubular = CGAL::Tubular_meshing;

std::string directory;

std::string seed(const std::string& corpus, const std::string& name) {
  std::filesystem::create_directories(directory + "/" + corpus);
  return directory + "/" + corpus + "/" + name;
}

void write_text(const std::string& corpus, const std::string& name, std::string_view text) {
  std::ofstream out(seed(corpus, name), std::ios::binary);
  out << text;
}

// Numbers as binary files hold them, in either byte order.
class Bytes {
public:
  explicit Bytes(bool big_endian)
      : big_endian_(big_endian) {}
  Bytes& text(const std::string& t) {
    bytes += t;
    return *this;
  }
  template <class T> Bytes& numbers(const std::vector<T>& values) {
    for (const T& v : values) {
      std::string b(reinterpret_cast<const char*>(&v), sizeof v);
      if (big_endian_)
        b.assign(b.rbegin(), b.rend());
      bytes += b;
    }
    return *this;
  }
  std::string bytes;

private:
  bool big_endian_;
};

const std::vector<float> square = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};

// --- surfaces ---

void surfaces() {
  Surface surface;
  std::vector<Surface::Vertex_index> v;
  for (const Point& p : {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0.1, 0.2, 1)})
    v.push_back(surface.add_vertex(p));
  surface.add_face(v[0], v[2], v[1]);
  surface.add_face(v[0], v[1], v[3]);
  surface.add_face(v[1], v[2], v[3]);
  auto patch = surface.add_property_map<Surface::Face_index, int>("f:patch", 2).first;
  const auto np = Tubular::parameters::face_patch_map(patch);
  for (const char* format : {"stl", "off", "obj", "ply", "vtp", "vtk", "msh"})
    Tubular::IO::write_surface(seed(std::string("surface_") + format, std::string("written.") + format), surface, np);

  write_text("surface_stl", "ascii.stl",
             "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1e-1 0\nendloop\nendfacet\n"
             "endsolid s\n");
  write_text("surface_off", "polygon.off",
             "COFF # a comment\n5 1 0\n0 0 0 255 0 0\n1 0 0\n1 1 0\n.5 .2 0\n0 1 0\n5 0 1 2 3 4 9\n");
  write_text("surface_obj", "polygon.obj",
             "# a comment\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2/2/2 -2 4\n");
  write_text(
      "surface_ply", "ascii.ply",
      "ply\nformat ascii 1.0\ncomment c\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property list uchar int extra\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0 0\n1 0 0 1 7\n0 1 0 0\n3 0 1 2\n");
  Bytes ply(true);
  ply.text("ply\nformat binary_big_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
           "element face 1\nproperty list uchar int vertex_index\nproperty uchar red\nend_header\n");
  ply.numbers(square).numbers<std::uint8_t>({4}).numbers<std::int32_t>({0, 1, 2, 3}).numbers<std::uint8_t>({255});
  write_text("surface_ply", "big_endian.ply", ply.bytes);
  write_text("surface_vtp", "ascii.vtp",
             "<VTKFile type=\"PolyData\" version=\"0.1\"><PolyData><Piece NumberOfPoints=\"4\" NumberOfPolys=\"1\" "
             "NumberOfStrips=\"1\"><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">"
             "0 0 0 1 0 0 0 1 0 1 1 0</DataArray></Points><Polys><DataArray type=\"Int64\" Name=\"connectivity\" "
             "format=\"ascii\">0 1 2</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3"
             "</DataArray></Polys><Strips><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 3"
             "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">4</DataArray></Strips></Piece>"
             "</PolyData></VTKFile>");
  Bytes raw(false);
  raw.text("<VTKFile type=\"PolyData\" header_type=\"UInt32\" byte_order=\"LittleEndian\"><PolyData><Piece "
           "NumberOfPoints=\"4\" NumberOfPolys=\"1\"><Points><DataArray type=\"Float32\" format=\"appended\" "
           "offset=\"0\"/></Points><Polys><DataArray type=\"Int32\" Name=\"connectivity\" format=\"appended\" "
           "offset=\"52\"/><DataArray type=\"Int32\" Name=\"offsets\" format=\"appended\" offset=\"72\"/></Polys>"
           "</Piece></PolyData><AppendedData encoding=\"raw\">_");
  raw.numbers<std::uint32_t>({48}).numbers(square).numbers<std::uint32_t>({16}).numbers<std::int32_t>({0, 1, 2, 3});
  raw.numbers<std::uint32_t>({4}).numbers<std::int32_t>({4}).text("</AppendedData></VTKFile>");
  write_text("surface_vtp", "raw.vtp", raw.bytes);
  const std::string header = "# vtk DataFile Version ";
  Bytes vtk(true);
  vtk.text(header + "3.0\nt\nBINARY\nDATASET POLYDATA\nPOINTS 4 float\n").numbers(square).text("\nPOLYGONS 1 5\n");
  vtk.numbers<std::int32_t>({4, 0, 1, 2, 3}).text("\nTRIANGLE_STRIPS 1 5\n").numbers<std::int32_t>({4, 0, 1, 2, 3});
  vtk.text("\nPOINT_DATA 4\nSCALARS s float 1\nLOOKUP_TABLE default\n").numbers<float>({1, 2, 3, 4}).text("\n");
  vtk.text("FIELD f 2\nn 1 4 int\n")
      .numbers<std::int32_t>({1, 2, 3, 4})
      .text("\nw 1 1 string\n\xC3"
            "abc\n");
  write_text("surface_vtk", "binary.vtk", vtk.bytes);
  write_text("surface_vtk", "version_5.vtk",
             header + "5.1\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n0 0 0 1 0 0 0 1 0\nMETADATA\nx\n\n"
                      "CELLS 2 3\nOFFSETS vtktypeint64\n0 3\nCONNECTIVITY vtktypeint64\n0 1 2\nCELL_TYPES 1\n5\n");
}

// --- centerlines ---

void centerlines() {
  Tubular::Centerline_polylines lines;
  lines.points = {Point(0, 0, 0), Point(0, 0, 1), Point(0, 1, 2), Point(1, 0, 2)};
  lines.radius = {1, 0.9, 0.5, 0.6};
  lines.lines = {{0, 1, 2}, {0, 1, 3}};
  for (const char* format : {"vtp", "vtk"})
    Tubular::IO::write_centerlines(seed(std::string("centerlines_") + format, std::string("written.") + format), lines);
  write_text("centerlines_vtk", "cells.vtk",
             "# vtk DataFile Version 2.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n0 0 0 0 0 1 0 0 2\n"
             "CELLS 2 6\n2 0 1\n2 1 2\nCELL_TYPES 2\n3\n4\nPOINT_DATA 3\nFIELD FieldData 1\n"
             "MaximumInscribedSphereRadius 1 3 double\n1 1 1\n");
  write_text(
      "centerlines_msh", "ascii_2.msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 0 0 1\n7 0 0 2\n$EndNodes\n$Elements\n2\n"
      "1 1 2 0 1 1 2\n2 1 2 0 1 2 7\n$EndElements\n$NodeData\n1\n\"MaximumInscribedSphereRadius\"\n1\n0\n3\n0\n1\n"
      "3\n1 1\n2 1\n7 .5\n$EndNodeData\n");
}

// --- meshes ---

void meshes() {
  Tubular::Mixed_mesh mesh;
  for (int i = 0; i < 12; ++i)
    mesh.points.emplace_back(i % 2, i / 2 % 2, i / 4);
  mesh.tetrahedra.push_back({0, 1, 2, 4}, 1);
  mesh.pyramids.push_back({0, 1, 3, 2, 8}, 1);
  mesh.prisms.push_back({0, 1, 2, 4, 5, 6}, 1);
  mesh.hexahedra.push_back({0, 1, 3, 2, 4, 5, 7, 6}, 1);
  mesh.triangles.push_back({0, 1, 2}, 1);
  mesh.quads.push_back({0, 1, 3, 2}, 2);
  mesh.region_names[1] = "lumen";
  mesh.patch_names[1] = "wall";
  mesh.patch_names[2] = "inlet";
  mesh.point_arrays.push_back({"metric", 6, std::vector<double>(72, 1.)});
  for (const char* format : {"vtu", "msh", "mesh"})
    Tubular::IO::write_mesh(seed(std::string("mesh_") + format, std::string("written.") + format), mesh);
  Tubular::IO::write_mesh(seed("mesh_msh", "written_2.msh"), mesh, Tubular::parameters::format(2.2));

  // the target reads both files of a .mesh from one
  const std::string sol = seed("mesh_mesh", "written.sol");
  std::ifstream in(sol);
  std::ofstream(seed("mesh_mesh", "written.mesh"), std::ios::app) << '\0' << in.rdbuf();
  std::filesystem::remove(sol);

  // what fuzzing has found
  const std::string start = "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n";
  write_text("mesh_mesh", "vertices_twice.mesh", start + "Tetrahedra 1\n1 2 3 4 1\nVertices 1\n0 0 0 0\nEnd\n");
  write_text("mesh_mesh", "least_integer.mesh", start + "Tetrahedra 1\n-9223372036854775808 2 3 4 1\nEnd\n");
}

// --- soups: see fuzz_repair.cpp ---

void soups() {
  std::string tube(1, char(15)); // 16 points: four squares, along z
  for (int z = 0; z < 4; ++z)
    for (int corner : {0, 1, 3, 2})
      tube += {char(2 + 3 * (corner % 2) + 8 * (2 + 3 * (corner / 2))), char(2 * z)};
  for (int z = 0; z < 3; ++z)
    for (int i = 0; i < 4; ++i) {
      const int j = (i + 1) % 4;
      for (int k : {4 * z + i, 4 * z + j, 4 * z + 4 + j, 4 * z + i, 4 * z + 4 + j, 4 * z + 4 + i})
        tube += char(k);
    }
  write_text("repair", "tube", tube);
}

} // namespace

int main(int argc, char* argv[]) {
  if (argc != 2) {
    std::cerr << "usage: make_seeds DIRECTORY\n";
    return 2;
  }
  directory = argv[1];
  try {
    surfaces();
    centerlines();
    meshes();
    soups();
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
