// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A file is written whole or not at all.

#include "io_fixture.h"
#include "resource_limits.h"

#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <cerrno>
#include <cstring>
#include <string>

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
  {
    const Resource_limit limit(RLIMIT_FSIZE, 100);
    EXPECT_THROW(TM::IO::write_mesh(path("m.mesh"), sample_mesh()), TM::Output_error);
  }
  EXPECT_EQ(bytes_of(path("m.mesh")), "old");
  EXPECT_EQ(number_of_files(), 1u);
}
#endif
