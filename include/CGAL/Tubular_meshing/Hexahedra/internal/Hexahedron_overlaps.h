// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_HEXAHEDRON_OVERLAPS_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_HEXAHEDRON_OVERLAPS_H

#include <CGAL/Tubular_meshing/base/Box_tree.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Whether p lies inside of a hexahedron whose edges are straight and whose faces are bilinear: its place there is found
 * by Newton's method from the middle. For one that is not inverted; within rounding of a face it is no. */
inline bool is_inside_of_hexahedron(const std::array<Vector_3d, 8>& h, const Vector_3d& p) {
  constexpr int most_steps = 12;
  constexpr double settled = 1e-6, margin = 1e-3, far = 3;
  double x = 0.5, y = 0.5, z = 0.5;
  for (int k = 0; k < most_steps; ++k) {
    const std::array<Vector_3d, 4> along = {{h[1] - h[0], h[2] - h[3], h[5] - h[4], h[6] - h[7]}}; // by y and z
    const auto in_plane = [&](const Vector_3d& a, const Vector_3d& b, const Vector_3d& c, const Vector_3d& d) {
      return (1 - z) * ((1 - y) * a + y * b) + z * ((1 - y) * c + y * d);
    };
    const Vector_3d dx = in_plane(along[0], along[1], along[2], along[3]);
    const std::array<Vector_3d, 4> at = {
        {h[0] + x * along[0], h[3] + x * along[1], h[4] + x * along[2], h[7] + x * along[3]}};
    const Vector_3d dy = (1 - z) * (at[1] - at[0]) + z * (at[3] - at[2]);
    const Vector_3d dz = (1 - y) * (at[2] - at[0]) + y * (at[3] - at[1]);
    const Vector_3d gap = p - in_plane(at[0], at[1], at[2], at[3]);
    const Vector_3d yz = cross(dy, dz);
    const double determinant = dot(dx, yz);
    if (!(determinant > 0))
      return false;
    const double sx = dot(gap, yz) / determinant, sy = dot(gap, cross(dz, dx)) / determinant,
                 sz = dot(gap, cross(dx, dy)) / determinant;
    x += sx;
    y += sy;
    z += sz;
    if (!((std::max)({std::abs(x), std::abs(y), std::abs(z)}) < far))
      return false;
    if ((std::max)({std::abs(sx), std::abs(sy), std::abs(sz)}) < settled)
      return (std::min)({x, y, z}) > margin && (std::max)({x, y, z}) < 1 - margin;
  }
  return false;
}

/* Finds places that are filled more than once, among some hexahedra of a mesh. Positive Jacobians do not rule that out:
 * the blocks of two vessels that part slowly may reach into each other. O(n log n) in the hexahedra that count. */
class Hexahedron_overlaps {
public:
  typedef std::uint32_t Index;

  Hexahedron_overlaps(const Mixed_mesh& mesh, std::vector<Index> hexahedra)
      : mesh_(mesh)
      , hexahedra_(std::move(hexahedra)) {
    std::vector<Box> boxes(hexahedra_.size());
    std::vector<Place> centers(hexahedra_.size());
    for (std::size_t i = 0; i < hexahedra_.size(); ++i) {
      for (const Vector_3d& p : corners(i))
        boxes[i].add({{p.x, p.y, p.z}});
      const Vector_3d c = center(i);
      centers[i] = {{c.x, c.y, c.z}};
    }
    tree_ = Box_tree<3>(std::move(boxes), centers);
  }

  /* The number of hexahedra whose center lies in another one that they share no vertex with. Two that share a vertex do
   * not overlap where both are valid. */
  std::size_t count() const {
    std::size_t result = 0;
    for (std::size_t i = 0; i < hexahedra_.size(); ++i) {
      const Vector_3d c = center(i);
      Box box;
      box.add({{c.x, c.y, c.z}});
      bool is_in_another = false;
      tree_.for_each_overlapping(box, [&](Index j) {
        is_in_another = is_in_another || (!share_a_vertex(i, j) && is_inside_of_hexahedron(corners(j), c));
      });
      result += is_in_another;
    }
    return result;
  }

private:
  typedef Box_tree<3>::Box Box;
  typedef Box_tree<3>::Place Place;

  std::array<Vector_3d, 8> corners(std::size_t i) const {
    std::array<Vector_3d, 8> p;
    for (std::size_t k = 0; k < 8; ++k)
      p[k] = Vector_3d(mesh_.points[mesh_.hexahedra.vertices[hexahedra_[i]][k]]);
    return p;
  }
  Vector_3d center(std::size_t i) const {
    Vector_3d sum;
    for (const Vector_3d& p : corners(i))
      sum += p;
    return 0.125 * sum;
  }
  bool share_a_vertex(std::size_t i, std::size_t j) const {
    const auto &a = mesh_.hexahedra.vertices[hexahedra_[i]], &b = mesh_.hexahedra.vertices[hexahedra_[j]];
    return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
  }

  const Mixed_mesh& mesh_;
  const std::vector<Index> hexahedra_;
  Box_tree<3> tree_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_HEXAHEDRON_OVERLAPS_H
