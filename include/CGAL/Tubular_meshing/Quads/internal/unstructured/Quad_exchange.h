// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_QUAD_EXCHANGE_H
#define CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_QUAD_EXCHANGE_H

#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Quad_patch.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Quad_smoother.h>
#include <CGAL/Tubular_meshing/Quads/internal/unstructured/Sheet.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Exchanges some quads of a patch for others with the same border, if that makes its vertices more regular: as many
 * quads at each as there should be, four inside. Vertices around are moved to their new best places; if quads are bad
 * even so, all is as it was. */
class Quad_exchange {
public:
  typedef Quad_patch::Quad Quad;

  Quad_exchange(Quad_patch& mesh, const Sheet& sheet)
      : mesh_(mesh)
      , smoother_(mesh, sheet) {}

  /* How much is wrong with a number of quads at a vertex. */
  int cost(int v, int valence) const {
    return mesh_.is_fixed(v)
               ? cost(valence, mesh_.loop_valences[std::size_t(v)], mesh_.loop_valences[std::size_t(v)], 3)
               : cost_inside(valence);
  }
  static int cost_inside(int valence) { return cost(valence, 4, 3, 2); }
  int cost(int v) const { return mesh_.valence(v) == 0 ? 0 : cost(v, mesh_.valence(v)); }

  /* The quads `removed`, by number, for `added`, whose new vertices are the last ones of the patch, from `first_new`.
   * False if nothing was done; then the new vertices are gone again. */
  bool apply(const std::vector<int>& removed, const std::vector<Quad>& added, std::size_t first_new, int sweeps) {
    const std::size_t quads_before = mesh_.quads.size();
    std::vector<int> concerned;
    double worst_before = 1, mean_before = 0;
    for (int q : removed) {
      concerned.insert(concerned.end(), mesh_.quad(q).begin(), mesh_.quad(q).end());
      const double quality = mesh_.quality(q);
      worst_before = (std::min)(worst_before, quality);
      mean_before += quality / double(removed.size());
    }
    sort_and_unite(concerned);
    const int cost_before = sum_of_costs(concerned);
    std::vector<Quad> old;
    for (int q : removed) {
      old.push_back(mesh_.quad(q));
      mesh_.remove_quad(q);
    }
    for (const Quad& q : added) {
      mesh_.add_quad(q);
      concerned.insert(concerned.end(), q.begin(), q.end());
    }
    sort_and_unite(concerned);
    std::vector<std::pair<int, Sheet_place>> places;
    if (sum_of_costs(concerned) < cost_before && fit(added)) {
      const std::vector<int> movable = vertices_around(concerned);
      for (int v : movable)
        places.emplace_back(v, mesh_.places[std::size_t(v)]);
      smoother_.relax(movable, sweeps);
      double mean = 0;
      for (std::size_t q = quads_before; q < mesh_.quads.size(); ++q)
        mean += mesh_.quality(int(q)) / double(added.size());
      const double worst = worst_at(movable, concerned);
      const bool repairs = worst_before < cared_for_quality && worst > worst_before + least_gain_of_worst;
      if (worst >= (std::min)(worst_before, cared_for_quality) && (repairs || mean > mean_before - most_loss_of_mean))
        return true;
    }
    for (const auto& p : places)
      mesh_.places[std::size_t(p.first)] = p.second;
    for (std::size_t q = quads_before; q < mesh_.quads.size(); ++q)
      mesh_.remove_quad(int(q));
    mesh_.shrink(quads_before, first_new);
    for (std::size_t i = 0; i < removed.size(); ++i)
      mesh_.restore_quad(removed[i], old[i]);
    return false;
  }

private:
  static constexpr double most_loss_of_mean = 0.01;
  static constexpr double least_gain_of_worst = 0.1; // that makes up for any loss of the mean
  static constexpr double cared_for_quality = 0.5;   // of the worst quad: above it may fall

  static int cost(int valence, int wanted, int least, int factor) {
    const int none = 40, d = valence - wanted;
    return valence < least ? none : factor * (d * d + (d > 1 ? 1 : 0));
  }

  static void sort_and_unite(std::vector<int>& v) {
    std::sort(v.begin(), v.end());
    v.erase(std::unique(v.begin(), v.end()), v.end());
  }

  int sum_of_costs(const std::vector<int>& vertices) const {
    int sum = 0;
    for (int v : vertices)
      sum += cost(v);
    return sum;
  }

  // Whether edges have one quad on each side, and no two quads share two edges' worth of corners.
  bool fit(const std::vector<Quad>& added) const {
    for (const Quad& q : added)
      for (std::size_t k = 0; k < 4; ++k) {
        const int u = q[k], v = q[(k + 1) % 4];
        int there = 0, back = 0;
        for (int other : mesh_.quads_at(u)) {
          there += mesh_.after(other, u) == v;
          back += mesh_.before(other, u) == v;
        }
        if (u == v || u == q[(k + 2) % 4] || there != 1 || back > 1 ||
            (back == 0 && !(mesh_.is_fixed(u) && mesh_.is_fixed(v))))
          return false;
      }
    return true;
  }

  // The given ones that may move, and their neighbours.
  std::vector<int> vertices_around(const std::vector<int>& vertices) const {
    std::vector<int> result;
    for (int v : vertices)
      for (int q : mesh_.quads_at(v))
        for (int w : mesh_.quad(q))
          if (!mesh_.is_fixed(w))
            result.push_back(w);
    sort_and_unite(result);
    return result;
  }

  double worst_at(const std::vector<int>& moved, const std::vector<int>& concerned) const {
    double worst = 1;
    for (int v : moved)
      worst = (std::min)(worst, smoother_.worst_at(v));
    for (int v : concerned)
      worst = (std::min)(worst, smoother_.worst_at(v));
    return worst;
  }

  Quad_patch& mesh_;
  Quad_smoother smoother_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_QUAD_EXCHANGE_H
