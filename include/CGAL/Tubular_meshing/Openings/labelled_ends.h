// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_LABELLED_ENDS_H
#define CGAL_TUBULAR_MESHING_OPENINGS_LABELLED_ENDS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Opening.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingOpenings
 * What became of a label: `count` is the number of openings that it has made or named; none, if it is wall. */
struct Understood_label {
  int label = 0;
  std::string name; ///< empty: it has none
  std::size_t count = 0;
  std::string reason; ///< why it, or a part of it, is wall although it looks like an end or is called so; else empty

  bool is_understood() const { return reason.empty(); }
  /// How a sentence calls it.
  std::string text() const { return name.empty() ? std::to_string(label) : "\"" + name + "\""; }
};

/*! \ingroup PkgTubularMeshingOpenings
 * The ends of vessels that the labels of a surface's faces mark and name. */
struct Labelled_ends {
  /// One of them. It is where the opening with the nearest centre is.
  struct End {
    Point_3 center;
    double radius = 0;
    int label = 0;
    std::string name; ///< the label's; `face_2` where label 2 has none; with a number where a label has several ends
  };

  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  std::vector<End> ends;
  std::size_t inlet = none; ///< among them, if a name says so
  std::string wall_name;    ///< of the one label of the wall; empty if it has none, or there are several
  std::optional<int> wall;  ///< that label, if it is one
  std::string source;       ///< what the labels come from
  std::string array;        ///< the cell array that they are, if they are one
  std::vector<Understood_label> labels;

  bool empty() const { return labels.empty(); }

  /// The index of the end of this name, or with this label as a number; `none` if there is none.
  std::size_t find(const std::string& name) const;

  /// For each opening the index of the end that it is, or `none`.
  std::vector<std::size_t> match(const std::vector<Opening>& openings) const;
};

/*! \ingroup PkgTubularMeshingOpenings
 *
 * The options of open_labelled_ends(): its named parameters of the same names. */
struct Labelled_ends_options {
  Label_names label_names;
  std::string label_source = "labels"; ///< for reports
  std::optional<int> wall_label;       ///< that of the wall; none: found by name, else the largest
  std::string inlet_name;              ///< the name of the inlet; empty: the one that begins with `inlet` or `inflow`

  Labelled_ends_options() = default;
  template <class NamedParameters> explicit Labelled_ends_options(const NamedParameters& np) {
    using internal::choose;
    label_names = choose(np, internal_np::label_names, label_names);
    label_source = choose(np, internal_np::label_source, label_source);
    wall_label = choose(np, internal_np::wall_label, wall_label);
    inlet_name = choose(np, internal_np::inlet_name, inlet_name);
  }
};

namespace internal {

Labelled_ends open_labelled_ends(Surface& surface, Face_patch_map label, const Labelled_ends_options& options);

/* Gives the openings the names of the ends that they are. */
void name_openings(std::vector<Opening>& openings, const Labelled_ends& ends);

} // namespace internal

/*!
 * \ingroup PkgTubularMeshingOpenings
 *
 * Opens a surface at the ends of vessels that labels of its faces mark: solids of an STL file, `ModelFaceID` of
 * SimVascular, `CellEntityIds` of VMTK, physical groups of Gmsh.
 *
 * The wall is the label that `wall_label` names, else those that are called so (wall, vessel, lumen), else the largest.
 * Each disk of faces of another label whose boundary is one loop on the wall, and which is smaller than the wall, is
 * an end: its faces are removed, whatever its bulge, so that find_openings() finds its rim, and close_openings() closes
 * it flat there. A label with the name of an end (inlet, outlet, inflow, outflow, cap, opening) needs no more than
 * this. Any other has to look like an end as well: the wall stands upright on its rim (by 41 degrees on average), it is
 * no wider than its rim (as a sac is), and has at most eight times the area that its rim bounds (a half ball has twice
 * it, a blind vessel more). What is not an end is wall; `Understood_label::reason` says why.
 *
 * Where the surface is open, a label with the name of an end that reaches one loop of the border names the opening
 * there; its faces stay.
 *
 * \param surface a triangle mesh, manifold. Faces are removed from it, and garbage is collected
 * \param label the label of each face
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{label_names}
 *     \cgalParamDescription{the names of labels}
 *     \cgalParamType{`Label_names`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{wall_label}
 *     \cgalParamDescription{the label of the wall}
 *     \cgalParamType{int}
 *     \cgalParamDefault{found by name, else the largest}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{inlet_name}
 *     \cgalParamDescription{the name of the inlet, or its label as a number}
 *     \cgalParamType{`std::string`}
 *     \cgalParamDefault{the first name that begins with `inlet` or `inflow`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{label_source}
 *     \cgalParamDescription{what the labels are, for reports}
 *     \cgalParamType{`std::string`}
 *     \cgalParamDefault{`labels`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the ends, and what became of each label. If all faces have one label it is empty, and nothing is done
 *
 * \throws Parameter_error if there is no end called `inlet_name`; it names those that there are
 *
 * Complexity: O(n) in the number of faces (expected).
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
Labelled_ends open_labelled_ends(Surface& surface, Face_patch_map label,
                                 const NamedParameters& np = CGAL::parameters::default_values()) {
  return internal::open_labelled_ends(surface, label, Labelled_ends_options(np));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Openings/labelled_ends_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_OPENINGS_LABELLED_ENDS_H
