// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "walls.h"

#include "../command_line/Points.h"

#include <CGAL/Tubular_meshing/Layers/wall_fibres.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <array>
#include <cstddef>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace tubular = CGAL::Tubular_meshing;

namespace {

// That of the cells, if there are two of a name.
tubular::Wall_array array_named(const std::string& name, const tubular::IO::Surface_data& data) {
  tubular::Wall_array array;
  array.name = name;
  array.points = data.points;
  array.triangles = data.triangles;
  const auto cells = data.cell_arrays.find(name), points = data.point_arrays.find(name);
  if (cells != data.cell_arrays.end()) {
    array.of = tubular::Array_of::triangles;
    array.values = cells->second;
  } else if (points != data.point_arrays.end()) {
    array.values = points->second;
  } else {
    std::string known;
    add_names_of(data.cell_arrays, known);
    add_names_of(data.point_arrays, known);
    throw tubular::Input_error("The surface has no array \"" + name + "\" of one number a cell or a point" +
                               (known.empty() ? ", nor any other." : "; it has " + known + "."));
  }
  return array;
}

// A line of a table, which is about `place`: "Line 3 of …".
void read_thickness(std::string line, const std::string& place, Wall_requests& requests) {
  std::array<double, 2> x = {};
  const bool is_of_others = line.front() == '*';
  if (is_of_others)
    line.front() = '0';
  if (!command_line::parse_numbers(line, x) || !(x[0] >= 0 && x[0] < 1e9) || x[0] != double(std::size_t(x[0])) ||
      (is_of_others && x[0] != 0))
    throw tubular::Input_error(place + " is not a branch and a thickness; two numbers apart by a comma are, or * for "
                                       "all other branches.");
  if (!(x[1] > 0))
    throw tubular::Input_error(place + " has a thickness that is not above 0; a wall is thicker than 0 everywhere.");
  const bool is_new =
      is_of_others ? requests.of_other_branches == 0 : requests.of_branches.emplace(std::size_t(x[0]), x[1]).second;
  if (!is_new)
    throw tubular::Input_error(place + " names " +
                               (is_of_others ? "all other branches, which have"
                                             : "branch " + std::to_string(std::size_t(x[0])) + ", which has") +
                               " a thickness already.");
  if (is_of_others)
    requests.of_other_branches = x[1];
}

// A branch and its thickness a line, apart by a comma; * for all others. The first line may be a heading.
void read_table(const std::string& file, Wall_requests& requests) {
  std::ifstream in(file);
  if (!in)
    throw tubular::Input_error("The file \"" + file + "\" cannot be read.");
  std::string line;
  for (int number = 1, lines = 0; std::getline(in, line); ++number) {
    if (number == 1 && line.compare(0, 3, "\xef\xbb\xbf") == 0) // that begins files of spreadsheets
      line.erase(0, 3);
    line.erase(0, line.find_first_not_of(" \t\r"));
    if (line.empty() || line[0] == '#')
      continue;
    const bool is_heading = lines++ == 0 && std::string("+-.0123456789*").find(line[0]) == std::string::npos;
    if (!is_heading)
      read_thickness(line, "Line " + std::to_string(number) + " of \"" + file + "\"", requests);
  }
  if (requests.of_branches.empty() && requests.of_other_branches == 0)
    throw tubular::Input_error("The file \"" + file + "\" has no branch and no thickness.");
}

std::vector<const tubular::Labelled_surface*> surfaces_of(const std::vector<Part>& parts) {
  std::vector<const tubular::Labelled_surface*> surfaces;
  for (const Part& part : parts)
    surfaces.push_back(&part.run.model);
  return surfaces;
}

// Those of the branches from `before` on, by their numbers in the vessel.
std::map<std::size_t, double> part_of(const std::map<std::size_t, double>& table, std::size_t before,
                                      std::size_t number) {
  std::map<std::size_t, double> part;
  for (auto t = table.lower_bound(before); t != table.end() && t->first < before + number; ++t)
    part.emplace(t->first - before, t->second);
  return part;
}

void check_table(const Wall_requests& requests, std::size_t number) {
  if (!requests.of_branches.empty() && requests.of_branches.rbegin()->first >= number)
    throw tubular::Input_error("There is no branch " + std::to_string(requests.of_branches.rbegin()->first) +
                               " to have a thickness: there are " + std::to_string(number) + ", counted from 0.");
  for (std::size_t b = 0; b < number && requests.of_other_branches == 0; ++b)
    if (requests.of_branches.count(b) == 0)
      throw tubular::Input_error(
          "Branch " + std::to_string(b) + " has no thickness: there are " + std::to_string(number) +
          " branches, counted from 0, and each needs one; a line *,THICKNESS is for all others.");
}

void distribute_table(Run& run, std::vector<Part>& parts) {
  std::size_t before = 0;
  for (const Part& part : parts)
    before += part.run.model.centerlines.branches().size();
  check_table(run.walls, before);
  before = 0;
  for (Part& part : parts) {
    const tubular::Centerline_graph& graph = part.run.model.centerlines;
    const std::size_t number = graph.branches().size();
    part.run.walls.thickness = tubular::thickness_of_branches(graph, part_of(run.walls.of_branches, before, number),
                                                              run.walls.of_other_branches);
    before += number;
  }
}

// The names that the file has for the values of an array.
tubular::Label_names names_of_materials(const Options& o, const tubular::IO::Surface_data& data) {
  const bool is_of_labels = o.material_array == data.labels.array || o.material_array == data.labels.source;
  tubular::Label_names names = data.region_names;
  if (names.empty() && (is_of_labels || data.labels.empty()))
    names = data.names;
  if (is_of_labels && data.labels.wall)
    names[*data.labels.wall] = "wall";
  return names;
}

void check_materials(const Run& run) {
  const std::map<int, std::size_t> cells = cells_by_region(run.mesh);
  for (const auto& name : run.mesh.region_names)
    if (name.first >= tubular::labels::first_material && cells.count(name.first) == 0)
      throw tubular::Meshing_error(
          "The material \"" + name.second +
          "\" has no cells: its area is smaller than the facets of the mesh. Make a finer one, "
          "by -n or by --refine there.");
}

} // namespace

void add_names_of(const std::map<std::string, std::vector<double>>& arrays, std::string& names) {
  for (const auto& a : arrays)
    names += (names.empty() ? "" : ", ") + a.first;
}

std::map<int, std::size_t> cells_by_region(const tubular::Mixed_mesh& mesh) {
  std::map<int, std::size_t> number;
  for (const auto* labels : {&mesh.tetrahedra.label, &mesh.pyramids.label, &mesh.prisms.label, &mesh.hexahedra.label})
    for (int region : *labels)
      ++number[region];
  return number;
}

Wall_requests wall_requests(const Options& o, const tubular::IO::Surface_data& data) {
  Wall_requests requests;
  if (!o.wall_array.empty())
    requests.thickness_array = array_named(o.wall_array, data);
  if (!o.wall_table.empty())
    read_table(o.wall_table, requests);
  if (!o.material_array.empty()) {
    requests.material_array = array_named(o.material_array, data);
    requests.material_names = names_of_materials(o, data);
  }
  return requests;
}

void distribute_walls(Run& run, std::vector<Part>& parts) {
  const Options& o = run.options;
  if (!o.has_wall())
    return;
  Wall_requests& walls = run.walls;
  if (walls.thickness_array) {
    tubular::keep_wall(*walls.thickness_array, surfaces_of(parts));
    walls.thickness = tubular::thickness_of_array(*walls.thickness_array);
  } else if (o.wall.length > 0) {
    walls.thickness = tubular::Wall_thickness::of_length(o.wall.length);
  } else {
    walls.thickness = o.wall.thickness;
  }
  walls.second_thickness = o.second_wall.length > 0 ? tubular::Wall_thickness::of_length(o.second_wall.length)
                                                    : tubular::Wall_thickness(o.second_wall.thickness);
  if (walls.material_array) {
    tubular::keep_wall(*walls.material_array, surfaces_of(parts));
    walls.materials = tubular::materials_of_array(*walls.material_array, walls.material_names);
  }
  for (Part& part : parts) {
    part.run.walls.thickness = walls.thickness;
    part.run.walls.second_thickness = walls.second_thickness;
    part.run.walls.materials = walls.materials;
  }
  if (!o.wall_table.empty())
    distribute_table(run, parts);
}

void finish_walls(Run& run, Stage_clock& clock) {
  if (!run.options.material_array.empty())
    check_materials(run);
  if (!run.options.fibres)
    return;
  clock.begin("fibres");
  run.fibres = tubular::wall_fibres(run.mesh, run.model.centerlines, run.options.threads);
  if (run.fibres.undirected > 0)
    run.notes.push_back("In " + std::to_string(run.fibres.undirected) + " of the " + std::to_string(run.fibres.cells) +
                        " cells of the wall this lies across the centerline, as at the tips of vessels: their "
                        "longitudinal direction means little.");
}
