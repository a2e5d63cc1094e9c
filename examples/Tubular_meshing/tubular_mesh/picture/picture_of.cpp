// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "picture_of.h"

#include "../../command_line/Points.h"
#include "draw_mesh.h"
#include "write_png.h"

#include <array>
#include <optional>

namespace {

typedef Shown_mesh::Vector Vector;

Vector direction_of(const std::string& text) {
  CGAL::Tubular_meshing::Point_3 direction;
  if (!command_line::parse_axis(text, direction))
    direction = command_line::point_of(text);
  return Vector(direction);
}

std::optional<Clip_plane> plane_of(const std::string& text, const Shown_mesh& mesh) {
  if (text.empty())
    return std::nullopt;
  CGAL::Tubular_meshing::Point_3 axis;
  if (command_line::parse_axis(text, axis))
    return Clip_plane{center_of_extent(mesh), Vector(axis)};
  const auto x = command_line::numbers_of<6>(text);
  return Clip_plane{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}};
}

} // namespace

std::string picture_of(const Shown_mesh& mesh, const Options& o) {
  const std::optional<Clip_plane> plane = plane_of(o.clip, mesh);
  const Vector from = !o.picture_view.empty() ? direction_of(o.picture_view)
                      : plane                 ? plane->normal
                                              : Camera::best_direction(mesh);
  std::array<int, 2> size = {1600, 1200};
  command_line::parse_picture_size(o.picture_size, size);
  const Coloring coloring(mesh, Coloring::named(o.picture_color));
  const Seen_faces seen = plane ? seen_faces(mesh, *plane) : seen_faces(mesh);
  const Camera camera(points_of(mesh, seen), from, size[0], size[1]);
  return png_of(draw_mesh(mesh, seen, coloring, camera, size[0], size[1], true));
}
