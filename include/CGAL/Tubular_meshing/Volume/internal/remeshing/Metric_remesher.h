// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_METRIC_REMESHER_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_METRIC_REMESHER_H

#include <CGAL/Tubular_meshing/Volume/internal/Speculation.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Edge_collapser.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Edge_list.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Edge_splitter.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Metric_relocation.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Uniform_refinement.h>
#include <CGAL/Tubular_meshing/base/interruption.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The passes of the remesher, in their order.
 *
 * First sizes are brought about: edges longer than √2 units are split, the longest first, and edges shorter than 1/√2
 * units are collapsed, with flips and a relocation in between. That is done at twice the metric's own unit, where there
 * are an eighth of the tetrahedra, and there the mesh is given the metric's shape; then all edges are split at once. So
 * most vertices come about near their places, in tetrahedra of fair shapes. Where the mesh is finer from the start, comes
 * to no fair shapes while it is coarse, or has a boundary that has to stay, edges are split one by one at the metric's
 * unit, until few splits are left to do.
 *
 * Shapes are improved by relocations, flips, and what they leave to split or collapse in turn, vertices being taken out
 * where they are denser than the metric asks, and put in where there are too few. Edges are listed once for all that a
 * round does with them. Each round's work is proportional to what the one before has changed, or a linear sweep.
 */
class Metric_remesher {
public:
  typedef Tetrahedron_store Store;
  typedef Store::Index Index;

  explicit Metric_remesher(Metric_mesh& mesh)
      : mesh_(mesh)
      , store_(mesh.store)
      , flips_(store_, Surface_flip_guard(store_, mesh.projection, mesh.keep_boundary), mesh, mesh.threads,
               Speculation<Edge_splitter>::default_batch)
      , splitters_(mesh.threads, Speculation<Edge_splitter>::default_batch, mesh_, flips_)
      , collapsers_(mesh.threads, Speculation<Edge_collapser>::default_batch, mesh_, flips_) {}

  void run() {
    find_hidden();
    for (double ratio = S::ratio_at_once; mesh_.share_above_ratio(ratio) > S::negligible_share;
         ratio *= S::ratio_at_once) {
      mesh_.limit_ratio(ratio);
      flips_.update_all();
      fit(S::rounds_with_limited_ratio);
      mesh_.limit_ratio(Metric_mesh::no_limit);
      flips_.update_all();
    }
    fit(S::rounds_of_improvement);
    for (int round = 0; round < S::rounds_of_repair; ++round) {
      relocate();
      repair_below(S::repaired);
      flip(S::flipped_at_the_end);
    }
    for (int round = 0; round < S::most_rounds_of_last_repair && !tetrahedra_below(S::repaired_at_last).empty();
         ++round) {
      relax_below(S::repaired_at_last);
      repair_below(S::repaired_at_last);
      flip(S::flipped_at_the_end);
    }
  }

private:
  typedef Remeshing_schedule S;
  typedef Remeshing_flips::Time Time;

  // Sizes, and shapes by so many rounds.
  void fit(int rounds) {
    if (has_edges_above(S::sqrt_2 * S::coarse_unit)) {
      mesh_.set_unit(S::coarse_unit);
      adapt();
      if (!mesh_.keep_boundary)
        improve(S::rounds_while_coarse);
      if (can_refine()) {
        refine();
        return improve(rounds - 1);
      }
    }
    mesh_.set_unit(1);
    for (int round = 0; round < S::most_rounds_at_full_size && adapt() > S::few_splits * store_.number_of_vertices();
         ++round)
      ;
    improve(rounds);
  }

  // Returns the number of splits.
  std::size_t adapt() {
    check_interruption();
    const std::size_t splits = fit_lengths();
    flip(S::flipped_while_adapting);
    relocate();
    return splits;
  }

  // Where the coarse mesh has poor shapes, each of them would be eight.
  bool can_refine() const {
    const double all = double(store_.tetrahedra().size()), poor = double(tetrahedra_below(S::poor).size());
    return !mesh_.keep_boundary && poor < S::few_poor * all;
  }

  // All edges are split at once.
  void refine() {
    check_interruption();
    renumber();
    mesh_.set_unit(1);
    Uniform_refinement(mesh_).run();
    relocate();
    flip(S::flipped_while_adapting);
  }

  // In later rounds no edges are split for their length: balancing takes out most of what that puts in.
  void improve(int rounds) {
    for (int round = 0; round < rounds; ++round) {
      check_interruption();
      relocate();
      flip(S::flipped_while_improving);
      fit_lengths(round < S::rounds_with_splits);
      balance();
    }
  }

  /* Splits edges that a small feature of the field crosses unseen by both ends: their length by samples is much larger
   * than by their ends. From there on, the ends see it. */
  void find_hidden() {
    std::vector<Index> todo = store_.tetrahedra();
    for (int round = 0; round < 8 && !todo.empty(); ++round) {
      const Edge_list edges =
          list_edges(mesh_, todo, [this](double l, Index a, Index b) { return hidden_middle(l, a, b) > 0; });
      todo.clear();
      apply(
          splitters_, edges.size(), always,
          [&](Edge_splitter& s, std::size_t k) {
            return find(s, edges[k], hidden_middle(edges[k].length, edges[k].a, edges[k].b), S::split(1, 1));
          },
          [&](const Store::Index_list& come) { todo.insert(todo.end(), come.begin(), come.end()); });
    }
  }
  // Where the finest of a few samples lies, if the edge ab is much longer than its ends tell; else 0.
  double hidden_middle(double told, Index a, Index b) const {
    const Vector_3d from = store_.point(a), e = store_.point(b) - from;
    const int samples = 3;
    double length = 0, largest = 0, where = 0;
    for (int k = 1; k <= samples; ++k) {
      const double s = double(k) / (samples + 1), l = mesh_.at(from + s * e).metric.length(e);
      length += l / samples;
      if (l > largest) {
        largest = l;
        where = s;
      }
    }
    return length > S::sqrt_2 && length > 1.5 * told ? where : 0;
  }

  bool has_edges_above(double length) const {
    return !list_edges(mesh_, store_.tetrahedra(), [=](double l, Index, Index) { return l > length; }).empty();
  }

  // New vertices are numbered in space first, among the others.
  void relocate() {
    if (store_.number_of_vertices() > numbered_)
      renumber();
    else
      wake_vertices_of_new_tetrahedra();
    Metric_relocation relocation(mesh_);
    if (!mesh_.keep_boundary)
      relocation.pull_to_surface();
    relocation.sweep();
    flips_.update_all();
  }

  std::vector<Index> tetrahedra_below(double quality) const {
    return store_.tetrahedra([&](Index t) { return flips_.quality(t) < quality; });
  }

  // Around bad shapes nothing else counts.
  void relax_below(double quality) {
    const std::vector<Index> bad = tetrahedra_below(quality);
    if (bad.empty())
      return;
    std::vector<char> is_near(store_.number_of_vertices(), 0);
    for (Index t : bad)
      for (Index v : store_[t].v)
        is_near[v] = 1;
    Metric_relocation relocation(mesh_, [&](Index v) { return is_near[v] != 0; });
    for (int i = 0; i < 3; ++i)
      relocation.sweep_all();
    flips_.update_all();
  }

  void renumber() {
    wake_vertices_of_new_tetrahedra();
    mesh_.renumber();
    numbered_ = store_.number_of_vertices();
  }

  void wake_vertices_of_new_tetrahedra() {
    flips_.for_each_newer(last_woken_, [this](Index t) {
      for (Index v : store_[t].v)
        mesh_.clock.wake(v);
    });
    last_woken_ = flips_.now();
  }

  /* Tetrahedra at rest since the last time, with the same threshold, are not tried again, nor are cavities with a worse
   * one, which is tried itself. */
  void flip(double threshold) {
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
    flips_.improve_below(
        threshold,
        [&](Index t) {
          const auto& v = store_[t].v;
          return is_stirred[v[0]] || is_stirred[v[1]] || is_stirred[v[2]] || is_stirred[v[3]];
        },
        true);
  }

  // Splits edges that are too long, then collapses those that are too short. They are listed once for both.
  std::size_t fit_lengths(bool split_long = true) {
    const double unit = mesh_.unit();
    const auto is_long = [=](double l) { return l > S::sqrt_2 * unit; };
    const auto is_short = [=](double l) { return l < unit / S::sqrt_2; };
    Edge_list edges =
        list_edges(mesh_, store_.tetrahedra(), [&](double l, Index, Index) { return is_long(l) || is_short(l); });
    const auto first_short =
        std::find_if(edges.begin(), edges.end(), [&](const Listed_edge& e) { return is_short(e.length); });
    Edge_list short_edges(first_short, edges.end());
    edges.erase(first_short, edges.end());
    const Time listed = flips_.now();
    const std::size_t splits = split_long ? split(std::move(edges), is_long) : 0;
    collapse(updated(std::move(short_edges), listed, is_short), is_short);
    return splits;
  }

  /* A list of edges by length as it would be now, if no vertex has moved since that time. What is left of the edges of
   * tetrahedra that are gone is in those that have come. */
  template <class IsWanted> Edge_list updated(Edge_list edges, Time since, const IsWanted& is_wanted) const {
    edges.erase(std::remove_if(edges.begin(), edges.end(),
                               [&](const Listed_edge& e) {
                                 int i, j;
                                 return !e.find(store_, i, j) || flips_.is_newer(e.t, since);
                               }),
                edges.end());
    std::vector<Index> newer;
    flips_.for_each_newer(since, [&](Index t) { newer.push_back(t); });
    const Edge_list added = list_edges(mesh_, newer, [&](double l, Index, Index) { return is_wanted(l); });
    const auto old = std::ptrdiff_t(edges.size());
    edges.insert(edges.end(), added.begin(), added.end());
    std::inplace_merge(edges.begin(), edges.begin() + old, edges.end(), is_longer);
    edges.erase(std::unique(edges.begin(), edges.end(), have_same_ends), edges.end());
    return edges;
  }

  /* The longest edges first, those much shorter in a later round, with flips in between: splits of tetrahedra out of
   * shape would make more of them. */
  template <class IsLong> std::size_t split(Edge_list edges, const IsLong& is_long) {
    const std::size_t most = most_splits();
    std::size_t n = 0;
    double longest = 1e300;
    std::vector<Index> made;
    while (!edges.empty() && n < most) {
      const Time listed = flips_.now();
      made.clear();
      longest = S::longest_first * (std::min)(longest, double(edges.front().length));
      const auto later =
          std::find_if(edges.begin(), edges.end(), [=](const Listed_edge& e) { return e.length < longest; });
      n += apply(
          splitters_, std::size_t(later - edges.begin()), always,
          [&](Edge_splitter& s, std::size_t k) { return find(s, edges[k], S::split(mesh_.unit(), edges[k].length)); },
          [&](const Store::Index_list& come) { made.insert(made.end(), come.begin(), come.end()); });
      made = spread(made);
      flips_.improve_these(made, S::flipped_after_splits);
      edges.erase(edges.begin(), later);
      edges = updated(std::move(edges), listed, is_long);
    }
    return n;
  }

  /* What has come of one split is next to each other in a list, and in space: of several flips there that are looked for
   * at the same time, only the first would hold. So they are taken from all over the list. */
  static std::vector<Index> spread(const std::vector<Index>& tetrahedra) {
    const std::size_t step = 64;
    std::vector<Index> result;
    result.reserve(tetrahedra.size());
    for (std::size_t first = 0; first < step; ++first)
      for (std::size_t k = first; k < tetrahedra.size(); k += step)
        result.push_back(tetrahedra[k]);
    return result;
  }

  // Whether an edge, if it is still there, can be split or collapsed.
  template <class Operation, class... Arguments>
  bool find(Operation& operation, const Listed_edge& edge, const Arguments&... arguments) const {
    int i, j;
    return edge.find(store_, i, j) && operation.find(edge.t, i, j, arguments...);
  }

  /* Does what is wanted, wanted(k), and found to be possible, find(worker, k), for k < n, one after the other.
   * after(come) receives what has come. Returns how often. */
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
  template <class IsShort> void collapse(Edge_list edges, const IsShort& is_short) {
    std::vector<Index> todo;
    for (int round = 0; round < S::most_rounds_of_collapses && !edges.empty(); ++round) {
      std::reverse(edges.begin(), edges.end());
      todo.clear();
      apply(
          collapsers_, edges.size(), always,
          [&](Edge_collapser& c, std::size_t k) { return find(c, edges[k], S::collapse(mesh_.unit())); },
          [&](const Store::Index_list& come) { todo.insert(todo.end(), come.begin(), come.end()); });
      edges = list_edges(mesh_, todo, [&](double l, Index, Index) { return is_short(l); });
    }
  }

  /* Lengths between 1/√2 and √2 allow for eight times as many elements here as there. Where the volumes of tetrahedra
   * are too small all around, vertices are taken out; where they are too large, put in; no two next to each other in
   * one pass, as relocation is to spread what each of them changes. */
  void balance() {
    const double unit = mesh_.unit(), longest_collapsed = S::longest_collapsed * unit;
    const std::vector<float> volume = mesh_.local_volumes();
    std::vector<char> locked(volume.size(), 0);
    const auto lock = [&](const Store::Index_list& tetrahedra) {
      for (Index t : tetrahedra)
        for (Index v : store_[t].v)
          if (v < locked.size())
            locked[v] = 1;
    };
    const auto is_free = [&](const Listed_edge& e) { return !locked[e.a] && !locked[e.b]; };
    const auto is_dense = [&](double l, Index a, Index b) {
      return l < longest_collapsed && volume[a] < S::dense && volume[b] < S::dense;
    };
    const auto is_sparse = [&](double l, Index a, Index b) {
      return l > S::shortest_split * unit && volume[a] > S::sparse && volume[b] > S::sparse;
    };
    // those that a collapse has changed are not free, so that one list will do
    Edge_list edges = list_edges(mesh_, store_.tetrahedra(),
                                 [&](double l, Index a, Index b) { return is_dense(l, a, b) || is_sparse(l, a, b); });
    const auto first_dense =
        std::find_if(edges.begin(), edges.end(), [=](const Listed_edge& e) { return e.length < longest_collapsed; });
    Edge_list dense(first_dense, edges.end());
    std::reverse(dense.begin(), dense.end());
    edges.erase(first_dense, edges.end());
    apply(
        collapsers_, dense.size(), [&](std::size_t k) { return is_free(dense[k]); },
        [&](Edge_collapser& c, std::size_t k) { return find(c, dense[k], S::collapse_where_dense(unit)); }, lock);
    apply(
        splitters_, edges.size(), [&](std::size_t k) { return is_free(edges[k]); },
        [&](Edge_splitter& s, std::size_t k) { return find(s, edges[k], S::split_where_sparse(unit)); }, lock);
  }

  /* The worst tetrahedra, which neither flips nor relocation have improved: an edge of them is collapsed or
   * split, short or long, if that makes the worst quality of the cavity better. */
  void repair_below(double quality) {
    const Operation_bounds better = S::repair();
    Edge_collapser collapser(mesh_, flips_);
    Edge_splitter splitter(mesh_, flips_);
    for (Index t : tetrahedra_below(quality))
      for (int e = 0; e < 6 && store_.is_alive(t) && flips_.quality(t) < quality; ++e) {
        const int i = e < 3 ? 0 : e < 5 ? 1 : 2, j = e < 3 ? e + 1 : e < 5 ? e - 1 : 3;
        if (collapser.find(t, i, j, better))
          collapser.commit(mesh_, flips_, come_);
        else if (splitter.find(t, i, j, better))
          splitter.commit(mesh_, flips_, come_);
      }
  }

  Metric_mesh& mesh_;
  Store& store_;
  Remeshing_flips flips_;
  Speculation<Edge_splitter> splitters_;
  Speculation<Edge_collapser> collapsers_;
  Store::Index_list come_;
  double last_threshold_ = 0;
  Vertex_clock::Time last_flips_ = 0;
  Time last_woken_ = 0;
  Index numbered_ = 0; // vertices, in space
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_METRIC_REMESHER_H
