// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_EDGE_SPLITTER_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_EDGE_SPLITTER_H

#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Cavity.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Facet_turning.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace CGAL::Tubular_meshing::internal {

/* Puts a vertex at the middle, in the metric, of an edge; on the surface, at the nearest point of the edge's patch or
 * rim. First it is found whether that is possible, which only reads: several splitters may do so at the same time. */
class Edge_splitter {
public:
  typedef Tetrahedron_store Store;
  typedef Store::Index Index;

  Edge_splitter(const Metric_mesh& mesh, const Remeshing_flips& flips)
      : mesh_(mesh)
      , cavity_(mesh, flips) {}

  // Whether the edge between corners i and j of t can be split, at the share `s` of it.
  bool find(Index t, int i, int j, double s, const Operation_bounds& bounds) {
    mesh_.store.ring(t, i, j, ring_);
    location_ = mesh_.locations.of_edge(mesh_.store, ring_);
    if (location_.dimension < 3 && mesh_.keep_boundary)
      return false;
    const Vector_3d a = mesh_.store.point(ring_.a), b = mesh_.store.point(ring_.b), middle = a + s * (b - a);
    if (is_crowded(middle, bounds.shortest))
      return false;
    const Vector_3d on_surface = mesh_.project(middle, location_);
    // where the surface is out of reach for the elements as they are, the edge itself will do
    if (try_at(on_surface, true, bounds))
      return true;
    return location_.dimension < 3 && try_at(middle, false, bounds);
  }
  // At the middle of the length that the metrics at its ends give it.
  bool find(Index t, int i, int j, const Operation_bounds& bounds) {
    return find(t, i, j, metric_middle(mesh_.at(mesh_.store[t].v[i]), mesh_.at(mesh_.store[t].v[j])), bounds);
  }

  // Whether what was found still holds, if all changes since are that those tetrahedra have come of which is_new(t).
  template <class IsNew> bool is_fresh(const IsNew& is_new) const { return cavity_.is_fresh(is_new); }

  // Does what was found; the new tetrahedra are left in `come`.
  void commit(Metric_mesh& mesh, Remeshing_flips& flips, Store::Index_list& come) {
    const Index v = mesh.add_vertex(cavity_.kernel(), location_, on_surface_);
    for (auto& f : cavity_.facets())
      std::replace(f.v.begin(), f.v.end(), Store::none, v);
    cavity_.commit(mesh.store, flips, v, come);
  }

private:
  static constexpr double wanted_quality = 0.7; // of cones: those above need not be improved
  static constexpr double by_far = 0.8;         // of the shortest length that is allowed

  /* Whether new edges would be too short by far, as the ends' metrics tell: most of the edges that cannot be split are
   * refused by this already, and the field need not be asked. */
  bool is_crowded(const Vector_3d& p, double shortest) const {
    const Metric_point middle = {p, 0.5 * (mesh_.metric(ring_.a) + mesh_.metric(ring_.b))};
    return std::any_of(ring_.link.begin(), ring_.link.end(),
                       [&](Index v) { return mesh_.length(middle, mesh_.at(v)) < by_far * shortest; });
  }

  bool try_at(const Vector_3d& p, bool on_surface, const Operation_bounds& bounds) {
    cavity_.begin(mesh_.at(p), Store::none);
    if (!has_room(bounds.shortest)) // which a larger cavity would not make
      return false;
    if (on_surface && location_.dimension < 3 && turns_halves(p))
      return false;
    for (Index t : ring_.tetrahedra) {
      cavity_.add_tetrahedron(t);
      cavity_.add_cone(t, ring_.a);
      cavity_.add_cone(t, ring_.b);
      add_facets(t);
    }
    cavity_.enlarge(wanted_quality);
    if (!cavity_.is_allowed(bounds))
      return false;
    const auto lengths = cavity_.lengths();
    on_surface_ = on_surface;
    return lengths[0] >= bounds.shortest && lengths[1] <= bounds.longest;
  }

  // Whether none of the new edges to the vertices around would be too short.
  bool has_room(double shortest) const {
    const auto is_far = [&](Index v) { return mesh_.length(cavity_.kernel(), mesh_.at(v)) >= shortest; };
    return is_far(ring_.a) && is_far(ring_.b) && std::all_of(ring_.link.begin(), ring_.link.end(), is_far);
  }

  // The labelled facets of t at the edge: visit(facet).
  template <class Visit> void for_each_labelled_facet(Index t, const Visit& visit) const {
    const auto& tet = mesh_.store[t];
    for (int k = 0; k < 4; ++k)
      if (tet.label[k] != 0 && tet.v[k] != ring_.a && tet.v[k] != ring_.b)
        visit(Store::facet(t, k));
  }

  // Whether a half of a labelled facet at the edge would turn too far if the new vertex were at p.
  bool turns_halves(const Vector_3d& p) const {
    const Store& store = mesh_.store;
    const auto normal = [&](Index facet, Index moved) {
      std::array<Vector_3d, 3> x;
      const Store::Facet_vertices f = store.vertices(facet);
      for (std::size_t i = 0; i < 3; ++i)
        x[i] = f[i] == moved ? p : store.point(f[i]);
      return cross(x[1] - x[0], x[2] - x[0]);
    };
    const auto for_each_of_all = [&](const auto& visit) {
      for (Index t : ring_.tetrahedra)
        for_each_labelled_facet(t, [&](Index facet) { visit(facet, store.label(facet), store.region(t)); });
    };
    Facet_turning turning;
    for_each_of_all([&](Index facet, std::int32_t label, std::int32_t region) {
      turning.add(label, region, normal(facet, Store::none));
    });
    bool turns = false;
    for_each_of_all([&](Index facet, std::int32_t label, std::int32_t region) {
      const Vector_3d before = normal(facet, Store::none);
      for (Index end : {ring_.a, ring_.b})
        turns = turns || !turning.allows(label, region, before, normal(facet, end));
    });
    return turns;
  }

  // The halves of the labelled facets of t at the edge; the new vertex is yet without a number.
  void add_facets(Index t) {
    for_each_labelled_facet(t, [&](Index facet) {
      for (Index end : {ring_.a, ring_.b}) {
        Store::Facet_vertices half = mesh_.store.vertices(facet);
        std::replace(half.begin(), half.end(), end, Store::none);
        cavity_.facets().push_back({half, mesh_.store.label(facet)});
      }
    });
  }

  const Metric_mesh& mesh_;
  Cavity cavity_;
  Store::Ring ring_;
  Surface_location location_;
  bool on_surface_ = false;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_EDGE_SPLITTER_H
