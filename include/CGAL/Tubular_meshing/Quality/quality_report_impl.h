// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_QUALITY_REPORT_IMPL_H
#define CGAL_TUBULAR_MESHING_QUALITY_QUALITY_REPORT_IMPL_H

#include <CGAL/Tubular_meshing/Quality/internal/Finite_volumes.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Quality/shape_measures.h>
#include <CGAL/Tubular_meshing/base/parallel.h>
#include <CGAL/Tubular_meshing/base/edges_of.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

namespace internal {

// Ordered as the numbers are, infinite ones as well.
inline std::uint64_t ordered_bits(double value) {
  constexpr std::uint64_t sign = std::uint64_t(1) << 63;
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  return (bits & sign) != 0 ? ~bits : bits | sign;
}

// The bin of a value from `min` to `max`. A number that is none is put with the largest.
struct Bin_of_value {
  double min, max;
  std::uint64_t least; // of `min`
  int shift;           // from what is ordered as the values to bins

  Bin_of_value(double min, double max, std::size_t most_bins)
      : min(min)
      , max(max)
      , least(ordered_bits(min))
      , shift(0) {
    while ((*this)(max) >= most_bins)
      ++shift;
  }

  std::size_t operator()(double value) const {
    const double bounded = value < max ? (std::max)(min, value) : max; // min where zeros differ in sign
    return std::size_t((ordered_bits(bounded) - least) >> shift);
  }
};

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Measure_statistics::Measure_statistics(std::vector<double> values) {
  if (values.empty())
    return;
  double sum = 0;
  min_ = max_ = values.front();
  for (double v : values) {
    sum += v;
    min_ = (std::min)(min_, v);
    max_ = (std::max)(max_, v);
  }
  mean_ = sum / double(values.size());
  const internal::Bin_of_value bin(min_, max_, most_bins);
  begin_.assign(bin(max_) + 2, 0);
  for (double v : values)
    ++begin_[bin(v) + 1];
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  values_ = std::move(values);
}

CGAL_TUBULAR_MESHING_INLINE std::vector<double> Measure_statistics::values_in(std::size_t wanted) const {
  std::vector<double> result;
  result.reserve(begin_[wanted + 1] - begin_[wanted]);
  const internal::Bin_of_value bin(min_, max_, most_bins);
  std::copy_if(values_.begin(), values_.end(), std::back_inserter(result),
               [&](double value) { return bin(value) == wanted; });
  return result;
}

CGAL_TUBULAR_MESHING_INLINE double Measure_statistics::percentile(double percent) const {
  if (values_.empty())
    return 0;
  const double at = (std::min)((std::max)(percent, 0.), 100.) / 100 * double(values_.size() - 1);
  const std::size_t rank = std::size_t(at);
  const double part = at - double(rank);
  std::vector<double> values;
  std::size_t begin = 0; // of the values among all, if they were sorted
  const auto value_of = [&](std::size_t k) {
    if (k >= begin + values.size()) {
      const auto end = std::upper_bound(begin_.begin(), begin_.end(), k);
      begin = *(end - 1);
      values = values_in(std::size_t(end - 1 - begin_.begin()));
    }
    const auto wanted = values.begin() + std::ptrdiff_t(k - begin);
    std::nth_element(values.begin(), wanted, values.end(),
                     [](double v, double w) { return internal::ordered_bits(v) < internal::ordered_bits(w); });
    return *wanted;
  };
  const double low = value_of(rank), high = part > 0 ? value_of(rank + 1) : low;
  return low < high ? low + part * (high - low) : low;
}

CGAL_TUBULAR_MESHING_INLINE double Measure_statistics::share_below(double bound) const {
  return values_.empty() ? 0
                         : double(std::count_if(values_.begin(), values_.end(), [&](double v) { return v < bound; })) /
                               double(values_.size());
}

CGAL_TUBULAR_MESHING_INLINE std::array<std::size_t, Measure_statistics::number_of_bins>
Measure_statistics::histogram() const {
  std::array<std::size_t, number_of_bins> bins = {};
  for (double v : values_)
    ++bins[std::size_t((std::min)((std::max)(v, 0.) * number_of_bins, number_of_bins - 1.))];
  return bins;
}

namespace internal {

/* Measures the elements of a mesh: all of them, or the cells of one region. */
class Quality_reporter {
public:
  explicit Quality_reporter(const Mixed_mesh& mesh, const int* region = nullptr, int threads = 1)
      : mesh_(mesh)
      , region_(region)
      , threads_(threads) {}

  Quality_report report() const {
    Finite_volumes volumes(mesh_, region_, threads_);
    return report(volumes);
  }
  // The measures of `volumes` are taken out of it.
  Quality_report report(Finite_volumes& volumes) const {
    Quality_report r;
    std::vector<std::function<void()>> sorts; // several at a time
    const auto take = [&](Measure_statistics& measure, std::vector<double> values) {
      if (!values.empty())
        sorts.push_back([&measure, v = std::move(values)]() mutable { measure = Measure_statistics(std::move(v)); });
    };
    if (region_ == nullptr) {
      take(r.gamma_T, gamma_T());
      take(r.eta_q, eta_q());
    }
    take(r.gamma_tau, gamma_tau());
    take(r.zeta_H, zeta_H());
    take(r.scaled_jacobian, scaled_jacobians());
    take(r.prism_jacobian, prism_jacobians());
    take(r.pyramid_jacobian, pyramid_jacobians());
    take(r.Q_tau, Q_tau());
    if (const Point_array* metric = metric_array())
      r.efficiency = efficiency(*metric);
    take(r.aspect, std::move(volumes.aspect()));
    take(r.non_orthogonality, std::move(volumes.non_orthogonality()));
    take(r.skewness, std::move(volumes.skewness()));
    for_each_task(sorts.size(), threads_, [&](std::size_t k) { sorts[k](); });
    return r;
  }

  // The values of each measure, in the order of the elements.
  std::vector<double> gamma_T() const {
    return over(mesh_.triangles, [](const std::array<Vector_3d, 3>& p) { return triangle_gamma(p[0], p[1], p[2]); });
  }
  std::vector<double> eta_q() const {
    return over(mesh_.quads, [](const std::array<Vector_3d, 4>& p) { return internal::quad_eta(p); });
  }
  std::vector<double> gamma_tau() const {
    return over(mesh_.tetrahedra,
                [](const std::array<Vector_3d, 4>& p) { return internal::tetrahedron_gamma(p[0], p[1], p[2], p[3]); });
  }
  std::vector<double> zeta_H() const {
    return over(mesh_.hexahedra, [](const std::array<Vector_3d, 8>& p) { return internal::hexahedron_zeta(p); });
  }
  std::vector<double> scaled_jacobians() const {
    return over(mesh_.hexahedra, [](const std::array<Vector_3d, 8>& p) { return scaled_jacobian(p); });
  }
  std::vector<double> prism_jacobians() const {
    return over(mesh_.prisms, [](const std::array<Vector_3d, 6>& p) { return scaled_jacobian(p); });
  }
  std::vector<double> pyramid_jacobians() const {
    return over(mesh_.pyramids, [](const std::array<Vector_3d, 5>& p) { return scaled_jacobian(p); });
  }
  // Empty, where the mesh has no metric.
  std::vector<double> Q_tau() const {
    const Point_array* array = metric_array();
    if (array == nullptr)
      return {};
    const auto metric = [&](std::uint32_t v) { return metric_at(*array, v); };
    return over_vertices(mesh_.tetrahedra, [&](const std::array<std::uint32_t, 4>& v) {
      return internal::tetrahedron_Q({point(v[0]), point(v[1]), point(v[2]), point(v[3])},
                                     {metric(v[0]), metric(v[1]), metric(v[2]), metric(v[3])});
    });
  }

private:
  bool counts(int label) const { return region_ == nullptr || label == *region_; }

  Vector_3d point(std::uint32_t v) const { return Vector_3d(mesh_.points[v]); }

  // measure(vertices) of the elements that count.
  template <std::size_t N, class Measure>
  std::vector<double> over_vertices(const Element_block<N>& elements, const Measure& measure) const {
    std::vector<std::size_t> counted;
    for (std::size_t i = 0; i < elements.size(); ++i)
      if (counts(elements.label[i]))
        counted.push_back(i);
    std::vector<double> values(counted.size());
    for_each_range(counted.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k)
        values[k] = measure(elements.vertices[counted[k]]);
    });
    return values;
  }
  // The same of their points.
  template <std::size_t N, class Measure>
  std::vector<double> over(const Element_block<N>& elements, const Measure& measure) const {
    return over_vertices(elements, [&](const std::array<std::uint32_t, N>& v) {
      std::array<Vector_3d, N> p;
      for (std::size_t i = 0; i < N; ++i)
        p[i] = point(v[i]);
      return measure(p);
    });
  }

  const Point_array* metric_array() const {
    for (const Point_array& a : mesh_.point_arrays)
      if (a.is_metric())
        return &a;
    return nullptr;
  }
  static Metric_tensor_3 metric_at(const Point_array& array, std::uint32_t v) {
    const double* m = array.values.data() + 6 * std::size_t(v);
    return Metric_tensor_3(m[0], m[1], m[2], m[3], m[4], m[5]);
  }

  double efficiency(const Point_array& metric) const {
    const auto edges = edges_of(
        mesh_.tetrahedra, mesh_.points.size(), [&](int label) { return counts(label); }, threads_);
    std::vector<double> excess(edges.size());
    for_each_range(edges.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) {
        const auto& e = edges[k];
        const double l = Metric_tensor_3::edge_length_linear(point(e.second) - point(e.first),
                                                             metric_at(metric, e.first), metric_at(metric, e.second));
        excess[k] = l < 1 ? l - 1 : 1 / l - 1;
      }
    });
    double sum = 0;
    for (double x : excess) // in their order, whatever the number of threads
      sum += x;
    return edges.empty() ? 0 : std::exp(sum / double(edges.size()));
  }

  const Mixed_mesh& mesh_;
  const int* region_; // null: all
  int threads_;
};

CGAL_TUBULAR_MESHING_INLINE Quality_report quality_report(const Mixed_mesh& mesh, const int* region,
                                                          int number_of_threads) {
  return Quality_reporter(mesh, region, number_of_threads).report();
}

} // namespace internal

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_QUALITY_QUALITY_REPORT_IMPL_H
