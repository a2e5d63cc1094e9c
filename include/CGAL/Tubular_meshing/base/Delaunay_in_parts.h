// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_DELAUNAY_IN_PARTS_H
#define CGAL_TUBULAR_MESHING_BASE_DELAUNAY_IN_PARTS_H

#include <CGAL/Tubular_meshing/base/parallel.h>

#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/assertions.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Makes a Delaunay triangulation of points, all different, on several threads: the points on either side of a plane are
 * triangulated side by side, and joined (D. Funke and P. Sanders, Parallel d-D Delaunay triangulations in shared and
 * distributed memory, 2017). The triangulation is the one that insertion makes; only the order of its cells in memory
 * differs.
 *
 * A cell whose circumsphere does not reach the plane stays as it is. Round a vertex that has only such cells, all does.
 * The other vertices are the border: what is missing between the cells that stay are cells of the triangulation of the
 * border alone. There, a cell with corners on both sides of the plane is one of these; one with all corners on one side,
 * if it is a cell of that side which does not stay; all others lie where cells stay. O(n log n) for n points, and the
 * border's cells are made twice: on surfaces of trees, about one in eight.
 *
 * The cells need tds_data(), whose marks are used, and vertices an info() that is given with each point. */
template <class Delaunay> class Delaunay_in_parts {
public:
  typedef typename Delaunay::Point Point;
  typedef typename Delaunay::Vertex_handle Vertex;
  typedef typename Delaunay::Cell_handle Cell;
  typedef std::decay_t<decltype(std::declval<Vertex>()->info())> Info;
  typedef std::pair<Point, Info> Sample;
  typedef std::vector<Sample> Samples;

  /* As many as there are threads to be had, of `threads` (0: as many as there are cores). */
  static int number_of_parts(int threads) {
    int available = 1;
#ifdef CGAL_LINKED_WITH_TBB
    if (threads != 1)
      run_on(threads, [&] { available = tbb::this_task_arena::max_concurrency(); });
#else
    static_cast<void>(threads);
#endif
    int parts = 1; // a power of two; joining more takes longer than it saves
    while (2 * parts <= (std::min)(available, 8))
      parts *= 2;
    return parts;
  }

  /* In at most so many parts, of 10,000 points at least. */
  static void triangulate(Samples& samples, int parts, int threads, Delaunay& delaunay) {
    Delaunay_in_parts(threads).triangulate(samples.begin(), samples.end(), parts, delaunay);
  }

  /* One point after the other. Calls f(vertex) for each. */
  template <class F>
  static void insert(typename Samples::iterator first, typename Samples::iterator last, Delaunay& delaunay,
                     const F& f) {
    typedef CGAL::First_of_pair_property_map<Sample> Place;
    CGAL::spatial_sort(first, last, CGAL::Spatial_sort_traits_adapter_3<typename Delaunay::Geom_traits, Place>());
    Vertex near;
    for (auto s = first; s != last; ++s) {
      const std::size_t before = delaunay.number_of_vertices();
      near = delaunay.insert(s->first, near);
      if (delaunay.number_of_vertices() == before)
        continue; // another point is there
      near->info() = s->second;
      f(near);
    }
  }

private:
  typedef typename Samples::iterator Iterator;
  typedef std::array<Info, 3> Triple;
  typedef std::array<Info, 4> Quadruple;

  explicit Delaunay_in_parts(int threads)
      : threads_(threads) {}

  static constexpr std::ptrdiff_t fewest = 10000; // points of a part that is worth it

  static void insert(Iterator first, Iterator last, Delaunay& delaunay) {
    insert(first, last, delaunay, [](Vertex) {});
  }

  struct Plane {
    int axis;
    double place;
  };

  void triangulate(Iterator first, Iterator last, int parts, Delaunay& delaunay) const {
    if (parts < 2 || last - first < 2 * fewest)
      return insert(first, last, delaunay);
    const Plane plane = middle(first, last);
    const Iterator second =
        std::partition(first, last, [&](const Sample& s) { return s.first[plane.axis] < plane.place; });
    if (second - first < fewest || last - second < fewest)
      return insert(first, last, delaunay);
    Delaunay above;
    for_each_task(2, threads_, [&](std::size_t side) {
      if (side == 0)
        triangulate(first, second, parts / 2, delaunay);
      else
        triangulate(second, last, parts / 2, above);
    });
    if (delaunay.dimension() == 3 && above.dimension() == 3)
      join(delaunay, above, plane);
    else
      insert(second, last, delaunay);
  }

  // Across the longest extent, in which a tree of vessels has the fewest points near a plane.
  static Plane middle(Iterator first, Iterator last) {
    Plane plane = {0, 0};
    double longest = -1;
    for (int k = 0; k < 3; ++k) {
      const auto ends =
          std::minmax_element(first, last, [k](const Sample& a, const Sample& b) { return a.first[k] < b.first[k]; });
      if (const double extent = ends.second->first[k] - ends.first->first[k]; extent > longest) {
        longest = extent;
        plane.axis = k;
      }
    }
    std::vector<double> places;
    places.reserve(std::size_t(last - first));
    for (Iterator s = first; s != last; ++s)
      places.push_back(s->first[plane.axis]);
    std::nth_element(places.begin(), places.begin() + std::ptrdiff_t(places.size() / 2), places.end());
    plane.place = places[places.size() / 2];
    return plane;
  }

  // A facet of a cell that stays, beyond which none does.
  struct Seam {
    Triple corners; // in order
    Cell cell;
    int side;

    bool operator<(const Seam& other) const { return corners < other.corners; }
  };

  // What does not stay of one side of the plane.
  struct Rest {
    std::vector<Cell> cells;
    std::vector<Quadruple> corners; // of those that are finite, each in order, sorted
    std::vector<Vertex> border;     // sorted
    std::vector<Seam> seams;        // sorted
  };

  static bool is_less(Vertex a, Vertex b) {
    return a->info() < b->info();
  }

  template <class Corners> static Corners in_order(Corners corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
  }

  static Triple corners_of(Cell c, int side) {
    return in_order(Triple{
        {c->vertex((side + 1) & 3)->info(), c->vertex((side + 2) & 3)->info(), c->vertex((side + 3) & 3)->info()}});
  }

  static Quadruple corners_of(Cell c) {
    return in_order(
        Quadruple{{c->vertex(0)->info(), c->vertex(1)->info(), c->vertex(2)->info(), c->vertex(3)->info()}});
  }

  // `sign` is 1 below the plane and -1 above it. The cells that do not stay are marked.
  static Rest rest_of(const Delaunay& delaunay, const Plane& plane, int sign) {
    Rest rest;
    for (auto i = delaunay.all_cells_begin(); i != delaunay.all_cells_end(); ++i) {
      const Cell c = i;
      c->tds_data().clear();
      if (!delaunay.is_infinite(c) && stays(c, plane, sign))
        continue;
      c->tds_data().mark_in_conflict();
      rest.cells.push_back(c);
    }
    for (Cell c : rest.cells) {
      if (!delaunay.is_infinite(c))
        rest.corners.push_back(corners_of(c));
      for (int k = 0; k < 4; ++k) {
        if (const Vertex v = c->vertex(k); v != delaunay.infinite_vertex())
          rest.border.push_back(v);
        if (const Cell n = c->neighbor(k); !is_marked(n))
          rest.seams.push_back(Seam{corners_of(c, k), n, n->index(c)});
      }
    }
    std::sort(rest.corners.begin(), rest.corners.end());
    std::sort(rest.border.begin(), rest.border.end(), is_less);
    rest.border.erase(std::unique(rest.border.begin(), rest.border.end()), rest.border.end());
    std::sort(rest.seams.begin(), rest.seams.end());
    return rest;
  }

  static bool is_marked(Cell c) {
    return c->tds_data().is_in_conflict();
  }

  /* Whether a cell's circumsphere is surely on one side of a plane: rounding errors are bounded by more than they can
   * be. */
  static bool stays(Cell c, const Plane& plane, int sign) {
    typedef std::array<double, 3> Vector;
    const Point& p = c->vertex(0)->point();
    std::array<Vector, 3> e;
    double longest = 0; // of the edges' coordinates
    for (std::size_t i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) {
        e[i][std::size_t(k)] = c->vertex(int(i) + 1)->point()[k] - p[k];
        longest = (std::max)(longest, std::abs(e[i][std::size_t(k)]));
      }
    const auto cross = [](const Vector& a, const Vector& b) {
      return Vector{{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
    };
    const auto dot = [](const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    const Vector n0 = cross(e[1], e[2]), n1 = cross(e[2], e[0]), n2 = cross(e[0], e[1]);
    const double volume = 2 * dot(e[0], n0); // positive, up to rounding
    const double s0 = dot(e[0], e[0]), s1 = dot(e[1], e[1]), s2 = dot(e[2], e[2]);
    Vector center; // from p, times the volume
    for (std::size_t k = 0; k < 3; ++k)
      center[k] = s0 * n0[k] + s1 * n1[k] + s2 * n2[k];
    const double error = 1024 * (std::numeric_limits<double>::epsilon)(), cube = longest * longest * longest;
    const double least_volume = std::abs(volume) - error * cube;
    if (!(least_volume > 0))
      return false;
    const double reach = sign * (volume > 0 ? center[std::size_t(plane.axis)] : -center[std::size_t(plane.axis)]) +
                         std::sqrt(dot(center, center)) + error * cube * longest;
    const double way = sign * (plane.place - p[plane.axis]);
    return reach / least_volume < way * (1 - error);
  }

  // The triangulation above the plane is used up.
  void join(Delaunay& below, Delaunay& above, const Plane& plane) const {
    std::array<Rest, 2> rests;
    for_each_task(2, threads_, [&](std::size_t side) {
      rests[side] = side == 0 ? rest_of(below, plane, 1) : rest_of(above, plane, -1);
    });
    std::vector<Vertex> border = rests[0].border;
    border.insert(border.end(), rests[1].border.begin(), rests[1].border.end());
    Samples samples;
    samples.reserve(border.size());
    for (std::size_t i = 0; i < border.size(); ++i)
      samples.emplace_back(border[i]->point(), Info(i));
    Delaunay between;
    insert(samples.begin(), samples.end(), between);
    const std::vector<Cell> cells = cells_of_rest(between, border, rests);

    auto& all = below.tds();
    for (int side = 0; side < 2; ++side)
      for (Cell c : rests[std::size_t(side)].cells)
        (side == 0 ? all : above.tds()).delete_cell(c);
    above.tds().delete_vertex(above.infinite_vertex());
    for (Cell c : cells)
      for (int k = 0; k < 4; ++k) {
        const Vertex copy = c->vertex(k);
        const Vertex v =
            copy == between.infinite_vertex() ? below.infinite_vertex() : border[std::size_t(copy->info())];
        c->set_vertex(k, v);
        v->set_cell(c);
      }
    for (Cell c : cells)
      for (int k = 0; k < 4; ++k)
        if (!is_marked(c->neighbor(k)))
          sew(c, k, rests, plane);
    std::vector<Cell> others;
    for (auto c = between.all_cells_begin(); c != between.all_cells_end(); ++c)
      if (!is_marked(c))
        others.push_back(c);
    for (Cell c : others)
      between.tds().delete_cell(c);
    for (Cell c : cells)
      c->tds_data().clear();
    all.vertices().merge(above.tds().vertices());
    all.cells().merge(above.tds().cells());
    all.cells().merge(between.tds().cells());
  }

  // Those cells of the border's triangulation that fill what does not stay; they are marked.
  std::vector<Cell> cells_of_rest(const Delaunay& between, const std::vector<Vertex>& border,
                                  const std::array<Rest, 2>& rests) const {
    std::vector<Cell> cells;
    cells.reserve(between.number_of_cells());
    for (auto c = between.all_cells_begin(); c != between.all_cells_end(); ++c)
      cells.push_back(c);
    for_each_range(cells.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        cells[i]->tds_data().clear();
        if (between.is_infinite(cells[i]) || is_of_rest(cells[i], border, rests))
          cells[i]->tds_data().mark_in_conflict();
      }
    });
    cells.erase(std::remove_if(cells.begin(), cells.end(), [](Cell c) { return !is_marked(c); }), cells.end());
    return cells;
  }

  static bool is_of_rest(Cell c, const std::vector<Vertex>& border, const std::array<Rest, 2>& rests) {
    const std::size_t below = rests[0].border.size();
    int corners_below = 0;
    Quadruple corners;
    for (int k = 0; k < 4; ++k) {
      const std::size_t place = std::size_t(c->vertex(k)->info());
      corners_below += place < below;
      corners[std::size_t(k)] = border[place]->info();
    }
    if (corners_below != 0 && corners_below != 4)
      return true;
    const std::vector<Quadruple>& known = rests[corners_below == 0].corners;
    return std::binary_search(known.begin(), known.end(), in_order(corners));
  }

  // Makes a cell and the one that stays beyond a side of it neighbours.
  static void sew(Cell c, int side, const std::array<Rest, 2>& rests, const Plane& plane) {
    const bool is_above = c->vertex((side + 1) & 3)->point()[plane.axis] >= plane.place;
    const std::vector<Seam>& seams = rests[is_above].seams;
    const auto seam = std::lower_bound(seams.begin(), seams.end(), Seam{corners_of(c, side), Cell(), 0});
    CGAL_assertion(seam != seams.end() && seam->corners == corners_of(c, side));
    c->set_neighbor(side, seam->cell);
    seam->cell->set_neighbor(seam->side, c);
  }

  int threads_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_DELAUNAY_IN_PARTS_H
