// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces as other programs write them: what VTK and meshio wrote, where they are installed, and variants of formats
// that this test writes itself.

#include "installed_programs.h"
#include "io_fixture.h"

#include <CGAL/Tubular_meshing/IO/internal/decompress.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <set>
#include <string>
#include <vector>

namespace {

using TM::IO::read_surface_data;
typedef TM::IO::Surface_data Data;

double area_of(const Data& data) {
  double sum = 0;
  for (const auto& t : data.triangles) {
    const TM::Vector_3 n =
        CGAL::cross_product(data.points[t[1]] - data.points[t[0]], data.points[t[2]] - data.points[t[0]]);
    sum += std::sqrt(n.squared_length()) / 2;
  }
  return sum;
}

TEST_F(IO, All_that_VTK_and_meshio_write) {
  const std::string log = path("log");
  const int status = run_script("write_by_programs.py", {directory.string()}, log);
  if (status == lacks_packages)
    GTEST_SKIP() << "needs VTK or meshio in Python";
  ASSERT_EQ(status, 0) << bytes_of(log);
  fs::remove(log);
  const double area = 2 * 12 * std::sin(CGAL_PI / 12) * 5; // of a prism of 12 sides, 5 high
  std::size_t files = 0, labelled = 0;
  for (const auto& entry : fs::directory_iterator(directory)) {
    const std::string name = entry.path().filename().string();
    if (name.find("lzma") != name.npos && !TM::IO::internal::has_lzma())
      continue;
    SCOPED_TRACE(name);
    ++files;
    Data data;
    ASSERT_NO_THROW(data = read_surface_data(entry.path().string()));
    EXPECT_EQ(data.triangles.size(), 240u);
    EXPECT_NEAR(area_of(data), area, 1e-4);
    const bool has_labels = !data.labels.empty();
    labelled += has_labels;
    if (has_labels) {
      EXPECT_EQ(std::count(data.labels.label.begin(), data.labels.label.end(), 2), 48);
    }
    const auto size = data.point_arrays.find("size");
    if (size != data.point_arrays.end()) {
      EXPECT_EQ(size->second, std::vector<double>(data.points.size(), 0.5));
    }
  }
  EXPECT_GE(files, 20u);
  EXPECT_GE(labelled, 5u);
}

// --- LZ4 ---

TEST(Lz4_block, Literals_and_overlapping_copies) {
  using TM::IO::internal::Compression;
  using TM::IO::internal::decompress;
  const auto unpacked = [](const std::string& packed, std::size_t bytes) {
    std::string out = "before" + std::string(bytes, '?') + "after";
    const bool sound = decompress(Compression::lz4, packed, &out[6], bytes);
    EXPECT_EQ(out.substr(0, 6) + out.substr(6 + bytes), "beforeafter");
    return sound ? out.substr(6, bytes) : std::string("damaged");
  };
  EXPECT_EQ(unpacked(std::string("\x30") + "abc", 3), "abc");
  // "ab", then eleven bytes from two before, then "xyzvw"
  EXPECT_EQ(unpacked(std::string("\x27") + "ab" + std::string("\x02\x00", 2) + "\x50" + "xyzvw", 18),
            "ababababababaxyzvw");
  // a run of 15 + 255 + 5 literals
  const std::string run(275, 'r');
  EXPECT_EQ(unpacked("\xf0\xff\x05" + run, 275), run);
  // 4 + 15 + 10 copies of one byte
  EXPECT_EQ(unpacked(std::string("\x1f") + "q" + std::string("\x01\x00", 2) + "\x0a" + std::string("\x10") + "e", 31),
            std::string(30, 'q') + "e");
}

TEST(Lz4_block, Damage_is_found) {
  using TM::IO::internal::Compression;
  using TM::IO::internal::decompress;
  const std::string good = std::string("\x27") + "ab" + std::string("\x02\x00", 2) + "\x50" + "xyzvw";
  const auto is_sound = [](const std::string& packed, std::size_t bytes) {
    std::string out(bytes, '?');
    return decompress(Compression::lz4, packed, &out[0], bytes);
  };
  EXPECT_TRUE(is_sound(good, 18));
  for (std::size_t n = 0; n < good.size(); ++n)
    EXPECT_FALSE(is_sound(good.substr(0, n), 18)) << n;
  for (std::size_t bytes : {0u, 1u, 17u, 19u, 1000u})
    EXPECT_FALSE(is_sound(good, bytes)) << bytes;
  for (char offset : {'\x00', '\x03', '\x7f'}) { // nothing, or what is not there
    std::string bad = good;
    bad[3] = offset;
    EXPECT_FALSE(is_sound(bad, 18)) << int(offset);
  }
}

// --- other variants ---

template <class T> void put(std::string& bytes, T value, bool big = false) {
  char b[sizeof(T)];
  std::memcpy(b, &value, sizeof(T));
  if (big)
    std::reverse(b, b + sizeof(T));
  bytes.append(b, sizeof(T));
}

TEST_F(IO, Gmsh_format_4_0) {
  std::string text = "$MeshFormat\n4 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 6 \"skin\"\n$EndPhysicalNames\n"
                     "$Entities\n1 0 2 0\n9 0 0 0 0 0 0 0\n1 0 0 0 1 1 0 1 6 0\n2 0 0 0 1 1 0 1 -7 0\n$EndEntities\n"
                     "$Nodes\n2 4\n1 2 0 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n2 2 0 1\n8 0 0 1\n$EndNodes\n"
                     "$Elements\n2 2\n1 2 2 1\n1 1 2 3\n2 2 2 1\n2 1 3 8\n$EndElements\n";
  const Data ascii = read_surface_data(make("a.msh", text));
  EXPECT_EQ(ascii.points.size(), 4u);
  EXPECT_EQ(ascii.points[3], Point(0, 0, 1));
  EXPECT_EQ(ascii.labels.label, (std::vector<int>{6, 7}));
  EXPECT_EQ(ascii.labels.names.at(6), "skin");

  std::string binary = "$MeshFormat\n4 1 8\n";
  put(binary, std::int32_t(1));
  binary += "\n$EndMeshFormat\n$Entities\n";
  for (int n : {0, 0, 2, 0})
    put(binary, std::uint64_t(n));
  for (int tag : {1, 2}) {
    put(binary, std::int32_t(tag));
    for (int k = 0; k < 6; ++k)
      put(binary, 0.5 * k);
    put(binary, std::uint64_t(1));
    put(binary, std::int32_t(5 + tag));
    put(binary, std::uint64_t(0));
  }
  binary += "\n$EndEntities\n$Nodes\n";
  put(binary, std::uint64_t(1));
  put(binary, std::uint64_t(4));
  for (int x : {1, 2, 0})
    put(binary, std::int32_t(x));
  put(binary, std::uint64_t(4));
  const double points[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int i = 0; i < 4; ++i) {
    put(binary, std::int32_t(i + 1));
    for (double x : points[i])
      put(binary, x);
  }
  binary += "\n$EndNodes\n$Elements\n";
  put(binary, std::uint64_t(2));
  put(binary, std::uint64_t(2));
  for (int tag : {1, 2}) {
    for (int x : {tag, 2, 2})
      put(binary, std::int32_t(x));
    put(binary, std::uint64_t(1));
    for (int x : {tag, 1, 1 + tag, 2 + tag})
      put(binary, std::int32_t(x));
  }
  binary += "\n$EndElements\n";
  const Data read = read_surface_data(make("b.msh", binary));
  EXPECT_EQ(read.points, ascii.points);
  EXPECT_EQ(read.labels.label, (std::vector<int>{6, 7}));
}

TEST_F(IO, Triangles_of_second_order_have_their_corners) {
  const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0 0\n2 2 0 0\n3 0 2 0\n4 1 0 0\n5 1 1 "
                           "0\n6 0 1 0\n$EndNodes\n$Elements\n1\n1 9 2 1 1 1 2 3 4 5 6\n$EndElements\n";
  EXPECT_EQ(area_of(read_surface_data(make("a.msh", head))), 2);
  EXPECT_EQ(area_of(read_surface_data(make(
                "a.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 6 float\n0 0 0 2 "
                         "0 0 0 2 0 1 0 0 1 1 0 0 1 0\nCELLS 1 7\n6 0 1 2 3 4 5\nCELL_TYPES 1\n22\n"))),
            2);
}

TEST_F(IO, Off_with_colours_and_normals) {
  EXPECT_EQ(area_of(read_surface_data(make(
                "a.off", "COFF\n4 2 5\n0 0 0 255 0 0 255\n1 0 0 255 0 0 255\n1 1 0 0 0 0 255\n0 1 0 1 2 3 4\n3 0 1 2 "
                         "255 0 0\n3 0 2 3\n"))),
            1);
  EXPECT_EQ(area_of(read_surface_data(
                make("b.off", "NOFF # normals\n4 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n\n# a comment\n1 1 0 0 0 1\n0 1 0 0 0 "
                              "1\n4 0 1 2 3 0.5 0.5 0.5\n"))),
            1);
}

TEST_F(IO, Obj_with_all_that_Blender_writes) {
  const Data data = read_surface_data(
      make("a.obj", "# Blender v2.93.4 OBJ File: ''\r\n# www.blender.org\r\nmtllib a.mtl\r\no Cube\r\nv 0 0 0 0.5 0.5 "
                    "0.5\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nvt 0 0\r\nvn 0 0 1\r\nusemtl None\r\ns off\r\nf -4/1/1 "
                    "-3/1/1 -2/1/1 -1/1/1\r\nl 1 2\r\np 1\r\nf 1//1 2//1\r\n"));
  EXPECT_EQ(area_of(data), 1);
  EXPECT_EQ(data.notes.size(), 1u);
}

TEST_F(IO, Stl_with_colours) {
  for (bool materialise : {false, true}) {
    std::string bytes = materialise ? std::string("COLOR=") + std::string("\x01\x02\x03\x04", 4) : "VCG";
    bytes.resize(80, '\0');
    put(bytes, std::uint32_t(2));
    const float corners[2][3][3] = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
    for (const auto& t : corners) {
      for (int k = 0; k < 3; ++k)
        put(bytes, 0.f);
      for (const auto& p : t)
        for (float x : p)
          put(bytes, x);
      put(bytes, std::uint16_t(0x8123));
    }
    EXPECT_EQ(area_of(read_surface_data(make("a.stl", bytes))), 1);
  }
}

TEST_F(IO, Bits_of_legacy_vtk) {
  for (bool binary : {false, true}) {
    std::string text = std::string("# vtk DataFile Version 5.1\nx\n") + (binary ? "BINARY" : "ASCII") +
                       "\nDATASET POLYDATA\nPOINTS 3 float\n";
    const float points[9] = {0, 0, 0, 1, 0, 0, 0, 2, 0};
    for (float x : points)
      binary ? put(text, x, true) : void(text += std::to_string(x) + " ");
    text += "\nPOLYGONS 2 3\nOFFSETS vtktypeint32\n";
    for (std::int32_t x : {0, 3})
      binary ? put(text, x, true) : void(text += std::to_string(x) + " ");
    text += "\nCONNECTIVITY vtktypeint32\n";
    for (std::int32_t x : {0, 1, 2})
      binary ? put(text, x, true) : void(text += std::to_string(x) + " ");
    text += "\nPOINT_DATA 3\nFIELD FieldData 2\nbits 1 3 bit\n";
    text += binary ? std::string("\xa0\n") : std::string("1 0 1\n");
    text += "size 1 3 double\n";
    for (double x : {1., 2., 3.})
      binary ? put(text, x, true) : void(text += std::to_string(x) + " ");
    const Data data = read_surface_data(make("a.vtk", text + "\n"));
    EXPECT_EQ(area_of(data), 1);
    EXPECT_EQ(data.point_arrays.at("bits"), (std::vector<double>{1, 0, 1}));
    EXPECT_EQ(data.point_arrays.at("size"), (std::vector<double>{1, 2, 3}));
  }
}

} // namespace
