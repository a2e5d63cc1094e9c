// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_BOUNDARY_IN_DELAUNAY_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_BOUNDARY_IN_DELAUNAY_H

#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Recovered_boundary.h>
#include <CGAL/Tubular_meshing/base/Delaunay_in_parts.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/interruption.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Where tetrahedra have to be made anew, so that triangles become facets: the facets around them and the triangles in
 * them, as one boundary. */
struct Cavities {
  Boundary_arrays boundary;
  std::vector<std::uint32_t> vertex;                    // of each of its points: the number of the same point outside
  std::vector<std::array<std::uint32_t, 4>> tetrahedra; // of these points, which are to go
};

/* The Delaunay triangulation of the points of a closed surface, as symbolic perturbation makes it unique, and which of
 * the surface's triangles are facets of it. O(n log n) for points on a surface that is not too special. */
class Boundary_in_delaunay {
public:
  Boundary_in_delaunay(const Boundary_arrays& boundary, int threads)
      : boundary_(boundary)
      , vertex_(boundary.points.size()) {
    std::vector<std::pair<Point_3, std::uint32_t>> points;
    points.reserve(boundary.points.size());
    for (const Vector_3d& p : boundary.points)
      points.emplace_back(Point_3(p.x, p.y, p.z), std::uint32_t(points.size()));
    // as many parts for any number of threads, as the order of the cells depends on it
    Delaunay_in_parts<Delaunay>::triangulate(points, 4, threads, delaunay_);
    for (const Vertex_handle v : delaunay_.finite_vertex_handles())
      vertex_[v->info()] = v;
    if (has_all_points())
      find_missing_triangles(threads);
  }

  // Whether the points are not in a plane, and all different.
  bool has_all_points() const {
    return delaunay_.dimension() == 3 && delaunay_.number_of_vertices() == boundary_.points.size();
  }

  // Of a few it is quicker, and leaves better tetrahedra, to recover these alone.
  bool has_most_triangles() const { return missing_.size() <= boundary_.triangles.size() / 50; }

  // The tetrahedra that missing triangles meet, if only in a vertex, and what is to be kept of them.
  Cavities cavities() {
    std::vector<Cell_handle> cells;
    for (std::size_t f : missing_) {
      check_interruption();
      collect_met(f, cells);
    }
    Cavities result;
    std::vector<Vertex_handle> vertices;
    std::unordered_map<std::uint32_t, std::uint32_t> numbers; // of points, in the cavities
    const auto number = [&](Vertex_handle v) {
      const auto known = numbers.emplace(v->info(), std::uint32_t(vertices.size()));
      if (known.second)
        vertices.push_back(v);
      return known.first->second;
    };
    const auto keep = [&](Vertex_handle a, Vertex_handle b, Vertex_handle c) {
      result.boundary.triangles.push_back({number(a), number(b), number(c)});
    };
    for (const Cell_handle c : cells) {
      result.tetrahedra.push_back(
          {number(c->vertex(0)), number(c->vertex(1)), number(c->vertex(2)), number(c->vertex(3))});
      for (int i = 0; i < 4; ++i)
        if (!is_met(c->neighbor(i)) || (is_triangle(c, i) && !c->neighbor(i)->info().is_listed))
          keep(c->vertex((i + 1) & 3), c->vertex((i + 2) & 3), c->vertex((i + 3) & 3));
      c->info().is_listed = true;
    }
    for (std::size_t f : missing_) {
      const auto& t = boundary_.triangles[f];
      keep(vertex_[t[0]], vertex_[t[1]], vertex_[t[2]]);
    }
    for (const Vertex_handle v : vertices) {
      result.vertex.push_back(v->info());
      result.boundary.points.push_back(boundary_.points[v->info()]);
    }
    return result;
  }

  // Once cavities() are known.
  std::vector<std::array<std::uint32_t, 4>> tetrahedra_outside_cavities() const {
    std::vector<std::array<std::uint32_t, 4>> result;
    result.reserve(cells_.size());
    for (const Cell_handle c : cells_)
      if (!is_met(c))
        result.push_back({c->vertex(0)->info(), c->vertex(1)->info(), c->vertex(2)->info(), c->vertex(3)->info()});
    return result;
  }

private:
  struct Cell_state {
    std::uint8_t triangles = 0; // of a finite cell: bit i, the facet opposite to vertex i is a triangle of the surface
    bool is_met = false;        // by a triangle that is missing
    bool is_listed = false;     // among those that are
  };
  typedef Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel> Vertex_base;
  typedef Triangulation_cell_base_with_info_3<Cell_state, Kernel, Delaunay_triangulation_cell_base_3<Kernel>> Cell_base;
  typedef Triangulation_data_structure_3<Vertex_base, Cell_base> Data_structure;
  typedef Delaunay_triangulation_3<Kernel, Data_structure> Delaunay;
  typedef Delaunay::Vertex_handle Vertex_handle;
  typedef Delaunay::Cell_handle Cell_handle;
  typedef std::array<std::uint32_t, 3> Triangle;

  static bool is_met(Cell_handle c) { return c->info().is_met; }
  static bool is_triangle(Cell_handle c, int i) { return (c->info().triangles >> i & 1) != 0; }

  // Triangles by their lowest vertices, and there by the others.
  class Triangles_at_vertices {
  public:
    explicit Triangles_at_vertices(const Boundary_arrays& boundary)
        : begin_(boundary.points.size() + 1, 0)
        , triangles_(boundary.triangles.size()) {
      for (Triangle t : boundary.triangles)
        ++begin_[*std::min_element(t.begin(), t.end()) + 1];
      std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
      std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
      for (std::size_t f = 0; f < boundary.triangles.size(); ++f) {
        Triangle t = boundary.triangles[f];
        std::sort(t.begin(), t.end());
        triangles_[next[t[0]]++] = {t[1], t[2], std::uint32_t(f)};
      }
    }
    // visit(number) for those of these vertices, in any order.
    template <class Visit> void for_each_of(Triangle t, const Visit& visit) const {
      std::sort(t.begin(), t.end());
      for (std::uint32_t k = begin_[t[0]]; k < begin_[t[0] + 1]; ++k)
        if (triangles_[k].middle == t[1] && triangles_[k].highest == t[2])
          visit(triangles_[k].number);
    }

  private:
    struct Entry {
      std::uint32_t middle, highest, number;
    };
    std::vector<std::uint32_t> begin_;
    std::vector<Entry> triangles_;
  };

  // Those that no tetrahedron has for a facet. Linear.
  void find_missing_triangles(int threads) {
    const Triangles_at_vertices triangles(boundary_);
    cells_.assign(delaunay_.finite_cell_handles().begin(), delaunay_.finite_cell_handles().end());
    std::vector<std::atomic<char>> is_found(boundary_.triangles.size());
    for_each_range(cells_.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k)
        for (int i = 0; i < 4; ++i) {
          const Cell_handle c = cells_[k];
          triangles.for_each_of(
              {c->vertex((i + 1) & 3)->info(), c->vertex((i + 2) & 3)->info(), c->vertex((i + 3) & 3)->info()},
              [&](std::uint32_t f) {
                is_found[f].store(1, std::memory_order_relaxed);
                c->info().triangles |= std::uint8_t(1 << i);
              });
        }
    });
    for (std::size_t f = 0; f < is_found.size(); ++f)
      if (!is_found[f])
        missing_.push_back(f);
  }

  // From the tetrahedra at a vertex to their neighbors, as long as they are met.
  void collect_met(std::size_t missing, std::vector<Cell_handle>& cells) {
    const auto& t = boundary_.triangles[missing];
    const Kernel::Triangle_3 triangle(vertex_[t[0]]->point(), vertex_[t[1]]->point(), vertex_[t[2]]->point());
    std::vector<Cell_handle> met;
    delaunay_.finite_incident_cells(vertex_[t[0]], std::back_inserter(met));
    std::unordered_set<Cell_handle> seen(met.begin(), met.end());
    for (std::size_t k = 0; k < met.size(); ++k)
      for (int i = 0; i < 4; ++i) {
        const Cell_handle n = met[k]->neighbor(i);
        if (!delaunay_.is_infinite(n) && seen.insert(n).second &&
            CGAL::do_intersect(triangle, delaunay_.tetrahedron(n)))
          met.push_back(n);
      }
    for (const Cell_handle c : met) {
      if (!is_met(c))
        cells.push_back(c);
      c->info().is_met = true;
    }
  }

  const Boundary_arrays& boundary_;
  Delaunay delaunay_;
  std::vector<Vertex_handle> vertex_; // of each point
  std::vector<Cell_handle> cells_;    // finite ones
  std::vector<std::size_t> missing_;  // triangles
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_BOUNDARY_IN_DELAUNAY_H
