// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PARTITION_PARTITION_REPORT_IMPL_H
#define CGAL_TUBULAR_MESHING_PARTITION_PARTITION_REPORT_IMPL_H

#include <CGAL/Tubular_meshing/Partition/Ghost_cells.h>
#include <CGAL/Tubular_meshing/Partition/internal/Dual_graph.h>
#include <CGAL/Tubular_meshing/Partition/partition_report.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing {

CGAL_TUBULAR_MESHING_INLINE Partition_report partition_report(const Mixed_mesh& mesh, const Cell_partition& partition) {
  const std::vector<std::uint32_t>& part = partition.part;
  const std::size_t parts = partition.number_of_parts;
  Partition_report report;
  report.cells.assign(parts, 0);
  report.pieces.assign(parts, 0);
  for (std::uint32_t p : part)
    ++report.cells[p];
  if (!part.empty())
    report.imbalance =
        double(*std::max_element(report.cells.begin(), report.cells.end())) * double(parts) / double(part.size()) - 1;
  const internal::Dual_graph graph(mesh);
  graph.traverse([&](std::size_t a, std::size_t b) { return part[a] == part[b]; },
                 [&](std::size_t c, bool is_first_of_piece) {
                   report.pieces[part[c]] += is_first_of_piece;
                   for (std::int32_t k = graph.first[c]; k < graph.first[c + 1]; ++k)
                     report.cut_faces += part[c] < part[std::size_t(graph.neighbours[std::size_t(k)])];
                 });
  const Ghost_cells ghosts(mesh, partition);
  for (std::size_t p = 0; p < parts; ++p)
    report.ghost_cells.push_back(ghosts.of_part(p).size());
  return report;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PARTITION_PARTITION_REPORT_IMPL_H
