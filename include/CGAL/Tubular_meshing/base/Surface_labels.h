// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_SURFACE_LABELS_H
#define CGAL_TUBULAR_MESHING_BASE_SURFACE_LABELS_H

#include <CGAL/Tubular_meshing/base/labels.h>

#include <optional>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingBase
 *
 * The labels that the faces of a surface have in its file: which face is which end of a vessel. What they mean is found
 * out by open_labelled_ends().
 */
struct Surface_labels {
  std::string source;      ///< what they are, for a report: `cell array ModelFaceID`, `solids`, …; empty: none
  std::string array;       ///< the name of the array, if they are one
  std::vector<int> label;  ///< one a triangle
  Label_names names;       ///< of the labels that have one
  std::optional<int> wall; ///< the label of the wall by the convention of this array, if it has one

  bool empty() const { return label.empty(); }
};

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_BASE_SURFACE_LABELS_H
