// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line tool: from a surface and its centerlines to a labelled mesh. See the user manual, or --help.

#include "tubular_mesh/Options.h"
#include "tubular_mesh/Run_report.h"
#include "tubular_mesh/Stage_clock.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/IO/write_centerlines.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_surface.h>
#include <CGAL/tubular_meshing.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <new>
#include <set>
#include <string>
#include <system_error>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Surface;
namespace tubular = CGAL::Tubular_meshing;

namespace {

const char* const version = "1.0";

enum Exit_status { done = 0, wrong_usage = 2, unusable_input = 3, meshing_failed = 4 };

// What is wrong with the options as such; before any work is done, since work takes time.
void check(const Options& o) {
  if (o.type == "anisotropic" || o.type == "mixed")
    throw tubular::Parameter_error("Meshes of type " + o.type +
                                   " are not part of this version; it makes isotropic ones.");
  if (o.type != "isotropic")
    throw tubular::Parameter_error("There is no type of mesh named \"" + o.type + "\"; the types are: isotropic.");
  for (double x : o.inlet)
    if (!std::isfinite(x))
      throw tubular::Parameter_error("The coordinates of --inlet have to be finite numbers.");
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
  std::set<std::string> files = {same_file(o.surface), same_file(o.centerlines)};
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

template <class NamedParameters>
tubular::Tubular_model<Point_3> prepare(const Options& o, const Surface& surface,
                                        const tubular::Centerline_polylines<Point_3>& lines,
                                        const NamedParameters& np) {
  if (o.inlet.empty())
    return tubular::make_tubular_model(surface, lines, np);
  return tubular::make_tubular_model(surface, lines, np.inlet(Point_3(o.inlet[0], o.inlet[1], o.inlet[2])));
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
  clock.begin("read");
  Surface surface;
  tubular::IO::read_surface(o.surface, surface);
  tubular::Centerline_polylines<Point_3> lines;
  tubular::IO::read_centerlines(o.centerlines, lines);

  const auto np = tubular::parameters::points_per_circumference(o.points_per_circumference)
                      .min_size(o.min_size)
                      .max_size(o.max_size)
                      .gradation(o.gradation)
                      .number_of_threads(o.threads)
                      .observer([&](const char* stage) { clock.begin(stage); });
  clock.begin("branches, openings");
  const tubular::Tubular_model<Point_3> model = prepare(o, surface, lines, np);
  const tubular::Mixed_mesh<Point_3> mesh = tubular::make_isotropic_mesh(model, np);
  clock.begin("report");
  run_report::Json report = run_report::make(o, version, model, mesh);
  clock.begin("write");
  write(o, model, mesh, report, clock);
  if (!o.quiet) {
    run_report::print(report, o.verbose);
    if (std::fflush(stdout) != 0)
      throw tubular::Output_error("The summary cannot be printed; the files are written.");
  }
}

int fail(const std::string& sentence, Exit_status status) {
  std::fprintf(stderr, "tubular_mesh: %s\n", sentence.c_str());
  return status;
}

} // namespace

int main(int argc, char* argv[]) {
  // a file too large, a reader gone: errors to report, not reasons to be killed
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  CLI::App app;
  Options options;
  declare_options(app, options, std::string("tubular_mesh ") + version);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? done : wrong_usage;
  }
  try {
    run(options);
    return done;
  } catch (const tubular::Parameter_error& e) {
    return fail(e.what(), wrong_usage);
  } catch (const tubular::Input_error& e) {
    return fail(e.what(), unusable_input);
  } catch (const tubular::Error& e) {
    return fail(e.what(), meshing_failed);
  } catch (const std::bad_alloc&) {
    return fail("There is not enough memory for a mesh this fine; make it coarser (-n, --min-size).", meshing_failed);
  } catch (const std::exception& e) {
    return fail(std::string("Meshing failed: ") + e.what(), meshing_failed);
  }
}
