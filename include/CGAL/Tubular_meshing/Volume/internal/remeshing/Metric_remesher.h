// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_METRIC_REMESHER_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_METRIC_REMESHER_H

#include <CGAL/Tubular_meshing/Volume/internal/Speculation.h>
#include <CGAL/Tubular_meshing/Volume/internal/Surface_flip_guard.h>
#include <CGAL/Tubular_meshing/Volume/internal/Topology_optimizer.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Edge_collapser.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Edge_list.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Edge_splitter.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Metric_mesh.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Metric_relocation.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/local_volumes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* Flips that change the surface are refused where it is to stay. */
struct Remeshing_flip_guard {
  Surface_flip_guard<Patch_projection> shape;
  bool keep_boundary;

  bool operator()(Tetrahedron_store::Index a, Tetrahedron_store::Index b, Tetrahedron_store::Index c,
                  Tetrahedron_store::Index d, std::int32_t patch) const {
    return !keep_boundary && shape(a, b, c, d, patch);
  }
};

/* The passes of the remesher, in their order.
 *
 * First sizes are brought about, from coarse to fine: for unit lengths 4, 2 and 1 edges longer than √2 units are split,
 * the longest first, and edges shorter than 1/√2 units are collapsed, with flips and a relocation in between. A mesh
 * that has the metric's shape at a coarse size is cheap to come by, and what is split from it has that shape from the
 * start. Then shapes: relocations, flips, and what they leave to split or collapse in turn, vertices being taken out
 * where they are denser than the metric asks, and put in where there are too few. Each round's work is proportional to
 * what the one before has changed, or a linear sweep.
 */
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
               mesh.threads, Speculation<Splitter>::default_batch)
      , splitters_(mesh.threads, Speculation<Splitter>::default_batch, mesh_, flips_)
      , collapsers_(mesh.threads, Speculation<Collapser>::default_batch, mesh_, flips_) {}

  // `observe(*this, what, n)` is told after each pass what was done, and how often.
  template <class Observer> void run(const Observer& observe) {
    observe(*this, "find", find_hidden());
    const double at_once = 32, hardly_any = 0.1;
    for (double ratio = at_once; mesh_.share_above_ratio(ratio) > hardly_any; ratio *= at_once) {
      mesh_.limit_ratio(ratio);
      flips_.update_all();
      adapt_by_steps(observe);
      improve(3, observe);
      mesh_.limit_ratio(Mesh::no_limit);
      flips_.update_all();
    }
    adapt_by_steps(observe);
    improve(6, observe);
    for (int round = 0; round < 3; ++round) {
      relocate(2, 1);
      observe(*this, "repair", repair_below(0.25));
      observe(*this, "finish", flip(0.8));
    }
    for (int round = 0; round < 2; ++round) {
      relax_below(0.3);
      observe(*this, "repair", repair_below(0.3));
      observe(*this, "finish", flip(0.8));
    }
  }

  template <class Observer> void adapt_by_steps(const Observer& observe) {
    for (double size : {4., 2., 1.})
      if (size == 1 || has_edges_above(sqrt_2 * size))
        adapt(size, observe);
  }

  template <class Observer> void improve(int rounds, const Observer& observe) {
    for (int round = 0; round < rounds; ++round) {
      relocate(2, 1);
      observe(*this, "flip", flip(0.75));
      observe(*this, "size", split_above(1) + collapse_below(1));
      observe(*this, "balance", balance());
    }
  }

  const Mesh& mesh() const { return mesh_; }
  const Flips& flips() const { return flips_; }

private:
  typedef Edge_splitter<Mesh, Flips> Splitter;
  typedef Edge_collapser<Mesh, Flips> Collapser;
  typedef typename Flips::Time Time;

  static constexpr double sqrt_2 = 1.4142135623730951;

  /* Splits edges that a small feature of the field crosses unseen by both ends: their length by samples is much larger
   * than by their ends. From there on, the ends see it. */
  std::size_t find_hidden() {
    std::size_t n = 0;
    std::vector<Index> todo = list_tetrahedra(store_);
    for (int round = 0; round < 8 && !todo.empty(); ++round) {
      const Edge_list edges = list_edges(mesh_, todo, [](double) { return true; });
      std::vector<float> share(edges.size(), 0);
      for_each_range(edges.size(), mesh_.threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k)
          share[k] = float(hidden_middle(edges[k]));
      });
      todo.clear();
      n += apply(
          splitters_, edges.size(), [&](std::size_t k) { return share[k] > 0; },
          [&](Splitter& s, std::size_t k) {
            int i, j;
            return edges[k].find(store_, i, j) && s.find(edges[k].t, i, j, share[k], bounds_of_split(1, 1));
          },
          [&](const Store::Index_list& come) { todo.insert(todo.end(), come.begin(), come.end()); });
    }
    return n;
  }
  // Where the finest of a few samples lies, if the edge is much longer than its ends tell; else 0.
  double hidden_middle(const Listed_edge& edge) const {
    const Vector_3d a = store_.point(edge.a), e = store_.point(edge.b) - a;
    const int samples = 3;
    double length = 0, largest = 0, where = 0;
    for (int k = 1; k <= samples; ++k) {
      const double s = double(k) / (samples + 1), l = mesh_.at(a + s * e).metric.length(e);
      length += l / samples;
      if (l > largest) {
        largest = l;
        where = s;
      }
    }
    return length > sqrt_2 && length > 1.5 * edge.length ? where : 0;
  }

  bool has_edges_above(double length) const {
    return !list_edges(mesh_, list_tetrahedra(store_), [=](double l) { return l > length; }).empty();
  }

  template <class Observer> void adapt(double size, const Observer& observe) {
    const int most_rounds = size > 1 ? 1 : 4;
    for (int round = 0; round < most_rounds; ++round) {
      observe(*this, "split", split_above(size));
      observe(*this, "collapse", collapse_below(size));
      observe(*this, "flip", flip(0.5));
      renumber();
      relocate(1, size);
    }
  }

  void relocate(int sweeps, double size) {
    wake_vertices_of_new_tetrahedra();
    if (size != last_size_)
      mesh_.clock.wake_all();
    last_size_ = size;
    Metric_relocation<Mesh> relocation(mesh_, size);
    if (!mesh_.keep_boundary)
      relocation.pull_to_surface();
    for (int i = 0; i < sweeps; ++i)
      relocation.sweep();
    flips_.update_all();
  }

  // Around bad shapes nothing else counts.
  void relax_below(double quality) {
    std::vector<char> is_near(store_.number_of_vertices(), 0);
    for (Index t = 0; t < store_.number_of_slots(); ++t)
      if (store_.is_alive(t) && flips_.quality(t) < quality)
        for (Index v : store_[t].v)
          is_near[v] = 1;
    Metric_relocation<Mesh> relocation(mesh_, 1, false);
    for (int i = 0; i < 3; ++i)
      relocation.sweep(is_near);
    flips_.update_all();
  }

  void renumber() {
    wake_vertices_of_new_tetrahedra();
    mesh_.renumber();
    flips_.update_all();
  }

  void wake_vertices_of_new_tetrahedra() {
    flips_.for_each_newer(last_woken_, [this](Index t) {
      for (Index v : store_[t].v)
        mesh_.clock.wake(v);
    });
    last_woken_ = flips_.now();
  }

  // Tetrahedra at rest since the last time, with the same threshold, are not tried again.
  std::size_t flip(double threshold) {
    std::vector<char> is_stirred(store_.number_of_vertices(), threshold != last_threshold_);
    const Vertex_clock::Time last = last_flips_;
    wake_vertices_of_new_tetrahedra();
    for (Index t = 0; t < store_.number_of_slots(); ++t)
      if (store_.is_alive(t) && mesh_.clock.any_stirred_since(store_[t].v, last))
        for (Index v : store_[t].v)
          is_stirred[v] = 1;
    mesh_.clock.tick();
    last_flips_ = mesh_.clock.now();
    mesh_.clock.tick();
    last_threshold_ = threshold;
    return flips_.improve_below(threshold, [&](Index t) {
      const auto& v = store_[t].v;
      return is_stirred[v[0]] || is_stirred[v[1]] || is_stirred[v[2]] || is_stirred[v[3]];
    });
  }

  /* Bad shapes may be split and collapsed as long as it does not make them much worse. Where an edge is many times too
   * long, that it goes comes first, even if short ones come of it; but a bound there must be, as halves of bad shapes
   * would be worse without end. */
  static Operation_bounds bounds_of_split(double size, double length) {
    const double excess = (std::max)(1., length / (sqrt_2 * size));
    return {0.2, 0.8, 0.65 * size * (std::min)(1., 2 / excess), 1e300, 0.002, 0.8 / std::sqrt(excess)};
  }
  static Operation_bounds bounds_of_collapse(double size) { return {0.2, 0.8, 0, sqrt_2 * size, 1, 1}; }

  /* The longest edges first, those much shorter in a later round, with flips in between: splits of tetrahedra out of
   * shape would make more of them. */
  std::size_t split_above(double size) {
    const double step = 0.6;
    const std::size_t most = most_splits();
    std::size_t n = 0;
    double longest = 1e300;
    std::vector<Index> todo = list_tetrahedra(store_), next, made;
    for (; !todo.empty() && n < most; todo.swap(next)) {
      const Edge_list edges = list_edges(mesh_, todo, [=](double l) { return l > sqrt_2 * size; });
      next.clear();
      made.clear();
      if (edges.empty())
        break;
      longest = step * (std::min)(longest, double(edges.front().length));
      const auto later =
          std::find_if(edges.begin(), edges.end(), [=](const Listed_edge& e) { return e.length < longest; });
      for (auto e = later; e != edges.end(); ++e)
        next.push_back(e->t);
      n += apply(
          splitters_, std::size_t(later - edges.begin()), always,
          [&](Splitter& s, std::size_t k) {
            int i, j;
            return edges[k].find(store_, i, j) && s.find(edges[k].t, i, j, bounds_of_split(size, edges[k].length));
          },
          [&](const Store::Index_list& come) { made.insert(made.end(), come.begin(), come.end()); });
      flips_.improve_these(made, 0.4);
      next.insert(next.end(), made.begin(), made.end());
    }
    return n;
  }

  /* Does what is wanted, wanted(k), and found to be possible, find(worker, k), for k < n, one after the other.
   * after(come) is told what has come. Returns how often. */
  static bool always(std::size_t) { return true; }
  template <class Worker, class Wanted, class Find, class After>
  std::size_t apply(Speculation<Worker>& workers, std::size_t n, const Wanted& wanted, const Find& find,
                    const After& after) {
    std::size_t done = 0;
    workers.run([=] { return n; }, [this] { return flips_.now(); },
                [&](Worker& w, std::size_t k) { return wanted(k) && find(w, k); },
                [&](const Worker& w, std::size_t k, Time since) {
                  return wanted(k) && w.is_fresh([&](Index t) { return flips_.is_newer(t, since); });
                },
                [&](Worker& w, std::size_t) {
                  w.commit(mesh_, flips_, come_);
                  after(come_);
                  ++done;
                });
    return done;
  }

  /* What a mesh can need, several times over: there are five or six tetrahedra a vertex. In metrics whose sizes are in
   * a ratio of thousands, elements may get ever worse shapes, and ever more long edges with them; passes have an end.
   */
  std::size_t most_splits() const { return 10000 + std::size_t(mesh_.number_of_unit_tetrahedra()); }

  // The shortest edges first, again where new ones come about; few rounds do most.
  std::size_t collapse_below(double size) {
    const int most_rounds = 20;
    std::size_t n = 0;
    std::vector<Index> todo = list_tetrahedra(store_);
    for (int round = 0; round < most_rounds && !todo.empty(); ++round) {
      Edge_list edges = list_edges(mesh_, todo, [=](double l) { return l < size / sqrt_2; });
      std::reverse(edges.begin(), edges.end());
      todo.clear();
      n += apply(
          collapsers_, edges.size(), always,
          [&](Collapser& c, std::size_t k) {
            int i, j;
            return edges[k].find(store_, i, j) && c.find(edges[k].t, i, j, bounds_of_collapse(size));
          },
          [&](const Store::Index_list& come) { todo.insert(todo.end(), come.begin(), come.end()); });
    }
    return n;
  }

  /* Lengths between 1/√2 and √2 allow for eight times as many elements here as there. Where the volumes of tetrahedra
   * are too small all around, vertices are taken out; where they are too large, put in; no two next to each other in
   * one pass, as relocation is to spread what each of them changes. */
  std::size_t balance() {
    const double dense = 0.9, sparse = 1.08;
    const std::vector<float> volume = local_volumes(mesh_);
    std::vector<char> locked(volume.size(), 0);
    const auto lock = [&](const Store::Index_list& tetrahedra) {
      for (Index t : tetrahedra)
        for (Index v : store_[t].v)
          if (v < locked.size())
            locked[v] = 1;
    };
    const auto is_free = [&](const Listed_edge& e) {
      return e.a < locked.size() && e.b < locked.size() && !locked[e.a] && !locked[e.b];
    };
    const Operation_bounds when_collapsing = {0.15, 0.5, 0, 1.75, 1, 1}, when_splitting = {0.25, 0.8, 0.6, 1e300, 1, 1};
    std::size_t n = 0;
    Edge_list edges = list_edges(mesh_, list_tetrahedra(store_), [](double l) { return l < 1; });
    std::reverse(edges.begin(), edges.end());
    n += apply(
        collapsers_, edges.size(),
        [&](std::size_t k) { return is_free(edges[k]) && volume[edges[k].a] < dense && volume[edges[k].b] < dense; },
        [&](Collapser& c, std::size_t k) {
          int i, j;
          return edges[k].find(store_, i, j) && c.find(edges[k].t, i, j, when_collapsing);
        },
        lock);
    edges = list_edges(mesh_, list_tetrahedra(store_), [](double l) { return l > 1.2; });
    n += apply(
        splitters_, edges.size(),
        [&](std::size_t k) { return is_free(edges[k]) && volume[edges[k].a] > sparse && volume[edges[k].b] > sparse; },
        [&](Splitter& s, std::size_t k) {
          int i, j;
          return edges[k].find(store_, i, j) && s.find(edges[k].t, i, j, when_splitting);
        },
        lock);
    return n;
  }

  /* The worst tetrahedra, from which neither flips nor relocation have found a way out: an edge of them is collapsed or
   * split, short or long, if that makes the worst quality of the cavity better. */
  std::size_t repair_below(double quality) {
    const Operation_bounds better = {1, 1.1, 0.4, 2, 1, 1};
    std::vector<Index> worst;
    for (Index t = 0; t < store_.number_of_slots(); ++t)
      if (store_.is_alive(t) && flips_.quality(t) < quality)
        worst.push_back(t);
    Collapser collapser(mesh_, flips_);
    Splitter splitter(mesh_, flips_);
    std::size_t n = 0;
    for (Index t : worst)
      for (int e = 0; e < 6 && store_.is_alive(t) && flips_.quality(t) < quality; ++e) {
        const int i = e < 3 ? 0 : e < 5 ? 1 : 2, j = e < 3 ? e + 1 : e < 5 ? e - 1 : 3;
        if (collapser.find(t, i, j, better))
          collapser.commit(mesh_, flips_, come_);
        else if (splitter.find(t, i, j, better))
          splitter.commit(mesh_, flips_, come_);
        else
          continue;
        ++n;
      }
    return n;
  }

  Mesh& mesh_;
  Store& store_;
  Flips flips_;
  Speculation<Splitter> splitters_;
  Speculation<Collapser> collapsers_;
  Store::Index_list come_;
  double last_size_ = 0, last_threshold_ = 0;
  Vertex_clock::Time last_flips_ = 0;
  Time last_woken_ = 0;
};

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_METRIC_REMESHER_H
