// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "execute.h"

#include "../command_line/Stop_signals.h"
#include "../command_line/exit_status.h"
#include "Progress.h"
#include "dry_run.h"
#include "page/make_page.h"
#include "picture/picture_of.h"
#include "reduced_model.h"
#include "renames.h"
#include "solver_case.h"
#include "stages.h"
#include "walls.h"

#include <CGAL/Tubular_meshing/IO/unfinished_outputs.h>
#include <CGAL/Tubular_meshing/IO/write_centerlines.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_partitioned_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_sections.h>
#include <CGAL/Tubular_meshing/IO/write_surface.h>
#include <CGAL/Tubular_meshing/Partition/partition_cells.h>
#include <CGAL/Tubular_meshing/base/interruption.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace tubular = CGAL::Tubular_meshing;

void write_surface(tubular::IO::Output_file& file, const tubular::Remeshed_surface& surface,
                   const tubular::Tubular_model& model) {
  const auto labels = tubular::parameters::face_patch_map(surface.patch)
                          .surface_patch_map(surface.patch_of_face)
                          .patch_names(model.patch_names)
                          .patch_ids(model.patch_ids);
  if (surface.metrics.empty())
    return tubular::IO::write_surface(file, surface.surface, labels);
  typedef tubular::Surface::Vertex_index Vertex;
  const auto metric = boost::make_function_property_map<Vertex>([&](Vertex v) { return surface.metrics[v]; });
  tubular::IO::write_surface(file, surface.surface, labels.vertex_metric_map(metric));
}

void write_surface(tubular::IO::Output_file& file, const tubular::Tubular_model& model) {
  tubular::IO::write_surface(
      file, model.surface,
      tubular::parameters::face_patch_map(model.patch).patch_names(model.patch_names).patch_ids(model.patch_ids));
}

std::vector<tubular::Cell_array> cell_arrays(const Run& run) {
  return run.options.fibres ? run.fibres.arrays() : std::vector<tubular::Cell_array>();
}

void write(const Run& run, Run_report& report, Stage_clock& clock) {
  const Options& o = run.options;
  std::vector<std::unique_ptr<tubular::IO::Output>> outputs;
  const auto open = [&](const std::string& name) -> tubular::IO::Output_file& {
    auto file = std::make_unique<tubular::IO::Output_file>(name);
    tubular::IO::Output_file& opened = *file;
    outputs.push_back(std::move(file));
    return opened;
  };
  if (o.output.empty()) { // not of a program that keeps the mesh
  } else if (o.makes_surface_only()) {
    write_surface(open(o.output), run.surface, run.model);
  } else if (o.solver_case.is_wanted()) {
    auto folder = open_case(o);
    write_case(*folder, run);
    outputs.push_back(std::move(folder));
  } else if (o.partitions > 0) {
    outputs.push_back(tubular::IO::open_partitioned_mesh(o.output, std::size_t(o.partitions), o.mesh_format()));
    tubular::IO::write_partitioned_mesh(*outputs.back(), run.mesh, run.partition, cell_arrays(run), o.mesh_format());
  } else {
    const auto format = tubular::parameters::format(o.mesh_format());
    outputs.push_back(tubular::IO::open_mesh(o.output, format));
    if (o.is_quadratic())
      tubular::IO::write_mesh(*outputs.back(), run.quadratic, cell_arrays(run), format);
    else
      tubular::IO::write_mesh(*outputs.back(), run.mesh, cell_arrays(run), format);
  }
  if (!o.surface_output.empty() && run.surface.surface.number_of_faces() > 0)
    write_surface(open(o.surface_output), run.surface, run.model);
  else if (!o.surface_output.empty())
    write_surface(open(o.surface_output), run.model);
  if (!o.blocks_output.empty())
    tubular::IO::write_mesh(open(o.blocks_output), run.block_mesh);
  if (!o.centerlines_output.empty())
    tubular::IO::write_centerlines(open(o.centerlines_output), run.model.centerlines);
  if (!o.sections_output.empty())
    tubular::IO::write_sections(open(o.sections_output), run.sections);
  if (!o.zero_d_output.empty())
    tubular::IO::write_zero_d_model(open(o.zero_d_output), run.zero_d);
  std::unique_ptr<Shown_mesh> shown; // if it is
  if (!o.picture.empty() || std::any_of(o.reports.begin(), o.reports.end(), Options::is_page)) {
    clock.begin("picture");
    shown = std::make_unique<Shown_mesh>(run.cells(), run.model.centerlines, o.threads);
  }
  if (!o.picture.empty())
    open(o.picture).write(picture_of(*shown, o));
  clock.finish();
  report.add_times(clock);
  for (const std::string& name : o.reports)
    open(name).write(Options::is_page(name)
                         ? make_page(report.json(), *shown, o.command, std::size_t(1e6 * o.report_budget))
                         : report.json());
  for (auto& output : outputs)
    output->finish();
  tubular::internal::check_interruption_now();
  const tubular::IO::Commit_guard all_or_none;
  for (auto& output : outputs)
    output->commit();
}

Prepared prepare(Run& run, const tubular::Surface& surface, Stage_clock& clock) {
  const tubular::internal::Thread_limit limit(run.options.threads);
  std::vector<Part> parts = split(run, surface);
  const bool is_sampled = is_to_be_sampled(run, surface.number_of_faces(), clock);
  for (Part& part : parts) {
    part.run.is_sampled = is_sampled;
    cut_ends(part.run, part.surface, clock);
    extend_openings(part.run, part.surface, clock);
    prepare_model(part.run, part.surface, clock);
  }
  check_number_of_openings(run, parts);
  return {std::move(run), std::move(parts)};
}

Prepared copy_of(const Prepared& prepared, const Options& options, const tubular::Size_requests& sizes,
                 const Wall_requests& walls) {
  Prepared copy;
  copy.run.options = options;
  copy.run.version = prepared.run.version;
  copy.run.notes = prepared.run.notes;
  copy.run.repairs = prepared.run.repairs;
  copy.run.labels = prepared.run.labels;
  copy.run.sizes = sizes;
  copy.run.walls = walls;
  copy.parts = copy_of(prepared.parts, options, sizes);
  return copy;
}

Run make_mesh(Prepared prepared, Stage_clock& clock) {
  Run run = std::move(prepared.run);
  const tubular::internal::Thread_limit limit(run.options.threads);
  std::vector<Part> parts = std::move(prepared.parts);
  distribute_branches(run, parts);
  distribute_walls(run, parts);
  rename_patches(run, parts);
  make_meshes(parts, clock);
  join(run, std::move(parts));
  rename_wall_patches(run);
  finish_walls(run, clock);
  make_reduced_model(run, clock);
  return run;
}

void note_changes(Run& run) {
  if (!run.options.makes_surface_only())
    for (const std::string& change : tubular::IO::changes_in(run.cells(), run.options.mesh_format()))
      run.notes.push_back(change);
}

namespace {

// Of a wrong unit nothing fails, but all that is computed is wrong.
void note_unit(Run& run) {
  const Options& o = run.options;
  if ((!o.solver_case.is_wanted() && o.zero_d_output.empty()) || run.model.openings.empty())
    return;
  constexpr double smallest = 5e-5, largest = 5e-2; // radii of vessels, in metres
  const double radius = run.model.openings.front().radius * o.physics.meters();
  if (radius >= smallest && radius <= largest)
    return;
  std::ostringstream note;
  note.precision(3);
  note << "In " << o.physics.length_unit << " the inlet's radius is " << 1000 * radius
       << " mm; if the surface has another unit, give it by --length-unit.";
  run.notes.push_back(note.str());
}

Run run_of(const Options& options, const std::string& version) {
  Run run;
  run.options = options;
  run.version = version;
  return run;
}

void make_and_write(const Options& options, const std::string& version, Progress& progress) {
  const tubular::internal::Thread_limit limit(options.threads);
  Stage_clock clock(Stage_clock::Observer(), &progress);
  Run run = run_of(options, version);
  Prepared prepared = prepare(run, read_surface(run, clock), clock);
  if (options.dry_run) {
    dry_run(prepared, clock, progress);
    return;
  }
  run = make_mesh(std::move(prepared), clock);
  if (options.partitions > 0) {
    clock.begin("partition");
    run.partition = tubular::partition_cells(run.mesh, std::size_t(options.partitions));
  }
  curve(run, clock);
  clock.begin("report");
  note_changes(run);
  note_unit(run);
  Run_report report(run);
  clock.begin("write");
  write(run, report, clock);
  progress.finish(run);
  if (!options.quiet) {
    report.print(options.verbose);
    if (std::fflush(stdout) != 0)
      throw tubular::Output_error("The summary cannot be printed; the files are written.");
  }
}

} // namespace

void execute(const Options& options, const std::string& version) {
  const bool has_output = !options.dry_run || !options.output.empty();
  check(options, has_output);
  Progress progress(options, version);
  try {
    make_and_write(options, version, progress);
  } catch (const command_line::Interrupted& e) {
    progress.fail(128 + e.signal, "Interrupted; nothing was written.");
    throw;
  } catch (const std::exception& e) {
    progress.fail(command_line::status_of(e), command_line::explanation_of(e));
    throw;
  }
}
