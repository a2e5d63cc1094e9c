// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_METRIC_REMESHER_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_METRIC_REMESHER_H

#include <CGAL/Tubular_meshing/Volume/internal/Surface_flip_guard.h>
#include <CGAL/Tubular_meshing/Volume/internal/Topology_optimizer.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Edge_collapser.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Edge_splitter.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Metric_mesh.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Metric_relocation.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>
#ifdef REMESH_DEBUG
#include <chrono>
#include <cstdio>
#endif

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* Flips that change a surface's edge are refused where the boundary is to stay. */
struct Remeshing_flip_guard {
  Surface_flip_guard<Patch_projection> shape;
  bool keep_boundary;

  bool operator()(Tetrahedron_store::Index a, Tetrahedron_store::Index b, Tetrahedron_store::Index c,
                  Tetrahedron_store::Index d, std::int32_t patch) const {
    return !keep_boundary && shape(a, b, c, d, patch);
  }
};

/* The passes of the remesher, and their order. */
template <class Field> class Metric_remesher {
public:
  typedef Tetrahedron_store Store;
  typedef Store::Index Index;
  typedef Metric_mesh<Field> Mesh;
  struct Measure {
    const Mesh* mesh;
    double tetrahedron(Index a, Index b, Index c, Index d) const { return mesh->tetrahedron(a, b, c, d); }
    double triangle(Index a, Index b, Index c) const { return mesh->triangle(a, b, c); }
  };
  typedef Topology_optimizer<Remeshing_flip_guard, Measure> Flips;

  explicit Metric_remesher(Mesh& mesh)
      : mesh_(mesh)
      , store_(mesh.store)
      , flips_(store_, Remeshing_flip_guard{{store_, mesh.projection}, mesh.keep_boundary}, Measure{&mesh},
               mesh.threads)
      , splitter_(mesh, flips_)
      , collapser_(mesh, flips_) {}

  void run() {
    adapt_sizes();
    for (int pass = 0; pass < 6; ++pass) {
      relocate(2);
      flips_.improve_below(0.75);
      const std::size_t n = split_all() + collapse_all();
      log("opt", n);
      log("balance", balance());
    }
    for (int pass = 0; pass < 3; ++pass) {
      relocate(2);
      flips_.improve_below(0.8);
      log("final", 0);
    }
  }

private:
  struct Candidate {
    float length;
    Index t, a, b;
  };

  void adapt_sizes() {
    const int stages = getenv("ST") ? atoi(getenv("ST")) : 0;
    for (int round = -stages; round < 4; ++round) {
      scale_ = round < 0 ? std::pow(2., -round) : 1;
      if (round < 0 && candidates(all_tetrahedra(), 0, scale_ * 1.4142).empty())
        continue;
      log("scale", scale_);
      const std::size_t s = split_all();
      log("split", s);
      const std::size_t c = collapse_all();
      log("collapse", c);
      const std::size_t f = flips_.improve_below(0.5);
      log("flip", f);
      mesh_.renumber();
      flips_.update_all(mesh_.threads);
      relocate(1);
      log("move", 0);
    }
  }

  void relocate(int sweeps) {
    Metric_relocation<Mesh> relocation(mesh_, scale_);
    for (int i = 0; i < sweeps; ++i)
      relocation.sweep();
    flips_.update_all(mesh_.threads);
  }

  std::vector<Index> all_tetrahedra() const {
    std::vector<Index> all;
    for (Index t = 0; t < store_.number_of_slots(); ++t)
      if (store_.is_alive(t))
        all.push_back(t);
    return all;
  }

  // The edges of the tetrahedra listed whose length is outside [low, high], each once, by falling length.
  std::vector<Candidate> candidates(const std::vector<Index>& tetrahedra, double low, double high) const {
    std::vector<Candidate> found;
    for (Index t : tetrahedra) {
      if (!store_.is_alive(t))
        continue;
      const auto& v = store_[t].v;
      for (int i = 0; i < 4; ++i)
        for (int j = i + 1; j < 4; ++j) {
          const double l = mesh_.length(v[i], v[j]);
          if (l < low || l > high)
            found.push_back({float(l), t, (std::min)(v[i], v[j]), (std::max)(v[i], v[j])});
        }
    }
    const auto by_edge = [](const Candidate& x, const Candidate& y) {
      return std::make_pair(x.a, x.b) < std::make_pair(y.a, y.b);
    };
    std::sort(found.begin(), found.end(), by_edge);
    found.erase(std::unique(found.begin(), found.end(),
                            [](const Candidate& x, const Candidate& y) { return x.a == y.a && x.b == y.b; }),
                found.end());
    std::stable_sort(found.begin(), found.end(),
                     [](const Candidate& x, const Candidate& y) { return x.length > y.length; });
    return found;
  }

  // The corners of an edge in the tetrahedron where it was found; false if it is no longer there.
  bool locate(const Candidate& c, int& i, int& j) const {
    if (!store_.is_alive(c.t))
      return false;
    i = store_.corner(c.t, c.a);
    j = store_.corner(c.t, c.b);
    return store_[c.t].v[i] == c.a && store_[c.t].v[j] == c.b;
  }

  std::size_t split_all() {
    const Operation_bounds bounds = {0.2, FAC, 0.65 * scale_, 1e300};
    std::size_t n = 0;
    double longest = 1e300;
    std::vector<Index> todo = all_tetrahedra(), next;
    for (int i, j; !todo.empty();) {
      const std::vector<Candidate> edges = candidates(todo, 0, 1.4142 * scale_);
      next.clear();
      if (edges.empty())
        break;
      longest = (std::min)(longest, double(edges.front().length));
      for (const Candidate& c : edges) {
        if (c.length < 0.6 * longest)
          next.push_back(c.t);
        else if (locate(c, i, j) && splitter_.split(c.t, i, j, bounds)) {
          next.insert(next.end(), splitter_.new_tetrahedra().begin(), splitter_.new_tetrahedra().end());
          ++n;
        }
      }
      longest *= 0.6;
      flips_.improve_these(next, 0.4);
      todo.swap(next);
    }
    return n;
  }

  std::size_t collapse_all() {
    const Operation_bounds bounds = {0.2, FAC, 0, 1.4142 * scale_};
    std::vector<Index> todo = all_tetrahedra();
    std::size_t n = 0;
    for (int i, j; !todo.empty();) {
      std::vector<Candidate> edges = candidates(todo, 0.7071 * scale_, 1e300);
      std::reverse(edges.begin(), edges.end());
      todo.clear();
      for (const Candidate& c : edges)
        if (locate(c, i, j) && collapser_.collapse(c.t, i, j, bounds)) {
          todo.insert(todo.end(), collapser_.new_tetrahedra().begin(), collapser_.new_tetrahedra().end());
          ++n;
        }
    }
    return n;
  }

  /* The volume that a tetrahedron has in the metric, over that of the regular one: averaged around each vertex and once
   * more over its neighbors, so that it tells whether vertices are too many or too few there. */
  std::vector<float> volumes_around_vertices() const {
    std::vector<float> mean(store_.number_of_vertices(), 1.f), number(store_.number_of_vertices());
    std::vector<float> of_tetrahedron(store_.number_of_slots());
    for (Index t = 0; t < store_.number_of_slots(); ++t)
      if (store_.is_alive(t))
        of_tetrahedron[t] = float(mesh_.shape(store_[t].v).volume);
    for (int round = 0; round < 2; ++round) {
      std::fill(mean.begin(), mean.end(), 0.f);
      std::fill(number.begin(), number.end(), 0.f);
      for (Index t = 0; t < store_.number_of_slots(); ++t)
        if (store_.is_alive(t))
          for (Index v : store_[t].v) {
            mean[v] += of_tetrahedron[t];
            number[v] += 1;
          }
      for (std::size_t v = 0; v < mean.size(); ++v)
        mean[v] /= (std::max)(number[v], 1.f);
      for (Index t = 0; t < store_.number_of_slots(); ++t)
        if (store_.is_alive(t)) {
          const auto& v = store_[t].v;
          of_tetrahedron[t] = (mean[v[0]] + mean[v[1]] + mean[v[2]] + mean[v[3]]) / 4;
        }
    }
    return mean;
  }

  std::size_t balance() {
    const std::vector<float> volume = volumes_around_vertices();
    std::vector<char> locked(volume.size(), 0);
    const auto lock = [&](const Store::Index_list& tetrahedra) {
      for (Index t : tetrahedra)
        for (Index v : store_[t].v)
          if (v < locked.size())
            locked[v] = 1;
    };
    const double dense = getenv("DENSE") ? atof(getenv("DENSE")) : 0.86, sparse = getenv("SPARSE") ? atof(getenv("SPARSE")) : 1.04;
    std::size_t n = 0;
    const Operation_bounds collapse_bounds = {0.15, 0.5, 0, 1.75};
    std::vector<Candidate> edges = candidates(all_tetrahedra(), 1, 1e300);
    std::reverse(edges.begin(), edges.end());
    int i, j;
    for (const Candidate& c : edges)
      if (volume[c.a] < dense && volume[c.b] < dense && !locked[c.a] && !locked[c.b] && locate(c, i, j) &&
          collapser_.collapse(c.t, i, j, collapse_bounds)) {
        lock(collapser_.new_tetrahedra());
        ++n;
      }
    const Operation_bounds split_bounds = {0.25, 0.8, 0.6, 1e300};
    for (const Candidate& c : candidates(all_tetrahedra(), 0, 1.2))
      if (c.a < locked.size() && c.b < locked.size() && volume[c.a] > sparse && volume[c.b] > sparse &&
          !locked[c.a] && !locked[c.b] && locate(c, i, j) && splitter_.split(c.t, i, j, split_bounds)) {
        lock(splitter_.new_tetrahedra());
        ++n;
      }
    return n;
  }

#ifdef REMESH_DEBUG
  void log(const char* what, std::size_t n) {
    static auto start = std::chrono::steady_clock::now();
    const auto now = std::chrono::steady_clock::now();
    std::size_t alive = 0, good = 0;
    double q = 0, worst = 1;
    for (Index t = 0; t < store_.number_of_slots(); ++t)
      if (store_.is_alive(t)) {
        ++alive;
        q += 1 / flips_.quality(t);
        worst = (std::min)(worst, flips_.quality(t));
        good += flips_.quality(t) > 1. / 3;
      }
    std::vector<Candidate> e = candidates(all_tetrahedra(), 2, 1);
    double tau = 0, mean = 0;
    for (const Candidate& c : e) {
      tau += (c.length < 1 ? c.length : 1 / c.length) - 1;
      mean += c.length;
    }
    std::printf("%7.2f %-9s %7zu tets %8zu Q mean %8.3f max %8.2f <3 %.4f tau %.4f l %.3f [%.3f %.3f]\n",
                std::chrono::duration<double>(now - start).count(), what, n, alive, q / double(alive), 1 / worst,
                double(good) / double(alive), std::exp(tau / double(e.size())), mean / double(e.size()),
                e.back().length, e.front().length);
    start += std::chrono::steady_clock::now() - now;
  }
#else
  void log(const char*, std::size_t) {}
#endif

  double scale_ = 1;
  Mesh& mesh_;
  Store& store_;
  Flips flips_;
  Edge_splitter<Mesh, Flips> splitter_;
  Edge_collapser<Mesh, Flips> collapser_;
};

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_METRIC_REMESHER_H
