// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The kinds of meshes that a caller may have, as a list of types, and a surface as each of them.

#ifndef TUBULAR_MESHING_TEST_OTHER_KERNELS_H
#define TUBULAR_MESHING_TEST_OTHER_KERNELS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <gtest/gtest.h>

namespace other_kernels {

typedef ::testing::Types<CGAL::Tubular_meshing::Surface,
                         CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>,
                         CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>,
                         CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>, CGAL::Polyhedron_items_with_id_3>>
    Meshes;

template <class Mesh> Mesh converted(const CGAL::Tubular_meshing::Surface& surface) {
  Mesh result;
  CGAL::copy_face_graph(surface, result);
  return result;
}

} // namespace other_kernels

#endif // TUBULAR_MESHING_TEST_OTHER_KERNELS_H
