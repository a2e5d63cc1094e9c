// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_WALLS_H
#define TUBULAR_MESH_WALLS_H

#include "Run.h"
#include "Stage_clock.h"
#include "parts.h"

#include <CGAL/Tubular_meshing/IO/read_surface.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

/* The vessel's wall: how thick it is where, what it is made of, and the directions in it. */

// What is asked for by arrays of the surface's file, and by a table.
Wall_requests wall_requests(const Options& o, const CGAL::Tubular_meshing::IO::Surface_data& data);

/* Gives each vessel the thickness and the materials of its wall, once branches are known, which are numbered through. */
void distribute_walls(Run& run, std::vector<Part>& parts);

/* Of the mesh of all vessels: checks that it has all materials, and finds the directions of fibres, if they are wanted. */
void finish_walls(Run& run, Stage_clock& clock);

/* The names of arrays, apart by commas, behind those that are in the list. */
void add_names_of(const std::map<std::string, std::vector<double>>& arrays, std::string& names);

/* How many cells each region has. */
std::map<int, std::size_t> cells_by_region(const CGAL::Tubular_meshing::Mixed_mesh& mesh);

#endif // TUBULAR_MESH_WALLS_H
