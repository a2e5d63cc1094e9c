// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_LUMEN_DIVIDER_H
#define CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_LUMEN_DIVIDER_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Labelled_surface.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A part of a lumen between cuts across it: closed, with a cap on each of these. */
struct Lumen_part {
  Labelled_surface surface;
  Surface_cut cut;                      // its patches; the curves between it and other parts are rims
  std::vector<std::size_t> whole_patch; // of each patch: the one of the whole
  Centerline_graph graph;               // what is in it of the centerlines
};

/* Divides the lumen of a cut surface along those curves that are between patches of two kinds. */
class Lumen_divider {
public:
  typedef std::size_t size_type;

  /* `kind`: of each patch. The cap on curve c is labelled `first_label` + c. Throws Meshing_error if a curve is not
   * across a vessel. O(n log n). */
  Lumen_divider(const Labelled_surface& surface, const Surface_cut& cut, const Centerline_graph& graph,
                std::vector<char> kind, int first_label)
      : surface_(surface.surface)
      , label_(surface.patch)
      , cut_(cut)
      , graph_(graph)
      , kind_(std::move(kind))
      , first_label_(first_label) {
    for (const Cut_curve& c : cut_.curves)
      if (is_between(c) && c.branch == Cut_curve::none)
        throw Meshing_error("the wall is cut round a handle");
    number_parts();
    for (Face f : surface_.faces())
      if (cut_.patch_of_face[f] < 0)
        caps_[label_[f]].push_back(f);
  }

  size_type number_of_parts() const { return kind_of_part_.size(); }
  char kind_of(size_type part) const { return kind_of_part_[part]; }

  Lumen_part part(size_type k) const {
    Lumen_part result;
    const Copies copies = add_faces(k, result);
    add_curves(k, copies, result);
    close(result);
    result.graph = graph_of(k);
    return result;
  }

private:
  typedef std::map<Vertex, Vertex> Copies; // of the whole surface's vertices

  bool is_between(const Cut_curve& c) const { return !c.is_rim() && kind_[c.left_patch] != kind_[c.right_patch]; }

  // Patches of one kind that are neighbors are in one part.
  void number_parts() {
    constexpr size_type none = Cut_curve::none;
    part_.assign(cut_.patches.size(), none);
    for (size_type first = 0; first < part_.size(); ++first) {
      if (part_[first] != none)
        continue;
      std::vector<size_type> found{first};
      part_[first] = kind_of_part_.size();
      kind_of_part_.push_back(kind_[first]);
      while (!found.empty()) {
        const size_type p = found.back();
        found.pop_back();
        for (const Patch_loop& loop : cut_.patches[p].loops)
          if (loop.neighbour != none && part_[loop.neighbour] == none && kind_[loop.neighbour] == kind_[first]) {
            part_[loop.neighbour] = part_[first];
            found.push_back(loop.neighbour);
          }
      }
    }
  }

  // --- the surface ---

  Copies add_faces(size_type k, Lumen_part& part) const {
    Surface& s = part.surface.surface;
    part.cut.patch_of_face = s.add_property_map<Face, int>("f:surface_patch", -1).first;
    Copies copies;
    const auto copy = [&](Vertex v) {
      const auto [found, is_new] = copies.emplace(v, Vertex());
      if (is_new)
        found->second = s.add_vertex(surface_.point(v));
      return found->second;
    };
    for (size_type p = 0; p < cut_.patches.size(); ++p) {
      if (part_[p] != k)
        continue;
      Surface_patch patch = cut_.patches[p];
      for (Face& f : patch.faces) {
        f = add_face(f, s, copy);
        part.surface.patch[f] = labels::wall;
        part.cut.patch_of_face[f] = int(part.cut.patches.size());
      }
      part.cut.patches.push_back(std::move(patch));
      part.whole_patch.push_back(p);
    }
    for (const Cut_curve& c : cut_.curves)
      if (c.is_rim() && part_[c.left_patch] == k)
        for (Face f : caps_.at(c.opening))
          part.surface.patch[add_face(f, s, copy)] = c.opening;
    return copies;
  }
  template <class Copy> Face add_face(Face f, Surface& s, const Copy& copy) const {
    const Halfedge h = surface_.halfedge(f);
    return s.add_face(copy(surface_.source(h)), copy(surface_.target(h)), copy(surface_.target(surface_.next(h))));
  }

  // --- its curves ---

  void add_curves(size_type k, const Copies& copies, Lumen_part& part) const {
    std::map<size_type, size_type> number, patch_number; // of those of the whole
    for (const bool between : {false, true})             // what is between parts is a rim, and these come last
      for (size_type c = 0; c < cut_.curves.size(); ++c) {
        const Cut_curve& curve = cut_.curves[c];
        const bool is_here = part_[curve.left_patch] == k || (!curve.is_rim() && part_[curve.right_patch] == k);
        if (!is_here || is_between(curve) != between)
          continue;
        number[c] = part.cut.curves.size();
        part.cut.curves.push_back(copy_of(c, part_[curve.left_patch] == k, copies, part.surface.surface));
      }
    for (size_type p : part.whole_patch)
      patch_number.emplace(p, patch_number.size());
    for (Cut_curve& c : part.cut.curves) {
      c.left_patch = patch_number.at(c.left_patch);
      if (c.right_patch != Cut_curve::none)
        c.right_patch = patch_number.at(c.right_patch);
    }
    for (Surface_patch& p : part.cut.patches) {
      for (Patch_loop& loop : p.loops) {
        const bool is_rim = is_between(cut_.curves[loop.curve]);
        loop.curve = number.at(loop.curve);
        loop.forward = loop.forward || is_rim;
        loop.neighbour =
            is_rim || loop.neighbour == Cut_curve::none ? Cut_curve::none : patch_number.at(loop.neighbour);
      }
      std::stable_sort(p.loops.begin(), p.loops.end(),
                       [](const Patch_loop& a, const Patch_loop& b) { return a.curve < b.curve; });
    }
  }

  // A rim has the wall on its left.
  Cut_curve copy_of(size_type c, bool is_left, const Copies& copies, const Surface& s) const {
    Cut_curve curve = cut_.curves[c];
    if (is_between(cut_.curves[c])) {
      if (!is_left) {
        std::reverse(curve.halfedges.begin(), curve.halfedges.end());
        for (Halfedge& h : curve.halfedges)
          h = surface_.opposite(h);
        curve.left_patch = curve.right_patch;
      }
      curve.right_patch = Cut_curve::none;
      curve.opening = first_label_ + int(c);
    }
    curve.vertices.clear();
    for (Halfedge& h : curve.halfedges) {
      h = s.halfedge(copies.at(surface_.source(h)), copies.at(surface_.target(h)));
      curve.vertices.push_back(s.source(h));
    }
    return curve;
  }

  // Puts caps on the curves that are open.
  static void close(Lumen_part& part) {
    Surface& s = part.surface.surface;
    for (const Cut_curve& c : part.cut.curves) {
      const Halfedge h = s.opposite(c.halfedges.front());
      if (!s.is_border(h))
        continue;
      std::vector<Face> cap;
      Polygon_mesh_processing::triangulate_hole(s, h, std::back_inserter(cap));
      if (cap.empty())
        throw Meshing_error("the cut across a vessel there cannot be closed");
      for (Face f : cap)
        part.surface.patch[f] = c.opening;
    }
  }

  // --- the centerlines ---

  /* Of each branch the pieces that are in the part: on the left of a cut is what is nearer to the branch's source. */
  Centerline_graph graph_of(size_type k) const {
    std::vector<Point_3> points = graph_.points();
    std::vector<double> radii = graph_.radii();
    std::vector<Centerline_graph::Polyline> pieces;
    std::vector<std::vector<size_type>> cuts(graph_.branches().size());
    for (size_type c = 0; c < cut_.curves.size(); ++c)
      if (is_between(cut_.curves[c]))
        cuts[cut_.curves[c].branch].push_back(c);
    std::vector<size_type> part_of_branch(graph_.branches().size(), Cut_curve::none);
    for (size_type p = 0; p < part_.size(); ++p)
      for (size_type b : cut_.patches[p].branches)
        part_of_branch[b] = part_[p];
    for (size_type b = 0; b < cuts.size(); ++b) {
      const Centerline_graph::Branch& branch = graph_.branches()[b];
      std::sort(cuts[b].begin(), cuts[b].end(),
                [&](size_type c, size_type d) { return cut_.curves[c].abscissa < cut_.curves[d].abscissa; });
      if (cuts[b].empty()) {
        if (part_of_branch[b] == k)
          pieces.push_back(branch.points);
        continue;
      }
      std::vector<size_type> ends; // the points at the cuts
      for (size_type c : cuts[b]) {
        ends.push_back(points.size());
        add_point(branch, cut_.curves[c].abscissa, points, radii);
      }
      for (size_type i = 0; i <= ends.size(); ++i) {
        const size_type patch =
            i < ends.size() ? cut_.curves[cuts[b][i]].left_patch : cut_.curves[cuts[b].back()].right_patch;
        if (part_[patch] != k)
          continue;
        Centerline_graph::Polyline piece;
        if (i > 0)
          piece.push_back(ends[i - 1]);
        for (size_type j = 0; j < branch.points.size(); ++j)
          if ((i == 0 || branch.abscissa[j] > cut_.curves[cuts[b][i - 1]].abscissa) &&
              (i == ends.size() || branch.abscissa[j] < cut_.curves[cuts[b][i]].abscissa))
            piece.push_back(branch.points[j]);
        if (i < ends.size())
          piece.push_back(ends[i]);
        pieces.push_back(std::move(piece));
      }
    }
    return Centerline_graph(std::move(points), std::move(radii), std::move(pieces));
  }
  void add_point(const Centerline_graph::Branch& branch, double abscissa, std::vector<Point_3>& points,
                 std::vector<double>& radii) const {
    const auto next = std::upper_bound(branch.abscissa.begin() + 1, branch.abscissa.end() - 1, abscissa);
    const size_type j = size_type(next - branch.abscissa.begin());
    const size_type a = branch.points[j - 1], b = branch.points[j];
    const double length = branch.abscissa[j] - branch.abscissa[j - 1];
    const double t = length > 0 ? (std::min)((std::max)((abscissa - branch.abscissa[j - 1]) / length, 0.), 1.) : 0;
    points.push_back(graph_.points()[a] + t * (graph_.points()[b] - graph_.points()[a]));
    radii.push_back((1 - t) * graph_.radii()[a] + t * graph_.radii()[b]);
  }

  const Surface& surface_;
  const Face_patch_map label_;
  const Surface_cut& cut_;
  const Centerline_graph& graph_;
  const std::vector<char> kind_; // of each patch
  const int first_label_;
  std::vector<size_type> part_; // of each patch
  std::vector<char> kind_of_part_;
  std::map<int, std::vector<Face>> caps_; // of openings, by their labels
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_LUMEN_DIVIDER_H
