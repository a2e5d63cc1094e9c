// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_MAKE_COMPLEX_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_MAKE_COMPLEX_H

#include <CGAL/Tubular_meshing/Volume/internal/mesh_3/Lumen_domain.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <CGAL/Mesh_cell_criteria_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_edge_criteria_3.h>
#include <CGAL/Mesh_facet_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/version.h>

#if CGAL_VERSION_NR >= 1050600000
#include <CGAL/make_mesh_3.h>
#else
#include <CGAL/Mesh_3/C3T3_helpers.h>
#include <CGAL/Mesh_3/Mesher_3.h>
#include <CGAL/Mesh_3/Protect_edges_sizing_field.h>
#endif

#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

typedef Mesh_triangulation_3<Lumen_domain>::type Lumen_triangulation;

/* The complex that Mesh_3 makes: a type of our own, so that CGAL's Dump_c3t3, by which Mesh_3 writes files `dump-bug.*`
 * into the current folder when it fails, can be silenced for it. */
struct Lumen_complex
    : Mesh_complex_3_in_triangulation_3<Lumen_triangulation, Lumen_domain::Corner_index, Lumen_domain::Curve_index> {};

/* A model of `MeshCriteriaWithFeatures_3`. */
struct Lumen_criteria {
  typedef Mesh_edge_criteria_3<Lumen_triangulation> Edge_criteria;
  typedef Mesh_facet_criteria_3<Lumen_triangulation> Facet_criteria;
  typedef Mesh_cell_criteria_3<Lumen_triangulation> Cell_criteria;

  const Edge_criteria& edge_criteria_object() const { return edges; }
  const Facet_criteria& facet_criteria_object() const { return facets; }
  const Cell_criteria& cell_criteria_object() const { return cells; }

  Edge_criteria edges;
  Facet_criteria facets;
  Cell_criteria cells;
};

} // namespace internal
} // namespace Tubular_meshing

template <bool is_streamable> struct Dump_c3t3<Tubular_meshing::internal::Lumen_complex, is_streamable> {
  template <class... Arguments> void dump_c3t3(const Arguments&...) const {} // one more since CGAL 6.2
};

namespace Tubular_meshing {
namespace internal {

#if CGAL_VERSION_NR >= 1050600000

// Refines until all criteria hold and the surface is a manifold.
inline void make_complex(const Lumen_domain& domain, const Lumen_criteria& criteria, Lumen_complex& complex) {
  namespace params = CGAL::parameters;
  complex = make_mesh_3<Lumen_complex>(domain, criteria, params::no_perturb(), params::no_exude(), params::no_odt(),
                                       params::no_lloyd(), params::manifold());
}

#else

/* make_mesh_3() of CGAL 5.5 brings named parameters by Boost.Parameter, of which a unit that includes it takes 2.2 GB
 * before its first line: its steps, without the optimizers that are off, are spelled out. */
struct Edge_sizes {
  typedef Lumen_criteria::Edge_criteria::FT FT;
  const Lumen_criteria::Edge_criteria* criteria;
  template <class Index> FT operator()(const Point_3& p, int dimension, const Index& index) const {
    return criteria->sizing_field(p, dimension, index);
  }
};

inline void add_initial_points(const Lumen_domain& domain, Lumen_complex& complex) {
  std::vector<std::pair<Point_3, Lumen_domain::Index>> points;
  domain.construct_initial_points_object()(std::back_inserter(points));
  const auto weighted = complex.triangulation().geom_traits().construct_weighted_point_3_object();
  for (const auto& p : points) {
    const auto v = complex.triangulation().insert(weighted(p.first));
    if (v == Lumen_triangulation::Vertex_handle()) // hidden by a ball on a rim
      continue;
    complex.set_dimension(v, 2);
    complex.set_index(v, p.second);
  }
}

// Refines until all criteria hold and the surface is a manifold.
inline void make_complex(const Lumen_domain& domain, const Lumen_criteria& criteria, Lumen_complex& complex) {
  Mesh_3::Protect_edges_sizing_field<Lumen_complex, Lumen_domain, Edge_sizes> protect(complex, domain,
                                                                                      Edge_sizes{&criteria.edges});
  protect.set_nonlinear_growth_of_balls(false);
  protect(true);
  bool has_facets = complex.triangulation().dimension() == 3;
  if (has_facets) {
    Mesh_3::C3T3_helpers<Lumen_complex, Lumen_domain>(complex, domain).update_restricted_facets();
    has_facets = complex.number_of_facets() != 0;
  }
  if (!has_facets)
    add_initial_points(domain, complex);

  const int manifold = 24; // parameters::internal::Manifold_options::MANIFOLD
  Mesh_3::Mesher_3<Lumen_complex, Lumen_criteria, Lumen_domain> mesher(complex, domain, criteria, manifold);
  mesher.refine_mesh();
  complex.clear_manifold_info();
}

#endif

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_MAKE_COMPLEX_H
