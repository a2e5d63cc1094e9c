// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_COVER_OF_LUMEN_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_COVER_OF_LUMEN_H

#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Block_builder.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Hexahedron_overlaps.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Junction_shape.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Vessel_network.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Wall_of_lumen.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Whether hexahedra along vessels fill the lumen, all of it and once. */
class Cover_of_lumen {
public:
  Cover_of_lumen(const Surface& surface, const Wall_of_lumen& wall, const Vessel_network& network, Length_function size,
                 double points_per_circumference, int threads)
      : surface_(surface)
      , wall_(wall)
      , network_(network)
      , size_(size)
      , size_of_radius_(2 * pi / points_per_circumference)
      , threads_(threads) {}

  /* The parts of the surface that a mesh misses by more than a radius of the vessel nearest to them, the worst first: the
   * vertices of each, the farthest first. */
  std::vector<std::vector<Vertex>> missed_parts(const Mixed_mesh& mesh) const {
    constexpr double most = 1;
    const std::vector<double> gap = gaps(mesh).in_radii;
    std::vector<std::size_t> worst;
    for (std::size_t i = 0; i < gap.size(); ++i)
      if (gap[i] > most)
        worst.push_back(i);
    const auto is_farther = [&](std::size_t i, std::size_t j) {
      return gap[i] > gap[j] || (gap[i] == gap[j] && i < j);
    };
    std::sort(worst.begin(), worst.end(), is_farther);
    std::vector<std::vector<Vertex>> result;
    std::vector<bool> known(gap.size(), false);
    for (std::size_t i : worst)
      if (!known[i]) {
        result.push_back(part_from(vertex(i), most / 2, gap, known));
        std::sort(result.back().begin(), result.back().end(), is_farther);
      }
    return result;
  }

  // Junctions of vessels whose hexahedra reach into each other.
  std::vector<std::size_t> overlapping(const Network_blocks& blocks) const {
    return junctions_where(
        [&](std::size_t n) { return Hexahedron_overlaps(blocks.mesh, hexahedra_round(n, blocks)).count() > 0; });
  }

  /* Junctions whose hexahedra leave out more of the lumen than facets do in any case: pockets of the wall. */
  std::vector<std::size_t> with_pockets(const Network_blocks& blocks) const {
    constexpr double depth = 0.25; // in radii
    constexpr double most = 0.02;  // of the junction's volume
    const Gaps g = gaps(blocks.mesh);
    std::vector<std::pair<Vector_3d, double>> pockets; // place and volume of what lies before a vertex
    for (std::size_t i = 0; i < g.in_radii.size(); ++i)
      if (g.in_radii[i] > depth)
        pockets.emplace_back(Vector_3d(surface_.point(vertex(i))), g.length[i] * area_at(vertex(i)));
    if (pockets.empty())
      return {};
    return junctions_where([&](std::size_t n) {
      const double reach = reach_of(n);
      double left_out = 0, filled = 0;
      for (const auto& [place, volume] : pockets)
        left_out += norm(place - network_.nodes[n].point) < reach ? volume : 0;
      if (left_out == 0)
        return false;
      for (std::uint32_t h : hexahedra_round(n, blocks))
        filled += volume_of(blocks.mesh, h);
      return left_out > most * filled;
    });
  }

  // Those of a junction's vessels, as far as the lumen is one there, and some more.
  std::vector<std::uint32_t> hexahedra_round(std::size_t node, const Network_blocks& blocks) const {
    const double reach = reach_of(node);
    std::set<std::size_t> vessels;
    for (const auto& e : network_.nodes[node].ends)
      vessels.insert(e.vessel);
    std::vector<std::uint32_t> hexahedra;
    for (std::size_t v : vessels)
      for (std::size_t h = blocks.first[v]; h < blocks.first[v + 1]; ++h)
        if (norm(Vector_3d(blocks.mesh.points[blocks.mesh.hexahedra.vertices[h][0]]) - network_.nodes[node].point) <
            reach)
          hexahedra.push_back(std::uint32_t(h));
    return hexahedra;
  }

private:
  // How far each vertex of the surface is from a mesh, and the same in radii of the vessel there.
  struct Gaps {
    std::vector<double> length, in_radii;
  };

  static Vertex vertex(std::size_t i) { return Vertex(Surface::size_type(i)); }

  Gaps gaps(const Mixed_mesh& mesh) const {
    std::vector<std::array<Point_3, 3>> triangles;
    for (const auto& q : mesh.quads.vertices) {
      triangles.push_back({mesh.points[q[0]], mesh.points[q[1]], mesh.points[q[2]]});
      triangles.push_back({mesh.points[q[0]], mesh.points[q[2]], mesh.points[q[3]]});
    }
    const Wall_distance distance(triangles);
    Gaps result;
    result.length.assign(surface_.number_of_vertices(), 0);
    result.in_radii.assign(surface_.number_of_vertices(), 0);
    for_each_range(result.length.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const Point_3& p = surface_.point(vertex(i));
        const Wall_distance::Place q = distance.closest_place(p);
        const auto t = distance.triangle(q.triangle);
        const double edge = std::pow(CGAL::cross_product(t[1] - t[0], t[2] - t[0]).squared_length(), 0.25);
        // of a quad and of the size, as that is small where the wall has a pit or a spike
        const double radius = (std::max)(edge, size_(q.point)) / size_of_radius_;
        result.length[i] = std::sqrt(CGAL::squared_distance(p, q.point));
        result.in_radii[i] = result.length[i] / radius;
      }
    });
    return result;
  }

  // The vertices round one with gaps above a bound, which are known then.
  std::vector<Vertex> part_from(Vertex v, double bound, const std::vector<double>& gap,
                                std::vector<bool>& known) const {
    std::vector<Vertex> part{v};
    known[v] = true;
    for (std::size_t k = 0; k < part.size(); ++k)
      for (Vertex w : CGAL::vertices_around_target(surface_.halfedge(part[k]), surface_))
        if (gap[w] > bound && !known[w]) {
          known[w] = true;
          part.push_back(w);
        }
    return part;
  }

  template <class Holds> std::vector<std::size_t> junctions_where(const Holds& holds) const {
    std::vector<char> is_one(network_.nodes.size(), 0);
    for_each_task(is_one.size(), threads_,
                  [&](std::size_t n) { is_one[n] = network_.nodes[n].is_junction() && holds(n); });
    std::vector<std::size_t> result;
    for (std::size_t n = 0; n < is_one.size(); ++n)
      if (is_one[n])
        result.push_back(n);
    return result;
  }

  // How far from a junction's node its vessels are apart, and some radii more.
  double reach_of(std::size_t node) const {
    const std::vector<Vessel_path> paths = network_.paths_from(node);
    const std::vector<double> partings = parting_abscissas(paths, exit_abscissas(paths), wall_);
    double reach = 0;
    for (std::size_t k = 0; k < paths.size(); ++k)
      reach = (std::max)(reach, partings[k] + 3 * paths[k].radius(partings[k]));
    return reach;
  }

  double area_at(Vertex v) const { // a third of its faces'
    double area = 0;
    for (Halfedge h : CGAL::halfedges_around_target(surface_.halfedge(v), surface_)) {
      const Vector_3d a(surface_.point(v)), b(surface_.point(surface_.source(h))),
          c(surface_.point(surface_.target(surface_.next(h))));
      area += norm(cross(b - a, c - a)) / 6;
    }
    return area;
  }

  static double volume_of(const Mixed_mesh& mesh, std::size_t h) { // of its edges' mean parallelepiped
    std::array<Vector_3d, 8> p;
    for (std::size_t k = 0; k < 8; ++k)
      p[k] = Vector_3d(mesh.points[mesh.hexahedra.vertices[h][k]]);
    const Vector_3d x = 0.25 * ((p[1] - p[0]) + (p[2] - p[3]) + (p[5] - p[4]) + (p[6] - p[7]));
    const Vector_3d y = 0.25 * ((p[3] - p[0]) + (p[2] - p[1]) + (p[7] - p[4]) + (p[6] - p[5]));
    const Vector_3d z = 0.25 * ((p[4] - p[0]) + (p[5] - p[1]) + (p[6] - p[2]) + (p[7] - p[3]));
    return dot(x, cross(y, z));
  }

  const Surface& surface_;
  const Wall_of_lumen& wall_;
  const Vessel_network& network_;
  Length_function size_;
  double size_of_radius_; // the mesh size where the radius is 1
  int threads_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_COVER_OF_LUMEN_H
