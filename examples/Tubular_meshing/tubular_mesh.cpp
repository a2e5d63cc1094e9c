// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line tool: from a surface to a labelled mesh. See the user manual, or --help.

#include "command_line/Stop_signals.h"
#include "command_line/run_tool.h"
#include "tubular_mesh/declare_options.h"
#include "tubular_mesh/execute.h"

#include <CGAL/Tubular_meshing/IO/hdf5_at_exit.h>
#include <CGAL/Tubular_meshing/base/interruption.h>

#include <string>

int main(int argc, char* argv[]) {
  const std::string version = TUBULAR_MESHING_VERSION;
  CGAL::Tubular_meshing::IO::leave_hdf5_alone_at_exit(); // a full disk has a status of its own
  const command_line::Stop_signals stop;                 // before there are other threads
  const CGAL::Tubular_meshing::Interruption_check check([&] { stop.check(); });
  CLI::App app("", "tubular_mesh");
  Options options;
  declare_options(app, options, "tubular_mesh " + version);
  options.command = command_line::text_of("tubular_mesh", argc, argv);
  return command_line::run_tool(app, argc, argv, [&] { execute(options, version); });
}
