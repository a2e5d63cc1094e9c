// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_SURFACE_REPAIRER_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_SURFACE_REPAIRER_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Repair/Repair_report.h>
#include <CGAL/Tubular_meshing/Repair/Repair_surface_options.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/Repair/internal/Soup_edges.h>
#include <CGAL/Tubular_meshing/Repair/internal/drop_islands.h>
#include <CGAL/Tubular_meshing/Repair/internal/fill_wall.h>
#include <CGAL/Tubular_meshing/Repair/internal/repair_crossings.h>
#include <CGAL/Tubular_meshing/Repair/internal/is_oriented_surface.h>
#include <CGAL/Tubular_meshing/Repair/internal/put_back_spikes.h>
#include <CGAL/Tubular_meshing/Repair/internal/remove_fins.h>
#include <CGAL/Tubular_meshing/Repair/internal/remove_needles.h>
#include <CGAL/Tubular_meshing/Repair/internal/report_orientation.h>
#include <CGAL/Tubular_meshing/Repair/internal/sew_seams.h>
#include <CGAL/Tubular_meshing/Repair/internal/smooth_noise.h>
#include <CGAL/Tubular_meshing/Repair/internal/split_touching_loops.h>
#include <CGAL/Tubular_meshing/Repair/internal/tube_ends.h>
#include <CGAL/Tubular_meshing/Repair/internal/turn_parts_outward.h>
#include <CGAL/Tubular_meshing/Repair/internal/unite_parts.h>
#include <CGAL/Tubular_meshing/Repair/internal/sort_border_loops.h>
#include <CGAL/Tubular_meshing/Repair/internal/wrap_surface.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The corners of each face, as indices of vertices. */
inline std::vector<Index_triangle> triangles_of(const Surface& mesh) {
  std::vector<Index_triangle> triangles;
  triangles.reserve(mesh.number_of_faces());
  for (auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    triangles.push_back(
        {std::size_t(mesh.source(h)), std::size_t(mesh.target(h)), std::size_t(mesh.target(mesh.next(h)))});
  }
  return triangles;
}

/* The repairs, one after the other: first those of the triangles as a soup, then those of the mesh that they make. */
class Surface_repairer {
  typedef Surface::Vertex_index Vertex;
  typedef Surface::Halfedge_index Halfedge;
  typedef Surface::Face_index Face;

public:
  Surface_repairer(Surface& mesh, Repair_report& report, const Repair_surface_options& options)
      : mesh_(mesh)
      , report_(report)
      , options_(options) {}

  /* Makes the mesh and repairs nothing but what keeps the triangles from being one. */
  void assemble(Triangle_soup& soup) {
    merge_and_drop(soup);
    make_mesh(soup);
  }

  /* Makes the mesh and repairs it; what cannot be repaired in place, or anything if so asked, is wrapped. */
  void repair(Triangle_soup& soup, bool wrap_anyway) {
    merge_and_drop(soup);
    sew(soup);
    remove_fins(soup);
    make_mesh(soup);
    report_islands(drop_islands(mesh_, options_.number_of_parts));
    turn_outward();
    remove_needles();
    Touching_loop_splitter(mesh_).split();
    close_holes();
    replace_needles();
    unite_parts();
    const bool is_repaired = repair_crossings() && is_sound();
    if (!is_repaired || wrap_anyway)
      wrap();
    report_handles();
  }

  void smooth() {
    const std::vector<Point_3> before(mesh_.points().begin(), mesh_.points().end());
    const bool was_bad = !find_bad_faces(mesh_).empty();
    Noise_smoother(mesh_).smooth();
    if (!was_bad && !find_bad_faces(mesh_).empty() && !Crossing_repairer(mesh_).repair(find_bad_faces(mesh_)))
      throw Meshing_error("Smoothing makes the surface intersect itself at " +
                          coordinates(find_bad_faces(mesh_).crossing) + ": leave the smoothing out.");
    double farthest = 0;
    for (std::size_t i = 0; i < (std::min)(before.size(), std::size_t(mesh_.num_vertices())); ++i)
      farthest = (std::max)(farthest, point_distance(before[i], mesh_.point(Vertex(Surface::size_type(i)))));
    report_.add(Surface_defect::noise, mesh_.number_of_vertices(), farthest,
                "The surface was smoothed, by up to " + short_number(farthest) + ".");
  }

private:
  static Point_3 point(const Coordinates& c) { return Point_3(c[0], c[1], c[2]); }

  // --- the soup ---

  void merge_and_drop(Triangle_soup& soup) {
    const std::size_t points = soup.points.size(), triangles = soup.triangles.size();
    merge_points(soup.points, soup.triangles);
    if (soup.points.size() < points)
      report_.add(Surface_defect::duplicate_points, points - soup.points.size(), 0,
                  counted(points - soup.points.size(), "point was", "points were") + " merged with equal ones.");
    const std::size_t collapsed =
        std::size_t(std::count_if(soup.triangles.begin(), soup.triangles.end(), [](const Index_triangle& t) {
          return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
        }));
    drop_degenerate_and_duplicate(soup.triangles);
    const std::size_t duplicates = triangles - collapsed - soup.triangles.size();
    if (collapsed > 0)
      report_.add(Surface_defect::collapsed_triangles, collapsed, 0,
                  counted(collapsed, "triangle with two equal corners was", "triangles with two equal corners were") +
                      " removed.");
    if (duplicates > 0)
      report_.add(Surface_defect::duplicate_triangles, duplicates, 0,
                  counted(duplicates, "repeated triangle was", "repeated triangles were") + " removed.");
    drop_unused_points(soup.points, soup.triangles);
    if (soup.triangles.empty())
      throw Input_error("The surface has no triangle with three different corners: check the unit and the precision it "
                        "was exported with.");
    const std::size_t fewest = 6; // of a prism, open at both ends
    if (soup.triangles.size() < fewest)
      throw Input_error("The surface has only " + counted(soup.triangles.size(), "triangle", "triangles") +
                        ", too few for a vessel: check that the file is what it should be.");
  }

  void sew(Triangle_soup& soup) {
    const Sewn_seams sewn = Seam_sewer(soup).sew();
    if (sewn.edges > 0)
      report_.add(Surface_defect::seam_gaps, sewn.edges, sewn.width,
                  "Gaps of up to " + short_number(sewn.width) + " along seams were sewn up, " +
                      counted(sewn.edges, "edge", "edges") + " in all.",
                  point(sewn.place));
  }

  void remove_fins(Triangle_soup& soup) {
    const Removed_fins removed = Fin_remover(soup).remove();
    if (removed.edges == 0)
      return;
    drop_unused_points(soup.points, soup.triangles);
    report_.add(Surface_defect::nonmanifold_edges, removed.edges, 0,
                counted(removed.edges, "edge was", "edges were") + " shared by more than two triangles, the first at " +
                    coordinates(point(removed.place)) + ": fins and membranes there, of " +
                    counted(removed.triangles, "triangle", "triangles") + ", were removed.",
                point(removed.place));
  }

  void make_mesh(Triangle_soup& soup) {
    std::vector<Point_3> points;
    points.reserve(soup.points.size());
    for (const Coordinates& p : soup.points)
      points.push_back(point(p));
    if (!is_oriented_surface(soup.triangles, points.size())) { // a cheap test before a costly step
      const std::vector<Index_triangle> before = soup.triangles;
      Polygon_mesh_processing::orient_polygon_soup(points, soup.triangles);
      report_orientation(points, before, soup.triangles, report_);
    }
    mesh_.clear();
    Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, soup.triangles, mesh_);
    Polygon_mesh_processing::stitch_borders(mesh_);
  }

  // --- the mesh ---

  void report_islands(const Dropped_islands& dropped) {
    if (dropped.count == 0)
      return;
    report_.add(Surface_defect::islands, dropped.count, dropped.extent,
                counted(dropped.count, "island", "islands") + " of " +
                    counted(dropped.triangles, "triangle", "triangles") + " in all, " +
                    short_number(100 * dropped.share) + " % of the area, the largest at " + coordinates(dropped.place) +
                    ", " + (dropped.count == 1 ? "was" : "were") + " removed.",
                dropped.place);
  }

  void turn_outward() {
    if (options_.number_of_parts == 1 ? !is_inside_out(mesh_, border_cycles(mesh_)) : !turn_parts_outward(mesh_))
      return;
    if (options_.number_of_parts == 1)
      Polygon_mesh_processing::reverse_face_orientations(mesh_);
    report_.add(Surface_defect::inside_out, mesh_.number_of_faces(), 0,
                "The normals of the surface pointed into the lumen; they now point outward.");
  }

  // Vessels that cross; what is wrong within one is repaired before, as far as a union asks for it, and after.
  void unite_parts() {
    if (number_of_pieces() == 1)
      return;
    const United_parts parts = internal::unite_parts(mesh_);
    if (parts.inside > 0)
      report_.add(Surface_defect::parts_inside, parts.inside, 0,
                  counted(parts.inside, "part", "parts") + " of the surface, " + short_number(100 * parts.share) +
                      " % of the area, " + (parts.inside == 1 ? "lies" : "lie") + " inside of another one, as at " +
                      coordinates(parts.place_inside) + ", and " + (parts.inside == 1 ? "was" : "were") + " removed.",
                  parts.place_inside);
    if (parts.united == 0)
      return;
    report_.add(Surface_defect::crossing_parts, parts.united, 0,
                counted(parts.united, "part crosses another one and was", "parts cross others and were") +
                    " united with it, one with a point at " + coordinates(parts.crossing) + ".",
                parts.crossing);
    remove_needles();
    Touching_loop_splitter(mesh_).split();
    tube_ends_.clear();
    append_shapes(border_cycles(mesh_), tube_ends_);
  }

  void remove_needles() {
    Needle_remover remover(mesh_);
    const std::vector<Face> needles = remover.find();
    if (needles.empty())
      return;
    const Point_3 place = mesh_.point(mesh_.target(mesh_.halfedge(needles.front())));
    const std::size_t left = remover.remove(needles);
    if (left < needles.size())
      report_.add(Surface_defect::needle_triangles, needles.size() - left, 0,
                  counted(needles.size() - left, "triangle", "triangles") + " of almost no area, the first at " +
                      coordinates(place) + ", " + (needles.size() - left == 1 ? "was" : "were") + " removed.",
                  place);
  }

  // Those that can neither be collapsed nor flipped away go with the faces around them.
  void replace_needles() {
    const Needle_remover remover(mesh_);
    const std::vector<Face> needles = remover.find();
    if (needles.empty())
      return;
    note_flat_ends();
    const Point_3 place = mesh_.point(mesh_.target(mesh_.halfedge(needles.front())));
    const Surface before = mesh_;
    if (!Crossing_repairer(mesh_).replace_all([&] { return remover.find(); }) || !keeps_ends()) {
      mesh_ = before;
      return;
    }
    report_.add(Surface_defect::needle_triangles, needles.size(), 0,
                counted(needles.size(), "triangle", "triangles") + " of almost no area, the first at " +
                    coordinates(place) + ", " + (needles.size() == 1 ? "was" : "were") +
                    " replaced with the faces around.",
                place);
  }

  // Tells the openings from the holes, and closes these.
  void close_holes() {
    Border_loops loops = sort_border_loops(mesh_, options_.filled_holes, options_.kept_openings);
    tube_ends_.clear();
    append_shapes(loops.openings, tube_ends_);
    append_shapes(loops.possible_openings, tube_ends_);
    fill(loops.pinholes, Surface_defect::pinholes, "pinhole");
    fill(loops.chosen_holes, Surface_defect::filled_holes, "chosen hole");
    for (const Opening_site& loop : loops.possible_openings)
      report_.add(
          Surface_defect::possible_openings, 1, loop.shape.radius,
          "The border loop at " + coordinates(loop.shape.center) + ", of radius " + short_number(loop.shape.radius) +
              ", lies in the wall: it may be an opening or a hole, and is taken for an opening. Have it filled, "
              "by its place, if it is a hole.",
          loop.shape.center);
  }

  void fill(const std::vector<Opening_site>& holes, Surface_defect defect, const std::string& name) {
    if (holes.empty())
      return;
    const Opening_site* largest = &holes.front();
    for (const auto& hole : holes) {
      if (!fill_wall(mesh_, hole.rim.front(), true))
        throw Input_error("The hole of the wall at " + coordinates(hole.shape.center) +
                          " cannot be filled: remove the triangles around it.");
      largest = hole.shape.radius > largest->shape.radius ? &hole : largest;
    }
    report_.add(defect, holes.size(), largest->shape.radius,
                counted(holes.size(), name, name + "s") + " of the wall, the largest of radius " +
                    short_number(largest->shape.radius) + " at " + coordinates(largest->shape.center) + ", " +
                    (holes.size() == 1 ? "was" : "were") + " filled.",
                largest->shape.center);
  }

  // Spikes first: most triangles that cross are theirs, and without them the wall that they pierce stays as it is.
  // False if something is left; then the mesh is as it was, but for the spikes.
  bool repair_crossings() {
    Spike_mover mover(mesh_);
    const bool has_spikes = mover.has_spikes();
    const Bad_faces bad = find_bad_faces(mesh_);
    if (has_spikes)
      report_spikes(mover.put_back());
    const Bad_faces left = has_spikes ? find_bad_faces(mesh_) : bad;
    bool repaired = left.empty();
    if (!repaired) {
      note_flat_ends();
      const Surface before = mesh_;
      repaired = Crossing_repairer(mesh_).repair(left) && keeps_ends();
      if (!repaired)
        mesh_ = before;
    }
    report_crossings(bad, repaired);
    return repaired;
  }

  void report_spikes(const Moved_spikes& moved) {
    report_.add(Surface_defect::spikes, moved.count, moved.farthest,
                counted(moved.count, "vertex was", "vertices were") + " far out of the wall around, and " +
                    (moved.count == 1 ? "was" : "were") + " put back into it, by up to " +
                    short_number(moved.farthest) + ", the farthest at " + coordinates(moved.place) + ".",
                moved.place);
  }

  void report_crossings(const Bad_faces& bad, bool repaired) {
    const std::string end = repaired ? "; they were smoothed or replaced." : "; they could not be repaired locally.";
    if (bad.crossings > 0) {
      const std::string what = counted(bad.crossings, "pair of triangles crosses", "pairs of triangles cross") +
                               " each other, the first at " + coordinates(bad.crossing);
      report_.add(Surface_defect::self_intersections, bad.crossings, 0, what + end, bad.crossing);
      reason_ = what;
    }
    if (bad.folds > 0) {
      const std::string what = "At " + counted(bad.folds, "edge", "edges") +
                               " the surface turns back on itself, the first at " + coordinates(bad.fold);
      report_.add(Surface_defect::folds, bad.folds, 0, what + end, bad.fold);
      reason_ = reason_.empty() ? what : reason_;
    }
    if (!repaired && reason_.empty())
      reason_ = "Where vertices were put back into the wall, triangles cross each other";
  }

  // A clean surface does not pay for them.
  void note_flat_ends() {
    if (!knows_flat_ends_)
      append_shapes(flat_ends(mesh_), tube_ends_);
    knows_flat_ends_ = true;
  }

  // Whether the ends are where they were, and nothing else is open.
  bool keeps_ends() const {
    std::vector<Rim_shape> ends;
    append_shapes(border_cycles(mesh_), ends);
    append_shapes(flat_ends(mesh_), ends);
    return ends.size() == tube_ends_.size() && first_not_among(tube_ends_, ends) == nullptr &&
           first_not_among(ends, tube_ends_) == nullptr;
  }

  // Whether no loops of the border touch, and no needle is left.
  bool is_sound() {
    std::unordered_set<Vertex> seen;
    for (const auto& loop : border_cycles(mesh_))
      for (Halfedge h : loop.rim)
        if (!seen.insert(mesh_.target(h)).second) {
          reason_ = "The border touches itself at " + coordinates(mesh_.point(mesh_.target(h)));
          return false;
        }
    const std::vector<Face> needles = Needle_remover(mesh_).find();
    if (needles.empty())
      return true;
    reason_ = "Triangles of almost no area at " +
              coordinates(mesh_.point(mesh_.target(mesh_.halfedge(needles.front())))) + " cannot be removed";
    return false;
  }

  long number_of_handles() const {
    const long characteristic = long(mesh_.number_of_vertices()) - long(mesh_.number_of_edges()) +
                                long(mesh_.number_of_faces()) + long(border_cycles(mesh_).size());
    return (2 * number_of_pieces() - characteristic) / 2;
  }

  long number_of_pieces() const { return options_.number_of_parts == 1 ? 1 : long(number_of_components(mesh_)); }

  void report_handles() {
    const long handles = number_of_handles();
    if (handles > 0)
      report_.add(Surface_defect::handles, std::size_t(handles), 0,
                  "The lumen has " + counted(std::size_t(handles), "loop", "loops") +
                      ": vessels split and rejoin there, or touch and are fused.");
  }

  // --- wrapping ---

  void wrap() {
    note_flat_ends();
    const std::vector<Rim_shape> ends = tube_ends_;
    const long handles = number_of_handles();
    std::vector<Point_3> points(mesh_.points().begin(), mesh_.points().end());
    std::vector<Index_triangle> triangles = triangles_and_fans(points);
    Surface_wrapper wrapper(std::move(points), std::move(triangles), ends,
                            reason_.empty() ? "The surface is to be wrapped" : reason_);
    wrapper.wrap(mesh_, smallest_radius());
    drop_islands(mesh_, options_.number_of_parts);
    const std::string what =
        reason_.empty() ? "As asked for, the surface was " : reason_ + "; the surface was therefore ";
    report_.add(Surface_defect::wrapped, 1, wrapper.alpha(),
                what + "replaced by a wrap around it at a size of " + short_number(wrapper.alpha()) +
                    ", cut open at its ends.");
    refuse_wrap(ends, handles);
  }

  void refuse_wrap(const std::vector<Rim_shape>& ends, long handles) const {
    const std::string what = reason_.empty() ? "The surface cannot be wrapped" : reason_ + ", and wrapping it fails";
    std::vector<Rim_shape> found;
    append_shapes(border_cycles(mesh_), found);
    for (const auto& lost : {first_not_among(ends, found), first_not_among(found, ends)})
      if (lost != nullptr)
        throw Input_error(what + " at the opening at " + coordinates(lost->center) +
                          ": cut the surface straight there, or clean it in another program.");
    if (found.size() != ends.size() || !crossing_pairs(mesh_).empty())
      throw Input_error(what + ": clean it in another program.");
    if (number_of_handles() != handles)
      throw Input_error(what + ", as vessels that are close to each other grow together: clean it in another program.");
  }

  // Of the ends; without one, twice the volume over the area, as of a tube.
  double smallest_radius() const {
    double smallest = (std::numeric_limits<double>::infinity)();
    for (const auto& end : tube_ends_)
      smallest = (std::min)(smallest, end.radius);
    if (!tube_ends_.empty())
      return smallest;
    double volume = 0, area = 0;
    const Point_3& o = mesh_.point(*mesh_.vertices().begin());
    for (Face f : mesh_.faces()) {
      const Vector_3 n = area_vector(mesh_.halfedge(f), mesh_);
      volume += (mesh_.point(mesh_.target(mesh_.halfedge(f))) - o) * n / 3;
      area += std::sqrt(n.squared_length());
    }
    return 2 * std::abs(volume) / area;
  }

  // Appends the centres of the fans to the points.
  std::vector<Index_triangle> triangles_and_fans(std::vector<Point_3>& points) const {
    std::vector<Index_triangle> triangles = triangles_of(mesh_);
    for (const auto& loop : border_cycles(mesh_)) {
      const std::size_t center = points.size();
      points.push_back(loop.shape.center);
      for (Halfedge h : loop.rim)
        triangles.push_back({std::size_t(mesh_.source(h)), std::size_t(mesh_.target(h)), center});
    }
    return triangles;
  }

  Surface& mesh_;
  Repair_report& report_;
  const Repair_surface_options& options_;
  std::vector<Rim_shape> tube_ends_; ///< as they were before what was wrong between them was repaired
  bool knows_flat_ends_ = false;
  std::string reason_; ///< why the surface is wrapped
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_SURFACE_REPAIRER_H
