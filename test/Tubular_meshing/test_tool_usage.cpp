// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// How the command-line tool is called: what it refuses, and how; what it says of itself.

#include "test_tool_helpers.h"
#include "test_tool_refusals.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>

#ifdef TUBULAR_MESH_TOOL

namespace {

using namespace tool_test;

class Refused : public Tool, public ::testing::WithParamInterface<Refusal> {
protected:
  void SetUp() override {
    Tool::SetUp();
    const Sample good = tube();
    make("tube.off", good.surface);
    make("lines.vtk", good.lines);
    make_bad_surfaces(*this, good);
    make_bad_centerlines(*this, good);
    fs::create_directory(out("folder.vtu"));
    std::ofstream(out("file")) << "a file";
  }
};

TEST_P(Refused, With_a_sentence_and_without_a_trace) {
  const Refusal& refusal = GetParam();
  const std::set<std::string> before = listing(output_directory());
  const std::string good_surface = bytes_of(in("tube.off"));
  Limits limits;
  limits.seconds = 20;
  const Outcome outcome = run(arguments_of(refusal.command_line, *this), limits);
  EXPECT_EQ(outcome.status, refusal.status) << outcome.killed_by << "\n" << outcome.err;
  EXPECT_EQ(outcome.out, "");
  expect_one_sentence(outcome, refusal.mentioned);
  EXPECT_EQ(listing(output_directory()), before);
  EXPECT_EQ(bytes_of(in("tube.off")), good_surface);
  if (refusal.status == usage) {
    EXPECT_EQ(stages_of(outcome), Arguments()) << "it was known before any work";
  }
}

std::string name_of(const ::testing::TestParamInfo<Refusal>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Usage, Refused, ::testing::ValuesIn(usage_errors()), name_of);
INSTANTIATE_TEST_SUITE_P(File, Refused, ::testing::ValuesIn(file_errors()), name_of);
INSTANTIATE_TEST_SUITE_P(Geometry, Refused, ::testing::ValuesIn(geometry_errors()), name_of);

TEST_F(Tool, Refuses_a_directory_that_is_write_protected) {
  if (geteuid() == 0)
    GTEST_SKIP() << "needs a user who is not root";
  fs::permissions(output_directory(), fs::perms::owner_read | fs::perms::owner_exec);
  const Outcome outcome = run(tube_run(*this));
  fs::permissions(output_directory(), fs::perms::owner_all);
  EXPECT_EQ(outcome.status, usage);
  expect_one_sentence(outcome, {"mesh.vtu"});
}

TEST_F(Tool, Tells_its_version_and_its_options) {
  const Outcome version = succeed({"--version"}), help = succeed({"--help"});
  EXPECT_TRUE(std::regex_match(version.out, std::regex("tubular_mesh [0-9]+\\.[0-9.]+\n"))) << version.out;
  for (const char* option : {"--centerlines",
                             "--output",
                             "--type",
                             "--points-per-circumference",
                             "--min-size",
                             "--max-size",
                             "--gradation",
                             "--inlet",
                             "--outlet",
                             "--seeds",
                             "--loops",
                             "--no-loops",
                             "--repair",
                             "--smooth",
                             "--flow-extensions",
                             "--report",
                             "--write-surface",
                             "--write-centerlines",
                             "--threads",
                             "--verbose",
                             "--quiet",
                             "--version",
                             "Exit status",
                             ".vtu"})
    EXPECT_NE(help.out.find(option), std::string::npos) << option;
  EXPECT_EQ(version.err + help.err, "");
}

TEST_F(Tool, Has_the_options_that_its_manual_lists) {
  const fs::path project = fs::path(TUBULAR_MESHING_DATA).parent_path();
  const fs::path script = project / "scripts" / "options_table.py";
  const fs::path table = project / "doc" / "Tubular_meshing" / "options.md";
  NEEDS(script, fs::exists(script));
  NEEDS(table, fs::exists(table));
  const Outcome made =
      Child_process("/usr/bin/env", {"python3", script.string(), TUBULAR_MESH_TOOL}, output_directory(), Limits())
          .wait();
  NEEDS("python3", made.status != 127);
  EXPECT_EQ(made.status, 0) << made.killed_by << made.err;
  EXPECT_TRUE(made.out == bytes_of(table)) << "make it anew: " << script << " " << TUBULAR_MESH_TOOL << " > " << table;
}

TEST_F(Tool, Says_as_much_as_it_is_told_to) {
  const Arguments arguments = tube_run(*this);
  const Outcome quiet = succeed(arguments + Arguments{"-q"}), plain = succeed(arguments);
  const Outcome verbose = succeed(arguments + Arguments{"-v"});
  EXPECT_EQ(quiet.out + quiet.err, "");
  EXPECT_GT(lines_of(verbose.out).size(), lines_of(plain.out).size() + 20); // the histograms
  EXPECT_EQ(plain.out.find("\033"), std::string::npos);
  EXPECT_EQ(plain.err.find('\r'), std::string::npos);

  const Outcome failed = run({"absent.stl", "-c", "absent.vtk", "-o", out("m.vtu"), "-q"});
  EXPECT_EQ(failed.status, input);
  expect_one_sentence(failed, {"absent.stl"}); // errors are not kept quiet
}

} // namespace

#endif // TUBULAR_MESH_TOOL
