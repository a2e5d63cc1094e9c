// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_REPORT_PARTITIONS_H
#define TUBULAR_MESH_REPORT_PARTITIONS_H

#include "json.h"

#include <CGAL/Tubular_meshing/Partition/partition_report.h>

/* Of a mesh that is written in parts. */
void add_partitions(Json& report, const CGAL::Tubular_meshing::Partition_report& partition);
void print_partitions(const Json& partitions);

#endif // TUBULAR_MESH_REPORT_PARTITIONS_H
