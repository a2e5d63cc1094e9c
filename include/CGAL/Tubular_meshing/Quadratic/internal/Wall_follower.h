// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_WALL_FOLLOWER_H
#define CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_WALL_FOLLOWER_H

#include <CGAL/Tubular_meshing/Quadratic/Quadratic_mesh.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* How far what is off the wall goes with it, as the wall's straight facets become curved ones: as far as the point of
 * the wall that is nearest, times a factor. In a round vessel of radius r the sagitta of a chord at a distance d from
 * the wall is less by d / r, so layers keep the proportions of their heights; from there it falls to none at half the
 * radius. Outside of the lumen it is more by d / r. */
class Wall_follower {
public:
  /* corners, edges: where the nodes of the wall go. */
  Wall_follower(const Quadratic_mesh& mesh, const std::vector<Vector_3d>& corners, const std::vector<Vector_3d>& edges)
      : mesh_(mesh)
      , corners_(corners)
      , edges_(edges) {
    std::vector<Double_kernel::Triangle_3> triangles;
    const auto add = [&](const std::uint32_t* v, std::size_t a, std::size_t b, std::size_t c, std::size_t n) {
      Part part;
      part.corners = n;
      for (std::size_t k = 0; k < n; ++k)
        part.corner[k] = v[k];
      part.at = {std::uint8_t(a), std::uint8_t(b), std::uint8_t(c)};
      const Double_kernel::Triangle_3 t(to_double_point(old(v[a])), to_double_point(old(v[b])),
                                        to_double_point(old(v[c])));
      if (!(squared_norm(cross(Vector_3d(t[1]) - Vector_3d(t[0]), Vector_3d(t[2]) - Vector_3d(t[0]))) > 0))
        return;
      parts_.push_back(part);
      triangles.push_back(t);
    };
    for (std::size_t i = 0; i < mesh.linear.triangles.size(); ++i)
      if (mesh.linear.triangles.label[i] == labels::wall)
        add(mesh.linear.triangles.vertices[i].data(), 0, 1, 2, 3);
    for (std::size_t i = 0; i < mesh.linear.quads.size(); ++i)
      if (mesh.linear.quads.label[i] == labels::wall) {
        add(mesh.linear.quads.vertices[i].data(), 0, 1, 2, 4);
        add(mesh.linear.quads.vertices[i].data(), 0, 2, 3, 4);
      }
    tree_ = Nearest_tree<Double_kernel::Triangle_3>(std::move(triangles));
  }

  Vector_3d shift(const Vector_3d& x, double radius, bool is_in_lumen) const {
    const double reach = 0.5 * radius;
    const double infinity = (std::numeric_limits<double>::infinity)();
    const auto found = tree_.nearest(to_double_point(x), is_in_lumen ? reach * reach : infinity);
    if (found.index >= tree_.size() || !(radius > 0))
      return Vector_3d();
    const double distance = std::sqrt(found.squared_distance);
    return factor(distance, radius, is_in_lumen) * shift_of_wall(parts_[found.index], Vector_3d(found.point));
  }

private:
  struct Part { // of a facet: a triangle between three of its corners
    std::array<std::uint32_t, 4> corner;
    std::size_t corners;
    std::array<std::uint8_t, 3> at;
  };

  static double factor(double distance, double radius, bool is_in_lumen) {
    if (!is_in_lumen)
      return 1 + distance / radius;
    const double t = 2 * distance / radius;
    return t >= 1 ? 0 : (1 - distance / radius) * (1 - t * t * (3 - 2 * t));
  }

  Vector_3d old(std::uint32_t v) const { return Vector_3d(mesh_.linear.points[v]); }
  Vector_3d edge(std::uint32_t a, std::uint32_t b) const { return edges_[mesh_.edge(a, b)]; }

  Vector_3d shift_of_wall(const Part& part, const Vector_3d& x) const {
    const auto& v = part.corner;
    const Vector_3d a = old(v[part.at[0]]), b = old(v[part.at[1]]), c = old(v[part.at[2]]), n = cross(b - a, c - a);
    const double area = squared_norm(n);
    const double p = dot(cross(c - b, x - b), n) / area, q = dot(cross(a - c, x - c), n) / area, r = 1 - p - q;
    if (part.corners == 3)
      return p * (2 * p - 1) * corners_[v[0]] + q * (2 * q - 1) * corners_[v[1]] + r * (2 * r - 1) * corners_[v[2]] +
             4 * p * q * edge(v[0], v[1]) + 4 * q * r * edge(v[1], v[2]) + 4 * r * p * edge(v[2], v[0]) -
             (p * a + q * b + r * c);
    // in the square, whose corners these are
    const double side[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const double weight[3] = {p, q, r};
    double s = 0, t = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      s += weight[k] * side[part.at[k]][0];
      t += weight[k] * side[part.at[k]][1];
    }
    Vector_3d curved;
    for (std::size_t k = 0; k < 4; ++k) {
      const double sk = side[k][0], tk = side[k][1];
      curved += 0.25 * (1 + sk * s) * (1 + tk * t) * (sk * s + tk * t - 1) * corners_[v[k]];
    }
    curved += 0.5 * (1 - s * s) * (1 - t) * edge(v[0], v[1]) + 0.5 * (1 - t * t) * (1 + s) * edge(v[1], v[2]) +
              0.5 * (1 - s * s) * (1 + t) * edge(v[2], v[3]) + 0.5 * (1 - t * t) * (1 - s) * edge(v[3], v[0]);
    return curved - (p * a + q * b + r * c);
  }

  const Quadratic_mesh& mesh_;
  const std::vector<Vector_3d>&corners_, &edges_;
  std::vector<Part> parts_;
  Nearest_tree<Double_kernel::Triangle_3> tree_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_WALL_FOLLOWER_H
