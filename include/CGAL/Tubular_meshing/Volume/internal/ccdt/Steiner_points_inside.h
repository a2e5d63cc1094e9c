// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_CCDT_STEINER_POINTS_INSIDE_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_CCDT_STEINER_POINTS_INSIDE_H

#include <CGAL/Tubular_meshing/base/element_measures.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Takes the points that a conforming triangulation has put on its boundary off it again: each goes a little way inside,
 * and between it and the boundary come tetrahedra on the facets that are there without it.
 *
 * Around such a point the boundary's facets lie in one triangle of the surface, or in the two at an edge of it; in each
 * of them those facets form a polygon, which is triangulated again. */
class Steiner_points_inside {
public:
  typedef std::uint32_t Index;
  typedef std::array<Index, 4> Tetrahedron;
  struct Facet {
    std::array<Index, 3> v; // counterclockwise from outside
    Index face;             // of the surface, that it is a part of
  };

  std::vector<Vector_3d> points; // the surface's own, then the Steiner points
  std::vector<Tetrahedron> tetrahedra;
  std::vector<Facet> facets;

  // Whether all points from `first` on have come inside; the facets are those of the surface then.
  bool run(Index first) {
    first_ = first;
    tetrahedra_at_.assign(points.size() - first, std::vector<std::size_t>());
    facets_at_.assign(points.size() - first, std::vector<std::size_t>());
    for (std::size_t t = 0; t < tetrahedra.size(); ++t)
      register_at(tetrahedra[t], t, tetrahedra_at_);
    for (std::size_t f = 0; f < facets.size(); ++f)
      register_at(facets[f].v, f, facets_at_);
    // where one stands in another's way, it is tried again when that has gone
    std::vector<Index> remaining;
    for (Index v = first; v < points.size(); ++v)
      if (!facets_at_[v - first].empty())
        remaining.push_back(v);
    while (!remaining.empty()) {
      const std::size_t before = remaining.size();
      remaining.erase(std::remove_if(remaining.begin(), remaining.end(), [&](Index v) { return bring_inside(v); }),
                      remaining.end());
      if (remaining.size() == before)
        return false;
    }
    facets.erase(std::remove_if(facets.begin(), facets.end(), [](const Facet& f) { return is_gone(f); }), facets.end());
    return true;
  }

private:
  static bool is_gone(const Facet& f) { return f.v[0] == f.v[1]; }

  template <class Vertices>
  void register_at(const Vertices& v, std::size_t i, std::vector<std::vector<std::size_t>>& lists) const {
    for (Index u : v)
      if (u >= first_)
        lists[u - first_].push_back(i);
  }

  // The facets that replace those around v; false if a polygon cannot be triangulated without v.
  bool triangulate_around(Index v, std::vector<Facet>& come) const {
    std::map<Index, std::map<Index, Index>> next; // by face: along the polygon around v
    for (std::size_t f : facets_at_[v - first_]) {
      const auto& w = facets[f].v;
      const int i = w[0] == v ? 0 : w[1] == v ? 1 : 2;
      next[facets[f].face][w[(i + 1) % 3]] = w[(i + 2) % 3];
    }
    for (const auto& face : next) {
      // a path begins where nothing leads to; a closed polygon anywhere
      Index start = face.second.begin()->first;
      for (const auto& step : face.second)
        if (std::none_of(face.second.begin(), face.second.end(), [&](const auto& s) { return s.second == step.first; }))
          start = step.first;
      std::vector<Index> polygon(1, start);
      for (auto s = face.second.find(start); s != face.second.end() && s->second != start;
           s = face.second.find(s->second))
        polygon.push_back(s->second);
      if (!triangulate(polygon, v, face.first, come))
        return false;
    }
    return true;
  }

  // As the fan from one of its vertices whose worst triangle is best; seen from there, all must turn alike.
  bool triangulate(const std::vector<Index>& polygon, Index v, Index face, std::vector<Facet>& come) const {
    const std::size_t n = polygon.size();
    Vector_3d normal;
    for (std::size_t k = 0; k < n; ++k)
      normal += cross(points[polygon[k]] - points[v], points[polygon[(k + 1) % n]] - points[v]);
    double best = 0;
    std::vector<Facet> fan, best_fan;
    for (std::size_t k = 0; k < n; ++k) {
      fan.clear();
      double worst = 1;
      for (std::size_t j = 1; j + 1 < n; ++j) {
        const std::array<Index, 3> w = {polygon[k], polygon[(k + j) % n], polygon[(k + j + 1) % n]};
        const Vector_3d &a = points[w[0]], &b = points[w[1]], &c = points[w[2]];
        const bool turned = dot(cross(b - a, c - a), normal) <= 0;
        worst = (std::min)(worst, turned ? -1 : triangle_gamma(a, b, c));
        fan.push_back({w, face});
      }
      if (worst > best) {
        best = worst;
        best_fan = fan;
      }
    }
    come.insert(come.end(), best_fan.begin(), best_fan.end());
    return best > 0;
  }

  bool bring_inside(Index v) {
    std::vector<Facet> come;
    if (!triangulate_around(v, come))
      return false;
    Vector_3d inward;
    double reach = 0;
    for (const Facet& f : come) {
      const Vector_3d &a = points[f.v[0]], &b = points[f.v[1]], &c = points[f.v[2]];
      inward += -1. * normalized(cross(b - a, c - a));
      reach = (std::max)(reach, norm(a - points[v]));
    }
    if (!find_place(v, come, reach * normalized(inward)))
      return false;
    for (std::size_t f : facets_at_[v - first_])
      facets[f].v = {0, 0, 0};
    for (const Facet& f : come) {
      register_at(f.v, facets.size(), facets_at_);
      facets.push_back(f);
      const Tetrahedron t = {v, f.v[0], f.v[1], f.v[2]};
      register_at(t, tetrahedra.size(), tetrahedra_at_);
      tetrahedra.push_back(t);
    }
    forget_gone_facets();
    return true;
  }

  void forget_gone_facets() {
    for (auto& list : facets_at_)
      list.erase(std::remove_if(list.begin(), list.end(), [&](std::size_t f) { return is_gone(facets[f]); }),
                 list.end());
  }

  // Along a ray, where the worst tetrahedron around v is best; false if there is no place.
  bool find_place(Index v, const std::vector<Facet>& come, const Vector_3d& ray) {
    const Vector_3d old = points[v];
    Vector_3d place = old;
    double best = 0;
    for (double s = 1; s > 1e-4; s *= 0.7) {
      points[v] = old + s * ray;
      double worst = 1;
      for (std::size_t t : tetrahedra_at_[v - first_])
        worst = (std::min)(worst, quality(tetrahedra[t]));
      for (const Facet& f : come)
        worst = (std::min)(worst, quality({v, f.v[0], f.v[1], f.v[2]}));
      if (worst > best) {
        best = worst;
        place = points[v];
      }
    }
    points[v] = place;
    return best > 0;
  }

  double quality(const Tetrahedron& t) const {
    return tetrahedron_gamma(points[t[0]], points[t[1]], points[t[2]], points[t[3]]);
  }

  Index first_ = 0;
  std::vector<std::vector<std::size_t>> tetrahedra_at_, facets_at_; // by Steiner point
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_CCDT_STEINER_POINTS_INSIDE_H
