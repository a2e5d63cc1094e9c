// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A junction that is too much for blocks of hexahedra.

#ifndef TUBULAR_MESHING_TEST_HUB_OF_VESSELS_H
#define TUBULAR_MESHING_TEST_HUB_OF_VESSELS_H

#include <CGAL/Tubular_meshing/Generators/Tubular_skeleton.h>

#include <cmath>

// Ten vessels at a junction: two more than blocks can have.
inline CGAL::Tubular_meshing::Tubular_skeleton hub_of_ten_vessels() {
  typedef CGAL::Tubular_meshing::Point_3 Point;
  CGAL::Tubular_meshing::Tubular_skeleton skeleton;
  skeleton.nodes.push_back(Point(0, 0, 0));
  for (int i = 0; i < 10; ++i) {
    const double z = (i + 0.5) / 5 - 1, r = std::sqrt(1 - z * z), a = 2.4 * i;
    const Point end(9 * r * std::cos(a), 9 * r * std::sin(a), 9 * z);
    skeleton.nodes.push_back(end);
    skeleton.add_branch(
        0, skeleton.nodes.size() - 1, [&](double t) { return Point(t * end.x(), t * end.y(), t * end.z()); },
        [](double) { return 1.; });
  }
  skeleton.inlet = 1;
  return skeleton;
}

#endif // TUBULAR_MESHING_TEST_HUB_OF_VESSELS_H
