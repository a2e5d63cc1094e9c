// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_STAGES_H
#define TUBULAR_MESH_STAGES_H

// The stages of a run that take long, to compile as well: each is a translation unit of its own.

#include "Options.h"
#include "Stage_clock.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Opening.h>
#include <CGAL/Tubular_meshing/Operators/Repair_report.h>
#include <CGAL/Tubular_meshing/Tubular_model.h>

#include <vector>

typedef CGAL::Surface_mesh<Point_3> Surface;
namespace tubular = CGAL::Tubular_meshing;

// The surface, mended.
tubular::Repair_report<Point_3> read_surface(const Options& o, Surface& surface, Stage_clock& clock);

/* Straight tubes at the openings. The list is of the openings where they are now, the inlet first, and of the tubes'
 * lengths; empty where none were asked for. */
struct Flow_extensions {
  std::vector<tubular::Opening<Point_3>> openings;
  std::vector<double> lengths;
};
Flow_extensions extend_openings(const Options& o, Surface& surface, Stage_clock& clock);

// The surface with its openings, and its centerlines, given or computed.
tubular::Tubular_model<Point_3> prepare(const Options& o, const Surface& surface, const Flow_extensions& extensions,
                                        Stage_clock& clock);

tubular::Mixed_mesh<Point_3> make_mesh(const Options& o, const tubular::Tubular_model<Point_3>& model,
                                       Stage_clock& clock);

#endif // TUBULAR_MESH_STAGES_H
