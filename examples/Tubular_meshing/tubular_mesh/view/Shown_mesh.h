// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_VIEW_SHOWN_MESH_H
#define TUBULAR_MESH_VIEW_SHOWN_MESH_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Numbered_cells.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/* A mesh with what pictures and pages show of it: cells and facets are counted through their blocks, and each has its
 * quality and its place along the branches. */
class Shown_mesh {
public:
  typedef CGAL::Tubular_meshing::internal::cells::Numbered_cells Cells;
  typedef CGAL::Tubular_meshing::internal::cells::Face Face;
  typedef CGAL::Tubular_meshing::internal::Vector_3d Vector;
  static constexpr std::uint32_t none = std::uint32_t(-1);

  // Where along the tree: the branch, and the length along it from its source.
  struct Place {
    std::uint32_t branch = 0;
    float abscissa = 0;
  };
  // The cells of a facet: one at the boundary, two between regions, none of a surface.
  typedef std::array<std::uint32_t, 2> Sides;

  // Keeps references to both.
  Shown_mesh(const CGAL::Tubular_meshing::Mixed_mesh& mesh, const CGAL::Tubular_meshing::Centerline_graph& centerlines,
             int threads);

  const CGAL::Tubular_meshing::Mixed_mesh& mesh() const { return mesh_; }
  const CGAL::Tubular_meshing::Centerline_graph& centerlines() const { return centerlines_; }
  const Cells& cells() const { return cells_; }

  std::size_t number_of_facets() const { return mesh_.number_of_facets(); }
  bool is_triangle(std::size_t facet) const { return facet < mesh_.triangles.size(); }
  Face facet(std::size_t f) const;
  int patch(std::size_t facet) const;
  const Sides& sides(std::size_t facet) const { return sides_[facet]; }

  // Of its kind: gamma_tau, or 1 / Q_tau if the mesh has a metric; gamma_T; eta_q; scaled Jacobians. At most 1.
  float quality_of_cell(std::size_t cell) const { return cell_quality_[cell]; }
  float quality_of_facet(std::size_t facet) const { return facet_quality_[facet]; }
  const Place& place_of_cell(std::size_t cell) const { return cell_place_[cell]; }
  const Place& place_of_facet(std::size_t facet) const { return facet_place_[facet]; }

  Vector point(std::uint32_t v) const { return Vector(mesh_.points[v]); }
  // The corners of the box around all points; the first is not below the second where there are none.
  std::array<Vector, 2> extent() const;
  Vector center_of_cell(std::size_t cell) const;
  Vector center_of_face(const Face& face) const;
  // The mean length of its edges.
  double size_of_face(const Face& face) const;

private:
  void find_sides();
  void measure();
  void find_places(int threads);

  const CGAL::Tubular_meshing::Mixed_mesh& mesh_;
  const CGAL::Tubular_meshing::Centerline_graph& centerlines_;
  Cells cells_;
  std::vector<Sides> sides_;
  std::vector<float> cell_quality_, facet_quality_;
  std::vector<Place> cell_place_, facet_place_;
};

#endif // TUBULAR_MESH_VIEW_SHOWN_MESH_H
