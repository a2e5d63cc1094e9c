// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PIECES_REMESHED_PIECE_IMPL_H
#define CGAL_TUBULAR_MESHING_PATCHES_PIECES_REMESHED_PIECE_IMPL_H

#include <CGAL/Tubular_meshing/Patches/pieces/Remeshed_piece.h>
#include <CGAL/Tubular_meshing/Plane/triangulate_in_metric.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <cstddef>
#include <string>
#include <utility>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

CGAL_TUBULAR_MESHING_INLINE bool triangulate_piece(const Chart& chart, bool judged_in_space,
                                                   const Plane_polygons& polygons, bool turn, Remeshed_piece& piece) {
  const auto metric = [&](const Plane_point& uv) { return chart.metric(uv); };
  const auto image = [&](const Plane_point& uv) { return chart.point(uv); };
  const Plane_embedding embedding(image);
  std::string problem;
  auto plane = mesh_plane(polygons, metric, judged_in_space ? &embedding : nullptr, chart.hidden_places(),
                          Triangulate_in_metric_options(), problem);
  if (!plane)
    return false;
  std::size_t on_boundary = 0;
  for (const auto& polygon : polygons)
    on_boundary += polygon.size();
  for (std::size_t i = on_boundary; i < plane->points.size(); ++i)
    piece.inner_points.push_back(chart.point(plane->points[i]));
  if (turn)
    for (auto& t : plane->triangles)
      std::swap(t[1], t[2]);
  piece.triangles = std::move(plane->triangles);
  return true;
}

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_PATCHES_PIECES_REMESHED_PIECE_IMPL_H
