// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_WALL_MATERIALS_IMPL_H
#define CGAL_TUBULAR_MESHING_LAYERS_WALL_MATERIALS_IMPL_H

#include <CGAL/Tubular_meshing/Layers/Wall_materials.h>
#include <CGAL/Tubular_meshing/Layers/internal/Located_triangles.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing {
namespace internal {

inline int material_of(const Wall_array& array, double value, std::size_t point) {
  if (!(std::abs(value) < 1e9) || value != std::floor(value))
    throw Input_error("The array \"" + array.name + "\" says the materials of the wall, but has the value " +
                      std::to_string(value) + " at " + place_of(array.points[point]) + ", which is no integer.");
  return int(value);
}

// Those on the triangles.
inline std::set<int> materials_in(const Wall_array& array) {
  std::set<int> materials;
  for (std::size_t i = 0; i < array.triangles.size(); ++i)
    if (array.of == Array_of::triangles)
      materials.insert(material_of(array, array.values[i], array.triangles[i][0]));
    else
      for (std::size_t v : array.triangles[i])
        materials.insert(material_of(array, array.values[v], v));
  return materials;
}

inline std::string name_of_material(int material, const Label_names& names) {
  const auto found = names.find(material);
  return found == names.end() ? std::string() : found->second;
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Wall_materials materials_of_array(const Wall_array& array, const Label_names& names) {
  Wall_materials result;
  const auto region = std::make_shared<std::map<int, int>>();
  std::set<std::string> used = {"lumen", "wall", "second_wall"};
  int next = labels::first_material;
  for (int material : internal::materials_in(array)) {
    const std::string name = internal::name_of_material(material, names);
    const bool is_wall = name.empty() ? material == 0 : name == "wall";
    (*region)[material] = is_wall ? labels::wall_region : next;
    if (is_wall)
      continue;
    used.insert(result.names[next] =
                    unused_name(name.empty() ? array.name + "_" + std::to_string(material) : name, used));
    ++next;
  }
  const auto located = std::make_shared<const internal::Located_triangles>(array);
  const auto values = std::make_shared<const std::vector<double>>(array.values);
  const bool is_of_points = array.of == Array_of::points;
  result.region = [located, values, region, is_of_points](const Point_3& p) {
    const auto place = (*located)(p);
    std::size_t i = place.triangle;
    if (is_of_points) {
      const auto nearest = std::max_element(place.weights.begin(), place.weights.end());
      i = located->corners(i)[std::size_t(nearest - place.weights.begin())];
    }
    return region->at(int((*values)[i]));
  };
  return result;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_LAYERS_WALL_MATERIALS_IMPL_H
