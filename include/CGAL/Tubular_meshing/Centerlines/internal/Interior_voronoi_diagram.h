// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_INTERIOR_VORONOI_DIAGRAM_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_INTERIOR_VORONOI_DIAGRAM_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Sampled_surface.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The part of the Voronoi diagram of a surface's samples that lies inside the surface: an approximation of its medial
 * axis (N. Amenta, S. Choi and R. Kolluri, The power crust, unions of balls, and the medial axis transform, 2001).
 *
 * A vertex is the centre of the sphere through the four samples of a Delaunay tetrahedron; it is inside if it lies
 * behind the tangent planes of at least three of them. This holds for no tetrahedron in a gap between two vessels, even
 * where the gap is narrower than the triangles, and needs no search. A face is dual to a Delaunay edge, a convex
 * polygon; those with a vertex outside are left out. */
class Interior_voronoi_diagram {
public:
  typedef Double_kernel::Point_3 Point;
  typedef Double_kernel::Vector_3 Vector;
  typedef std::uint32_t Index;
  static constexpr Index none = Index(-1);

  std::vector<Point> points;                  // vertices
  std::vector<double> radii;                  // of the spheres
  std::vector<std::array<Index, 6>> faces_of; // of each vertex, filled up with `none`
  std::vector<Index> face_begin;              // where the vertices of each face begin in face_vertices
  std::vector<Index> face_vertices;           // in order around the face
  std::vector<Index> poles;                   // of each sample: its largest sphere, or `none`

  /* Takes in those of the surface's samples that are not in the diagram yet, and makes vertices and poles of all. */
  void insert_samples(const Sampled_surface& surface) {
    std::vector<std::pair<Delaunay::Point, Index>> samples;
    for (std::size_t i = poles.size(); i < surface.points.size(); ++i) {
      const Point& p = surface.points[i];
      samples.emplace_back(Delaunay::Point(p.x(), p.y(), p.z()), Index(i));
    }
    delaunay_.insert(samples.begin(), samples.end());
    poles.assign(surface.points.size(), none);
    points.clear();
    radii.clear();
    if (delaunay_.dimension() < 3)
      return;
    make_vertices(surface);
    find_poles();
  }

  std::size_t number_of_faces() const { return face_begin.empty() ? 0 : face_begin.size() - 1; }

  /* The faces; apart, since the poles tell whether there are samples enough. */
  void make_faces(const Sampled_surface& surface) {
    std::vector<std::vector<Index>> outlines;
    for (auto e = delaunay_.finite_edges_begin(); e != delaunay_.finite_edges_end(); ++e)
      if (runs_inside(surface, e->first->vertex(e->second)->info(), e->first->vertex(e->third)->info())) {
        std::vector<Index> outline = outline_of(*e, delaunay_);
        if (!outline.empty())
          outlines.push_back(std::move(outline));
      }
    delaunay_.clear();
    std::sort(outlines.begin(), outlines.end()); // as for the vertices, memory is not to decide
    faces_of.assign(points.size(), {{none, none, none, none, none, none}});
    face_begin.assign(1, 0);
    for (const std::vector<Index>& outline : outlines)
      add_face(outline);
  }

  /* The sample nearest to a point; before make_faces(). */
  Index nearest_sample(const Point& p) const {
    return delaunay_.nearest_vertex(Delaunay::Point(p.x(), p.y(), p.z()))->info();
  }

private:
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef CGAL::Triangulation_data_structure_3<
      CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>,
      CGAL::Delaunay_triangulation_cell_base_3<Kernel, CGAL::Triangulation_cell_base_with_info_3<Index, Kernel>>>
      Data_structure;
  typedef CGAL::Delaunay_triangulation_3<Kernel, Data_structure> Delaunay;
  typedef Delaunay::Cell_handle Cell;

  /* A vertex before it has its number. Numbers follow places, not the triangulation's memory, in which cells lie as a
   * random walk has found them: where the front has a choice, among equals, it is the same one each time. */
  struct Candidate {
    std::array<std::int64_t, 3> place; // rounded, so that places that differ by rounding errors are one
    Point center;
    double radius;
    Cell cell;
  };

  static std::array<std::int64_t, 3> rounded(const Point& p) {
    const double unit = 1e-9; // of the surface's extent
    return {{std::llround(p.x() / unit), std::llround(p.y() / unit), std::llround(p.z() / unit)}};
  }

  // Of cells with one centre, their corners' places tell which is first.
  static std::array<std::array<std::int64_t, 3>, 4> corners(const Sampled_surface& surface, Cell c) {
    std::array<std::array<std::int64_t, 3>, 4> result;
    for (int k = 0; k < 4; ++k)
      result[std::size_t(k)] = rounded(surface.points[c->vertex(k)->info()]);
    std::sort(result.begin(), result.end());
    return result;
  }

  void make_vertices(const Sampled_surface& surface) {
    for (auto c = delaunay_.all_cells_begin(); c != delaunay_.all_cells_end(); ++c)
      c->info() = none;
    std::vector<Candidate> candidates;
    for (auto c = delaunay_.finite_cells_begin(); c != delaunay_.finite_cells_end(); ++c) {
      Candidate v;
      v.cell = c;
      if (!circumsphere(surface, c, v.center, v.radius) || !is_inside(surface, c, v.center))
        continue;
      v.place = rounded(v.center);
      candidates.push_back(v);
    }
    std::sort(candidates.begin(), candidates.end(), [&](const Candidate& a, const Candidate& b) {
      return a.place != b.place ? a.place < b.place : corners(surface, a.cell) < corners(surface, b.cell);
    });
    for (const Candidate& v : candidates) {
      v.cell->info() = Index(points.size());
      points.push_back(v.center);
      radii.push_back(v.radius);
    }
  }

  static bool circumsphere(const Sampled_surface& surface, Cell c, Point& center, double& radius) {
    const Point& p = surface.points[c->vertex(0)->info()];
    const Vector a = surface.points[c->vertex(1)->info()] - p;
    const Vector b = surface.points[c->vertex(2)->info()] - p;
    const Vector d = surface.points[c->vertex(3)->info()] - p;
    const Vector bd = CGAL::cross_product(b, d);
    const double volume = 2 * (a * bd);
    const Vector r = (a * a) * bd + (b * b) * CGAL::cross_product(d, a) + (d * d) * CGAL::cross_product(a, b);
    const double length = std::sqrt(r.squared_length());
    if (!(std::abs(volume) > 0) || !(length < 64 * std::abs(volume))) // beyond the surface, whose extent is about 1
      return false;
    center = p + r / volume;
    radius = length / std::abs(volume);
    return true;
  }

  static bool is_inside(const Sampled_surface& surface, Cell c, const Point& center) {
    int behind = 0;
    for (int k = 0; k < 4; ++k) {
      const Index i = c->vertex(k)->info();
      behind += (center - surface.points[i]) * surface.normals[i] < 0;
    }
    return behind >= 3;
  }

  /* Whether the segment between two samples leaves both of them inwards. Where an inscribed sphere touches two points
   * of the surface, it does; where two vessels nearly touch, segments join them through the gap, and faces dual to them
   * lead from one to the other. */
  static bool runs_inside(const Sampled_surface& surface, Index p, Index q) {
    const Vector d = surface.points[q] - surface.points[p];
    return d * surface.normals[p] < 0 && d * surface.normals[q] > 0;
  }

  void find_poles() {
    for (auto c = delaunay_.finite_cells_begin(); c != delaunay_.finite_cells_end(); ++c)
      if (c->info() != none)
        for (int k = 0; k < 4; ++k) {
          Index& pole = poles[c->vertex(k)->info()];
          if (pole == none || radii[c->info()] > radii[pole] ||
              (radii[c->info()] == radii[pole] && points[c->info()] < points[pole]))
            pole = c->info();
        }
  }

  // From its smallest vertex, on towards the smaller neighbour; empty if one is outside.
  static std::vector<Index> outline_of(const Delaunay::Edge& edge, const Delaunay& delaunay) {
    std::vector<Index> outline;
    auto c = delaunay.incident_cells(edge);
    const auto first = c;
    do {
      if (c->info() == none)
        return {};
      outline.push_back(c->info());
    } while (++c != first);
    std::rotate(outline.begin(), std::min_element(outline.begin(), outline.end()), outline.end());
    if (outline.size() > 2 && outline.back() < outline[1])
      std::reverse(outline.begin() + 1, outline.end());
    return outline;
  }

  void add_face(const std::vector<Index>& outline) {
    const Index face = Index(face_begin.size() - 1);
    for (Index v : outline)
      *std::find(faces_of[v].begin(), faces_of[v].end(), none) = face;
    face_vertices.insert(face_vertices.end(), outline.begin(), outline.end());
    face_begin.push_back(Index(face_vertices.size()));
  }

  Delaunay delaunay_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_INTERIOR_VORONOI_DIAGRAM_H
