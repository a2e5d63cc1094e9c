// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "draw_mesh.h"

#include <cmath>

using CGAL::Tubular_meshing::internal::cross;
using CGAL::Tubular_meshing::internal::dot;
using CGAL::Tubular_meshing::internal::normalized;
using CGAL::Tubular_meshing::internal::cells::number_of_corners;

namespace {

class Painter {
public:
  Painter(const Shown_mesh& mesh, const Camera& camera, int width, int height, bool has_edges)
      : mesh_(mesh)
      , has_edges_(has_edges)
      , raster_(width, height, {255, 255, 255})
      , light_(normalized(camera.from() + 0.35 * camera.up())) {
    at_.reserve(mesh.mesh().points.size());
    for (const auto& p : mesh.mesh().points)
      at_.push_back(camera.project(Shown_mesh::Vector(p)));
  }

  // A quad as two triangles, without the side between them.
  void draw(const Shown_mesh::Face& f, Color color, double lift) {
    if (number_of_corners(f) == 3)
      return draw({f[0], f[1], f[2]}, color, 7, lift);
    draw({f[0], f[1], f[2]}, color, 5, lift); // not the side opposite to the second corner
    draw({f[0], f[2], f[3]}, color, 3, lift);
  }

  Image image() const { return raster_.image(); }

private:
  void draw(const std::array<std::uint32_t, 3>& t, Color color, int sides, double lift) {
    const auto a = mesh_.point(t[0]), b = mesh_.point(t[1]), c = mesh_.point(t[2]);
    const double light = std::abs(dot(normalized(cross(b - a, c - a)), light_)); // from either side
    raster_.draw({at_[t[0]], at_[t[1]], at_[t[2]]}, color, 0.4 + 0.6 * light, has_edges_ ? sides : 0, lift);
  }

  const Shown_mesh& mesh_;
  bool has_edges_;
  Raster raster_;
  Shown_mesh::Vector light_;
  std::vector<Shown_mesh::Vector> at_; // the points, in the picture
};

} // namespace

Image draw_mesh(const Shown_mesh& mesh, const Seen_faces& seen, const Coloring& coloring, const Camera& camera,
                int width, int height, bool has_edges) {
  Painter painter(mesh, camera, width, height, has_edges);
  for (const auto& cut : seen.cut)
    painter.draw(cut.face, coloring.of_cut_face(cut.cell, cut.face), 0);
  for (std::size_t f : seen.facets)
    painter.draw(mesh.facet(f), coloring.of_facet(f), 0.01); // in front of the faces of cells that are the same
  return painter.image();
}
