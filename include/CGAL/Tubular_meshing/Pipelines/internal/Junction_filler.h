// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_JUNCTION_FILLER_H
#define CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_JUNCTION_FILLER_H

#include <CGAL/Tubular_meshing/Hexahedra/insert_wall_layers.h>
#include <CGAL/Tubular_meshing/Layers/append_mesh.h>
#include <CGAL/Tubular_meshing/Layers/extrude_boundary_layer.h>
#include <CGAL/Tubular_meshing/Patches/parameterize_patch.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Curve_divider.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesher_options.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Lumen_divider.h>
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
 * rim of these caps, and pyramids and tetrahedra between them and the caps. */
class Junction_filler {
public:
  typedef std::uint32_t Index;
  typedef std::array<Index, 4> Quad;

  struct Number_of_cells {
    std::size_t pyramids, tetrahedra;
  };

  /* `mesh`: of hexahedra and quads alone. Caps have labels from `first_cap` on, as Lumen_divider has made them; they are
   * taken out of its quads. */
  Junction_filler(Mixed_mesh& mesh, int first_cap, const Mesher_options& options)
      : first_cap_(first_cap)
      , options_(options)
      , points_of_blocks_(mesh.points.size()) {
    Element_block<4> others;
    for (std::size_t k = 0; k < mesh.quads.size(); ++k) {
      const int label = mesh.quads.label[k];
      if (label < first_cap_)
        others.push_back(mesh.quads.vertices[k], label);
      else
        caps_[label].push_back(mesh.quads.vertices[k]);
    }
    quads_of_blocks_ = others.size();
    mesh.quads = std::move(others);
  }

  /* Throws Meshing_error if the part cannot be filled. */
  Number_of_cells fill(const Lumen_part& part, Length_function size, Mixed_mesh& mesh) {
    Junction junction;
    std::vector<std::vector<Index>> rims;
    std::vector<std::vector<Curve_position>> given;
    for (const Cut_curve& c : part.cut.curves) {
      const bool is_cap = c.opening >= first_cap_;
      if (is_cap)
        junction.caps.push_back(c.opening);
      rims.push_back(is_cap ? rim_of(caps_.at(c.opening)) : std::vector<Index>());
      given.push_back(positions_on(part.surface.surface, c, mesh.points, rims.back()));
    }
    const auto maps = parameterize_patches(part.surface.surface, part.cut, options_.parameterization);
    const Remeshed_surface wall =
        internal::quadrangulate_patches(part.surface.surface, part.cut, maps, size, options_.quads, given);
    junction.facets = facets_of(wall, rims, mesh);
    Facets closed = junction.facets;
    for (int label : junction.caps)
      for (const Quad& q : caps_.at(label))
        closed.quads.push_back(turned(q), inside);
    junctions_.push_back(std::move(junction));
    return fill_between(closed, size, mesh);
  }

  /* Puts layers along the wall, of the blocks and of what has been filled, which is filled again within them, in the
   * order in which it was; points may have moved since then. The layers on both sides of a cap have the same points. */
  Layer_report insert_layers(Length_function radius, Length_function size, Mixed_mesh& mesh,
                             std::vector<Number_of_cells>& numbers) const {
    Mixed_mesh result = blocks_of(mesh);
    Layer_report report = internal::insert_wall_layers(result, radius, options_.boundary_layer);
    std::map<int, std::vector<Quad>> cut_caps;
    Element_block<4> others;
    for (std::size_t k = 0; k < result.quads.size(); ++k)
      if (result.quads.label[k] < first_cap_)
        others.push_back(result.quads.vertices[k], result.quads.label[k]);
      else
        cut_caps[result.quads.label[k]].push_back(result.quads.vertices[k]);
    result.quads = std::move(others);
    for (const Junction& j : junctions_) {
      Facets closed;
      report = sum(report, add_layers(j, radius, cut_caps, mesh, result, closed));
      numbers.push_back(fill_between(closed, size, result));
    }
    result.region_names = mesh.region_names;
    result.patch_names = mesh.patch_names;
    mesh = std::move(result);
    return report;
  }

private:
  static constexpr int inside = -1; // the label of facets that are none of the mesh's boundary; 0 would be no label

  // In points of a mesh, counterclockwise from outside.
  struct Facets {
    Element_block<3> triangles;
    Element_block<4> quads;
  };
  struct Junction {
    Facets facets;         // those of the mesh's boundary
    std::vector<int> caps; // labels of those between it and blocks
  };

  // --- the wall ---

  /* The points round a cap, in order, with the cap on the left. Caps are counterclockwise seen from the part that is to
   * be filled. */
  static std::vector<Index> rim_of(const std::vector<Quad>& cap) {
    std::set<std::pair<Index, Index>> edges;
    for (const Quad& q : cap)
      for (std::size_t i = 0; i < 4; ++i)
        edges.emplace(q[i], q[(i + 1) % 4]);
    std::map<Index, Index> next;
    for (const auto& e : edges)
      if (edges.count({e.second, e.first}) == 0)
        next[e.first] = e.second;
    std::vector<Index> rim;
    const Index first = next.begin()->first;
    Index v = first;
    do {
      rim.push_back(v);
      v = next.at(v);
    } while (v != first);
    return rim;
  }

  /* Where the points of a cap's rim are on the curve, in its order, with which the rim is made to begin: as the cap is
   * seen from inside, both have the same direction. */
  static std::vector<Curve_position> positions_on(const Surface& surface, const Cut_curve& curve,
                                                  const std::vector<Point_3>& points, std::vector<Index>& rim) {
    std::vector<Curve_position> result;
    if (rim.empty())
      return result;
    for (Index v : rim)
      result.push_back(nearest_on(surface, curve, points[v]));
    const auto is_before = [](const Curve_position& a, const Curve_position& b) {
      return std::make_pair(a.edge, a.t) < std::make_pair(b.edge, b.t);
    };
    const auto first = std::min_element(result.begin(), result.end(), is_before) - result.begin();
    std::rotate(result.begin(), result.begin() + first, result.end());
    std::rotate(rim.begin(), rim.begin() + first, rim.end());
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

  // The points on the rims of caps are those of the mesh; the others are added to it.
  Facets facets_of(const Remeshed_surface& wall, const std::vector<std::vector<Index>>& rims, Mixed_mesh& mesh) const {
    std::vector<Index> index(wall.surface.number_of_vertices(), no_point);
    for (std::size_t c = 0; c < rims.size(); ++c)
      for (std::size_t i = 0; i < rims[c].size(); ++i)
        index[std::size_t(wall.curves[c][i])] = rims[c][i];
    Facets result;
    for (Face f : wall.surface.faces()) {
      const int label = wall.patch[f];
      if (label >= first_cap_)
        continue;
      std::vector<Index> corners;
      for (Vertex v : wall.surface.vertices_around_face(wall.surface.halfedge(f))) {
        Index& k = index[std::size_t(v)];
        if (k == no_point) {
          k = Index(mesh.points.size());
          mesh.points.push_back(wall.surface.point(v));
        }
        corners.push_back(k);
      }
      if (corners.size() == 3 && label == labels::wall)
        throw Meshing_error("the quads on its wall meet each other, however fine they are");
      if (corners.size() == 3)
        result.triangles.push_back({{corners[0], corners[1], corners[2]}}, label);
      else
        result.quads.push_back({{corners[0], corners[1], corners[2], corners[3]}}, label);
    }
    return result;
  }

  // --- cells ---

  static Quad turned(const Quad& q) { return {{q[0], q[3], q[2], q[1]}}; }

  // Closed facets as a surface; `points`: those of its vertices.
  static Labelled_surface surface_of(const Facets& facets, const std::vector<Point_3>& all,
                                     std::vector<Index>& points) {
    Labelled_surface result;
    std::unordered_map<Index, Vertex> vertex_of;
    const auto add = [&](const auto& elements) {
      for (std::size_t k = 0; k < elements.size(); ++k) {
        std::vector<Vertex> corners;
        for (Index v : elements.vertices[k]) {
          const auto [found, is_new] = vertex_of.emplace(v, Vertex());
          if (is_new) {
            found->second = result.surface.add_vertex(all[v]);
            points.push_back(v);
          }
          corners.push_back(found->second);
        }
        const Face f = result.surface.add_face(corners);
        if (f == Surface::null_face())
          throw Meshing_error("the facets of its boundary meet each other");
        result.patch[f] = elements.label[k];
      }
    };
    add(facets.triangles);
    add(facets.quads);
    return result;
  }

  Number_of_cells fill_between(const Facets& closed, Length_function size, Mixed_mesh& mesh) const {
    std::vector<Index> points;
    const Labelled_surface surface = surface_of(closed, mesh.points, points);
    Mixed_mesh filling;
    Fill_with_pyramids_and_tetrahedra_options pyramids = options_.pyramids;
    pyramids.split_quads = false; // the other sides of hexahedra
    internal::fill_with_pyramids_and_tetrahedra(surface.surface, surface.patch, size, filling, pyramids);
    append_mesh(mesh, filling, points, inside);
    return {filling.pyramids.size(), filling.tetrahedra.size()};
  }

  // --- layers ---

  // Caps included. Its points are the first of the mesh's, with their numbers.
  Mixed_mesh blocks_of(const Mixed_mesh& mesh) const {
    Mixed_mesh blocks;
    blocks.points.assign(mesh.points.begin(), mesh.points.begin() + std::ptrdiff_t(points_of_blocks_));
    blocks.hexahedra = mesh.hexahedra;
    for (std::size_t k = 0; k < quads_of_blocks_; ++k)
      blocks.quads.push_back(mesh.quads.vertices[k], mesh.quads.label[k]);
    for (const auto& [label, quads] : caps_)
      for (const Quad& q : quads)
        blocks.quads.push_back(q, label);
    return blocks;
  }

  /* Adds the layers in a junction to blocks that have theirs; `closed` becomes the boundary of what they leave. */
  Layer_report add_layers(const Junction& junction, Length_function radius,
                          const std::map<int, std::vector<Quad>>& cut_caps, const Mixed_mesh& mesh, Mixed_mesh& result,
                          Facets& closed) const {
    Facets before = junction.facets;
    for (int label : junction.caps)
      for (const Quad& q : caps_.at(label))
        before.quads.push_back(turned(q), label);
    std::vector<Index> points;
    const Labelled_surface surface = surface_of(before, mesh.points, points);
    Boundary_layer layer =
        internal::extrude_boundary_layer(surface.surface, surface.patch, radius, options_.boundary_layer);

    std::map<Point_3, Index> numbers; // of the wall's points, in the mesh
    for (Index v : points)
      numbers[mesh.points[v]] = v;
    std::vector<Index> known(layer.layers.points.size(), no_point); // in the result
    Columns own, of_blocks;
    for (std::size_t k = 0; k < layer.layers.quads.size(); ++k)
      if (layer.layers.quads.label[k] >= first_cap_)
        own.add(layer.layers.quads.vertices[k]);
    for (int label : junction.caps)
      for (const Quad& q : cut_caps.at(label))
        of_blocks.add(q);
    std::set<Index> in_layers; // points of caps that are no longer on what is left
    for (Index i = 0; i < known.size(); ++i) {
      const auto found = numbers.find(layer.layers.points[i]);
      if (found == numbers.end() || found->second >= points_of_blocks_)
        continue;
      Index a = i, b = found->second;
      for (known[a] = b; own.goes_on(a); known[a] = b) {
        in_layers.insert(b);
        a = own.next(a);
        b = of_blocks.next(b);
      }
    }
    for (std::size_t i = 0; i < known.size(); ++i)
      if (known[i] == no_point) {
        known[i] = Index(result.points.size());
        result.points.push_back(layer.layers.points[i]);
      }
    for (int& label : layer.layers.quads.label)
      label = label >= first_cap_ ? inside : label;
    append_mesh(result, layer.layers, known, inside);

    std::vector<Index> inner;
    for (Vertex v : layer.inner.vertices()) {
      const Index p = layer.mesh_points[std::size_t(v)];
      inner.push_back(p == no_point ? no_point : known[p]);
    }
    for (Face f : layer.inner.faces())
      if (layer.patch[f] < first_cap_)
        add_inner(layer, f, inner, result, closed);
    for (int label : junction.caps)
      for (const Quad& q : cut_caps.at(label))
        if (std::none_of(q.begin(), q.end(), [&](Index v) { return in_layers.count(v) > 0; }))
          closed.quads.push_back(turned(q), inside);
    return layer.report;
  }

  // From layer to layer along the rim of a cap: quads there begin with an edge along the rim.
  class Columns {
  public:
    void add(const Quad& q) {
      next_.emplace(q[0], q[3]);
      next_.emplace(q[1], q[2]);
    }
    bool goes_on(Index v) const { return next_.count(v) > 0; }
    Index next(Index v) const { return next_.at(v); }

  private:
    std::unordered_map<Index, Index> next_;
  };

  // A face of what layers leave: on their far side, or of an opening.
  static void add_inner(const Boundary_layer& layer, Face f, std::vector<Index>& inner, Mixed_mesh& result,
                        Facets& closed) {
    const int label = layer.patch[f] == labels::wall ? inside : layer.patch[f];
    std::vector<Index> corners;
    for (Vertex v : layer.inner.vertices_around_face(layer.inner.halfedge(f))) {
      Index& k = inner[std::size_t(v)];
      if (k == no_point) {
        k = Index(result.points.size());
        result.points.push_back(layer.inner.point(v));
      }
      corners.push_back(k);
    }
    if (corners.size() == 3)
      closed.triangles.push_back({{corners[0], corners[1], corners[2]}}, label);
    else
      closed.quads.push_back({{corners[0], corners[1], corners[2], corners[3]}}, label);
  }

  static Layer_report sum(const Layer_report& a, const Layer_report& b) {
    Layer_report result = a.min_ratio <= b.min_ratio ? a : b;
    result.vertices = a.vertices + b.vertices;
    result.reduced_vertices = a.reduced_vertices + b.reduced_vertices;
    result.prisms = a.prisms + b.prisms;
    result.hexahedra = a.hexahedra + b.hexahedra;
    result.relabelled_facets = a.relabelled_facets + b.relabelled_facets;
    if (result.vertices > 0)
      result.mean_ratio =
          (a.mean_ratio * double(a.vertices) + b.mean_ratio * double(b.vertices)) / double(result.vertices);
    result.rounds = (std::max)(a.rounds, b.rounds);
    return result;
  }

  const int first_cap_;
  const Mesher_options& options_;
  std::size_t points_of_blocks_, quads_of_blocks_; // those of the mesh that come first
  std::map<int, std::vector<Quad>> caps_;          // by their labels
  std::vector<Junction> junctions_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_JUNCTION_FILLER_H
