// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Small surfaces of known shape, with open and closed ends.

#ifndef CGAL_TUBULAR_MESHING_TEST_SURFACES_H
#define CGAL_TUBULAR_MESHING_TEST_SURFACES_H

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <vector>

namespace test_surfaces {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef CGAL::Aff_transformation_3<Kernel> Transformation;
typedef CGAL::Surface_mesh<Point> Mesh;

// --- surfaces ---

enum class End { open, fan, fine };

/* A tube along z from 0 to `length`, with `sides` sides. */
struct Tube {
  int sides = 20, rings = 20;
  double length = 8, rx = 1, ry = 1;
  End bottom = End::open, top = End::open;
  std::function<double(double)> sag = [](double) { return 0.; }; // of the rim at the top, by angle
  double tilt = 0;                                               // of the top, dz/dx
  double dish = 0, noise = 0;                                    // of caps
};

inline void add_cap(Mesh& mesh, const Tube& tube, const std::vector<Mesh::Vertex_index>& rim, End kind, double z,
                    bool top, std::mt19937& random) {
  auto add = [&](Mesh::Vertex_index a, Mesh::Vertex_index b, Mesh::Vertex_index c) {
    top ? mesh.add_face(a, b, c) : mesh.add_face(a, c, b);
  };
  std::uniform_real_distribution<double> noise(-tube.noise, tube.noise);
  const int circles = kind == End::fine ? std::max(2, tube.sides / 6) : 1;
  std::vector<Mesh::Vertex_index> outer = rim;
  for (int c = circles - 1; c >= 1; --c) {
    const double t = double(c) / circles;
    std::vector<Mesh::Vertex_index> inner;
    for (auto v : rim) {
      const Point& p = mesh.point(v);
      inner.push_back(
          mesh.add_vertex(Point(t * p.x(), t * p.y(), z + t * (p.z() - z) - tube.dish * (1 - t * t) + noise(random))));
    }
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const std::size_t j = (i + 1) % rim.size();
      add(outer[i], outer[j], inner[j]);
      add(outer[i], inner[j], inner[i]);
    }
    outer = inner;
  }
  const auto center = mesh.add_vertex(Point(0, 0, z - tube.dish));
  for (std::size_t i = 0; i < rim.size(); ++i)
    add(outer[i], outer[(i + 1) % rim.size()], center);
}

inline Mesh make_tube(const Tube& tube) {
  Mesh mesh;
  std::mt19937 random(7);
  std::vector<std::vector<Mesh::Vertex_index>> rings(tube.rings + 1);
  for (int k = 0; k <= tube.rings; ++k)
    for (int i = 0; i < tube.sides; ++i) {
      const double angle = 2 * CGAL_PI * i / tube.sides, t = double(k) / tube.rings;
      const double x = tube.rx * std::cos(angle), y = tube.ry * std::sin(angle);
      rings[k].push_back(
          mesh.add_vertex(Point(x, y, t * tube.length + std::pow(t, 4) * (tube.sag(angle) + tube.tilt * x))));
    }
  for (int k = 0; k < tube.rings; ++k)
    for (int i = 0; i < tube.sides; ++i) {
      const int j = (i + 1) % tube.sides;
      mesh.add_face(rings[k][i], rings[k][j], rings[k + 1][j]);
      mesh.add_face(rings[k][i], rings[k + 1][j], rings[k + 1][i]);
    }
  if (tube.bottom != End::open)
    add_cap(mesh, tube, rings[0], tube.bottom, 0, false, random);
  if (tube.top != End::open)
    add_cap(mesh, tube, rings[tube.rings], tube.top, tube.length, true, random);
  return mesh;
}

inline Mesh make_sphere(int parallels, int meridians) {
  Mesh mesh;
  std::vector<std::vector<Mesh::Vertex_index>> rings;
  for (int k = 1; k < parallels; ++k) {
    rings.emplace_back();
    for (int i = 0; i < meridians; ++i) {
      const double u = 2 * CGAL_PI * i / meridians, v = CGAL_PI * k / parallels;
      rings.back().push_back(
          mesh.add_vertex(Point(std::sin(v) * std::cos(u), std::sin(v) * std::sin(u), -std::cos(v))));
    }
  }
  const auto south = mesh.add_vertex(Point(0, 0, -1)), north = mesh.add_vertex(Point(0, 0, 1));
  for (int i = 0; i < meridians; ++i) {
    const int j = (i + 1) % meridians;
    mesh.add_face(south, rings[0][j], rings[0][i]);
    mesh.add_face(north, rings.back()[i], rings.back()[j]);
    for (std::size_t k = 0; k + 1 < rings.size(); ++k) {
      mesh.add_face(rings[k][i], rings[k][j], rings[k + 1][j]);
      mesh.add_face(rings[k][i], rings[k + 1][j], rings[k + 1][i]);
    }
  }
  return mesh;
}

inline Mesh make_torus(int along, int around) {
  Mesh mesh;
  std::vector<std::vector<Mesh::Vertex_index>> rings(along);
  for (int k = 0; k < along; ++k)
    for (int i = 0; i < around; ++i) {
      const double u = 2 * CGAL_PI * k / along, v = 2 * CGAL_PI * i / around, r = 3 + std::cos(v);
      rings[k].push_back(mesh.add_vertex(Point(r * std::cos(u), r * std::sin(u), std::sin(v))));
    }
  for (int k = 0; k < along; ++k)
    for (int i = 0; i < around; ++i) {
      const int j = (i + 1) % around, l = (k + 1) % along;
      mesh.add_face(rings[k][i], rings[l][i], rings[l][j]);
      mesh.add_face(rings[k][i], rings[l][j], rings[k][j]);
    }
  return mesh;
}

inline Mesh make_square_duct() {
  Tube tube;
  tube.sides = 4;
  tube.bottom = tube.top = End::fan;
  return make_tube(tube);
}

inline Mesh transformed(const Mesh& mesh, const Transformation& t) {
  Mesh result = mesh;
  for (auto v : result.vertices())
    result.point(v) = t(result.point(v));
  return result;
}

inline Transformation rotation(double angle) { // about (0, 1, 1)
  const double c = std::cos(angle), s = std::sin(angle), h = std::sqrt(0.5);
  return Transformation(c, -s * h, s * h, s * h, (1 + c) / 2, (1 - c) / 2, -s * h, (1 - c) / 2, (1 + c) / 2);
}

inline Mesh shuffled(const Mesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Mesh::Vertex_index> vertices(mesh.vertices().begin(), mesh.vertices().end());
  std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
  std::shuffle(vertices.begin(), vertices.end(), random);
  std::shuffle(faces.begin(), faces.end(), random);
  Mesh result;
  std::vector<Mesh::Vertex_index> image(vertices.size());
  for (auto v : vertices)
    image[v] = result.add_vertex(mesh.point(v));
  for (auto f : faces) {
    auto h = mesh.halfedge(f);
    for (unsigned i = random() % 3; i > 0; --i)
      h = mesh.next(h);
    result.add_face(image[mesh.source(h)], image[mesh.target(h)], image[mesh.target(mesh.next(h))]);
  }
  return result;
}

inline void append(Mesh& mesh, const Mesh& other, const Transformation& t) {
  mesh += transformed(other, t);
}

} // namespace test_surfaces

#endif // CGAL_TUBULAR_MESHING_TEST_SURFACES_H
