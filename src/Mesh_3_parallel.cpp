// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/Volume/internal/mesh_3/run_mesh_3.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
namespace CGAL {
namespace Tubular_meshing {
namespace internal {

template void run_mesh_3<Parallel_tag>(Surface&, const Watched_size&, double, Mixed_mesh&);

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL
#endif
