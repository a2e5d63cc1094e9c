// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_CARRY_LABELS_H
#define CGAL_TUBULAR_MESHING_REPAIR_CARRY_LABELS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingRepair
 *
 * Gives the faces of a repaired surface the labels of the triangles that it was made from: a face with the corners of
 * one has that one's label, any other (that the repair has made) has the label of the triangle nearest to its centre;
 * but where such faces would be no more than a fragment of a region, as at the ragged rim of a cap that was replaced,
 * they have the label around them.
 *
 * \param points, triangles the soup that repair_surface() was given
 * \param labels one a triangle
 * \param surface what repair_surface() has made of them
 * \param label receives the labels
 *
 * O(n), and O(log n) for each face that the repair has made.
 */
void carry_labels(const std::vector<Point_3>& points, const std::vector<std::array<std::size_t, 3>>& triangles,
                  const std::vector<int>& labels, const Surface& surface, Face_patch_map label);

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Repair/carry_labels_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_REPAIR_CARRY_LABELS_H
