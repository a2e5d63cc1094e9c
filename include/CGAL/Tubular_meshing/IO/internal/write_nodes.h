// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_NODES_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_NODES_H

#include <CGAL/Tubular_meshing/IO/Mesh_format.h>
#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/IO/Output_folder.h>
#include <CGAL/Tubular_meshing/IO/internal/Mesh_nodes.h>
#include <CGAL/Tubular_meshing/Partition/Cell_partition.h>
#include <CGAL/Tubular_meshing/base/Cell_array.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

/* The writers of formats that have quadratic elements too, of meshes of either order; those that have functions of
 * their own. */
void write_svmultiphysics(Output_folder& folder, const Mesh_nodes& nodes);
void write_febio(Output_file& file, const Mesh_nodes& nodes);
void write_xdmf(Output_file& file, const Mesh_nodes& nodes);
// A file with a variable of more bytes than those that classic netCDF files have at most is one of netCDF-4.
void write_exodus(Output_file& file, const Mesh_nodes& nodes, std::uint64_t largest_variable = 0xfffffffc);

// The same of a mesh in parts.
void write_parts(Output& output, const Mesh_nodes& nodes, const Cell_partition& partition, Mesh_format format);
void check_arrays(const std::vector<Cell_array>& arrays, const Mixed_mesh& mesh, Mesh_format format,
                  const std::string& file);

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_NODES_H
