// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_FLOW_EXTENSIONS_H
#define CGAL_TUBULAR_MESHING_OPENINGS_FLOW_EXTENSIONS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Openings/close_openings.h>
#include <CGAL/Tubular_meshing/Openings/internal/extension/Extension_builder.h>
#include <CGAL/Tubular_meshing/Openings/internal/extension/Extension_profile.h>
#include <CGAL/Tubular_meshing/Openings/internal/extension/Extension_space.h>
#include <CGAL/Tubular_meshing/Openings/internal/extension/wall_direction.h>
#include <CGAL/Tubular_meshing/Rims/planar_cap.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/cgal_compatibility.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <sstream>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* Extends openings; where it throws, the surface and the openings may be half done. */
class Flow_extender {
  typedef Surface::Face_index Face;
  typedef CGAL::AABB_face_graph_triangle_primitive<Surface> Primitive;
  typedef CGAL::AABB_tree<Aabb_traits<Kernel, Primitive>> Tree;

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
    Tree wall(CGAL::faces(mesh_).begin(), CGAL::faces(mesh_).end(), mesh_);
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

  // Turns the surface outward, and opens the caps that are in the way.
  void find_sites() {
    std::vector<Opening_site> loops = border_loops(mesh_);
    if (is_inside_out(mesh_, loops)) {
      CGAL::Polygon_mesh_processing::reverse_face_orientations(mesh_);
      loops = border_loops(mesh_);
    }
    loops.erase(std::remove_if(loops.begin(), loops.end(), [&](const auto& loop) { return is_pinhole(loop, mesh_); }),
                loops.end());
    sites_ = sites_of(openings_, loops, mesh_);
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

  void limit(const Tree& wall, double length, double min_length) {
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

  void build(const Tree& wall) {
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
  void check_crossings(std::vector<Face> faces, const Tree& wall) const {
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
    std::vector<std::pair<Face, Face>> crossings;
    CGAL::Polygon_mesh_processing::self_intersections<CGAL::Parallel_if_available_tag>(faces, mesh_,
                                                                                       std::back_inserter(crossings));
    std::size_t first = Extension_limit::none;
    for (const auto& c : crossings)
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

} // namespace internal

/*!
 * \ingroup PkgTubularMeshingRef
 *
 * Adds flow extensions (section 2.1 of the paper, footnote): attaches a straight tube to each opening of a tubular
 * surface, so that the flow develops, and centerlines run, beyond the ends of the vessel.
 *
 * - An extension goes on in the direction of the wall within a radius behind the opening, so that it is tangent to the
 *   vessel even where this is cut obliquely; at an opening whose wall has no direction (a hole in a dome), along the
 *   opening's normal.
 * - Its profile is the rim's own where it begins and becomes a circle, smoothly (with no slope at either end), within
 *   two radii, or as much as there is. The circle has the area that the rim has across this direction; the far end is
 *   planar.
 * - Its edges are as long as those of the rim (the mean, weighted by length; at least twelve around the circle), and
 *   finer where the rim is. The rim's vertices stay where they are, and no vertex is added to its edges: the surface
 *   stays manifold.
 * - The extensions of openings that are closed by a flat cap take the place of the cap.
 * - An extension stops half a radius or less before a tube 5 % wider would meet the wall; two that would come too near
 *   each other grow alike until they do.
 *
 * Compute centerlines after this: their ends are then those of the extensions.
 *
 * \param surface a triangle mesh, manifold, as given to find_openings(). Faces are oriented outwards (all are reversed,
 *   if they were not). Where caps are removed, descriptors are not kept, as garbage is collected; property maps are,
 *   with default values for new elements.
 * \param openings what find_openings() has returned for this surface. Those extended are updated: centre, normal, area,
 *   perimeter and radius are those of the far end. Their order, labels and centerline branches do not change.
 * \param np named parameters:
 *   - `extension_length`: in radii, of the disk that has the area of the opening across the extension's direction; from
 *     the opening's centre to the far end. At least a quarter of a radius is added to the outermost vertex of the rim.
 *     From above 0 to 1000. Default: 5.
 *   - `min_extension_length`: how short an extension may become where it would run into something, in radii. Default:
 *     the smaller of 1 and `extension_length`; equal to this, nothing is shortened.
 *   - `extended_openings`: the indices of the openings to extend, a `std::vector<std::size_t>`. Default: all.
 * \return for each opening the length of its extension from centre to centre, in the unit of the surface; 0 for those
 *   not extended
 *
 * \throws Input_error as find_openings() does, and if the openings are not those of the surface
 * \throws Parameter_error if a length is out of its range, or an index is
 * \throws Meshing_error naming the opening, if its extension would be shorter than the least length, or if its rim is
 *   such that no straight tube can begin there without crossing the wall or itself
 *
 * Where it throws, the surface and the openings are as before, but property maps have to be looked up anew.
 *
 * Complexity: O(n log n) in the number of faces, of the surface and of the extensions, where a rim's height along the
 * vessel is a few radii.
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<double> add_flow_extensions(Surface& surface, std::vector<Opening>& openings,
                                        const NamedParameters& np = CGAL::parameters::default_values()) {
  const double length = internal::choose(np, internal_np::extension_length, 5.);
  const double min_length = internal::choose(np, internal_np::min_extension_length, (std::min)(1., length));
  internal::check_extension_lengths(length, min_length);
  std::vector<std::size_t> all(openings.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  std::vector<bool> wanted(openings.size(), false);
  for (std::size_t i : internal::choose(np, internal_np::extended_openings, all)) {
    if (i >= openings.size())
      throw Parameter_error("There is no opening " + std::to_string(i) + " to extend (extended_openings): there are " +
                            std::to_string(openings.size()) + ", counted from 0.");
    wanted[i] = true;
  }

  internal::check_tubular_surface(surface);
  Surface surface_before = surface;
  std::vector<Opening> openings_before = openings;
  try {
    return internal::Flow_extender(surface, openings, wanted).extend(length, min_length);
  } catch (...) {
    surface = std::move(surface_before);
    openings.swap(openings_before);
    throw;
  }
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_OPENINGS_FLOW_EXTENSIONS_H
