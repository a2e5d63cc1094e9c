// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_METRIC_RELOCATION_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_METRIC_RELOCATION_H

#include <CGAL/Tubular_meshing/Volume/internal/Colored_stars.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Facet_turning.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Metric_energy.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Metric_mesh.h>
#include <CGAL/Tubular_meshing/base/newton_steps.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Coordinates y = Lᵀ x in which a metric L Lᵀ is the identity: there steps are well scaled, however small a size is
 * beside another one. */
class Metric_frame {
public:
  explicit Metric_frame(const Metric_tensor_3& m)
      : l00(std::sqrt(m.xx))
      , l10(m.xy / l00)
      , l20(m.xz / l00)
      , l11(std::sqrt((std::max)(m.yy - l10 * l10, 1e-30 * m.yy)))
      , l21((m.yz - l20 * l10) / l11)
      , l22(std::sqrt((std::max)(m.zz - l20 * l20 - l21 * l21, 1e-30 * m.zz))) {}

  Vector_3d vector_into(const Vector_3d& x) const {
    return {l00 * x.x + l10 * x.y + l20 * x.z, l11 * x.y + l21 * x.z, l22 * x.z};
  }
  Vector_3d vector_out_of(const Vector_3d& y) const {
    const double z = y.z / l22, v = (y.y - l21 * z) / l11;
    return {(y.x - l10 * v - l20 * z) / l00, v, z};
  }
  // Of gradients and normals.
  Vector_3d covector_into(const Vector_3d& g) const {
    const double x = g.x / l00, y = (g.y - l10 * x) / l11;
    return {x, y, (g.z - l20 * x - l21 * y) / l22};
  }
  Symmetric_matrix_3d hessian_into(const Symmetric_matrix_3d& h) const {
    // columns of H L⁻ᵀ, transposed, are rows of L⁻¹ H; then the same from the other side
    const Vector_3d a = covector_into({h.xx, h.xy, h.xz}), b = covector_into({h.xy, h.yy, h.yz}),
                    c = covector_into({h.xz, h.yz, h.zz});
    const Vector_3d x = covector_into({a.x, b.x, c.x}), y = covector_into({a.y, b.y, c.y}),
                    z = covector_into({a.z, b.z, c.z});
    return {x.x, x.y, x.z, y.y, y.z, z.z};
  }

private:
  double l00, l10, l20, l11, l21, l22;
};

/* Moves vertices, topology fixed, down Metric_energy by Newton steps with backtracking; a step is judged with the
 * metric that the field has at its end. Vertices on the surface move along it and are projected onto it. The result is
 * the same for any number of threads. */
class Metric_relocation {
public:
  typedef Tetrahedron_store Store;
  typedef Store::Index Index;

  explicit Metric_relocation(Metric_mesh& mesh)
      : Metric_relocation(mesh, !mesh.layer_patches.empty(), [](Index) { return true; }) {}
  // Of those vertices alone for which is_wanted(v), and heights of boundary layers do not count.
  template <class IsWanted>
  Metric_relocation(Metric_mesh& mesh, const IsWanted& is_wanted)
      : Metric_relocation(mesh, false, is_wanted) {}

  // One visit to each vertex near which something has changed since the last one.
  void sweep() {
    for_each_movable([this](Index v, Star& star) {
      const Store::Facet_vertices* around = stars_.vertices_of_facets(v);
      if (!mesh_.clock.is_awake(v, around, around + stars_.facets(v).size()))
        return;
      relocate(v, star);
      mesh_.clock.set_visited(v);
    });
  }

  // One visit to each vertex.
  void sweep_all() {
    for_each_movable([this](Index v, Star& star) { relocate(v, star); });
  }

  // Brings vertices that are off the surface, where it was out of reach when they were made, onto it.
  void pull_to_surface() {
    for_each_movable([this](Index v, Star& star) {
      if (mesh_.location(v).dimension < 3 && !mesh_.is_on_surface(v))
        pull(v, star);
    });
  }

private:
  template <class IsWanted>
  Metric_relocation(Metric_mesh& mesh, bool heights, const IsWanted& is_wanted)
      : mesh_(mesh)
      , unit2_(mesh.unit() * mesh.unit())
      , heights_(heights)
      , store_(mesh.store) {
    stars_.build(
        store_, [&](Index v) { return mesh_.location(v).dimension != 0; }, is_wanted, mesh_.threads,
        Vertex_clock::block);
  }

  static constexpr double over_relaxation = 1.4; // of steps: neighbors follow, and fewer sweeps do
  static constexpr double least_gain = 3e-4;     // of the energy; less is not worth the visit
  static constexpr double most_loss = 1.5;       // for getting onto the surface
  static constexpr double negligible = 1e-9;     // distance from the surface, in the metric
  static constexpr double noticeable = 0.05;     // a way, in the metric, that is of interest to the neighbors

  /* All that the energy of a vertex depends on but for its own place, in one piece of memory. */
  struct Star {
    struct Layer_facet {
      Vector_3d normal, corner;
      Metric_tensor_3 metric;
    };
    std::vector<Four_facets> facets;
    std::vector<Layer_facet> layer;
  };

  // Each color is one step of time.
  template <class Visit> void for_each_movable(const Visit& visit) const {
    stars_.for_each_movable(
        mesh_.threads, [&visit, star = Star()](Index v) mutable { visit(v, star); }, [this] { mesh_.clock.tick(); });
  }

  void gather(Index v, Star& star) const {
    const auto facets = stars_.facets(v);
    star.facets.resize((facets.size() + 3) / 4);
    star.layer.clear();
    std::size_t n = 0;
    for (Index s : facets) {
      const Store::Facet_vertices& f = stars_.vertices_of_facets(v)[n];
      star.facets[n / 4].set(int(n % 4), mesh_.at(f[0]), mesh_.at(f[1]), mesh_.at(f[2]));
      ++n;
      if (has_layer(s))
        star.layer.push_back(layer_facet(f));
    }
    if (n % 4 != 0)
      star.facets.back().fill(int(n % 4));
  }
  typename Star::Layer_facet layer_facet(const Store::Facet_vertices& f) const {
    const Vector_3d &p = store_.point(f[0]), &q = store_.point(f[1]), &r = store_.point(f[2]);
    return {normalized(cross(q - p, r - p)), p,
            (1. / 3) * (mesh_.metric(f[0]) + mesh_.metric(f[1]) + mesh_.metric(f[2]))};
  }

  void relocate(Index v, Star& star) const {
    const Surface_location at = mesh_.location(v);
    const Metric_point old = mesh_.at(v);
    gather(v, star);
    Metric_energy here(unit2_);
    if (!energy<true>(star, old, here))
      return;
    Vector_3d step = newton(v, at, old, here);
    if (-dot(step, here.gradient) < least_gain * here.value)
      return;
    step = over_relaxation * step;
    const double length2 = old.metric.squared_length(step);
    if (length2 > unit2_) // further than to a neighbor
      step = std::sqrt(unit2_ / length2) * step;
    backtrack(step, [&](const Vector_3d& s) {
      const Vector_3d moved = old.position + s, p = mesh_.project(moved, at);
      // a projection longer than the step has landed on another part of the surface
      if (at.dimension < 3 && squared_norm(p - moved) > squared_norm(s))
        return false;
      const Metric_point there = mesh_.at(p);
      Metric_energy e(unit2_);
      if (!energy<false>(star, there, e, here.value) || !keeps_surface(v, p))
        return false;
      move(v, there, true);
      return true;
    });
  }

  void move(Index v, const Metric_point& there, bool on_surface) const {
    const double way2 = there.metric.squared_length(there.position - store_.point(v));
    if (way2 > noticeable * noticeable * unit2_)
      mesh_.clock.set_moved(v);
    mesh_.move(v, there, on_surface);
  }

  void pull(Index v, Star& star) const {
    const Metric_point old = mesh_.at(v);
    const Vector_3d p = mesh_.project(old.position, mesh_.location(v));
    const double distance2 = old.metric.squared_length(p - old.position);
    Metric_energy here(unit2_);
    if (distance2 < negligible * negligible * unit2_)
      return mesh_.move(v, old, true);
    gather(v, star);
    if (!energy<false>(star, old, here))
      return;
    // a part of the way, if all of it is too far for the elements as they are; they will give way
    for (double share = 1; share > 0.1; share /= 2) {
      const Vector_3d x = old.position + share * (p - old.position);
      const Metric_point there = mesh_.at(share == 1 ? p : x);
      Metric_energy e(unit2_);
      if (energy<false>(star, there, e, most_loss * here.value) && keeps_surface(v, there.position)) {
        move(v, there, share == 1);
        return;
      }
    }
  }

  Vector_3d newton(Index v, const Surface_location& at, const Metric_point& old, const Metric_energy& e) const {
    const Metric_frame frame(old.metric);
    const Symmetric_matrix_3d h = frame.hessian_into(e.hessian);
    const Vector_3d g = frame.covector_into(e.gradient);
    if (at.dimension == 3)
      return frame.vector_out_of(newton_step(h, g));
    const Normals n = normals(v);
    if (at.dimension == 2)
      return frame.vector_out_of(tangential_step(h, g, normalized(frame.covector_into(n.first))));
    return frame.vector_out_of(step_along(h, g, normalized(frame.vector_into(cross(n.first, n.second)))));
  }

  // False if a tetrahedron is inverted, or as soon as the energy is not below the bound: it is a sum of positive terms.
  template <bool With_derivatives>
  static bool energy(const Star& star, const Metric_point& x, Metric_energy& e, double bound = 1e300) {
    for (const Four_facets& f : star.facets)
      if (!e.add<With_derivatives>(f, x) || !(e.value < bound))
        return false;
    for (const auto& f : star.layer)
      if (!e.add_height(f.normal, f.corner - x.position, f.metric, With_derivatives) || !(e.value < bound))
        return false;
    return true;
  }

  bool has_layer(Index facet) const {
    if (!heights_)
      return false;
    const std::int32_t label = store_.label(facet);
    return label != 0 &&
           std::find(mesh_.layer_patches.begin(), mesh_.layer_patches.end(), label) != mesh_.layer_patches.end();
  }

  // Of the labelled facets at a vertex: their mean normals, those with the lowest label first, the others second.
  struct Normals {
    Vector_3d first, second;
  };
  template <class Visit> void for_each_facet(Index v, const Visit& visit) const {
    for (Index s : stars_.facets(v))
      store_.for_each_labelled_facet(s, [&](Index facet, Index a, Index b) {
        // an interface is visited from its side of lower region
        const Index other = store_.other_side(facet);
        if (other == Store::none ||
            store_.region(Store::tetrahedron_of(other)) >= store_.region(Store::tetrahedron_of(facet)))
          visit(a, b, store_.label(facet));
      });
  }
  Normals normals(Index v) const {
    std::int32_t lowest = (std::numeric_limits<std::int32_t>::max)();
    for_each_facet(v, [&](Index, Index, std::int32_t label) { lowest = (std::min)(lowest, label); });
    const Vector_3d& x = store_.point(v);
    Normals sum;
    for_each_facet(v, [&](Index a, Index b, std::int32_t label) {
      (label == lowest ? sum.first : sum.second) += cross(store_.point(a) - x, store_.point(b) - x);
    });
    return {normalized(sum.first), normalized(sum.second)};
  }

  // No facet at v may turn far when v comes to p, nor come to be far from how those at v lie together.
  bool keeps_surface(Index v, const Vector_3d& p) const {
    if (mesh_.location(v).dimension == 3)
      return true;
    struct Facet {
      Index a, b;
      std::int32_t label;
      Vector_3d normal;
    };
    boost::container::small_vector<Facet, 12> facets;
    Facet_turning turning;
    const auto normal = [this](const Vector_3d& apex, Index a, Index b) {
      return cross(store_.point(a) - apex, store_.point(b) - apex);
    };
    const Vector_3d& x = store_.point(v);
    for_each_facet(v, [&](Index a, Index b, std::int32_t label) {
      facets.push_back({a, b, label, normal(x, a, b)});
      turning.add(label, 0, facets.back().normal);
    });
    return std::all_of(facets.begin(), facets.end(),
                       [&](const Facet& f) { return turning.allows(f.label, 0, f.normal, normal(p, f.a, f.b)); });
  }

  Metric_mesh& mesh_;
  const double unit2_;
  const bool heights_;
  Store& store_;
  Colored_stars stars_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_METRIC_RELOCATION_H
