// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_METRIC_CRITERIA_3_H
#define CGAL_TUBULAR_MESHING_FIELDS_METRIC_CRITERIA_3_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Fields/internal/metric_simplices.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <CGAL/Mesh_cell_criteria_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_edge_criteria_3.h>
#include <CGAL/Mesh_facet_criteria_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <string>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 *
 * How large an element of a mesh may be, measured in a metric: 1 is the metric's own size. Zero asks for nothing. The
 * edges of a unit mesh are at most √2 long; a regular tetrahedron of edges 1 has the circumradius 0.61, a regular
 * triangle 0.58.
 */
struct Metric_size_bounds {
  double edge_length = 1.4142135623730951; ///< longest edge, by (10) between the metrics of its ends
  double circumradius = 0; ///< radius of the sphere of the metric (the vertices' mean) through the element's vertices
};

namespace internal {

/* What cells and facets have in common: the metric of a field at vertices, and the verdict on an element's size. */
template <class Triangulation, class MetricField> class Metric_size_criterion {
public:
  Metric_size_criterion(const MetricField& field, const Metric_size_bounds& bounds)
      : field_(&field)
      , bounds_(bounds) {
    for (double b : {bounds.edge_length, bounds.circumradius})
      if (!(b >= 0 && b <= 1e6))
        throw Parameter_error("The bound " + std::to_string(b) +
                              " on elements in a metric is no length: give 0, for none, or about 1.");
  }

  /* How many times too large a simplex is, or 1 if it is not. */
  template <std::size_t N>
  double excess(const Triangulation& tr, const std::array<typename Triangulation::Vertex_handle, N>& vertices) const {
    std::array<Vector_3d, N> p;
    std::array<Metric_tensor_3, N> m;
    for (std::size_t i = 0; i < N; ++i) {
      const auto& point = tr.geom_traits().construct_point_3_object()(tr.point(vertices[i]));
      p[i] = Vector_3d(CGAL::to_double(point.x()), CGAL::to_double(point.y()), CGAL::to_double(point.z()));
      m[i] = (*field_)(typename MetricField::Point_3(point.x(), point.y(), point.z()));
    }
    double result = 1;
    if (bounds_.edge_length > 0)
      result = (std::max)(result, longest_edge(p, m) / bounds_.edge_length);
    if (bounds_.circumradius > 0)
      result = (std::max)(result, metric_circumradius(p, mean_metric(m)) / bounds_.circumradius);
    return result;
  }

private:
  const MetricField* field_;
  Metric_size_bounds bounds_;
};

/* In Mesh_3's queues the number of the criterion comes before the measure, the worst (smallest) first: whatever CGAL's
 * own criteria find wrong is corrected before sizes. */
constexpr int metric_criterion_number = 1000;

} // namespace internal

/*! \ingroup PkgTubularMeshingRef
 *
 * The cell criteria of Mesh_3, and one more: cells that are too large in a Riemannian metric are refined, the largest
 * ones first.
 *
 * Mesh_3 inserts Euclidean circumcenters, and the mesh it makes is isotropic: where the metric is not, cells become as
 * small in all directions as it asks for in one. Their number is that of the metric's smallest sizes. It serves for
 * mildly anisotropic metrics, and as a start for anisotropic remeshing; the metric's directions are for that to follow.
 *
 * \cgalModels `MeshCellCriteria_3`
 *
 * \tparam Triangulation the triangulation of the mesh complex
 * \tparam MetricField a model of `MetricField_3`
 */
template <class Triangulation, class MetricField>
class Metric_cell_criteria_3 : public Mesh_cell_criteria_3<Triangulation> {
  typedef Mesh_cell_criteria_3<Triangulation> Base;

public:
  typedef typename Base::Cell_quality Cell_quality;
  typedef typename Base::Is_cell_bad Is_cell_bad;
  typedef typename Triangulation::Cell_handle Cell_handle;

  /*! \param base CGAL's criteria: radius-edge ratio and Euclidean size
   * \param metric must outlive the criteria and their copies; called from several threads where Mesh_3 runs in parallel
   * \param bounds sizes in the metric
   * \throws Parameter_error if a bound is not a number, negative, or above a million */
  Metric_cell_criteria_3(const Base& base, const MetricField& metric,
                         const Metric_size_bounds& bounds = Metric_size_bounds())
      : Base(base)
      , size_(metric, bounds) {}

  Is_cell_bad operator()(const Triangulation& tr, const Cell_handle& c) const {
    Is_cell_bad bad = Base::operator()(tr, c);
    if (bad)
      return bad;
    const double excess = size_.template excess<4>(tr, {c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3)});
    return excess > 1 ? Is_cell_bad(Cell_quality(internal::metric_criterion_number, 1 / excess)) : Is_cell_bad();
  }

private:
  internal::Metric_size_criterion<Triangulation, MetricField> size_;
};

/*! \ingroup PkgTubularMeshingRef
 *
 * The same for the facets of the surface.
 *
 * \cgalModels `MeshFacetCriteria_3`
 */
template <class Triangulation, class MetricField>
class Metric_facet_criteria_3 : public Mesh_facet_criteria_3<Triangulation> {
  typedef Mesh_facet_criteria_3<Triangulation> Base;

public:
  typedef typename Base::Facet_quality Facet_quality;
  typedef typename Base::Is_facet_bad Is_facet_bad;
  typedef typename Triangulation::Facet Facet;

  /*! \param base CGAL's criteria: angle, Euclidean size, distance to the surface, topology
   * \param metric, bounds as for Metric_cell_criteria_3 */
  Metric_facet_criteria_3(const Base& base, const MetricField& metric,
                          const Metric_size_bounds& bounds = Metric_size_bounds())
      : Base(base)
      , size_(metric, bounds) {}

  Is_facet_bad operator()(const Triangulation& tr, const Facet& f) const {
    Is_facet_bad bad = Base::operator()(tr, f);
    if (bad)
      return bad;
    const auto vertex = [&](int k) { return f.first->vertex((f.second + k) & 3); };
    const double excess = size_.template excess<3>(tr, {vertex(1), vertex(2), vertex(3)});
    return excess > 1 ? Is_facet_bad(Facet_quality(internal::metric_criterion_number, 1 / excess)) : Is_facet_bad();
  }

private:
  internal::Metric_size_criterion<Triangulation, MetricField> size_;
};

/*! \ingroup PkgTubularMeshingRef
 *
 * Mesh_3's criteria with both: constructed, as Mesh_criteria_3 is, from facet criteria and cell criteria.
 */
template <class Triangulation, class MetricField>
using Metric_mesh_criteria_3 = Mesh_criteria_3<Triangulation, Mesh_edge_criteria_3<Triangulation>,
                                               Metric_facet_criteria_3<Triangulation, MetricField>,
                                               Metric_cell_criteria_3<Triangulation, MetricField>>;

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_FIELDS_METRIC_CRITERIA_3_H
