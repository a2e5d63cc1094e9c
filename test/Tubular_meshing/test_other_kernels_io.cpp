// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes of any kernel and kind are written and read.

#include "io_fixture.h"
#include "other_kernels.h"

#include <CGAL/Tubular_meshing/IO/read_mesh.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/IO/write_surface.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace {

template <class Mesh> class Other_kernels : public IO {};
TYPED_TEST_SUITE(Other_kernels, other_kernels::Meshes);

} // namespace

TYPED_TEST(Other_kernels, Are_written_and_read_back) {
  typedef typename boost::graph_traits<TypeParam>::face_descriptor Face;
  TypeParam mesh = other_kernels::converted<TypeParam>(tetrahedron());
  const CGAL::Constant_property_map<Face, int> patch(2);
  for (const std::string name : {"s.off", "s.ply", "s.vtp", "s.msh", "s.stl"}) {
    SCOPED_TRACE(name);
    TM::IO::write_surface(this->path(name), mesh, TM::parameters::face_patch_map(patch));
    TypeParam back;
    TM::IO::read_surface(this->path(name), back);
    EXPECT_EQ(num_vertices(back), 4u);
    EXPECT_EQ(num_faces(back), 4u);
    EXPECT_TRUE(CGAL::is_closed(back));
    double largest = 0;
    for (auto v : vertices(back))
      largest = (std::max)(largest, CGAL::to_double(get(get(CGAL::vertex_point, back), v).x()));
    EXPECT_NEAR(largest, 1. / 3, 1e-7);
  }
  Mesh m;
  TM::IO::read_mesh(this->path("s.msh"), m);
  EXPECT_EQ(m.triangles.label, (std::vector<int>(4, 2)));
}
