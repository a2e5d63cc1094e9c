// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_SEW_SEAMS_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_SEW_SEAMS_H

#include <CGAL/Tubular_meshing/Repair/internal/Soup_edges.h>
#include <CGAL/Tubular_meshing/Repair/internal/remove_fins.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

struct Sewn_seams {
  std::size_t edges = 0; ///< pairs of free edges that have become one
  double width = 0;      ///< the widest gap closed
  Coordinates place = {0, 0, 0};
};

/* Sews free edges that nearly coincide: points of two borders become one point where both ends of an edge find a
 * partner, first the nearest ones, then up to a fraction of the local edge length. Where one side has more points than
 * the other, they split its edges. Two borders that merely touch in a point stay apart. Where points have many edges near
 * them, these are no seams, but triangles that lie across each other without order: they are left. O(n log n). */
class Seam_sewer {
public:
  explicit Seam_sewer(Triangle_soup& soup)
      : soup_(soup) {}

  Sewn_seams sew() {
    bool has_order = true;
    for (double reach : {1e-3, 0.03, 0.2}) {
      // Seams need few rounds, one for each side of a triangle and some for its parts; triangles that lie across each
      // other without order would be split without end, and the further the reach the more.
      const int most_rounds = 8;
      std::size_t before = 0;
      for (int round = 0; find_free_edges() && find_near_pairs(reach) && round < most_rounds; ++round) {
        const std::size_t splits = has_order ? split_edges() : 0;
        if (splits == 0)
          break;
        has_order = round < 3 || splits <= before / 2 + 10;
        before = splits;
      }
      if (free_.empty())
        break;
      merge_points();
      if (!has_order)
        break;
    }
    if (sewn_.edges > 0) {
      drop_degenerate_and_duplicate(soup_.triangles);
      drop_unused_points(soup_.points, soup_.triangles);
    }
    return sewn_;
  }

private:
  struct Free_edge {
    std::size_t a, b, side;
    double length;
  };
  struct Near_pair {
    std::size_t point, edge;
    double tolerance; ///< how near

    bool operator<(const Near_pair& p) const { return point != p.point ? point < p.point : edge < p.edge; }
  };
  typedef CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t> Box;

  bool find_free_edges() {
    if (knows_free_edges_)
      return !free_.empty();
    knows_free_edges_ = true;
    free_.clear();
    length_.assign(soup_.points.size(), 0);
    number_of_points_ = 0;
    Soup_edges(soup_).for_each([&](const Soup_edges::Edge& e) {
      if (e.count() != 1)
        return;
      const double l = distance_between(soup_.points[e.a], soup_.points[e.b]);
      free_.push_back(Free_edge{e.a, e.b, e.first->side, l});
      for (std::size_t v : {e.a, e.b}) {
        number_of_points_ += length_[v] > 0 ? 0 : 1;
        length_[v] = length_[v] > 0 ? (std::min)(length_[v], l) : l;
      }
    });
    return !free_.empty();
  }

  // The pairs of a free point and a free edge, no ends of one triangle, that are nearer to each other than `reach` times
  // the shortest free edge around. False, and none, if there are too many for seams: at these a point has few.
  bool find_near_pairs(double reach) {
    near_.clear();
    const std::size_t most = 1000 + 10 * number_of_points_;
    const std::size_t most_asked = 100000 + 300 * number_of_points_; // in all rounds; seams ask ten or twenty in each
    std::vector<Box> points, edges;
    CGAL::Bbox_3 all;
    for (std::size_t v = 0; v < length_.size(); ++v) {
      if (!(length_[v] > 0))
        continue;
      const Coordinates& p = soup_.points[v];
      const double r = reach * length_[v];
      points.emplace_back(CGAL::Bbox_3(p[0] - r, p[1] - r, p[2] - r, p[0] + r, p[1] + r, p[2] + r), v);
      all += points.back().bbox();
    }
    const double distance = // of points, if they were spread evenly
        std::sqrt(square(all.x_span()) + square(all.y_span()) + square(all.z_span())) /
        std::cbrt(double(number_of_points_));
    for (std::size_t i = 0; i < free_.size(); ++i)
      add_boxes(i, distance, edges);
    struct Too_many {};
    try {
      CGAL::box_intersection_d(
          points.begin(), points.end(), edges.begin(), edges.end(), [&](const Box& p, const Box& e) {
            if (++asked_ > most_asked)
              throw Too_many();
            const Free_edge& edge = free_[e.info()];
            const double tolerance = reach * (std::min)(length_[p.info()], edge.length);
            if (!(project(p.info(), edge).second <= tolerance)) // most are not; so this comes first
              return;
            const Index_triangle& t = soup_.triangles[edge.side / 3];
            if (std::find(t.begin(), t.end(), p.info()) != t.end())
              return;
            near_.push_back(Near_pair{p.info(), e.info(), tolerance});
            if (near_.size() > most)
              throw Too_many();
          });
    } catch (const Too_many&) {
      near_.clear();
      return false;
    }
    std::sort(near_.begin(), near_.end()); // the boxes come in no certain order, and an edge may have several
    near_.erase(
        std::unique(near_.begin(), near_.end(),
                    [](const Near_pair& p, const Near_pair& q) { return p.point == q.point && p.edge == q.edge; }),
        near_.end());
    return true;
  }

  static double square(double x) { return x * x; }

  // The box of an edge, or of its pieces: that of one that is long against the distance of points would hold many.
  void add_boxes(std::size_t edge, double distance, std::vector<Box>& boxes) const {
    const Coordinates &p = soup_.points[free_[edge].a], &q = soup_.points[free_[edge].b];
    const double longest = 64;
    const int pieces = distance > 0 ? int((std::min)(longest, std::ceil(free_[edge].length / (2 * distance)))) : 1;
    for (int k = 0; k < pieces; ++k) {
      CGAL::Bbox_3 box;
      for (int end : {k, k + 1}) {
        const double t = double(end) / pieces;
        const double x = (1 - t) * p[0] + t * q[0], y = (1 - t) * p[1] + t * q[1], z = (1 - t) * p[2] + t * q[2];
        box += CGAL::Bbox_3(x, y, z, x, y, z);
      }
      boxes.emplace_back(box, edge);
    }
  }

  // The parameter of the point of edge e that is nearest to point v, in [0, 1], and its distance.
  std::pair<double, double> project(std::size_t v, const Free_edge& e) const {
    const Coordinates d = minus(soup_.points[e.b], soup_.points[e.a]);
    const Coordinates w = minus(soup_.points[v], soup_.points[e.a]);
    const double t = (std::max)(0., (std::min)(1., dot(w, d) / dot(d, d)));
    const Coordinates gap = {w[0] - t * d[0], w[1] - t * d[1], w[2] - t * d[2]};
    return {t, length(gap)};
  }

  // Splits the free edges that a point of another border lies on, if a neighbour of that point is near a border too.
  // Returns how many.
  std::size_t split_edges() {
    struct Candidate {
      double distance = 0, t = 0;
      std::size_t edge = 0;
      bool at_end = false;
    };
    std::map<std::size_t, Candidate> near;
    for (const auto& [v, i, tolerance] : near_) {
      const auto p = project(v, free_[i]);
      const Candidate c{p.second, p.first, i, (std::min)(p.first, 1 - p.first) * free_[i].length <= tolerance};
      const auto inserted = near.emplace(v, c);
      if (!inserted.second && std::make_pair(!c.at_end, c.distance) <
                                  std::make_pair(!inserted.first->second.at_end, inserted.first->second.distance))
        inserted.first->second = c;
    }
    std::map<std::size_t, bool> accompanied;
    for (const Free_edge& e : free_)
      if (near.count(e.a) && near.count(e.b))
        accompanied[e.a] = accompanied[e.b] = true;
    std::map<std::size_t, std::vector<std::pair<double, std::size_t>>> splits; // by triangle's side
    for (const auto& n : near)
      if (!n.second.at_end && accompanied.count(n.first)) {
        splits[n.second.edge].emplace_back(n.second.t, n.first);
        note_gap(n.second.distance, n.first);
      }
    std::map<std::size_t, std::size_t> split_triangles; // one edge of a triangle at a time
    for (auto& s : splits)
      if (split_triangles.emplace(free_[s.first].side / 3, s.first).second)
        split(free_[s.first], s.second);
    knows_free_edges_ = knows_free_edges_ && split_triangles.empty();
    return split_triangles.size();
  }

  void split(const Free_edge& e, std::vector<std::pair<double, std::size_t>>& points) {
    const std::size_t f = e.side / 3, k = e.side % 3;
    const Index_triangle t = soup_.triangles[f];
    const std::size_t from = t[k], to = t[(k + 1) % 3], apex = t[(k + 2) % 3];
    std::sort(points.begin(), points.end());
    if (from != e.a)
      std::reverse(points.begin(), points.end());
    soup_.triangles[f] = {from, points.front().second, apex};
    for (std::size_t i = 0; i < points.size(); ++i)
      soup_.triangles.push_back({points[i].second, i + 1 < points.size() ? points[i + 1].second : to, apex});
    sewn_.edges += points.size();
  }

  void merge_points() {
    // sets of points that are near each other
    Index_union near(soup_.points.size());
    for (const auto& [v, i, tolerance] : near_)
      for (std::size_t end : {free_[i].a, free_[i].b})
        if (distance_between(soup_.points[v], soup_.points[end]) <= tolerance)
          near.join(v, end);
    // of which only those ends are merged that belong to edges between the same two sets
    std::map<std::pair<std::size_t, std::size_t>, std::vector<std::pair<std::size_t, std::size_t>>> bundles;
    for (const Free_edge& e : free_) {
      std::pair<std::size_t, std::size_t> ends(e.a, e.b), sets(near.find(e.a), near.find(e.b));
      if (sets.first > sets.second) {
        std::swap(ends.first, ends.second);
        std::swap(sets.first, sets.second);
      }
      if (sets.first != sets.second)
        bundles[sets].push_back(ends);
    }
    Index_union merged(soup_.points.size());
    bool any = false;
    for (const auto& b : bundles)
      for (std::size_t i = 1; i < b.second.size(); ++i) {
        merged.join(b.second[0].first, b.second[i].first);
        merged.join(b.second[0].second, b.second[i].second);
        ++sewn_.edges;
        any = true;
      }
    if (any)
      move_together(merged);
  }

  void move_together(Index_union& merged) {
    std::map<std::size_t, std::vector<std::size_t>> sets;
    for (std::size_t v = 0; v < length_.size(); ++v)
      if (length_[v] > 0)
        sets[merged.find(v)].push_back(v);
    for (const auto& s : sets) {
      if (s.second.size() < 2)
        continue;
      Coordinates mean = {0, 0, 0};
      for (std::size_t v : s.second)
        for (int k = 0; k < 3; ++k)
          mean[k] += soup_.points[v][k] / double(s.second.size());
      for (std::size_t v : s.second)
        note_gap(distance_between(soup_.points[v], soup_.points[s.first]), v);
      soup_.points[s.first] = mean;
    }
    for (Index_triangle& t : soup_.triangles)
      for (std::size_t& v : t)
        v = merged.find(v);
    drop_degenerate_and_duplicate(soup_.triangles);
    knows_free_edges_ = false;
  }

  void note_gap(double width, std::size_t v) {
    if (width <= sewn_.width && sewn_.width > 0)
      return;
    sewn_.width = width;
    sewn_.place = soup_.points[v];
  }

  Triangle_soup& soup_;
  bool knows_free_edges_ = false; ///< of the triangles as they are
  std::vector<Free_edge> free_;
  std::vector<double> length_;       ///< by point, of the shortest free edge there; 0: the point is not free
  std::size_t number_of_points_ = 0; ///< that are free
  std::vector<Near_pair> near_;
  std::size_t asked_ = 0; ///< pairs whose distance has been asked for
  Sewn_seams sewn_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_SEW_SEAMS_H
