// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_COMPONENT_SHAPE_H
#define CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_COMPONENT_SHAPE_H

#include <CGAL/Tubular_meshing/Repair/internal/tube_ends.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* What tells a vessel among the components of a surface from debris. */
struct Component_shape {
  double area = 0, volume = 0; ///< the volume is signed, border loops closed by fans
  std::vector<double> ends;    ///< the radii of its loops and flat ends

  /* Of a tube: twice the volume over the area. */
  double radius() const { return area > 0 ? 2 * std::abs(volume) / area : 0; }

  /* A vessel has two openings or more, of the size of its own radius, and a thousandth of the area of the largest; or
   * it is closed or has one opening, is much longer than wide, and has a hundredth of this area. */
  bool is_vessel(double largest_area) const {
    std::size_t openings = 0;
    for (double r : ends)
      openings += r > 0.3 * radius();
    // of a tube of length l: l / r; of a ball: 4.5
    const double slenderness = area / (2 * CGAL_PI * radius() * radius());
    if (openings >= 2)
      return area > 1e-3 * largest_area && slenderness > 1;
    return area > 1e-2 * largest_area && slenderness > 7;
  }
};

/* Of each component, but for its flat ends. O(n). */
inline std::vector<Component_shape>
measure_open_components(const Surface& mesh, const std::vector<std::size_t>& component, std::size_t number) {
  std::vector<Component_shape> shapes(number);
  std::vector<Point_3> origin(number);
  std::vector<bool> has_origin(number, false);
  const auto add = [&](std::size_t c, const Point_3& a, const Point_3& b, const Point_3& p) {
    if (!has_origin[c])
      origin[c] = a;
    has_origin[c] = true;
    shapes[c].volume += (a - origin[c]) * CGAL::cross_product(b - origin[c], p - origin[c]) / 6;
  };
  for (auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    const std::size_t c = component[std::size_t(f)];
    shapes[c].area += std::sqrt(area_vector(h, mesh).squared_length());
    add(c, mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h))));
  }
  for (const Opening_site& loop : border_cycles(mesh)) {
    const std::size_t c = component[std::size_t(mesh.face(mesh.opposite(loop.rim.front())))];
    shapes[c].ends.push_back(loop.shape.radius);
    for (auto h : loop.rim)
      add(c, mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), loop.shape.center);
  }
  return shapes;
}

/* Of each component. O(n). */
inline std::vector<Component_shape> measure_components(const Surface& mesh, const std::vector<std::size_t>& component,
                                                       std::size_t number) {
  std::vector<Component_shape> shapes = measure_open_components(mesh, component, number);
  for (const bool inside_out : {false, true})
    for (const Opening_site& end : Flat_end_finder(mesh, inside_out).find(certain_flat_end())) {
      const std::size_t c = component[std::size_t(end.cap.front())];
      if ((shapes[c].volume < 0) == inside_out)
        shapes[c].ends.push_back(end.shape.radius);
    }
  return shapes;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_INTERNAL_COMPONENT_SHAPE_H
