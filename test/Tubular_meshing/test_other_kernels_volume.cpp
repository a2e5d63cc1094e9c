// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The volume meshers take surfaces of any kernel and of any model of FaceListGraph: they give what they give for the
// package's own.

#include <CGAL/Tubular_meshing/Volume/anisotropic_tetrahedral_remeshing.h>
#include <CGAL/Tubular_meshing/Volume/fill_keeping_boundary.h>
#include <CGAL/Tubular_meshing/Volume/fill_with_mesh_3.h>
#include <CGAL/Tubular_meshing/Volume/fill_with_pyramids_and_tetrahedra.h>
#include <CGAL/Tubular_meshing/Volume/optimize_tetrahedra.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/properties_Polyhedron_3.h>

#include "other_graphs.h"
#include "test_surfaces.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace {

namespace tubular = CGAL::Tubular_meshing;
typedef tubular::Point_3 Point;
typedef tubular::Mixed_mesh Mesh;

double size_of(const Point&) {
  return 0.4;
}
tubular::Metric_tensor_3 metric_at(const Point&) {
  return tubular::Metric_tensor_3::isotropic(0.35);
}

// A tube whose coordinates are the same as float.
tubular::Labelled_surface make_tube() {
  test_surfaces::Tube shape;
  shape.sides = 12;
  shape.rings = 8;
  shape.bottom = shape.top = test_surfaces::End::fine;
  tubular::Labelled_surface tube(test_surfaces::make_tube(shape));
  for (auto v : tube.surface.vertices()) {
    const Point& p = tube.surface.point(v);
    tube.surface.point(v) =
        Point(other_graphs::rounded(p.x()), other_graphs::rounded(p.y()), other_graphs::rounded(p.z()));
  }
  for (auto f : tube.surface.faces())
    tube.patch[f] = tubular::labels::wall;
  return tube;
}

// All meshers in turn.
template <class FaceGraph, class FacePatchMap>
std::vector<Mesh> meshes_of(const FaceGraph& surface, const FacePatchMap& patch) {
  std::vector<Mesh> meshes;
  Mesh mesh;
  tubular::fill_with_mesh_3(surface, patch, &size_of, mesh);
  meshes.push_back(mesh);
  tubular::optimize_tetrahedra(mesh, surface, patch, tubular::parameters::number_of_threads(1));
  meshes.push_back(mesh);
  tubular::anisotropic_tetrahedral_remeshing(mesh, surface, patch, &metric_at,
                                             tubular::parameters::number_of_threads(1));
  meshes.push_back(mesh);
  if (tubular::has_tetgen() || tubular::has_ccdt()) {
    tubular::fill_keeping_boundary(surface, patch, &size_of, mesh);
    meshes.push_back(mesh);
    tubular::fill_with_pyramids_and_tetrahedra(surface, patch, &size_of, mesh);
    meshes.push_back(mesh);
  }
  return meshes;
}

void expect_same(const std::vector<Mesh>& a, const std::vector<Mesh>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_FALSE(a[i].tetrahedra.empty());
    EXPECT_EQ(a[i].points, b[i].points) << i;
    EXPECT_EQ(a[i].tetrahedra.vertices, b[i].tetrahedra.vertices) << i;
    EXPECT_EQ(a[i].triangles.label, b[i].triangles.label) << i;
  }
}

template <class Kernel> void expect_same_with_kernel() {
  typedef CGAL::Surface_mesh<typename Kernel::Point_3> Other;
  const tubular::Labelled_surface tube = make_tube();
  Other other;
  other_graphs::copy_in_order(tube.surface, other);
  const auto patch =
      other.template add_property_map<typename Other::Face_index, int>("f:label", tubular::labels::wall).first;
  expect_same(meshes_of(tube.surface, tube.patch), meshes_of(other, patch));
}

TEST(Volume_meshers, Take_a_surface_of_exact_numbers) {
  expect_same_with_kernel<CGAL::Exact_predicates_exact_constructions_kernel>();
}

TEST(Volume_meshers, Take_a_surface_of_floats) {
  expect_same_with_kernel<CGAL::Simple_cartesian<float>>();
}

TEST(Volume_meshers, Take_a_polyhedron) {
  typedef CGAL::Polyhedron_3<tubular::Kernel> Polyhedron;
  typedef boost::graph_traits<Polyhedron>::face_descriptor Face;
  const tubular::Labelled_surface tube = make_tube();
  Polyhedron polyhedron;
  other_graphs::copy_in_order(tube.surface, polyhedron);
  std::map<Face, int> labels;
  for (Face f : faces(polyhedron))
    labels[f] = tubular::labels::wall;
  const boost::associative_property_map<std::map<Face, int>> patch(labels);
  expect_same(meshes_of(tube.surface, tube.patch), meshes_of(polyhedron, patch));
}

} // namespace
