// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_CENTERLINE_TRACER_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_CENTERLINE_TRACER_H

#include <CGAL/Tubular_meshing/Centerlines/internal/Interior_voronoi_diagram.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Sampled_surface.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Voronoi_front.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/essential_meetings.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Sample_refiner.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/smooth_line.h>
#include <CGAL/Tubular_meshing/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* A place where centerlines begin or end: the centre of a cap, or any point, which stands for the pole nearest to it.
 */
struct Centerline_end {
  Double_kernel::Point_3 point;
  int patch; // of the cap; labels::wall if there is none
};

/* Traces the centerlines of a sampled surface, in canonical coordinates: from the first end to each of the others. */
class Centerline_tracer {
public:
  typedef Interior_voronoi_diagram Diagram;
  typedef Diagram::Index Index;

  Centerline_tracer(Sampled_surface surface, std::vector<Centerline_end> ends)
      : surface_(std::move(surface))
      , ends_(std::move(ends)) {
    sample_caps();
    diagram_.reset(new Diagram(surface_));
    const std::size_t samples = surface_.points.size();
    const int most_rounds = 6; // each at least halves the edges that are too long
    for (int round = 0; round < most_rounds && Sample_refiner(surface_, *diagram_).refine(samples); ++round)
      diagram_.reset(new Diagram(surface_));
    find_poles();
    diagram_->make_faces();
  }

  /* One line to each end but the first; with `loops` of them, for each of these a line that begins and ends at the
   * first end. */
  std::vector<Sampled_line> lines(int loops) const {
    const std::vector<Index> targets(poles_.begin() + 1, poles_.end());
    const Voronoi_front front(*diagram_, poles_[0], loops > 0 ? std::vector<Index>() : targets);
    std::vector<Sampled_line> result;
    for (std::size_t i = 1; i < ends_.size(); ++i) {
      if (!front.has_reached(poles_[i]))
        throw Input_error("The inside of the surface does not connect its inlet with " + name(i) +
                          ": the surface is in several pieces, or closed in between.");
      Sampled_line line = front.path_from(poles_[i]);
      std::reverse(line.begin(), line.end());
      complete(line, 0, false);
      complete(line, i, true);
      result.push_back(smooth(line));
    }
    if (loops > 0)
      for (const auto& meeting : essential_meetings(*diagram_, front, std::size_t(loops))) {
        Sampled_line line = front.path_from(meeting[0]), back = front.path_from(meeting[1]);
        std::reverse(line.begin(), line.end());
        line.insert(line.end(), back.begin(), back.end());
        complete(line, 0, false);
        complete(line, 0, true);
        result.push_back(smooth(line));
      }
    return result;
  }

  /* The triangles of the wall. */
  const std::vector<Double_kernel::Triangle_3>& wall_triangles() const { return surface_.wall_triangles; }

private:
  void sample_caps() {
    const std::vector<Sampled_surface::Rim> rims = surface_.rims();
    for (const Sampled_surface::Rim& rim : rims) {
      for (std::size_t i = 0; i < ends_.size(); ++i)
        if (ends_[i].patch == rim.patch) {
          centers_.resize(ends_.size(), std::size_t(-1));
          centers_[i] = surface_.add_cap(rim.samples, ends_[i].point);
        }
    }
    centers_.resize(ends_.size(), std::size_t(-1));
  }

  void find_poles() {
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      const std::size_t sample =
          centers_[i] != std::size_t(-1) ? centers_[i] : diagram_->nearest_sample(ends_[i].point);
      const Index pole = diagram_->poles.empty() ? Diagram::none : diagram_->poles[sample];
      if (pole == Diagram::none)
        throw Input_error("No sphere inside the surface touches it at " + name(i) +
                          ": the surface is turned inside out, or not closed there; repair it.");
      poles_.push_back(pole);
    }
  }

  std::string name(std::size_t i) const {
    return (i == 0 ? std::string("its inlet") : "outlet " + std::to_string(i)) +
           (ends_[i].patch != labels::wall ? "" : " (a point that was given)");
  }

  // Lines begin and end at the centres of caps.
  void complete(Sampled_line& line, std::size_t end, bool at_back) const {
    if (centers_[end] == std::size_t(-1))
      return;
    const Line_point& next = at_back ? line.back() : line.front();
    const Line_point center = {ends_[end].point, next.radius};
    line.insert(at_back ? line.end() : line.begin(), center);
  }

  static Sampled_line smooth(const Sampled_line& line) {
    const double window = 1, step = 0.25; // radii
    return resampled(smoothed(line, window, 2), step);
  }

  Sampled_surface surface_;
  std::vector<Centerline_end> ends_;
  std::vector<std::size_t> centers_; // samples, or -1
  std::vector<Index> poles_;
  std::unique_ptr<Diagram> diagram_;
};

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_CENTERLINE_TRACER_H
