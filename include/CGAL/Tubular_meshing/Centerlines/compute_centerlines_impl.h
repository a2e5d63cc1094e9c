// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_COMPUTE_CENTERLINES_IMPL_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_COMPUTE_CENTERLINES_IMPL_H

#include <CGAL/Tubular_meshing/Centerlines/build_centerline_graph.h>
#include <CGAL/Tubular_meshing/Centerlines/compute_centerlines.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Centerline_tracer.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Surface_loops.h>
#include <CGAL/Tubular_meshing/base/Canonical_frame.h>
#include <CGAL/Tubular_meshing/base/Labelled_surface.h>
#include <CGAL/Tubular_meshing/base/Corner_tree.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/Task_beside.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>

namespace CGAL::Tubular_meshing::internal {

inline void check_closed_surface(const Surface& surface) {
  if (surface.is_empty())
    throw Input_error("The surface is empty; it has no centerlines.");
  if (!CGAL::is_triangle_mesh(surface) || !CGAL::is_closed(surface))
    throw Input_error("Centerlines are computed inside closed surfaces of triangles; close the openings of this one "
                      "first (close_openings()), and triangulate its faces.");
  for (auto v : surface.vertices())
    for (int k = 0; k < 3; ++k)
      if (!std::isfinite(surface.point(v)[k]))
        throw Input_error("Vertex " + std::to_string(std::size_t(v)) +
                          " of the surface has a coordinate that is not a number; repair the file.");
}

// The graph in the canonical frame, as a graph of the caller's points.
inline Centerline_graph from_canonical(const Centerline_graph& graph, const Canonical_frame& frame,
                                       const Point_3& root) {
  std::vector<Point_3> points;
  std::vector<double> radii;
  std::vector<std::vector<std::size_t>> branches;
  for (const Point_3& p : graph.points()) {
    const Double_kernel::Point_3 q = frame.from_canonical(to_double_point(p));
    points.emplace_back(q.x(), q.y(), q.z());
  }
  for (double r : graph.radii())
    radii.push_back(frame.scale() * r);
  for (const auto& b : graph.branches())
    branches.push_back(b.points);
  Centerline_graph result(std::move(points), std::move(radii), std::move(branches));
  const auto away = [&](std::size_t n) {
    return CGAL::squared_distance(result.points()[result.nodes()[n].point], root);
  };
  std::size_t nearest = 0;
  for (std::size_t n = 1; n < result.nodes().size(); ++n)
    if (away(n) < away(nearest))
      nearest = n;
  result.direct_from(nearest);
  return result;
}

// Independent ones, of a graph of one piece.
inline std::size_t number_of_loops(const Centerline_graph& graph) {
  return graph.branches().size() + 1 - graph.nodes().size();
}

struct Centerline_computation::Impl {
  Impl(const Surface& surface, const std::vector<std::pair<Point_3, int>>& ends, std::size_t needed,
       int number_of_threads)
      : threads(number_of_threads)
      , frame(points_of(surface, ends.size(), needed))
      , root(ends.front().first) {}

  static std::vector<Double_kernel::Point_3> points_of(const Surface& surface, std::size_t number_of_ends,
                                                       std::size_t needed) {
    check_closed_surface(surface);
    if (number_of_ends < needed)
      throw Input_error("Centerlines lead from an inlet to outlets, but the surface has only " +
                        std::to_string(number_of_ends) + " opening; name further ends, by points.");
    std::vector<Double_kernel::Point_3> points;
    for (auto v : surface.vertices())
      points.push_back(to_double_point(surface.point(v)));
    return points;
  }

  std::vector<Centerline_end> canonical(const std::vector<std::pair<Point_3, int>>& ends) const {
    std::vector<Centerline_end> result;
    for (const auto& e : ends)
      result.push_back(Centerline_end{frame.to_canonical(to_double_point(e.first)), e.second});
    return result;
  }

  // Those of Surface_loops, in the frame.
  std::vector<std::vector<Double_kernel::Point_3>> loops_on(const Surface& surface) const {
    std::vector<std::vector<Double_kernel::Point_3>> result;
    const Surface_loops found(surface);
    for (const Surface_loops::Loop& loop : found.loops()) {
      result.emplace_back();
      for (auto v : loop)
        result.back().push_back(frame.to_canonical(to_double_point(surface.point(v))));
    }
    return result;
  }

  // What else there is to do, is done beside what is the work of one thread: the front, and the insertion of few samples.
  void trace(const Surface& surface, const Face_patch_map& patch, const std::vector<std::pair<Point_3, int>>& ends,
             bool with_loops, bool everywhere, Function_view<void()> beside) {
    Sampled_surface samples(surface, patch, frame, threads);
    const std::vector<Double_kernel::Triangle_3> triangles = std::move(samples.wall_triangles);
    std::vector<std::vector<Double_kernel::Point_3>> on_surface;
    if (with_loops && !everywhere)
      on_surface = loops_on(surface); // how far the front is to run depends on it
    Task_beside others;
    const auto do_others = [&] {
      if (with_loops && everywhere)
        on_surface = loops_on(surface);
      wall = Corner_tree<Double_kernel::Triangle_3>(triangles);
      beside();
    };
    const bool are_few = !Centerline_tracer::Diagram::are_inserted_side_by_side(samples.number_in_use(), threads);
    if (are_few)
      others.run(do_others);
    tracer = std::make_unique<Centerline_tracer>(std::move(samples), canonical(ends), threads);
    if (!are_few)
      others.run(do_others);
    tracer->trace(everywhere || !on_surface.empty());
    others.wait();
    loops = on_surface.size() / 2;
    if (!on_surface.empty())
      tracer->add_loops(on_surface, Essential_meetings::Wall(triangles));
  }

  Centerline_graph merged(const std::vector<Sampled_line>& lines, const Build_centerline_graph_options& options) const {
    Centerline_polylines polylines;
    for (const Sampled_line& line : lines) {
      polylines.lines.emplace_back();
      for (const Line_point& p : line) {
        polylines.lines.back().push_back(polylines.points.size());
        polylines.points.push_back(to_core(p.point));
      }
    }
    polylines.radius = measured(polylines.points);
    Centerline_graph result;
    build_centerline_graph(polylines, result, options);
    result.set_radii(measured(result.points()));
    return result;
  }

  // Lines share points with each other and with their graph, and graphs of one computation with each other: no point is
  // measured twice.
  std::vector<double> measured(const std::vector<Point_3>& points) const {
    std::vector<Double_kernel::Point_3> unknown;
    for (const Point_3& p : points)
      if (known_radii.emplace(p, unmeasured).second)
        unknown.push_back(to_double_point(p));
    const std::vector<double> of_unknown = distances_to_wall(unknown);
    for (std::size_t i = 0; i < unknown.size(); ++i)
      known_radii[to_core(unknown[i])] = of_unknown[i];
    std::vector<double> radii;
    radii.reserve(points.size());
    for (const Point_3& p : points)
      radii.push_back(known_radii.at(p));
    return radii;
  }
  static constexpr double unmeasured = -1;

  // By blocks that do not depend on the threads: a search begins with what the one before has found.
  std::vector<double> distances_to_wall(const std::vector<Double_kernel::Point_3>& points) const {
    const std::size_t block = 64;
    std::vector<double> distances(points.size());
    for_each_task((points.size() + block - 1) / block, threads, [&](std::size_t b) {
      std::size_t hint = wall.size();
      for (std::size_t i = b * block; i < (std::min)(points.size(), (b + 1) * block); ++i) {
        const auto found = wall.nearest_from(hint, points[i], (std::numeric_limits<double>::infinity)());
        hint = found.index;
        distances[i] = std::sqrt(found.squared_distance);
      }
    });
    return distances;
  }

  const int threads;
  const Canonical_frame frame;
  Point_3 root;
  std::size_t loops = 0; // of the lumen; 0 also if they are not wanted
  std::unique_ptr<Centerline_tracer> tracer;
  Corner_tree<Double_kernel::Triangle_3> wall;
  mutable std::unordered_map<Point_3, double> known_radii; // in the frame, of points of lines and graphs
};

CGAL_TUBULAR_MESHING_INLINE
Centerline_computation::Centerline_computation(const Surface& surface, const Face_patch_map& patch,
                                               const std::vector<std::pair<Point_3, int>>& ends, bool loops,
                                               bool everywhere, int threads, Function_view<void()> beside) {
  if (ends.empty()) // before one is taken for the root
    throw Input_error("Centerlines lead from an inlet to outlets, but the surface has no opening; name its ends, by "
                      "points.");
  impl_ = std::make_unique<Impl>(surface, ends, everywhere ? 1 : 2, threads);
  run_on(threads, [&] { impl_->trace(surface, patch, ends, loops, everywhere, beside); });
}

CGAL_TUBULAR_MESHING_INLINE Centerline_computation::~Centerline_computation() = default;

CGAL_TUBULAR_MESHING_INLINE bool Centerline_computation::add_ends(const std::vector<Surface::Vertex_index>& vertices) {
  return impl_->tracer->add_ends(std::vector<std::size_t>(vertices.begin(), vertices.end()));
}

CGAL_TUBULAR_MESHING_INLINE void Centerline_computation::start_from(const Point_3& end) {
  impl_->root = end;
  impl_->tracer->start_from(impl_->frame.to_canonical(to_double_point(end)));
}

CGAL_TUBULAR_MESHING_INLINE double Centerline_computation::longest_line() const {
  double longest = 0;
  for (const Sampled_line& line : impl_->tracer->lines()) {
    double widest = 0;
    for (const Line_point& p : line)
      widest = (std::max)(widest, p.radius);
    if (widest > 0)
      longest = (std::max)(longest, length(line) / widest);
  }
  return longest;
}

CGAL_TUBULAR_MESHING_INLINE void
Centerline_computation::make_graph(Centerline_graph& graph, const Build_centerline_graph_options& options) const {
  std::vector<Sampled_line> lines = impl_->tracer->lines();
  Centerline_graph merged;
  run_on(impl_->threads, [&] { merged = impl_->merged(lines, options); });
  // The two lines of a loop may part once more where the lumen is wide: one that adds nothing else is left out.
  for (std::size_t i = lines.size(); i-- > 0 && impl_->loops > 0 && number_of_loops(merged) > impl_->loops;) {
    std::vector<Sampled_line> fewer = lines;
    fewer.erase(fewer.begin() + std::ptrdiff_t(i));
    Centerline_graph other = impl_->merged(fewer, options);
    if (number_of_loops(other) < impl_->loops || number_of_loops(other) >= number_of_loops(merged) ||
        other.number_of_ends() < merged.number_of_ends())
      continue;
    lines = std::move(fewer);
    merged = std::move(other);
  }
  graph = from_canonical(merged, impl_->frame, impl_->root);
}

CGAL_TUBULAR_MESHING_INLINE void compute_centerlines(const Surface& surface, const Face_patch_map& patch,
                                                     const std::vector<Opening>& openings, Centerline_graph& graph,
                                                     const Compute_centerlines_options& options) {
  std::vector<std::pair<Point_3, int>> ends;
  for (const Opening& o : openings)
    ends.emplace_back(o.center, o.patch);
  Build_centerline_graph_options merging;
  merging.merge_tolerance = options.merge_tolerance;
  Centerline_computation(surface, patch, ends, options.loops, false, options.number_of_threads)
      .make_graph(graph, merging);
}

CGAL_TUBULAR_MESHING_INLINE void compute_centerlines(const Surface& surface, const std::vector<Point_3>& ends,
                                                     Centerline_graph& graph,
                                                     const Compute_centerlines_options& options) {
  Labelled_surface labelled(surface);
  for (Surface::Face_index f : labelled.surface.faces())
    labelled.patch[f] = labels::wall;
  std::vector<Opening> openings(ends.size());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    openings[i].center = ends[i];
    openings[i].patch = labels::wall;
  }
  compute_centerlines(labelled.surface, labelled.patch, openings, graph, options);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_COMPUTE_CENTERLINES_IMPL_H
