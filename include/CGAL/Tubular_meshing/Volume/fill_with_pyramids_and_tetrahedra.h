// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_PYRAMIDS_AND_TETRAHEDRA_H
#define CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_PYRAMIDS_AND_TETRAHEDRA_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Patches/surface_to_mixed_mesh.h>
#include <CGAL/Tubular_meshing/Volume/Volume_mesher.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/fill_keeping_boundary.h>
#include <CGAL/Tubular_meshing/Volume/internal/pyramids/Size_near_surface.h>
#include <CGAL/Tubular_meshing/Volume/internal/pyramids/crown_quads.h>
#include <CGAL/Tubular_meshing/Volume/internal/pyramids/optimize_with_apexes.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

inline void check_keeps_boundary(Volume_mesher mesher) {
  if (mesher == Volume_mesher::mesh_3)
    throw Meshing_error(
        "The tetrahedra between pyramids need a mesher that keeps their sides: build this program where CMake finds "
        "TetGen (libtet1.5-dev), or CGAL 6.1 or later, and choose one of these.");
}

inline Element_block<5> pyramids_on(const Element_block<4>& quads, std::size_t first_apex) {
  Element_block<5> pyramids;
  pyramids.reserve(quads.size());
  for (std::size_t k = 0; k < quads.size(); ++k) {
    const auto& q = quads.vertices[k]; // counterclockwise from outside, the pyramid's base from inside
    pyramids.push_back({q[0], q[3], q[2], q[1], std::uint32_t(first_apex + k)}, labels::lumen);
  }
  return pyramids;
}

// Fills what the pyramids leave with tetrahedra. Where pyramids meet, which make_room() leaves to chance in the
// narrowest gaps only, they make way for each other, and it is tried again.
template <class SizingField>
void fill_between_pyramids(Crowned_surface& crowned, const SizingField& size, Volume_mesher mesher,
                           const CGAL::Tubular_meshing::internal::Filling_limits& limits, Mixed_mesh& mesh) {
  (void)limits;
  const auto fill = [&] {
    if (mesher == Volume_mesher::ccdt)
#ifdef CGAL_TUBULAR_MESHING_WITH_CCDT
      return fill_keeping_boundary(crowned.surface(), crowned.patch(), size, run_ccdt, "CGAL", limits, mesh);
#else
      return fill_with_ccdt(crowned.surface(), crowned.patch(), size, mesh); // says why not
#endif
#ifdef CGAL_TUBULAR_MESHING_WITH_TETGEN
    fill_keeping_boundary(crowned.surface(), crowned.patch(), size, run_tetgen, "TetGen", limits, mesh);
#else
    fill_with_tetgen(crowned.surface(), crowned.patch(), size, mesh);
#endif
  };
  try {
    fill();
  } catch (const Meshing_error&) {
    if (!crowned.make_way())
      throw;
    fill();
  }
}

} // namespace internal

/*! \ingroup PkgTubularMeshingRef
 *
 * fills a closed labelled surface of triangles and quads, and keeps it as it is, facet for facet: a pyramid stands on
 * the inside of each quad (\cgalCite{owen1997}), and tetrahedra fill what is left (section 2.5 of the paper). A mesh of
 * the wall, of hexahedra on the same quads, conforms with it.
 *
 * Pyramids are about as high as makes their sides equilateral, and lower where the surface folds inward or where it is
 * near to itself, so that they meet nowhere. What they leave is filled as by fill_with_tetgen(), and optimized as by
 * optimize_tetrahedra(), together with the pyramids' apexes.
 *
 * \param surface a closed mesh of triangles and quads without self-intersections, its faces turned outward
 * \param patch a readable property map from its faces to `int`
 * \param size a model of `MeshDomainField_3`: the wanted length of edges; near the surface they are no longer than its
 *   own, if these are shorter. Must outlive the call only.
 * \param mesh is replaced: pyramids and tetrahedra of region labels::lumen, and the surface's faces. Its first points
 *   are the surface's, followed by the pyramids' apexes; its triangles and quads are the surface's faces, in their
 *   order and bit for bit; pyramid i stands on quad i.
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{volume_mesher} \cgalParamDescription{what makes the tetrahedra: `Volume_mesher::tetgen` or
 *     `Volume_mesher::ccdt`} \cgalParamDefault{default_volume_mesher()} \cgalParamNEnd
 *   \cgalParamNBegin{split_quads} \cgalParamDescription{whether quads on which no pyramid fits become two triangles
 *     each, which follow the surface's own in the mesh. No mesh of the wall conforms with these}
 *     \cgalParamDefault{`false`} \cgalParamNEnd
 *   \cgalParamNBegin{optimization_passes} \cgalParamDescription{see optimize_tetrahedra()} \cgalParamDefault{2}
 *     \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads} \cgalParamDescription{0 takes all cores; the result does not depend on it}
 *     \cgalParamDefault{0} \cgalParamNEnd
 *   \cgalParamNBegin{time_limit} \cgalParamDescription{see fill_with_tetgen()} \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * About linear in the number of cells.
 *
 * No pyramid fits on a quad that has a corner of about 180 degrees or more, in the plane or by being bent, as one with
 * two edges on the rim of a cap; nor where the surface meets itself.
 *
 * \throws Meshing_error if the surface is not closed, if no pyramid fits on a quad, or if the mesher of the tetrahedra
 *   fails or is not there
 */
template <class SizingField, class NamedParameters = CGAL::parameters::Default_named_parameters>
void fill_with_pyramids_and_tetrahedra(const Surface& surface, Face_patch_map patch, const SizingField& size,
                                       Mixed_mesh& mesh,
                                       const NamedParameters& np = CGAL::parameters::default_values()) {
  const Volume_mesher mesher = internal::choose(np, internal_np::volume_mesher, default_volume_mesher());
  internal::check_keeps_boundary(mesher);
  Mixed_mesh boundary;
  surface_to_mixed_mesh(surface, patch, boundary);
  internal::Crowned_surface crowned =
      internal::crown_quads(boundary, internal::choose(np, internal_np::split_quads, false));

  internal::Filling_limits limits = {
      internal::choose(np, internal_np::time_limit, 600 + 0.01 * double(num_faces(crowned.surface())))};
  limits.way_out = "mend the surface, or mesh it finer";
  Mixed_mesh result;
  const internal::Size_near_surface<SizingField> graded(size, boundary);
  internal::fill_between_pyramids(crowned, graded, mesher, limits, result);
  result.pyramids = internal::pyramids_on(boundary.quads, boundary.points.size());
  internal::optimize_with_apexes(result, internal::choose(np, internal_np::optimization_passes, 2),
                                 internal::choose(np, internal_np::number_of_threads, 0));
  result.triangles = std::move(boundary.triangles);
  result.quads = std::move(boundary.quads);
  mesh = std::move(result);
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_VOLUME_FILL_WITH_PYRAMIDS_AND_TETRAHEDRA_H
