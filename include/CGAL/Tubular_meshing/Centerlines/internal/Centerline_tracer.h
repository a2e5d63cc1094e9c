// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_CENTERLINE_TRACER_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_CENTERLINE_TRACER_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Interior_voronoi_diagram.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Sampled_surface.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Voronoi_front.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Essential_meetings.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Sample_refiner.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/smooth_line.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

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

  /* `threads`: 0 for all; lines do not depend on it. */
  Centerline_tracer(Sampled_surface surface, std::vector<Centerline_end> ends, int threads)
      : threads_(threads)
      , surface_(std::move(surface))
      , ends_(std::move(ends))
      , diagram_(threads) {
    sample_caps();
    diagram_.insert_samples(surface_);
    // Each round at least halves the edges that are too long. A surface of a few triangles round each vessel asks for
    // many samples at first, and for ever more then, as the spheres between the facets are found to be smaller still:
    // its centerlines are as good without these.
    Sample_refiner refiner(surface_, threads);
    const int most_rounds = 6;
    const std::size_t enough = (std::max)(std::size_t(20000), 4 * surface_.points.size());
    for (int round = 0; round < most_rounds && surface_.points.size() < enough && refiner.refine(diagram_); ++round)
      diagram_.insert_samples(surface_);
    const std::vector<std::size_t> samples = samples_at_ends();
    diagram_.make(surface_);
    find_poles(samples);
  }

  /* Traces one line to each end but the first. Further ends and loops can be added afterwards if the front is to run
   * everywhere, not only as far as the ends. */
  void trace(bool everywhere) {
    const std::vector<Index> outlets(poles_.begin() + 1, poles_.end());
    front_.reset(new Voronoi_front(diagram_, poles_[0], everywhere ? std::vector<Index>() : outlets));
    std::vector<std::size_t> reached;
    for (std::size_t i = 1; i < ends_.size(); ++i) {
      if (!front_->has_reached(poles_[i]))
        throw Input_error("The inside of the surface does not connect its inlet with " + name(i) +
                          ": the surface is in several pieces, or closed in between.");
      reached.push_back(i);
    }
    trace_to(reached);
  }

  /* Traces one line or two for each independent loop of the lumen: see Loop_linking. */
  void add_loops(const std::vector<std::vector<Diagram::Point>>& surface_loops, const Essential_meetings::Wall& wall) {
    const Essential_meetings found(diagram_, *front_, surface_loops, wall);
    for (const auto& meeting : found.meetings())
      add_loop(*front_, meeting[0], meeting[1], lines_);
  }

  /* Traces a line to each of these vertices of the wall, by their numbers, to which one leads; false if there are none. */
  bool add_ends(const std::vector<std::size_t>& vertices) {
    std::vector<std::size_t> reached;
    for (std::size_t v : vertices) {
      const std::size_t sample = surface_.sample_of(v);
      const Index pole = diagram_.poles[sample];
      if (pole == Diagram::none || pole == poles_[0] || !front_->has_reached(pole))
        continue;
      reached.push_back(ends_.size());
      ends_.push_back(Centerline_end{surface_.points[sample], labels::wall});
      centers_.push_back(std::size_t(-1));
      poles_.push_back(pole);
    }
    trace_to(reached);
    return !reached.empty();
  }

  /* Traces all lines once more, from that of their ends that is nearest to a point. The ends have to be points, and the front
   * has to have run everywhere. */
  void start_from(const Diagram::Point& p) {
    std::size_t source = 0;
    for (std::size_t i = 1; i < poles_.size(); ++i)
      if (distance(p, diagram_.points[poles_[i]]) < distance(p, diagram_.points[poles_[source]]))
        source = i;
    std::swap(ends_[0], ends_[source]);
    std::swap(poles_[0], poles_[source]);
    front_.reset(new Voronoi_front(diagram_, poles_[0], {}));
    lines_.clear();
    std::vector<std::size_t> reached;
    for (std::size_t i = 1; i < poles_.size(); ++i)
      if (poles_[i] != poles_[0] && front_->has_reached(poles_[i]))
        reached.push_back(i);
    trace_to(reached);
  }

  const std::vector<Sampled_line>& lines() const { return lines_; }

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

  std::vector<std::size_t> samples_at_ends() const {
    std::vector<std::size_t> samples;
    for (std::size_t i = 0; i < ends_.size(); ++i)
      samples.push_back(is_cap(i) ? centers_[i] : diagram_.nearest_sample(ends_[i].point));
    return samples;
  }

  void find_poles(const std::vector<std::size_t>& samples) {
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      const std::size_t sample = samples[i];
      const Index pole = diagram_.poles[sample];
      if (pole == Diagram::none)
        throw Input_error("No sphere inside the surface touches it at " + name(i) +
                          ": the surface is turned inside out, or not closed there; repair it.");
      if (!is_cap(i) && distance(ends_[i].point, surface_.points[sample]) > 2 * diagram_.radii[pole])
        throw Input_error("The place of " + name(i) +
                          " is further from the surface than the vessel nearest to it is wide; give a point in the "
                          "lumen, or near its wall, in the unit of the surface.");
      if (i > 0 && pole == poles_[0] && !is_cap(i) && !is_cap(0))
        throw Input_error("The place of " + name(i) +
                          " is that of the inlet, so that no line leads from one to the "
                          "other; give points further apart.");
      poles_.push_back(pole);
    }
  }

  void trace_to(const std::vector<std::size_t>& ends) {
    const std::size_t before = lines_.size();
    lines_.resize(before + ends.size());
    for_each_task(ends.size(), threads_, [&](std::size_t i) {
      lines_[before + i] = finished(reversed(front_->path_from(poles_[ends[i]])), ends[i]);
    });
  }

  bool is_cap(std::size_t end) const { return centers_[end] != std::size_t(-1); }

  std::string name(std::size_t i) const {
    return (i == 0 ? std::string("its inlet") : "outlet " + std::to_string(i)) +
           (ends_[i].patch != labels::wall ? "" : " (a point that was given)");
  }

  // By one side of a loop to the meeting at its far side, and on, as blood would flow, to the nearest outlet that lies
  // beyond; and by the other side likewise. Where there is none beyond, so far back by the other side that they join.
  void add_loop(const Voronoi_front& front, Index a, Index b, std::vector<Sampled_line>& lines) const {
    const std::array<Index, 2> side = {{a, b}};
    const std::array<Sampled_line, 2> back = {{front.path_from(a), front.path_from(b)}};
    for (int i = 0; i < 2; ++i) {
      const Voronoi_front onward(diagram_, side[1 - i], {});
      const std::size_t outlet = nearest_outlet(onward, back[1 - i], back[i]);
      Sampled_line line = reversed(back[i]);
      if (outlet == 0) {
        const Sampled_line end = beginning_of(back[1 - i]);
        line.insert(line.end(), end.begin(), end.end());
      } else {
        const Sampled_line rest = reversed(onward.path_from(poles_[outlet]));
        line.insert(line.end(), rest.begin(), rest.end());
      }
      lines.push_back(finished(std::move(line), outlet));
    }
  }

  // Of the outlets that are reached by one way, and not by the other; 0 if there is none.
  std::size_t nearest_outlet(const Voronoi_front& onward, const Sampled_line& way, const Sampled_line& other) const {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < ends_.size(); ++i)
      if ((nearest == 0 || onward.time(poles_[i]) < onward.time(poles_[nearest])) &&
          begins_along(reversed(onward.path_from(poles_[i])), way, other))
        nearest = i;
    return nearest;
  }

  static Sampled_line beginning_of(const Sampled_line& line) {
    const double length = 2; // radii
    Sampled_line result(1, line.front());
    double walked = 0;
    for (std::size_t i = 1; i < line.size() && walked < length; ++i) {
      walked += distance(line[i - 1].point, line[i].point) / line[i].radius;
      result.push_back(line[i]);
    }
    return result;
  }

  // Whether a path, two radii from its beginning, is nearer to `one` than to `other`.
  static bool begins_along(const Sampled_line& path, const Sampled_line& one, const Sampled_line& other) {
    double walked = 0;
    std::size_t i = 1;
    for (; i + 1 < path.size() && walked < 2; ++i)
      walked += distance(path[i - 1].point, path[i].point) / path[i].radius;
    return distance_to(path[i].point, one) < distance_to(path[i].point, other);
  }

  static double distance_to(const Double_kernel::Point_3& p, const Sampled_line& line) {
    double nearest = (std::numeric_limits<double>::infinity)();
    for (const Line_point& q : line)
      nearest = (std::min)(nearest, distance(p, q.point));
    return nearest;
  }

  static Sampled_line reversed(Sampled_line line) {
    std::reverse(line.begin(), line.end());
    return line;
  }

  // A traced line begins at the centre of the inlet's cap, and ends at that of the outlet's (0: somewhere within).
  Sampled_line finished(Sampled_line line, std::size_t outlet) const {
    const double window = 1, step = 0.25; // radii
    if (is_cap(0))
      line.insert(line.begin(), Line_point{ends_[0].point, line.front().radius});
    if (outlet != 0 && is_cap(outlet))
      line.push_back(Line_point{ends_[outlet].point, line.back().radius});
    return resampled(smoothed(line, window, 2), step);
  }

  int threads_;
  Sampled_surface surface_;
  std::vector<Centerline_end> ends_;
  std::vector<std::size_t> centers_; // samples, or -1
  std::vector<Index> poles_;
  Diagram diagram_;
  std::unique_ptr<Voronoi_front> front_;
  std::vector<Sampled_line> lines_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_CENTERLINE_TRACER_H
