// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "parts.h"

#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Pipelines/join_parts.h>
#include <CGAL/Tubular_meshing/Repair/split_into_parts.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace tubular = CGAL::Tubular_meshing;

namespace {

/* Which of the parts a point is nearest to. */
class Nearest_part {
public:
  explicit Nearest_part(const std::vector<Part>& parts) {
    for (const Part& part : parts)
      distances_.emplace_back(new tubular::Wall_distance(part.surface));
  }

  std::size_t operator()(const tubular::Point_3& p) const {
    const auto nearest = std::min_element(distances_.begin(), distances_.end(),
                                          [&](const auto& a, const auto& b) { return (*a)(p) < (*b)(p); });
    return std::size_t(nearest - distances_.begin());
  }

private:
  std::vector<std::unique_ptr<tubular::Wall_distance>> distances_;
};

void distribute_points(const Named_points& points, const Nearest_part& part_of, std::vector<Part>& parts) {
  if (points.inlet)
    parts[part_of(*points.inlet)].run.points.inlet = points.inlet;
  for (const auto& p : points.ends)
    parts[part_of(p)].run.points.ends.push_back(p);
  for (const auto& p : points.blind_ends)
    parts[part_of(p)].run.points.blind_ends.push_back(p);
}

void distribute_balls(const tubular::Size_requests& sizes, const Nearest_part& part_of, std::vector<Part>& parts) {
  for (Part& part : parts)
    part.run.sizes.balls.clear();
  for (const auto& ball : sizes.balls)
    parts[part_of(ball.center)].run.sizes.balls.push_back(ball);
}

// The names of ends go with their ends, what became of the labels with all parts.
void distribute_labels(const tubular::Labelled_ends& labels, const Nearest_part& part_of, std::vector<Part>& parts) {
  for (Part& part : parts) {
    part.run.labels = labels;
    part.run.labels.ends.clear();
    part.run.labels.inlet = tubular::Labelled_ends::none;
  }
  for (std::size_t e = 0; e < labels.ends.size(); ++e) {
    tubular::Labelled_ends& mine = parts[part_of(labels.ends[e].center)].run.labels;
    if (e == labels.inlet)
      mine.inlet = mine.ends.size();
    mine.ends.push_back(labels.ends[e]);
  }
}

// Each line goes with the part that its middle is nearest to.
void distribute_lines(const tubular::Centerline_polylines& lines, const Nearest_part& part_of,
                      std::vector<Part>& parts) {
  for (const auto& line : lines.lines) {
    auto& mine = parts[part_of(lines.points[line[line.size() / 2]])].run.lines;
    mine.lines.emplace_back();
    for (std::size_t i : line) {
      mine.lines.back().push_back(mine.points.size());
      mine.points.push_back(lines.points[i]);
      if (!lines.radius.empty())
        mine.radius.push_back(lines.radius[i]);
    }
  }
  for (std::size_t k = 0; k < parts.size(); ++k)
    if (!lines.lines.empty() && parts[k].run.lines.lines.empty())
      parts[k].run.notes.push_back("None of the given centerlines lies in part " + std::to_string(k + 1) +
                                   "; those of this part were computed.");
}

void add(tubular::Layer_report& all, const tubular::Layer_report& part) {
  if (part.vertices == 0)
    return;
  const double before = double(all.vertices), more = double(part.vertices);
  all.mean_ratio = (all.mean_ratio * before + part.mean_ratio * more) / (before + more);
  if (before == 0 || part.min_ratio < all.min_ratio)
    all.worst_place = part.worst_place;
  all.min_ratio = (std::min)(all.min_ratio, part.min_ratio);
  all.vertices += part.vertices;
  all.reduced_vertices += part.reduced_vertices;
  all.steep_vertices += part.steep_vertices;
  all.prisms += part.prisms;
  all.hexahedra += part.hexahedra;
  all.tetrahedra += part.tetrahedra;
  all.relabelled_facets += part.relabelled_facets;
  all.rounds = (std::max)(all.rounds, part.rounds);
}

void add(tubular::Preserve_volume_report& all, const tubular::Preserve_volume_report& part) {
  all.input_volume += part.input_volume;
  all.volume_before += part.volume_before;
  all.volume += part.volume;
  all.largest_shift = (std::max)(all.largest_shift, part.largest_shift);
  all.held_back += part.held_back;
}

// Means are of cells, whose number is not known here: of vessels, they are the least.
void add(tubular::Optimize_hexahedra_report& all, const tubular::Optimize_hexahedra_report& part) {
  for (double tubular::Optimize_hexahedra_report::*least :
       {&tubular::Optimize_hexahedra_report::min_scaled_jacobian_before,
        &tubular::Optimize_hexahedra_report::min_scaled_jacobian,
        &tubular::Optimize_hexahedra_report::mean_scaled_jacobian_before,
        &tubular::Optimize_hexahedra_report::mean_scaled_jacobian})
    all.*least = (std::min)(all.*least, part.*least);
  all.inverted_before += part.inverted_before;
  all.inverted += part.inverted;
  all.held_vertices += part.held_vertices;
}

void add(tubular::Hexahedral_report& all, const tubular::Hexahedral_report& part) {
  if (part.method == tubular::Hexahedral_method::subdivision)
    all.method = part.method; // of all that are joined, not only blocks
  all.places_without_blocks.insert(all.places_without_blocks.end(), part.places_without_blocks.begin(),
                                   part.places_without_blocks.end());
  all.points_per_circumference = (std::max)(all.points_per_circumference, part.points_per_circumference);
  all.number_of_junctions += part.number_of_junctions;
  all.number_of_blocks += part.number_of_blocks;
  all.irregular_edges += part.irregular_edges;
  all.twist.insert(all.twist.end(), part.twist.begin(), part.twist.end());
  all.boundary.largest_shift = (std::max)(all.boundary.largest_shift, part.boundary.largest_shift);
  all.boundary.not_found += part.boundary.not_found;
  all.boundary.held_back += part.boundary.held_back;
  add(all.optimization, part.optimization);
}

tubular::Tubular_model copy_of(const tubular::Tubular_model& model) {
  tubular::Tubular_model copy;
  static_cast<tubular::Labelled_surface&>(copy) = tubular::Labelled_surface(model.surface);
  copy.centerlines = model.centerlines;
  copy.openings = model.openings;
  copy.round_ends = model.round_ends;
  copy.patch_names = model.patch_names;
  copy.patch_ids = model.patch_ids;
  copy.labels = model.labels;
  return copy;
}

template <class T> void append(std::vector<T>& all, const std::vector<T>& part) {
  all.insert(all.end(), part.begin(), part.end());
}

} // namespace

std::vector<Part> copy_of(const std::vector<Part>& parts, const Options& options, const tubular::Size_requests& sizes) {
  std::vector<Part> copies(parts.size());
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Run& from = parts[k].run;
    Run& to = copies[k].run;
    to.options = options;
    to.notes = from.notes;
    to.round_ends = from.round_ends;
    to.labels = from.labels;
    to.sizes = sizes;
    to.extensions = from.extensions;
    to.model = copy_of(from.model);
  }
  if (parts.size() > 1 && !sizes.balls.empty())
    distribute_balls(sizes, Nearest_part(parts), copies);
  return copies;
}

std::vector<Part> split(const Run& run, const tubular::Surface& surface) {
  std::vector<Part> parts;
  std::vector<tubular::Surface> surfaces;
  if (run.options.repair == "off") // what is no vessel has not been dropped
    surfaces.push_back(surface);
  else
    surfaces = tubular::split_into_parts(surface);
  for (tubular::Surface& s : surfaces) {
    parts.emplace_back();
    parts.back().surface = std::move(s);
    parts.back().run.options = run.options;
    parts.back().run.sizes = run.sizes;
  }
  if (parts.size() == 1) {
    parts.front().run.points = run.points;
    parts.front().run.lines = run.lines;
    parts.front().run.labels = run.labels;
    return parts;
  }
  const Nearest_part part_of(parts);
  distribute_points(run.points, part_of, parts);
  distribute_lines(run.lines, part_of, parts);
  distribute_balls(run.sizes, part_of, parts);
  if (!run.labels.empty())
    distribute_labels(run.labels, part_of, parts);
  return parts;
}

void distribute_branches(const Run& run, std::vector<Part>& parts) {
  std::size_t before = 0;
  for (Part& part : parts) {
    const std::size_t number = part.run.model.centerlines.branches().size();
    part.run.sizes.branches.clear();
    for (auto request : run.sizes.branches)
      if (request.branch >= before && request.branch - before < number) {
        request.branch -= before;
        part.run.sizes.branches.push_back(request);
      }
    before += number;
  }
  for (const auto& request : run.sizes.branches)
    if (request.branch >= before)
      throw tubular::Parameter_error("There is no branch " + std::to_string(request.branch) + " to refine: there are " +
                                     std::to_string(before) + ", counted from 0.");
}

void join(Run& run, std::vector<Part> parts) {
  std::vector<tubular::Tubular_model> models;
  std::vector<tubular::Remeshed_surface> surfaces;
  std::vector<tubular::Mixed_mesh> meshes, blocks;
  std::size_t branches = 0;
  run.options.points_per_circumference = parts.front().run.options.points_per_circumference;
  run.meshing = parts.front().run.meshing;
  run.wall = parts.front().run.wall;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    Run& part = parts[k].run;
    run.openings_of_parts.push_back(part.model.openings.size());
    append(run.notes, part.notes);
    append(run.round_ends, part.round_ends);
    append(run.extensions.openings, part.extensions.openings);
    append(run.extensions.lengths, part.extensions.lengths);
    if (k > 0) {
      append(run.meshing.fallbacks, part.meshing.fallbacks);
      add(run.meshing.boundary_layer, part.meshing.boundary_layer);
      add(run.meshing.wall, part.meshing.wall);
      add(run.meshing.volume, part.meshing.volume);
      add(run.meshing.hexahedral, part.meshing.hexahedral);
      add(run.wall, part.wall);
    }
    models.push_back(std::move(part.model));
    if (part.surface.surface.number_of_faces() > 0)
      surfaces.push_back(std::move(part.surface));
    if (!run.options.blocks_output.empty()) {
      blocks.push_back(tubular::make_block_mesh(part.blocks, part.mesh.points, branches));
      blocks.back().patch_names = part.mesh.patch_names;
      if (!blocks.back().region_names.empty())
        branches = std::size_t(blocks.back().region_names.rbegin()->first);
    }
    meshes.push_back(std::move(part.mesh));
  }
  if (surfaces.size() == parts.size()) // else some were not meshed by patches, and none is kept
    run.surface = tubular::join_parts(std::move(surfaces), run.openings_of_parts);
  run.mesh = tubular::join_parts(std::move(meshes), run.openings_of_parts);
  if (!run.options.blocks_output.empty())
    run.block_mesh = tubular::join_parts(std::move(blocks), run.openings_of_parts);
  run.model = tubular::join_parts(std::move(models));
}

void check_number_of_openings(const Run& run, const std::vector<Part>& parts) {
  std::size_t number = 0;
  std::ostringstream list;
  for (const Part& part : parts)
    for (const tubular::Opening& o : part.run.model.openings)
      list << (number++ == 0 ? "" : "; ") << "(" << o.center.x() << ", " << o.center.y() << ", " << o.center.z()
           << "), of radius " << o.radius;
  if (run.options.openings == 0 || number == std::size_t(run.options.openings))
    return;
  throw tubular::Input_error("The surface has " + std::to_string(number) +
                             (number == 1 ? " opening, not " : " openings, not ") +
                             std::to_string(run.options.openings) + ": at " + list.str() + ".");
}
