// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_NODES_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_NODES_H

#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/IO/Output_folder.h>
#include <CGAL/Tubular_meshing/IO/internal/Mesh_nodes.h>
#include <CGAL/Tubular_meshing/base/config.h>

namespace CGAL::Tubular_meshing::IO::internal {

/* The writers of formats that have quadratic elements too, of meshes of either order; those that have functions of
 * their own. */
void write_svmultiphysics(Output_folder& folder, const Mesh_nodes& nodes);
void write_febio(Output_file& file, const Mesh_nodes& nodes);
void write_xdmf(Output_file& file, const Mesh_nodes& nodes);
void write_exodus(Output_file& file, const Mesh_nodes& nodes);

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_NODES_H
