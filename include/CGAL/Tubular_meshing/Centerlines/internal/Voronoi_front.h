// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_VORONOI_FRONT_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_VORONOI_FRONT_H

#include <CGAL/Tubular_meshing/Centerlines/internal/Interior_voronoi_diagram.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Sampled_line.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The time at which a front that starts at one vertex and moves with speed R, the radius of the inscribed sphere,
 * arrives at the vertices of the Voronoi diagram: the smallest integral of 1/R along a path (L. Antiga, B. Ene-Iordache
 * and A. Remuzzi, Computational geometry for patient-specific reconstruction and meshing of blood vessels from MR and
 * CT angiography, 2003).
 *
 * Fast marching over the faces: a vertex is reached across a face from the segment between two other of its vertices,
 * at the point of the segment from which it is reached first; so paths cross faces in any direction, and do not run
 * along their edges. O(n log n) for n vertices. */
class Voronoi_front {
public:
  typedef Interior_voronoi_diagram Diagram;
  typedef Diagram::Index Index;
  typedef Diagram::Point Point;
  typedef Diagram::Vector Vector;
  static constexpr Index none = Diagram::none;

  /* Lets the front run until it has reached all targets, or everything if there are none. */
  Voronoi_front(const Diagram& diagram, Index source, const std::vector<Index>& targets)
      : diagram_(diagram)
      , of_face_(diagram.number_of_faces()) {
    for (Index f = 0; f < of_face_.size(); ++f)
      of_face_[f] = Face_state{diagram.face_begin[f + 1] - diagram.face_begin[f], none};
    at_.reserve(diagram.points.size());
    for (std::size_t v = 0; v < diagram.points.size(); ++v)
      at_.push_back(State{diagram.points[v], diagram.radii[v], (std::numeric_limits<double>::infinity)(), none, none});
    std::vector<bool> wanted(diagram.points.size(), false);
    std::size_t missing = 0;
    for (Index t : targets)
      if (t != none && !wanted[t]) {
        wanted[t] = true;
        ++missing;
      }
    Index reached = 0;
    lower(source, 0, none);
    while (!queue_.empty()) {
      const Index v = queue_.top().second;
      queue_.pop();
      if (at_[v].rank != none)
        continue;
      at_[v].rank = reached++;
      if (wanted[v] && --missing == 0)
        break;
      spread_from(v);
    }
    std::vector<Face_state>().swap(of_face_);
  }

  bool has_reached(Index v) const { return at_[v].rank != none; }
  double time(Index v) const { return at_[v].time; }
  Index rank(Index v) const { return at_[v].rank; }
  // A vertex of the same face from which, or from an edge of which, the front came; `none` at the source.
  Index parent(Index v) const { return at_[v].parent; }

  /* The path of steepest descent from a vertex to the source. It always gets there: among vertices that all but
   * coincide, as on surfaces with symmetries, small steps may go round in circles. When they have reached no vertex
   * earlier than those before for a while, it goes on from vertex to vertex, each earlier than the last. */
  Sampled_line path_from(Index target) const {
    const int most_steps = 64; // for nothing
    Sampled_line path;
    Place place = at_vertex(target);
    path.push_back(Line_point{place.point, place.radius});
    Index earliest = at_[target].rank;
    for (int steps = 0; place.a != place.b || at_[place.a].rank != 0;) {
      place = steps < most_steps ? snapped(place, step_down(place)) : at_vertex(earliest_beside(place));
      path.push_back(Line_point{place.point, place.radius});
      const Index now = (std::min)(at_[place.a].rank, at_[place.b].rank);
      steps = now < earliest ? 0 : steps + 1;
      earliest = (std::min)(earliest, now);
    }
    return path;
  }

private:
  // All that is asked of a vertex, in one place in memory: the front is at work everywhere in a large tree by turns.
  struct State {
    Point point;
    double radius, time;
    Index rank, parent; // the rank in the order of arrival
  };

  struct Face_state {
    Index missing; // vertices that have not been reached
    Index first;   // that was reached
  };

  // A point at a vertex (a == b) or on an edge of the diagram.
  struct Place {
    Index a, b;
    Point point;
    double radius, time;
  };

  const Point& point(Index v) const { return at_[v].point; }
  double radius(Index v) const { return at_[v].radius; }

  /* Where the segment ab is to be left for c, as a fraction of it: the minimum over x of T(x) + |x - c| / R, T being
   * linear on ab, and R that at c. */
  double best_departure(Index a, Index b, const Point& c, double radius_at_c) const {
    const Vector e = point(b) - point(a), d = c - point(a);
    const double length2 = e.squared_length();
    if (!(length2 > 0))
      return 0;
    const double length = std::sqrt(length2), along = (d * e) / length;
    const double across = std::sqrt((std::max)(0., d.squared_length() - along * along));
    const double k = (at_[b].time - at_[a].time) * radius_at_c / length;
    if (k >= 1)
      return 0;
    if (k <= -1)
      return 1;
    const double s = (along - k * across / std::sqrt(1 - k * k)) / length;
    return (std::min)(1., (std::max)(0., s));
  }

  Place on_edge(Index a, Index b, double t) const {
    if (t <= 0 || t >= 1)
      return at_vertex(t <= 0 ? a : b);
    return Place{a, b, point(a) + t * (point(b) - point(a)), (1 - t) * radius(a) + t * radius(b),
                 (1 - t) * at_[a].time + t * at_[b].time};
  }

  Place at_vertex(Index v) const { return Place{v, v, point(v), radius(v), at_[v].time}; }

  static double time_from(const Place& x, const Point& c, double radius_at_c) {
    return x.time + distance(x.point, c) / radius_at_c;
  }

  void lower(Index v, double time, Index parent) {
    if (time < at_[v].time) {
      at_[v].time = time;
      at_[v].parent = parent;
      queue_.emplace(time, v);
    }
  }

  // A segment from the vertex that was reached last to one that was before, from which the front comes across a face.
  struct Way_in {
    Index end;
    double length, rise; // of the time along it
    Vector direction;
  };

  Way_in way_in(Index v, Index u) const {
    const Vector e = point(u) - point(v);
    const double length = std::sqrt(e.squared_length());
    return Way_in{u, length, at_[u].time - at_[v].time, length > 0 ? e / length : e};
  }

  /* When a place is reached from the segment, other than from its beginning v; see best_departure(). `d` leads from v to
   * the place, and is as long as `far`. Infinite also where that could not be before `known`. */
  double time_across(Index v, const Way_in& way, const Vector& d, double far, double radius_at_place,
                     double known) const {
    const double never = (std::numeric_limits<double>::infinity)();
    if (!(way.length > 0) || at_[way.end].time + (far - way.length) / radius_at_place >= known)
      return never;
    const double k = way.rise * radius_at_place / way.length;
    if (k >= 1)
      return never;
    double s = 1, from_there = 0;
    if (k > -1) {
      const double along = d * way.direction, across2 = (std::max)(0., far * far - along * along);
      from_there = std::sqrt(across2 / (1 - k * k));
      s = (along - k * from_there) / way.length;
    }
    if (!(s > 0))
      return never;
    return s < 1 ? at_[v].time + s * way.rise + from_there / radius_at_place
                 : at_[way.end].time + std::sqrt((d - way.length * way.direction).squared_length()) / radius_at_place;
  }

  void spread_from(Index v) {
    for (Index f : diagram_.faces_of[v]) {
      if (f == none)
        break;
      Face_state& face = of_face_[f];
      if (face.first == none)
        face.first = v;
      if (--face.missing == 0)
        continue;
      const Index* const begin = &diagram_.face_vertices[diagram_.face_begin[f]];
      const Index* const end = &diagram_.face_vertices[0] + diagram_.face_begin[f + 1];
      const Index* const here = std::find(begin, end, v);
      const Index before = here == begin ? end[-1] : here[-1], after = here + 1 == end ? *begin : here[1];
      std::array<Way_in, 3> ways;
      std::size_t n = 0;
      for (Index u : {before, after, face.first})
        if (u != v && has_reached(u) &&
            std::none_of(ways.begin(), ways.begin() + std::ptrdiff_t(n),
                         [&](const Way_in& way) { return way.end == u; }))
          ways[n++] = way_in(v, u);
      for (const Index* w = begin; w != end; ++w)
        if (!has_reached(*w)) {
          const Vector d = point(*w) - point(v);
          const double far = std::sqrt(d.squared_length());
          double time = (std::min)(at_[*w].time, at_[v].time + far / radius(*w));
          for (std::size_t i = 0; i < n; ++i)
            time = (std::min)(time, time_across(v, ways[i], d, far, radius(*w), time));
          lower(*w, time, v);
        }
    }
  }

  bool is_on(Index v, Index face) const {
    const auto& faces = diagram_.faces_of[v];
    return std::find(faces.begin(), faces.end(), face) != faces.end();
  }

  Place step_down(const Place& x) const {
    Place best = x;
    double best_time = (std::numeric_limits<double>::infinity)();
    for (Index f : diagram_.faces_of[x.a])
      if (f != none && is_on(x.b, f))
        look_across(f, x, best, best_time);
    if (best.time < x.time)
      return best;
    return at_vertex(earliest_beside(x)); // where vertices coincide: along the order in which they were reached
  }

  // Of an edge, the end that was reached first; of a vertex, that vertex of its faces: another one but at the source.
  Index earliest_beside(const Place& x) const {
    Index earliest = at_[x.a].rank < at_[x.b].rank ? x.a : x.b;
    if (x.a == x.b)
      for (Index f : diagram_.faces_of[x.a])
        for (Index i = f == none ? 0 : diagram_.face_begin[f]; f != none && i < diagram_.face_begin[f + 1]; ++i)
          if (at_[diagram_.face_vertices[i]].rank < at_[earliest].rank)
            earliest = diagram_.face_vertices[i];
    return earliest;
  }

  /* A step, lengthened to the next vertex if it is a small one. Regular surfaces have many samples on common spheres,
   * and round these spheres' centres, clusters of vertices through which there are thousands of small steps. */
  Place snapped(const Place& from, const Place& to) const {
    const double small = 0.01, near = 0.05; // radii
    if (to.a == to.b || distance(from.point, to.point) > small * to.radius)
      return to;
    const Index earlier = at_[to.a].rank < at_[to.b].rank ? to.a : to.b;
    return distance(point(earlier), to.point) < near * to.radius ? at_vertex(earlier) : to;
  }

  // The point of the face's outline from which x was reached first.
  void look_across(Index f, const Place& x, Place& best, double& best_time) const {
    const Index begin = diagram_.face_begin[f], end = diagram_.face_begin[f + 1];
    for (Index i = begin; i < end; ++i) {
      const Index u = diagram_.face_vertices[i], w = diagram_.face_vertices[i + 1 < end ? i + 1 : begin];
      if (!has_reached(u) || !has_reached(w) || holds(x, u, w))
        continue;
      const Place y = on_edge(u, w, best_departure(u, w, x.point, x.radius));
      const double t = time_from(y, x.point, x.radius);
      if (y.time < x.time && t < best_time) {
        best_time = t;
        best = y;
      }
    }
  }

  static bool holds(const Place& x, Index u, Index w) {
    return x.a == x.b ? x.a == u || x.a == w : (x.a == u && x.b == w) || (x.a == w && x.b == u);
  }

  const Diagram& diagram_;
  std::vector<State> at_;
  std::vector<Face_state> of_face_; // while the front runs
  typedef std::pair<double, Index> Event;
  std::priority_queue<Event, std::vector<Event>, std::greater<Event>> queue_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_VORONOI_FRONT_H
