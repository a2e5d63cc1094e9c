// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_DROP_ISLANDS_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_DROP_ISLANDS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Repair/internal/Component_shape.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

struct Dropped_islands {
  std::size_t count = 0, triangles = 0;
  double share = 0, extent = 0; ///< of the whole area; the diagonal of the largest one's box
  Point_3 place;                ///< on the largest one
};

/* Keeps the component of the largest area, and as many others as are wanted that are vessels by themselves. Throws
 * Input_error where one that would go has a rim that faces a rim of what stays within a radius: that is a vessel with a
 * gap, no island. O(n). */
class Island_dropper {
  typedef Surface::Halfedge_index Halfedge;
  typedef Surface::Face_index Face;

public:
  /* `number_of_parts`: 0 for all. */
  Island_dropper(Surface& mesh, std::size_t number_of_parts)
      : mesh_(mesh)
      , number_of_parts_(number_of_parts)
      , component_(mesh.num_faces(), none) {}

  Dropped_islands drop() {
    Dropped_islands dropped;
    double total = 0;
    for (Face f : mesh_.faces())
      if (component_[std::size_t(f)] == none)
        total += flood(f);
    if (area_.size() < 2)
      return dropped;
    const std::vector<bool> kept = choose_kept();
    refuse_gaps(kept);
    std::size_t largest = none;
    for (std::size_t c = 0; c < area_.size(); ++c) {
      if (kept[c])
        continue;
      ++dropped.count;
      dropped.share += area_[c] / total;
      if (largest == none || area_[c] > area_[largest])
        largest = c;
    }
    if (dropped.count == 0)
      return dropped;
    CGAL::Bbox_3 box;
    std::vector<Face> faces;
    for (Face f : mesh_.faces())
      if (!kept[component_[std::size_t(f)]]) {
        faces.push_back(f);
        if (component_[std::size_t(f)] == largest) {
          dropped.place = mesh_.point(mesh_.target(mesh_.halfedge(f)));
          box += dropped.place.bbox();
        }
      }
    dropped.extent =
        std::sqrt(square(box.xmax() - box.xmin()) + square(box.ymax() - box.ymin()) + square(box.zmax() - box.zmin()));
    dropped.triangles = faces.size();
    for (Face f : faces)
      CGAL::Euler::remove_face(mesh_.halfedge(f), mesh_);
    mesh_.collect_garbage();
    return dropped;
  }

private:
  static constexpr std::size_t none = std::size_t(-1);

  static double square(double x) { return x * x; }

  // Numbers the faces that are connected to f, and returns their area.
  double flood(Face f) {
    const std::size_t number = area_.size();
    double area = 0;
    std::vector<Face> stack = {f};
    component_[std::size_t(f)] = number;
    while (!stack.empty()) {
      const Halfedge first = mesh_.halfedge(stack.back());
      stack.pop_back();
      area += std::sqrt(area_vector(first, mesh_).squared_length());
      for (Halfedge h : CGAL::halfedges_around_face(first, mesh_)) {
        const Face g = mesh_.face(mesh_.opposite(h));
        if (g != Surface::null_face() && component_[std::size_t(g)] == none) {
          component_[std::size_t(g)] = number;
          stack.push_back(g);
        }
      }
    }
    area_.push_back(area);
    return area;
  }

  // The largest first, then by decreasing area.
  std::vector<bool> choose_kept() const {
    std::vector<std::size_t> order(area_.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return area_[a] > area_[b]; });
    std::vector<bool> kept(area_.size(), false);
    kept[order.front()] = true;
    if (number_of_parts_ == 1)
      return kept;
    const std::vector<Component_shape> shapes = measure_components(mesh_, component_, area_.size());
    std::size_t number = 1;
    for (std::size_t i = 1; i < order.size() && (number_of_parts_ == 0 || number < number_of_parts_); ++i)
      if (shapes[order[i]].is_vessel(area_[order.front()])) {
        kept[order[i]] = true;
        ++number;
      }
    return kept;
  }

  void refuse_gaps(const std::vector<bool>& kept) const {
    const auto loops = border_cycles(mesh_);
    const auto component_of = [&](const Opening_site& loop) {
      return component_[std::size_t(mesh_.face(mesh_.opposite(loop.rim.front())))];
    };
    std::vector<std::size_t> number_of_loops(area_.size(), 0);
    for (const auto& a : loops)
      ++number_of_loops[component_of(a)];
    const double largest = *std::max_element(area_.begin(), area_.end());
    for (const auto& a : loops) {
      const std::size_t c = component_of(a);
      if (kept[c] || (number_of_loops[c] < 2 && area_[c] < 0.01 * largest))
        continue; // it is no piece of a tube, and small
      for (const auto& b : loops)
        if (kept[component_of(b)])
          refuse_gap(a, b);
    }
    if (number_of_parts_ == 1)
      return;
    for (std::size_t i = 0; i < loops.size(); ++i) // between two that are kept
      for (std::size_t k = 0; k < i; ++k)
        if (component_of(loops[i]) != component_of(loops[k]) && kept[component_of(loops[i])] &&
            kept[component_of(loops[k])])
          refuse_gap(loops[i], loops[k]);
  }

  static void refuse_gap(const Opening_site& a, const Opening_site& b) {
    if (b.shape.radius > 0.5 * a.shape.radius && a.shape.radius > 0.5 * b.shape.radius &&
        point_distance(a.shape.center, b.shape.center) < a.shape.radius &&
        a.shape.plane.normal() * b.shape.plane.normal() < 0)
      throw Input_error("The surface is in two parts, with a gap of " +
                        std::to_string(point_distance(a.shape.center, b.shape.center)) + " at " +
                        coordinates(a.shape.center) +
                        ", too wide to be sewn up: join the parts, or remove one of them.");
  }

  Surface& mesh_;
  const std::size_t number_of_parts_;
  std::vector<std::size_t> component_;
  std::vector<double> area_;
};

inline Dropped_islands drop_islands(Surface& mesh, std::size_t number_of_parts = 1) {
  return Island_dropper(mesh, number_of_parts).drop();
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_DROP_ISLANDS_H
