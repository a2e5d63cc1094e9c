// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_REPORT_COUNTS_H
#define TUBULAR_MESH_REPORT_COUNTS_H

#include "json.h"

#include <initializer_list>

/* Numbers of elements by their kinds, of a mesh or of an estimate. */
template <class Number> Json cells_by_kind(Number tetrahedra, Number pyramids, Number prisms, Number hexahedra) {
  return {{"tetrahedra", tetrahedra}, {"pyramids", pyramids}, {"prisms", prisms}, {"hexahedra", hexahedra}};
}
template <class Number> Json facets_by_kind(Number triangles, Number quads) {
  return {{"triangles", triangles}, {"quads", quads}};
}

/* Calls use(number, kind) for all kinds of cells and facets of a report that there are. */
template <class Use> void for_each_count(const Json& report, const Use& use) {
  for (const char* group : {"cells", "facets"})
    for (const auto& kind : report[group].items())
      if (kind.value() > 0)
        use(kind.value(), kind.key());
}

#endif // TUBULAR_MESH_REPORT_COUNTS_H
