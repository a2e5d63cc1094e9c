// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_SURFACE_H
#define CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_SURFACE_H

#include <CGAL/Tubular_meshing/Generators/Tubular_skeleton.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <utility>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingGenerators
 * How the rim of a generated opening leaves its plane. */
enum class Sag_shape {
  saddle, ///< twice up and twice down around the rim, by cos(2a)
  tilt    ///< an oblique ellipse, by cos(a)
};

/*! \ingroup PkgTubularMeshingGenerators
 *
 * The options of generate_tubular_surface(): its named parameters of the same names. */
struct Generate_tubular_surface_options {
  double points_per_circumference = 24;
  bool capped_ends = false;
  bool round_ends = false;
  double noise = 0; ///< of the radius
  unsigned noise_seed = 0;
  double sag = 0; ///< of the radius
  Sag_shape sag_shape = Sag_shape::saddle;

  Generate_tubular_surface_options() = default;
  template <class NamedParameters>
  explicit Generate_tubular_surface_options(const NamedParameters& np)
      : points_per_circumference(internal::choose(np, internal_np::points_per_circumference, 24.))
      , capped_ends(internal::choose(np, internal_np::capped_ends, false))
      , round_ends(internal::choose(np, internal_np::round_ends, false))
      , noise(internal::choose(np, internal_np::noise, 0.))
      , noise_seed(internal::choose(np, internal_np::noise_seed, 0u))
      , sag(internal::choose(np, internal_np::sag, 0.))
      , sag_shape(internal::choose(np, internal_np::sag_shape, Sag_shape::saddle)) {}
};

namespace internal {

Surface generate_tubular_surface(const Tubular_skeleton& skeleton, const Generate_tubular_surface_options& options);

} // namespace internal

/*! \ingroup PkgTubularMeshingGenerators
 *
 * Makes a smooth triangulated surface around a skeleton: the zero surface of its Tubular_distance_function, cut off at
 * the ends by the planes through the end nodes, perpendicular to the centerline.
 *
 * Away from junctions each vertex is exactly (to 1e-9) at the skeleton's radius from the centerline; junctions are
 * filleted. Triangles are nearly equilateral, and their size is proportional to the local radius. The surface is an
 * orientable manifold, oriented outwards, with a circular planar rim at each end, or closed by a flat cap there. It
 * does not intersect itself as long as branches that do not share a node keep half a radius apart.
 *
 * \tparam TriangleMesh a model of `MutableFaceGraph`
 *
 * \param skeleton the nodes, branches and radii
 * \param out replaced by the surface
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{points_per_circumference}
 *     \cgalParamDescription{n, from 8 to 1000: edges are \f$ 2 \pi r / n \f$ long on average, r being the local radius}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{24}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{capped_ends}
 *     \cgalParamDescription{whether ends are closed by planar triangulated caps}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{round_ends}
 *     \cgalParamDescription{whether ends are closed by half balls around the end nodes, as those of segmented vessels
 *       are; then there are no openings, and `capped_ends` and `sag` have nothing to do}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{noise}
 *     \cgalParamDescription{amplitude of a random displacement of each vertex along the normal, as a fraction of the
 * local radius, at most 1, uniformly distributed; rims stay planar, caps flat} \cgalParamType{`double`}
 *     \cgalParamDefault{0}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{noise_seed}
 *     \cgalParamDescription{the same seed gives the same noise}
 *     \cgalParamType{`unsigned`}
 *     \cgalParamDefault{0}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{sag}
 *     \cgalParamDescription{how far rims, with the caps, leave their planes, as a fraction of the radius, at most 0.5;
 * the wall follows within two radii} \cgalParamType{`double`} \cgalParamDefault{0} \cgalParamNEnd
 *   \cgalParamNBegin{sag_shape}
 *     \cgalParamDescription{how they leave them}
 *     \cgalParamType{Sag_shape}
 *     \cgalParamDefault{`Sag_shape::saddle`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the vertices of `out`}
 *     \cgalParamType{a model of `WritablePropertyMap`}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, out)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Input_error if the skeleton is not consistent
 * \throws Parameter_error for values out of range
 * \throws Meshing_error if an end cannot be cut open, as another branch goes through it
 *
 * Complexity: O(t log n) for t triangles and n points of the skeleton.
 */
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
void generate_tubular_surface(const Tubular_skeleton& skeleton, TriangleMesh& out,
                              const NamedParameters& np = CGAL::parameters::default_values()) {
  Surface surface = internal::generate_tubular_surface(skeleton, Generate_tubular_surface_options(np));
  if constexpr (internal::is_core_surface<TriangleMesh, NamedParameters>)
    out = std::move(surface);
  else
    internal::copy_from_core(surface, out, np);
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Generators/tubular_surface_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_SURFACE_H
