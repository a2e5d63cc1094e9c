// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_MESH_3_H
#define CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_MESH_3_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Volume/internal/mesh_complex_to_mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/Rims/rim_corners.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/info.h>
#endif

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

// A size field times a constant, light enough for Mesh_3's habit of copying fields by value.
template <class SizingField> struct Scaled_field {
  typedef double FT;
  const SizingField* field;
  FT factor;

  template <class Point_3, class Index> FT operator()(const Point_3& p, const int dimension, const Index& index) const {
    return factor * (*field)(p, dimension, index);
  }
};

struct Rim_polyline {
  std::vector<Point_3> points; // where closed, the first comes again at the end
  std::set<int> patches;       // the two that meet in it
};

// The closed polylines in which a cap meets the wall.
inline std::vector<Rim_polyline> rim_polylines(const Surface_mesh<Point_3>& surface, Face_patch_map patch) {
  typedef Surface::Halfedge_index Halfedge;
  const auto label = [&](Halfedge h) { return get(patch, surface.face(h)); };
  const auto is_rim = [&](Halfedge h) { return label(h) != label(surface.opposite(h)); };
  std::vector<Rim_polyline> rims;
  std::vector<bool> seen(surface.number_of_halfedges(), false);
  for (Halfedge start : surface.halfedges()) {
    // walked on the caps' side, so that each rim comes once
    if (seen[start] || label(start) == labels::wall || !is_rim(start))
      continue;
    Rim_polyline rim = {{surface.point(surface.source(start))}, {label(start), label(surface.opposite(start))}};
    Halfedge h = start;
    do {
      seen[h] = true;
      rim.points.push_back(surface.point(surface.target(h)));
      h = surface.next(h);
      while (!is_rim(h))
        h = surface.next(surface.opposite(h));
    } while (h != start);
    rims.push_back(std::move(rim));
  }
  return rims;
}

template <class Rim> struct Rim_points_map {
  typedef Rim key_type;
  typedef decltype(Rim::points) value_type;
  typedef const value_type& reference;
  typedef boost::readable_property_map_tag category;
  friend reference get(const Rim_points_map&, const Rim& rim) { return rim.points; }
};

template <class Rim> struct Rim_patches_map {
  typedef Rim key_type;
  typedef std::set<int> value_type;
  typedef const value_type& reference;
  typedef boost::readable_property_map_tag category;
  friend reference get(const Rim_patches_map&, const Rim& rim) { return rim.patches; }
};

// Mesh_3 bounds the radii of Delaunay balls, not edges: these ratios make the mean edge, on the surface and inside,
// about h (0.95 h and 1.06 h after optimization, on the vessels that were measured).
constexpr double facet_ball_radius = 0.9;
constexpr double cell_ball_radius = 0.81;
constexpr double facet_angle_bound = 25; // degrees; Mesh_3 is proved to end up to 30
constexpr double radius_edge_ratio_bound = 2;

template <class Concurrency_tag, class Surface, class SizingField>
void run_mesh_3(const Surface& labelled_surface, const SizingField& size, double facet_distance, Mixed_mesh& mesh) {
  typedef Exact_predicates_inexact_constructions_kernel Kernel;
  typedef Polyhedral_mesh_domain_with_features_3<Kernel, Surface> Domain;
  typedef typename Mesh_triangulation_3<Domain, Default, Concurrency_tag>::type Triangulation;
  typedef Mesh_complex_3_in_triangulation_3<Triangulation, typename Domain::Corner_index, typename Domain::Curve_index>
      C3t3;
  typedef Scaled_field<SizingField> Field;
  typedef Rim_polyline Rim;
  namespace params = CGAL::parameters;

  Domain domain(labelled_surface);
  std::vector<Rim> rims;
  for (const Rim& rim :
       rim_polylines(labelled_surface, get(face_patch_id_t<int>(), const_cast<Surface&>(labelled_surface))))
    for (auto& piece : split_at_corners(rim.points, [&](const auto& p) { return 0.5 * size(p, 1, 0); }))
      rims.push_back({std::move(piece), rim.patches});
  domain.add_features_and_incidences(rims.begin(), rims.end(), Rim_points_map<Rim>(), Rim_patches_map<Rim>());

  const Mesh_criteria_3<Triangulation> criteria(
      params::edge_size = Field{&size, 1.}, params::facet_angle = facet_angle_bound,
      params::facet_size = Field{&size, facet_ball_radius}, params::facet_distance = Field{&size, facet_distance},
      params::cell_radius_edge_ratio = radius_edge_ratio_bound, params::cell_size = Field{&size, cell_ball_radius});
  const C3t3 c3t3 = make_mesh_3<C3t3>(domain, criteria, params::no_perturb(), params::no_exude(), params::no_odt(),
                                      params::no_lloyd(), params::manifold());
  mesh_complex_to_mixed_mesh(c3t3, mesh);
}

} // namespace internal

/*! \ingroup PkgTubularMeshingRef
 *
 * fills a closed labelled surface with tetrahedra by CGAL's Mesh_3: the surface is remeshed, its rims are protected as
 * features, its labels are kept. Refinement only; what makes the mesh good is optimize_tetrahedra().
 *
 * \param surface a closed triangle mesh without self-intersections, its faces turned outward
 * \param patch a readable property map from its faces to `int`: labels::wall, and one label a cap. Caps do not touch
 *   each other.
 * \param size a model of `MeshDomainField_3`: the wanted length of edges. Must outlive the call only.
 * \param mesh is replaced: tetrahedra of region labels::lumen, and all boundary triangles
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{facet_distance} \cgalParamDescription{how far the middle of a surface triangle may be from the
 *     surface, relative to the local mesh size} \cgalParamDefault{0.07, a third more than a triangle of edge h has on a
 * tube of 20 h circumference} \cgalParamNEnd \cgalParamNBegin{number_of_threads} \cgalParamDescription{with 1 the
 * result is reproducible; 0 takes all cores} \cgalParamDefault{0} \cgalParamNEnd \cgalNamedParamsEnd
 *
 * \throws Meshing_error if Mesh_3 fails
 */
template <class SizingField, class NamedParameters = CGAL::parameters::Default_named_parameters>
void fill_with_mesh_3(const Surface& surface, Face_patch_map patch, const SizingField& size, Mixed_mesh& mesh,
                      const NamedParameters& np = CGAL::parameters::default_values()) {
  typedef Surface_mesh<Exact_predicates_inexact_constructions_kernel::Point_3> Surface;
  const double distance = internal::choose(np, internal_np::facet_distance, 0.07);
  const int threads = internal::choose(np, internal_np::number_of_threads, 0);

  Surface labelled;
  std::vector<std::pair<typename boost::graph_traits<Surface>::face_descriptor, Surface::Face_index>> copies;
  copy_face_graph(surface, labelled, CGAL::parameters::face_to_face_output_iterator(std::back_inserter(copies)));
  auto patch_id = get(face_patch_id_t<int>(), labelled);
  for (const auto& f : copies)
    put(patch_id, f.second, get(patch, f.first));

  mesh = Mixed_mesh();
  try {
#ifdef CGAL_LINKED_WITH_TBB
    const std::size_t concurrency = threads > 0 ? std::size_t(threads) : std::size_t(tbb::info::default_concurrency());
    if (concurrency > 1) {
      tbb::global_control control(tbb::global_control::max_allowed_parallelism, concurrency);
      internal::run_mesh_3<Parallel_tag>(labelled, size, distance, mesh);
    } else
#endif
      internal::run_mesh_3<Sequential_tag>(labelled, size, distance, mesh);
  } catch (const Failure_exception& e) {
    throw Meshing_error("Mesh_3 cannot fill this surface (" + e.message() + " " + e.expression() +
                        "): check that it does not intersect itself.");
  }
  if (mesh.tetrahedra.empty())
    throw Meshing_error("Mesh_3 found no volume inside the surface: check that it is closed and larger than the mesh "
                        "size.");
  mesh.region_names = {{labels::lumen, "lumen"}};
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_MESH_3_H
