// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_ELEMENT_QUALITY_IMPL_H
#define CGAL_TUBULAR_MESHING_QUALITY_ELEMENT_QUALITY_IMPL_H

#include <CGAL/Tubular_meshing/Quality/element_quality.h>
#include <CGAL/Tubular_meshing/Quality/quality_report_impl.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <cstddef>

namespace CGAL::Tubular_meshing {
namespace internal {

struct Element_measure {
  const char* name;
  std::size_t (*number)(const Mixed_mesh&); // of the elements that are measured, or 0 if there are none
  std::vector<double> (*values)(const Mixed_mesh&);
};

inline bool has_metric(const Mixed_mesh& mesh) {
  return std::any_of(mesh.point_arrays.begin(), mesh.point_arrays.end(), [](const auto& a) { return a.is_metric(); });
}

inline const std::vector<Element_measure>& all_element_measures() {
  typedef const Mixed_mesh& Mesh;
  typedef Quality_reporter Reporter;
  static const std::vector<Element_measure> measures = {
      {"gamma_T", [](Mesh m) { return m.triangles.size(); }, [](Mesh m) { return Reporter(m).gamma_T(); }},
      {"gamma_tau", [](Mesh m) { return m.tetrahedra.size(); }, [](Mesh m) { return Reporter(m).gamma_tau(); }},
      {"eta_q", [](Mesh m) { return m.quads.size(); }, [](Mesh m) { return Reporter(m).eta_q(); }},
      {"zeta_H", [](Mesh m) { return m.hexahedra.size(); }, [](Mesh m) { return Reporter(m).zeta_H(); }},
      {"scaled_jacobian", [](Mesh m) { return m.hexahedra.size(); },
       [](Mesh m) { return Reporter(m).scaled_jacobians(); }},
      {"prism_jacobian", [](Mesh m) { return m.prisms.size(); }, [](Mesh m) { return Reporter(m).prism_jacobians(); }},
      {"pyramid_jacobian", [](Mesh m) { return m.pyramids.size(); },
       [](Mesh m) { return Reporter(m).pyramid_jacobians(); }},
      {"Q_tau", [](Mesh m) { return has_metric(m) ? m.tetrahedra.size() : 0; },
       [](Mesh m) { return Reporter(m).Q_tau(); }},
      {"aspect", [](Mesh m) { return m.number_of_cells(); }, [](Mesh m) { return Finite_volumes(m).aspect(); }},
      {"non_orthogonality", [](Mesh m) { return m.number_of_cells(); },
       [](Mesh m) { return Finite_volumes(m).non_orthogonality(); }},
      {"skewness", [](Mesh m) { return m.number_of_cells(); }, [](Mesh m) { return Finite_volumes(m).skewness(); }}};
  return measures;
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE std::vector<std::string> element_measures(const Mixed_mesh& mesh) {
  std::vector<std::string> names;
  for (const internal::Element_measure& m : internal::all_element_measures())
    if (m.number(mesh) > 0)
      names.push_back(m.name);
  return names;
}

CGAL_TUBULAR_MESHING_INLINE std::vector<double> element_quality(const Mixed_mesh& mesh, const std::string& measure) {
  std::string known;
  for (const internal::Element_measure& m : internal::all_element_measures()) {
    if (measure == m.name)
      return m.values(mesh);
    known += (known.empty() ? "" : ", ") + std::string(m.name);
  }
  throw Parameter_error("There is no measure of quality called \"" + measure + "\": there are " + known + ".");
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_QUALITY_ELEMENT_QUALITY_IMPL_H
