// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line tool: from a surface to a labelled mesh. See the user manual, or --help.

#include "command_line/Stop_signals.h"
#include "command_line/huge_pages.h"
#include "command_line/run_tool.h"
#include "command_line/words.h"
#include "tubular_mesh/batch/Job_options.h"
#include "tubular_mesh/batch/run_batch.h"
#include "tubular_mesh/declare_options.h"
#include "tubular_mesh/execute.h"

#include <CGAL/Tubular_meshing/IO/hdf5_at_exit.h>
#include <CGAL/Tubular_meshing/base/interruption.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>

namespace {

// Before the command line is read: in a batch some options do not need others.
bool is_batch(int argc, char* argv[]) {
  return std::any_of(argv + 1, argv + argc, [](const char* word) {
    return std::strcmp(word, "--batch") == 0 || std::strncmp(word, "--batch=", 8) == 0;
  });
}

// This program's file, to be started again.
std::string own_file(const char* called) {
  std::error_code error;
  const std::filesystem::path file = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? std::filesystem::absolute(called).string() : file.string();
}

} // namespace

int main(int argc, char* argv[]) {
  command_line::use_huge_pages();
  const std::string version = TUBULAR_MESHING_VERSION;
  CGAL::Tubular_meshing::IO::leave_hdf5_alone_at_exit(); // a full disk has a status of its own
  const command_line::Stop_signals stop;                 // before there are other threads
  const CGAL::Tubular_meshing::Interruption_check check([&] { stop.check(); });
  CLI::App app("", "tubular_mesh");
  Options options;
  declare_options(app, options, "tubular_mesh " + version);
  options.command = command_line::text_of("tubular_mesh", argc, argv);
  if (is_batch(argc, argv))
    allow_in_batch(app);
  app.final_callback([&] {
    if (options.surface.empty() && !options.batch.is_wanted())
      throw CLI::RequiredError("surface");
    if (!options.surface.empty() && options.batch.is_wanted())
      throw CLI::ExcludesError("surface", "--batch");
  });
  return command_line::run_tool(app, argc, argv, [&] {
    if (!options.batch.is_wanted()) {
      execute(options, version);
      return command_line::done;
    }
    options.batch.options = common_words(app);
    return run_batch(options, version, own_file(argv[0]));
  });
}
