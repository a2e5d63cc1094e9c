// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "layers.h"

#include "tubular_mesh/walls.h"

#include <CGAL/Tubular_meshing/Layers/Wall_materials.h>

#include <cstddef>
#include <cstdio>
#include <map>
#include <string>
#include <utility>

namespace tubular = CGAL::Tubular_meshing;

void add_layers(Json& report, const char* name, const tubular::Layer_report& layers) {
  report[name] = {{"vertices", layers.vertices},
                  {"reduced_vertices", layers.reduced_vertices},
                  {"min_ratio", layers.min_ratio},
                  {"mean_ratio", layers.mean_ratio},
                  {"steep_vertices", layers.steep_vertices},
                  {"worst_place", vector_of(layers.worst_place)},
                  {"sentence", layers.text()}};
}

void add_materials(Json& report, const tubular::Mixed_mesh& mesh) {
  std::map<int, std::size_t> cells = cells_by_region(mesh);
  Json list = Json::array();
  for (const auto& name : mesh.region_names)
    if (name.first == tubular::labels::wall_region || name.first >= tubular::labels::first_material)
      list.push_back({{"region", name.first}, {"name", name.second}, {"cells", cells[name.first]}});
  report["materials"] = list;
}

void print_layers(const Json& r) {
  for (const auto& layers : {std::make_pair("wall", "wall"), std::make_pair("boundary_layer", "boundary layer")})
    if (r.contains(layers.first))
      std::printf("%s: %s\n", layers.second, r[layers.first]["sentence"].get<std::string>().c_str());
}

void print_materials(const Json& materials) {
  std::string text;
  for (const auto& m : materials)
    text += (text.empty() ? "" : ", ") + m["name"].get<std::string>() + " " + std::to_string(m["cells"].get<long>()) +
            " cells";
  std::printf("materials of the wall: %s\n", text.c_str());
}
