// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_CURVATURE_H
#define CGAL_TUBULAR_MESHING_FIELDS_CURVATURE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Fields/internal/Curvature_estimator.h>
#include <CGAL/Tubular_meshing/Fields/internal/Indexed_wall.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 *
 * The curvature of a surface at a vertex. Curvatures are in one over the unit of length, and positive where the surface
 * is convex, seen from the side its normals point to: 1/r round a vessel of radius r, negative along the inner side of
 * its bends.
 *
 * \tparam Vector_3 a model of `Vector_3`
 */
template <class Vector_3> struct Vertex_curvature {
  Vector_3 normal = Vector_3(0, 0, 0); ///< of unit length; zero where the vertex has no face that counts
  double min_curvature = 0, max_curvature = 0;
  Vector_3 min_direction = Vector_3(0, 0, 0); ///< a unit vector in the tangent plane
  Vector_3 max_direction = Vector_3(0, 0, 0); ///< perpendicular to it

  /// The normal curvature in the direction of the tangent vector `v`, of any length but zero (Euler's formula).
  double along(const Vector_3& v) const {
    const double a = v * min_direction, b = v * max_direction;
    return (min_curvature * a * a + max_curvature * b * b) / (a * a + b * b);
  }
};

namespace internal {

template <class Vector_3> Vertex_curvature<Vector_3> principal(const Shape_tensor& k, const Tangent_frame& f) {
  const double mean = (k.uu + k.vv) / 2, d = (k.uu - k.vv) / 2, radius = std::hypot(d, k.uv);
  const double angle = radius > 0 ? std::atan2(k.uv, d) / 2 : 0; // of the direction of larger curvature
  const double c = std::cos(angle), s = std::sin(angle);
  const auto vector = [](const Vector_3d& v) { return Vector_3(v.x, v.y, v.z); };
  return {vector(f.n), mean - radius, mean + radius, vector(c * f.v + (-s) * f.u), vector(c * f.u + s * f.v)};
}

} // namespace internal

/*! \ingroup PkgTubularMeshingRef
 *
 * computes normals, principal curvatures and their directions at the vertices of a triangulated surface, open or
 * closed, by the tensors of its faces \cgalCite{rusinkiewicz2004}, and averages them against noise over a neighborhood
 * that is relative to the vessel's radius.
 *
 * Where vertices lie on a smooth surface and nothing is averaged, the error falls with the square of the length of
 * regular meshes' edges. Averaging within the default radius leaves the curvatures of a torus of radii 3 and 1 within
 * two percent of the larger one. At the rim of the faces that count, where normals are one-sided, the curvature is that
 * of the vertices next to it. O(n) for n faces; averaging, the longest part, runs on several threads.
 *
 * \param mesh a triangle mesh whose faces are turned outward
 * \param curvatures a writable property map from the mesh's vertices to `Vertex_curvature`; only vertices of faces that
 *   count are written
 * \param np an optional sequence of named parameters among the ones listed below, and CGAL's `vertex_point_map`
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{face_patch_map} \cgalParamDescription{a readable property map from faces to `int`: only those of
 *     labels::wall count, so that nothing is averaged across the rim of a cap} \cgalParamDefault{all faces count}
 *     \cgalParamNEnd
 *   \cgalParamNBegin{local_radius} \cgalParamDescription{a function object from points to the radius of the vessel
 *     there, safe to call from several threads: a `std::function<double(Point)>`} \cgalParamDefault{none: nothing is
 *     averaged} \cgalParamNEnd
 *   \cgalParamNBegin{smoothing_radius} \cgalParamDescription{how far away a vertex may be to be averaged with, relative
 *     to the local radius; 0 or more} \cgalParamDefault{0.4} \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads} \cgalParamDescription{0 takes all cores; the result is the same on any number}
 *     \cgalParamDefault{0} \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Parameter_error if `smoothing_radius` is out of its range
 */
template <class TriangleMesh, class CurvatureMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
void compute_curvatures(const TriangleMesh& mesh, CurvatureMap curvatures,
                        const NamedParameters& np = CGAL::parameters::default_values()) {
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor Vertex;
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor Face;
  typedef typename boost::property_traits<CurvatureMap>::value_type Curvature;
  auto vpm = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                              get_const_property_map(CGAL::vertex_point, mesh));
  typedef typename boost::property_traits<decltype(vpm)>::value_type Point_3;
  const auto patch =
      choose_parameter(get_parameter(np, internal_np::face_patch_map), Constant_property_map<Face, int>(labels::wall));
  const auto radius = internal::choose(np, internal_np::local_radius, std::function<double(const Point_3&)>());
  const double smoothing = internal::choose(np, internal_np::smoothing_radius, 0.4);
  const int threads = internal::choose(np, internal_np::number_of_threads, 0);
  if (!(smoothing >= 0 && smoothing <= 1e6))
    throw Parameter_error("The smoothing radius of curvatures is " + std::to_string(smoothing) +
                          ": give a part of the vessel's radius, at least 0; 0.4 is usual.");

  std::vector<Vertex> vertices;
  const internal::Indexed_wall wall(
      mesh, vpm, [&](Face f) { return int(get(patch, f)) == labels::wall; }, vertices);
  std::vector<double> reach;
  if (radius && smoothing > 0) {
    reach.resize(vertices.size());
    internal::for_each_range(vertices.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v)
        reach[v] = smoothing * radius(get(vpm, vertices[v]));
    });
  }
  const internal::Curvature_estimator estimator(wall, reach, threads);
  for (std::size_t v = 0; v < vertices.size(); ++v)
    put(curvatures, vertices[v],
        internal::principal<decltype(Curvature::normal)>(estimator.tensors()[v], estimator.frames()[v]));
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_FIELDS_CURVATURE_H
