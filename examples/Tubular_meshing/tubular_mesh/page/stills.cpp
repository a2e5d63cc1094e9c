// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stills.h"

#include "../picture/draw_mesh.h"
#include "../picture/write_png.h"
#include "../view/Camera.h"
#include "../view/Clip_plane.h"
#include "../view/Coloring.h"
#include "../view/deflate.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

using html::number;

namespace {

const int width = 720, height = 540;

std::string svg(const std::string& title, const Image& image, const std::string& over_it) {
  return "<svg class=\"still\" role=\"img\" viewBox=\"0 0 " + std::to_string(width) + " " + std::to_string(height) +
         "\"><title>" + html::escaped_for_xml(title) + "</title><image width=\"" + std::to_string(width) +
         "\" height=\"" + std::to_string(height) + "\" href=\"data:image/png;base64," + base64(png_of(image)) + "\"/>" +
         over_it + "</svg>\n";
}

// Of the largest openings, those whose names have room.
std::string names_of_openings(const html::Json& report, const Camera& camera) {
  std::vector<Shown_mesh::Vector> taken;
  std::string text;
  for (const auto& o : report["openings"]) {
    const auto& c = o["center"];
    const auto at = camera.project({c[0].get<double>(), c[1].get<double>(), c[2].get<double>()});
    const bool has_room = std::none_of(taken.begin(), taken.end(), [&](const auto& p) {
      return std::abs(p.x - at.x) < 90 && std::abs(p.y - at.y) < 15;
    });
    if (!has_room || taken.size() == 24)
      continue;
    taken.push_back(at);
    text += "<text x=\"" + number(std::clamp(at.x, 45., width - 45.), 5) + "\" y=\"" +
            number(std::clamp(at.y, 14., height - 4.), 5) + "\">" +
            html::escaped_for_xml(o["name"].get<std::string>()) + "</text>";
  }
  return "<g class=\"names\">" + text + "</g>";
}

// As lines, with circles of their radius where they are apart by more than it.
std::string lines_of(const Shown_mesh& mesh, const Camera& camera) {
  const auto& graph = mesh.centerlines();
  std::string lines, circles;
  for (const auto& branch : graph.branches()) {
    double next = 0;
    for (std::size_t i = 0; i < branch.points.size(); ++i) {
      const double radius = graph.radii()[branch.points[i]];
      const auto at = camera.project(Shown_mesh::Vector(graph.points()[branch.points[i]]));
      const bool is_last = i + 1 == branch.points.size();
      if (i > 0 && !is_last && branch.abscissa[i] < next)
        continue;
      lines += (i == 0 ? "M" : "L") + number(at.x, 5) + " " + number(at.y, 5);
      next = branch.abscissa[i] + radius;
      if (i > 0 && !is_last)
        circles += "<circle cx=\"" + number(at.x, 5) + "\" cy=\"" + number(at.y, 5) + "\" r=\"" +
                   number(camera.pixels(radius), 4) + "\"/>";
    }
  }
  return "<g fill=\"none\" stroke=\"#000\"><path stroke-width=\"1.5\" d=\"" + lines +
         "\"/><g stroke-width=\".5\" stroke-opacity=\".5\">" + circles + "</g></g>";
}

} // namespace

std::string still_of_mesh(const html::Json& report, const Shown_mesh& mesh) {
  const Camera camera(points_of(mesh), Camera::best_direction(mesh), width, height);
  const Image image =
      draw_mesh(mesh, seen_faces(mesh), Coloring(mesh, Coloring::By::patch), camera, width, height, false);
  return svg("The mesh, by its patches, with names of openings", image, names_of_openings(report, camera));
}

std::string still_of_cut(const Shown_mesh& mesh) {
  const auto from = Camera::best_direction(mesh);
  const Camera camera(points_of(mesh), from, width, height);
  const Image image = draw_mesh(mesh, seen_faces(mesh, {center_of_extent(mesh), from}),
                                Coloring(mesh, Coloring::By::quality), camera, width, height, false);
  return svg("The mesh cut in the middle, by its quality, and the centerlines with their radii", image,
             lines_of(mesh, camera));
}
