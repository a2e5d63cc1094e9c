// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What holds of each format that meshes are written in: names of files and patches of any kind, and what is left where
// they cannot be written.

#include "solver_meshes.h"

#include <CGAL/Tubular_meshing/IO/Mesh_format.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#ifdef __unix__
#include <csignal>
#include <sys/resource.h>
#endif

namespace {

using TM::IO::Mesh_format;
namespace parameters = TM::parameters;

struct Written {
  std::string name;
  Mesh_format format;
  std::vector<std::string> files; // that there are then, where "m" was asked for
};

std::vector<Written> written_formats() {
  const std::map<std::string, std::vector<std::string>> files = {
      {"pvtu", {"m", "m_parts"}},
      {"openfoam", {"m/constant/polyMesh/boundary"}},
      {"openfoam-binary", {"m/constant/polyMesh/boundary"}},
      {"openfoam-regions", {"m/constant/fluid/polyMesh/boundary", "m/constant/solid/polyMesh/boundary"}},
      {"openfoam-regions-binary", {"m/constant/fluid/polyMesh/boundary", "m/constant/solid/polyMesh/boundary"}},
      {"svmultiphysics", {"m/fluid/mesh-complete.mesh.vtu", "m/solid/mesh-complete.mesh.vtu"}},
      {"xdmf", {"m"}}};
  std::vector<Written> result;
  for (const std::string& name : TM::IO::mesh_format_names()) {
    const Mesh_format format = TM::IO::mesh_format_named(name);
    const auto found = files.find(name);
    if (TM::IO::why_not_built_in(format).empty())
      result.push_back({name, format, found == files.end() ? std::vector<std::string>{"m"} : found->second});
  }
  return result;
}

Mesh tetrahedra(std::size_t n) {
  return Layered_box::make(n, "TT", "12");
}

} // namespace

namespace {

class Every_format : public IO {
protected:
  std::size_t all_files() const {
    return std::size_t(std::distance(fs::recursive_directory_iterator(directory), fs::recursive_directory_iterator()));
  }
};

// Of a parameter, in messages.
void PrintTo(const Written& w, std::ostream* out) {
  *out << w.name;
}

} // namespace

TEST_F(Every_format, Is_known_here) {
  EXPECT_GE(written_formats().size(), 12u);
}

TEST_F(Every_format, Takes_blanks_quotes_and_other_alphabets_in_names_of_files) {
  const Mesh m = tetrahedra(2);
  for (const Written& w : written_formats()) {
    SCOPED_TRACE(w.name);
    const fs::path folder = directory / "Aorta von \"Müller\"; it's 大動脈 $HOME %d";
    fs::create_directories(folder);
    TM::IO::write_mesh((folder / "a b 'c' \"d\" é.%s").string(), m, parameters::format(w.format));
    TM::IO::write_mesh((folder / "m").string(), m, parameters::format(w.format));
    EXPECT_TRUE(fs::exists(folder / "a b 'c' \"d\" é.%s") || fs::exists(folder / "a b 'c' \"d\" é"));
    for (const std::string& file : w.files)
      EXPECT_TRUE(fs::exists(folder / file)) << file;
    EXPECT_EQ(number_of_files(), 1u);
    fs::remove_all(folder);
  }
}

TEST_F(Every_format, Takes_blanks_apostrophes_and_other_alphabets_in_names_of_patches_and_regions) {
  Mesh m = tetrahedra(2);
  m.patch_names = {{1, "wall it's <&>"}, {2, "Einströmung 入口"}, {3, "3rd; {outlet}, $x"}, {100, ""}};
  m.region_names = {{1, "das Lumen"}, {2, "paroi artérielle"}};
  for (const Written& w : written_formats()) {
    SCOPED_TRACE(w.name);
    TM::IO::write_mesh(path("m"), m, parameters::format(w.format));
    for (const std::string& file : w.files)
      EXPECT_TRUE(fs::exists(directory / file)) << file;
    fs::remove_all(directory);
    fs::create_directories(directory);
  }
  // a quotation mark or a line's end would not come back from most of them
  for (const char* name : {"an \"inlet\"", "in\nlet"})
    for (const Written& w : written_formats()) {
      SCOPED_TRACE(w.name);
      m.patch_names[2] = name;
      EXPECT_THROW(TM::IO::write_mesh(path("m"), m, parameters::format(w.format)), TM::Output_error);
      EXPECT_EQ(number_of_files(), 0u);
    }
}

TEST_F(Every_format, Keeps_two_patches_of_one_name_apart_or_refuses_them) {
  Mesh m = tetrahedra(2);
  m.patch_names = {{1, "wall"}, {2, "same"}, {3, "same"}, {100, "wall"}};
  for (const Written& w : written_formats()) {
    SCOPED_TRACE(w.name);
    try {
      TM::IO::write_mesh(path("m"), m, parameters::format(w.format));
    } catch (const TM::Output_error& e) {
      EXPECT_EQ(w.format, Mesh_format::abaqus) << e.what();
      EXPECT_NE(std::string(e.what()).find("the same"), std::string::npos) << e.what();
      EXPECT_EQ(number_of_files(), 0u);
      continue;
    }
    // by names where these tell patches apart, by labels elsewhere
    const TM::Label_names names = TM::IO::patch_names_in(m, w.format);
    const bool has_labels = w.format == Mesh_format::vtu || w.format == Mesh_format::pvtu ||
                            w.format == Mesh_format::gmsh || w.format == Mesh_format::medit ||
                            w.format == Mesh_format::xdmf;
    EXPECT_EQ(names.at(2) != names.at(3) && names.at(1) != names.at(100), !has_labels);
    fs::remove_all(directory);
    fs::create_directories(directory);
  }
}

TEST_F(Every_format, Leaves_nothing_where_it_cannot_be_written) {
  const Mesh m = tetrahedra(2);
  std::ofstream(directory / "file") << "a file";
  for (const Written& w : written_formats()) {
    SCOPED_TRACE(w.name);
    for (const std::string& target : {path("file/m"), std::string("/proc/none/m")}) {
      try {
        TM::IO::write_mesh(target, m, parameters::format(w.format));
        ADD_FAILURE() << target;
      } catch (const TM::Output_error& e) {
        EXPECT_NE(std::string(e.what()).find(target), std::string::npos) << e.what();
      }
    }
    EXPECT_EQ(all_files(), 1u);
    EXPECT_EQ(bytes_of(path("file")), "a file");
  }
}

#ifdef __unix__
// Under limits on the size of files, which the system says are met by any full disk: what was there stays as it was.
namespace {

class Format_on_a_full_disk : public Every_format, public ::testing::WithParamInterface<Written> {
protected:
  std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> result;
    for (const auto& entry : fs::recursive_directory_iterator(directory))
      result[entry.path().string()] = entry.is_regular_file() ? bytes_of(entry.path().string()) : "";
    return result;
  }

  void run() const {
    const Mesh small = tetrahedra(2), large = tetrahedra(12);
    const auto np = parameters::format(GetParam().format);
    rlimit limit;
    getrlimit(RLIMIT_FSIZE, &limit);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    TM::IO::write_mesh(path("m"), small, np);
    const auto before = contents();
    for (rlim_t most : {100, 2000, 5000}) {
      rlimit tight = limit;
      tight.rlim_cur = most;
      setrlimit(RLIMIT_FSIZE, &tight);
      EXPECT_THROW(TM::IO::write_mesh(path("m"), large, np), TM::Output_error) << most;
      setrlimit(RLIMIT_FSIZE, &limit);
      EXPECT_TRUE(contents() == before) << most;
    }
    std::signal(SIGXFSZ, handler);
    try { // there is room again, but see below
      TM::IO::write_mesh(path("m"), large, np);
      EXPECT_FALSE(contents() == before);
    } catch (const TM::Output_error&) {
      EXPECT_EQ(GetParam().format, Mesh_format::cgns);
      EXPECT_TRUE(contents() == before);
    }
  }
};

} // namespace

// In a process of its own: within one, HDF5 does not give up files that it could not write, and later ones fail as well.
TEST_P(Format_on_a_full_disk, Leaves_what_was_there) {
  EXPECT_EXIT(
      {
        run();
        std::_Exit(HasFailure() ? 1 : 0);
      },
      ::testing::ExitedWithCode(0), "");
}

INSTANTIATE_TEST_SUITE_P(All, Format_on_a_full_disk, ::testing::ValuesIn(written_formats()), [](const auto& info) {
  std::string name = info.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});
#endif
