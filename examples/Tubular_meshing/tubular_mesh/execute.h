// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_EXECUTE_H
#define TUBULAR_MESH_EXECUTE_H

#include "Run.h"
#include "Run_report.h"
#include "Stage_clock.h"
#include "parts.h"

#include <CGAL/Tubular_meshing/Fields/Size_requests.h>
#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <string>
#include <vector>

// Reads, meshes, writes and prints what the options ask for; throws an Error where that cannot be done.
void execute(const Options& options, const std::string& version);

/* The steps of it, for programs that keep what comes of each. */

/* A surface made ready for meshing: its vessels, each with its openings and centerlines. */
struct Prepared {
  Run run;
  std::vector<Part> parts;
};
// Takes the run over.
Prepared prepare(Run& run, const CGAL::Tubular_meshing::Surface& surface, Stage_clock& clock);

// For another mesh of it, with other options, sizes and walls.
Prepared copy_of(const Prepared& prepared, const Options& options, const CGAL::Tubular_meshing::Size_requests& sizes,
                 const Wall_requests& walls);

// The mesh of all vessels.
Run make_mesh(Prepared prepared, Stage_clock& clock);

// What the format of the output changes is noted in the run, for the report.
void note_changes(Run& run);

// That are written with the mesh.
std::vector<CGAL::Tubular_meshing::Cell_array> cell_arrays(const Run& run);

// Writes everything that was asked for; nothing gets its name before all of it is whole.
void write(const Run& run, Run_report& report, Stage_clock& clock);

// A surface with the names of its patches, where they came with the input, or were given.
void write_surface(CGAL::Tubular_meshing::IO::Output_file& file, const CGAL::Tubular_meshing::Remeshed_surface& surface,
                   const CGAL::Tubular_meshing::Tubular_model& model);
// That of a model as it was closed.
void write_surface(CGAL::Tubular_meshing::IO::Output_file& file, const CGAL::Tubular_meshing::Tubular_model& model);

#endif // TUBULAR_MESH_EXECUTE_H
