// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_UNITE_PARTS_IMPL_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_UNITE_PARTS_IMPL_H

#include <CGAL/Tubular_meshing/Repair/internal/unite_parts.h>
#include <CGAL/Tubular_meshing/Repair/split_into_parts.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/base/cgal_compatibility.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Side_of_triangle_mesh.h>

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Keeps to the faces of caps while corefinement splits and copies faces. */
class Cap_visitor : public Polygon_mesh_processing::Corefinement::Default_visitor<Surface> {
  typedef Surface::Face_index Face;

public:
  static bool is_cap(const Surface& mesh, Face f) {
    const auto map = property_map_of<Face, bool>(mesh, name());
    return map && (*map)[f];
  }
  static void mark(Surface& mesh, Face f, bool cap) { mesh.add_property_map<Face, bool>(name(), false).first[f] = cap; }
  static void forget(Surface& mesh) {
    if (auto map = property_map_of<Face, bool>(mesh, name()))
      mesh.remove_property_map(*map);
  }

  void before_subface_creations(Face f, Surface& mesh) { is_cap_ = is_cap(mesh, f); }
  void after_subface_created(Face f, Surface& mesh) { mark(mesh, f, is_cap_); }
  void after_face_copy(Face from, const Surface& source, Face to, Surface& target) {
    mark(target, to, is_cap(source, from));
  }

private:
  static const char* name() { return "f:tubular_meshing_cap"; }
  bool is_cap_ = false;
};

class Part_uniter {
  typedef Surface::Face_index Face;

public:
  explicit Part_uniter(Surface& mesh)
      : mesh_(mesh)
      , parts_(split_into_parts(mesh)) {}

  United_parts unite() {
    if (parts_.size() < 2)
      return result_;
    for (Surface& part : parts_)
      close(part);
    bool has_changed = false;
    for (std::size_t i = 0; i < parts_.size(); ++i) // the larger ones take the smaller ones up
      for (std::size_t k = i + 1; k < parts_.size();)
        if (take_up(parts_[i], parts_[k])) {
          parts_.erase(parts_.begin() + std::ptrdiff_t(k));
          has_changed = true;
          k = i + 1; // what is larger now may reach others
        } else
          ++k;
    if (has_changed)
      join();
    return result_;
  }

private:
  // Fills the border loops with caps that are taken away again.
  static void close(Surface& part) {
    for (const Opening_site& loop : border_cycles(part)) {
      std::vector<Face> cap;
      Polygon_mesh_processing::triangulate_hole(part, loop.rim.front(), std::back_inserter(cap));
      for (Face f : cap)
        Cap_visitor::mark(part, f, true);
    }
  }

  static void open(Surface& part) {
    std::vector<Face> caps;
    for (Face f : part.faces())
      if (Cap_visitor::is_cap(part, f))
        caps.push_back(f);
    for (Face f : caps)
      CGAL::Euler::remove_face(part.halfedge(f), part);
    part.collect_garbage();
    Cap_visitor::forget(part);
  }

  // Whether the second part is in the first one now, or was inside of it.
  bool take_up(Surface& part, Surface& other) {
    namespace PMP = Polygon_mesh_processing;
    if (!CGAL::do_overlap(PMP::bbox(part), PMP::bbox(other)))
      return false;
    if (PMP::do_intersect(part, other)) {
      unite(part, other);
      return true;
    }
    if (!lies_inside(other, part))
      return false;
    ++result_.inside;
    result_.place_inside = other.point(*other.vertices().begin());
    result_.share += PMP::area(other) / PMP::area(mesh_);
    return true;
  }

  static bool lies_inside(const Surface& part, const Surface& other) {
    if (!CGAL::is_closed(other))
      return false;
    const CGAL::Side_of_triangle_mesh<Surface, Kernel> side(other);
    return side(part.point(*part.vertices().begin())) == CGAL::ON_BOUNDED_SIDE;
  }

  void unite(Surface& part, Surface& other) {
    namespace PMP = Polygon_mesh_processing;
    const Point_3 place = other.point(*other.vertices().begin());
    bool is_united = false;
    try {
      is_united = CGAL::is_closed(part) && CGAL::is_closed(other) &&
                  PMP::corefine_and_compute_union(
                      part, other, part, CGAL::parameters::throw_on_self_intersection(true).visitor(Cap_visitor()));
    } catch (const PMP::Corefinement::Self_intersection_exception&) {
    }
    if (!is_united)
      throw Input_error("Two parts of the surface cross each other, one of them with a point at " + coordinates(place) +
                        ", and cannot be united: unite them in another program, or keep one.");
    part.collect_garbage();
    if (result_.united++ == 0)
      result_.crossing = place;
  }

  void join() {
    mesh_.clear();
    for (Surface& part : parts_) {
      open(part);
      mesh_ += part;
    }
  }

  Surface& mesh_;
  std::vector<Surface> parts_; ///< closed
  United_parts result_;
};

CGAL_TUBULAR_MESHING_INLINE United_parts unite_parts(Surface& mesh) {
  return Part_uniter(mesh).unite();
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_UNITE_PARTS_IMPL_H
