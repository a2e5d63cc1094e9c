// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// make_mesh_3() for one kind of domain, without the optimizers that may follow it: that of CGAL 5.5, with its named
// parameters, takes two thirds of the memory and half of the time of a unit that includes it, so that its two steps are
// spelled out for that version.

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_MAKE_COMPLEX_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_MAKE_COMPLEX_H

#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <CGAL/Mesh_cell_criteria_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_edge_criteria_3.h>
#include <CGAL/Mesh_facet_criteria_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/version.h>

#if CGAL_VERSION_NR >= 1050600000
#include <CGAL/make_mesh_3.h>
#else
#include <CGAL/Mesh_3/C3T3_helpers.h>
#include <CGAL/Mesh_3/Mesher_3.h>
#include <CGAL/Mesh_3/Protect_edges_sizing_field.h>
#endif

#include <atomic>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

typedef Polyhedral_mesh_domain_with_features_3<Kernel, Surface> Lumen_domain;

/* The complex that Mesh_3 makes: a type of our own, so that CGAL's Dump_c3t3, by which Mesh_3 writes files `dump-bug.*`
 * into the current folder when it fails, can be silenced for it. */
template <class Triangulation>
struct Lumen_complex
    : Mesh_complex_3_in_triangulation_3<Triangulation, Lumen_domain::Corner_index, Lumen_domain::Curve_index> {};

} // namespace internal
} // namespace Tubular_meshing

template <class Triangulation, bool is_streamable>
struct Dump_c3t3<Tubular_meshing::internal::Lumen_complex<Triangulation>, is_streamable> {
  void dump_c3t3(const Tubular_meshing::internal::Lumen_complex<Triangulation>&, const std::string&) const {}
};

namespace Tubular_meshing {
namespace internal {

/* A model of `MeshCriteriaWithFeatures_3`. */
template <class Triangulation> struct Lumen_criteria {
  typedef Mesh_edge_criteria_3<Triangulation> Edge_criteria;
  typedef Mesh_facet_criteria_3<Triangulation> Facet_criteria;
  typedef Mesh_cell_criteria_3<Triangulation> Cell_criteria;

  const Edge_criteria& edge_criteria_object() const { return edges; }
  const Facet_criteria& facet_criteria_object() const { return facets; }
  const Cell_criteria& cell_criteria_object() const { return cells; }

  Edge_criteria edges;
  Facet_criteria facets;
  Cell_criteria cells;
};

#if CGAL_VERSION_NR >= 1050600000

// Refines until all criteria hold and the surface is a manifold, or `stop` is set.
template <class Triangulation>
void make_complex(const Lumen_domain& domain, const Lumen_criteria<Triangulation>& criteria, std::atomic<bool>& stop,
                  Lumen_complex<Triangulation>& complex) {
  namespace params = CGAL::parameters;
  complex = make_mesh_3<Lumen_complex<Triangulation>>(
      domain, criteria, params::no_perturb(), params::no_exude(), params::no_odt(), params::no_lloyd(),
      params::manifold(), params::mesh_3_options(params::pointer_to_stop_atomic_boolean = &stop));
}

#else

template <class Triangulation> struct Edge_sizes {
  typedef typename Mesh_edge_criteria_3<Triangulation>::FT FT;
  const Mesh_edge_criteria_3<Triangulation>* criteria;
  template <class Index> FT operator()(const Point_3& p, int dimension, const Index& index) const {
    return criteria->sizing_field(p, dimension, index);
  }
};

template <class Triangulation>
void add_initial_points(const Lumen_domain& domain, Lumen_complex<Triangulation>& complex) {
  std::vector<std::pair<Point_3, Lumen_domain::Index>> points;
  domain.construct_initial_points_object()(std::back_inserter(points));
  const auto weighted = complex.triangulation().geom_traits().construct_weighted_point_3_object();
  for (const auto& p : points) {
    const auto v = complex.triangulation().insert(weighted(p.first));
    if (v == typename Triangulation::Vertex_handle()) // hidden by a ball on a rim
      continue;
    complex.set_dimension(v, 2);
    complex.set_index(v, p.second);
  }
}

// Refines until all criteria hold and the surface is a manifold, or `stop` is set.
template <class Triangulation>
void make_complex(const Lumen_domain& domain, const Lumen_criteria<Triangulation>& criteria, std::atomic<bool>& stop,
                  Lumen_complex<Triangulation>& complex) {
  typedef Lumen_complex<Triangulation> Complex;
  typedef Edge_sizes<Triangulation> Sizes;
  Mesh_3::Protect_edges_sizing_field<Complex, Lumen_domain, Sizes> protect(complex, domain, Sizes{&criteria.edges}, 0,
                                                                           0, nullptr, &stop);
  protect.set_nonlinear_growth_of_balls(false);
  protect(true);
  bool has_facets = complex.triangulation().dimension() == 3;
  if (has_facets) {
    Mesh_3::C3T3_helpers<Complex, Lumen_domain>(complex, domain).update_restricted_facets();
    has_facets = complex.number_of_facets() != 0;
  }
  if (!has_facets)
    add_initial_points(domain, complex);

  const int manifold = 24; // parameters::internal::Manifold_options::MANIFOLD
  Mesh_3::Mesher_3<Complex, Lumen_criteria<Triangulation>, Lumen_domain> mesher(complex, domain, criteria, manifold, 0,
                                                                                nullptr, &stop);
  mesher.refine_mesh();
  complex.clear_manifold_info();
}

#endif

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_MAKE_COMPLEX_H
