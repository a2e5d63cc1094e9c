// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_CURVATURE_H
#define CGAL_TUBULAR_MESHING_FIELDS_CURVATURE_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingFields
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

/*! \ingroup PkgTubularMeshingFields
 *
 * The options of compute_curvatures(): its named parameters.
 */
struct Compute_curvatures_options {
  std::function<double(const Point_3&)> local_radius;
  double smoothing_radius = 0.4;
  int number_of_threads = 0;

  Compute_curvatures_options() = default;
  template <class NamedParameters> explicit Compute_curvatures_options(const NamedParameters& np) {
    local_radius = internal::choose(np, internal_np::local_radius, local_radius);
    smoothing_radius = internal::choose(np, internal_np::smoothing_radius, smoothing_radius);
    number_of_threads = internal::choose(np, internal_np::number_of_threads, number_of_threads);
  }
};

namespace internal {

/* Some of a mesh's faces, the wall of a lumen as a rule, as plain arrays. */
struct Indexed_triangles {
  std::vector<Point_3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/* The faces for which `counts` holds; `vertices` becomes the mesh's vertices in the order of the points, which is that
 * in which the faces mention them. O(n). */
template <class TriangleMesh, class Counts, class NamedParameters>
Indexed_triangles
indexed_triangles(const TriangleMesh& mesh, const Counts& counts, const NamedParameters& np,
                  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>& vertices) {
  const auto points = core_points(mesh, np);
  std::unordered_map<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, std::uint32_t> index;
  index.reserve(num_vertices(mesh));
  Indexed_triangles result;
  for (auto f : faces(mesh)) {
    if (!counts(f))
      continue;
    result.triangles.emplace_back();
    auto h = halfedge(f, mesh);
    for (std::uint32_t& i : result.triangles.back()) {
      const auto v = target(h, mesh);
      const auto inserted = index.emplace(v, std::uint32_t(vertices.size()));
      if (inserted.second) {
        result.points.push_back(get(points, v));
        vertices.push_back(v);
      }
      i = inserted.first->second;
      h = next(h, mesh);
    }
  }
  return result;
}

/* One a point. */
std::vector<Vertex_curvature<Vector_3>> compute_curvatures(const Indexed_triangles& wall,
                                                           const Compute_curvatures_options& options);

} // namespace internal

/*! \ingroup PkgTubularMeshingFields
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
 * \tparam TriangleMesh a model of `FaceListGraph`, of any kernel
 * \param mesh a triangle mesh whose faces are turned outward
 * \param curvatures a writable property map from the mesh's vertices to `Vertex_curvature`; only vertices of faces that
 *   count are written
 * \param np an optional sequence of named parameters among the ones listed below, and CGAL's `vertex_point_map`
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{face_patch_map}
 *     \cgalParamDescription{only faces of labels::wall count, so that nothing is averaged across the rim of a cap}
 *     \cgalParamType{a readable property map from faces to `int`}
 *     \cgalParamDefault{all faces count}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{local_radius}
 *     \cgalParamDescription{a function object from points to the radius of the vessel there, safe to call from
 *       several threads}
 *     \cgalParamType{`std::function<double(Point_3)>`}
 *     \cgalParamDefault{none: nothing is averaged}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{smoothing_radius}
 *     \cgalParamDescription{how far away a vertex may be to be averaged with, relative to the local radius; 0 or
 *       more}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{0.4}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads}
 *     \cgalParamDescription{0 takes all cores; the result is the same on any number}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{0}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Parameter_error if `smoothing_radius` is out of its range
 */
template <class TriangleMesh, class CurvatureMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
void compute_curvatures(const TriangleMesh& mesh, CurvatureMap curvatures,
                        const NamedParameters& np = CGAL::parameters::default_values()) {
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor Face;
  typedef typename boost::property_traits<CurvatureMap>::value_type Curvature;
  typedef decltype(Curvature::normal) Vector;
  const auto patch =
      choose_parameter(get_parameter(np, internal_np::face_patch_map), Constant_property_map<Face, int>(labels::wall));
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices;
  const internal::Indexed_triangles wall = internal::indexed_triangles(
      mesh, [&](Face f) { return int(get(patch, f)) == labels::wall; }, np, vertices);
  const auto computed = internal::compute_curvatures(wall, Compute_curvatures_options(np));
  const auto vector = [](const Vector_3& v) { return Vector(v.x(), v.y(), v.z()); };
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vertex_curvature<Vector_3>& k = computed[i];
    put(curvatures, vertices[i],
        Curvature{vector(k.normal), k.min_curvature, k.max_curvature, vector(k.min_direction),
                  vector(k.max_direction)});
  }
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Fields/curvature_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_FIELDS_CURVATURE_H
