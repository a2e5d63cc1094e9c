// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_MESH_BOUNDARY_H
#define CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_MESH_BOUNDARY_H

#include <CGAL/Tubular_meshing/Quadratic/Quadratic_mesh.h>
#include <CGAL/Tubular_meshing/Quadratic/internal/Smooth_wall.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Where the corners and edges of a mesh are: on the lumen's wall, on the rim of an opening, in the plane of a flat
 * patch; in the lumen, or outside of it. */
class Mesh_boundary {
public:
  struct Site {
    bool is_on_wall = false;
    int rim = 0;   // the opening, of those on a rim; between_openings
    int plane = 0; // the flat patch that it is in, or 0
  };
  static constexpr int between_openings = -1;

  Mesh_boundary(const Quadratic_mesh& mesh, const Smooth_wall& wall)
      : mesh_(mesh)
      , corners_(mesh.linear.points.size())
      , edges_(mesh.edge_end.size())
      , normals_(corners_.size())
      , reach_(corners_.size(), 0)
      , is_in_lumen_(corners_.size(), 0) {
    find_planes();
    const auto on_wall = [&](const Element_topology& t, const std::uint32_t* v, int) { add_wall_facet(t, v); };
    const auto beside = [&](const Element_topology& t, const std::uint32_t* v, int label) {
      add_other_facet(t, v, label, wall);
    };
    for_each_facet([](int label) { return label == labels::wall; }, on_wall);
    for_each_facet([](int label) { return label != labels::wall; }, beside);
    mark_lumen();
  }

  const Site& corner(std::size_t i) const { return corners_[i]; }
  const Site& edge(std::size_t i) const { return edges_[i]; }
  // Of the wall at a corner, outward.
  const Vector_3d& normal(std::size_t corner) const { return normals_[corner]; }
  // The longest edge of the wall at a corner.
  double reach(std::size_t corner) const { return reach_[corner]; }
  // Cells of the lumen have the corner.
  bool is_in_lumen(std::size_t corner) const { return is_in_lumen_[corner] != 0; }

  // The part of a shift that leaves what is in a plane there.
  Vector_3d in_plane(const Site& site, const Vector_3d& shift) const {
    if (site.plane == 0)
      return shift;
    const Vector_3d& n = planes_.at(site.plane);
    return shift - dot(shift, n) * n;
  }

private:
  template <class Counts, class Visit> void for_each_facet(const Counts& counts, const Visit& visit) const {
    for_each_block_of_facets(mesh_.linear, [&](Element_type type, const auto& block) {
      const Element_topology& t = topology_of(type);
      for (std::size_t i = 0; i < block.size(); ++i)
        if (counts(block.label[i]))
          visit(t, block.vertices[i].data(), block.label[i]);
    });
  }

  Vector_3d point(std::uint32_t i) const { return Vector_3d(mesh_.linear.points[i]); }

  static std::size_t next(const Element_topology& t, std::size_t k) { return (k + 1) % t.corners; }

  Vector_3d area(const Element_topology& t, const std::uint32_t* v) const {
    Vector_3d sum;
    for (std::size_t k = 1; k + 1 < t.corners; ++k)
      sum += 0.5 * cross(point(v[k]) - point(v[0]), point(v[k + 1]) - point(v[0]));
    return sum;
  }

  // The patches, but for the wall, whose corners are all in a plane.
  void find_planes() {
    const auto all = [](int label) { return label != labels::wall; };
    struct Flat {
      Vector_3d area, first;
      bool has_first = false;
      double extent = 0, off = 0;
    };
    std::map<int, Flat> patches;
    for_each_facet(all, [&](const Element_topology& t, const std::uint32_t* v, int label) {
      Flat& p = patches[label];
      p.area += area(t, v);
      if (!p.has_first)
        p.first = point(v[0]);
      p.has_first = true;
    });
    for (auto& p : patches)
      p.second.area = normalized(p.second.area);
    for_each_facet(all, [&](const Element_topology& t, const std::uint32_t* v, int label) {
      Flat& p = patches[label];
      for (std::size_t k = 0; k < t.corners; ++k) {
        const Vector_3d d = point(v[k]) - p.first;
        p.extent = (std::max)(p.extent, norm(d));
        p.off = (std::max)(p.off, std::abs(dot(d, p.area)));
      }
    });
    const double flat = 1e-3; // of the extent: a cap that was put into a plane is so but for rounding
    for (const auto& p : patches)
      if (p.second.off <= flat * p.second.extent && p.second.extent > 0)
        planes_[p.first] = p.second.area;
  }

  void add_wall_facet(const Element_topology& t, const std::uint32_t* v) {
    const Vector_3d n = area(t, v);
    for (std::size_t k = 0; k < t.corners; ++k) {
      const std::uint32_t a = v[k], b = v[next(t, k)];
      corners_[a].is_on_wall = true;
      normals_[a] += n;
      const double length = norm(point(b) - point(a));
      reach_[a] = (std::max)(reach_[a], length);
      reach_[b] = (std::max)(reach_[b], length);
      edges_[mesh_.edge(a, b)].is_on_wall = true;
    }
  }

  void add_other_facet(const Element_topology& t, const std::uint32_t* v, int label, const Smooth_wall& wall) {
    const bool is_opening = wall.has_rim(label), is_flat = planes_.count(label) != 0;
    const auto add = [&](Site& site) {
      if (site.is_on_wall && is_opening)
        site.rim = site.rim == 0 || site.rim == label ? label : between_openings;
      if (is_flat && site.plane == 0)
        site.plane = label;
    };
    for (std::size_t k = 0; k < t.corners; ++k) {
      add(corners_[v[k]]);
      add(edges_[mesh_.edge(v[k], v[next(t, k)])]);
    }
  }

  void mark_lumen() {
    for_each_block_of_cells(mesh_.linear, [&](Element_type, const auto& block) {
      for (std::size_t i = 0; i < block.size(); ++i)
        if (block.label[i] == labels::lumen)
          for (std::uint32_t v : block.vertices[i])
            is_in_lumen_[v] = 1;
    });
  }

  const Quadratic_mesh& mesh_;
  std::vector<Site> corners_, edges_;
  std::vector<Vector_3d> normals_;
  std::vector<double> reach_;
  std::vector<char> is_in_lumen_;
  std::map<int, Vector_3d> planes_; // normals
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADRATIC_INTERNAL_MESH_BOUNDARY_H
