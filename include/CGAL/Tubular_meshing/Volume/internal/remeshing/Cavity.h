// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_CAVITY_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_CAVITY_H

#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Metric_mesh.h>

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

  explicit Cavity(const Metric_mesh& mesh)
      : mesh_(mesh)
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
  const Cones& cones() const { return cones_; }
  // labelled facets at the kernel
  Facets& facets() { return facets_; }
  const Facets& facets() const { return facets_; }

  void add_tetrahedron(Index t, double quality) {
    gone_.push_back(t);
    worst_before_ = (std::min)(worst_before_, quality);
  }

  // The cone over the facet of t opposite to corner i. A cone at the kernel is none.
  void add_cone(Index t, int i) {
    const auto& tet = store_[t];
    const auto& c = Store::facet_corners(i);
    const Store::Facet_vertices f = {tet.v[c[0]], tet.v[c[2]], tet.v[c[1]]};
    if (f[0] == vertex_ || f[1] == vertex_ || f[2] == vertex_)
      return;
    cones_.push_back({f, tet.neighbor[i], tet.label[i], tet.region, quality(f), false});
  }

  double worst_before() const { return worst_before_; }
  double worst() const {
    double q = 1;
    for (const Facet_cone& c : cones_)
      q = (std::min)(q, c.quality);
    return q;
  }

  /* Takes in tetrahedra behind facets with cones below `wanted`, while each step makes the worst of the two sets
   * it exchanges better. */
  template <class Quality> void enlarge(double wanted, const Quality& quality_of) {
    for (int step = 0; step < most_steps; ++step) {
      Facet_cone* worst = nullptr;
      for (Facet_cone& c : cones_)
        if (!c.settled && c.quality < wanted && (worst == nullptr || c.quality < worst->quality))
          worst = &c;
      if (worst == nullptr)
        return;
      if (worst->label != 0 || worst->outer == Store::none || !take_in(*worst, quality_of))
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
        const double l = metric_length(kernel_, mesh_.at(v));
        range = {(std::min)(range[0], l), (std::max)(range[1], l)};
      }
    return range;
  }

  // Of the tetrahedra to go.
  template <class Predicate> bool all_of_gone(const Predicate& p) const {
    return std::all_of(gone_.begin(), gone_.end(), p);
  }

  // Puts the cones, with `kernel` as their apex, in place of the cavity; their numbers are left in `come`.
  void commit(Store& store, Index kernel, Store::Index_list& come) const {
    boost::container::small_vector<Store::Vertices, 64> cells;
    for (const Facet_cone& c : cones_)
      cells.push_back({c.f[0], c.f[1], c.f[2], kernel});
    store.replace(
        gone_, cells, [&](std::size_t k) { return cones_[k].region; }, facets_, come);
  }

private:
  static constexpr int most_steps = 64;

  double quality(const Store::Facet_vertices& f) const {
    if (!is_positive(store_.point(f[0]), store_.point(f[1]), store_.point(f[2]), kernel_.position))
      return 0;
    return metric_quality(mesh_.at(f[0]), mesh_.at(f[1]), mesh_.at(f[2]), kernel_);
  }

  template <class Quality> bool take_in(const Facet_cone& cone, const Quality& quality_of) {
    const Index t = Store::tetrahedron_of(cone.outer);
    const auto& tet = store_[t];
    if (tet.region != cone.region || std::find(tet.v.begin(), tet.v.end(), vertex_) != tet.v.end())
      return false;
    boost::container::small_vector<std::size_t, 4> lost; // cones over the facets of t
    double before = quality_of(t), after = 1;
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
      const auto& c = Store::facet_corners(i);
      const Store::Facet_vertices f = {tet.v[c[0]], tet.v[c[2]], tet.v[c[1]]};
      found[n] = {f, tet.neighbor[i], tet.label[i], tet.region, quality(f), false};
      after = (std::min)(after, found[n++].quality);
      if (after <= before)
        return false;
    }
    worst_before_ = (std::min)(worst_before_, quality_of(t));
    gone_.push_back(t);
    std::sort(lost.begin(), lost.end());
    for (std::size_t k = lost.size(); k-- > 0;) {
      cones_[lost[k]] = cones_.back();
      cones_.pop_back();
    }
    cones_.insert(cones_.end(), found.begin(), found.begin() + std::ptrdiff_t(n));
    return true;
  }

  const Metric_mesh& mesh_;
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
