// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_PARTS_H
#define TUBULAR_MESH_PARTS_H

#include "Run.h"

#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <vector>

/* One of the vessels of a file, and the run that meshes it. */
struct Part {
  CGAL::Tubular_meshing::Surface surface;
  Run run;
};

/* The vessels, the largest first. Points, lines and labelled ends go with the vessel that they are nearest to. */
std::vector<Part> split(const Run& run, const CGAL::Tubular_meshing::Surface& surface);

/* For another mesh of the same vessels, with other options and sizes. */
std::vector<Part> copy_of(const std::vector<Part>& parts, const Options& options,
                          const CGAL::Tubular_meshing::Size_requests& sizes);

/* Gives each vessel the sizes that are asked for in its branches, which are numbered through, once they are known. */
void distribute_branches(const Run& run, std::vector<Part>& parts);

/* Brings what came of the parts together in the run of the whole. */
void join(Run& run, std::vector<Part> parts);

/* Throws an Input_error, with the list of the openings, if there are not as many as the user says. */
void check_number_of_openings(const Run& run, const std::vector<Part>& parts);

#endif // TUBULAR_MESH_PARTS_H
