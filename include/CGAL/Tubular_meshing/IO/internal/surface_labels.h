// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_SURFACE_LABELS_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_SURFACE_LABELS_H

#include <CGAL/Tubular_meshing/IO/internal/Input_file.h>
#include <CGAL/Tubular_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Tubular_meshing/IO/internal/Text_cursor.h>
#include <CGAL/Tubular_meshing/base/Surface_labels.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

inline bool are_labels(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double x) { return std::abs(x) < 1e9 && x == std::floor(x); });
}

inline bool has_two_labels(const std::vector<int>& labels) {
  return std::any_of(labels.begin(), labels.end(), [&](int l) { return l != labels.front(); });
}

// The label of each triangle, where there is a label of each cell.
inline std::vector<int> labels_of_triangles(const Polygon_soup& soup, const std::vector<std::size_t>& polygon,
                                            const std::vector<double>& of_cell) {
  std::vector<int> labels;
  for (std::size_t p : polygon)
    if (soup.cell_of(p) < of_cell.size())
      labels.push_back(static_cast<int>(of_cell[soup.cell_of(p)]));
  if (labels.size() != polygon.size())
    labels.clear();
  return labels;
}

// What a convention says about the wall: the smallest of VMTK's labels, which is 0 or 1; the first of this package's.
inline std::optional<int> wall_by_convention(const std::string& array, const std::vector<int>& labels) {
  const int smallest = *std::min_element(labels.begin(), labels.end());
  if ((array == "CellEntityIds" || array == "CapID") && smallest <= 1)
    return smallest;
  if (array == "patch" && smallest == labels::wall)
    return smallest;
  return std::nullopt;
}

// As this package numbers its patches: wall, inlet, outlet_1, …; of those that are there, since a file may hold any number.
inline Label_names names_of_patches_used(const std::vector<int>& used) {
  Label_names names;
  for (int label : std::set<int>(used.begin(), used.end()))
    names[label] = label == labels::wall    ? std::string("wall")
                   : label == labels::inlet ? std::string("inlet")
                                            : "outlet_" + std::to_string(label - labels::inlet);
  return names;
}

inline Surface_labels labels_by_array(const Polygon_soup& soup, const std::vector<std::size_t>& polygon,
                                      const std::string& name) {
  Surface_labels result;
  const auto array = soup.cell_arrays.find(name);
  if (array == soup.cell_arrays.end() || !are_labels(array->second))
    return result;
  result.label = labels_of_triangles(soup, polygon, array->second);
  if (result.empty() || !has_two_labels(result.label))
    return Surface_labels();
  result.source = "cell array " + name;
  result.array = name;
  result.wall = wall_by_convention(name, result.label);
  result.names =
      name == "patch" && soup.names.empty() && result.wall ? names_of_patches_used(result.label) : soup.names;
  return result;
}

inline Surface_labels labels_asked_for(const Polygon_soup& soup, const std::vector<std::size_t>& polygon,
                                       const std::string& name, const Input_file& file) {
  if (soup.cell_arrays.count(name) == 0) {
    std::string known;
    for (const auto& a : soup.cell_arrays)
      known += (known.empty() ? "" : ", ") + a.first;
    file.fail("has no cell array " + printable(name) +
              (known.empty() ? " of one number a cell, nor any other" : "; it has " + known));
  }
  if (!are_labels(soup.cell_arrays.at(name)))
    file.fail("cannot be used so: not all values of its cell array " + printable(name) + " are integers");
  Surface_labels labels = labels_by_array(soup, polygon, name);
  if (labels.empty())
    file.fail("cannot be used so: its cell array " + printable(name) + " has the same value everywhere");
  return labels;
}

// The labels of the triangles; none, where there are not two.
inline Surface_labels surface_labels(const Polygon_soup& soup, const std::vector<std::size_t>& polygon,
                                     const std::string& asked_for, const Input_file& file) {
  if (!asked_for.empty())
    return labels_asked_for(soup, polygon, asked_for, file);
  Surface_labels result;
  if (!soup.groups.empty())
    for (std::size_t p : polygon)
      result.label.push_back(soup.groups[p]);
  if (!result.empty() && has_two_labels(result.label)) {
    result.source = soup.group_kind;
    result.names = soup.names;
    return result;
  }
  for (const char* name : {"ModelFaceID", "CapID", "CellEntityIds", "patch", "gmsh:physical", "medit:ref"}) {
    result = labels_by_array(soup, polygon, name);
    if (!result.empty())
      return result;
  }
  return Surface_labels();
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_SURFACE_LABELS_H
