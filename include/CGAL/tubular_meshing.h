// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*! \file
 *
 * The pipelines, from a surface to a mesh: make_tubular_model(), Mesher, and make_isotropic_mesh() and its like. Reading,
 * repair and writing have headers of their own: IO/read_surface.h, Repair/repair_surface.h, IO/write_mesh.h.
 */

#ifndef CGAL_TUBULAR_MESHING_H
#define CGAL_TUBULAR_MESHING_H

#include <CGAL/Tubular_meshing/Pipelines/Mesher.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Pipelines/make_mesh.h>

#endif // CGAL_TUBULAR_MESHING_H
