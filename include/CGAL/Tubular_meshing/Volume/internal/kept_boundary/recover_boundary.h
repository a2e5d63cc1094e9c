// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_RECOVER_BOUNDARY_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_RECOVER_BOUNDARY_H

#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/Volume/fill_keeping_boundary.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Unit_frame.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/boundary_recovery.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/failure_sentence.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/recover_in_delaunay.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/take_inside.h>
#include <CGAL/Tubular_meshing/base/crossing_pairs.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <unistd.h>

#include <cstddef>
#include <mutex>
#include <optional>
#include <new>
#include <string>
#include <utility>

namespace CGAL::Tubular_meshing::internal {

// What a filling may take before it is given up, and what to do instead then.
struct Filling_limits {
  bool in_child_process;
  double seconds; // of processor time, for a recovery of the boundary in a child process
  std::string instead;
  std::size_t most_points = in_memory();
  int threads; // for the points inside

  Filling_limits(const Fill_keeping_boundary_options& options, const Surface& surface, std::string instead)
      : in_child_process(options.in_child_process)
      , seconds(options.time_limit > 0 ? options.time_limit : 600 + 0.01 * double(surface.number_of_faces()))
      , instead(std::move(instead))
      , threads(options.number_of_threads) {}

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

// Whatever happens there, this process goes on.
inline Child_ending recover_in_child_process(const Boundary_recovery& recovery, const Boundary_arrays& boundary,
                                             double seconds, Recovered_boundary& recovered) {
  const auto work = [&](const Pipe_writer& pipe) {
    const int code = recovery.run(boundary, recovered);
    return code != 0 ? code : pipe.write(recovered.inner_points) && pipe.write(recovered.tetrahedra) ? 0 : 255;
  };
  const auto read = [&](const Pipe_reader& pipe) {
    return pipe.read(recovered.inner_points) && pipe.read(recovered.tetrahedra);
  };
  return run_in_child_process(work, read, seconds);
}

// One at a time: TetGen's predicates have global constants, which depend on the surface. What TetGen may crash on, a
// surface that crosses itself, is not given to it.
inline Child_ending recover_in_this_process(const Boundary_recovery& recovery, const Surface& surface,
                                            const Boundary_arrays& boundary, Recovered_boundary& recovered) {
  if (!crossing_pairs(surface).empty())
    return {Child_ending::gave_up, crossing_facets_code};
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  int code = out_of_memory_code;
  try {
    code = recovery.run(boundary, recovered);
  } catch (const std::bad_alloc&) {
  }
  return {code == 0 ? Child_ending::done : Child_ending::gave_up, code};
}

/* The recoveries of a surface, from the quickest on, in a mesh of nothing but it: its tetrahedra, all of one label, turned
 * alike, some of them outside, become part of the mesh. */
class Surface_recovery {
public:
  Surface_recovery(const Surface& surface, const Boundary_recovery& recovery, const Filling_limits& limits,
                   Mixed_mesh& mesh)
      : surface_(surface)
      , recovery_(recovery)
      , limits_(limits)
      , frame_(mesh.points)
      , mesh_(mesh)
      , surface_points_(mesh.points.size()) {
    boundary_.points.reserve(mesh.points.size());
    for (const Point_3& p : mesh.points)
      boundary_.points.push_back(frame_.to_frame(p));
    boundary_.triangles = mesh.triangles.vertices;
  }

  // By the Delaunay triangulation of its points. Whether that could be made to keep it.
  bool in_delaunay() {
    const auto fill_cavities = [&](const Boundary_arrays& cavities, Recovered_boundary& filling) {
      return recovery_.keeps_inner_facets && recover(cavities, filling).kind == Child_ending::done;
    };
    Recovered_boundary recovered;
    if (!recover_in_delaunay(boundary_, limits_.threads, fill_cavities, recovered))
      return false;
    take(std::move(recovered));
    return true;
  }

  // As a whole. Returns what went wrong, if anything did.
  std::optional<Sentence> as_a_whole() {
    Recovered_boundary recovered;
    const Child_ending ending = recover(boundary_, recovered);
    if (ending.kind != Child_ending::done)
      return failure_sentence(recovery_.name, ending, surface_, limits_.instead);
    take(std::move(recovered));
    return std::nullopt;
  }

  // Of what was taken last: why it does not do.
  Sentence sentence() const {
    const Validity_report report = validity_report(mesh_, parameters::number_of_threads(limits_.threads));
    return Sentence(recovery_.name + " could not keep this surface (" + report.defects() + "): " + limits_.instead +
                    ".");
  }

private:
  Child_ending recover(const Boundary_arrays& part, Recovered_boundary& result) const {
    return limits_.in_child_process ? recover_in_child_process(recovery_, part, limits_.seconds, result)
                                    : recover_in_this_process(recovery_, surface_, part, result);
  }

  void take(Recovered_boundary recovered) {
    mesh_.points.resize(surface_points_);
    for (const Vector_3d& x : recovered.inner_points)
      mesh_.points.push_back(frame_.from_frame(x));
    mesh_.tetrahedra.label.assign(recovered.tetrahedra.size(), labels::lumen);
    mesh_.tetrahedra.vertices = std::move(recovered.tetrahedra);
    orient_tetrahedra(mesh_);
  }

  const Surface& surface_;
  const Boundary_recovery& recovery_;
  const Filling_limits& limits_;
  const Unit_frame frame_;
  Boundary_arrays boundary_;
  Mixed_mesh& mesh_;
  const std::size_t surface_points_;
};

/* Fills a closed surface with tetrahedra, which get a store: of the points of the surface, in a mesh of nothing but it,
 * and of as few others as it takes. Returns what went wrong, if anything did. */
inline std::optional<Sentence> recover_boundary(const Surface& surface, const Boundary_recovery& recovery,
                                                const Filling_limits& limits, Mixed_mesh& mesh,
                                                std::optional<Tetrahedron_store>& tetrahedra) {
  Surface_recovery recoveries(surface, recovery, limits, mesh);
  if (recoveries.in_delaunay())
    tetrahedra = take_inside(mesh, limits.threads);
  if (tetrahedra)
    return std::nullopt;
  if (std::optional<Sentence> failure = recoveries.as_a_whole())
    return failure;
  tetrahedra = take_inside(mesh, limits.threads);
  if (!tetrahedra)
    return recoveries.sentence();
  return std::nullopt;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_RECOVER_BOUNDARY_H
