// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_STAGES_H
#define TUBULAR_MESH_STAGES_H

#include "Run.h"
#include "Stage_clock.h"
#include "parts.h"

#include <CGAL/Tubular_meshing/Fields/Size_requests.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesh_estimate.h>

#include <cstddef>
#include <vector>

/* The stages of a run, in their order; each reads what the ones before it left in the run. */

// The surface of the file, repaired, and open where labels say that vessels end.
CGAL::Tubular_meshing::Surface read_surface(Run& run, Stage_clock& clock);

// The same in two steps, of a surface that has been read: repaired, ...
CGAL::Tubular_meshing::Surface repair(Run& run, const CGAL::Tubular_meshing::IO::Surface_data& data,
                                      Stage_clock& clock);
// ... and open at labelled ends; with what the options and the file say about ends, sizes and lines.
void take_requests(Run& run, const CGAL::Tubular_meshing::IO::Surface_data& data,
                   CGAL::Tubular_meshing::Surface& surface);

// Sizes that are asked for by place, by branch, and by an array of the surface's file.
CGAL::Tubular_meshing::Size_requests size_requests(const Options& o,
                                                   const CGAL::Tubular_meshing::IO::Surface_data& data);

// Cuts round ends open where that cannot wait for the model.
void cut_ends(Run& run, CGAL::Tubular_meshing::Surface& surface, Stage_clock& clock);

void extend_openings(Run& run, CGAL::Tubular_meshing::Surface& surface, Stage_clock& clock);

// The surface with its openings, and its centerlines, given or computed.
// Whether a dry run does without centerlines: of a surface of so many triangles, if nothing asks for the branches.
bool is_to_be_sampled(const Run& run, std::size_t triangles, Stage_clock& clock);

void prepare_model(Run& run, const CGAL::Tubular_meshing::Surface& surface, Stage_clock& clock);

// About what make_meshes() would make, of each vessel.
std::vector<CGAL::Tubular_meshing::Mesh_estimate> estimate_meshes(std::vector<Part>& parts, Stage_clock& clock);

// Of each vessel the surface mesh alone, or the cells of the lumen and the walls around it.
void make_meshes(std::vector<Part>& parts, Stage_clock& clock);

// Quadratic elements, if they are wanted, of the mesh of all vessels.
void curve(Run& run, Stage_clock& clock);

#endif // TUBULAR_MESH_STAGES_H
