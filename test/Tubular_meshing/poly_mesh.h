// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESHING_TEST_POLY_MESH_H
#define TUBULAR_MESHING_TEST_POLY_MESH_H

#include "io_fixture.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

// A polyMesh, by a reader of its own.
struct Poly_mesh {
  struct Patch {
    std::string type;
    std::size_t faces = 0, first = 0, my_part = 0, other_part = 0;
  };
  struct Zone {
    std::vector<std::size_t> members;
    std::vector<int> flips;
  };
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
  std::vector<std::size_t> owner, neighbour;
  std::map<std::string, Patch> patches;
  std::vector<std::string> order_of_patches;
  std::map<std::string, Zone> cell_zones, face_zones;
  std::map<std::string, std::vector<std::int64_t>> addressing; // of a part, by what it is of
  std::string note;

  explicit Poly_mesh(const fs::path& folder) {
    read_points(body(folder / "points"));
    read_faces(body(folder / "faces"));
    owner = labels(body(folder / "owner"));
    note = note_;
    neighbour = labels(body(folder / "neighbour"));
    read_boundary(body(folder / "boundary"));
    if (fs::exists(folder / "cellZones"))
      read_zones(body(folder / "cellZones"), cell_zones);
    if (fs::exists(folder / "faceZones"))
      read_zones(body(folder / "faceZones"), face_zones);
    for (const char* kind : {"point", "face", "cell", "boundary"}) {
      const fs::path file = folder / (std::string(kind) + "ProcAddressing");
      if (fs::exists(file))
        for (std::size_t label : labels(body(file)))
          addressing[kind].push_back(std::int64_t(label));
    }
  }

private:
  bool binary_ = false;
  std::string note_;

  // What follows the header.
  std::string body(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream all;
    all << in.rdbuf();
    std::string text = all.str();
    const std::size_t begin = text.find("FoamFile"); // OpenFOAM's own files have a comment before
    EXPECT_TRUE(begin == 0 || text.compare(0, 2, "/*") == 0) << file;
    text.erase(0, begin);
    const std::size_t end = text.find("}\n");
    const std::string header = text.substr(0, end);
    binary_ = header.find("format      binary;") != std::string::npos;
    const std::size_t note = header.find("note");
    note_ = note == std::string::npos ? "" : header.substr(note, header.find('\n', note) - note);
    EXPECT_NE(header.find("object      " + file.filename().string() + ";"), std::string::npos);
    text.erase(0, end + 2);
    const std::size_t comment = text.find_first_not_of('\n');
    return text.compare(comment, 2, "//") == 0 ? text.substr(text.find('\n', comment)) : text;
  }

  // "N(": a list of so many
  static std::size_t begin_list(std::istringstream& in) {
    std::size_t n = 0;
    char c = 0;
    in >> n >> c;
    EXPECT_EQ(c, '(');
    return n;
  }
  template <class T> static T raw(std::istringstream& in) {
    char bytes[sizeof(T)];
    in.read(bytes, sizeof(T));
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
  }

  void read_points(const std::string& text) {
    std::istringstream in(text);
    const std::size_t n = begin_list(in);
    for (std::size_t i = 0; i < n; ++i) {
      std::string x, y, z;
      if (binary_) {
        const double a = raw<double>(in), b = raw<double>(in), c = raw<double>(in);
        points.push_back(Point(a, b, c));
      } else {
        char bracket;
        in >> bracket >> x >> y;
        std::getline(in, z, ')');
        points.push_back(
            Point(std::strtod(x.c_str(), nullptr), std::strtod(y.c_str(), nullptr), std::strtod(z.c_str(), nullptr)));
      }
    }
    char c = 0;
    in >> c;
    EXPECT_EQ(c, ')');
  }

  std::vector<std::size_t> list(std::istringstream& in) const {
    std::size_t n = 0;
    char bracket = 0;
    in >> n >> bracket;
    if (bracket == '{') { // all the same
      std::size_t label = 0;
      in >> label >> bracket;
      return std::vector<std::size_t>(n, label);
    }
    EXPECT_EQ(bracket, '(');
    std::vector<std::size_t> result(n);
    for (std::size_t& l : result)
      if (binary_) {
        l = std::size_t(raw<std::int32_t>(in));
      } else {
        std::int64_t label = 0; // may be negative in addressing
        in >> label;
        l = std::size_t(label);
      }
    char c = 0;
    in >> c;
    EXPECT_EQ(c, ')');
    return result;
  }
  std::vector<std::size_t> labels(const std::string& text) const {
    std::istringstream in(text);
    return list(in);
  }

  void read_faces(const std::string& text) {
    std::istringstream in(text);
    if (binary_) {
      const auto ends = list(in), corners = list(in);
      for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        faces.emplace_back(corners.begin() + std::ptrdiff_t(ends[i]), corners.begin() + std::ptrdiff_t(ends[i + 1]));
      EXPECT_EQ(ends.back(), corners.size());
      return;
    }
    const std::size_t n = begin_list(in);
    for (std::size_t i = 0; i < n; ++i)
      faces.push_back(list(in));
  }

  void read_boundary(const std::string& text) {
    std::istringstream in(text);
    const std::size_t n = begin_list(in);
    for (std::size_t i = 0; i < n; ++i) {
      std::string name, word;
      in >> name >> word;
      EXPECT_EQ(word, "{");
      Patch p;
      while (in >> word && word != "}") {
        std::string value;
        EXPECT_TRUE(std::getline(in >> std::ws, value, ';')) << name << ' ' << word;
        if (word == "type")
          p.type = value;
        else if (word == "nFaces")
          p.faces = std::stoul(value);
        else if (word == "startFace")
          p.first = std::stoul(value);
        else if (word == "myProcNo")
          p.my_part = std::stoul(value);
        else if (word == "neighbProcNo")
          p.other_part = std::stoul(value);
      }
      EXPECT_TRUE(patches.emplace(name, p).second) << name;
      order_of_patches.push_back(name);
    }
  }

  void read_zones(const std::string& text, std::map<std::string, Zone>& zones) const {
    std::istringstream in(text);
    const std::size_t n = begin_list(in);
    for (std::size_t i = 0; i < n; ++i) {
      std::string name, word;
      in >> name >> word;
      EXPECT_EQ(word, "{");
      Zone zone;
      while (in >> word && word != "}")
        if (word == "List<label>")
          zone.members = list(in);
        else if (word == "List<bool>")
          for (std::size_t f : list(in))
            zone.flips.push_back(int(f));
      EXPECT_TRUE(zones.emplace(name, zone).second) << name;
    }
  }
};

#endif // TUBULAR_MESHING_TEST_POLY_MESH_H
