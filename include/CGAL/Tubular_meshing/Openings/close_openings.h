// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_CLOSE_OPENINGS_H
#define CGAL_TUBULAR_MESHING_OPENINGS_CLOSE_OPENINGS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Openings/internal/Opening_closer.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <CGAL/Polygon_mesh_processing/orientation.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

// Sites by the first coordinate of their centres, to look openings up in.
class Site_index {
public:
  void insert(const Opening_site& site) { by_x_.emplace(site.shape.center.x(), site); }

  /* The site whose centre is that of the opening but for rounding, taken out of the index; false if there is none. */
  bool take(const Opening& opening, Opening_site& site) {
    const double tolerance = 1e-3 * opening.radius;
    auto nearest = by_x_.end();
    for (auto i = by_x_.lower_bound(opening.center.x() - tolerance);
         i != by_x_.end() && i->first <= opening.center.x() + tolerance; ++i)
      if (point_distance(i->second.shape.center, opening.center) <= tolerance &&
          std::abs(i->second.shape.radius - opening.radius) <= tolerance &&
          (nearest == by_x_.end() || point_distance(i->second.shape.center, opening.center) <
                                         point_distance(nearest->second.shape.center, opening.center)))
        nearest = i;
    if (nearest == by_x_.end())
      return false;
    site = std::move(nearest->second);
    by_x_.erase(nearest);
    return true;
  }

  bool empty() const { return by_x_.empty(); }
  const Opening_site& front() const { return by_x_.begin()->second; }

private:
  std::multimap<double, Opening_site> by_x_;
};

// The sites of the openings, in their order. Flat ends are searched for with ever other criteria, as when they were
// found.
inline std::vector<Opening_site> sites_of(const std::vector<Opening>& openings, const std::vector<Opening_site>& loops,
                                          const Surface& surface) {
  std::vector<Opening_site> sites(openings.size());
  std::vector<std::size_t> missing, still_missing;
  Site_index index;
  for (const auto& loop : loops)
    index.insert(loop);
  for (std::size_t i = 0; i < openings.size(); ++i)
    if (!index.take(openings[i], sites[i]))
      missing.push_back(i);
  if (!index.empty())
    throw Input_error("The border loop at " + coordinates(index.front().shape.center) +
                      " is not one of the openings that were given: pass all that find_openings() returns.");
  if (missing.empty())
    return sites;
  Flat_end_finder finder(surface, false);
  for (const Flat_end_criteria& criteria : possible_flat_ends()) {
    Site_index flat_ends;
    for (const auto& end : finder.find(criteria))
      flat_ends.insert(end);
    still_missing.clear();
    for (std::size_t i : missing)
      if (!flat_ends.take(openings[i], sites[i]))
        still_missing.push_back(i);
    missing.swap(still_missing);
    if (missing.empty())
      return sites;
  }
  throw Input_error("The surface has no opening at " + coordinates(openings[missing[0]].center) +
                    ": pass what find_openings() returns for this surface.");
}

} // namespace internal

/*!
 * \ingroup PkgTubularMeshingRef
 *
 * The close-volume operator (section 2.3 of the paper): closes a tubular surface by planar caps, and labels its faces.
 *
 * - A border loop that sags by at most a fifth of its radius is moved onto the mean plane of its vertices, along the
 *   plane's normal; the displacement fades out in the wall within four times its size. Triangles with two edges on
 *   the loop are removed before.
 * - Where the loop sags more, or where moving it would fold a triangle or make the surface intersect itself, the tube
 *   is trimmed by a parallel plane as much further in as needed, at first 5 % of the radius below the loop's lowest
 *   vertex. If that is in vain, as the loop is too ragged to have a direction, by a plane across the wall behind it.
 * - The planar rim is filled with its constrained Delaunay triangulation: no vertex is added, straight and non-convex
 *   rims are fine.
 * - Caps that the surface has already are moved onto their mean plane, and keep their triangles. If these would fold,
 *   the cap is replaced.
 * - A triangle or two missing in a smooth wall (see find_openings()) are filled as they are, as wall.
 *
 * Afterwards the surface is closed, its faces are oriented outwards (all are reversed, if they were not), each cap is
 * planar up to rounding (about 1e-15 of the largest coordinate), and `openings` describe the caps: centre, normal,
 * area, perimeter and radius are those of the polygon that is the cap. Their order, labels and ends do not change.
 *
 * \param surface a triangle mesh, manifold, as given to find_openings(). Descriptors are not kept, as garbage is
 *   collected; property maps are, with default values for new elements.
 * \param openings what find_openings() has returned for this surface
 * \param patch a writable property map from face to int: labels::wall, or the label of the face's opening
 *
 * The fourth parameter is for later options; there is none at present.
 *
 * \throws Input_error as find_openings() does, and if the openings are not those of the surface
 * \throws Meshing_error if an opening cannot be closed without folding the wall. The surface is then partly closed.
 *
 * Complexity: a linear pass over the surface, and O(k log k) in the number of faces within about a radius of openings.
 */
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
void close_openings(Surface& surface, std::vector<Opening>& openings, Face_patch_map patch,
                    const NamedParameters& /* np */ = CGAL::parameters::default_values()) {
  typedef Surface::Face_index Face;
  internal::check_tubular_surface(surface);
  std::vector<internal::Opening_site> loops = internal::border_loops(surface), pinholes;
  if (internal::is_inside_out(surface, loops)) {
    CGAL::Polygon_mesh_processing::reverse_face_orientations(surface);
    loops = internal::border_loops(surface);
  }
  const auto first_pinhole = std::stable_partition(
      loops.begin(), loops.end(), [&](const auto& loop) { return !internal::is_pinhole(loop, surface); });
  pinholes.assign(first_pinhole, loops.end());
  loops.erase(first_pinhole, loops.end());
  std::vector<internal::Opening_site> sites = internal::sites_of(openings, loops, surface);

  // Labels are kept with the faces until no more of them come and go.
  auto label = surface.add_property_map<Face, int>("f:tubular_meshing_label", labels::wall).first;
  internal::Opening_closer closer(surface);
  for (auto& pinhole : pinholes)
    closer.fill(pinhole);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    closer.close(sites[i]);
    for (Face f : sites[i].cap)
      label[f] = openings[i].patch;
    internal::set_shape(openings[i], sites[i].shape, false);
  }
  if (surface.has_garbage())
    surface.collect_garbage();
  for (Face f : surface.faces())
    put(patch, f, int(label[f]));
  surface.remove_property_map(label);
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_OPENINGS_CLOSE_OPENINGS_H
