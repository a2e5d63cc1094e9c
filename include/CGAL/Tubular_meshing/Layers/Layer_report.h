// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_LAYER_REPORT_H
#define CGAL_TUBULAR_MESHING_LAYERS_LAYER_REPORT_H

#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <cstddef>
#include <cstdio>
#include <sstream>
#include <string>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingLayers
 *
 * What layers of cells came out like: where they could not be as thick as they were asked to be, for want of room, and
 * how thin they are there.
 */
struct Layer_report {
  std::size_t vertices = 0;         ///< of the surface that the layers grew on
  std::size_t reduced_vertices = 0; ///< of those, where layers are thinner than wanted, by more than a hundredth
  std::size_t steep_vertices = 0;   ///< where the thickness asked for changes by more than 0.4 of the distance, and was
                                    ///< lowered; of thicknesses that are not all multiples of the local radius
  std::size_t prisms = 0;           ///< that were added
  std::size_t hexahedra = 0;        ///< that were added
  std::size_t tetrahedra = 0;       ///< that were added
  std::size_t relabelled_facets = 0;      ///< of the wall, that lie in an opening's plane: they belong to its cap now
  double min_ratio = 1;                   ///< smallest ratio of the thickness obtained to that wanted
  double mean_ratio = 1;                  ///< mean of that ratio, over all vertices
  Point_3 worst_place = Point_3(0, 0, 0); ///< the vertex with the smallest ratio
  int rounds = 0;                         ///< how often the thickness was reduced because of folded or crossing cells

  /// One to three sentences.
  std::string text() const {
    if (steep_vertices == 0)
      return text_of_room();
    return text_of_room() + " At " + std::to_string(steep_vertices) +
           " vertices the thickness asked for changes by more than 0.4 of the distance along the wall, and was lowered "
           "for that.";
  }

private:
  std::string text_of_room() const {
    std::ostringstream s;
    s.precision(6);
    if (reduced_vertices == 0) {
      s << "The layers are as thick as wanted at all " << vertices << " vertices.";
      return s.str();
    }
    s << "For want of room, the layers are thinner than wanted at " << reduced_vertices << " of " << vertices
      << " vertices: " << percent(min_ratio) << " of the wanted thickness at the least, near (" << worst_place.x()
      << ", " << worst_place.y() << ", " << worst_place.z() << "), and " << percent(mean_ratio)
      << " on average over all vertices.";
    return s.str();
  }

  static std::string percent(double ratio) {
    char s[32];
    std::snprintf(s, sizeof s, ratio < 0.01 ? "%.2g %%" : "%.0f %%", 100 * ratio);
    return s;
  }
};

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_LAYERS_LAYER_REPORT_H
