// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_CROSS_SECTIONS_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_CROSS_SECTIONS_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingCenterlines
 * What a plane across a branch cuts out of the lumen: the loop of the wall round the centerline. */
struct Cross_section {
  std::size_t branch = 0;
  double abscissa = 0; ///< along the branch, from its source
  Point_3 point;       ///< of the centerline there
  Vector_3 normal;     ///< unit, along the branch
  Point_3 center;      ///< centroid of the section's area; the point, where there is no section
  double area = 0;     ///< 0 where the plane meets no closed loop of the wall round the point
  double perimeter = 0;
  double inscribed_radius = 0; ///< of the centerline there: its points' radius, linear between them
  double eccentricity = 0; ///< of the ellipse with the same second moments of area: 0 of a disk, towards 1 of a slit
  double curvature = 0;    ///< of the centerline, 1 / length
  double torsion = 0;      ///< of the centerline, 1 / length; positive of a right-handed helix, 0 where it is straight

  /// Of the disk of the same area.
  double radius() const;
  /// 4 area / perimeter; 0 where there is no section.
  double hydraulic_diameter() const;
};

/*! \ingroup PkgTubularMeshingCenterlines
 *
 * cuts a lumen by planes across its branches, from each branch's source to its target. Planes are perpendicular to the
 * branch as it runs over one local radius; the first and the last are half the spacing from the branch's ends, so that
 * none lies in a flat cap. In and near a bifurcation a plane cuts several vessels where they are one: sections are large
 * there.
 *
 * Curvature and torsion are those of the polynomials of degree 4 that fit the branch best over two local radii to each
 * side; where the radius of curvature is more than 50 local radii, the torsion is 0.
 *
 * \param surface the lumen's surface, closed, of triangles
 * \param graph its branches, with radii
 * \param spacing of the planes, in local radii
 * \param number_of_threads 0: all cores. The result does not depend on it
 *
 * O(log n + m) a section, m the triangles that it cuts; a branch of length l and radius r has about l / (r `spacing`).
 *
 * \throws Parameter_error if the spacing is less than 0.01, or no number
 */
std::vector<Cross_section> cross_sections(const Surface& surface, const Centerline_graph& graph, double spacing = 0.5,
                                          int number_of_threads = 0);

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Centerlines/cross_sections_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_CROSS_SECTIONS_H
