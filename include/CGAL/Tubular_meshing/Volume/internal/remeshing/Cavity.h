// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_CAVITY_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_CAVITY_H

#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Metric_mesh.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Remeshing_schedule.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstdint>

namespace CGAL::Tubular_meshing::internal {

/* The one operation by which vertices come and go: a set of tetrahedra, the cavity, is replaced by the cones from a
 * kernel (a new point, or a vertex of the cavity) over the facets of its boundary, those at the kernel excepted. As all
 * cones are positive they fill the cavity, whatever its shape.
 *
 * A split starts from the tetrahedra around the edge, a collapse from those around the vertex that goes. The cavity is
 * then enlarged over the facets with the worst cones, as long as this raises the worst quality of what it replaces:
 * what Delaunay's circumspheres decide in the plain case, the measure itself decides here, so that any metric will do.
 * Labelled facets are never crossed.
 *
 * Follows the idea of the cavity operator [Loseille and Menier 2014].
 */
class Cavity {
public:
  typedef Tetrahedron_store Store;
  typedef Store::Index Index;
  struct Facet_cone {
    Store::Facet_vertices f; // with the kernel they make a positive tetrahedron
    Index outer;             // the facet's code on the other side, or none
    std::int32_t label;
    std::int32_t region;
    double quality;
    bool settled; // the cavity does not grow here
  };
  typedef boost::container::small_vector<Facet_cone, 64> Cones;
  typedef boost::container::small_vector<Store::Labelled_facet, 16> Facets;

  // `flips` know the qualities of tetrahedra.
  Cavity(const Metric_mesh& mesh, const Remeshing_flips& flips)
      : mesh_(mesh)
      , flips_(flips)
      , store_(mesh.store) {}

  // `vertex` is the kernel's number, if it is in the mesh already.
  void begin(const Metric_point& kernel, Index vertex) {
    kernel_ = kernel;
    vertex_ = vertex;
    gone_.clear();
    cones_.clear();
    facets_.clear();
    worst_before_ = 1;
  }

  const Metric_point& kernel() const { return kernel_; }
  // labelled facets at the kernel
  Facets& facets() { return facets_; }
  const Facets& facets() const { return facets_; }

  void add_tetrahedron(Index t) {
    gone_.push_back(t);
    worst_before_ = (std::min)(worst_before_, flips_.quality(t));
  }

  // The cone over the facet of t opposite to vertex v. A cone at the kernel is none.
  void add_cone(Index t, Index v) {
    const int i = store_.corner(t, v);
    const Store::Facet_vertices f = store_.vertices(Store::facet(t, i));
    if (std::find(f.begin(), f.end(), vertex_) == f.end())
      cones_.push_back(cone_over(t, i));
  }

  // Whether what the cavity would become is positive, and as good as it has to be.
  bool is_allowed(const Operation_bounds& bounds) const {
    double worst = 1;
    for (const Facet_cone& c : cones_)
      worst = (std::min)(worst, c.quality);
    return worst > 0 && bounds.allow(worst_before_, worst);
  }

  /* Takes in tetrahedra behind facets with cones below `wanted`, while each step makes the worst of the two sets
   * it exchanges better. */
  void enlarge(double wanted) {
    for (int step = 0; step < most_steps; ++step) {
      Facet_cone* worst = nullptr;
      for (Facet_cone& c : cones_)
        if (!c.settled && c.quality < wanted && (worst == nullptr || c.quality < worst->quality))
          worst = &c;
      if (worst == nullptr)
        return;
      if (worst->label != 0 || worst->outer == Store::none || !take_in(*worst))
        worst->settled = true;
    }
  }

  // The shortest and the longest edge from the kernel to the vertices of the cavity.
  std::array<double, 2> lengths() const {
    boost::container::small_vector<Index, 64> seen;
    std::array<double, 2> range = {1e300, 0};
    for (const Facet_cone& c : cones_)
      for (Index v : c.f) {
        if (std::find(seen.begin(), seen.end(), v) != seen.end())
          continue;
        seen.push_back(v);
        const double l = mesh_.length(kernel_, mesh_.at(v));
        range = {(std::min)(range[0], l), (std::max)(range[1], l)};
      }
    return range;
  }

  // Whether all of the tetrahedra are as they were, if those that have come since are those of which is_new(t) holds.
  template <class IsNew> bool is_fresh(const IsNew& is_new) const { return are_fresh(gone_, is_new); }
  template <class List, class IsNew> bool are_fresh(const List& tetrahedra, const IsNew& is_new) const {
    return std::all_of(tetrahedra.begin(), tetrahedra.end(), [&](Index t) { return store_.is_alive(t) && !is_new(t); });
  }

  // Puts the cones, with `kernel` as their apex, in place of the cavity; their numbers are left in `come`.
  void commit(Store& store, Remeshing_flips& flips, Index kernel, Store::Index_list& come) const {
    boost::container::small_vector<Store::Vertices, 64> cells;
    for (const Facet_cone& c : cones_)
      cells.push_back({c.f[0], c.f[1], c.f[2], kernel});
    store.replace(
        gone_, cells, [&](std::size_t k) { return cones_[k].region; }, facets_, come);
    flips.update_new(come);
  }

private:
  static constexpr int most_steps = 64;

  Facet_cone cone_over(Index t, int i) const {
    const auto& tet = store_[t];
    const auto& c = Store::facet_corners(i);
    const Store::Facet_vertices f = {tet.v[c[0]], tet.v[c[2]], tet.v[c[1]]};
    const bool positive = is_positive(store_.point(f[0]), store_.point(f[1]), store_.point(f[2]), kernel_.position);
    const double quality = positive ? metric_quality(mesh_.at(f[0]), mesh_.at(f[1]), mesh_.at(f[2]), kernel_) : 0;
    return {f, tet.neighbor[i], tet.label[i], tet.region, quality, false};
  }

  bool take_in(const Facet_cone& cone) {
    const Index t = Store::tetrahedron_of(cone.outer);
    const auto& tet = store_[t];
    if (tet.region != cone.region || std::find(tet.v.begin(), tet.v.end(), vertex_) != tet.v.end())
      return false;
    boost::container::small_vector<std::size_t, 4> lost; // cones over the facets of t
    double before = flips_.quality(t), after = 1;
    const std::size_t known = cones_.size();
    for (int i = 0; i < 4; ++i) {
      const Index code = Store::facet(t, i);
      const auto at = std::find_if(cones_.begin(), cones_.begin() + std::ptrdiff_t(known),
                                   [&](const Facet_cone& c) { return c.outer == code; });
      if (at != cones_.begin() + std::ptrdiff_t(known)) {
        lost.push_back(std::size_t(at - cones_.begin()));
        before = (std::min)(before, at->quality);
      }
    }
    if (lost.size() > 2) // a vertex would be left without tetrahedra
      return false;
    std::array<Facet_cone, 3> found;
    std::size_t n = 0;
    for (int i = 0; i < 4; ++i) {
      const Index code = Store::facet(t, i);
      if (std::any_of(lost.begin(), lost.end(), [&](std::size_t k) { return cones_[k].outer == code; }))
        continue;
      found[n] = cone_over(t, i);
      after = (std::min)(after, found[n++].quality);
      if (after <= before)
        return false;
    }
    add_tetrahedron(t);
    std::sort(lost.begin(), lost.end());
    for (std::size_t k = lost.size(); k-- > 0;) {
      cones_[lost[k]] = cones_.back();
      cones_.pop_back();
    }
    cones_.insert(cones_.end(), found.begin(), found.begin() + std::ptrdiff_t(n));
    return true;
  }

  const Metric_mesh& mesh_;
  const Remeshing_flips& flips_;
  const Store& store_;
  Metric_point kernel_;
  Index vertex_ = Store::none; // of the kernel, if it is one
  double worst_before_ = 1;
  Store::Index_list gone_;
  Cones cones_;
  Facets facets_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_CAVITY_H
