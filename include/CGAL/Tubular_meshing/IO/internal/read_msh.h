// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_MSH_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_MSH_H

#include <CGAL/Tubular_meshing/IO/internal/Gmsh_file.h>
#include <CGAL/Tubular_meshing/IO/internal/element_kinds.h>
#include <CGAL/Tubular_meshing/IO/internal/fail_quadratic.h>

#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

inline bool is_symmetric_tensor(const double* t) {
  return t[1] == t[3] && t[2] == t[6] && t[5] == t[7];
}

// Data that not every node has are passed over. Tensors that are symmetric, all of them, are kept in six components.
inline void read_msh_point_array(const Gmsh_node_data& d, Mixed_mesh& mesh) {
  const std::size_t n = mesh.points.size();
  if (d.nodes.size() != n)
    return;
  std::vector<double> values(n * d.components);
  for (std::size_t i = 0; i < n; ++i)
    std::copy_n(d.values.begin() + static_cast<std::ptrdiff_t>(i * d.components), d.components,
                values.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(d.nodes[i]) * d.components));
  bool symmetric = d.components == 9;
  for (std::size_t i = 0; i < n && symmetric; ++i)
    symmetric = is_symmetric_tensor(&values[9 * i]);
  if (!symmetric) {
    mesh.point_arrays.push_back({d.name, static_cast<int>(d.components), std::move(values)});
    return;
  }
  Point_array folded{d.name, 6, std::vector<double>(6 * n)};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < 9; ++k)
      folded.values[6 * i + symmetric_component[k]] = values[9 * i + k];
  mesh.point_arrays.push_back(std::move(folded));
}

// Points and lines among the elements are passed over.
inline void read_msh(const Input_file& file, Mixed_mesh& mesh) {
  Gmsh_file msh(file);
  mesh.points = to_points(msh.points);
  for (const auto& n : msh.names)
    if (n.first.first == 3)
      mesh.region_names[n.first.second] = n.second;
    else if (n.first.first == 2)
      mesh.patch_names[n.first.second] = n.second;
  for (const Gmsh_file::Element& e : msh.elements) {
    if (e.type == gmsh::point || e.type == gmsh::line)
      continue;
    const Element_kind* kind = find_kind(&Element_kind::gmsh_type, e.type);
    if (is_quadratic_gmsh_type(e.type))
      fail_quadratic(file, "element " + std::to_string(e.tag));
    if (!kind)
      file.fail("cannot be used: element " + std::to_string(e.tag) + " is of Gmsh's type " + std::to_string(e.type) +
                "; save the mesh with elements of first order");
    add_element(mesh, *kind, msh.element_nodes.begin() + static_cast<std::ptrdiff_t>(e.first_node), false,
                static_cast<int>(e.physical));
  }
  for (const Gmsh_node_data& d : msh.node_data)
    read_msh_point_array(d, mesh);
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_MSH_H
