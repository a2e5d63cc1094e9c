// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_MAKE_COMPLEX_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_MAKE_COMPLEX_H

#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <CGAL/Mesh_cell_criteria_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_edge_criteria_3.h>
#include <CGAL/Mesh_facet_criteria_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/version.h>

#include <CGAL/make_mesh_3.h>

#include <atomic>
#include <iterator>
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

/* The optimizers that make_mesh_3() may run afterwards are off. These come before CGAL's for our complex, so that CGAL's
 * are not compiled: they would take half of the unit's time and 1.4 of its 3.4 GB. */
template <class Triangulation, class... Arguments>
void odt_optimize_mesh_3(Lumen_complex<Triangulation>&, const Lumen_domain&, const Arguments&...) {}
template <class Triangulation, class... Arguments>
void lloyd_optimize_mesh_3(Lumen_complex<Triangulation>&, const Lumen_domain&, const Arguments&...) {}
template <class Triangulation, class... Arguments>
void perturb_mesh_3(Lumen_complex<Triangulation>&, const Lumen_domain&, const Arguments&...) {}
template <class Triangulation, class... Arguments>
void exude_mesh_3(Lumen_complex<Triangulation>&, const Arguments&...) {}

} // namespace internal
} // namespace Tubular_meshing

template <class Triangulation, bool is_streamable>
struct Dump_c3t3<Tubular_meshing::internal::Lumen_complex<Triangulation>, is_streamable> {
  template <class... Arguments> void dump_c3t3(const Arguments&...) const {} // one more since CGAL 6.2
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

// Refines until all criteria hold and the surface is a manifold, or `stop` is set. Before CGAL 5.6 the named parameters
// have no name for it.
template <class Triangulation>
void make_complex(const Lumen_domain& domain, const Lumen_criteria<Triangulation>& criteria, std::atomic<bool>& stop,
                  Lumen_complex<Triangulation>& complex) {
  namespace params = CGAL::parameters;
  params::internal::Mesh_3_options options;
  options.pointer_to_stop_atomic_boolean = &stop;
  make_mesh_3_impl(complex, domain, criteria, params::no_exude(), params::no_perturb(), params::no_odt(),
                   params::no_lloyd(), true, options, params::manifold());
}

#endif

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_MAKE_COMPLEX_H
