// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_REPAIR_CROSSINGS_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_REPAIR_CROSSINGS_H

#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/Repair/internal/fill_wall.h>
#include <CGAL/Tubular_meshing/base/crossing_pairs.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <CGAL/utility.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* What is wrong with the shape of a surface: faces that cross each other, or turn back on each other. */
struct Bad_faces {
  typedef Surface::Face_index Face;
  std::vector<Face> faces; ///< sorted
  std::size_t crossings = 0, folds = 0;
  Point_3 crossing, fold; ///< where the first ones are

  bool empty() const { return faces.empty(); }
};

inline bool is_folded(Surface::Edge_index e, const Surface& mesh) {
  if (mesh.is_border(e))
    return false;
  const Vector_3 m = area_vector(mesh.halfedge(e, 0), mesh), n = area_vector(mesh.halfedge(e, 1), mesh);
  const double cosine = m * n; // times the areas
  return cosine < 0 &&
         cosine * cosine > 0.81 * m.squared_length() * n.squared_length(); // turns by more than 154 degrees
}

inline Bad_faces find_bad_faces(const Surface& mesh) {
  Bad_faces bad;
  const auto pairs = crossing_pairs(mesh);
  bad.crossings = pairs.size();
  if (!pairs.empty())
    bad.crossing = mesh.point(mesh.target(mesh.halfedge(pairs[0].first)));
  for (const auto& pair : pairs) {
    bad.faces.push_back(pair.first);
    bad.faces.push_back(pair.second);
  }
  for (auto e : mesh.edges())
    if (is_folded(e, mesh)) {
      if (bad.folds++ == 0)
        bad.fold = mesh.point(mesh.vertex(e, 0));
      bad.faces.push_back(mesh.face(mesh.halfedge(e, 0)));
      bad.faces.push_back(mesh.face(mesh.halfedge(e, 1)));
    }
  std::sort(bad.faces.begin(), bad.faces.end());
  bad.faces.erase(std::unique(bad.faces.begin(), bad.faces.end()), bad.faces.end());
  return bad;
}

/* Repairs crossing and folded faces in place: first by smoothing them and the faces around, bent like the wall or flat,
 * which is taken back where it does not help, then by replacing them with a patch that is bent like the wall around it,
 * then ever larger patches, without bending: walls that pierce each other retreat from each other. Where bad faces
 * reach a rim, they are removed, and the notch is filled up to a chord. O(n log n) for each of at most ten rounds. */
class Crossing_repairer {
  typedef Surface::Vertex_index Vertex;
  typedef Surface::Halfedge_index Halfedge;
  typedef Surface::Face_index Face;
  typedef std::unordered_set<Face> Faces;

public:
  explicit Crossing_repairer(Surface& mesh)
      : mesh_(mesh) {}

  /* Whether nothing bad is left. */
  bool repair(Bad_faces bad) {
    for (int round = 0; round < 4 && !bad.empty(); ++round)
      bad = smooth(bad, (round + 1) / 2, round < 2);
    return bad.empty() || replace_all([&] { return find_bad_faces(mesh_).faces; });
  }

  /* Replaces what `find` returns, with ever more faces around, until it returns none. Whether it does. */
  bool replace_all(Function_view<std::vector<Face>()> find) {
    std::vector<Face> faces = find();
    for (int round = 0; round < 6 && !faces.empty(); ++round) {
      for (const Faces& patch : patches_around(faces, 1 + round / 2))
        replace(patch, round < 2);
      mesh_.collect_garbage();
      faces = find();
    }
    return faces.empty();
  }

private:
  Bad_faces smooth(const Bad_faces& bad, int rings, bool bent) {
    std::vector<std::vector<std::pair<Vertex, Point_3>>> before;
    std::vector<Faces> patches = patches_around(bad.faces, rings);
    for (const Faces& patch : patches) {
      std::vector<Vertex> vertices = inner_vertices(patch);
      before.emplace_back();
      for (Vertex v : vertices)
        before.back().emplace_back(v, mesh_.point(v));
      relax(mesh_, vertices, bent ? 6 : 4);
      if (bent)
        bend(mesh_, vertices, 40);
    }
    const Bad_faces left = find_bad_faces(mesh_);
    for (std::size_t i = 0; i < patches.size(); ++i)
      if (std::any_of(left.faces.begin(), left.faces.end(), [&](Face f) { return patches[i].count(f) > 0; }))
        for (const auto& v : before[i])
          mesh_.point(v.first) = v.second;
    return left.empty() ? left : find_bad_faces(mesh_);
  }

  // The vertices of the faces, but for those on the border, in a fixed order.
  std::vector<Vertex> inner_vertices(const Faces& patch) const {
    std::vector<Vertex> vertices;
    for (Face f : patch)
      for (Vertex v : CGAL::vertices_around_face(mesh_.halfedge(f), mesh_))
        if (!mesh_.is_border(v))
          vertices.push_back(v);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
  }

  // The connected sets of the faces and so many rings around them; what is to be replaced has to be a simple region.
  std::vector<Faces> patches_around(const std::vector<Face>& bad, int rings) const {
    std::vector<Face> front = bad;
    Faces all(bad.begin(), bad.end());
    for (int i = 0; i < rings; ++i) {
      std::vector<Face> next;
      for (Face f : front)
        for (Vertex v : CGAL::vertices_around_face(mesh_.halfedge(f), mesh_))
          add_faces_around(v, all, next);
      front.swap(next);
    }
    std::vector<Face> order(all.begin(), all.end());
    std::sort(order.begin(), order.end());
    std::vector<Faces> patches;
    Faces visited;
    for (Face seed : order) {
      if (!visited.insert(seed).second)
        continue;
      std::vector<Face> patch = {seed};
      for (std::size_t i = 0; i < patch.size(); ++i)
        for (Face g : CGAL::faces_around_face(mesh_.halfedge(patch[i]), mesh_))
          if (all.count(g) && visited.insert(g).second)
            patch.push_back(g);
      patches.emplace_back(patch.begin(), patch.end());
    }
    return patches;
  }

  void add_faces_around(Vertex v, Faces& all, std::vector<Face>& added) const {
    for (Face f : CGAL::faces_around_target(mesh_.halfedge(v), mesh_))
      if (f != Surface::null_face() && all.insert(f).second)
        added.push_back(f);
  }

  // The halfedges of the faces whose other side is another face's, or the border's.
  std::vector<Halfedge> boundary(const Faces& patch) const {
    std::vector<Halfedge> sides;
    for (Face f : patch)
      for (Halfedge h : CGAL::halfedges_around_face(mesh_.halfedge(f), mesh_))
        if (!patch.count(mesh_.face(mesh_.opposite(h))))
          sides.push_back(h);
    std::sort(sides.begin(), sides.end());
    return sides;
  }

  // Where the boundary of the faces touches itself, all faces around are added.
  void make_simple(Faces& patch) const {
    for (int i = 0; i < 10; ++i) {
      std::unordered_set<Vertex> seen;
      std::vector<Face> added;
      for (Halfedge h : boundary(patch))
        if (!seen.insert(mesh_.target(h)).second)
          add_faces_around(mesh_.target(h), patch, added);
      if (added.empty())
        return;
    }
  }

  // Adds what the faces enclose, which is smaller than they are: where bad faces go round sound ones, all are replaced.
  void fill_in(Faces& patch) const {
    const std::size_t most = (std::min)(patch.size(), std::size_t(mesh_.number_of_faces()) / 4);
    Faces outside;
    for (Halfedge h : boundary(patch)) {
      const Face first = mesh_.face(mesh_.opposite(h));
      if (first == Surface::null_face() || patch.count(first) || outside.count(first))
        continue;
      Faces visited = {first};
      std::vector<Face> region = {first};
      bool enclosed = true;
      for (std::size_t i = 0; enclosed && i < region.size(); ++i)
        for (Halfedge side : CGAL::halfedges_around_face(mesh_.halfedge(region[i]), mesh_)) {
          const Face next = mesh_.face(mesh_.opposite(side));
          enclosed = enclosed && next != Surface::null_face() && !outside.count(next) && region.size() <= most;
          if (enclosed && !patch.count(next) && visited.insert(next).second)
            region.push_back(next);
        }
      (enclosed ? patch : outside).insert(region.begin(), region.end());
    }
  }

  void replace(Faces patch, bool bent) {
    for (Face f : patch)
      if (mesh_.is_removed(f)) // two patches of this round have grown into each other
        return;
    make_simple(patch);
    fill_in(patch);
    for (Face f : patch)
      if (mesh_.is_removed(f))
        return;
    std::vector<Halfedge> sides = boundary(patch);
    const bool at_rim =
        std::any_of(sides.begin(), sides.end(), [&](Halfedge h) { return mesh_.is_border(mesh_.opposite(h)); });
    if (!at_rim && !is_disk(patch, sides))
      return;
    std::vector<Face> order(patch.begin(), patch.end());
    std::sort(order.begin(), order.end());
    if (at_rim && !stays_simple(patch))
      return;
    for (Face f : order)
      CGAL::Euler::remove_face(mesh_.halfedge(f), mesh_);
    if (at_rim)
      straighten_rim(sides);
    else
      fill_wall(mesh_, sides.front(), bent);
  }

  // Fills the notch that removed faces have left in a rim, up to the chord of its ends. The sides are those of the
  // removed faces, by now on the border or gone.
  void straighten_rim(const std::vector<Halfedge>& sides) {
    const std::unordered_set<Halfedge> all(sides.begin(), sides.end());
    const auto in_notch = [&](Halfedge h) { return all.count(h) > 0 && !mesh_.is_removed(h) && mesh_.is_border(h); };
    auto first =
        std::find_if(sides.begin(), sides.end(), [&](Halfedge h) { return in_notch(h) && !in_notch(mesh_.prev(h)); });
    if (first == sides.end())
      return;
    std::vector<Vertex> notch = {mesh_.source(*first)};
    std::vector<Point_3> polyline = {mesh_.point(notch.front())};
    for (Halfedge h = *first; in_notch(h); h = mesh_.next(h)) {
      notch.push_back(mesh_.target(h));
      polyline.push_back(mesh_.point(notch.back()));
    }
    if (notch.size() < 3 || mesh_.halfedge(notch.front(), notch.back()) != Surface::null_halfedge())
      return;
    std::vector<CGAL::Triple<int, int, int>> triangles;
    Polygon_mesh_processing::triangulate_hole_polyline(polyline, std::back_inserter(triangles));
    std::vector<std::array<int, 3>> ordered;
    for (const auto& t : triangles) {
      ordered.push_back({t.first, t.second, t.third});
      std::sort(ordered.back().begin(), ordered.back().end()); // along the border
    }
    for (const auto& t : ordered)
      for (int k = 0; k < 3; ++k)
        if (t[(k + 1) % 3] - t[k] != 1 &&
            mesh_.halfedge(notch[t[k]], notch[t[(k + 1) % 3]]) != Surface::null_halfedge())
          return; // an edge that the wall has already
    for (const auto& t : ordered)
      mesh_.add_face(notch[t[0]], notch[t[1]], notch[t[2]]);
  }

  bool is_disk(const Faces& patch, const std::vector<Halfedge>& sides) const {
    std::unordered_set<Vertex> vertices;
    for (Face f : patch)
      for (Vertex v : CGAL::vertices_around_face(mesh_.halfedge(f), mesh_))
        vertices.insert(v);
    const std::size_t edges = (3 * patch.size() + sides.size()) / 2;
    return vertices.size() + patch.size() == edges + 1;
  }

  // Whether no vertex would be touched by two borders without the faces, and no rim be lost.
  bool stays_simple(const Faces& patch) const {
    std::unordered_set<Vertex> vertices;
    std::size_t ends = 0; // of the paths that the faces share with the border
    for (Halfedge h : boundary(patch)) {
      vertices.insert(mesh_.target(h));
      const bool outside = mesh_.is_border(mesh_.opposite(h));
      Halfedge next = mesh_.next(h);
      while (patch.count(mesh_.face(mesh_.opposite(next))))
        next = mesh_.next(mesh_.opposite(next));
      ends += outside != mesh_.is_border(mesh_.opposite(next));
    }
    if (ends != 2)
      return false;
    for (Vertex v : vertices) {
      std::size_t fans = 0; // of faces that stay
      for (Halfedge h : CGAL::halfedges_around_target(mesh_.halfedge(v), mesh_)) {
        const Face f = mesh_.face(h), g = mesh_.face(mesh_.opposite(h));
        fans += stays(f, patch) && !stays(g, patch);
      }
      if (fans > 1)
        return false;
    }
    return true;
  }

  bool stays(Face f, const Faces& patch) const { return f != Surface::null_face() && patch.count(f) == 0; }

  Surface& mesh_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_REPAIR_CROSSINGS_H
