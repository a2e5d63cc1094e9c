// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_REPORT_TIMES_H
#define TUBULAR_MESH_REPORT_TIMES_H

#include "json.h"

class Stage_clock;

/* Seconds by stage and in all, and the most memory that the program has had. */
void add_times(Json& report, const Stage_clock& clock);
void print_times(const Json& report);

#endif // TUBULAR_MESH_REPORT_TIMES_H
