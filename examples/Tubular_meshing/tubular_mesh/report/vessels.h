// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_REPORT_VESSELS_H
#define TUBULAR_MESH_REPORT_VESSELS_H

#include "json.h"
#include "tubular_mesh/Run.h"

#include <CGAL/Tubular_meshing/Quality/lumen_measures.h>

/* What was meshed: the input's labels and defects, openings, branches, volume. Of each, its part of the report, and of
 * the summary on the terminal. */
Json repairs_of(const CGAL::Tubular_meshing::Repair_report& report);
Json labels_of(const CGAL::Tubular_meshing::Labelled_ends& ends);
Json round_ends_of(const std::vector<CGAL::Tubular_meshing::Round_end_report>& ends);
Json openings_of(const Run& run, const CGAL::Tubular_meshing::Lumen_measures& measures);
Json branches_of(const Run& run);
Json volumes_of(const Run& run, const CGAL::Tubular_meshing::Lumen_measures& measures);

/* Whether the centerlines were to keep all branches where vessels rejoin, or have them. */
bool keeps_loops(const Run& run);

void print_repairs(const Json& repairs);
void print_labels(const Json& labels);
void print_round_ends(const Json& ends);
void print_openings(const Json& openings);
void print_branches(const Json& branches);
void print_range_of_points(const Json& branches);
void print_lost_branches(const Json& report);
void print_volume(const Json& volumes);

#endif // TUBULAR_MESH_REPORT_VESSELS_H
