// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_GENERATORS_BRONCHIAL_TREE_H
#define CGAL_TUBULAR_MESHING_GENERATORS_BRONCHIAL_TREE_H

#include <CGAL/Tubular_meshing/Generators/Tubular_skeleton.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <cstddef>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingGenerators
 *
 * A bronchial tree after Weibel \cgalCite{weibel1963}: each branch divides into two, radii and lengths shrink by
 * 2^(-1/3) a generation, and planes of bifurcation turn. The radius of the trachea is 9. Branches that do not share a
 * node keep a third of their diameters apart or more.
 *
 * \param number_of_branches odd, as each bifurcation adds two; generation after generation is filled, so that
 *        2^(g+1) - 1 branches are g + 1 complete generations (305: eight of them and a part of the ninth), up to some
 *        thousands, where single branches remain ends for want of room
 * \exception Parameter_error if it is even or zero, or too large for the room there is
 */
Tubular_skeleton bronchial_tree(std::size_t number_of_branches);

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Generators/bronchial_tree_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_GENERATORS_BRONCHIAL_TREE_H
