// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// centerline_descriptors SURFACE CENTERLINES [X Y Z]: the branches of a vessel tree, and radius and axes at a point.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Centerlines/build_centerline_graph.h>
#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>

#include <cstdlib>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
namespace TM = CGAL::Tubular_meshing;

int main(int argc, char* argv[]) {
  if (argc != 3 && argc != 6) {
    std::cerr << "usage: centerline_descriptors SURFACE CENTERLINES [X Y Z]\n";
    return 2;
  }
  try {
    CGAL::Surface_mesh<Point> surface;
    TM::IO::read_surface(argv[1], surface);
    TM::Centerline_polylines lines;
    TM::IO::read_centerlines(argv[2], lines);

    TM::Centerline_graph graph;
    TM::build_centerline_graph(lines, TM::Wall_distance(surface), graph);
    std::cout << "branch\tfrom\tto\tlength\tradius\taspect ratio\n";
    for (std::size_t i = 0; i < graph.branches().size(); ++i) {
      const auto& b = graph.branches()[i];
      std::cout << i << '\t' << b.source << '\t' << b.target << '\t' << b.length << '\t' << b.min_radius << " to "
                << b.max_radius << '\t' << graph.aspect_ratio(i) << '\n';
    }

    const TM::Centerline_field field(graph);
    const Point x = argc == 6 ? Point(std::atof(argv[3]), std::atof(argv[4]), std::atof(argv[5]))
                              : surface.point(*surface.vertices().begin());
    const auto [at, frame] = field.descriptors_and_frame(x);
    std::cout << "at " << x << ": branch " << at.branch << ", abscissa " << at.abscissa << ", radius " << at.radius
              << ", distance " << at.distance << "\ne_t  " << frame.e_t << "\ne_n  " << frame.e_n << "\ne_bn "
              << frame.e_bn << '\n';
  } catch (const TM::Error& e) {
    std::cerr << e.what() << '\n';
    return 3;
  }
}
