// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_QUALITY_REPORT_H
#define CGAL_TUBULAR_MESHING_QUALITY_QUALITY_REPORT_H

#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Quality/internal/metric_measures.h>
#include <CGAL/Tubular_meshing/Quality/shape_measures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 *
 * How the values of a measure are spread over the elements of a mesh. All zero where there are no elements.
 */
class Measure_statistics {
public:
  static constexpr std::size_t number_of_bins = 20;

  Measure_statistics() = default;
  /// O(n log n)
  explicit Measure_statistics(std::vector<double> values)
      : values_(std::move(values)) {
    std::sort(values_.begin(), values_.end());
    for (double v : values_)
      mean_ += v;
    if (!values_.empty())
      mean_ /= double(values_.size());
  }

  std::size_t count() const { return values_.size(); }
  double min() const { return values_.empty() ? 0 : values_.front(); }
  double max() const { return values_.empty() ? 0 : values_.back(); }
  double mean() const { return mean_; }

  /// The value below which `percent` of the elements lie, linearly interpolated.
  double percentile(double percent) const {
    if (values_.empty())
      return 0;
    const double at = (std::min)((std::max)(percent, 0.), 100.) / 100 * double(values_.size() - 1);
    const std::size_t i = std::size_t(at);
    return i + 1 < values_.size() ? values_[i] + (at - double(i)) * (values_[i + 1] - values_[i]) : values_.back();
  }

  /// The share of elements whose value is below `bound`.
  double share_below(double bound) const {
    return values_.empty() ? 0
                           : double(std::lower_bound(values_.begin(), values_.end(), bound) - values_.begin()) /
                                 double(values_.size());
  }

  /// The number of elements in each of twenty bins of equal width over [0, 1]; what is outside counts at the ends.
  std::array<std::size_t, number_of_bins> histogram() const {
    std::array<std::size_t, number_of_bins> bins = {};
    for (double v : values_)
      ++bins[std::size_t((std::min)((std::max)(v, 0.) * number_of_bins, number_of_bins - 1.))];
    return bins;
  }

private:
  std::vector<double> values_; // sorted
  double mean_ = 0;
};

/*! \ingroup PkgTubularMeshingRef
 *
 * The quality of a mesh by the paper's measures. A measure of elements that the mesh does not have is empty.
 */
struct Quality_report {
  Measure_statistics gamma_T;          ///< (12), of the triangles
  Measure_statistics gamma_tau;        ///< (13), of the tetrahedra
  Measure_statistics eta_q;            ///< (14), of the quadrilaterals
  Measure_statistics zeta_H;           ///< (15), of the hexahedra
  Measure_statistics prism_jacobian;   ///< of the prisms, see CGAL::Tubular_meshing::prism_jacobian()
  Measure_statistics pyramid_jacobian; ///< of the pyramids, see CGAL::Tubular_meshing::pyramid_jacobian()
  Measure_statistics Q_tau;            ///< (16), of the tetrahedra, where the mesh carries a `metric`
  double efficiency = 0;               ///< (17), over the edges of the tetrahedra, where the mesh carries a `metric`
};

namespace internal {

class Quality_reporter {
public:
  explicit Quality_reporter(const Mixed_mesh& mesh)
      : mesh_(mesh) {}

  Quality_report report() const {
    Quality_report r;
    r.gamma_T =
        over(mesh_.triangles, [](const std::array<Vector_3d, 3>& p) { return triangle_gamma(p[0], p[1], p[2]); });
    r.gamma_tau = over(mesh_.tetrahedra, [](const std::array<Vector_3d, 4>& p) {
      return internal::tetrahedron_gamma(p[0], p[1], p[2], p[3]);
    });
    r.eta_q = over(mesh_.quads, [](const std::array<Vector_3d, 4>& p) { return internal::quad_eta(p); });
    r.zeta_H = over(mesh_.hexahedra, [](const std::array<Vector_3d, 8>& p) { return internal::hexahedron_zeta(p); });
    r.prism_jacobian =
        over(mesh_.prisms, [](const std::array<Vector_3d, 6>& p) { return internal::prism_jacobian(p); });
    r.pyramid_jacobian =
        over(mesh_.pyramids, [](const std::array<Vector_3d, 5>& p) { return internal::pyramid_jacobian(p); });
    for (const Point_array& a : mesh_.point_arrays)
      if (a.is_metric())
        add_metric_measures(a, r);
    return r;
  }

private:
  template <std::size_t N, class Measure>
  Measure_statistics over(const Element_block<N>& elements, const Measure& measure) const {
    std::vector<double> values;
    values.reserve(elements.size());
    for (const auto& v : elements.vertices) {
      std::array<Vector_3d, N> p;
      for (std::size_t i = 0; i < N; ++i)
        p[i] = Vector_3d(mesh_.points[v[i]]);
      values.push_back(measure(p));
    }
    return Measure_statistics(std::move(values));
  }

  void add_metric_measures(const Point_array& array, Quality_report& r) const {
    const auto metric = [&](std::uint32_t v) {
      Metric m;
      std::copy_n(array.values.begin() + 6 * std::ptrdiff_t(v), 6, m.begin());
      return m;
    };
    std::vector<double> values;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const auto& v : mesh_.tetrahedra.vertices) {
      std::array<Vector_3d, 4> p;
      std::array<Metric, 4> m;
      for (std::size_t i = 0; i < 4; ++i) {
        p[i] = Vector_3d(mesh_.points[v[i]]);
        m[i] = metric(v[i]);
        for (std::size_t j = 0; j < i; ++j)
          edges.push_back(std::minmax(v[i], v[j]));
      }
      values.push_back(internal::tetrahedron_Q(p, m));
    }
    r.Q_tau = Measure_statistics(std::move(values));
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    double sum = 0;
    for (const auto& e : edges) {
      const double l = internal::metric_length(Vector_3d(mesh_.points[e.second]) - Vector_3d(mesh_.points[e.first]),
                                               metric(e.first), metric(e.second));
      sum += l < 1 ? l - 1 : 1 / l - 1;
    }
    r.efficiency = edges.empty() ? 0 : std::exp(sum / double(edges.size()));
  }

  const Mixed_mesh& mesh_;
};

} // namespace internal

/*! \ingroup PkgTubularMeshingRef
 *
 * measures all elements of a mesh, (12)-(15), and (16)-(17) if it carries a point array `metric` of six components.
 * O(n log n).
 */
inline Quality_report quality_report(const Mixed_mesh& mesh) {
  return internal::Quality_reporter(mesh).report();
}

namespace internal {

template <std::size_t N> Element_block<N> elements_of(const Element_block<N>& elements, int label) {
  Element_block<N> result;
  for (std::size_t i = 0; i < elements.size(); ++i)
    if (elements.label[i] == label)
      result.push_back(elements.vertices[i], label);
  return result;
}

} // namespace internal

/*! \ingroup PkgTubularMeshingRef
 *
 * the same for the cells of one region; facets are left out.
 */
inline Quality_report quality_report(const Mixed_mesh& mesh, int region) {
  Mixed_mesh part;
  part.points = mesh.points;
  part.point_arrays = mesh.point_arrays;
  part.tetrahedra = internal::elements_of(mesh.tetrahedra, region);
  part.pyramids = internal::elements_of(mesh.pyramids, region);
  part.prisms = internal::elements_of(mesh.prisms, region);
  part.hexahedra = internal::elements_of(mesh.hexahedra, region);
  return quality_report(part);
}

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_QUALITY_QUALITY_REPORT_H
