// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_INTERIOR_VORONOI_DIAGRAM_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_INTERIOR_VORONOI_DIAGRAM_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Delaunay_in_parts.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Sampled_surface.h>
#include <CGAL/Tubular_meshing/base/place_on_curve.h>
#include <CGAL/Tubular_meshing/base/parallel.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/parallel_sort.h>

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
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The part of the Voronoi diagram of a surface's samples that lies inside the surface: an approximation of its medial
 * axis (N. Amenta, S. Choi and R. Kolluri, The power crust, unions of balls, and the medial axis transform, 2001).
 *
 * A vertex is the centre of the sphere through the four samples of a Delaunay tetrahedron; it is inside if it lies
 * behind the tangent planes of at least three of them. This holds for no tetrahedron in a gap between two vessels, even
 * where the gap is narrower than the triangles, and needs no search. A face is dual to a Delaunay edge, a convex
 * polygon; those with a vertex outside are left out.
 *
 * First samples are inserted, in rounds; then make() numbers the vertices along a curve that fills space, so that those
 * near each other are near each other in memory. */
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

  /* `threads`: 0 for all; the diagram does not depend on it. */
  explicit Interior_voronoi_diagram(int threads = 0)
      : threads_(threads) {}

  /* Whether so many samples, the first ones, are inserted by several threads: of fewer, to join the parts takes as long
   * as it saves, so that threads do better with other work. */
  static bool are_inserted_side_by_side(std::size_t samples, int threads) {
    const std::size_t few = 30000;
    return samples >= few && Delaunay_in_parts<Delaunay>::number_of_parts(threads) > 1;
  }

  /* Takes in those of the surface's samples that are not in the diagram yet, but for those that others stand for. */
  void insert_samples(const Sampled_surface& surface) {
    const std::size_t before = pole_radii_.size();
    inserted_.clear();
    insert_from(before, surface);
    pole_radii_.resize(surface.points.size(), 0);
    if (delaunay_.dimension() < 3)
      return;
    const std::size_t few = 150; // are looked at in less time than a pass takes if there are so many times as many
    if (inserted_.size() * few > surface.points.size())
      measure_everywhere(surface);
    else
      measure_beside_inserted(surface);
  }

  /* The radius of the largest sphere that touches a sample, 0 if there is none; before make(). */
  double pole_radius(std::size_t sample) const { return pole_radii_[sample]; }

  /* The sample nearest to a point; before make(). */
  Index nearest_sample(const Point& p) const {
    return delaunay_.nearest_vertex(Delaunay::Point(p.x(), p.y(), p.z()))->info();
  }

  /* Vertices, poles and faces of the samples that are there. */
  void make(const Sampled_surface& surface) {
    poles.assign(surface.points.size(), none);
    if (delaunay_.dimension() == 3) {
      make_vertices();
      copy_cells();
      find_poles();
    }
    delaunay_.clear();
    std::vector<double>().swap(pole_radii_);
    make_faces(surface);
    std::vector<Quadruple>().swap(samples_of_);
    std::vector<Quadruple>().swap(neighbors_of_);
  }

  std::size_t number_of_faces() const { return face_begin.empty() ? 0 : face_begin.size() - 1; }

private:
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  static constexpr Index unknown = none, outside = none - 1;
  struct Cell_info {
    Index ball = unknown; // its number, or the vertex'; or that the cell has not been looked at, or is outside
  };
  typedef CGAL::Triangulation_data_structure_3<
      CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>,
      CGAL::Delaunay_triangulation_cell_base_3<Kernel, CGAL::Triangulation_cell_base_with_info_3<Cell_info, Kernel>>>
      Data_structure;
  typedef CGAL::Delaunay_triangulation_3<Kernel, Data_structure> Delaunay;
  typedef Delaunay::Cell_handle Cell;
  typedef std::array<Index, 4> Quadruple;
  typedef std::array<std::int64_t, 3> Rounded_place;

  struct Ball {
    Point center;
    double radius;
  };

  /* A Delaunay triangulation is the same in whatever order its points come (CGAL breaks ties by their places), but for
   * points that coincide: of these the first stands for all. */
  void insert_from(std::size_t first, const Sampled_surface& surface) {
    const auto less = [&](Index a, Index b) {
      const Point &p = surface.points[a], &q = surface.points[b];
      const std::uint64_t along_p = place_on_curve(p), along_q = place_on_curve(q);
      return along_p != along_q ? along_p < along_q : p != q ? p < q : a < b;
    };
    std::vector<Index> order;
    order.reserve(surface.points.size() - first);
    for (std::size_t i = first; i < surface.points.size(); ++i)
      if (!surface.is_left_out(i))
        order.push_back(Index(i));
    const auto sorted_end = std::is_sorted_until(order.begin(), order.end(), less); // the vertices of the wall are
    std::sort(sorted_end, order.end(), less);
    std::inplace_merge(order.begin(), sorted_end, order.end(), less);
    std::vector<std::pair<Delaunay::Point, Index>> samples;
    samples.reserve(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      if (const Point& p = surface.points[order[i]]; i == 0 || p != surface.points[order[i - 1]])
        samples.emplace_back(Delaunay::Point(p.x(), p.y(), p.z()), order[i]);
    insert(samples);
  }

  // The first ones by parts side by side: CGAL's insertion by several threads takes twice the work.
  void insert(std::vector<std::pair<Delaunay::Point, Index>>& samples) {
    if (delaunay_.number_of_vertices() == 0) {
      typedef Delaunay_in_parts<Delaunay> In_parts;
      const int parts = are_inserted_side_by_side(samples.size(), threads_) ? In_parts::number_of_parts(threads_) : 1;
      In_parts::triangulate(samples, parts, threads_, delaunay_);
      for (auto v = delaunay_.finite_vertices_begin(); v != delaunay_.finite_vertices_end(); ++v)
        inserted_.push_back(v);
    } else
      Delaunay_in_parts<Delaunay>::insert(samples.begin(), samples.end(), delaunay_,
                                          [&](Delaunay::Vertex_handle v) { inserted_.push_back(v); });
  }

  void measure_everywhere(const Sampled_surface& surface) {
    const bool are_all_new = balls_.empty();
    if (are_all_new)
      balls_.reserve(delaunay_.number_of_cells() / 2); // of the cells, about so many are inside
    measure_new_cells(surface);                        // raises the radii at their corners
    if (are_all_new)
      return;
    std::fill(pole_radii_.begin(), pole_radii_.end(), 0.);
    for (auto c = delaunay_.finite_cells_begin(); c != delaunay_.finite_cells_end(); ++c)
      raise_pole_radii(c);
  }

  void raise_pole_radii(Cell c) {
    if (c->info().ball < outside)
      for (int k = 0; k < 4; ++k) {
        double& radius = pole_radii_[c->vertex(k)->info()];
        radius = (std::max)(radius, balls_[c->info().ball].radius);
      }
  }

  // All new cells have a new corner, and all whose corners have lost cells, a new neighbour.
  void measure_beside_inserted(const Sampled_surface& surface) {
    std::vector<Delaunay::Vertex_handle> changed;
    std::vector<Cell> cells;
    for (Delaunay::Vertex_handle v : inserted_) {
      changed.push_back(v);
      delaunay_.finite_adjacent_vertices(v, std::back_inserter(changed));
    }
    const auto less = [](Delaunay::Vertex_handle a, Delaunay::Vertex_handle b) { return a->info() < b->info(); };
    std::sort(changed.begin(), changed.end(), less);
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    for (Delaunay::Vertex_handle v : changed) {
      cells.clear();
      delaunay_.finite_incident_cells(v, std::back_inserter(cells));
      double& radius = pole_radii_[v->info()];
      radius = 0;
      for (Cell c : cells) {
        if (c->info().ball == unknown) {
          Ball ball;
          measure_cell(surface, c, ball);
          keep(c, ball);
        }
        if (c->info().ball < outside)
          radius = (std::max)(radius, balls_[c->info().ball].radius);
      }
    }
  }

  void keep(Cell c, const Ball& ball) {
    if (c->info().ball == outside)
      return;
    c->info().ball = Index(balls_.size());
    balls_.push_back(ball);
  }

  // By blocks, so that there is little to remember of cells outside.
  void measure_new_cells(const Sampled_surface& surface) {
    const std::size_t block = 1 << 16;
    std::vector<Cell> cells;
    std::vector<Ball> balls;
    cells.reserve(block);
    const auto measure = [&] {
      balls.resize(cells.size());
      for_each_range(cells.size(), threads_, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
          measure_cell(surface, cells[i], balls[i]);
      });
      for (std::size_t i = 0; i < cells.size(); ++i) {
        keep(cells[i], balls[i]);
        raise_pole_radii(cells[i]);
      }
      cells.clear();
    };
    for (auto c = delaunay_.finite_cells_begin(); c != delaunay_.finite_cells_end(); ++c)
      if (c->info().ball == unknown) {
        cells.push_back(c);
        if (cells.size() == block)
          measure();
      }
    measure();
  }

  // The order of a cell's vertices depends on that of the insertions: they are sorted, or rounding would differ.
  static Quadruple samples_of(Cell c) {
    Quadruple s = {{c->vertex(0)->info(), c->vertex(1)->info(), c->vertex(2)->info(), c->vertex(3)->info()}};
    std::sort(s.begin(), s.end());
    return s;
  }

  static void measure_cell(const Sampled_surface& surface, Cell c, Ball& ball) {
    const Quadruple s = samples_of(c);
    if (!circumsphere(surface, s, ball) || !is_inside(surface, s, ball.center))
      c->info().ball = outside;
  }

  static bool circumsphere(const Sampled_surface& surface, const Quadruple& s, Ball& ball) {
    const Point& p = surface.points[s[0]];
    const Vector a = surface.points[s[1]] - p, b = surface.points[s[2]] - p, d = surface.points[s[3]] - p;
    const Vector bd = CGAL::cross_product(b, d);
    const double volume = 2 * (a * bd);
    const Vector r = (a * a) * bd + (b * b) * CGAL::cross_product(d, a) + (d * d) * CGAL::cross_product(a, b);
    const double length = std::sqrt(r.squared_length());
    if (!(std::abs(volume) > 0) || !(length < 64 * std::abs(volume))) // beyond the surface, whose extent is about 1
      return false;
    ball = Ball{p + r / volume, length / std::abs(volume)};
    return true;
  }

  static bool is_inside(const Sampled_surface& surface, const Quadruple& s, const Point& center) {
    int behind = 0;
    for (Index i : s)
      behind += (center - surface.points[i]) * surface.normals[i] < 0;
    return behind >= 3;
  }

  /* Whether the segment between two samples leaves both of them inwards. Where an inscribed sphere touches two points
   * of the surface, it does; where two vessels nearly touch, segments join them through the gap, and faces dual to them
   * lead from one to the other. */
  static bool runs_inside(const Sampled_surface& surface, Index p, Index q) {
    const Vector d = surface.points[q] - surface.points[p];
    return d * surface.normals[p] < 0 && d * surface.normals[q] > 0;
  }

  /* Numbers follow places, not the triangulation's memory: where the front has a choice, among equals, it is the same
   * one each time. Places are rounded, so that those of spheres that are one but for rounding errors are equal. */
  static Rounded_place rounded(const Point& p) {
    const double unit = 1e-9; // of the surface's extent
    return {{std::llround(p.x() / unit), std::llround(p.y() / unit), std::llround(p.z() / unit)}};
  }

  void make_vertices() {
    std::vector<std::pair<std::uint64_t, Cell>> order;
    order.reserve(balls_.size());
    for (auto c = delaunay_.finite_cells_begin(); c != delaunay_.finite_cells_end(); ++c)
      if (c->info().ball < outside)
        order.emplace_back(place_on_curve(balls_[c->info().ball].center), c);
    const auto less = [&](const auto& a, const auto& b) {
      if (a.first != b.first)
        return a.first < b.first;
      const Rounded_place p = rounded(balls_[a.second->info().ball].center);
      const Rounded_place q = rounded(balls_[b.second->info().ball].center);
      return p != q ? p < q : samples_of(a.second) < samples_of(b.second);
    };
    parallel_sort(order.begin(), order.end(), less, threads_);
    points.resize(order.size());
    radii.resize(order.size());
    for_each_range(order.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        Index& number = order[i].second->info().ball;
        const Ball& ball = balls_[number];
        points[i] = ball.center;
        radii[i] = ball.radius;
        number = Index(i);
      }
    });
    std::vector<Ball>().swap(balls_); // before there is more
    samples_of_.resize(order.size());
    cells_.resize(order.size());
    for_each_range(order.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        cells_[i] = order[i].second;
        for (std::size_t k = 0; k < 4; ++k)
          samples_of_[i][k] = cells_[i]->vertex(int(k))->info();
      }
    });
  }

  void copy_cells() {
    neighbors_of_.resize(cells_.size());
    for_each_range(cells_.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        for (std::size_t k = 0; k < 4; ++k) {
          const Index n = cells_[i]->neighbor(int(k))->info().ball;
          neighbors_of_[i][k] = n < outside ? n : none; // infinite cells are not looked at
        }
    });
    std::vector<Cell>().swap(cells_);
  }

  void find_poles() {
    for (Index c = 0; c < points.size(); ++c)
      for (Index s : samples_of_[c]) {
        Index& pole = poles[s];
        if (pole == none || radii[c] > radii[pole] || (radii[c] == radii[pole] && points[c] < points[pole]))
          pole = c;
      }
  }

  /* In the order of their lowest vertices, then of the next ones; by blocks of these, which are independent. */
  void make_faces(const Sampled_surface& surface) {
    struct Block {
      std::vector<Index> sizes, vertices;
    };
    const std::size_t width = 1 << 13;
    std::vector<Block> blocks((points.size() + width - 1) / width);
    for_each_task(blocks.size(), threads_, [&](std::size_t b) {
      std::vector<std::vector<Index>> outlines(6);
      for (std::size_t c = b * width; c < (std::min)(points.size(), (b + 1) * width); ++c)
        add_faces_of(surface, Index(c), outlines, blocks[b].sizes, blocks[b].vertices);
    });
    std::size_t faces = 0, corners = 0;
    for (const Block& b : blocks) {
      faces += b.sizes.size();
      corners += b.vertices.size();
    }
    face_begin.assign(1, 0);
    face_begin.reserve(faces + 1);
    face_vertices.clear();
    face_vertices.reserve(corners);
    for (Block& b : blocks) {
      for (Index size : b.sizes)
        face_begin.push_back(face_begin.back() + size);
      face_vertices.insert(face_vertices.end(), b.vertices.begin(), b.vertices.end());
      b = Block();
    }
    faces_of.assign(points.size(), {{none, none, none, none, none, none}});
    for (Index f = 0; f < faces; ++f)
      for (Index i = face_begin[f]; i < face_begin[f + 1]; ++i) {
        std::array<Index, 6>& around = faces_of[face_vertices[i]];
        *std::find(around.begin(), around.end(), none) = f;
      }
  }

  // Those of which c is the lowest vertex.
  void add_faces_of(const Sampled_surface& surface, Index c, std::vector<std::vector<Index>>& outlines,
                    std::vector<Index>& sizes, std::vector<Index>& vertices) const {
    std::size_t n = 0;
    const Quadruple& s = samples_of_[c];
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        const std::size_t k = i == 0 ? (j == 1 ? 2 : 1) : 0, l = 6 - i - j - k;
        if (is_later(neighbors_of_[c][k], c) && is_later(neighbors_of_[c][l], c) && runs_inside(surface, s[i], s[j]) &&
            find_outline(c, {{s[i], s[j]}}, s[k], s[l], outlines[n]))
          ++n;
      }
    std::sort(outlines.begin(), outlines.begin() + std::ptrdiff_t(n));
    for (std::size_t f = 0; f < n; ++f) {
      sizes.push_back(Index(outlines[f].size()));
      vertices.insert(vertices.end(), outlines[f].begin(), outlines[f].end());
    }
  }

  static bool is_later(Index n, Index c) { return n != none && n > c; }

  /* Round a Delaunay edge from c, on towards the lower neighbour. False if a vertex is outside, or lower than c.
   * `back` and `ahead` are the samples of a cell beside the edge: the way on leads across the side opposite to `back`. */
  bool find_outline(Index c, const std::array<Index, 2>& edge, Index back, Index ahead,
                    std::vector<Index>& outline) const {
    outline.assign(1, c);
    for (Index at = c;;) {
      const Quadruple& s = samples_of_[at];
      const std::size_t side = std::size_t(std::find(s.begin(), s.end(), back) - s.begin());
      const Index next = neighbors_of_[at][side];
      if (next == c)
        break;
      if (!is_later(next, c))
        return false;
      outline.push_back(next);
      Index new_sample = none;
      for (Index t : samples_of_[next])
        if (t != edge[0] && t != edge[1] && t != ahead)
          new_sample = t;
      back = ahead;
      ahead = new_sample;
      at = next;
    }
    if (outline.size() > 2 && outline.back() < outline[1])
      std::reverse(outline.begin() + 1, outline.end());
    return true;
  }

  int threads_;
  Delaunay delaunay_;
  std::vector<Delaunay::Vertex_handle> inserted_;    // of the last samples
  std::vector<double> pole_radii_;                   // of each sample, while samples come; 0: there is no sphere
  std::vector<Ball> balls_;                          // likewise; also of cells that are no more
  std::vector<Cell> cells_;                          // by vertex, as the next two are
  std::vector<Quadruple> samples_of_, neighbors_of_; // a neighbour is opposite to the sample of the same place
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_INTERIOR_VORONOI_DIAGRAM_H
