// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_REPAIR_REPAIR_SURFACE_IMPL_H
#define CGAL_TUBULAR_MESHING_REPAIR_REPAIR_SURFACE_IMPL_H

#include <CGAL/Tubular_meshing/Repair/internal/Surface_repairer.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>
#include <CGAL/Tubular_meshing/Rims/Opening_site.h>
#include <CGAL/Tubular_meshing/base/Triangle_soup.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

CGAL_TUBULAR_MESHING_INLINE Repair_report repair_soup(const std::vector<Point_3>& points,
                                                      const std::vector<std::array<std::size_t, 3>>& triangles,
                                                      Surface& mesh, const Repair_surface_options& options) {
  Triangle_soup soup;
  soup.points.reserve(points.size());
  for (const Point_3& p : points) {
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      throw Input_error("The surface has coordinates that are no finite numbers at point " +
                        std::to_string(soup.points.size()) + ": remove or correct that point.");
    soup.points.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto& t : triangles)
    for (std::size_t v : t)
      if (v >= points.size())
        throw Input_error("A triangle of the surface refers to point " + std::to_string(v) + ", but there are only " +
                          std::to_string(points.size()) + ".");
  soup.triangles = triangles;

  Repair_report report;
  Surface_repairer repairer(mesh, report, options);
  if (options.repair_mode == Repair_mode::off)
    repairer.assemble(soup);
  else
    repairer.repair(soup, options.repair_mode == Repair_mode::wrap);
  if (options.smooth)
    repairer.smooth();
  return report;
}

CGAL_TUBULAR_MESHING_INLINE Repair_report repair_mesh(Surface& mesh, const Repair_surface_options& options) {
  check_tubular_surface(mesh);
  std::vector<Point_3> points(mesh.num_vertices());
  for (auto v : mesh.vertices())
    points[std::size_t(v)] = mesh.point(v);
  Surface repaired;
  Repair_report report = repair_soup(points, triangles_of(mesh), repaired, options);
  if (!report.empty())
    mesh = std::move(repaired);
  return report;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_REPAIR_REPAIR_SURFACE_IMPL_H
