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
 * the other, they split its edges. Two borders that merely touch in a point stay apart. O(n log n). */
class Seam_sewer {
public:
  explicit Seam_sewer(Triangle_soup& soup)
      : soup_(soup) {}

  Sewn_seams sew() {
    for (double reach : {1e-3, 0.03, 0.2}) {
      // Seams need few rounds; triangles that lie across each other without order would be split without end.
      const int most_rounds = 8;
      for (int round = 0; find_free_edges() && round < most_rounds && split_edges(reach); ++round)
        ;
      if (free_.empty())
        break;
      merge_points(reach);
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
  typedef CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t> Box;

  bool find_free_edges() {
    free_.clear();
    length_.clear();
    Soup_edges(soup_).for_each([&](const Soup_edges::Edge& e) {
      if (e.count() != 1)
        return;
      const double l = distance_between(soup_.points[e.a], soup_.points[e.b]);
      free_.push_back(Free_edge{e.a, e.b, e.first->side, l});
      for (std::size_t v : {e.a, e.b}) {
        auto& shortest = length_.emplace(v, l).first->second;
        shortest = (std::min)(shortest, l);
      }
    });
    return !free_.empty();
  }

  // Calls found(v, e) for each pair of a free point and a free edge, no ends of one triangle, that are nearer to each
  // other than `reach` times the shortest free edge around.
  template <class Found> void for_each_near_pair(double reach, const Found& found) const {
    std::vector<Box> points, edges;
    for (const auto& v : length_) {
      const Coordinates& p = soup_.points[v.first];
      const double r = reach * v.second;
      points.emplace_back(CGAL::Bbox_3(p[0] - r, p[1] - r, p[2] - r, p[0] + r, p[1] + r, p[2] + r), v.first);
    }
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const Coordinates &p = soup_.points[free_[i].a], &q = soup_.points[free_[i].b];
      edges.emplace_back(
          CGAL::Bbox_3(p[0], p[1], p[2], p[0], p[1], p[2]) + CGAL::Bbox_3(q[0], q[1], q[2], q[0], q[1], q[2]), i);
    }
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    const auto tolerance = [&](std::size_t v, std::size_t i) {
      return reach * (std::min)(length_.at(v), free_[i].length);
    };
    CGAL::box_intersection_d(points.begin(), points.end(), edges.begin(), edges.end(), [&](const Box& p, const Box& e) {
      const Index_triangle& t = soup_.triangles[free_[e.info()].side / 3];
      if (std::find(t.begin(), t.end(), p.info()) == t.end() &&
          project(p.info(), free_[e.info()]).second <= tolerance(p.info(), e.info())) // boxes of long edges hold many
        pairs.emplace_back(p.info(), e.info());
    });
    std::sort(pairs.begin(), pairs.end()); // the boxes come in no certain order
    for (const auto& pair : pairs)
      found(pair.first, pair.second, tolerance(pair.first, pair.second));
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
  bool split_edges(double reach) {
    struct Candidate {
      double distance = 0, t = 0;
      std::size_t edge = 0;
      bool at_end = false;
    };
    std::map<std::size_t, Candidate> near;
    for_each_near_pair(reach, [&](std::size_t v, std::size_t i, double tolerance) {
      const auto p = project(v, free_[i]);
      if (!(p.second <= tolerance))
        return;
      const Candidate c{p.second, p.first, i, (std::min)(p.first, 1 - p.first) * free_[i].length <= tolerance};
      const auto inserted = near.emplace(v, c);
      if (!inserted.second && std::make_pair(!c.at_end, c.distance) <
                                  std::make_pair(!inserted.first->second.at_end, inserted.first->second.distance))
        inserted.first->second = c;
    });
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
    bool any = false;
    for (auto& s : splits)
      if (split_triangles.emplace(free_[s.first].side / 3, s.first).second) {
        split(free_[s.first], s.second);
        any = true;
      }
    return any;
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

  void merge_points(double reach) {
    // sets of points that are near each other
    Index_union near(soup_.points.size());
    for_each_near_pair(reach, [&](std::size_t v, std::size_t i, double tolerance) {
      for (std::size_t end : {free_[i].a, free_[i].b})
        if (distance_between(soup_.points[v], soup_.points[end]) <= tolerance)
          near.join(v, end);
    });
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
    for (const auto& v : length_)
      sets[merged.find(v.first)].push_back(v.first);
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
  }

  void note_gap(double width, std::size_t v) {
    if (width <= sewn_.width && sewn_.width > 0)
      return;
    sewn_.width = width;
    sewn_.place = soup_.points[v];
  }

  Triangle_soup& soup_;
  std::vector<Free_edge> free_;
  std::map<std::size_t, double> length_; ///< of the shortest free edge at each free point
  Sewn_seams sewn_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_SEW_SEAMS_H
