// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Closed surfaces whose ends are domes of any height, each with a label.

#ifndef CGAL_TUBULAR_MESHING_LABELLED_SURFACES_H
#define CGAL_TUBULAR_MESHING_LABELLED_SURFACES_H

#include "test_surfaces.h"

#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>

#include <cstddef>
#include <string>
#include <vector>

namespace test_surfaces {

/* A mesh and the label of each face, in the order of the faces. */
struct Labelled_mesh {
  Mesh mesh;
  std::vector<int> label;
  std::vector<Point> centers; ///< of the ends' rims, in the order of their labels
};

/* Closes each opening by a dome of a height in radii (negative: a dish), the one of find_openings()'s opening i with
 * the label first + i; the wall's is `wall`. Half an ellipsoid, which goes over into the wall smoothly; `creased`: a
 * paraboloid, which meets it in a crease. */
inline Labelled_mesh with_domes(const Mesh& open, const std::vector<double>& heights, int wall, int first,
                                int circles = 4, bool creased = false) {
  namespace tubular = CGAL::Tubular_meshing;
  Labelled_mesh result{open, std::vector<int>(open.number_of_faces(), wall), {}};
  Mesh& mesh = result.mesh;
  const std::vector<tubular::Opening> openings = tubular::find_openings(open);
  const auto loops = tubular::internal::border_cycles(open);
  for (std::size_t i = 0; i < openings.size(); ++i) {
    const tubular::Opening& o = openings[i];
    const double height = heights[i % heights.size()] * o.radius;
    result.centers.push_back(o.center);
    std::vector<Mesh::Vertex_index> outer;
    for (const auto& loop : loops)
      if (CGAL::squared_distance(loop.shape.center, o.center) < 1e-6 * o.radius * o.radius)
        for (auto h : loop.rim)
          outer.push_back(mesh.target(h));
    const std::vector<Mesh::Vertex_index> rim = outer;
    const auto add = [&](Mesh::Vertex_index a, Mesh::Vertex_index b, Mesh::Vertex_index c) {
      mesh.add_face(a, b, c);
      result.label.push_back(first + int(i));
    };
    for (int k = circles - 1; k >= 1; --k) {
      const double t = double(k) / circles;
      std::vector<Mesh::Vertex_index> inner;
      for (auto v : rim)
        inner.push_back(mesh.add_vertex(o.center + t * (open.point(v) - o.center) +
                                        height * (creased ? 1 - t * t : std::sqrt(1 - t * t)) * o.normal));
      for (std::size_t j = 0; j < rim.size(); ++j) {
        const std::size_t n = (j + 1) % rim.size();
        add(outer[j], outer[n], inner[n]);
        add(outer[j], inner[n], inner[j]);
      }
      outer = inner;
    }
    const auto apex = mesh.add_vertex(o.center + height * o.normal);
    for (std::size_t j = 0; j < rim.size(); ++j)
      add(outer[j], outer[(j + 1) % rim.size()], apex);
  }
  return result;
}

inline Mesh open_bifurcation(double points = 20) {
  Mesh mesh;
  CGAL::Tubular_meshing::generate_tubular_surface(CGAL::Tubular_meshing::y_bifurcation(), mesh,
                                                  CGAL::Tubular_meshing::parameters::points_per_circumference(points));
  return mesh;
}

inline Mesh::Property_map<Mesh::Face_index, int> labels_of(Labelled_mesh& labelled) {
  auto map = labelled.mesh.add_property_map<Mesh::Face_index, int>("f:label", 0).first;
  auto label = labelled.label.begin();
  for (auto f : labelled.mesh.faces())
    map[f] = *label++;
  return map;
}

/* Ends that are flat, half balls, longer than half balls, and dished. */
inline std::vector<std::vector<double>> dome_heights() {
  return {{0, 0, 0}, {0.4, 0.4, 0.4}, {1, 1, 1}, {2.5, 1.4, 0.2}, {-0.4, 0.8, -0.2}};
}

/* Turned, in metres and in micrometres, and far away. */
inline std::vector<Transformation> placements() {
  const Transformation far(CGAL::TRANSLATION, Vector(300, -200, 900));
  return {Transformation(CGAL::IDENTITY), rotation(1.1), Transformation(CGAL::SCALING, 1e-3) * rotation(-2.3),
          Transformation(CGAL::SCALING, 1e4) * rotation(0.4), far * rotation(2)};
}

} // namespace test_surfaces

#endif // CGAL_TUBULAR_MESHING_LABELLED_SURFACES_H
