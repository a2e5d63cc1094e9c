// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_REPORT_QUALITY_H
#define TUBULAR_MESH_REPORT_QUALITY_H

#include "json.h"
#include "tubular_mesh/Run.h"

#include <CGAL/Tubular_meshing/Quality/quality_report.h>

/* How good the elements are; those in a metric, and those of the second order, also by measures of their own. */
Json qualities_of(const CGAL::Tubular_meshing::Quality_report& quality);
// `of_all`: that of the whole mesh
void add_metric_quality(Json& report, const CGAL::Tubular_meshing::Tubular_model& model,
                        const CGAL::Tubular_meshing::Mixed_mesh& mesh,
                        const CGAL::Tubular_meshing::Quality_report& of_all, int threads);
void add_metric_quality(Json& report, const CGAL::Tubular_meshing::Remeshed_surface& surface);
void add_quadratic(Json& report, const Run& run);

void print_qualities(const Json& report);
void print_histograms(const Json& quality);

#endif // TUBULAR_MESH_REPORT_QUALITY_H
