// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_UNTANGLING_OFF_WALL_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_UNTANGLING_OFF_WALL_H

#include <CGAL/Tubular_meshing/Hexahedra/internal/Hexahedron_optimizer.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Hexahedron_stars.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Sliding_surface.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Star_energy.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Wall_of_lumen.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Untangles some hexahedra of a mesh whose vertices on the wall stand in each other's way while they must stay there, as
 * in a sharp crotch: these leave the wall, as if they were inside, and come back to it step by step, with nothing
 * inverted on the way. They come back to where the wall is nearest, which may be another vessel's: whether the place is
 * filled once is to be asked afterwards, see Hexahedron_overlaps. */
class Untangling_off_wall {
public:
  typedef std::uint32_t Index;

  Untangling_off_wall(const Mixed_mesh& mesh, const std::vector<Index>& hexahedra, const Wall_of_lumen& wall)
      : wall_(wall)
      , number_(mesh.points.size(), none) {
    add_hexahedra(mesh, hexahedra);
    is_fixed_.assign(vertex_.size(), false);
    std::vector<bool> is_on_wall(vertex_.size(), false);
    add_facets(mesh, is_on_wall);
    for (Index v = 0; v < vertex_.size(); ++v)
      if (is_on_wall[v] && !is_fixed_[v])
        wall_vertices_.push_back(v);
    stars_ = Hexahedron_stars(part_.hexahedra, part_.points.size());
  }

  /* False if hexahedra are inverted even then. Where vertices cannot come back without inverting others, they stay a
   * little off the wall.
   * `surface`, `patch`: what `sliding` was made of. */
  bool run(const Surface& surface, Face_patch_map patch, const Sliding_surface& sliding, int threads) {
    constexpr int steps = 12;
    constexpr double nearer = 0.6; // from step to step
    constexpr double on_wall = (std::numeric_limits<double>::min)();
    Optimize_hexahedra_options options;
    options.number_of_threads = threads;
    options.quality_wanted = 0.2;
    options.fixed_vertices = &is_fixed_;
    options.untangling_sweeps = 100;
    const auto optimize = [&](double slack) {
      return Hexahedron_optimizer(part_, surface, patch, options, sliding, slack).run();
    };
    if (optimize((std::numeric_limits<double>::infinity)()).inverted > 0)
      return false;
    double slack = 0;
    for (Index v : wall_vertices_)
      slack = (std::max)(slack, wall_.distance(Vector_3d(part_.points[v])));
    options.number_of_sweeps = 4;
    for (int step = 1; step <= steps; ++step) {
      slack = step < steps ? nearer * slack : 0;
      go_back(slack);
      optimize((std::max)(slack, on_wall));
    }
    return true;
  }

  void bring_to(Mixed_mesh& mesh) const {
    for (std::size_t i = 0; i < vertex_.size(); ++i)
      mesh.points[vertex_[i]] = part_.points[i];
  }

private:
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  void add_hexahedra(const Mixed_mesh& mesh, const std::vector<Index>& hexahedra) {
    for (Index h : hexahedra) {
      std::array<Index, 8> vertices;
      for (std::size_t k = 0; k < 8; ++k) {
        const Index v = mesh.hexahedra.vertices[h][k];
        if (number_[v] == none) {
          number_[v] = Index(vertex_.size());
          vertex_.push_back(v);
          part_.points.push_back(mesh.points[v]);
        }
        vertices[k] = number_[v];
      }
      part_.hexahedra.push_back(vertices, labels::lumen);
    }
  }

  // Of the wall. Vertices of openings are fixed, and those shared with the rest of the mesh.
  void add_facets(const Mixed_mesh& mesh, std::vector<bool>& is_on_wall) {
    for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
      const int label = mesh.quads.label[i];
      std::array<Index, 4> q = mesh.quads.vertices[i];
      for (Index& v : q)
        v = number_[v];
      if (label != labels::wall)
        fix(q);
      else if (std::find(q.begin(), q.end(), none) == q.end()) {
        part_.quads.push_back(q, label);
        for (Index v : q)
          is_on_wall[v] = true;
      }
    }
    std::vector<std::size_t> number_in_part(part_.points.size(), 0), number_in_all(part_.points.size(), 0);
    for (const auto& h : part_.hexahedra.vertices)
      for (Index v : h)
        ++number_in_part[v];
    for (const auto& h : mesh.hexahedra.vertices)
      for (Index v : h)
        if (number_[v] != none)
          ++number_in_all[number_[v]];
    for (std::size_t v = 0; v < is_fixed_.size(); ++v)
      if (number_in_part[v] != number_in_all[v])
        is_fixed_[v] = true;
  }
  void fix(const std::array<Index, 4>& q) {
    for (Index v : q)
      if (v != none)
        is_fixed_[v] = true;
  }

  // Moves vertices to where they are no farther off the wall than that, or less where hexahedra would be inverted.
  void go_back(double slack) {
    for (Index v : wall_vertices_) {
      const Vector_3d from(part_.points[v]), way = wall_.nearest(from) - from;
      const double distance = norm(way);
      double t = distance > slack ? 1 - slack / distance : 0;
      for (int k = 0; k < 5 && t > 0; ++k, t /= 2) {
        part_.points[v] = as<Point_3>(from + t * way);
        if (is_valid_around(v))
          break;
        part_.points[v] = as<Point_3>(from);
      }
    }
  }
  bool is_valid_around(Index v) const {
    for (const auto& e : stars_(v)) {
      Hexahedron_points p;
      for (std::size_t c = 0; c < 8; ++c)
        p[c] = Vector_3d(part_.points[part_.hexahedra.vertices[e.hexahedron()][c]]);
      if (!(least_scaled_jacobian(p) > 0))
        return false;
    }
    return true;
  }

  const Wall_of_lumen& wall_;
  std::vector<Index> number_; // of each vertex of the whole; none if it is not here
  std::vector<Index> vertex_; // of the whole, of each here
  Mixed_mesh part_;
  std::vector<bool> is_fixed_; // of the vertices here
  std::vector<Index> wall_vertices_;
  Hexahedron_stars stars_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_UNTANGLING_OFF_WALL_H
