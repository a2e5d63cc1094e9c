// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_QUALITY_REPORT_H
#define CGAL_TUBULAR_MESHING_QUALITY_QUALITY_REPORT_H

#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingQuality
 *
 * How the values of a measure are spread over the elements of a mesh. All zero where there are no elements.
 *
 * Made in O(n) for n values, none of which is moved: they are counted in thousands of bins in ascending order. What is
 * asked for afterwards is exact, and takes a pass over the values, O(n).
 */
class Measure_statistics {
public:
  static constexpr std::size_t number_of_bins = 20;

  Measure_statistics() = default;
  explicit Measure_statistics(std::vector<double> values);

  std::size_t count() const { return values_.size(); }
  double min() const { return min_; }
  double max() const { return max_; }
  double mean() const { return mean_; }

  /// The value below which `percent` of the elements lie, linearly interpolated.
  double percentile(double percent) const;

  /// The share of elements whose value is below `bound`.
  double share_below(double bound) const;

  /// The number of elements in each of twenty bins of equal width over [0, 1]; what is outside counts at the ends.
  std::array<std::size_t, number_of_bins> histogram() const;

private:
  static constexpr std::size_t most_bins = 4096;

  std::vector<double> values_in(std::size_t bin) const;

  std::vector<double> values_;
  std::vector<std::size_t> begin_; // of each bin among the values, if they were sorted
  double min_ = 0, max_ = 0, mean_ = 0;
};

/*! \ingroup PkgTubularMeshingQuality
 *
 * The quality of a mesh by the paper's measures, and by those of cells as finite volumes, which are OpenFOAM's: what its
 * `checkMesh` prints. The latter are taken of cells of all kinds. A measure of elements that the mesh does not have is
 * empty.
 */
struct Quality_report {
  Measure_statistics gamma_T;          ///< (12), of the triangles
  Measure_statistics gamma_tau;        ///< (13), of the tetrahedra
  Measure_statistics eta_q;            ///< (14), of the quadrilaterals
  Measure_statistics zeta_H;           ///< (15), of the hexahedra
  Measure_statistics scaled_jacobian;  ///< of the hexahedra, see CGAL::Tubular_meshing::hexahedron_jacobian()
  Measure_statistics prism_jacobian;   ///< of the prisms, see CGAL::Tubular_meshing::prism_jacobian()
  Measure_statistics pyramid_jacobian; ///< of the pyramids, see CGAL::Tubular_meshing::pyramid_jacobian()
  Measure_statistics Q_tau;            ///< (16), of the tetrahedra, where the mesh carries a `metric`
  double efficiency = 0;               ///< (17), over the edges of the tetrahedra, where the mesh carries a `metric`
  Measure_statistics aspect;           ///< of the cells: 1 is a cube along the axes, infinite a flat cell
  /// of the faces between cells, in degrees: the angle between a face's normal and the line between the cells' centers
  Measure_statistics non_orthogonality;
  /// of the faces: how far from the face's center that line meets the face, in parts of the face's extent
  Measure_statistics skewness;
};

namespace internal {

// region: null stands for the whole mesh
Quality_report quality_report(const Mixed_mesh& mesh, const int* region, int number_of_threads);

} // namespace internal

/*! \ingroup PkgTubularMeshingQuality
 *
 * measures all elements of a mesh, (12)-(15) and as finite volumes, and (16)-(17) if it carries a point array `metric` of
 * six components. O(n log n).
 *
 * \param mesh the mesh
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{number_of_threads}
 *     \cgalParamDescription{0: all cores. The result does not depend on it}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{`0`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 */
template <typename CGAL_NP_TEMPLATE_PARAMETERS>
Quality_report quality_report(const Mixed_mesh& mesh, const CGAL_NP_CLASS& np = CGAL::parameters::default_values()) {
  return internal::quality_report(mesh, nullptr, internal::choose(np, internal_np::number_of_threads, 0));
}

/*! \ingroup PkgTubularMeshingQuality
 *
 * the same for the cells of one region, as if they were all; facets are left out. It has the same parameters.
 */
template <typename CGAL_NP_TEMPLATE_PARAMETERS>
Quality_report quality_report(const Mixed_mesh& mesh, int region,
                              const CGAL_NP_CLASS& np = CGAL::parameters::default_values()) {
  return internal::quality_report(mesh, &region, internal::choose(np, internal_np::number_of_threads, 0));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Quality/quality_report_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_QUALITY_QUALITY_REPORT_H
