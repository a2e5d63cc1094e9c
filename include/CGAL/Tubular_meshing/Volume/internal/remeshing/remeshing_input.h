// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_REMESHING_INPUT_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_REMESHING_INPUT_H

#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>

namespace CGAL::Tubular_meshing::internal {

/* Refuses meshes that the remesher cannot start from. O(n log n) */
inline void check_mesh_to_remesh(const Mixed_mesh& mesh, int threads) {
  if (mesh.number_of_cells() != mesh.tetrahedra.size() || !mesh.quads.empty())
    throw Input_error("The mesh has cells other than tetrahedra, which cannot be remeshed; pass its tetrahedra alone.");
  if (mesh.tetrahedra.empty())
    throw Input_error("The mesh has no tetrahedra, so that there is nothing to remesh; fill the surface first.");
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Vector_3d p(mesh.points[i]);
    if (!std::isfinite(p.x + p.y + p.z))
      throw Input_error("Point " + std::to_string(i) + " of the mesh is not finite; repair the mesh.");
  }
  const auto check_indices = [&mesh](const auto& block, const char* what) {
    for (std::size_t i = 0; i < block.size(); ++i)
      for (std::uint32_t v : block.vertices[i])
        if (v >= mesh.points.size())
          throw Input_error(std::string(what) + " " + std::to_string(i) + " of the mesh has the vertex " +
                            std::to_string(v) + ", which is not there; repair the mesh.");
  };
  check_indices(mesh.tetrahedra, "Tetrahedron");
  check_indices(mesh.triangles, "Triangle");
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (mesh.triangles.label[i] == 0)
      throw Input_error("Triangle " + std::to_string(i) +
                        " of the mesh has the label 0, which means none; give each boundary triangle its patch.");
  Validity_report report = validity_report(mesh, parameters::number_of_threads(threads));
  report.unused_points = 0; // they go
  report.connected_components = 1;
  if (!report.is_valid())
    throw Input_error("The mesh cannot be remeshed, as it has " + report.defects() +
                      "; repair it, and list all boundary triangles with their patches.");
}

/* The bounds of what a metric may ask for in a model of a given extent, and the sentences of what it may not. */
class Metric_limits {
public:
  explicit Metric_limits(double extent)
      : extent_(extent) {}

  void check(const Metric_tensor_3& m, const Vector_3d& at) const {
    if (!m.is_finite())
      refuse(at, "has components that are no finite numbers (a size of zero makes such)",
             "make the metric field finite everywhere in the mesh");
    if (!m.is_valid())
      refuse(at, "is not positive definite", "make the metric field positive definite everywhere in the mesh");
    // bounds on the eigenvalues by the trace, exact enough to pass almost all without decomposition
    const double trace = m.xx + m.yy + m.zz;
    const double largest = trace, smallest = m.determinant() / (trace * trace);
    if (smallest * (largest_size * extent_) * (largest_size * extent_) > 1 &&
        largest < largest_ratio * largest_ratio * smallest)
      return;
    const auto h = m.sizes();
    if (h[2] > largest_ratio * h[0])
      refuse(at, "has sizes from " + number(h[0]) + " to " + number(h[2]) + ", a ratio above " + number(largest_ratio),
             "limit the ratio of its sizes");
    if (h[2] > largest_size * extent_)
      refuse(at, "asks for a size of " + number(h[2]) + ", far beyond the model's extent of " + number(extent_),
             "limit its sizes, and check the units of model and metric");
  }

  static void check_number_of_tetrahedra(double n) {
    if (!(n < most_tetrahedra))
      throw Input_error("The metric asks for about " + number(n) + " tetrahedra, more than the " +
                        number(most_tetrahedra) +
                        " that can be numbered; enlarge its sizes, and check the units of model and metric.");
  }

private:
  static constexpr double largest_ratio = 1e5;
  static constexpr double largest_size = 10; // in extents
  static constexpr double most_tetrahedra = 2e8;

  static std::string number(double x) {
    std::ostringstream s;
    s << x;
    return s.str();
  }
  [[noreturn]] static void refuse(const Vector_3d& at, const std::string& what, const std::string& remedy) {
    throw Input_error("The metric at " + place_of(at) + " " + what + "; " + remedy + ".");
  }

  double extent_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_REMESHING_INPUT_H
