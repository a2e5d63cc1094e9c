// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADRATIC_MAKE_QUADRATIC_MESH_IMPL_H
#define CGAL_TUBULAR_MESHING_QUADRATIC_MAKE_QUADRATIC_MESH_IMPL_H

#include <CGAL/Tubular_meshing/Quadratic/internal/Cell_straightener.h>
#include <CGAL/Tubular_meshing/Quadratic/internal/Curved_nodes.h>
#include <CGAL/Tubular_meshing/Quadratic/internal/Mesh_boundary.h>
#include <CGAL/Tubular_meshing/Quadratic/internal/Smooth_wall.h>
#include <CGAL/Tubular_meshing/Quadratic/internal/Wall_follower.h>
#include <CGAL/Tubular_meshing/Quadratic/make_quadratic_mesh.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

CGAL_TUBULAR_MESHING_INLINE std::string Quadratic_report::text() const {
  const auto counted = [](std::size_t n, const char* one, const char* many) {
    return std::to_string(n) + (n == 1 ? one : many);
  };
  std::string text = "Every cell is valid";
  if (invalid > 0)
    text = counted(invalid, " cell is", " cells are") + " not valid, even with straight edges";
  if (relaxed > 0)
    text += "; for that " + counted(relaxed, " cell has", " cells have") + " edges less curved than the wall, and " +
            counted(straightened, " has", " have") + " straight ones";
  if (corners_held_back > 0)
    text +=
        "; " + counted(corners_held_back, " corner", " corners") + " of the wall could not go to the smooth surface";
  if (not_found > 0)
    text += "; " + counted(not_found, " node", " nodes") + " of the wall have no part of the surface next to them";
  return text + ".";
}

namespace internal {

/* Curves a mesh: where its nodes are to go, before it is known whether they can. */
class Mesh_bender {
public:
  Mesh_bender(const Quadratic_mesh& mesh, const Smooth_wall& wall, Length_function radius, int threads)
      : mesh_(mesh)
      , wall_(wall)
      , radius_(radius)
      , threads_(threads)
      , sites_(mesh, wall) {}

  Curved_nodes run(Quadratic_report& report) {
    move_corners_of_wall();
    move_edges_of_wall();
    follow();
    std::vector<Vector_3d> shifts, bends;
    for (std::size_t i = 0; i < corners_.size(); ++i)
      shifts.push_back(corners_[i] - old(i));
    for_each_edge([&](std::uint32_t a, std::uint32_t b, std::size_t e) {
      const Vector_3d bend = edges_[e] - 0.5 * (corners_[a] + corners_[b]);
      const double straight = 1e-9; // of the edge's length
      bends.push_back(norm(bend) > straight * norm(corners_[b] - corners_[a]) ? bend : Vector_3d());
    });
    std::vector<Vector_3d> bumps = mesh_.is_complete ? bumps_of_wall() : std::vector<Vector_3d>();
    report.not_found = lost_;
    return Curved_nodes(mesh_, std::move(shifts), std::move(bends), std::move(bumps));
  }

private:
  static constexpr double steepest_bend = 0.3; // of an edge's length: more is another part of the wall

  Vector_3d old(std::size_t i) const { return Vector_3d(mesh_.linear.points[i]); }

  template <class F> void for_each_edge(const F& f) const {
    for (std::size_t a = 0; a + 1 < mesh_.first_edge.size(); ++a)
      for (std::size_t e = mesh_.first_edge[a]; e < mesh_.first_edge[a + 1]; ++e)
        f(std::uint32_t(a), mesh_.edge_end[e], e);
  }
  // The same on all threads.
  template <class F> void for_each_edge_in_parallel(const F& f) const {
    for_each_range(mesh_.linear.points.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t a = first; a < last; ++a)
        for (std::size_t e = mesh_.first_edge[a]; e < mesh_.first_edge[a + 1]; ++e)
          f(std::uint32_t(a), mesh_.edge_end[e], e);
    });
  }

  // Where what is on the wall at x goes; none where it is not found, and x where it has to stay.
  std::optional<Vector_3d> place(const Mesh_boundary::Site& site, const Vector_3d& x, const Vector_3d& normal,
                                 double reach) const {
    if (site.rim == Mesh_boundary::between_openings)
      return x;
    if (site.rim != 0)
      return wall_.nearest_on_rim(site.rim, x, reach);
    const auto found = wall_.nearest(x, normal, reach);
    return found ? std::optional<Vector_3d>(x + sites_.in_plane(site, found->point - x)) : std::nullopt;
  }

  void move_corners_of_wall() {
    corners_.resize(mesh_.linear.points.size());
    std::vector<char> is_lost(corners_.size(), 0);
    for_each_range(corners_.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        corners_[i] = old(i);
        if (!sites_.corner(i).is_on_wall)
          continue;
        const auto found = place(sites_.corner(i), old(i), sites_.normal(i), sites_.reach(i));
        is_lost[i] = !found;
        if (found)
          corners_[i] = *found;
      }
    });
    lost_ += std::size_t(std::count(is_lost.begin(), is_lost.end(), 1));
    if (!wall_.tips().empty())
      move_corners_to_tips();
  }

  /* A tip of the wall that the mesh has cut off gets the next corner. Those that are as good as on the mesh's wall do
   * not: they are no more than roughness. */
  void move_corners_to_tips() {
    constexpr double least_gap = 0.05; // of an edge's length
    std::vector<std::array<std::uint32_t, 3>> facets;
    std::vector<Double_kernel::Triangle_3> triangles;
    for_each_triangle_of_wall([&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      facets.push_back({a, b, c});
      triangles.emplace_back(to_double_point(corners_[a]), to_double_point(corners_[b]), to_double_point(corners_[c]));
    });
    const Nearest_tree<Double_kernel::Triangle_3> tree(std::move(triangles));
    std::map<std::uint32_t, std::pair<double, Vector_3d>> tip_of; // of a corner the nearest one
    for (const Smooth_wall::Place& tip : wall_.tips()) {
      const auto found = tree.nearest(to_double_point(tip.point), (std::numeric_limits<double>::infinity)());
      if (found.index >= facets.size())
        continue;
      const auto& f = facets[found.index];
      const std::uint32_t corner = *std::min_element(f.begin(), f.end(), [&](std::uint32_t a, std::uint32_t b) {
        return squared_norm(corners_[a] - tip.point) < squared_norm(corners_[b] - tip.point);
      });
      const double reach = sites_.reach(corner), gap = std::sqrt(found.squared_distance);
      const double way = norm(corners_[corner] - tip.point);
      if (sites_.corner(corner).rim != 0 || sites_.corner(corner).plane != 0 || gap < least_gap * reach ||
          way > reach || !(dot(sites_.normal(corner), tip.normal) > 0))
        continue;
      const auto place = tip_of.emplace(corner, std::make_pair(way, tip.point)).first;
      if (way < place->second.first)
        place->second = {way, tip.point};
    }
    for (const auto& t : tip_of)
      corners_[t.first] = t.second.second;
  }

  template <class F> void for_each_triangle_of_wall(const F& f) const {
    const auto& triangles = mesh_.linear.triangles;
    for (std::size_t i = 0; i < triangles.size(); ++i)
      if (triangles.label[i] == labels::wall)
        f(triangles.vertices[i][0], triangles.vertices[i][1], triangles.vertices[i][2]);
    const auto& quads = mesh_.linear.quads;
    for (std::size_t i = 0; i < quads.size(); ++i)
      if (quads.label[i] == labels::wall)
        for (std::size_t k = 1; k < 3; ++k)
          f(quads.vertices[i][0], quads.vertices[i][k], quads.vertices[i][k + 1]);
  }

  void move_edges_of_wall() {
    edges_.resize(mesh_.edge_end.size());
    std::vector<char> is_lost(edges_.size(), 0);
    for_each_edge_in_parallel([&](std::uint32_t a, std::uint32_t b, std::size_t e) {
      const Vector_3d middle = 0.5 * (corners_[a] + corners_[b]);
      edges_[e] = middle;
      if (!sites_.edge(e).is_on_wall)
        return;
      const Vector_3d normal = normalized(sites_.normal(a)) + normalized(sites_.normal(b));
      const auto found = place(sites_.edge(e), middle, normal, steepest_bend * norm(corners_[b] - corners_[a]));
      is_lost[e] = !found;
      if (found)
        edges_[e] = *found;
    });
    lost_ += std::size_t(std::count(is_lost.begin(), is_lost.end(), 1));
  }

  // Of what is not on the wall.
  void follow() {
    const std::vector<Vector_3d> wall_corners = corners_, wall_edges = edges_;
    const Wall_follower follower(mesh_, wall_corners, wall_edges);
    std::vector<double> radius(corners_.size()); // of edges it is the mean of that at their ends, as it takes its time
    for_each_range(corners_.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        radius[i] = radius_(mesh_.linear.points[i]);
    });
    const auto moved = [&](const Vector_3d& x, const Mesh_boundary::Site& site, double r, bool is_in_lumen) {
      return x + sites_.in_plane(site, follower.shift(x, r, is_in_lumen));
    };
    for_each_range(corners_.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        if (!sites_.corner(i).is_on_wall)
          corners_[i] = moved(old(i), sites_.corner(i), radius[i], sites_.is_in_lumen(i));
    });
    for_each_edge_in_parallel([&](std::uint32_t a, std::uint32_t b, std::size_t e) {
      if (!sites_.edge(e).is_on_wall)
        edges_[e] = moved(0.5 * (old(a) + old(b)), sites_.edge(e), 0.5 * (radius[a] + radius[b]),
                          sites_.is_in_lumen(a) && sites_.is_in_lumen(b));
    });
  }

  // How far the middles of the wall's quads are from where their edges imply them.
  std::vector<Vector_3d> bumps_of_wall() const {
    std::vector<Vector_3d> bumps(mesh_.quads.size());
    const auto& quads = mesh_.linear.quads;
    for_each_range(quads.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        if (quads.label[i] != labels::wall)
          continue;
        const auto& v = quads.vertices[i];
        const Vector_3d middle =
            middle_of_quad([&](std::size_t k) { return corners_[v[k]]; },
                           [&](std::size_t k) { return edges_[mesh_.edge(v[k], v[(k + 1) % 4])]; });
        Vector_3d normal;
        for (std::uint32_t k : v)
          normal += normalized(sites_.normal(k));
        const double reach = steepest_bend * norm(corners_[v[2]] - corners_[v[0]]);
        const auto found = wall_.nearest(middle, normal, reach);
        if (found)
          bumps[mesh_.quad(v)] = found->point - middle;
      }
    });
    return bumps;
  }

  const Quadratic_mesh& mesh_;
  const Smooth_wall& wall_;
  Length_function radius_;
  int threads_;
  const Mesh_boundary sites_;
  std::vector<Vector_3d> corners_, edges_; // where they go
  std::size_t lost_ = 0;
};

inline void set_points(Quadratic_mesh& mesh, const Curved_nodes& nodes) {
  const auto point = [](const Vector_3d& p) { return as<Point_3>(p); };
  mesh.edge_points.resize(mesh.edge_end.size());
  for (std::size_t a = 0; a + 1 < mesh.first_edge.size(); ++a)
    for (std::size_t e = mesh.first_edge[a]; e < mesh.first_edge[a + 1]; ++e)
      mesh.edge_points[e] = point(nodes.middle_of_edge(std::uint32_t(a), mesh.edge_end[e], e));
  if (mesh.is_complete) {
    mesh.quad_points.resize(mesh.quads.size());
    mesh.inner_points.resize(mesh.linear.hexahedra.size());
    const auto set = [&](Element_type type, const auto& block) {
      const Element_topology& t = topology_of(type);
      for (std::size_t i = 0; i < block.size(); ++i) {
        const std::uint32_t* const v = block.vertices[i].data();
        const Cell_points cell = nodes.cell(type, v);
        for (std::size_t q = 0; q < t.number_of_quads; ++q) {
          Quadratic_mesh::Quad corners;
          for (std::size_t k = 0; k < 4; ++k)
            corners[k] = v[std::size_t(t.quads[q][k])];
          mesh.quad_points[mesh.quad(corners)] = point(cell.point[t.corners + t.number_of_edges + q]);
        }
        if (type == Element_type::hexahedron)
          mesh.inner_points[i] = point(cell.point[26]);
      }
    };
    for_each_block_of_cells(mesh.linear, set);
  }
  for (std::size_t i = 0; i < mesh.linear.points.size(); ++i) // the nodes above are from where they were
    mesh.linear.points[i] = point(Vector_3d(mesh.linear.points[i]) + nodes.shifts[i]);
}

CGAL_TUBULAR_MESHING_INLINE Quadratic_report make_quadratic_mesh(Mixed_mesh linear, const Surface& input,
                                                                 Face_patch_map input_patch, Length_function radius,
                                                                 Quadratic_mesh& result,
                                                                 const Quadratic_options& options) {
  Quadratic_report report;
  result = Quadratic_mesh();
  result.linear = std::move(linear);
  result.is_complete = options.complete_elements;
  add_edges_and_quads(result, options.number_of_threads);
  const Smooth_wall wall(input, input_patch, options.number_of_threads);
  Curved_nodes nodes = Mesh_bender(result, wall, radius, options.number_of_threads).run(report);
  Cell_straightener straightener(result, nodes, options.number_of_threads);
  straightener.run();
  report.relaxed = straightener.number_relaxed();
  report.straightened = straightener.number_straightened();
  const std::vector<std::uint32_t> invalid = straightener.invalid_ones(); // with straight edges
  report.invalid = invalid.size();
  report.relaxed -= report.invalid;
  report.straightened -= report.invalid;
  if (!invalid.empty())
    report.invalid_place = result.linear.points[invalid.front()];
  for (std::size_t i = 0; i < nodes.shifts.size(); ++i) {
    report.largest_shift = (std::max)(report.largest_shift, norm(nodes.shifts[i]));
    report.corners_held_back += nodes.shifts.is_held_back(i);
  }
  for (std::size_t e = 0; e < nodes.bends.size(); ++e) {
    report.largest_bend = (std::max)(report.largest_bend, norm(nodes.bends[e]));
    report.curved_edges += nodes.bends.is_there(e);
  }
  set_points(result, nodes);
  return report;
}

} // namespace internal
} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_QUADRATIC_MAKE_QUADRATIC_MESH_IMPL_H
