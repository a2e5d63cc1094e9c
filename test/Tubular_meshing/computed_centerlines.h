// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the tests of computed centerlines share: surfaces closed at their openings, and their centerlines.

#ifndef CGAL_TUBULAR_MESHING_TEST_COMPUTED_CENTERLINES_H
#define CGAL_TUBULAR_MESHING_TEST_COMPUTED_CENTERLINES_H

#include "test_surfaces.h"

#include <CGAL/Tubular_meshing/Centerlines/compute_centerlines.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Openings/close_openings.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace computed_centerlines {

using namespace test_surfaces;
namespace tubular = CGAL::Tubular_meshing;
typedef tubular::Centerline_graph Graph;
typedef tubular::Tubular_skeleton Skeleton;
typedef tubular::Opening Opening;

inline double distance(const Point& p, const Point& q) {
  return std::sqrt(CGAL::squared_distance(p, q));
}

struct Closed {
  Mesh mesh;
  Mesh::Property_map<Mesh::Face_index, int> patch;
  std::vector<Opening> openings;

  explicit Closed(const Mesh& open, const Point* inlet = nullptr)
      : mesh(open) {
    openings = inlet ? tubular::find_openings(mesh, tubular::parameters::inlet(*inlet)) : tubular::find_openings(mesh);
    patch = mesh.add_property_map<Mesh::Face_index, int>("f:patch", 0).first;
    tubular::close_openings(mesh, openings, patch);
  }
  Closed(const Closed&) = delete;
};

inline Graph centerlines_of(const Closed& closed, bool loops = false) {
  Graph graph;
  tubular::compute_centerlines(closed.mesh, closed.patch, closed.openings, graph, tubular::parameters::loops(loops));
  EXPECT_TRUE(graph.is_consistent());
  return graph;
}

inline Graph centerlines_of(const Mesh& open, const Point* inlet = nullptr, bool loops = false) {
  return centerlines_of(Closed(open, inlet), loops);
}

inline Mesh surface_of(const Skeleton& skeleton, double points = 24, double noise = 0) {
  Mesh mesh;
  tubular::generate_tubular_surface(skeleton, mesh, tubular::parameters::points_per_circumference(points).noise(noise));
  return mesh;
}

// Of the measurement data, which is not part of this project: an empty surface where it is absent.
inline Mesh shared_surface(const std::string& file) {
  Mesh mesh;
#ifdef TUBULAR_MESHING_SHARED_DATA
  const std::string path = std::string(TUBULAR_MESHING_SHARED_DATA) + "/" + file;
  if (std::ifstream(path))
    tubular::IO::read_surface(path, mesh);
#endif
  (void)file;
  return mesh;
}

} // namespace computed_centerlines

#endif // CGAL_TUBULAR_MESHING_TEST_COMPUTED_CENTERLINES_H
