// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "renames.h"

#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Pipelines/join_parts.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace tubular = CGAL::Tubular_meshing;

namespace {

std::string renamed(const Options& o, const std::string& name) {
  for (const std::string& r : o.renames)
    if (r.substr(0, r.find('=')) == name)
      return r.substr(r.find('=') + 1);
  return name;
}

tubular::Label_names renamed(const Options& o, tubular::Label_names names) {
  for (auto& n : names)
    n.second = renamed(o, n.second);
  return names;
}

std::string list_of(const tubular::Label_names& names) {
  std::string list;
  for (const auto& n : names)
    list += (list.empty() ? "" : ", ") + n.second;
  return list;
}

// All vessels without their surfaces and lines: their openings, patches and names as they come to be.
tubular::Tubular_model outline(const std::vector<Part>& parts) {
  std::vector<tubular::Tubular_model> models;
  for (const Part& part : parts) {
    models.emplace_back();
    models.back().openings = part.run.model.openings;
    for (auto& opening : models.back().openings)
      opening.branch = opening.node = tubular::Opening::no_branch;
    models.back().patch_names = tubular::patch_names(part.run.model);
  }
  return tubular::join_parts(std::move(models));
}

void check(const Options& o, const tubular::Label_names& before, const tubular::Label_names& after) {
  tubular::Label_names names = after;
  if (o.has_wall())
    tubular::add_wall_patch_names(names, o.has_second_wall());
  if (!o.material_array.empty())
    names[tubular::labels::material_interface(tubular::labels::outer_wall_for(after.rbegin()->first))] =
        "material_interface";
  tubular::Label_names known = names;
  for (const auto& n : before)
    known[n.first] = n.second;
  for (const std::string& r : o.renames) {
    const std::string name = r.substr(0, r.find('='));
    if (std::none_of(known.begin(), known.end(), [&](const auto& n) { return n.second == name; }))
      throw tubular::Parameter_error("There is no patch called \"" + name + "\" to be renamed: there are " +
                                     list_of(known) + ".");
  }
  std::set<std::string> different;
  for (const auto& n : names) {
    const std::string name = after.count(n.first) == 0 ? renamed(o, n.second) : n.second;
    if (!different.insert(name).second)
      throw tubular::Parameter_error("Two patches would be called \"" + name + "\": give them different names.");
  }
}

} // namespace

void rename_patches(const Run& run, std::vector<Part>& parts) {
  const Options& o = run.options;
  if (o.renames.empty())
    return;
  const tubular::Tubular_model whole = outline(parts);
  const tubular::Label_names before = tubular::patch_names(whole), after = renamed(o, before);
  check(o, before, after);
  std::size_t i = 0;
  for (Part& part : parts) {
    tubular::Tubular_model& model = part.run.model;
    model.patch_names = tubular::patch_names(model);
    const auto rename = [&](int patch, int patch_of_whole) {
      if (before.at(patch_of_whole) != after.at(patch_of_whole)) // else it is numbered through
        model.patch_names[patch] = after.at(patch_of_whole);
      return model.patch_names[patch];
    };
    rename(tubular::labels::wall, tubular::labels::wall);
    for (auto& opening : model.openings)
      opening.name = rename(opening.patch, whole.openings[i++].patch);
  }
}

void rename_wall_patches(Run& run) {
  if (run.options.renames.empty())
    return;
  const tubular::Label_names done = tubular::patch_names(run.model);
  for (auto& n : run.mesh.patch_names)
    if (done.count(n.first) == 0)
      n.second = renamed(run.options, n.second);
}
