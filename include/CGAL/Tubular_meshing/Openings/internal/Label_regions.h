// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_LABEL_REGIONS_H
#define CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_LABEL_REGIONS_H

#include <CGAL/Tubular_meshing/Openings/internal/label_roles.h>
#include <CGAL/Tubular_meshing/Openings/labelled_ends.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/Rims/disk_rim.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The connected sets of faces of one label each, and which of them are ends of vessels. */
class Label_regions {
  typedef Surface::Halfedge_index Halfedge;
  typedef Surface::Face_index Face;

public:
  struct Region {
    int label = 0;
    double area = 0;
    std::vector<Face> faces;
    std::set<std::size_t> loops; // of the border, that it reaches
    Opening_site site;           // of an end: its rim, and their shape
    bool is_end = false;         // its faces are to go
    bool names_loop = false;     // it names the opening that it reaches
  };

  /* What is known of a label before its regions are looked at. */
  struct Label {
    std::string name;
    Label_role role = Label_role::unknown;
    double area = 0;
    std::vector<std::size_t> regions;
    std::string reason; // why not all of its regions are ends
  };

  Label_regions(const Surface& mesh, Face_patch_map label, const Labelled_ends_options& options)
      : mesh_(mesh)
      , label_(label)
      , region_(mesh.num_faces(), 0)
      , loops_(border_cycles(mesh)) {
    collect();
    for (auto& l : labels_) {
      const auto name = options.label_names.find(l.first);
      if (name != options.label_names.end())
        l.second.name = name->second;
      l.second.role = role_of_name(l.second.name);
    }
    choose_wall(options);
    for (auto& l : labels_)
      if (l.second.role != Label_role::wall)
        find_ends(l.second);
    refuse_neighbours();
  }

  const std::vector<Region>& regions() const { return regions_; }
  const std::map<int, Label>& labels() const { return labels_; }
  const Rim_shape& shape_of_loop(std::size_t i) const { return loops_[i].shape; }

private:
  void collect() {
    std::vector<std::size_t> loop_of(mesh_.num_halfedges(), loops_.size());
    for (std::size_t i = 0; i < loops_.size(); ++i)
      for (Halfedge h : loops_[i].rim)
        loop_of[std::size_t(h)] = i;
    std::vector<bool> visited(mesh_.num_faces(), false);
    for (Face first : mesh_.faces()) {
      if (visited[std::size_t(first)])
        continue;
      visited[std::size_t(first)] = true;
      Region region;
      region.label = label_[first];
      region.faces = {first};
      for (std::size_t i = 0; i < region.faces.size(); ++i) {
        const Face f = region.faces[i];
        region_[std::size_t(f)] = regions_.size();
        region.area += std::sqrt(area_vector(mesh_.halfedge(f), mesh_).squared_length());
        for (Halfedge h : CGAL::halfedges_around_face(mesh_.halfedge(f), mesh_)) {
          const Halfedge o = mesh_.opposite(h);
          if (mesh_.is_border(o))
            region.loops.insert(loop_of[std::size_t(o)]);
          else if (!visited[std::size_t(mesh_.face(o))] && label_[mesh_.face(o)] == region.label) {
            visited[std::size_t(mesh_.face(o))] = true;
            region.faces.push_back(mesh_.face(o));
          }
        }
      }
      labels_[region.label].area += region.area;
      labels_[region.label].regions.push_back(regions_.size());
      regions_.push_back(std::move(region));
    }
  }

  // By number, else by name, else by size; a number is not believed where that label is a disk and not the largest.
  void choose_wall(const Labelled_ends_options& options) {
    auto largest = labels_.end();
    bool named = false;
    for (auto l = labels_.begin(); l != labels_.end(); ++l) {
      named = named || l->second.role == Label_role::wall;
      const bool is_named_end = l->second.role == Label_role::opening || l->second.role == Label_role::inlet;
      if (!is_named_end && (largest == labels_.end() || l->second.area > largest->second.area))
        largest = l;
    }
    if (options.wall_label) {
      const auto given = labels_.find(*options.wall_label);
      if (given != labels_.end() && (given == largest || !is_disk(given->second)))
        largest = given;
    }
    if (largest != labels_.end() && !named)
      largest->second.role = Label_role::wall;
    for (const auto& l : labels_)
      if (l.second.role == Label_role::wall)
        wall_area_ += l.second.area;
  }

  bool is_disk(const Label& label) const {
    return label.regions.size() == 1 && regions_[label.regions[0]].loops.empty() &&
           !rim_of_disk(regions_[label.regions[0]].faces, mesh_).empty();
  }

  void find_ends(Label& label) {
    double largest = 0;
    for (std::size_t r : label.regions)
      largest = (std::max)(largest, regions_[r].area);
    for (std::size_t r : label.regions) {
      const std::string reason = why_no_end(regions_[r], label, largest);
      if (label.reason.empty())
        label.reason = reason;
    }
  }

  // Empty if it is an end, or names an opening.
  std::string why_no_end(Region& region, const Label& label, double largest_of_label) {
    const bool is_called_end = label.role != Label_role::unknown;
    if (region.area < 0.01 * largest_of_label)
      return "has specks of a hundredth of its largest part's area or less";
    if (!region.loops.empty()) {
      if (!is_called_end)
        return "reaches the border, and has no name of an end";
      if (region.loops.size() > 1)
        return "reaches several openings";
      region.names_loop = true;
      return "";
    }
    if (!(region.area < wall_area_))
      return "is as large as the wall";
    region.site.rim = rim_of_disk(region.faces, mesh_);
    if (region.site.rim.empty())
      return "is no disk that is bounded by one loop";
    region.site.shape = measure_rim(rim_points(region.site.rim, mesh_));
    const Rim_shape& shape = region.site.shape;
    if (!(shape.radius > 0))
      return "has a rim that bounds no area";
    const Bulge bulge = measure_bulge(region.faces, shape, mesh_, region.site.rim);
    if (!is_called_end && bulge.is_wide())
      return "is wider than its rim, as a sac is, and has no name of an end";
    if (!is_called_end && bulge.is_long())
      return "reaches far out of its rim, as a blind vessel does, and has no name of an end";
    if (!is_called_end && !wall_stands_upright(region))
      return "lies flush in the wall, and has no name of an end";
    region.is_end = true;
    return "";
  }

  bool wall_stands_upright(const Region& region) const {
    double cosine = 0, total = 0;
    for (Halfedge h : region.site.rim) {
      const Vector_3 n = area_vector(mesh_.opposite(h), mesh_);
      const double length = point_distance(mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h)));
      const double size = std::sqrt(n.squared_length());
      total += length;
      cosine += size > 0 ? length * (n * region.site.shape.plane.normal()) / size : 0;
    }
    return std::abs(cosine) <= max_cosine * total;
  }

  // Two ends that share a rim would leave one hole; they are left to be found by their shape.
  void refuse_neighbours() {
    std::vector<std::size_t> refused;
    for (std::size_t r = 0; r < regions_.size(); ++r)
      if (regions_[r].is_end)
        for (Halfedge h : regions_[r].site.rim) {
          const std::size_t other = region_[std::size_t(mesh_.face(mesh_.opposite(h)))];
          if (regions_[other].is_end) {
            refused.push_back(r);
            labels_[regions_[r].label].reason = "shares its rim with label " + text(regions_[other].label);
            break;
          }
        }
    for (std::size_t r : refused)
      regions_[r].is_end = false;
  }

  std::string text(int label) const {
    Understood_label l;
    l.label = label;
    l.name = labels_.at(label).name;
    return l.text();
  }

  static constexpr double max_cosine = 0.75; // of the wall's mean direction with that of the rim, as of possible ends

  const Surface& mesh_;
  const Face_patch_map label_;
  std::vector<std::size_t> region_; // of each face
  const std::vector<Opening_site> loops_;
  std::vector<Region> regions_;
  std::map<int, Label> labels_;
  double wall_area_ = 0;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_LABEL_REGIONS_H
