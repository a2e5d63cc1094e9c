// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_MESH_CHECK_IMPL_H
#define CGAL_TUBULAR_MESHING_QUALITY_MESH_CHECK_IMPL_H

#include <CGAL/Tubular_meshing/Quality/Mesh_check.h>
#include <CGAL/Tubular_meshing/Quality/internal/Matched_faces.h>
#include <CGAL/Tubular_meshing/Quality/internal/Fingerprint.h>
#include <CGAL/Tubular_meshing/Quality/validity_report_impl.h>
#include <CGAL/Tubular_meshing/base/Face_buckets.h>

#include <memory>

namespace CGAL::Tubular_meshing {

struct Mesh_check::Impl {
  internal::Fingerprint fingerprint;
  internal::Matched_faces matched; // its mesh may be gone: for others that have the same elements
  Validity_report validity;

  Impl(const Mixed_mesh& mesh, int threads)
      : fingerprint(mesh, threads)
      , matched(mesh, internal::cells::Face_buckets::with_facets, threads)
      , validity(internal::validity_of(matched, threads)) {}
};

CGAL_TUBULAR_MESHING_INLINE Mesh_check::Mesh_check(const Mixed_mesh& mesh, int number_of_threads)
    : impl_(std::make_shared<const Impl>(mesh, number_of_threads)) {}

CGAL_TUBULAR_MESHING_INLINE const Validity_report& Mesh_check::validity() const {
  static const Validity_report of_no_mesh;
  return impl_ ? impl_->validity : of_no_mesh;
}

CGAL_TUBULAR_MESHING_INLINE bool Mesh_check::is_of(const Mixed_mesh& mesh, int number_of_threads) const {
  return impl_ && impl_->fingerprint == internal::Fingerprint(mesh, number_of_threads);
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_QUALITY_MESH_CHECK_IMPL_H
