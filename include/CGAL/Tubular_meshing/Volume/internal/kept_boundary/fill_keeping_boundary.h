// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_FILL_KEEPING_BOUNDARY_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_FILL_KEEPING_BOUNDARY_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Child_process.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Delaunay_refinement.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Recovered_boundary.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Unit_frame.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/failure_sentence.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/sort_in_space.h>
#include <CGAL/Tubular_meshing/Patches/surface_to_mixed_mesh.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/write_inside.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <unistd.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

// What a filling may take before it is given up.
struct Filling_limits {
  double seconds; // of processor time, for the recovery of the boundary
  std::size_t most_points = in_memory();
  std::string way_out = "use fill_with_mesh_3(), which makes the surface anew"; // where it fails

  // A point and the tetrahedra around it take about 1 kB while they are made.
  static std::size_t in_memory() {
    return std::size_t(double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGE_SIZE)) / 1000);
  }
};

// The tetrahedra are turned alike, one way or the other.
inline void orient_tetrahedra(Mixed_mesh& mesh) {
  double volume = 0;
  for (const auto& t : mesh.tetrahedra.vertices)
    volume += signed_volume(Vector_3d(mesh.points[t[0]]), Vector_3d(mesh.points[t[1]]), Vector_3d(mesh.points[t[2]]),
                            Vector_3d(mesh.points[t[3]]));
  if (volume < 0)
    for (auto& t : mesh.tetrahedra.vertices)
      std::swap(t[0], t[1]);
}

/* Adds the tetrahedra of a recovery to a mesh of nothing but a surface. `recover` is called in a process of its own as
 *   int recover(const Boundary_arrays&, Recovered_boundary&),
 * and returns 0 or one of TetGen's numbers for what went wrong; `name` is what it is called in a sentence. */
template <class Surface, class Recovery>
void recover_in_child_process(const Surface& surface, const Recovery& recover, const std::string& name,
                              const Filling_limits& limits, Mixed_mesh& mesh) {
  const Unit_frame frame(mesh.points);
  Recovered_boundary recovered;
  const auto work = [&](const Pipe_writer& pipe) {
    Boundary_arrays boundary;
    for (const Point_3& p : mesh.points)
      boundary.points.push_back(frame.to_frame(p));
    boundary.triangles = mesh.triangles.vertices;
    const int code = recover(boundary, recovered);
    return code != 0 ? code : pipe.write(recovered.inner_points) && pipe.write(recovered.tetrahedra) ? 0 : 255;
  };
  const auto read = [&](const Pipe_reader& pipe) {
    return pipe.read(recovered.inner_points) && pipe.read(recovered.tetrahedra);
  };
  const Child_ending ending = run_in_child_process(work, read, limits.seconds);
  if (ending.kind != Child_ending::done)
    throw Meshing_error(failure_sentence(name, ending, surface, limits.way_out));
  for (const auto& x : recovered.inner_points)
    mesh.points.push_back(frame.from_frame(x));
  mesh.tetrahedra.label.assign(recovered.tetrahedra.size(), labels::lumen);
  mesh.tetrahedra.vertices = std::move(recovered.tetrahedra);
  orient_tetrahedra(mesh);

  const Validity_report report = validity_report(mesh);
  if (report.unlabelled_faces + report.misplaced_facets + report.overfull_faces > 0)
    throw Meshing_error(name + " could not keep this surface (" + report.defects() + "): " + limits.way_out + ".");
}

/* Where the circumscribed radius exceeds this part of h the circumcenter becomes a point: the mean edge inside is 1.05
 * h then, as it is with Mesh_3. Bounds on volume or edges that give as many tetrahedra leave up to twice as many
 * slivers. */
constexpr double kept_boundary_radius_bound = 0.78;

template <class SizingField>
void add_points_inside(const SizingField& size, std::size_t most_points, Mixed_mesh& mesh) {
  const auto size_at = [&](const Vector_3d& p) { return double(size(Point_3(p.x, p.y, p.z), 3, 0)); };
  Tetrahedron_store store(mesh);
  if (refine_inside(store, size_at, kept_boundary_radius_bound, most_points) == most_points)
    throw Meshing_error("A mesh this fine would have more than " + std::to_string(most_points) +
                        " points inside, more than the memory of this machine holds: make it coarser.");
  write_inside(store, mesh);
  sort_in_space(mesh.points, mesh.tetrahedra.vertices); // all have the same label
}

// Fills a closed surface, which stays as it is; see recover_in_child_process() for `recover` and `name`.
template <class SizingField, class Recovery>
void fill_keeping_boundary(const Surface& surface, Face_patch_map patch, const SizingField& size,
                           const Recovery& recover, const std::string& name, const Filling_limits& limits,
                           Mixed_mesh& result) {
  Mixed_mesh mesh;
  surface_to_mixed_mesh(surface, patch, mesh);
  if (!mesh.quads.empty())
    throw Meshing_error("Only a surface of triangles can be filled with tetrahedra; this one has quads.");
  recover_in_child_process(surface, recover, name, limits, mesh);
  add_points_inside(size, limits.most_points, mesh);
  mesh.region_names = {{labels::lumen, "lumen"}};
  result = std::move(mesh);
}

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_FILL_KEEPING_BOUNDARY_H
