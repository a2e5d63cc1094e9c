// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_CUT_BY_CENTERLINES_IMPL_H
#define CGAL_TUBULAR_MESHING_PATCHES_CUT_BY_CENTERLINES_IMPL_H

#include <CGAL/Tubular_meshing/Patches/cut_by_centerlines.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Blind_vessel_finder.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Cut_surface.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Disk_cutter.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Handle_cutter.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Junction_cutter.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Patch_labeller.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Piece_divider.h>
#include <CGAL/Tubular_meshing/Patches/internal/cut/Tube_divider.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

inline void check_cut_input(const Surface& surface, Face_patch_map patch, const Centerline_graph& graph,
                            double aspect_ratio) {
  if (!(aspect_ratio >= 1) || !std::isfinite(aspect_ratio))
    throw Parameter_error("The aspect ratio of patches is " + std::to_string(aspect_ratio) +
                          "; it must be 1 or more, as shorter tubes have no room for their own mesh.");
  if (graph.empty())
    throw Input_error("There are no centerlines to cut the surface by.");
  for (std::size_t i = 0; i < graph.points().size(); ++i)
    if (!(graph.radii()[i] > 0))
      throw Input_error("The centerlines have no radius at point " + std::to_string(i) +
                        "; measure the radii with Wall_distance.");
  if (surface.is_empty() || !CGAL::is_triangle_mesh(surface) || !CGAL::is_closed(surface))
    throw Input_error("Only closed surfaces of triangles are cut; close the openings of this one first "
                      "(close_openings()), and triangulate its faces.");
  for (auto f : surface.faces())
    if (patch[f] == labels::wall)
      return;
  throw Input_error("None of the surface's faces is labelled as wall; there is nothing to cut.");
}

/* The steps of cut_by_centerlines(), on input that has been checked. */
class Centerline_cut {
public:
  Centerline_cut(Surface& surface, const Centerline_graph& graph, Face_patch_map patch, double aspect_ratio,
                 double clearance)
      : surface_(surface, patch)
      , graph_(graph)
      , cutter_(surface_, graph)
      , junctions_(cutter_, clearance)
      , tubes_(cutter_, aspect_ratio)
      , pieces_(cutter_, tubes_, aspect_ratio)
      , aspect_ratio_(aspect_ratio) {}

  Surface_cut run() {
    const std::vector<size_type> branches = Graph_partition(cutter_).branches_from_root();
    for (size_type b : branches)
      junctions_.cut_off(b);
    for (size_type b : branches)
      tubes_.divide(b);
    pieces_.open_cycles();
    pieces_.divide_long_pieces();
    Handle_cutter handles(surface_);
    handles.run();

    Surface_cut result;
    Patch_labeller labeller(surface_, cutter_, handles.cuts(), result);
    labeller.label();
    for (size_type b : junctions_.merged())
      if (cutter_.cuts_of(b).empty())
        result.merged_branches.push_back(b);
    result.moved_cuts = junctions_.number_of_moved() + tubes_.number_of_moved() + pieces_.number_of_cuts();
    result.handle_cuts = handles.cuts().size();
    report_patches(labeller, result);
    report_blind_vessels(result);
    return result;
  }

private:
  Point_3 middle(size_type branch) const {
    return as<Point_3>(cutter_.axis(branch).point(graph_.branches()[branch].length / 2));
  }

  void report_patches(const Patch_labeller& labeller, Surface_cut& result) const {
    const double rounding = 1e-9;
    for (size_type i = 0; i < result.patches.size(); ++i) {
      const Surface_patch& p = result.patches[i];
      const bool is_known = !p.branches.empty();
      const size_type b = is_known ? p.branches.front() : 0;
      const auto report = [&](Cut_problem::Kind kind) {
        result.problems.push_back(Cut_problem{kind, middle(b), b, i});
      };
      if (!is_known || !p.is_sphere_with_holes() || labeller.has_half_a_piece(i))
        report(Cut_problem::wrong_topology);
      else if (labeller.has_several_pieces(i))
        report(Cut_problem::no_centerline);
      else if (p.aspect_ratio() > aspect_ratio_ * (1 + rounding))
        report(Cut_problem::too_long);
    }
  }

  void report_blind_vessels(Surface_cut& result) const {
    for (const auto& vessel : Blind_vessel_finder(surface_, graph_).find())
      result.problems.push_back(Cut_problem{Cut_problem::no_centerline, surface_.mesh().point(vessel.tip),
                                            vessel.branch, size_type(result.patch_of_face[vessel.face])});
  }

  Cut_surface surface_;
  const Centerline_graph& graph_;
  Disk_cutter cutter_;
  Junction_cutter junctions_;
  Tube_divider tubes_;
  Piece_divider pieces_;
  const double aspect_ratio_;
};

CGAL_TUBULAR_MESHING_INLINE Surface_cut cut_by_centerlines(Surface& surface, const Centerline_graph& graph,
                                                           Face_patch_map patch,
                                                           const Cut_by_centerlines_options& options,
                                                           double clearance) {
  if (surface.has_garbage())
    surface.collect_garbage();
  check_cut_input(surface, patch, graph, options.aspect_ratio);
  return Centerline_cut(surface, graph, patch, options.aspect_ratio, clearance).run();
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_CUT_BY_CENTERLINES_IMPL_H
