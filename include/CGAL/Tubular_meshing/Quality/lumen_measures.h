// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_LUMEN_MEASURES_H
#define CGAL_TUBULAR_MESHING_QUALITY_LUMEN_MEASURES_H

#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <cstddef>
#include <map>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingQuality
 * How large a meshed lumen is, by the facets around it. */
struct Lumen_measures {
  double volume = 0;
  double wall_area = 0;
  std::map<int, double> opening_area; ///< by the opening's label
};

namespace internal {

/* What is summed up over the facets of a lumen, straight or curved. */
struct Lumen_sums {
  double volumes = 0; // so many times the volume
  double wall_area = 0;
  std::map<int, Vector_3d> openings; // the area, along the normal

  Lumen_measures measures(double times_the_volume) const {
    Lumen_measures result;
    result.volume = volumes / times_the_volume;
    result.wall_area = wall_area;
    for (const auto& o : openings)
      result.opening_area[o.first] = norm(o.second);
    return result;
  }
};

// Whether a facet with this label bounds the lumen.
inline bool bounds_lumen(int label, std::size_t number_of_openings) {
  return label >= labels::wall && label <= labels::wall + int(number_of_openings);
}

class Lumen_measurer {
public:
  explicit Lumen_measurer(const Mixed_mesh& mesh)
      : mesh_(mesh) {}

  /* A facet as triangles around the mean of its corners: for a quad, this is the volume that the bilinear surface
   * through them bounds. */
  template <class Facet> void add(const Facet& facet, int label) {
    Vector_3d middle;
    for (auto i : facet)
      middle += 1. / double(facet.size()) * point(i);
    Vector_3d area;
    for (std::size_t k = 0; k < facet.size(); ++k) {
      const Vector_3d p = point(facet[k]), q = point(facet[(k + 1) % facet.size()]);
      const Vector_3d part = 0.5 * cross(p - middle, q - middle);
      sums_.volumes += dot(middle, cross(p, q));
      area += part;
      sums_.wall_area += label == labels::wall ? norm(part) : 0;
    }
    if (label != labels::wall)
      sums_.openings[label] += area;
  }

  Lumen_measures measures() const { return sums_.measures(6); }

private:
  // from a point of the mesh, against cancellation
  Vector_3d point(std::size_t i) const { return Vector_3d(mesh_.points[i]) - Vector_3d(mesh_.points.front()); }

  const Mixed_mesh& mesh_;
  Lumen_sums sums_;
};

} // namespace internal

/*! \ingroup PkgTubularMeshingQuality
 *
 * measures the lumen of a mesh by its facets: those of labels::wall, whether a wall has been grown on them or not, and
 * those of the openings. O(n) in the facets.
 *
 * \param mesh with or without cells; its lumen's facets turn counterclockwise seen from outside
 * \param number_of_openings as many labels follow that of the wall
 */
inline Lumen_measures lumen_measures(const Mixed_mesh& mesh, std::size_t number_of_openings) {
  internal::Lumen_measurer measurer(mesh);
  const auto add = [&](const auto& facets) {
    for (std::size_t i = 0; i < facets.size(); ++i)
      if (internal::bounds_lumen(facets.label[i], number_of_openings))
        measurer.add(facets.vertices[i], facets.label[i]);
  };
  add(mesh.triangles);
  add(mesh.quads);
  return measurer.measures();
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_QUALITY_LUMEN_MEASURES_H
