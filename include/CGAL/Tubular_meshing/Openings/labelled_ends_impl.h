// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_LABELLED_ENDS_IMPL_H
#define CGAL_TUBULAR_MESHING_OPENINGS_LABELLED_ENDS_IMPL_H

#include <CGAL/Tubular_meshing/Openings/internal/Label_regions.h>
#include <CGAL/Tubular_meshing/Openings/labelled_ends.h>
#include <CGAL/Tubular_meshing/Rims/planar_cap.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace CGAL::Tubular_meshing {

CGAL_TUBULAR_MESHING_INLINE std::size_t Labelled_ends::find(const std::string& name) const {
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (ends[i].name == name)
      return i;
  for (std::size_t i = 0; i < ends.size(); ++i) // a label that has several ends stands for the first
    if (std::to_string(ends[i].label) == name)
      return i;
  for (const Understood_label& l : labels)
    for (std::size_t i = 0; i < ends.size(); ++i)
      if (l.name == name && ends[i].label == l.label)
        return i;
  return none;
}

// The nearest pairs first, each end and each opening once.
CGAL_TUBULAR_MESHING_INLINE std::vector<std::size_t> Labelled_ends::match(const std::vector<Opening>& openings) const {
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for (std::size_t e = 0; e < ends.size(); ++e)
    for (std::size_t o = 0; o < openings.size(); ++o) {
      const double distance = internal::point_distance(ends[e].center, openings[o].center);
      if (distance < 0.5 * ends[e].radius)
        pairs.emplace_back(distance, e, o);
    }
  std::sort(pairs.begin(), pairs.end());
  std::vector<std::size_t> end_of(openings.size(), none);
  std::vector<bool> taken(ends.size(), false);
  for (const auto& [distance, e, o] : pairs)
    if (!taken[e] && end_of[o] == none) {
      taken[e] = true;
      end_of[o] = e;
    }
  return end_of;
}

namespace internal {

// Without what no file can hold in a name.
inline std::string clean_name(std::string name) {
  for (char& c : name)
    if (c == '"' || (c >= 0 && c < ' '))
      c = '_';
  return name;
}

inline void add_end(const Label_regions& regions, const Label_regions::Region& region, Labelled_ends& result) {
  Labelled_ends::End end;
  const Rim_shape& shape = region.is_end ? region.site.shape : regions.shape_of_loop(*region.loops.begin());
  end.center = shape.center;
  end.radius = shape.radius;
  end.label = region.label;
  result.ends.push_back(end);
}

// The name of its label; one of its own if that has several ends.
inline void name_ends(const Label_regions& regions, Labelled_ends& result) {
  std::set<std::string> used;
  for (const auto& l : result.labels) {
    const std::string base = l.name.empty() ? "face_" + std::to_string(l.label) : clean_name(l.name);
    std::size_t number = 0;
    for (auto& end : result.ends)
      if (end.label == l.label)
        used.insert(end.name = unused_name(l.count > 1 ? base + "_" + std::to_string(++number) : base, used));
  }
  double largest = 0;
  for (std::size_t i = 0; i < result.ends.size(); ++i)
    if (regions.labels().at(result.ends[i].label).role == Label_role::inlet && result.ends[i].radius > largest) {
      largest = result.ends[i].radius;
      result.inlet = i;
    }
}

inline std::string list_of_ends(const Labelled_ends& ends) {
  const std::size_t most = 20;
  std::string list;
  for (std::size_t i = 0; i < ends.ends.size() && i < most; ++i)
    list += (i > 0 ? ", " : "") + ends.ends[i].name;
  return list + (ends.ends.size() > most ? ", …" : "");
}

CGAL_TUBULAR_MESHING_INLINE Labelled_ends open_labelled_ends(Surface& surface, Face_patch_map label,
                                                             const Labelled_ends_options& options) {
  check_tubular_surface(surface);
  Labelled_ends result;
  const Label_regions regions(surface, label, options);
  if (regions.labels().size() < 2)
    return result;
  result.source = options.label_source;

  std::size_t walls = 0;
  for (const auto& l : regions.labels()) {
    Understood_label understood;
    understood.label = l.first;
    understood.name = l.second.name;
    understood.reason = l.second.reason;
    for (std::size_t r : l.second.regions)
      understood.count += regions.regions()[r].is_end || regions.regions()[r].names_loop;
    if (understood.count == 0) {
      result.wall = ++walls == 1 ? std::optional<int>(l.first) : std::nullopt;
      result.wall_name = result.wall ? clean_name(l.second.name) : "";
    }
    result.labels.push_back(understood);
  }
  std::vector<Surface::Face_index> removed;
  for (const auto& region : regions.regions())
    if (region.is_end || region.names_loop) {
      add_end(regions, region, result);
      if (region.is_end)
        removed.insert(removed.end(), region.faces.begin(), region.faces.end());
    }
  name_ends(regions, result);
  if (!options.inlet_name.empty()) {
    result.inlet = result.find(options.inlet_name);
    if (result.inlet == Labelled_ends::none)
      throw Parameter_error("No end of the surface is called \"" + options.inlet_name + "\"" +
                            (result.ends.empty() ? ": none has a name." : ": there are " + list_of_ends(result) + "."));
  }
  remove_faces(removed, surface);
  if (surface.has_garbage())
    surface.collect_garbage();
  return result;
}

CGAL_TUBULAR_MESHING_INLINE void name_openings(std::vector<Opening>& openings, const Labelled_ends& ends) {
  const std::vector<std::size_t> end_of = ends.match(openings);
  for (std::size_t i = 0; i < openings.size(); ++i)
    if (end_of[i] != Labelled_ends::none)
      openings[i].name = ends.ends[end_of[i]].name;
}

} // namespace internal
} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_OPENINGS_LABELLED_ENDS_IMPL_H
