// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_CONVERT_SURFACE_H
#define CGAL_TUBULAR_MESHING_BASE_CONVERT_SURFACE_H

#include <CGAL/Tubular_meshing/base/Labelled_surface.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Any kernel's point as the core has it. */
template <class Point> Point_3 to_core(const Point& p) {
  return Point_3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
}
inline const Point_3& to_core(const Point_3& p) {
  return p;
}

/* A point among the named parameters, of any kernel; none if it is not there. */
template <class NamedParameters, class Tag> std::optional<Point_3> optional_point(const NamedParameters& np, Tag tag) {
  typedef std::decay_t<decltype(CGAL::parameters::get_parameter(np, tag))> Value;
  if constexpr (std::is_same<Value, CGAL::internal_np::Param_not_found>::value)
    return std::nullopt;
  else
    return to_core(CGAL::parameters::get_parameter(np, tag));
}

/* A caller's vertex point map, read as points of the core and written from them. */
template <class VertexPointMap> struct Core_point_map {
  typedef typename boost::property_traits<VertexPointMap>::key_type key_type;
  typedef typename boost::property_traits<VertexPointMap>::value_type Caller_point;
  typedef Point_3 value_type;
  typedef Point_3 reference;
  typedef boost::read_write_property_map_tag category;

  VertexPointMap map;

  friend Point_3 get(const Core_point_map& m, const key_type& v) { return to_core(get(m.map, v)); }
  friend void put(const Core_point_map& m, const key_type& v, const Point_3& p) {
    put(m.map, v, Caller_point(p.x(), p.y(), p.z()));
  }
};

template <class FaceGraph, class NamedParameters>
Core_point_map<typename GetVertexPointMap<FaceGraph, NamedParameters>::const_type>
core_points(const FaceGraph& mesh, const NamedParameters& np) {
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  return {
      choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point), get_const_property_map(vertex_point, mesh))};
}

/* Whether a surface, with these parameters, is the core's own, with its own points. */
template <class FaceGraph, class NamedParameters>
constexpr bool is_core_surface = std::is_same<FaceGraph, Surface>::value&&
    std::is_same<std::decay_t<decltype(CGAL::parameters::get_parameter(std::declval<const NamedParameters&>(),
                                                                       CGAL::internal_np::vertex_point))>,
                 CGAL::internal_np::Param_not_found>::value;

/* Empties a mesh; property maps of the caller's stay. */
template <class FaceGraph> void remove_elements(FaceGraph& mesh) {
  clear(mesh);
}
template <class Point> void remove_elements(Surface_mesh<Point>& mesh) {
  mesh.clear_without_removing_property_maps();
}

template <class From, class To>
using Face_copies = std::vector<
    std::pair<typename boost::graph_traits<From>::face_descriptor, typename boost::graph_traits<To>::face_descriptor>>;

/* Adds the vertices and faces of `from` to an empty mesh in their order, each face from the same corner; `copies` gets
 * each face with its copy. False if faces cannot be added one by one. O(n). */
template <class From, class FromPoints, class To, class ToPoints>
bool copy_in_order(const From& from, FromPoints from_points, To& to, ToPoints to_points,
                   Face_copies<From, To>& copies) {
  typedef typename boost::graph_traits<To>::vertex_descriptor Vertex;
  const auto copy_of = get(CGAL::dynamic_vertex_property_t<Vertex>(), from);
  for (auto v : vertices(from)) {
    const Vertex copy = add_vertex(to);
    put(to_points, copy, get(from_points, v));
    put(copy_of, v, copy);
  }
  copies.reserve(num_faces(from));
  std::vector<Vertex> corners;
  for (auto f : faces(from)) {
    corners.clear();
    for (auto v : vertices_around_face(halfedge(f, from), from)) // from its halfedge's target, as add_face() begins
      corners.push_back(get(copy_of, v));
    const auto copy = Euler::add_face(corners, to);
    if (copy == boost::graph_traits<To>::null_face())
      return false;
    copies.emplace_back(f, copy);
  }
  return true;
}

/* Copies a caller's mesh into an empty surface, whose property maps stay, in the caller's order, so that what is made of
 * the copy does not depend on the mesh's type. (copy_face_graph() numbers vertices as it meets them.) O(n). */
template <class FaceGraph, class NamedParameters>
void copy_to_core(const FaceGraph& mesh, Surface& surface, const NamedParameters& np) {
  const auto points = core_points(mesh, np);
  Face_copies<FaceGraph, Surface> copies;
  if (!copy_in_order(mesh, points, surface, get(vertex_point, surface), copies)) {
    remove_elements(surface);
    copy_face_graph(mesh, surface, CGAL::parameters::vertex_point_map(points));
  }
}

/* The surface as the core has it: the caller's own where it is one already, else a copy. A skin's first line:
 *
 *     const Core_surface<FaceGraph, NamedParameters> core(mesh, np);
 *     return internal::stage(*core, Stage_options(np));
 */
template <class FaceGraph, class NamedParameters> class Core_surface {
public:
  Core_surface(const FaceGraph& mesh, const NamedParameters& np) {
    if constexpr (is_core_surface<FaceGraph, NamedParameters>)
      surface_ = &mesh;
    else {
      copy_to_core(mesh, copy_, np);
      surface_ = &copy_;
    }
  }
  Core_surface(const Core_surface&) = delete;
  Core_surface& operator=(const Core_surface&) = delete;

  const Surface& operator*() const { return *surface_; }
  const Surface* operator->() const { return surface_; }

private:
  Surface copy_;
  const Surface* surface_;
};

/* The labels of a caller's faces, for the surface that Core_surface makes of them: that surface must be free of
 * removed elements, or the caller's own. */
template <class FaceGraph, class FacePatchMap, class NamedParameters>
Labelled_surface labelled_copy(const FaceGraph& mesh, FacePatchMap patch, const NamedParameters& np) {
  Labelled_surface result;
  copy_to_core(mesh, result.surface, np);
  auto f = result.surface.faces().begin();
  for (auto caller : faces(mesh))
    result.patch[*f++] = int(get(patch, caller));
  return result;
}

/* A surface and labels as the core has them, both the caller's own where they can be. */
template <class FaceGraph, class FacePatchMap, class NamedParameters> class Core_labelled_surface {
public:
  Core_labelled_surface(const FaceGraph& mesh, FacePatchMap patch, const NamedParameters& np) {
    if constexpr (is_core_surface<FaceGraph, NamedParameters> && std::is_same<FacePatchMap, Face_patch_map>::value) {
      surface_ = &mesh;
      patch_ = patch;
    } else {
      copy_ = labelled_copy(mesh, patch, np);
      surface_ = &copy_.surface;
      patch_ = copy_.patch;
    }
  }
  Core_labelled_surface(const Core_labelled_surface&) = delete;
  Core_labelled_surface& operator=(const Core_labelled_surface&) = delete;

  const Surface& surface() const { return *surface_; }
  Face_patch_map patch() const { return patch_; }

private:
  Labelled_surface copy_;
  const Surface* surface_;
  Face_patch_map patch_;
};

/* The way back: `mesh` becomes a copy of the core's surface, in its order. Returns each face with its copy. O(n). */
template <class FaceGraph, class NamedParameters>
Face_copies<Surface, FaceGraph> copy_from_core(const Surface& surface, FaceGraph& mesh, const NamedParameters& np) {
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  typedef typename GetVertexPointMap<FaceGraph, NamedParameters>::type Points;
  const Core_point_map<Points> points{
      choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point), get_property_map(vertex_point, mesh))};
  Face_copies<Surface, FaceGraph> copies;
  remove_elements(mesh);
  if (!copy_in_order(surface, get(vertex_point, surface), mesh, points, copies)) {
    remove_elements(mesh);
    copies.clear();
    copy_face_graph(surface, mesh, CGAL::parameters::face_to_face_output_iterator(std::back_inserter(copies)),
                    CGAL::parameters::vertex_point_map(points));
  }
  return copies;
}

/* The same, and the faces get their labels. */
template <class FaceGraph, class FacePatchMap, class NamedParameters>
void copy_from_core(const Surface& surface, Face_patch_map patch, FaceGraph& mesh, FacePatchMap labels,
                    const NamedParameters& np) {
  for (const auto& c : copy_from_core(surface, mesh, np))
    put(labels, c.second, patch[c.first]);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_CONVERT_SURFACE_H
