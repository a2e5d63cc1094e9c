// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_TETGEN_FILL_IN_CHILD_PROCESS_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_TETGEN_FILL_IN_CHILD_PROCESS_H

#include <CGAL/Tubular_meshing/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Quality/internal/element_measures.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/Volume/internal/tetgen/Child_process.h>
#include <CGAL/Tubular_meshing/Volume/internal/tetgen/Filling_arrays.h>
#include <CGAL/Tubular_meshing/Volume/internal/tetgen/Unit_frame.h>
#include <CGAL/Tubular_meshing/Volume/internal/tetgen/failure_sentence.h>
#include <CGAL/Tubular_meshing/Volume/internal/tetgen/surface_to_mixed_mesh.h>
#include <CGAL/Tubular_meshing/exceptions.h>
#include <CGAL/Tubular_meshing/internal/Vector_3d.h>
#include <CGAL/Tubular_meshing/labels.h>

#include <array>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

// With the memory of this machine; TetGen takes about 2 kB for a point and the tetrahedra around it.
inline std::size_t most_points_in_memory() {
  return std::size_t(double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGE_SIZE)) / 2000);
}

template <class Point> Boundary_arrays boundary_in_frame(const Mixed_mesh<Point>& mesh, const Unit_frame& frame) {
  Boundary_arrays boundary;
  boundary.points.reserve(mesh.points.size());
  for (const Point& p : mesh.points)
    boundary.points.push_back(frame.to_frame(p));
  boundary.triangles = mesh.triangles.vertices;
  return boundary;
}

// The tetrahedra are turned alike, one way or the other.
template <class Point> void orient_tetrahedra(Mixed_mesh<Point>& mesh) {
  double volume = 0;
  for (const auto& t : mesh.tetrahedra.vertices)
    volume += signed_volume(Vector_3d(mesh.points[t[0]]), Vector_3d(mesh.points[t[1]]), Vector_3d(mesh.points[t[2]]),
                            Vector_3d(mesh.points[t[3]]));
  if (volume < 0)
    for (auto& t : mesh.tetrahedra.vertices)
      std::swap(t[0], t[1]);
}

template <class Point> void check_boundary_kept(const Mixed_mesh<Point>& mesh) {
  const Validity_report report = validity_report(mesh);
  if (report.unlabelled_faces + report.misplaced_facets + report.overfull_faces > 0)
    throw Meshing_error("TetGen could not keep this surface (" + report.defects() +
                        "): use fill_with_mesh_3(), which makes the surface anew.");
}

/* Fills a closed surface by a mesher that keeps it, in a process of its own. `mesher` is called there as
 *   int mesher(const Boundary_arrays&, const Size&, std::size_t most_points, Filling_arrays&),
 * with the size as a function of a `std::array<double, 3>`, and returns 0 or one of TetGen's numbers for what went
 * wrong. */
template <class TriangleMesh, class FacePatchMap, class SizingField, class Mesher, class Point>
void fill_in_child_process(const TriangleMesh& surface, FacePatchMap patch, const SizingField& size, double seconds,
                           const Mesher& mesher, Mixed_mesh<Point>& result) {
  Mixed_mesh<Point> mesh;
  surface_to_mixed_mesh(surface, patch, mesh);
  const Unit_frame frame(mesh.points);
  const std::size_t most_points = most_points_in_memory();
  Filling_arrays filling;
  const auto work = [&](const Pipe_writer& pipe) {
    const auto size_in_frame = [&](const std::array<double, 3>& x) {
      return size(frame.template from_frame<Point>(x.data()), 3, 0) / frame.scale();
    };
    const int code = mesher(boundary_in_frame(mesh, frame), size_in_frame, most_points, filling);
    if (code != 0)
      return code;
    if (filling.inner_points.size() >= most_points)
      return out_of_memory_code;
    return pipe.write(filling.inner_points) && pipe.write(filling.tetrahedra) ? 0 : 255;
  };
  const auto read = [&](const Pipe_reader& pipe) {
    return pipe.read(filling.inner_points) && pipe.read(filling.tetrahedra);
  };
  const Child_ending ending = run_in_child_process(work, read, seconds);
  if (ending.kind != Child_ending::done)
    throw Meshing_error(failure_sentence(ending, surface));

  mesh.points.reserve(mesh.points.size() + filling.inner_points.size());
  for (const auto& x : filling.inner_points)
    mesh.points.push_back(frame.template from_frame<Point>(x.data()));
  mesh.tetrahedra.label.assign(filling.tetrahedra.size(), labels::lumen);
  mesh.tetrahedra.vertices = std::move(filling.tetrahedra);
  orient_tetrahedra(mesh);
  check_boundary_kept(mesh);
  mesh.region_names = {{labels::lumen, "lumen"}};
  result = std::move(mesh);
}

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_TETGEN_FILL_IN_CHILD_PROCESS_H
