// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_SECTION_SNAPPER_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_SECTION_SNAPPER_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Cut_surface.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Plane_section.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Makes of a section the curve to cut: where the section crosses an edge near one of its ends, it goes through that
 * vertex instead, or the triangles there would be slivers.
 *
 * A section crosses the edges about a vertex one after the other. When it snaps to the vertex, all these crossings
 * become the one: the curve, which leaves the plane by no more than the vertex does, then goes straight from the edges
 * before to the vertex, and on. It stays a closed curve through the same faces. */
class Section_snapper {
public:
  explicit Section_snapper(const Cut_surface& surface)
      : surface_(surface)
      , mesh_(surface.mesh()) {}

  /* False if the section comes so near to a rim, to a curve cut before or to itself that the curve would touch it. */
  bool snap(const Plane_section& section, Cut_surface::Curve& curve) {
    return snap(section.crossings(), section.mean_radius(), curve);
  }

  /* The same for any closed curve over the faces, given by its crossings, whose heights are lengths. */
  bool snap(const std::vector<Plane_section::Crossing>& crossings, double mean_radius, Cut_surface::Curve& curve) {
    crossings_ = &crossings;
    const std::size_t n = crossings_->size();
    count_crossings_about_vertices();
    std::vector<Run> runs;
    if (!find_runs(near_share * mean_radius, runs))
      return false;
    std::sort(runs.begin(), runs.end());
    std::vector<Vertex> snapped(n, Surface::null_vertex());
    for (const Run& run : runs)
      for (std::size_t i = 0; i < run.length; ++i) {
        Vertex& v = snapped[(run.begin + i) % n];
        v = v == Surface::null_vertex() ? run.vertex : v;
      }
    make_curve(snapped, curve);
    return curve.size() >= 3;
  }

private:
  static constexpr double near_edge_end = 0.25; // of the edge's length
  static constexpr double near_share = 0.25;    // of the section's radius: how far a curve may leave its plane

  // The crossings about a vertex: `length` of them, from number `begin` on.
  struct Run {
    Vertex vertex;
    std::size_t begin, length;
    double height;

    // A vertex whose only crossed edge leads into the midst of another one's run must not interrupt that.
    bool operator<(const Run& r) const {
      return std::make_tuple(length == 1, height, vertex) < std::make_tuple(r.length == 1, r.height, r.vertex);
    }
  };

  void count_crossings_about_vertices() {
    about_.clear();
    for (const auto& c : *crossings_) {
      ++about_[mesh_.source(c.halfedge)];
      ++about_[mesh_.target(c.halfedge)];
    }
  }

  bool is_end(std::size_t i, Vertex v) const {
    const Halfedge h = (*crossings_)[i].halfedge;
    return mesh_.source(h) == v || mesh_.target(h) == v;
  }

  bool find_runs(double limit, std::vector<Run>& runs) const {
    std::set<Vertex> done;
    for (std::size_t i = 0; i < crossings_->size(); ++i) {
      const auto& c = (*crossings_)[i];
      const bool at_source = c.t < 0.5;
      const double t = (std::min)(c.t, 1 - c.t), height = std::abs(at_source ? c.source_height : c.target_height);
      if (t >= near_edge_end)
        continue;
      const Vertex v = at_source ? mesh_.source(c.halfedge) : mesh_.target(c.halfedge);
      if (surface_.is_taken(v))
        return false;
      if (height > limit || !done.insert(v).second)
        continue;
      const Run run = run_about(v, i, height);
      if (run.length == about_.at(v))
        runs.push_back(run);
      else if (t < 0.1 * near_edge_end) // it passes the vertex twice, and so near that it would touch itself
        return false;
    }
    return true;
  }

  Run run_about(Vertex v, std::size_t i, double height) const {
    const std::size_t n = crossings_->size();
    Run run{v, i, 1, height};
    while (run.length < n && is_end((run.begin + n - 1) % n, v)) {
      run.begin = (run.begin + n - 1) % n;
      ++run.length;
    }
    while (run.length < n && is_end((run.begin + run.length) % n, v))
      ++run.length;
    return run;
  }

  void make_curve(const std::vector<Vertex>& snapped, Cut_surface::Curve& curve) const {
    const std::size_t n = snapped.size();
    curve.clear();
    for (std::size_t i = 0; i < n; ++i) {
      const auto& c = (*crossings_)[i];
      if (snapped[i] != Surface::null_vertex() && snapped[i] == snapped[(i + 1) % n])
        continue; // the last crossing about a vertex tells the face that the curve enters
      curve.push_back(Curve_point{snapped[i], c.halfedge, c.t, mesh_.face(mesh_.opposite(c.halfedge))});
    }
  }

  const Cut_surface& surface_;
  const Surface& mesh_;
  const std::vector<Plane_section::Crossing>* crossings_ = nullptr;
  std::unordered_map<Vertex, std::size_t> about_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_SECTION_SNAPPER_H
