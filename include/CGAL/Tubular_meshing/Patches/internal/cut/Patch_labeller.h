// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_PATCH_LABELLER_H
#define CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_PATCH_LABELLER_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Cut_surface.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Disk_cutter.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Graph_pieces.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Turns the cuts into patches: flood fill between curves, then records, in the order of the centerlines. O(n) in the
 * surface, O(n log n) in the number of patches. */
class Patch_labeller {
public:
  Patch_labeller(const Cut_surface& surface, const Disk_cutter& cutter,
                 const std::vector<std::vector<Halfedge>>& handle_cuts, Surface_cut& result)
      : surface_(surface)
      , mesh_(surface.mesh())
      , cutter_(cutter)
      , partition_(cutter)
      , handle_cuts_(handle_cuts)
      , result_(result) {}

  void label() {
    result_.patch_of_face = mesh_.add_property_map<Face, int>("f:surface_patch", -1).first;
    for (Face f : mesh_.faces())
      result_.patch_of_face[f] = -1;
    fill();
    collect_cuts();
    collect_handle_cuts();
    collect_rims();
    number_along_centerlines();
    describe();
  }

  // Whether cuts that bound the patch bound different pieces of the centerlines: something joins these.
  bool has_several_pieces(size_type patch) const { return has_several_pieces_[patch]; }
  // Whether a piece of the centerlines has other patches than this one.
  bool has_half_a_piece(size_type patch) const {
    return piece_of_patch_[patch] != none && patch_of_piece_[piece_of_patch_[patch]] != patch;
  }

private:
  static constexpr size_type none = Cut_curve::none;

  // Labels connected faces alike, curves being the borders.
  void fill() {
    std::vector<Face> stack;
    for (Face seed : mesh_.faces()) {
      if (!surface_.is_wall(seed) || result_.patch_of_face[seed] >= 0)
        continue;
      const int patch = int(result_.patches.size());
      result_.patches.emplace_back();
      result_.patch_of_face[seed] = patch;
      stack.push_back(seed);
      while (!stack.empty()) {
        const Face f = stack.back();
        stack.pop_back();
        for (Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(f))) {
          const Face g = mesh_.face(mesh_.opposite(h));
          if (!surface_.is_on_curve(h) && result_.patch_of_face[g] < 0) {
            result_.patch_of_face[g] = patch;
            stack.push_back(g);
          }
        }
      }
    }
  }

  void collect_cuts() {
    for (size_type i : partition_.branches_from_root())
      for (size_type c : cutter_.cuts_of(i)) {
        const Branch_cut& cut = cutter_.cuts()[c];
        Cut_curve curve;
        curve.branch = i;
        curve.abscissa = cut.abscissa;
        add_curve(std::move(curve), cut.halfedges);
      }
  }

  void collect_handle_cuts() {
    for (const std::vector<Halfedge>& cut : handle_cuts_)
      add_curve(Cut_curve(), cut);
  }

  void collect_rims() {
    std::vector<bool> done(mesh_.number_of_halfedges() + mesh_.number_of_removed_halfedges(), false);
    std::vector<std::pair<int, std::vector<Halfedge>>> rims;
    for (Halfedge h : mesh_.halfedges()) {
      if (done[h] || !is_rim(h))
        continue;
      rims.emplace_back(surface_.label(mesh_.face(mesh_.opposite(h))), std::vector<Halfedge>());
      for (Halfedge g = h; !done[g]; g = next_on_rim(g)) {
        done[g] = true;
        rims.back().second.push_back(g);
      }
    }
    std::stable_sort(rims.begin(), rims.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (auto& rim : rims) {
      Cut_curve curve;
      curve.opening = rim.first;
      add_curve(std::move(curve), std::move(rim.second));
    }
  }

  bool is_rim(Halfedge h) const {
    return surface_.is_wall(mesh_.face(h)) && !surface_.is_wall(mesh_.face(mesh_.opposite(h)));
  }

  // Through the wall's faces about the vertex.
  Halfedge next_on_rim(Halfedge h) const {
    h = mesh_.next(h);
    while (!is_rim(h))
      h = mesh_.next(mesh_.opposite(h));
    return h;
  }

  void add_curve(Cut_curve curve, std::vector<Halfedge> halfedges) {
    curve.halfedges = std::move(halfedges);
    for (Halfedge h : curve.halfedges)
      curve.vertices.push_back(mesh_.source(h));
    curve.left_patch = patch_at(curve.halfedges.front());
    curve.right_patch = curve.is_rim() ? none : patch_at(mesh_.opposite(curve.halfedges.front()));
    result_.curves.push_back(std::move(curve));
  }

  size_type patch_at(Halfedge h) const { return size_type(result_.patch_of_face[mesh_.face(h)]); }

  /* A patch is where the pieces of the centerlines are whose cuts bound it: its number is the first one's. */
  void number_along_centerlines() {
    const size_type n = result_.patches.size();
    std::vector<size_type> piece(n, n == 1 ? 0 : none);
    std::vector<bool> several(n, false);
    const auto claim = [&](size_type patch, size_type p) {
      several[patch] = several[patch] || (piece[patch] != none && piece[patch] != p);
      piece[patch] = (std::min)(piece[patch], p);
    };
    std::vector<size_type> next_part(cutter_.graph().branches().size(), 0);
    for (const Cut_curve& c : result_.curves)
      if (c.branch != none) {
        const size_type part = next_part[c.branch]++;
        claim(c.left_patch, partition_.piece_of(c.branch, part));
        claim(c.right_patch, partition_.piece_of(c.branch, part + 1));
      }
    std::vector<size_type> order(n), number(n);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](size_type a, size_type b) { return piece[a] < piece[b]; });
    patch_of_piece_.assign(partition_.pieces().size(), none);
    piece_of_patch_.resize(n);
    has_several_pieces_.resize(n);
    for (size_type i = n; i-- > 0;) {
      number[order[i]] = i;
      piece_of_patch_[i] = piece[order[i]];
      has_several_pieces_[i] = several[order[i]];
      if (piece_of_patch_[i] != none)
        patch_of_piece_[piece_of_patch_[i]] = i;
    }
    for (Face f : mesh_.faces())
      if (result_.patch_of_face[f] >= 0)
        result_.patch_of_face[f] = int(number[size_type(result_.patch_of_face[f])]);
    for (Cut_curve& c : result_.curves) {
      c.left_patch = number[c.left_patch];
      c.right_patch = c.is_rim() ? none : number[c.right_patch];
    }
  }

  void describe() {
    count_elements();
    for (size_type i = 0; i < result_.curves.size(); ++i) {
      const Cut_curve& c = result_.curves[i];
      result_.patches[c.left_patch].loops.push_back(Patch_loop{i, true, c.right_patch});
      if (!c.is_rim())
        result_.patches[c.right_patch].loops.push_back(Patch_loop{i, false, c.left_patch});
    }
    for (size_type p = 0; p < result_.patches.size(); ++p)
      describe(result_.patches[p], piece_of_patch_[p]);
    for (Cut_curve& c : result_.curves)
      if (c.is_rim())
        find_branch(c);
  }

  // χ of a patch without its boundary, whose circles count nothing.
  void count_elements() {
    for (Face f : mesh_.faces())
      if (result_.patch_of_face[f] >= 0) {
        Surface_patch& patch = result_.patches[size_type(result_.patch_of_face[f])];
        patch.faces.push_back(f);
        ++patch.euler_characteristic;
      }
    for (auto e : mesh_.edges()) {
      const Halfedge h = mesh_.halfedge(e);
      if (surface_.is_wall(mesh_.face(h)) && !surface_.is_on_curve(h))
        --result_.patches[patch_at(h)].euler_characteristic;
    }
    for (Vertex v : mesh_.vertices())
      if (surface_.is_wall(mesh_.face(mesh_.halfedge(v))) && !surface_.is_taken(v))
        ++result_.patches[patch_at(mesh_.halfedge(v))].euler_characteristic;
  }

  void describe(Surface_patch& patch, size_type piece) {
    const size_type k = patch.loops.size();
    patch.kind = k == 0   ? Patch_kind::closed
                 : k == 1 ? Patch_kind::disk
                 : k == 2 ? Patch_kind::annular
                          : Patch_kind::junction;
    if (piece == none)
      return;
    const Graph_piece& g = partition_.pieces()[piece];
    std::set<size_type> branches;
    for (const Branch_part& p : g.parts)
      branches.insert(p.branch);
    patch.branches.assign(branches.begin(), branches.end());
    patch.length = g.length;
    patch.mean_diameter = g.min_radius + g.max_radius;
  }

  // The end of a branch in the rim's patch that is nearest to the rim's centre.
  void find_branch(Cut_curve& rim) const {
    const size_type piece = piece_of_patch_[rim.left_patch];
    if (piece == none)
      return;
    Vector_3d center;
    for (Vertex v : rim.vertices)
      center += (1. / double(rim.vertices.size())) * surface_.point(v);
    const auto& graph = cutter_.graph();
    double size = 0;
    for (Vertex v : rim.vertices)
      size = (std::max)(size, norm(surface_.point(v) - center));
    double best = size; // an end further away is not in this opening
    for (size_type n : partition_.pieces()[piece].nodes) {
      const double d = norm(Vector_3d(graph.points()[graph.nodes()[n].point]) - center);
      if (graph.nodes()[n].is_end() && d < best) {
        best = d;
        rim.branch = graph.nodes()[n].branches.front();
        const auto& b = graph.branches()[rim.branch];
        rim.abscissa = b.target == n ? b.length : 0;
      }
    }
  }

  const Cut_surface& surface_;
  Surface& mesh_;
  const Disk_cutter& cutter_;
  const Graph_partition partition_;
  const std::vector<std::vector<Halfedge>>& handle_cuts_;
  Surface_cut& result_;
  std::vector<size_type> piece_of_patch_, patch_of_piece_;
  std::vector<bool> has_several_pieces_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_INTERNAL_CUT_PATCH_LABELLER_H
