// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_EDGE_COLLAPSER_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_EDGE_COLLAPSER_H

#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Cavity.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Facet_turning.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Link_condition.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Takes a vertex out: it is pulled onto a neighbor that lies where it may move itself (a vertex on a patch onto one on
 * the same patch or its rim, and so on). On the surface that must not change the surface's shape or topology.
 *
 * First it is found whether that is possible, which only reads: several collapsers may do so at the same time. */
class Edge_collapser {
public:
  typedef Tetrahedron_store Store;
  typedef Store::Index Index;

  Edge_collapser(const Metric_mesh& mesh, const Remeshing_flips& flips)
      : mesh_(mesh)
      , cavity_(mesh, flips)
      , link_condition_(mesh.store) {}

  // Whether the edge between corners i and j of t can be collapsed: the one end onto the other, or the other way.
  bool find(Index t, int i, int j, const Operation_bounds& bounds) {
    const Index v = mesh_.store[t].v[i], w = mesh_.store[t].v[j];
    if (mesh_.location(v).dimension == 0 && mesh_.location(w).dimension == 0)
      return false;
    mesh_.store.ring(t, i, j, ring_);
    const Surface_location edge = mesh_.locations.of_edge(mesh_.store, ring_);
    const bool first = mesh_.location(v).dimension >= mesh_.location(w).dimension;
    return first ? can_collapse_onto(v, w, edge, bounds) || can_collapse_onto(w, v, edge, bounds)
                 : can_collapse_onto(w, v, edge, bounds) || can_collapse_onto(v, w, edge, bounds);
  }

  // Whether what was found still holds, if all changes since are that those tetrahedra have come of which is_new(t).
  template <class IsNew> bool is_fresh(const IsNew& is_new) const {
    return cavity_.is_fresh(is_new) &&
           (mesh_.location(from_).dimension == 3 || cavity_.are_fresh(link_condition_.other_star(), is_new));
  }

  // Does what was found; the new tetrahedra are left in `come`.
  void commit(Metric_mesh& mesh, Remeshing_flips& flips, Store::Index_list& come) const {
    cavity_.commit(mesh.store, flips, to_, come);
    mesh.store.remove_vertex(from_);
  }

private:
  static constexpr double wanted_quality = 0.5;       // of cones: those above need not be improved
  static constexpr std::size_t most_tetrahedra = 200; // around a vertex; of what is worth the work there are some 24
  static constexpr double deviation = 0.1;            // of new edges from the surface, in their length

  bool can_collapse_onto(Index v, Index w, const Surface_location& edge, const Operation_bounds& bounds) {
    const Surface_location& at = mesh_.location(v);
    if (at.dimension == 0 || (at.dimension < 3 && !(edge == at)))
      return false;
    if (!collect_star(v, w, bounds.longest))
      return false;
    cavity_.begin(mesh_.at(w), w);
    for (Index t : star_) {
      cavity_.add_tetrahedron(t);
      cavity_.add_cone(t, v);
    }
    if (at.dimension < 3 && (!add_facets(v, w) || !link_condition_.holds(v, w, ring_, star_)))
      return false;
    if (at.dimension == 3) // on the surface, vertices may come closer than tetrahedra allow for
      cavity_.enlarge(wanted_quality);
    if (!cavity_.is_allowed(bounds))
      return false;
    from_ = v;
    to_ = w;
    return at.dimension == 3 || keeps_shape(v, w, at);
  }

  /* The tetrahedra around v. False, and not all of them, where they are too many, or where w would be joined to a
   * neighbor of v by a new edge that is too long: nine of ten collapses are refused by this. */
  bool collect_star(Index v, Index w, double longest) {
    seen_.assign({v, w});
    seen_.insert(seen_.end(), ring_.link.begin(), ring_.link.end());
    return mesh_.store.star(v, star_, [&](Index t) {
      for (Index u : mesh_.store[t].v)
        if (std::find(seen_.begin(), seen_.end(), u) == seen_.end()) {
          if (mesh_.length(u, w) > longest)
            return false;
          seen_.push_back(u);
        }
      return star_.size() <= most_tetrahedra;
    });
  }

  // What becomes of the labelled facets at v. False where one would turn too far.
  bool add_facets(Index v, Index w) {
    const Store& store = mesh_.store;
    const auto normal = [&](Index apex, Index p, Index q) {
      return cross(store.point(p) - store.point(apex), store.point(q) - store.point(apex));
    };
    struct Facet {
      Index p, q;
      std::int32_t label, region;
      Vector_3d normal;
    };
    boost::container::small_vector<Facet, 12> facets;
    Facet_turning turning;
    for_each_labelled_facet(v, [&](Index facet, Index p, Index q) {
      facets.push_back({p, q, store.label(facet), store.region(Store::tetrahedron_of(facet)), normal(v, p, q)});
      turning.add(facets.back().label, facets.back().region, facets.back().normal);
    });
    for (const Facet& f : facets) {
      if (f.p == w || f.q == w)
        continue;
      if (!turning.allows(f.label, f.region, f.normal, normal(w, f.p, f.q)))
        return false;
      cavity_.facets().push_back({{w, f.p, f.q}, f.label});
    }
    return true;
  }
  // Of those at v, the tetrahedra around which are at hand.
  template <class Visit> void for_each_labelled_facet(Index v, const Visit& visit) const {
    for (Index t : star_)
      mesh_.store.for_each_labelled_facet(Store::facet(t, mesh_.store.corner(t, v)), visit);
  }

  // New edges on the surface lie close to it, in their length, or closer than v's edges did.
  bool keeps_shape(Index v, Index w, const Surface_location& at) const {
    const double any = (std::numeric_limits<double>::infinity)();
    if (worst_deviation(w, deviation) > deviation && worst_deviation(w, any) > worst_deviation(v, any))
      return false;
    if (at.dimension != 1)
      return true;
    const Index u = other_rim_neighbor(v, w);
    return u == Store::none || relative_deviation(w, u, at) <= (std::max)(deviation, relative_deviation(v, u, at));
  }
  // The vertex but w to which v is joined along its rim: where facets with different labels meet.
  Index other_rim_neighbor(Index v, Index w) const {
    boost::container::small_vector<Store::Labelled_facet, 16> ends; // {u, …} and the label of a facet at vu
    for_each_labelled_facet(v, [&](Index facet, Index p, Index q) {
      for (Index u : {p, q})
        if (u != w)
          ends.push_back({{u, 0, 0}, mesh_.store.label(facet)});
    });
    for (const auto& e : ends)
      for (const auto& f : ends)
        if (e.v[0] == f.v[0] && e.label != f.label)
          return e.v[0];
    return Store::none;
  }
  // Of the edges that the cavity's facets have at u; as soon as it exceeds the bound, it is known well enough.
  double worst_deviation(Index u, double bound) const {
    double worst = 0;
    for (const auto& f : cavity_.facets())
      for (int k = 1; k < 3 && worst <= bound; ++k)
        worst = (std::max)(worst, relative_deviation(u, f.v[k], {2, f.label}));
    return worst;
  }
  double relative_deviation(Index u, Index x, const Surface_location& on) const {
    const Vector_3d p = mesh_.store.point(u), q = mesh_.store.point(x), middle = 0.5 * (p + q);
    const double length2 = squared_norm(q - p);
    return length2 > 0 ? std::sqrt(squared_norm(mesh_.project(middle, on) - middle) / length2) : 0;
  }

  const Metric_mesh& mesh_;
  Cavity cavity_;
  Link_condition link_condition_;
  Store::Ring ring_;
  std::vector<Index> star_;
  boost::container::small_vector<Index, 64> seen_;
  Index from_ = Store::none, to_ = Store::none;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_EDGE_COLLAPSER_H
