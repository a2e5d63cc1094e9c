// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_MESH_BY_BLOCKS_H
#define CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_MESH_BY_BLOCKS_H

#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/Pipelines/Hexahedral_report.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesher_options.h>
#include <CGAL/Tubular_meshing/Pipelines/internal/Model_in_its_frame.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>

#include <optional>

namespace CGAL::Tubular_meshing::internal {

/* The mesh of a model in blocks along its vessels, in the model's frame; none where they cannot be had, and
 * `report.why_no_blocks` says why. */
inline std::optional<Mixed_mesh> mesh_by_blocks(const Model_in_its_frame& /*model*/,
                                                const Centerline_sizing_field& /*size*/,
                                                const Mesher_options& /*options*/, Hexahedral_report& report) {
  report.why_no_blocks = "this version of the program does not make them yet";
  return std::nullopt;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_MESH_BY_BLOCKS_H
