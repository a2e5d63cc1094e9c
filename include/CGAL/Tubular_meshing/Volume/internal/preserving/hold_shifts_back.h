// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PRESERVING_HOLD_SHIFTS_BACK_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PRESERVING_HOLD_SHIFTS_BACK_H

#include <CGAL/Tubular_meshing/Patches/pieces/crossing_faces.h>
#include <CGAL/Tubular_meshing/Volume/internal/preserving/Shift_holder.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/metric_quality.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/cell_topology.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

// Each of them once, however often it is named. False if all are where they came from: what is at fault there was so
// before.
inline bool hold_back(std::vector<std::size_t> points, Shift_holder& shifts) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  bool any = false;
  for (std::size_t i : points)
    any = shifts.hold_back(i) || any;
  return any;
}

/* What is looked at when vertices are held back: the triangles of a surface, and the edges between two of them. */
class Shapes_of_shifted {
public:
  Shapes_of_shifted(const Surface& mesh, const Shift_holder& shifts)
      : mesh_(mesh)
      , shifts_(shifts) {}

  /* Triangles keep a fair shape, or most of what they had of it: one that has to move far for its size, as at the foot of
   * a branch, would lose it. */
  bool is_spoiled(Face f) const {
    const double fair = 0.55, kept = 0.8; // γ_T, and the part of it that a triangle keeps in any case
    if (mesh_.is_removed(f) || mesh_.degree(f) != 3)
      return false;
    const auto t = corners(mesh_.halfedge(f));
    const double gamma = triangle_gamma(shifts_[t[0]], shifts_[t[1]], shifts_[t[2]]);
    return gamma < fair && gamma < kept * triangle_gamma(shifts_.from(t[0]), shifts_.from(t[1]), shifts_.from(t[2]));
  }

  /* Where the surface is folded, it is not folded further: its sides would come to lie on each other. */
  bool is_folded_further(Edge e) const {
    const double folded = -0.4, kept = 0.7; // the cosine between the normals, a rim's is near 0; a part of what is left
    if (mesh_.is_removed(e) || mesh_.is_border(e))
      return false;
    const Halfedge h = mesh_.halfedge(e), g = mesh_.opposite(h);
    if (mesh_.degree(mesh_.face(h)) != 3 || mesh_.degree(mesh_.face(g)) != 3)
      return false;
    const auto s = corners(h), t = corners(g);
    const double now = cosine(s, t, [&](std::size_t v) { return shifts_[v]; });
    return now < folded && 1 + now < kept * (1 + cosine(
                                                     s, t, [&](std::size_t v) { return shifts_.from(v); }));
  }

  void add_corners(Face f, std::vector<std::size_t>& to) const { add(corners(mesh_.halfedge(f)), to); }
  void add_corners(Edge e, std::vector<std::size_t>& to) const {
    add(corners(mesh_.halfedge(e)), to);
    add(corners(mesh_.opposite(mesh_.halfedge(e))), to);
  }

private:
  typedef std::array<std::size_t, 3> Corners;

  Corners corners(Halfedge h) const {
    return {{std::size_t(mesh_.source(h)), std::size_t(mesh_.target(h)), std::size_t(mesh_.target(mesh_.next(h)))}};
  }
  template <class Place> static double cosine(const Corners& s, const Corners& t, const Place& place) {
    const auto area = [&](const Corners& c) { return cross(place(c[1]) - place(c[0]), place(c[2]) - place(c[0])); };
    const Vector_3d a = area(s), b = area(t);
    const double lengths = norm(a) * norm(b);
    return lengths > 0 ? dot(a, b) / lengths : 1;
  }
  static void add(const Corners& c, std::vector<std::size_t>& to) { to.insert(to.end(), c.begin(), c.end()); }

  const Surface& mesh_;
  const Shift_holder& shifts_;
};

/* Holds back what spoils triangles, or folds the surface further. Ends, as what is held back goes to where it was. */
inline void keep_shapes(const Surface& mesh, Shift_holder& shifts, int threads) {
  const Shapes_of_shifted shapes(mesh, shifts);
  std::vector<char> spoiled(mesh.num_faces()), folded(mesh.num_edges());
  std::vector<std::size_t> at_fault;
  do {
    for_each_range(spoiled.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        spoiled[i] = shapes.is_spoiled(Face(Surface::size_type(i)));
    });
    for_each_range(folded.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        folded[i] = shapes.is_folded_further(Edge(Surface::size_type(i)));
    });
    at_fault.clear();
    for (std::size_t i = 0; i < spoiled.size(); ++i)
      if (spoiled[i])
        shapes.add_corners(Face(Surface::size_type(i)), at_fault);
    for (std::size_t i = 0; i < folded.size(); ++i)
      if (folded[i])
        shapes.add_corners(Edge(Surface::size_type(i)), at_fault);
  } while (hold_back(at_fault, shifts));
}

// Moves a surface; where it would meet itself, less. After the first round only what has been held back is looked at.
inline void move_without_crossings(Surface& mesh, Shift_holder& shifts, int threads) {
  keep_shapes(mesh, shifts, threads);
  constexpr int most_rounds = 24;
  std::vector<Face> faces(mesh.faces_begin(), mesh.faces_end());
  std::vector<char> is_held(mesh.num_vertices(), 0);
  const auto move = [&] {
    for (auto v : mesh.vertices())
      mesh.point(v) = shifts.point(std::size_t(v));
  };
  move();
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<std::size_t> at_fault;
    for (const auto& c : crossing_faces(faces, mesh))
      for (auto f : {c.first, c.second})
        for (auto v : mesh.vertices_around_face(mesh.halfedge(f)))
          at_fault.push_back(std::size_t(v));
    is_held.assign(is_held.size(), 0);
    for (std::size_t v : at_fault)
      is_held[v] = 1;
    if (!hold_back(std::move(at_fault), shifts))
      return;
    move();
    faces = faces_near(mesh, [&](Vertex v) { return is_held[std::size_t(v)] != 0; });
  }
  shifts.hold_all_back();
  move();
}

/* A hexahedron keeps a fair scaled Jacobian at a corner, or most of what it had. */
inline bool spoils_corner(const Shift_holder& shifts, const std::array<std::uint32_t, 4>& t) {
  const double fair = 0.25, kept = 0.9;
  const auto scaled = [](const Vector_3d& p, const Vector_3d& a, const Vector_3d& b, const Vector_3d& c) {
    const Vector_3d u = a - p, v = b - p, w = c - p;
    const double lengths = norm(u) * norm(v) * norm(w);
    return lengths > 0 ? dot(cross(u, v), w) / lengths : 0;
  };
  const double now = scaled(shifts[t[0]], shifts[t[1]], shifts[t[2]], shifts[t[3]]);
  return now < fair && now < kept * scaled(shifts.from(t[0]), shifts.from(t[1]), shifts.from(t[2]), shifts.from(t[3]));
}

/* What cells keep at each of their corners: a part of the volume there, and hexahedra their shape, unless they are
 * going to be optimized. */
struct Kept_of_cells {
  double volume = 0.3;
  bool shape = true;
};

/* The points of the corners at fault: a corner's volume is that of its point and the three next to it, and no other
 * point of the cell could help. */
template <std::size_t N>
void add_points_of_crushed_corners(const Element_block<N>& cells, const Shift_holder& shifts, const Kept_of_cells& kept,
                                   std::vector<std::size_t>& points) {
  for (const auto& c : cells.vertices)
    for (const Corner& corner : Cell_topology<N>::corners()) {
      std::array<std::uint32_t, 4> t;
      for (std::size_t k = 0; k < 4; ++k)
        t[k] = c[std::size_t(corner[k])];
      const double before = signed_volume(shifts.from(t[0]), shifts.from(t[1]), shifts.from(t[2]), shifts.from(t[3]));
      if (!(signed_volume(shifts[t[0]], shifts[t[1]], shifts[t[2]], shifts[t[3]]) > kept.volume * before) ||
          (N == 8 && kept.shape && spoils_corner(shifts, t)))
        points.insert(points.end(), t.begin(), t.end());
    }
}

/* The points of tetrahedra that lose their shape in the metric that the mesh carries, if it does: they keep a fair one,
 * or most of what they had. Where its layers at the wall are low, shifts that differ little from point to point can
 * cost a tetrahedron most of its height, and still be within the bounds for volumes. */
inline void add_points_of_spoiled_tetrahedra(const Mixed_mesh& mesh, const Shift_holder& shifts, int threads,
                                             std::vector<std::size_t>& points) {
  const double fair = 0.3, kept = 0.9; // of the inverse of Q, eq. (16)
  const auto array = std::find_if(mesh.point_arrays.begin(), mesh.point_arrays.end(), [&](const Point_array& a) {
    return a.is_metric() && a.values.size() == 6 * mesh.points.size();
  });
  if (array == mesh.point_arrays.end())
    return;
  const auto metric = [&](std::uint32_t v) {
    const double* m = array->values.data() + 6 * std::size_t(v);
    return Metric_tensor_3(m[0], m[1], m[2], m[3], m[4], m[5]);
  };
  const auto& tetrahedra = mesh.tetrahedra.vertices;
  const std::size_t piece = 4096;
  std::vector<std::vector<std::size_t>> at_fault((tetrahedra.size() + piece - 1) / piece);
  for_each_task(at_fault.size(), threads, [&](std::size_t p) {
    for (std::size_t k = p * piece; k < (std::min)((p + 1) * piece, tetrahedra.size()); ++k) {
      const auto& t = tetrahedra[k];
      if (std::none_of(t.begin(), t.end(), [&](std::uint32_t v) { return shifts.is_moved(v); }))
        continue;
      const Metric_tensor_3 mean = 0.25 * (metric(t[0]) + metric(t[1]) + metric(t[2]) + metric(t[3]));
      const auto quality = [&](const Vector_3d& a, const Vector_3d& b, const Vector_3d& c, const Vector_3d& d) {
        return metric_shape(b - a, c - a, d - a, mean).quality();
      };
      const double now = quality(shifts[t[0]], shifts[t[1]], shifts[t[2]], shifts[t[3]]);
      if (now < fair &&
          now < kept * quality(shifts.from(t[0]), shifts.from(t[1]), shifts.from(t[2]), shifts.from(t[3])))
        at_fault[p].insert(at_fault[p].end(), t.begin(), t.end());
    }
  });
  for (const std::vector<std::size_t>& list : at_fault)
    points.insert(points.end(), list.begin(), list.end());
}

/* Corners of cells at fault hold their points back, and then those around. Shapes in a metric are kept in the
 * first rounds, so that they hold back no points but those near by. If that comes to no end nothing moves at all. */
inline void keep_cells(const Mixed_mesh& mesh, const Kept_of_cells& kept, int threads, Shift_holder& shifts) {
  constexpr int most_rounds = 60, most_rounds_for_metric = 20;
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<std::size_t> at_fault;
    if (round < most_rounds_for_metric)
      add_points_of_spoiled_tetrahedra(mesh, shifts, threads, at_fault);
    add_points_of_crushed_corners(mesh.tetrahedra, shifts, kept, at_fault);
    add_points_of_crushed_corners(mesh.pyramids, shifts, kept, at_fault);
    add_points_of_crushed_corners(mesh.prisms, shifts, kept, at_fault);
    add_points_of_crushed_corners(mesh.hexahedra, shifts, kept, at_fault);
    if (!hold_back(std::move(at_fault), shifts))
      return;
  }
  shifts.hold_all_back();
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PRESERVING_HOLD_SHIFTS_BACK_H
