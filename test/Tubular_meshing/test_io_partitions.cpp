// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes in parts, in all formats: written whole or not at all, and refused with a sentence.

#include "openfoam_parts.h"
#include "partitioned_meshes.h"
#include "resource_limits.h"

#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_partitioned_mesh.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using TM::Cell_partition;
using TM::IO::Mesh_format;
using TM::IO::write_partitioned_mesh;

std::set<std::string> files_below(const fs::path& folder) {
  std::set<std::string> files;
  for (const auto& file : fs::recursive_directory_iterator(folder))
    files.insert(file.path().lexically_relative(folder).string());
  return files;
}

const std::vector<std::pair<std::string, Mesh_format>>& outputs() {
  static const std::vector<std::pair<std::string, Mesh_format>> list = {{"m.pvtu", Mesh_format::pvtu},
                                                                        {"m.msh", Mesh_format::gmsh},
                                                                        {"case", Mesh_format::openfoam},
                                                                        {"case", Mesh_format::openfoam_binary}};
  return list;
}

TEST_F(IO, Parts_are_written_all_or_none) {
  const Mesh m = Layered_box::make(3, "HXWT", "1112");
  const Cell_partition p = in_order(m, 4);
  for (const auto& o : outputs()) {
    {
      const auto out = TM::IO::open_partitioned_mesh(path(o.first), 4, o.second);
      write_partitioned_mesh(*out, m, p, o.second);
      out->finish();
    }
    EXPECT_EQ(files_below(directory), std::set<std::string>()) << o.first;
  }
}

TEST_F(IO, The_same_parts_make_the_same_files) {
  const Mesh m = with_arrays(Layered_box::make(4, "HXWT", "1112"));
  const auto write_all = [&](const std::string& folder) {
    fs::create_directories(directory / folder);
    for (const auto& o : outputs())
      if (o.second != Mesh_format::openfoam_binary)
        write_partitioned_mesh(path(folder + "/" + o.first), m, in_order(m, 5), o.second);
    return files_below(directory / folder);
  };
  const auto files = write_all("a");
  ASSERT_EQ(write_all("b"), files);
  for (const std::string& f : files)
    if (fs::is_regular_file(path("a/" + f))) {
      EXPECT_EQ(bytes_of(path("a/" + f)), bytes_of(path("b/" + f))) << f;
    }
}

void expect_error(const std::function<void()>& f, const std::string& said) {
  try {
    f();
    ADD_FAILURE() << "no error: " << said;
  } catch (const TM::Error& e) {
    EXPECT_NE(std::string(e.what()).find(said), std::string::npos) << e.what();
  }
}

TEST_F(IO, What_cannot_be_written_in_parts_is_refused) {
  const Mesh m = Layered_box::make(2, "HH", "11");
  const Cell_partition p = in_order(m, 2);
  const auto write = [&](const std::string& file, const Mesh& mesh, const Cell_partition& partition,
                         Mesh_format format = Mesh_format::by_name) {
    return [=] { write_partitioned_mesh(path(file), mesh, partition, format); };
  };
  expect_error(write("m.vtu", m, p), ".pvtu or .msh");
  expect_error(write("m.unknown", m, p), ".pvtu or .msh");
  expect_error(write("m.su2", m, p, Mesh_format::su2), ".pvtu or .msh");
  expect_error(write("polyMesh", m, p), "constant of a case");
  for (const auto& o : outputs()) {
    expect_error(write(o.first, m, {2, {0, 1, 0}}, o.second), "not one of the mesh");
    expect_error(write(o.first, m, {1, p.part}, o.second), "not one of the mesh");
    expect_error(write(o.first, Mesh(), {1, {}}, o.second), "without cells");
    expect_error(write(o.first, m, {0, p.part}, o.second), "not one of the mesh");
    Mesh loose = m;
    loose.quads.push_back({0, 1, 2, 8}, 2);
    expect_error(write(o.first, loose, p, o.second), "bounds no cell");
  }
  const auto out = TM::IO::open_partitioned_mesh(path("case"), 3, Mesh_format::openfoam);
  expect_error([&] { write_partitioned_mesh(*out, m, p, Mesh_format::openfoam); }, "not opened");
  expect_error([&] { write_partitioned_mesh(*out, m, p, Mesh_format::gmsh); }, "not opened");
  const auto file = TM::IO::open_mesh(path("m.vtu"));
  expect_error([&] { write_partitioned_mesh(*file, m, p, Mesh_format::pvtu); }, "not opened");
}

TEST_F(IO, Other_files_stay_where_parts_would_go) {
  const Mesh m = Layered_box::make(2, "HH", "11");
  fs::create_directories(directory / "m_parts");
  make("m_parts/notes.txt", "mine");
  expect_error([&] { write_partitioned_mesh(path("m.pvtu"), m, in_order(m, 2)); }, "notes.txt");
  fs::create_directories(directory / "case" / "processor1" / "constant" / "polyMesh");
  make("case/processor1/constant/polyMesh/mine", "mine");
  expect_error([&] { write_partitioned_mesh(path("case"), m, in_order(m, 2), Mesh_format::openfoam); }, "mine");
  EXPECT_EQ(
      files_below(directory),
      (std::set<std::string>{"m_parts", "m_parts/notes.txt", "case", "case/processor1", "case/processor1/constant",
                             "case/processor1/constant/polyMesh", "case/processor1/constant/polyMesh/mine"}));
}

TEST_F(IO, Processors_of_another_division_are_not_taken_for_parts) {
  const Mesh m = Layered_box::make(2, "HH", "11");
  write_partitioned_mesh(path("case"), m, in_order(m, 4), Mesh_format::openfoam);
  const auto before = files_below(directory);
  const auto write = [&](std::size_t parts) {
    write_partitioned_mesh(path("case"), m, in_order(m, parts), Mesh_format::openfoam);
  };
  expect_error([&] { write(3); }, "\"processor3\"");
  EXPECT_EQ(files_below(directory), before);
  write(4); // replaced
  EXPECT_EQ(files_below(directory), before);
  write(5);
  expect_openfoam_parts(directory / "case", in_order(m, 5));
  fs::create_directories(directory / "case" / "processors4");
  expect_error([&] { write(5); }, "\"processors4\"");
}

#ifdef __unix__
TEST_F(IO, There_may_be_more_parts_than_open_files) {
  const Mesh m = Layered_box::make(5, "TT", "12");
  {
    const Resource_limit limit(RLIMIT_NOFILE, 40);
    for (const auto& o : outputs())
      EXPECT_NO_THROW(write_partitioned_mesh(path(o.first), m, in_order(m, 100), o.second)) << o.first;
  }
  expect_openfoam_parts(directory / "case", in_order(m, 100));
}

TEST_F(IO, A_limit_on_file_size_leaves_no_part_behind) {
  const Mesh m = Layered_box::make(8, "TTT", "112");
  for (const auto& o : outputs()) {
    std::string said;
    try {
      const Resource_limit limit(RLIMIT_FSIZE, 6000);
      write_partitioned_mesh(path(o.first), m, in_order(m, 3), o.second);
    } catch (const TM::Output_error& e) {
      said = e.what();
    }
    EXPECT_NE(said.find("cannot be written"), std::string::npos) << o.first << said;
    EXPECT_EQ(files_below(directory), std::set<std::string>()) << o.first;
  }
}
#endif

} // namespace
