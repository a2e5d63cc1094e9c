// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_MESH_3_IMPL_H
#define CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_MESH_3_IMPL_H

#include <CGAL/Tubular_meshing/Volume/fill_with_mesh_3.h>
#include <CGAL/Tubular_meshing/Volume/internal/mesh_3/run_mesh_3.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

CGAL_TUBULAR_MESHING_INLINE void fill_with_mesh_3(const Surface& surface, Face_patch_map patch, Length_function size,
                                                  Mixed_mesh& mesh, const Fill_with_mesh_3_options& options) {
  if (!is_triangle_mesh(surface))
    throw Input_error("Only a surface of triangles can be filled with tetrahedra; this one has quads.");
  Surface labelled;
  std::vector<std::pair<Surface::Face_index, Surface::Face_index>> copies;
  copy_face_graph(surface, labelled, CGAL::parameters::face_to_face_output_iterator(std::back_inserter(copies)));
  auto patch_id = get(face_patch_id_t<int>(), labelled);
  for (const auto& f : copies)
    put(patch_id, f.second, get(patch, f.first));

  mesh = Mixed_mesh();
  const Watched_size watched(size, labelled, options.facet_distance);
  try {
    run_mesh_3(labelled, watched, options.facet_distance, mesh);
  } catch (const Failure_exception& e) {
    throw Meshing_error("Mesh_3 cannot fill this surface (" + e.message() + " " + e.expression() +
                        "): check that it does not intersect itself.");
  }
  if (mesh.tetrahedra.empty())
    throw Meshing_error("Mesh_3 found no volume inside the surface: check that it is closed and larger than the mesh "
                        "size.");
  mesh.region_names = {{labels::lumen, "lumen"}};
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_MESH_3_IMPL_H
