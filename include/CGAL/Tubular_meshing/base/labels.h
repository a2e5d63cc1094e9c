// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_LABELS_H
#define CGAL_TUBULAR_MESHING_BASE_LABELS_H

#include <map>
#include <set>
#include <string>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingBase
 *
 * The integers that tell volume cells (regions) and boundary facets (patches) apart, in memory and in every file. */
namespace labels {

// regions
constexpr int lumen = 1;
constexpr int wall_region = 2; ///< further wall layers count on from here

// patches
constexpr int wall = 1; ///< the lumen's surface; the interface, where there is a wall region
constexpr int inlet = 2;
constexpr int first_outlet = 3;
constexpr int outer_wall = 100;
constexpr int middle_wall = 101; ///< the interface, where there are two walls
constexpr int inlet_ring = 102;
constexpr int first_outlet_ring = 103;

/*! The patch of opening `i`: 0 is the inlet, `i` > 0 is outlet `i`. */
constexpr int of_opening(int i) {
  return inlet + i;
}

/*! What labels::outer_wall, 100, is where the lumen's own patches have labels up to `largest`: the next power of ten
 * where they would clash, as those of more than 98 openings do. The wall's other patches count on from it, as they do
 * from 100: middle_wall comes next, and the ring of the opening `patch` has the label outer_wall_for(largest) +
 * `patch`.
 */
constexpr int outer_wall_for(int largest) {
  return largest < outer_wall ? outer_wall : 10 * outer_wall_for(largest / 10);
}

} // namespace labels

/*! \ingroup PkgTubularMeshingBase
 * From label to name, e.g. 2 → "inlet". */
typedef std::map<int, std::string> Label_names;

/*! \ingroup PkgTubularMeshingBase
 * The names of the lumen's patches for a number of openings: wall, inlet, outlet_1, outlet_2, … */
inline Label_names lumen_patch_names(int number_of_openings) {
  Label_names names = {{labels::wall, "wall"}};
  for (int i = 0; i < number_of_openings; ++i)
    names[labels::of_opening(i)] = i == 0 ? std::string("inlet") : "outlet_" + std::to_string(i);
  return names;
}

/*! \ingroup PkgTubularMeshingBase
 *
 * The numbers that patches had in the cell array of the input that they come from: files that can hold it get that
 * array back, beside their own labels. */
struct Patch_ids {
  std::string array;     ///< its name, as `ModelFaceID`; empty: there is none
  std::map<int, int> id; ///< of each patch that had one

  bool empty() const { return array.empty() || id.empty(); }
};

/*! \ingroup PkgTubularMeshingBase
 * A name that is not among others yet: the one wanted, or with the first number behind it that makes it one. */
inline std::string unused_name(const std::string& wanted, const std::set<std::string>& used) {
  std::string name = wanted;
  for (int i = 2; used.count(name) != 0; ++i)
    name = wanted + "_" + std::to_string(i);
  return name;
}

/*! \ingroup PkgTubularMeshingBase
 * The name of the ring of a wall round the opening of a name: inlet_ring, outlet_ring_1; aorta_ring, if it has a name
 * of its own. */
inline std::string ring_name(int patch, const std::string& opening) {
  const std::string number = std::to_string(patch - labels::inlet);
  return opening == "outlet_" + number ? "outlet_ring_" + number : opening + "_ring";
}

/*! \ingroup PkgTubularMeshingBase
 * Adds the names of a wall's patches to those of the lumen's: outer_wall, inlet_ring, outlet_ring_1, …; a name that an
 * opening has already gets a number.
 * \param names those of the lumen's patches, with all openings
 * \param second_wall whether there is a middle_wall */
inline void add_wall_patch_names(Label_names& names, bool second_wall) {
  const int outer = labels::outer_wall_for(names.empty() ? labels::wall : names.rbegin()->first);
  std::set<std::string> used;
  for (const auto& name : names)
    used.insert(name.second);
  Label_names added;
  const auto add = [&](int label, const std::string& name) { used.insert(added[label] = unused_name(name, used)); };
  add(outer, "outer_wall");
  if (second_wall)
    add(outer + 1, "middle_wall");
  for (const auto& name : names)
    if (name.first >= labels::inlet)
      add(outer + name.first, ring_name(name.first, name.second));
  names.insert(added.begin(), added.end());
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_BASE_LABELS_H
