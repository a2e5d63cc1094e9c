// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_JOIN_PARTS_IMPL_H
#define CGAL_TUBULAR_MESHING_PIPELINES_JOIN_PARTS_IMPL_H

#include <CGAL/Tubular_meshing/Pipelines/internal/Part_labels.h>
#include <CGAL/Tubular_meshing/Pipelines/join_parts.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {
namespace internal {

inline void check_number_of_parts(std::size_t parts, std::size_t openings) {
  if (parts != openings)
    throw Input_error("There are " + std::to_string(parts) + " parts, but " + std::to_string(openings) +
                      " numbers of openings.");
}

template <std::size_t N, class Label>
void append_elements(Element_block<N>& all, const Element_block<N>& part, std::uint32_t first, const Label& label) {
  for (std::size_t i = 0; i < part.size(); ++i) {
    auto element = part.vertices[i];
    for (std::uint32_t& v : element)
      v += first;
    all.push_back(element, label(part.label[i]));
  }
}

inline void add_ids(Patch_ids& all, const Patch_ids& part, const Part_labels& labels) {
  if (all.array.empty())
    all.array = part.array;
  for (const auto& id : part.id)
    all.id.emplace(labels(id.first), id.second);
}

inline void add_labels(Labelled_ends& all, const Labelled_ends& part) {
  const std::size_t before = all.ends.size();
  if (all.empty())
    all = part;
  else
    all.ends.insert(all.ends.end(), part.ends.begin(), part.ends.end());
  if (all.inlet == Labelled_ends::none && part.inlet != Labelled_ends::none)
    all.inlet = before + part.inlet;
}

inline void append_part(Mixed_mesh& all, const Mixed_mesh& part, const Part_labels& labels) {
  const std::uint32_t first = std::uint32_t(all.points.size());
  const auto region = [](int label) { return label; };
  all.points.insert(all.points.end(), part.points.begin(), part.points.end());
  append_elements(all.tetrahedra, part.tetrahedra, first, region);
  append_elements(all.pyramids, part.pyramids, first, region);
  append_elements(all.prisms, part.prisms, first, region);
  append_elements(all.hexahedra, part.hexahedra, first, region);
  append_elements(all.triangles, part.triangles, first, labels);
  append_elements(all.quads, part.quads, first, labels);
  all.region_names.insert(part.region_names.begin(), part.region_names.end());
  for (const auto& name : part.patch_names)
    all.patch_names.emplace(labels(name.first), labels.name(name.first, name.second));
  add_ids(all.patch_ids, part.patch_ids, labels);
}

// Those that all parts have.
inline std::vector<Point_array> joined_arrays(const std::vector<Mixed_mesh>& parts) {
  std::vector<Point_array> arrays = parts.front().point_arrays;
  for (std::size_t k = 1; k < parts.size(); ++k) {
    std::vector<Point_array> common;
    for (Point_array& a : arrays)
      for (const Point_array& b : parts[k].point_arrays)
        if (a.name == b.name && a.components == b.components) {
          a.values.insert(a.values.end(), b.values.begin(), b.values.end());
          common.push_back(std::move(a));
          break;
        }
    arrays.swap(common);
  }
  return arrays;
}

// Adds the vertices and faces, and returns where its vertices begin.
inline Surface::size_type append_surface(Surface& all, const Surface& part, std::vector<Surface::Face_index>& faces) {
  const Surface::size_type first = all.number_of_vertices();
  std::vector<Surface::Vertex_index> vertices(part.num_vertices());
  for (auto v : part.vertices())
    vertices[std::size_t(v)] = all.add_vertex(part.point(v));
  faces.assign(part.num_faces(), Surface::null_face());
  std::vector<Surface::Vertex_index> corners;
  for (auto f : part.faces()) {
    corners.clear();
    for (auto v : CGAL::vertices_around_face(part.halfedge(f), part))
      corners.push_back(vertices[std::size_t(v)]);
    std::rotate(corners.begin(), corners.end() - 1, corners.end()); // so that the face's halfedge is the same
    faces[std::size_t(f)] = all.add_face(corners);
  }
  return first;
}

// Of the graphs one; each component keeps its directions.
inline Centerline_graph joined_centerlines(const std::vector<Tubular_model>& parts) {
  std::vector<Point_3> points;
  std::vector<double> radii;
  std::vector<Centerline_graph::Polyline> branches;
  std::vector<std::size_t> root_points;
  for (const Tubular_model& part : parts) {
    const Centerline_graph& graph = part.centerlines;
    const std::size_t first = points.size();
    points.insert(points.end(), graph.points().begin(), graph.points().end());
    radii.insert(radii.end(), graph.radii().begin(), graph.radii().end());
    for (const auto& b : graph.branches()) {
      branches.push_back(b.points);
      for (std::size_t& p : branches.back())
        p += first;
    }
    if (!graph.empty())
      root_points.push_back(first + graph.nodes()[graph.root()].point);
  }
  Centerline_graph joined(std::move(points), std::move(radii), std::move(branches));
  std::vector<std::size_t> roots;
  for (std::size_t p : root_points)
    for (std::size_t n = 0; n < joined.nodes().size(); ++n)
      if (joined.nodes()[n].point == p)
        roots.push_back(n);
  joined.direct_from(roots);
  return joined;
}

template <class Map> void add_counts(Map& all, const Map& part) {
  for (const auto& entry : part)
    all[entry.first] += entry.second;
}

inline void add_report(Patch_report& all, const Patch_report& part) {
  add_counts(all.kinds, part.kinds);
  add_counts(all.methods, part.methods);
  all.largest_aspect_ratio = (std::max)(all.largest_aspect_ratio, part.largest_aspect_ratio);
  all.moved_cuts += part.moved_cuts;
  all.refined_patches += part.refined_patches;
  all.smoothed_places += part.smoothed_places;
  all.problems.insert(all.problems.end(), part.problems.begin(), part.problems.end());
}

inline void add_report(Quad_report& all, const Quad_report& part) {
  const double quads = double(all.wall_quads()), more = double(part.wall_quads());
  if (quads + more > 0)
    all.mean_eta = (all.mean_eta * quads + part.mean_eta * more) / (quads + more);
  all.structured_quads += part.structured_quads;
  all.unstructured_quads += part.unstructured_quads;
  all.cap_quads += part.cap_quads;
  all.cap_triangles += part.cap_triangles;
  all.irregular_vertices += part.irregular_vertices;
  all.annular_patches_without_grid += part.annular_patches_without_grid;
  all.folded_quads += part.folded_quads;
  all.least_eta = (std::min)(all.least_eta, part.least_eta);
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Mixed_mesh join_parts(std::vector<Mixed_mesh> parts,
                                                  const std::vector<std::size_t>& openings) {
  internal::check_number_of_parts(parts.size(), openings.size());
  if (parts.size() == 1)
    return std::move(parts.front());
  Mixed_mesh all;
  for (std::size_t k = 0; k < parts.size(); ++k)
    internal::append_part(all, parts[k], internal::Part_labels(openings, k));
  if (!parts.empty())
    all.point_arrays = internal::joined_arrays(parts);
  return all;
}

CGAL_TUBULAR_MESHING_INLINE Tubular_model join_parts(std::vector<Tubular_model> parts) {
  if (parts.size() == 1)
    return std::move(parts.front());
  Tubular_model all;
  std::vector<std::size_t> openings;
  for (const Tubular_model& part : parts)
    openings.push_back(part.openings.size());
  std::size_t branches = 0, points = 0;
  all.centerlines = internal::joined_centerlines(parts);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Tubular_model& part = parts[k];
    const internal::Part_labels labels(openings, k);
    std::vector<Surface::Face_index> faces;
    internal::append_surface(all.surface, part.surface, faces);
    for (auto f : part.surface.faces())
      all.patch[faces[std::size_t(f)]] = labels(part.patch[f]);
    for (Opening o : part.openings) {
      o.patch = labels(o.patch);
      if (o.branch != Opening::no_branch)
        o.branch += branches;
      if (o.node != Opening::no_branch) {
        const std::size_t point = points + part.centerlines.nodes()[o.node].point;
        const auto& nodes = all.centerlines.nodes();
        o.node = std::size_t(std::find_if(nodes.begin(), nodes.end(), [&](const auto& n) { return n.point == point; }) -
                             nodes.begin());
      }
      all.openings.push_back(o);
    }
    all.round_ends.insert(all.round_ends.end(), part.round_ends.begin(), part.round_ends.end());
    for (const auto& name : patch_names(part))
      all.patch_names.emplace(labels(name.first), labels.name(name.first, name.second));
    internal::add_ids(all.patch_ids, part.patch_ids, labels);
    internal::add_labels(all.labels, part.labels);
    branches += part.centerlines.branches().size();
    points += part.centerlines.points().size();
  }
  return all;
}

CGAL_TUBULAR_MESHING_INLINE Remeshed_surface join_parts(std::vector<Remeshed_surface> parts,
                                                        const std::vector<std::size_t>& openings) {
  internal::check_number_of_parts(parts.size(), openings.size());
  if (parts.size() == 1)
    return std::move(parts.front());
  Remeshed_surface all;
  int patches = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Remeshed_surface& part = parts[k];
    const internal::Part_labels labels(openings, k);
    std::vector<Surface::Face_index> faces;
    const auto first = internal::append_surface(all.surface, part.surface, faces);
    int largest = -1;
    for (auto f : part.surface.faces()) {
      const int patch = part.patch_of_face[f];
      largest = (std::max)(largest, patch);
      all.patch[faces[std::size_t(f)]] = labels(part.patch[f]);
      all.patch_of_face[faces[std::size_t(f)]] = patch < 0 ? patch : patches + patch;
    }
    patches += largest + 1;
    for (const auto& curve : part.curves) {
      all.curves.emplace_back();
      for (auto v : curve)
        all.curves.back().push_back(Surface::Vertex_index(first + Surface::size_type(v)));
    }
    all.metrics.insert(all.metrics.end(), part.metrics.begin(), part.metrics.end());
    internal::add_report(all.report, part.report);
    internal::add_report(all.quads, part.quads);
  }
  if (all.metrics.size() != all.surface.number_of_vertices())
    all.metrics.clear();
  return all;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PIPELINES_JOIN_PARTS_IMPL_H
