// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PLANE_TRIANGULATE_POLYGONS_IMPL_H
#define CGAL_TUBULAR_MESHING_PLANE_TRIANGULATE_POLYGONS_IMPL_H

#include <CGAL/Tubular_meshing/Plane/triangulate_polygons.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* See triangulate_polygons(). The polygons are checked on the way. */
class Polygon_triangulator {
  typedef Plane_store::Index Index;
  struct Face_info {
    int depth = -1; // how many polygons are crossed on the way from infinity
    Index index = Plane_store::none;
  };
  typedef CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel> Vb;
  typedef CGAL::Triangulation_face_base_with_info_2<Face_info, Kernel,
                                                    CGAL::Constrained_triangulation_face_base_2<Kernel>>
      Fb;
  typedef CGAL::Triangulation_data_structure_2<Vb, Fb> Tds;
  typedef CGAL::Constrained_Delaunay_triangulation_2<Kernel, Tds, CGAL::No_constraint_intersection_tag> Cdt;
  typedef Cdt::Vertex_handle Vertex_handle;
  typedef Cdt::Face_handle Face_handle;

public:
  explicit Polygon_triangulator(const Plane_polygons& polygons)
      : polygons_(polygons) {
    if (check_coordinates() && insert_points() && insert_edges()) {
      mark_depths();
      check_nesting();
    }
  }

  // What is wrong with the polygons, a sentence; empty if nothing is. Then there is store().
  const std::string& problem() const { return problem_; }

  Plane_store store() {
    Index n = 0;
    for (Face_handle f : cdt_.finite_face_handles())
      if (f->info().depth == 1)
        f->info().index = n++;
    std::vector<Index> corners(3 * n), twins(3 * n, Plane_store::none);
    for (Face_handle f : cdt_.finite_face_handles())
      if (f->info().depth == 1)
        for (int i = 0; i < 3; ++i) { // half-edge i leaves corner i, opposite to corner i + 2
          const Index h = 3 * f->info().index + Index(i);
          corners[h] = f->vertex(i)->info();
          const int across = Cdt::cw(i);
          const Face_handle g = f->neighbor(across);
          if (g->info().depth == 1 && !f->is_constrained(across))
            twins[h] = 3 * g->info().index + Index(Cdt::ccw(cdt_.tds().mirror_index(f, across)));
        }
    return Plane_store(std::move(corners), std::move(twins), vertices_.size());
  }

private:
  static std::string name(std::size_t k) {
    return k == 0 ? "the outer polygon" : "polygon " + std::to_string(k) + " (a hole)";
  }
  static std::string name(std::size_t k, std::size_t i) { return "vertex " + std::to_string(i) + " of " + name(k); }

  bool refuse(const std::string& problem) {
    problem_ = problem;
    return false;
  }

  bool check_coordinates() {
    if (polygons_.empty())
      return refuse("A domain to be triangulated needs at least its outer polygon, but there is none.");
    for (std::size_t k = 0; k < polygons_.size(); ++k) {
      if (polygons_[k].size() < 3)
        return refuse("A polygon needs three vertices or more, but " + name(k) + " has " +
                      std::to_string(polygons_[k].size()) + ".");
      for (std::size_t i = 0; i < polygons_[k].size(); ++i)
        if (!std::isfinite(polygons_[k][i].x()) || !std::isfinite(polygons_[k][i].y()))
          return refuse("The coordinates of " + name(k, i) + " are not finite numbers.");
    }
    return true;
  }

  bool insert_points() {
    std::vector<std::pair<std::size_t, std::size_t>> place;
    std::vector<Plane_point> points;
    for (std::size_t k = 0; k < polygons_.size(); ++k)
      for (std::size_t i = 0; i < polygons_[k].size(); ++i) {
        place.emplace_back(k, i);
        points.push_back(polygons_[k][i]);
      }
    typedef CGAL::Pointer_property_map<Plane_point>::type Point_map;
    typedef CGAL::Spatial_sort_traits_adapter_2<Kernel, Point_map> Sort_traits;
    std::vector<std::size_t> order(boost::counting_iterator<std::size_t>(0),
                                   boost::counting_iterator<std::size_t>(points.size()));
    CGAL::spatial_sort(order.begin(), order.end(), Sort_traits(CGAL::make_property_map(points)));
    vertices_.resize(points.size());
    Face_handle hint;
    for (std::size_t j : order) {
      const std::size_t before = cdt_.number_of_vertices();
      const Vertex_handle v = cdt_.insert(points[j], hint);
      if (cdt_.number_of_vertices() == before) {
        const auto other = place[v->info()];
        return refuse("Polygons must not touch, but " + name(place[j].first, place[j].second) + " and " +
                      name(other.first, other.second) + " are the same point; remove one or keep them apart.");
      }
      v->info() = Index(j);
      vertices_[j] = v;
      hint = v->face();
    }
    if (cdt_.dimension() < 2)
      return refuse("All vertices of the polygons lie on one line: there is no domain to triangulate.");
    return true;
  }

  bool insert_edges() {
    std::size_t first = 0;
    for (std::size_t k = 0; k < polygons_.size(); ++k) {
      const std::size_t n = polygons_[k].size();
      for (std::size_t i = 0; i < n; ++i)
        if (!insert_edge(vertices_[first + i], vertices_[first + (i + 1) % n], k, i))
          return false;
      first += n;
    }
    return true;
  }

  bool insert_edge(Vertex_handle a, Vertex_handle b, std::size_t k, std::size_t i) {
    try {
      cdt_.insert_constraint(a, b);
    } catch (const Cdt::Intersection_of_constraints_exception&) {
      return refuse("Polygons must not cross themselves or each other, but the edge from " + name(k, i) +
                    " crosses another edge.");
    }
    Face_handle f;
    int side;
    if (!cdt_.is_edge(a, b, f, side) || !f->is_constrained(side))
      return refuse("Polygons must not touch, but the edge from " + name(k, i) +
                    " passes through another vertex; move one of them.");
    return true;
  }

  void mark_depths() {
    std::vector<Face_handle> level{cdt_.infinite_face()}, next_level;
    for (int depth = 0; !level.empty(); ++depth, level.swap(next_level)) {
      next_level.clear();
      while (!level.empty()) {
        const Face_handle f = level.back();
        level.pop_back();
        if (f->info().depth != -1)
          continue;
        f->info().depth = depth;
        for (int i = 0; i < 3; ++i)
          if (f->neighbor(i)->info().depth == -1)
            (f->is_constrained(i) ? next_level : level).push_back(f->neighbor(i));
      }
    }
  }

  // The outer polygon parts depths 0 and 1, a hole 1 and 2: anything else is not one domain.
  bool check_nesting() {
    std::size_t first = 0;
    for (std::size_t k = 0; k < polygons_.size(); ++k) {
      Face_handle f;
      int side = 0;
      cdt_.is_edge(vertices_[first], vertices_[first + 1], f, side);
      const int depth = (std::min)(f->info().depth, f->neighbor(side)->info().depth);
      if (depth != (k == 0 ? 0 : 1))
        return refuse(k == 0       ? "The outer polygon must come first, but it lies inside another polygon."
                      : depth == 0 ? "Holes must lie inside the outer polygon, but " + name(k) + " is outside."
                                   : "Holes must not be nested, but " + name(k) + " lies inside another one.");
      first += polygons_[k].size();
    }
    return true;
  }

  const Plane_polygons& polygons_;
  Cdt cdt_;
  std::vector<Vertex_handle> vertices_;
  std::string problem_;
};

CGAL_TUBULAR_MESHING_INLINE std::optional<Plane_store> triangulate_polygons(const Plane_polygons& polygons,
                                                                            std::string& problem) {
  Polygon_triangulator triangulator(polygons);
  problem = triangulator.problem();
  if (!problem.empty())
    return std::nullopt;
  return triangulator.store();
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PLANE_TRIANGULATE_POLYGONS_IMPL_H
