// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_SOLVER_CASE_H
#define TUBULAR_MESH_SOLVER_CASE_H

#include "Run.h"

#include <CGAL/Tubular_meshing/IO/Output_folder.h>

#include <map>
#include <memory>
#include <string>

/* Folders with a mesh and all else that a solver needs: --case. */

// Opens the folder; one that is there with other files than those of a case is not replaced.
std::unique_ptr<CGAL::Tubular_meshing::IO::Output_folder> open_case(const Options& options);

/* Writes the mesh, in metres, and what the templates become for its patches. Throws a Parameter_error if a pressure is
 * given at an outlet that is not there. */
void write_case(CGAL::Tubular_meshing::IO::Output_folder& folder, const Run& run);

/* The files of examples/Tubular_meshing/cases, by their paths there. */
const std::map<std::string, std::string>& case_templates();

#endif // TUBULAR_MESH_SOLVER_CASE_H
