// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_WALL_SAMPLES_H
#define CGAL_TUBULAR_MESHING_FIELDS_WALL_SAMPLES_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingFields
 * A place on a lumen's wall, and the lumen there. */
struct Wall_sample {
  Point_3 point;                ///< the middle of a facet
  Surface::Vertex_index vertex; ///< one of its corners
  double area;                  ///< of the wall that it stands for
  double radius;                ///< that a mesh size on the wall goes with; 0 if nothing of the wall lies opposite
};

/*! \ingroup PkgTubularMeshingFields
 *
 * Places spread evenly over a lumen's wall, with the radius that the lumen has there: enough to know how large all of it
 * is in units of a local mesh size, at a fraction of the cost of centerlines and of Shape_radius, which has balls at all
 * vertices. At each place there is a ball as that of Shape_radius, but for what that takes from its neighbours: the wall's
 * normals are averaged over some rings of neighbours, and of the balls at a vertex and at its neighbours the median is
 * taken. Centers of balls that none nearby rises above are the middles of vessels, and stand for centerlines: the radius
 * at a place is that of the nearest one, or the distance to it if that is larger.
 *
 * O(n log n) in the wall's vertices, with a small factor: 0.2 s for 400,000 triangles; and O(log n) each sample.
 *
 * \param surface the lumen, closed, turned outward
 * \param patch the labels of its faces: those that are not labels::wall are caps, and no wall
 * \param most how many there are to be; no more than there are faces
 * \param number_of_threads 0 takes all cores; the samples are the same on any number
 */
std::vector<Wall_sample> wall_samples(const Surface& surface, const Face_patch_map& patch, std::size_t most,
                                      int number_of_threads = 0);

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Fields/Wall_samples_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_FIELDS_WALL_SAMPLES_H
