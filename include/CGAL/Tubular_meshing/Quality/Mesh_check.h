// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_MESH_CHECK_H
#define CGAL_TUBULAR_MESHING_QUALITY_MESH_CHECK_H

#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <memory>

namespace CGAL::Tubular_meshing {

class Mesh_check;
struct Mesh_report;

namespace internal {

Mesh_report mesh_report_on(int threads, const Mixed_mesh& mesh, const Mesh_check& check);

} // namespace internal

/*! \ingroup PkgTubularMeshingQuality
 *
 * What was found of a mesh when it was checked: its validity, and which cells meet. mesh_report() spares most of its
 * work with it, see Mesher_report::check. It knows the mesh by its elements and labels: points may move, and the mesh be
 * copied. Copies share what they hold, four bytes a face of a cell.
 */
class Mesh_check {
public:
  /// Of no mesh.
  Mesh_check() = default;

  /// Does what validity_report() does. O(n log n). `number_of_threads`: 0 for all cores; the result does not depend on it
  explicit Mesh_check(const Mixed_mesh& mesh, int number_of_threads = 0);

  /// Of the mesh as it was then.
  const Validity_report& validity() const;

  /// Whether the mesh still has the elements and labels, and as many points. O(n)
  bool is_of(const Mixed_mesh& mesh, int number_of_threads = 0) const;

private:
  struct Impl;
  friend Mesh_report internal::mesh_report_on(int threads, const Mixed_mesh& mesh, const Mesh_check& check);

  std::shared_ptr<const Impl> impl_; // null: of no mesh
};

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Quality/Mesh_check_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_QUALITY_MESH_CHECK_H
