// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line tool: from a surface and its centerlines to a labelled mesh. See the user manual, or --help.

#include "command_line/run_tool.h"
#include "tubular_mesh/Options.h"
#include "tubular_mesh/Run_report.h"
#include "tubular_mesh/Stage_clock.h"
#include "tubular_mesh/stages.h"

#include <CGAL/Tubular_meshing/IO/write_centerlines.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_surface.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <system_error>
#include <vector>

namespace {

const char* const version = TUBULAR_MESHING_VERSION;

// What is wrong with the options as such; before any work is done, since work takes time.
void check(const Options& o) {
  if (o.type == "anisotropic" || o.type == "mixed")
    throw tubular::Parameter_error("Meshes of type " + o.type +
                                   " are not part of this version; it makes isotropic ones.");
  if (o.type != "isotropic")
    throw tubular::Parameter_error("There is no type of mesh named \"" + o.type + "\"; the types are: isotropic.");
  if (!o.outlets.empty() && o.inlet.empty())
    throw tubular::Parameter_error("--outlet needs --inlet, where the centerlines begin.");
  if (o.min_size > o.max_size)
    throw tubular::Parameter_error("--min-size is larger than --max-size.");
  if (!tubular::IO::is_supported_mesh_format(o.output))
    throw tubular::Parameter_error("The mesh cannot be written to \"" + o.output +
                                   "\": give a .vtu, .msh or .mesh file.");
  if (!o.surface_output.empty() && !tubular::IO::is_supported_surface_format(o.surface_output))
    throw tubular::Parameter_error("The surface cannot be written to \"" + o.surface_output +
                                   "\": give a .vtp, .stl, .off, .obj or .ply file.");
  if (!o.centerlines_output.empty() && !tubular::IO::is_supported_centerlines_format(o.centerlines_output))
    throw tubular::Parameter_error("The centerlines cannot be written to \"" + o.centerlines_output +
                                   "\": give a .vtp or .vtk file.");
  const auto same_file = [](const std::string& f) {
    std::error_code ignored;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(f), ignored).string();
  };
  std::set<std::string> files;
  for (const std::string& f : {o.surface, o.centerlines, o.seeds})
    if (!f.empty())
      files.insert(same_file(f));
  for (const std::string& f : o.outputs())
    if (!files.insert(same_file(f)).second)
      throw tubular::Parameter_error("The file \"" + f + "\" is named twice; an output needs a name of its own.");
  try {
    for (const std::string& f : o.outputs())
      tubular::IO::check_writable(f);
  } catch (const tubular::Output_error& e) { // the name was wrong; later on, a full disk is no fault of the user's
    throw tubular::Parameter_error(e.what());
  }
}

// Writes everything that was asked for; nothing gets its name before all of it is whole.
void write(const Options& o, const tubular::Tubular_model<Point_3>& model, const tubular::Mixed_mesh<Point_3>& mesh,
           run_report::Json& report, Stage_clock& clock) {
  std::vector<std::unique_ptr<tubular::IO::Output_file>> files;
  const auto open = [&](const std::string& name) -> tubular::IO::Output_file& {
    files.emplace_back(new tubular::IO::Output_file(name));
    return *files.back();
  };
  tubular::IO::write_mesh(open(o.output), mesh);
  if (!o.surface_output.empty())
    tubular::IO::write_surface(open(o.surface_output), model.surface, tubular::parameters::face_patch_map(model.patch));
  if (!o.centerlines_output.empty())
    tubular::IO::write_centerlines(open(o.centerlines_output), model.centerlines);
  clock.finish();
  run_report::add_times(report, clock);
  if (!o.report.empty())
    open(o.report).write(report.dump(2) + "\n");
  for (auto& f : files)
    f->finish();
  for (auto& f : files)
    f->commit();
}

void run(const Options& o) {
  check(o);
  Stage_clock clock(o.quiet);
  Surface surface;
  const tubular::Repair_report<Point_3> repairs = read_surface(o, surface, clock);
  const Flow_extensions extensions = extend_openings(o, surface, clock);
  const tubular::Tubular_model<Point_3> model = prepare(o, surface, extensions, clock);
  const tubular::Mixed_mesh<Point_3> mesh = make_mesh(o, model, clock);
  clock.begin("report");
  run_report::Json report = run_report::make(o, version, repairs, extensions.lengths, model, mesh);
  clock.begin("write");
  write(o, model, mesh, report, clock);
  if (!o.quiet) {
    run_report::print(report, o.verbose);
    if (std::fflush(stdout) != 0)
      throw tubular::Output_error("The summary cannot be printed; the files are written.");
  }
}

} // namespace

int main(int argc, char* argv[]) {
  CLI::App app("", "tubular_mesh");
  Options options;
  declare_options(app, options, std::string("tubular_mesh ") + version);
  return command_line::run_tool(app, argc, argv, [&] { run(options); });
}
