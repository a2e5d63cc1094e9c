// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_SHAPES_H
#define CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_SHAPES_H

#include <CGAL/Tubular_meshing/Generators/Tubular_skeleton.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <CGAL/number_type_config.h>

namespace CGAL::Tubular_meshing {

/*! \addtogroup PkgTubularMeshingRef
 * @{
 * \name Ready-made skeletons
 * Lengths are in millimetres where they are not given: nothing in the package depends on it.
 * \{ */

/*! A cylinder along the z-axis, from the origin. */
Tubular_skeleton straight_tube(double length = 10, double radius = 1);

/*! A torus' part: `angle` radians of a circle of radius `bend_radius` in the plane y = 0, around the origin. */
Tubular_skeleton curved_tube(double bend_radius = 5, double angle = CGAL_PI / 2, double radius = 1);

/*! A tube of radius 1 that divides into two of radius 0.8 and 0.7: three branches, three openings. */
Tubular_skeleton y_bifurcation();

/*! An aortic arch: ascending part, arch with three branches on its top, descending part. Seven branches, one inlet,
 * four outlets, as in the paper's figure 2; radii from 14 to 3.5. */
Tubular_skeleton aortic_arch();

/*! A loop like the circle of Willis: a ring of seven arcs with a basilar inlet and six outlets. Fourteen branches,
 * seven openings, one loop; radii from 1.6 to 1. */
Tubular_skeleton willis_loop();

/*! \} */
/*! @} */

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Generators/tubular_shapes_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_SHAPES_H
