// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_PAGE_REPORT_TABLES_H
#define TUBULAR_MESH_PAGE_REPORT_TABLES_H

#include "../view/Shown_mesh.h"
#include "html.h"

#include <string>

/* The report of a run as sections of a page. */

// What it is, in a sentence or two, and what is to be noted.
std::string summary_of(const html::Json& report);
// Spread, histograms, and the worst cells with their places.
std::string quality_section(const html::Json& report, const Shown_mesh& mesh);
std::string openings_section(const html::Json& report);
std::string branches_section(const html::Json& report);
// Repairs, round ends, places where layers or blocks gave way: with places where these are known.
std::string places_section(const html::Json& report);
std::string times_section(const html::Json& report);
std::string command_section(const html::Json& report, const std::string& command);

#endif // TUBULAR_MESH_PAGE_REPORT_TABLES_H
