// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_GENERATORS_INTERNAL_TUBULAR_CAPS_H
#define CGAL_TUBULAR_MESHING_GENERATORS_INTERNAL_TUBULAR_CAPS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Generators/Tubular_skeleton.h>
#include <CGAL/Tubular_meshing/base/Plane_frame.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <CGAL/number_type_config.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

// The plane of an end, with angles in it.
struct End_frame : Plane_frame {
  explicit End_frame(const Tubular_skeleton::End& end)
      : Plane_frame(Vector_3d(end.center), Vector_3d(end.normal))
      , radius(end.radius) {}

  double angle(const Vector_3d& p) const { return std::atan2(dot(p - origin, v), dot(p - origin, u)); }
  double distance_from_axis(const Vector_3d& p) const { return norm(p - origin - height(p) * normal); }
  Vector_3d on_disk(double angle, double r) const { return origin + r * std::cos(angle) * u + r * std::sin(angle) * v; }

  double radius;
};

// Fills the rim of an end with rings of triangles around its centre, about as large as the rim's edges.
class Cap_filler {
public:
  Cap_filler(const Tubular_skeleton::End& end, Surface& mesh)
      : frame_(end)
      , mesh_(mesh) {}

  void fill(Halfedge border) {
    Ring ring;
    for (Halfedge h : CGAL::halfedges_around_face(border, mesh_)) {
      const Vector_3d p(mesh_.point(mesh_.target(h)));
      double angle = frame_.angle(p);
      while (!ring.empty() && angle < ring.back().angle)
        angle += 2 * CGAL_PI;
      ring.push_back({angle, mesh_.target(h)});
    }
    const std::size_t rim_size = ring.size();
    // Rings are 0.87 edges apart, the height of an equilateral triangle.
    const int rings = (std::max)(1, int(std::lround(double(rim_size) / (2 * CGAL_PI * 0.87))));
    for (int i = 1; i <= rings; ++i) {
      const double fraction = double(rings - i) / rings;
      Ring inner = make_ring(fraction, i == rings ? 1 : (std::max)(3, int(std::lround(fraction * double(rim_size)))),
                             ring.front().angle);
      zip(ring, inner);
      ring.swap(inner);
    }
  }

private:
  struct Ring_vertex {
    double angle;
    Vertex vertex;
  };
  typedef std::vector<Ring_vertex> Ring;

  Ring make_ring(double fraction, int size, double first_angle) {
    Ring ring;
    for (int i = 0; i < size; ++i) {
      const double angle = first_angle + 2 * CGAL_PI * i / size;
      ring.push_back({angle, mesh_.add_vertex(as<Point_3>(frame_.on_disk(angle, fraction * frame_.radius)))});
    }
    return ring;
  }

  // Triangles between two rings, advancing on the one that lags behind; an inner ring of one vertex is the centre.
  void zip(const Ring& outer, const Ring& inner) {
    std::size_t i = 0, j = 0;
    const std::size_t n = outer.size(), m = inner.size() == 1 ? 0 : inner.size();
    auto vertex = [](const Ring& ring, std::size_t k) { return ring[k % ring.size()].vertex; };
    auto middle = [](const Ring& ring, std::size_t k) { // of the edge from k
      const double turn = 2 * CGAL_PI;
      const double next = k + 1 < ring.size() ? ring[k + 1].angle : ring[0].angle + turn;
      return (ring[k].angle + next) / 2;
    };
    while (i < n || j < m) {
      if (j == m || (i < n && middle(outer, i) <= middle(inner, j))) {
        mesh_.add_face(vertex(outer, i), vertex(outer, i + 1), vertex(inner, j));
        ++i;
      } else {
        mesh_.add_face(vertex(outer, i), vertex(inner, j + 1), vertex(inner, j));
        ++j;
      }
    }
  }

  End_frame frame_;
  Surface& mesh_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_GENERATORS_INTERNAL_TUBULAR_CAPS_H
