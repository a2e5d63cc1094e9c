// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_REPORT_ZERO_D_MODEL_H
#define TUBULAR_MESH_REPORT_ZERO_D_MODEL_H

#include "json.h"

#include <CGAL/Tubular_meshing/Centerlines/zero_d_model.h>

void add_zero_d_model(Json& report, const CGAL::Tubular_meshing::Zero_d_model& model);
void print_zero_d_model(const Json& model);

#endif // TUBULAR_MESH_REPORT_ZERO_D_MODEL_H
