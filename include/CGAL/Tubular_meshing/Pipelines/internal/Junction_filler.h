// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_JUNCTION_FILLER_H
#define CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_JUNCTION_FILLER_H

#include <CGAL/Tubular_meshing/Layers/append_mesh.h>
#include <CGAL/Tubular_meshing/Patches/parameterize_patch.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Curve_divider.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesher_options.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Lumen_divider.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Wall_crown.h>
#include <CGAL/Tubular_meshing/Quads/quadrangulate_patches.h>
#include <CGAL/Tubular_meshing/Volume/fill_with_pyramids_and_tetrahedra.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Fills parts of the lumen between hexahedra that end on caps across the vessels there: quads on the wall, from rim to
 * rim of these caps, and pyramids and tetrahedra between them and the caps; where layers are wanted, between hexahedra
 * on the wall's quads, in which the rings of the vessels go on, and the caps. */
class Junction_filler {
public:
  typedef std::uint32_t Index;
  typedef std::array<Index, 4> Quad;

  struct Number_of_cells {
    std::size_t pyramids, tetrahedra;
  };

  /* `mesh`: of hexahedra whose caps have labels from `first_cap` on, as Lumen_divider has made them. */
  Junction_filler(Mixed_mesh& mesh, int first_cap, Length_function size, const Mesher_options& options)
      : mesh_(mesh)
      , first_cap_(first_cap)
      , size_(size)
      , options_(options) {
    take_caps();
  }

  /* Throws Meshing_error if it cannot be filled. */
  Number_of_cells fill(const Lumen_part& part) {
    std::vector<Cap> caps;
    std::vector<std::vector<Curve_position>> given;
    for (const Cut_curve& c : part.cut.curves) {
      caps.push_back(c.opening < first_cap_ ? Cap() : cap_of(c.opening));
      given.push_back(positions_on(part.surface.surface, c, caps.back()));
    }
    const auto maps = parameterize_patches(part.surface.surface, part.cut, options_.parameterization);
    const Remeshed_surface wall =
        internal::quadrangulate_patches(part.surface.surface, part.cut, maps, size_, options_.quads, given);
    const Facets facets = facets_of(wall, caps);
    return options_.has_boundary_layer() ? fill_within_crown(facets, caps) : fill_all(facets, caps);
  }

private:
  static constexpr int inside = 0; // the label of facets that are none of the mesh's boundary

  // Quads across a vessel, in points of the mesh, counterclockwise seen from the part that is to be filled.
  struct Cap {
    std::vector<Quad> quads;
    std::vector<Index> rim;              // in order, with the cap on the left
    std::map<Index, Index> inner_of_rim; // the ends of the edges that lead from the rim into the cap
  };
  // Of the part's boundary, but for the caps between it and the hexahedra, in points of the mesh.
  struct Facets {
    Element_block<3> triangles;
    Element_block<4> quads;
  };

  void take_caps() {
    Element_block<4> others;
    for (std::size_t k = 0; k < mesh_.quads.size(); ++k) {
      const int label = mesh_.quads.label[k];
      if (label < first_cap_)
        others.push_back(mesh_.quads.vertices[k], label);
      else
        quads_of_cap_[label].push_back(mesh_.quads.vertices[k]);
    }
    mesh_.quads = std::move(others);
  }

  Cap cap_of(int label) const {
    Cap cap;
    cap.quads = quads_of_cap_.at(label);
    std::map<Index, Index> next;
    std::set<std::pair<Index, Index>> edges;
    for (const Quad& q : cap.quads)
      for (std::size_t i = 0; i < 4; ++i)
        edges.emplace(q[i], q[(i + 1) % 4]);
    for (const auto& e : edges)
      if (edges.count({e.second, e.first}) == 0)
        next[e.first] = e.second;
    const Index first = next.begin()->first;
    Index v = first;
    do {
      cap.rim.push_back(v);
      v = next.at(v);
    } while (v != first);
    for (const auto& e : edges)
      if (next.count(e.first) > 0 && next.count(e.second) == 0)
        cap.inner_of_rim[e.first] = e.second;
    return cap;
  }

  /* Where the points of a cap's rim are on the curve, in its order, with which the rim is made to begin: as the cap is
   * seen from inside, both have the same direction. */
  std::vector<Curve_position> positions_on(const Surface& surface, const Cut_curve& curve, Cap& cap) const {
    std::vector<Curve_position> result;
    if (cap.rim.empty())
      return result;
    for (Index v : cap.rim)
      result.push_back(nearest_on(surface, curve, mesh_.points[v]));
    const auto is_before = [](const Curve_position& a, const Curve_position& b) {
      return std::make_pair(a.edge, a.t) < std::make_pair(b.edge, b.t);
    };
    const auto first = std::min_element(result.begin(), result.end(), is_before) - result.begin();
    std::rotate(result.begin(), result.begin() + first, result.end());
    std::rotate(cap.rim.begin(), cap.rim.begin() + first, cap.rim.end());
    for (std::size_t i = 1; i < result.size(); ++i)
      if (!is_before(result[i - 1], result[i]))
        throw Meshing_error("the ends of the vessels' blocks are folded there");
    return result;
  }
  static Curve_position nearest_on(const Surface& surface, const Cut_curve& curve, const Point_3& p) {
    Curve_position best{0, 0, p};
    double least = (std::numeric_limits<double>::infinity)();
    const std::size_t n = curve.vertices.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vector_3d a(surface.point(curve.vertices[i])),
          d = Vector_3d(surface.point(curve.vertices[(i + 1) % n])) - a;
      const double t = (std::min)((std::max)(dot(Vector_3d(p) - a, d) / squared_norm(d), 0.), 1.);
      const double distance = squared_norm(Vector_3d(p) - (a + t * d));
      if (distance < least) {
        least = distance;
        best = t < 1 || i + 1 < n ? Curve_position{t < 1 ? i : i + 1, t < 1 ? t : 0, p} : Curve_position{0, 0, p};
      }
    }
    return best;
  }

  // The quads' points on caps are those of the mesh; the others are added to it.
  Facets facets_of(const Remeshed_surface& wall, const std::vector<Cap>& caps) {
    std::vector<Index> index(wall.surface.number_of_vertices(), no_point);
    for (std::size_t c = 0; c < caps.size(); ++c)
      for (std::size_t i = 0; i < caps[c].rim.size(); ++i)
        index[std::size_t(wall.curves[c][i])] = caps[c].rim[i];
    Facets result;
    for (Face f : wall.surface.faces()) {
      const int label = wall.patch[f];
      if (label >= first_cap_)
        continue;
      std::vector<Index> corners;
      for (Vertex v : wall.surface.vertices_around_face(wall.surface.halfedge(f))) {
        Index& k = index[std::size_t(v)];
        if (k == no_point) {
          k = Index(mesh_.points.size());
          mesh_.points.push_back(wall.surface.point(v));
        }
        corners.push_back(k);
      }
      if (corners.size() == 3)
        result.triangles.push_back({{corners[0], corners[1], corners[2]}}, label);
      else
        result.quads.push_back({{corners[0], corners[1], corners[2], corners[3]}}, label);
    }
    return result;
  }

  Number_of_cells fill_all(Facets facets, const std::vector<Cap>& caps) {
    for (const Cap& cap : caps)
      for (const Quad& q : cap.quads)
        facets.quads.push_back(turned(q), inside);
    return fill_between(facets);
  }

  Number_of_cells fill_within_crown(const Facets& facets, const std::vector<Cap>& caps) {
    if (!facets.triangles.empty() ||
        std::any_of(facets.quads.label.begin(), facets.quads.label.end(), [](int l) { return l != labels::wall; }))
      throw Meshing_error(facets.triangles.empty()
                              ? "an opening is too near for layers"
                              : "the wall there has triangles, on which there are no layers of hexahedra");
    std::map<Index, Index> inner_of_rim;
    std::vector<Quad> cores;
    for (const Cap& cap : caps) {
      inner_of_rim.insert(cap.inner_of_rim.begin(), cap.inner_of_rim.end());
      for (const Quad& q : cap.quads)
        if (std::none_of(q.begin(), q.end(), [&](Index v) { return cap.inner_of_rim.count(v) > 0; }))
          cores.push_back(turned(q));
    }
    Facets cavity;
    for (const Quad& q : Wall_crown(mesh_, facets.quads.vertices, inner_of_rim, size_).add(cores))
      cavity.quads.push_back(q, inside);
    for (const Quad& q : cores)
      cavity.quads.push_back(q, inside);
    mesh_.quads.vertices.insert(mesh_.quads.vertices.end(), facets.quads.vertices.begin(), facets.quads.vertices.end());
    mesh_.quads.label.insert(mesh_.quads.label.end(), facets.quads.label.begin(), facets.quads.label.end());
    return fill_between(cavity);
  }

  static Quad turned(const Quad& q) { return {{q[0], q[3], q[2], q[1]}}; }

  // Pyramids and tetrahedra within closed facets.
  Number_of_cells fill_between(const Facets& facets) {
    Labelled_surface closed;
    std::unordered_map<Index, Vertex> vertex_of;
    std::vector<Index> points;
    const auto add = [&](const auto& element, int label) {
      std::vector<Vertex> corners;
      for (Index v : element) {
        const auto [found, is_new] = vertex_of.emplace(v, Vertex());
        if (is_new) {
          found->second = closed.surface.add_vertex(mesh_.points[v]);
          points.push_back(v);
        }
        corners.push_back(found->second);
      }
      const Face f = closed.surface.add_face(corners);
      if (f == Surface::null_face())
        throw Meshing_error("the quads on its wall meet themselves");
      closed.patch[f] = label;
    };
    for (std::size_t i = 0; i < facets.triangles.size(); ++i)
      add(facets.triangles.vertices[i], facets.triangles.label[i]);
    for (std::size_t i = 0; i < facets.quads.size(); ++i)
      add(facets.quads.vertices[i], facets.quads.label[i]);
    Mixed_mesh filling;
    internal::fill_with_pyramids_and_tetrahedra(closed.surface, closed.patch, size_, filling, options_.pyramids);
    append_mesh(mesh_, filling, points, inside);
    return {filling.pyramids.size(), filling.tetrahedra.size()};
  }

  Mixed_mesh& mesh_;
  const int first_cap_;
  Length_function size_;
  const Mesher_options& options_;
  std::map<int, std::vector<Quad>> quads_of_cap_; // by its label
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_JUNCTION_FILLER_H
