// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_FLOW_EXTENSIONS_IMPL_H
#define CGAL_TUBULAR_MESHING_OPENINGS_FLOW_EXTENSIONS_IMPL_H

#include <CGAL/Tubular_meshing/Openings/flow_extensions.h>
#include <CGAL/Tubular_meshing/Openings/internal/extension/Extension_band.h>
#include <CGAL/Tubular_meshing/Openings/internal/extension/Extension_builder.h>
#include <CGAL/Tubular_meshing/Openings/internal/extension/Extension_profile.h>
#include <CGAL/Tubular_meshing/Openings/internal/extension/Extension_space.h>
#include <CGAL/Tubular_meshing/Openings/internal/extension/wall_direction.h>
#include <CGAL/Tubular_meshing/Openings/internal/opening_sites.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/Rims/planar_cap.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Opening.h>
#include <CGAL/Tubular_meshing/base/crossing_pairs.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <sstream>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Extends openings; where it throws, the surface and the openings may be half done. */
class Flow_extender {
  typedef Surface::Face_index Face;

public:
  Flow_extender(Surface& mesh, std::vector<Opening>& openings, const std::vector<bool>& wanted)
      : mesh_(mesh)
      , openings_(openings)
      , wanted_(wanted)
      , profiles_(openings.size())
      , limits_(openings.size()) {}

  std::vector<double> extend(double length, double min_length) {
    find_sites();
    for (std::size_t i = 0; i < openings_.size(); ++i)
      if (wanted_[i])
        plan(i, length);
    const Wall_tree wall(CGAL::faces(mesh_).begin(), CGAL::faces(mesh_).end(), mesh_);
    limit(wall, length, min_length);
    build(wall);
    std::vector<double> lengths(openings_.size(), 0.);
    for (std::size_t i = 0; i < openings_.size(); ++i)
      if (wanted_[i])
        lengths[i] = profiles_[i].end() * profiles_[i].radius();
    return lengths;
  }

private:
  static constexpr double least_over_rim = 0.25; // in radii

  std::string name(std::size_t i) const {
    return "opening " + std::to_string(i) + (i == 0 ? " (inlet)" : " (outlet_" + std::to_string(i) + ")") + " at " +
           coordinates(sites_[i].shape.center); // openings_ may have moved on
  }

  // Opens the caps that are in the way.
  void find_sites() {
    sites_ = turn_outward_and_find_sites(openings_, mesh_).openings;
    for (std::size_t i = 0; i < sites_.size(); ++i)
      if (wanted_[i]) {
        remove_faces(sites_[i].cap, mesh_);
        sites_[i].cap.clear();
      }
  }

  // Along the wall; where the rim seen from there crosses itself, along its own normal.
  void plan(std::size_t i, double length) {
    const std::vector<Point_3> rim = rim_points(sites_[i].rim, mesh_);
    const auto& normal = sites_[i].shape.plane.normal();
    Extension_profile& profile = profiles_[i];
    profile = Extension_profile(rim, wall_direction(sites_[i], normal, mesh_));
    if (!profile.is_valid())
      profile = Extension_profile(rim, normal);
    if (!profile.is_valid())
      throw Meshing_error("The rim of " + name(i) +
                          " crosses itself as seen along the vessel, so that no straight extension can begin there: "
                          "smooth the surface there or cut it straight.");
    profile.set_end((std::max)({length, profile.highest() + least_over_rim, Extension_band::least_height(profile)}));
  }

  void limit(const Wall_tree& wall, double length, double min_length) {
    for (std::size_t i = 0; i < profiles_.size(); ++i)
      if (wanted_[i])
        limits_[i] = free_of_wall(profiles_[i], mesh_, wall);
    Extension_growth(profiles_, wanted_, limits_);
    for (std::size_t i = 0; i < profiles_.size(); ++i) {
      if (!wanted_[i] || limits_[i].obstacle == Extension_limit::none)
        continue;
      const double least =
          (std::max)({min_length, profiles_[i].highest() + least_over_rim, Extension_band::least_height(profiles_[i])});
      if (limits_[i].height < least)
        refuse(i, limits_[i], length);
      profiles_[i].set_end(limits_[i].height);
    }
  }

  [[noreturn]] void refuse(std::size_t i, const Extension_limit& limit, double length) const {
    std::ostringstream sentence;
    sentence.precision(2);
    sentence << "The flow extension of " << name(i) << " would run into "
             << (limit.obstacle == Extension_limit::wall ? std::string("the wall")
                                                         : "the extension of " + name(limit.obstacle))
             << " after " << (std::max)(0., limit.height) << " of its " << length
             << " radii: leave one of these openings out (extended_openings), or ask for a smaller length "
                "(extension_length, min_extension_length).";
    throw Meshing_error(sentence.str());
  }

  void build(const Wall_tree& wall) {
    std::vector<Face> faces;
    Extension_builder builder(mesh_);
    for (std::size_t i = 0; i < profiles_.size(); ++i) {
      if (!wanted_[i])
        continue;
      builder.faces.clear();
      if (!builder.build(profiles_[i], sites_[i].rim))
        throw_crossing(i);
      for (Face f : builder.faces)
        owner_[f] = i;
      faces.insert(faces.end(), builder.faces.begin(), builder.faces.end());
      set_shape(openings_[i], measure_rim(rim_points(builder.rim, mesh_)), false);
    }
    check_crossings(faces, wall);
    if (mesh_.has_garbage())
      mesh_.collect_garbage();
  }

  // What was wrong with the wall before is left to the caller.
  void check_crossings(std::vector<Face> faces, const Wall_tree& wall) const {
    std::vector<Face> near;
    for (Face f : faces) {
      CGAL::Bbox_3 box;
      for (auto v : CGAL::vertices_around_face(mesh_.halfedge(f), mesh_))
        box += mesh_.point(v).bbox();
      wall.all_intersected_primitives(box, std::back_inserter(near));
    }
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    faces.insert(faces.end(), near.begin(), near.end());
    std::size_t first = Extension_limit::none;
    for (const auto& c : crossing_pairs(faces, mesh_))
      for (Face f : {c.first, c.second}) {
        const auto owner = owner_.find(f);
        if (owner != owner_.end())
          first = (std::min)(first, owner->second);
      }
    if (first != Extension_limit::none)
      throw_crossing(first);
  }

  [[noreturn]] void throw_crossing(std::size_t i) const {
    throw Meshing_error("The flow extension of " + name(i) +
                        " would cross the wall at its very beginning: cut the surface straight there, or leave this "
                        "opening out (extended_openings).");
  }

  Surface& mesh_;
  std::vector<Opening>& openings_;
  const std::vector<bool>& wanted_;
  std::vector<Opening_site> sites_;
  std::vector<Extension_profile> profiles_;
  std::vector<Extension_limit> limits_;
  std::unordered_map<Face, std::size_t> owner_; // the extension that a new face belongs to
};

inline void check_extension_lengths(double length, double min_length) {
  if (!(length > 0) || !(length <= 1000))
    throw Parameter_error("The length of flow extensions (extension_length) has to be more than 0 and at most 1000 "
                          "radii, not " +
                          std::to_string(length) + ".");
  if (!(min_length >= 0) || !(min_length <= length))
    throw Parameter_error(
        "The least length of flow extensions (min_extension_length) has to be from 0 to their length, "
        "not " +
        std::to_string(min_length) + ".");
}

/* By opening, whether it is to be extended. */
inline std::vector<bool> wanted_extensions(std::size_t openings, const Add_flow_extensions_options& options) {
  std::vector<bool> wanted(openings, !options.extended_openings);
  if (options.extended_openings)
    for (std::size_t i : *options.extended_openings) {
      if (i >= openings)
        throw Parameter_error("There is no opening " + std::to_string(i) +
                              " to extend (extended_openings): there are " + std::to_string(openings) +
                              ", counted from 0.");
      wanted[i] = true;
    }
  return wanted;
}

CGAL_TUBULAR_MESHING_INLINE std::vector<double> add_flow_extensions(Surface& surface, std::vector<Opening>& openings,
                                                                    const Add_flow_extensions_options& options) {
  const double length = options.extension_length;
  const double min_length = options.min_extension_length.value_or((std::min)(1., length));
  check_extension_lengths(length, min_length);
  const std::vector<bool> wanted = wanted_extensions(openings.size(), options);
  check_tubular_surface(surface);
  Surface surface_before = surface;
  std::vector<Opening> openings_before = openings;
  try {
    return Flow_extender(surface, openings, wanted).extend(length, min_length);
  } catch (...) {
    surface = std::move(surface_before);
    openings.swap(openings_before);
    throw;
  }
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_FLOW_EXTENSIONS_IMPL_H
