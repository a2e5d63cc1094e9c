// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_SUBDIVIDE_INTO_HEXAHEDRA_IMPL_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_SUBDIVIDE_INTO_HEXAHEDRA_IMPL_H

#include <CGAL/Tubular_meshing/Hexahedra/internal/Edge_division.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Vertex_sets.h>
#include <CGAL/Tubular_meshing/Hexahedra/subdivide_into_hexahedra.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing {

namespace internal {

/* The mesh that subdivide_into_hexahedra() makes, put together. */
class Hexahedral_subdivision {
public:
  typedef std::uint32_t Index;

  explicit Hexahedral_subdivision(const Mixed_mesh& mesh)
      : mesh_(mesh)
      , edges_(mesh)
      , triangles_(mesh.points.size(),
                   [&](const auto& visit) { for_each_face(mesh, visit, [](const std::array<Index, 4>&) {}); })
      , quads_(mesh.points.size(), [&](const auto& visit) {
        for_each_face(
            mesh, [](const std::array<Index, 3>&) {},
            [&](const std::array<Index, 4>& q) {
              if (edges_.is_divided(q[0], q[1]) && edges_.is_divided(q[1], q[2]))
                visit(q);
            });
      }) {}

  Mixed_mesh run() {
    result_.points = mesh_.points;
    result_.point_arrays = mesh_.point_arrays;
    result_.region_names = mesh_.region_names;
    result_.patch_names = mesh_.patch_names;
    result_.patch_ids = mesh_.patch_ids;
    reserve();
    edges_.for_each_divided([&](const Edge_ends& e) { add_mean(e); });
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      add_mean(triangles_[i]);
    for (std::size_t i = 0; i < quads_.size(); ++i)
      add_mean(quads_[i]);
    divide(mesh_.tetrahedra, [&](const auto& c) { return divide_tetrahedron(c); });
    divide(mesh_.prisms, [&](const auto& c) { return divide_prism(c); });
    divide(mesh_.hexahedra, [&](const auto& c) { return divide_hexahedron(c); });
    divide(mesh_.triangles, [&](const auto& f) { return divide_triangle(f); });
    divide(mesh_.quads, [&](const auto& f) { return divide_quad(f); });
    return std::move(result_);
  }

private:
  typedef std::array<Index, 8> Hexahedron;
  typedef std::array<Index, 4> Quad;

  void reserve() {
    const std::size_t points = mesh_.points.size() + edges_.number_of_midpoints() + triangles_.size() + quads_.size() +
                               mesh_.number_of_cells();
    if (points > std::size_t(Index(-1)))
      throw Input_error("The mesh is too large to be subdivided: it would have " + std::to_string(points) + " points.");
    result_.points.reserve(points);
    for (Point_array& a : result_.point_arrays)
      a.values.reserve(points * std::size_t(a.components));
    result_.hexahedra.reserve(4 * mesh_.tetrahedra.size() + 3 * mesh_.prisms.size() + mesh_.hexahedra.size());
    result_.quads.reserve(3 * mesh_.triangles.size() + 2 * mesh_.quads.size());
  }

  // --- points ---

  template <std::size_t N> Index add_mean(const std::array<Index, N>& corners) {
    double x = 0, y = 0, z = 0;
    for (Index v : corners) {
      x += mesh_.points[v].x();
      y += mesh_.points[v].y();
      z += mesh_.points[v].z();
    }
    result_.points.emplace_back(x / double(N), y / double(N), z / double(N));
    for (std::size_t a = 0; a < mesh_.point_arrays.size(); ++a) {
      const Point_array& from = mesh_.point_arrays[a];
      for (std::size_t k = 0; k < std::size_t(from.components); ++k) {
        double sum = 0;
        for (Index v : corners)
          sum += from.values[v * std::size_t(from.components) + k];
        result_.point_arrays[a].values.push_back(sum / double(N));
      }
    }
    return Index(result_.points.size() - 1);
  }

  Index middle(Index a, Index b) const { return edges_.midpoint(a, b); }
  Index middle(Index a, Index b, Index c) const {
    return Index(mesh_.points.size() + edges_.number_of_midpoints() + triangles_.number({{a, b, c}}));
  }
  Index middle(Index a, Index b, Index c, Index d) const {
    return Index(mesh_.points.size() + edges_.number_of_midpoints() + triangles_.size() +
                 quads_.number({{a, b, c, d}}));
  }

  /* The point of an edge, of a face, or of a cell in a grid of hexahedra: the middle of those of its two, four or eight
   * `corners` that it lies between. */
  template <class Add_center> Index middle(const std::vector<Index>& corners, const Add_center& center) const {
    switch (corners.size()) {
    case 1:
      return corners[0];
    case 2:
      return middle(corners[0], corners[1]);
    case 4:
      return middle(corners[0], corners[1], corners[2], corners[3]);
    default:
      return center();
    }
  }

  // --- elements ---

  template <std::size_t N, class Divide> void divide(const Element_block<N>& elements, const Divide& divide_one) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
      label_ = elements.label[i];
      divide_one(elements.vertices[i]);
    }
  }
  void add(const Hexahedron& h) { result_.hexahedra.push_back(h, label_); }
  void add(const Quad& q) { result_.quads.push_back(q, label_); }

  void divide_tetrahedron(const std::array<Index, 4>& t) {
    // of each vertex the others, so that they turn as 1, 2, 3 do seen from 0
    static const int corners[4][4] = {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};
    const Index center = add_mean(t);
    for (const auto& c : corners) {
      const Index v = t[c[0]], a = t[c[1]], b = t[c[2]], d = t[c[3]];
      add(Hexahedron{
          {v, middle(v, a), middle(v, a, b), middle(v, b), middle(v, d), middle(v, a, d), center, middle(v, b, d)}});
    }
  }

  /* Four corners of a prism's level at one of its lateral edges. */
  static Quad at_corner(const std::array<Index, 3>& corner, const std::array<Index, 3>& side, Index center,
                        std::size_t k) {
    return {{corner[k], side[k], center, side[(k + 2) % 3]}};
  }
  void add_between(const Quad& below, const Quad& above) {
    add(Hexahedron{{below[0], below[1], below[2], below[3], above[0], above[1], above[2], above[3]}});
  }

  void divide_prism(const std::array<Index, 6>& p) {
    const auto at = [&](std::size_t k) { // of the triangle from vertex k on
      const std::array<Index, 3> corner = {{p[k], p[k + 1], p[k + 2]}};
      const std::array<Index, 3> side = {
          {middle(corner[0], corner[1]), middle(corner[1], corner[2]), middle(corner[2], corner[0])}};
      const Index center = middle(corner[0], corner[1], corner[2]);
      return [corner, side, center](std::size_t i) { return at_corner(corner, side, center, i); };
    };
    const auto bottom = at(0), top = at(3);
    if (!edges_.is_divided(p[0], p[3])) {
      for (std::size_t k = 0; k < 3; ++k)
        add_between(bottom(k), top(k));
      return;
    }
    const std::array<Index, 3> corner = {{middle(p[0], p[3]), middle(p[1], p[4]), middle(p[2], p[5])}};
    const std::array<Index, 3> side = {
        {middle(p[0], p[1], p[4], p[3]), middle(p[1], p[2], p[5], p[4]), middle(p[2], p[0], p[3], p[5])}};
    const Index center = add_mean(p);
    for (std::size_t k = 0; k < 3; ++k) {
      const Quad between = at_corner(corner, side, center, k);
      add_between(bottom(k), between);
      add_between(between, top(k));
    }
  }

  void divide_hexahedron(const Hexahedron& h) {
    const std::array<std::size_t, 3> step = {{step_along(h[0], h[1]), step_along(h[0], h[3]), step_along(h[0], h[4])}};
    const Index center = step == std::array<std::size_t, 3>{{1, 1, 1}} ? add_mean(h) : 0;
    const auto point = [&](std::size_t i, std::size_t j, std::size_t k) { // each from 0 to 2
      static const int number[2][2][2] = {{{0, 4}, {3, 7}}, {{1, 5}, {2, 6}}};
      std::vector<Index> corners;
      for (std::size_t x : ends(i))
        for (std::size_t y : ends(j))
          for (std::size_t z : ends(k))
            corners.push_back(h[std::size_t(number[x][y][z])]);
      return middle(corners, [&] { return center; });
    };
    for (std::size_t i = 0; i < 2; i += step[0])
      for (std::size_t j = 0; j < 2; j += step[1])
        for (std::size_t k = 0; k < 2; k += step[2]) {
          const std::size_t x = i + step[0], y = j + step[1], z = k + step[2];
          add(Hexahedron{{point(i, j, k), point(x, j, k), point(x, y, k), point(i, y, k), point(i, j, z),
                          point(x, j, z), point(x, y, z), point(i, y, z)}});
        }
  }

  // Along an edge from 0 to 2: half of it, if it is divided.
  std::size_t step_along(Index a, Index b) const { return edges_.is_divided(a, b) ? 1 : 2; }
  // Between which ends of an edge a point of it lies.
  static std::vector<std::size_t> ends(std::size_t i) {
    return i == 1 ? std::vector<std::size_t>{0, 1} : std::vector<std::size_t>{i / 2};
  }

  void divide_triangle(const std::array<Index, 3>& t) {
    const std::array<Index, 3> side = {{middle(t[0], t[1]), middle(t[1], t[2]), middle(t[2], t[0])}};
    for (std::size_t k = 0; k < 3; ++k)
      add(at_corner(t, side, middle(t[0], t[1], t[2]), k));
  }

  void divide_quad(const Quad& q) {
    const std::size_t along = step_along(q[0], q[1]), across = step_along(q[1], q[2]);
    const auto point = [&](std::size_t i, std::size_t j) {
      static const int number[2][2] = {{0, 3}, {1, 2}};
      std::vector<Index> corners;
      for (std::size_t x : ends(i))
        for (std::size_t y : ends(j))
          corners.push_back(q[std::size_t(number[x][y])]);
      return middle(corners, [] { return Index(0); });
    };
    for (std::size_t i = 0; i < 2; i += along)
      for (std::size_t j = 0; j < 2; j += across)
        add(Quad{{point(i, j), point(i + along, j), point(i + along, j + across), point(i, j + across)}});
  }

  const Mixed_mesh& mesh_;
  Edge_division edges_;
  Vertex_sets<3> triangles_; // all of them
  Vertex_sets<4> quads_;     // that are divided in four
  Mixed_mesh result_;
  int label_ = 0; // of the element that is being divided
};

template <std::size_t N> void check_points_are_there(const Element_block<N>& elements, std::size_t points) {
  for (const auto& e : elements.vertices)
    for (std::uint32_t v : e)
      if (v >= points)
        throw Input_error("An element names point " + std::to_string(v) + ", but the mesh has " +
                          std::to_string(points) + " points.");
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Mixed_mesh subdivide_into_hexahedra(const Mixed_mesh& mesh) {
  if (!mesh.pyramids.empty())
    throw Input_error("The mesh has " + std::to_string(mesh.pyramids.size()) +
                      " pyramids, which cannot be divided into hexahedra: fill a surface of triangles instead.");
  const std::size_t points = mesh.points.size();
  internal::check_points_are_there(mesh.tetrahedra, points);
  internal::check_points_are_there(mesh.prisms, points);
  internal::check_points_are_there(mesh.hexahedra, points);
  internal::check_points_are_there(mesh.triangles, points);
  internal::check_points_are_there(mesh.quads, points);
  return internal::Hexahedral_subdivision(mesh).run();
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_SUBDIVIDE_INTO_HEXAHEDRA_IMPL_H
